//! Late paths of a placed design, where every wire takes what is usual for its fan-out: what the structure costs, wherever the placer put
//! what.
//!
//! nextpnr writes all delays as SDF. Of wires with as many loads, rounded down to a power of two, each is given the median; one without a delay
//! is none, as inside a carry chain. Paths begin at clock pins, and end where nothing leads on.

use super::timing::signal;
use rustc_hash::FxHashMap;
use serde::Serialize;

/// What a pin is called that a path begins at.
const CLOCKS: [&str; 4] = ["CLK", "WCK", "WCLK", "RCLK"];

/// End points of a kind, and the longest path to one of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LatePath {
    /// What it takes, in ns.
    pub ns: f64,
    /// How many end points of the kind are late: their names differ in numbers alone.
    pub ends: usize,
    /// Where it begins, in the unit's own names.
    pub from: String,
    /// Where it ends, and at which pin; numbers are left out.
    pub to: String,
    /// Cells on its way.
    pub cells: usize,
}

/// What is late in a unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LatePaths {
    /// The unit's name.
    pub unit: String,
    /// From where on a path is late, in ns.
    pub limit_ns: f64,
    /// End points of paths.
    pub ends: usize,
    /// Those that are reached late.
    pub late: usize,
    /// What a wire takes in ns with so many loads or more, below twice as many.
    pub wires: Vec<(usize, f64)>,
    /// By kind, the latest first.
    pub paths: Vec<LatePath>,
}

/// A delay from pin to pin, in picoseconds.
struct Arc {
    from: usize,
    to: usize,
    delay: u32,
}

/// The pins and delays of an SDF file.
#[derive(Default)]
struct Delays<'a> {
    numbers: FxHashMap<(&'a str, &'a str), usize>,
    pins: Vec<(&'a str, &'a str)>,
    wires: Vec<Arc>,
    cells: Vec<Arc>,
    /// Pins that a clock moves, and when.
    begins: Vec<(usize, u32)>,
}

impl<'a> Delays<'a> {
    fn pin(&mut self, cell: &'a str, port: &'a str) -> usize {
        *self.numbers.entry((cell, port)).or_insert_with(|| {
            self.pins.push((cell, port));
            self.pins.len() - 1
        })
    }

    /// Reads what nextpnr writes: a statement a line.
    fn read(sdf: &'a str) -> Result<Self, String> {
        let mut delays = Self::default();
        let mut cell = "";
        for (number, line) in (1..).zip(sdf.lines()) {
            let mut words = line.split_ascii_whitespace();
            let (Some(statement), from, to, delay) = (words.next(), words.next(), words.next(), words.next()) else {
                continue;
            };
            let wrong = || format!("line {number} of the delays: `{}`", line.trim());
            match statement {
                "(INSTANCE" => cell = from.map_or("", |name| name.trim_end_matches(')')),
                "(INTERCONNECT" | "(IOPATH" => {
                    let (Some(from), Some(to), Some(delay)) = (from, to, delay.and_then(slowest)) else {
                        return Err(wrong());
                    };
                    if statement == "(IOPATH" {
                        let end = delays.pin(cell, to);
                        if CLOCKS.iter().any(|clock| from.starts_with(clock)) {
                            delays.begins.push((end, delay));
                        } else {
                            let from = delays.pin(cell, from);
                            delays.cells.push(Arc { from, to: end, delay });
                        }
                    } else {
                        let [from, to] = [from, to].map(|pin| pin.rsplit_once('/'));
                        let (Some((driver, output)), Some((load, input))) = (from, to) else { return Err(wrong()) };
                        let (from, to) = (delays.pin(driver, output), delays.pin(load, input));
                        delays.wires.push(Arc { from, to, delay });
                    }
                }
                _ => {}
            }
        }
        Ok(delays)
    }

