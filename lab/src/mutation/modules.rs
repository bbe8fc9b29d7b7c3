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

impl<'a> Module<'a> {
    /// What its lines may place: only names of modules tell.
    fn instances(self) -> impl Iterator<Item = Instance<'a>> {
        self.text.lines().skip(1).filter_map(Instance::of)
    }

    fn places(self, inner: &str) -> bool {
        self.instances().any(|instance| instance.of == inner)
    }
}

/// A module placed in another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instance<'a> {
    /// The module's name.
    pub of: &'a str,
    /// Its own.
    pub name: &'a str,
    /// Its parameters, as `.NAME(value)`, separated by commas.
    pub parameters: &'a str,
}

impl<'a> Instance<'a> {
    /// What a line begins: `of name (` or `of #(parameters) name (`.
    fn of(line: &'a str) -> Option<Self> {
        let (of, rest) = line.trim_start().split_once(' ')?;
        let (parameters, rest) = match rest.strip_prefix("#(") {
            Some(rest) => rest.split_once(") ")?,
            None => ("", rest),
        };
        let name = rest.split([' ', '(']).next().filter(|name| !name.is_empty())?;
        Some(Self { of, name, parameters })
    }

    /// Width and depth of a memory, where it is one.
    pub fn memory_size(&self) -> Option<[u32; 2]> {
        let parameter = |name: &str| {
            let (_, rest) = self.parameters.split_once(&format!(".{name}("))?;
            rest.split(')').next()?.parse().ok()
        };
        self.of.strip_prefix("memory_")?;
        Some([parameter("WIDTH")?, parameter("DEPTH")?])
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

    /// What `outer` places.
    pub fn inside(&self, outer: &str) -> Vec<Instance<'a>> {
        let outer = self.all.iter().filter(|module| module.name == outer);
        let instances = outer.flat_map(|outer| outer.instances());
        instances.filter(|instance| self.names().any(|name| name == instance.of)).collect()
    }

    /// How much text `modules` are.
    pub fn bytes(&self, modules: &[&str]) -> usize {
        self.all.iter().filter(|module| modules.contains(&module.name)).map(|module| module.text.len()).sum()
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
        inner #(.W(2), .V(13)) x(.a(a));\nendmodule\nmodule top(input a);\n  outer y(.a(a));\n  shared z(.a(a));\nendmodule\n\
        module other (input a);\n  shared z(.a(a));\nendmodule\nmodule shared;\n  deep u();\nendmodule\nmodule deep;\nendmodule\n";

    #[test]
    fn modules_stand_in_others() {
        let modules = Modules::of(TEXT);
        assert_eq!(modules.names().collect::<Vec<_>>(), ["inner", "outer", "top", "other", "shared", "deep"]);
        assert_eq!(modules.around("inner"), ["outer"]);
        assert_eq!(modules.around("shared"), ["top", "other"]);
        let instance = |of, name, parameters| Instance { of, name, parameters };
        assert_eq!(modules.inside("top"), [instance("outer", "y", ""), instance("shared", "z", "")]);
        assert_eq!(modules.inside("outer"), [instance("inner", "x", ".W(2), .V(13)")]);
        let memory = instance("memory_1w1r", "words", ".WIDTH(9), .DEPTH(5)");
        assert_eq!((memory.memory_size(), modules.inside("outer")[0].memory_size()), (Some([9, 5]), None));
        assert_eq!(modules.within("top", |_| false), ["top", "outer", "shared", "inner", "deep"]);
        assert_eq!(modules.within("top", |name| name == "shared"), ["top", "outer", "inner"]);
    }
}
