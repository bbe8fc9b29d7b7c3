//! What texts mean, and what is wrong with others.

use super::library::PROGRAMS;
use super::*;

/// A program of a few lines around the statements of its kernel and of `final`.
fn around(kernel: &str, last: &str) -> String {
    format!(".program test\n.setting h: float\n.state s: float3\n.kernel\n{kernel}\n.final\n{last}\n")
}

fn parse(text: &str) -> Program {
    Program::parse("test.pasm", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn error(text: &str) -> String {
    Program::parse("t", text).expect_err("the text is no program").to_string()
}

#[test]
fn the_programs_of_the_library_are_programs() {
    for (name, text) in PROGRAMS {
        let program = Program::parse(name, text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(program.name(), *name);
        for section in Section::ALL {
            let nodes = program.block(section).nodes();
            let is_before = |(index, node): (usize, &Node)| node.operands.iter().all(|id| id.index() < index);
            assert!(nodes.iter().enumerate().all(is_before), "{name}: operands come before their users");
        }
    }
    assert!(!PROGRAMS.is_empty());
}

#[test]
fn vectors_become_words_and_sums_partial_sums() {
    let text = around("d = sub neighbor.position, query.position\naccumulate sum, d", "output mean, sum\nstore s, sum");
    let program = parse(&text);
    let names = |ports: Vec<Port>| ports.into_iter().map(|port| port.name).collect::<Vec<_>>();
    let kernel = ["query_position_x", "query_position_y", "query_position_z"];
    let neighbor = ["neighbor_position_x", "neighbor_position_y", "neighbor_position_z"];
    assert_eq!(names(program.inputs(Section::Kernel)), [kernel, neighbor].concat());
    let inputs = program.inputs(Section::Final);
    assert_eq!(inputs.len(), 3 * PARTIAL_SUMS);
    assert_eq!((inputs[9].name.as_str(), inputs[9].source, inputs[9].partial), ("sum_sum_y_1", Source::Sum(1), 1));
    let outgoing: Vec<String> = program.results(Section::Final).into_iter().map(|outgoing| outgoing.name).collect();
    let outputs = ["output_mean_x", "output_mean_y", "output_mean_z", "state_s_x", "state_s_y", "state_s_z"];
    assert_eq!(outgoing, [&outputs[..], &["write_s", "done"]].concat());
    assert_eq!(program.block(Section::Kernel).results().addends.len(), 3);
}

#[test]
fn dot_is_summed_from_left_to_right() {
    let program = parse(&around("q = dot query.position, neighbor.position\naccumulate q_sum, q", "output q, q_sum"));
    let nodes = program.block(Section::Kernel).nodes();
    let operation = |id: NodeId| nodes[id.index()].operation;
    let last = nodes.last().expect("there are nodes");
    assert_eq!((last.operation, last.name.as_deref()), (Operation::Add, Some("q")));
    assert_eq!(
        last.operands.iter().map(|&id| operation(id)).collect::<Vec<_>>(),
        [Operation::Add, Operation::Multiply]
    );
}

#[test]
fn repetitions_are_unrolled_and_pass_on_what_has_an_index() {
    let kernel =
        "x[0] = add h, 0.0\n.repeat i 0 3\nfactor = to_float i\n.repeat j i i+1\nx[j+1] = mul x[i], factor\n.end\n.end
        accumulate s3, x[3]";
    let program = parse(&around(kernel, "output y, s3"));
    let count =
        |operation| program.block(Section::Kernel).nodes().iter().filter(|node| node.operation == operation).count();
    assert_eq!((count(Operation::Multiply), count(Operation::ToFloat)), (3, 3));
    assert_eq!(count(Operation::Literal(Literal::Int(2))), 1, "the variable is a literal");
    let leak = around(".repeat i 0 3\nfactor = to_float i\n.end\naccumulate s3, factor", "output y, s3");
    assert!(error(&leak).starts_with("t:8:16: nothing here is called `factor`; the closest: h, "), "{}", error(&leak));
}

#[test]
fn literals_are_those_of_the_nearest_single() {
    for (text, value) in [("0.1", 0.1), ("-2.5e-3", -2.5e-3), ("0.0", 0.0), ("-0.0", -0.0), ("3e38", 3e38_f32)] {
        let program = parse(&around(&format!("x = add h, {text}\naccumulate y, x"), "output y, y"));
        let literal = Operation::Literal(Literal::Float(value.to_bits()));
        assert!(program.block(Section::Kernel).nodes().iter().any(|node| node.operation == literal), "{text}");
    }
}

#[test]
fn mistakes_have_a_place_and_a_remedy() {
    let good = "accumulate w, h";
    let cases = [
        ("", "t:1:1: the program ends without `.program`, its name"),
        (
            ".program A",
            "t:1:10: `A` has no meaning: names are lower-case letters, digits and underscores; `;` begins a comment",
        ),
        (".program a\n.query n: vector", "t:2:11: expected a type: `float`, `float3`, `int`, `bool`, found `vector`"),
        (
            ".program a\n.query position: float",
            "t:2:8: `position` is taken; a name is given once, in a `.repeat` with an index: `position[i]`",
        ),
        (".program a\n.setting count: int", "t:2:10: `count` is a word of the language and no name"),
        (
            ".program a\n.state a: float3\n.state a_y: int",
            "t:3:8: `a_y` is taken; a name is given once, in a `.repeat` with an index: `a_y[i]`",
        ),
        (".program a\n.kernel\naccumulate w, 1.0", "t:3:1: the program ends without `.final` and an `output` in it"),
        (
            ".program a\n.final\n.kernel",
            "t:3:1: `.kernel` has no place in `.final`; it belongs in the order of `.init`, `.kernel`, `.final`",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(error(text), expected, "{text}");
    }
    let in_kernel = [
        ("x = add h, 1", "t:5:5: `add` of float, int: expected float, float or float3, float3 or int, int"),
        ("x = plus h, h", "t:5:5: nothing here is called `plus`; the closest: abs, less, mul, sub, add, and"),
        ("x = add h h", "t:5:11: expected the end of the line, found `h`"),
        ("x = add h,", "t:5:11: expected a value: a name or a number, found the end of the line"),
        ("h = add h, h", "t:5:1: `h` is taken; "),
        ("x = neg -h", "t:5:10: expected a number behind the sign (of a value: `neg`), found `h`"),
        ("x = neg h.x", "t:5:9: `h` is float: expected float3 in front of a component"),
        ("x = neg s.w", "t:5:11: expected a component: `x`, `y` or `z`, found `w`"),
        ("x = neg query", "t:5:14: expected `.position` or another field of `query`, found the end of the line"),
        ("x = neg query.normal", "t:5:9: nothing here is called `query.normal`; the closest: query.position"),
        ("x = neg farthest.position", "t:5:9: `.kernel` does not see `farthest`; it is seen in `.init`"),
        ("x = neg count", "t:5:9: `.kernel` does not see `count`; it is seen in `.init` and `.final`"),
        ("x = neg 1e99", "t:5:9: `1e99` is no float: expected 0.0, or magnitudes from 1.2e-38 to 3.4e38"),
        (
            "x = neg 3000000000",
            "t:5:9: `3000000000` is no int: expected -2147483648 to 2147483647 (a float has a point: `1.0`)",
        ),
        ("store s, s", "t:5:1: `store` has no place in `.kernel`; it belongs in `.init` and `.final`"),
        ("accumulate b, true", "t:5:12: the addend of `b` is bool: expected float, float3 or int"),
        ("accumulate b, h\naccumulate b, h", "t:6:12: `b` is taken; "),
        (".repeat i 0 9", "t:5:1: expected an `.end` to this `.repeat`, found the end of the block"),
        (".repeat i 0 n\n.end", "t:5:13: expected a whole number or the variable of a `.repeat`, found `n`"),
        (".end", "t:5:1: expected a statement, `.repeat` or the `.end` of one, or the next block, found `.`"),
        ("x[0-1] = neg h", "t:5:4: expected `]`, found `-`"),
    ];
    for (statement, expected) in in_kernel {
        let error = error(&around(statement, "output w, h"));
        assert!(error.starts_with(expected), "{statement}: {error}");
    }
    let in_final = [
        ("output y, w\noutput y, w", "t:8:8: `y` is taken; "),
        ("store s, w", "t:7:10: what is stored to `s` is float: expected float3"),
        ("store s, s\nstore s, s", "t:8:7: `store s` stands here for the second time: expected one"),
        ("store t, s", "t:7:7: nothing here is called `t`; the closest: s"),
        ("done count", "t:7:6: done is int: expected bool"),
        ("done true\ndone true", "t:8:1: `done` stands here for the second time: expected one"),
        ("move s if neighbors", "t:7:11: the condition is int: expected bool"),
    ];
    for (statement, expected) in in_final {
        let error = error(&around(good, statement));
        assert!(error.starts_with(expected), "{statement}: {error}");
    }
}

#[test]
fn repetitions_end() {
    let nested = ".repeat i 0 9999\n.repeat j 0 9999\n.end\n.end";
    let expected = "t:5:1: statements of a block, repetitions unrolled: 10001, expected 10000 at most";
    assert!(error(&around(nested, "")).ends_with(&expected[6..]), "{}", error(&around(nested, "")));
    let deep: String = (0..9).map(|depth| format!(".repeat i{depth} 0 1\n")).collect();
    let deep = around(&format!("{deep}{}", ".end\n".repeat(9)), "");
    assert_eq!(error(&deep), "t:13:1: repetitions within each other: 9, expected 8 at most");
    let words: String = (0..6).map(|index| format!(".state s{index}: float3\n")).collect();
    assert_eq!(error(&format!(".program a\n{words}")), "t:7:8: words of state: 18, expected 16 at most");
}

/// The page for authors has every operation, and its example is a program.
#[test]
fn the_page_has_what_the_language_has() {
    let page = include_str!("../../../docs/programs.md");
    let table = page.split("## Operations").nth(1).expect("the page has operations");
    for name in super::instruction::names() {
        assert!(table.contains(&format!("`{name}`")), "{name} is missing");
    }
    let examples: Vec<&str> =
        page.split("```pasm").skip(1).map(|rest| rest.split("```").next().unwrap_or("")).collect();
    assert_eq!(examples.len(), 1);
    examples.iter().for_each(|example| assert_eq!(parse(example.trim_start()).outputs.len(), 4));
    let listed = PROGRAMS.iter().filter(|(name, _)| page.contains(&format!("(../programs/{name}.pasm)")));
    assert_eq!(listed.count(), PROGRAMS.len(), "the page lists the library");
}