    /// Gives every wire the median of those with as many loads; returns these.
    fn level(&mut self) -> Vec<(usize, f64)> {
        let mut loads = vec![0_usize; self.pins.len()];
        let real = |arc: &&mut Arc| arc.delay > 0;
        self.wires.iter_mut().filter(real).for_each(|arc| loads[arc.from] += 1);
        let mut alike: Vec<Vec<u32>> = Vec::new();
        for arc in self.wires.iter().filter(|arc| arc.delay > 0) {
            let class = loads[arc.from].ilog2() as usize;
            alike.resize_with(alike.len().max(class + 1), Vec::new);
            alike[class].push(arc.delay);
        }
        let median = |delays: &mut Vec<u32>| {
            delays.sort_unstable();
            delays.get(delays.len() / 2).copied().unwrap_or(0)
        };
        let medians: Vec<u32> = alike.iter_mut().map(median).collect();
        for arc in self.wires.iter_mut().filter(real) {
            arc.delay = medians[loads[arc.from].ilog2() as usize];
        }
        let usual = medians.iter().enumerate().filter(|(_, delay)| **delay > 0);
        usual.map(|(class, &delay)| (1 << class, ns(delay))).collect()
    }
}

/// The largest of `(least:usual:most)`.
fn slowest(delay: &str) -> Option<u32> {
    delay.trim_matches(['(', ')']).rsplit(':').next()?.parse().ok()
}

fn ns(picoseconds: u32) -> f64 {
    f64::from(picoseconds) / 1000.0
}

/// The longest path to every pin that a clock reaches: when it arrives, and from which pin.
struct Arrivals {
    times: Vec<Option<u32>>,
    before: Vec<Option<usize>>,
    ends: Vec<usize>,
}

impl Arrivals {
    fn new(delays: &Delays<'_>) -> Self {
        let count = delays.pins.len();
        let mut out: Vec<Vec<&Arc>> = vec![Vec::new(); count];
        delays.wires.iter().chain(&delays.cells).for_each(|arc| out[arc.from].push(arc));
        // What a clock reaches, and how often: a pin is done when all that leads to it is.
        let mut awaited = vec![0_u32; count];
        let mut seen = vec![false; count];
        let mut open: Vec<usize> = delays.begins.iter().map(|&(pin, _)| pin).collect();
        open.iter().for_each(|&pin| seen[pin] = true);
        while let Some(pin) = open.pop() {
            for arc in &out[pin] {
                awaited[arc.to] += 1;
                if !std::mem::replace(&mut seen[arc.to], true) {
                    open.push(arc.to);
                }
            }
        }
        let (mut times, mut before) = (vec![None; count], vec![None; count]);
        for &(pin, delay) in &delays.begins {
            times[pin] = times[pin].max(Some(delay));
        }
        let mut done: Vec<usize> = delays.begins.iter().map(|&(pin, _)| pin).filter(|pin| awaited[*pin] == 0).collect();
        done.sort_unstable();
        done.dedup();
        let mut ends = Vec::new();
        while let Some(pin) = done.pop() {
            if out[pin].is_empty() {
                ends.push(pin);
            }
            for arc in &out[pin] {
                let time = times[pin].map(|time: u32| time + arc.delay);
                if time > times[arc.to] {
                    (times[arc.to], before[arc.to]) = (time, Some(pin));
                }
                awaited[arc.to] -= 1;
                if awaited[arc.to] == 0 {
                    done.push(arc.to);
                }
            }
        }
        Self { times, before, ends }
    }

    /// The pins of the longest path to one, its end first.
    fn path(&self, end: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(end), |pin| self.before[*pin])
    }
}

/// A cell's name as the netlist has it, without what the tools add to a signal's.
fn name(cell: &str) -> String {
    let plain = cell.replace('\\', "");
    signal(&plain).unwrap_or(plain)
}

/// Its numbers left out, so that those of a kind are alike.
fn without_numbers(name: &str) -> String {
    let mut text = String::new();
    for character in name.chars() {
        match character {
            '0'..='9' if text.ends_with('#') => {}
            '0'..='9' => text.push('#'),
            _ => text.push(character),
        }
    }
    text
}

