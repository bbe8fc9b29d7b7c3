//! The modules of a text, and which stands in which.

/// Modules as the generator writes them: one after another, an instance a line.
#[derive(Clone, Debug)]
pub struct Modules<'a> {
    all: Vec<Module<'a>>,
}

#[derive(Clone, Copy, Debug)]
struct Module<'a> {
    name: &'a str,
    text: &'a str,
}

impl Module<'_> {
    fn places(&self, inner: &str) -> bool {
        self.text.lines().any(|line| line.split_whitespace().next() == Some(inner))
    }
}

impl<'a> Modules<'a> {
    /// Those of a text.
    pub fn of(verilog: &'a str) -> Self {
        let begins = |line: &'a str| line.strip_prefix("module ");
        let mut all: Vec<Module<'a>> = Vec::new();
        let mut rest = verilog;
        while let Some(line) = rest.lines().next() {
            if let Some(head) = begins(line) {
                let end = rest.find("\nendmodule").unwrap_or(rest.len());
                let name = head.split([' ', '(', ';', '#']).next().unwrap_or(head);
                all.push(Module { name, text: &rest[..end] });
            }
            rest = rest.split_once('\n').map_or("", |(_, rest)| rest);
        }
        Self { all }
    }

    /// All names.
    pub fn names(&self) -> impl Iterator<Item = &'a str> + '_ {
        self.all.iter().map(|module| module.name)
    }

    /// Those that place `inner`.
    pub fn around(&self, inner: &str) -> Vec<&'a str> {
        self.all.iter().filter(|module| module.places(inner)).map(|module| module.name).collect()
    }

    /// Those that `outer` places.
    pub fn inside(&self, outer: &str) -> Vec<&'a str> {
        let outer = self.all.iter().find(|module| module.name == outer);
        self.names().filter(|inner| outer.is_some_and(|outer| outer.places(inner))).collect()
    }

    /// `top` and what stands in it, but for modules that are `elsewhere`, and what stands only in them.
    pub fn within(&self, top: &str, elsewhere: impl Fn(&str) -> bool) -> Vec<&'a str> {
        let mut within: Vec<Module<'a>> = self.all.iter().filter(|module| module.name == top).copied().collect();
        let mut seen = 0;
        while let Some(outer) = within.get(seen).copied() {
            for inner in &self.all {
                let is_new = within.iter().all(|module| module.name != inner.name);
                if is_new && outer.places(inner.name) && !elsewhere(inner.name) {
                    within.push(*inner);
                }
            }
            seen += 1;
        }
        within.into_iter().map(|module| module.name).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "// A unit.\nmodule inner(input a);\nendmodule\nmodule outer #(\n    parameter W = 2\n) (input a);\n  \
        inner #(.W(2)) x(.a(a));\nendmodule\nmodule top(input a);\n  outer y(.a(a));\n  shared z(.a(a));\nendmodule\n\
        module other (input a);\n  shared z(.a(a));\nendmodule\nmodule shared;\n  deep u();\nendmodule\nmodule deep;\nendmodule\n";

    #[test]
    fn modules_stand_in_others() {
        let modules = Modules::of(TEXT);
        assert_eq!(modules.names().collect::<Vec<_>>(), ["inner", "outer", "top", "other", "shared", "deep"]);
        assert_eq!(modules.around("inner"), ["outer"]);
        assert_eq!(modules.around("shared"), ["top", "other"]);
        assert_eq!(modules.inside("top"), ["outer", "shared"]);
        assert_eq!(modules.within("top", |_| false), ["top", "outer", "shared", "inner", "deep"]);
        assert_eq!(modules.within("top", |name| name == "shared"), ["top", "outer", "inner"]);
    }
}