/// What is late in nextpnr's delays of a placed unit.
///
/// # Errors
/// A line of another form.
pub(super) fn paths(unit: &str, sdf: &str, limit_ns: f64) -> Result<LatePaths, String> {
    let mut delays = Delays::read(sdf)?;
    let wires = delays.level();
    let arrivals = Arrivals::new(&delays);
    let mut kinds: FxHashMap<String, (usize, u32, usize)> = FxHashMap::default();
    let mut late = 0;
    for &end in &arrivals.ends {
        let Some(time) = arrivals.times[end].filter(|time| ns(*time) > limit_ns) else { continue };
        late += 1;
        let (cell, port) = delays.pins[end];
        let kind = kinds.entry(without_numbers(&format!("{}.{port}", name(cell)))).or_insert((0, 0, end));
        kind.0 += 1;
        if (time, end) > (kind.1, kind.2) {
            (kind.1, kind.2) = (time, end);
        }
    }
    let path = |(to, (ends, time, end)): (String, (usize, u32, usize))| {
        let pins: Vec<usize> = arrivals.path(end).collect();
        let from = name(delays.pins[pins[pins.len() - 1]].0);
        let inside = pins.windows(2).filter(|pair| delays.pins[pair[0]].0 == delays.pins[pair[1]].0);
        LatePath { ns: ns(time), ends, from, to, cells: inside.count() }
    };
    let mut paths: Vec<LatePath> = kinds.into_iter().map(path).collect();
    paths.sort_by(|a, b| b.ns.total_cmp(&a.ns).then_with(|| a.to.cmp(&b.to)));
    Ok(LatePaths { unit: unit.to_owned(), limit_ns, ends: arrivals.ends.len(), late, wires, paths })
}

impl std::fmt::Display for LatePaths {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { unit, limit_ns, ends, late, wires, paths } = self;
        writeln!(f, "{unit}: {late} of {ends} end points are reached after {limit_ns} ns by usual wires")?;
        let usual: Vec<_> = wires.iter().map(|(loads, ns)| format!("{ns:.1} with {loads}")).collect();
        write!(f, "A wire takes, in ns: {}", usual.join(", "))?;
        for LatePath { ns, ends, from, to, cells } in paths {
            write!(f, "\n{ns:6.1} ns  {ends:5} ×  {to}  ←  {from} ({cells} cells)")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two registers' outputs meet in a cell; a third wire makes their median 700. The carry has no wire.
    const SDF: &str = r#"(DELAYFILE
    (CELLTYPE "top")
    (INSTANCE )
        (INTERCONNECT unit.a_TRELLIS_FF_Q/Q unit.sum_3_LUT4_Z/A (500:500:500) (500:500:500))
        (INTERCONNECT unit.b_TRELLIS_FF_Q/Q unit.sum_3_LUT4_Z/B (900:900:900) (900:900:900))
        (INTERCONNECT unit.c_TRELLIS_FF_Q/Q unit.d_4_TRELLIS_FF_Q/M (700:700:700) (700:700:700))
        (INTERCONNECT unit.sum_3_LUT4_Z/F unit.d_12_TRELLIS_FF_Q/DI (0:0:0) (0:0:0))
    (CELLTYPE "TRELLIS_FF")
    (INSTANCE unit.a_TRELLIS_FF_Q)
        (IOPATH CLK Q (430:477:525) (430:477:525))
    (INSTANCE unit.b_TRELLIS_FF_Q)
        (IOPATH CLK Q (430:477:525) (430:477:525))
    (INSTANCE unit.c_TRELLIS_FF_Q)
        (IOPATH CLK Q (430:477:525) (430:477:525))
    (INSTANCE unit.sum_3_LUT4_Z)
        (IOPATH A F (200:218:236) (200:218:236))
        (IOPATH B F (200:218:240) (200:218:240))
"#;

    #[test]
    fn the_longest_path_to_each_kind_of_end_is_found_by_usual_wires() {
        let found = paths("unit", SDF, 1.0).expect("it is nextpnr's form");
        assert_eq!((found.ends, found.late, &found.wires), (2, 2, &vec![(1, 0.7)]));
        let path = |ns, from: &str, to: &str, cells| LatePath { ns, ends: 1, from: from.into(), to: to.into(), cells };
        assert_eq!(found.paths, [path(1.465, "b", "d_#.DI", 1), path(1.225, "c", "d_#.M", 0)]);
        let fewer = paths("unit", SDF, 1.3).expect("it is nextpnr's form");
        assert_eq!((fewer.ends, fewer.late, fewer.paths.len()), (2, 1, 1));
        assert!(found.to_string().ends_with("1.2 ns      1 ×  d_#.M  ←  c (0 cells)"), "{found}");
    }

    #[test]
    fn another_form_is_told_by_its_line() {
        let wrong = paths("unit", "(DELAYFILE\n  (INTERCONNECT a b (1:2:3))", 1.0);
        assert_eq!(wrong, Err("line 2 of the delays: `(INTERCONNECT a b (1:2:3))`".to_owned()));
    }
}
