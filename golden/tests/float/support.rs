//! Operands, seeds and the comparer that all tests share.

use fastrand::Rng;
use pointcore_contract::{Format, Subnormals};

/// Random cases per operator and format.
pub const RANDOM_CASES: usize = 200_000;

const DEFAULT_SEED: u64 = 0x5eed;

/// The seed of this run: `POINTCORE_SEED`, or a fixed one.
pub fn seed() -> u64 {
    match std::env::var("POINTCORE_SEED") {
        Ok(text) => text.parse().expect("POINTCORE_SEED is a decimal number"),
        Err(_) => DEFAULT_SEED,
    }
}

/// Every format of the project, flushing variants included.
pub fn formats() -> impl Iterator<Item = Format> {
    Format::NAMED.into_iter().flat_map(|(_, format)| [format, format.flushed()])
}

/// [`formats`], and the smallest and the largest that the models take.
pub fn formats_and_limits() -> impl Iterator<Item = Format> {
    let limits = [(5, 2), (11, 28)];
    let limits = limits.map(|(exponent, mantissa)| Format { exponent, mantissa, subnormals: Subnormals::Keep });
    formats().chain(limits.into_iter().flat_map(|format| [format, format.flushed()]))
}

/// Whether `bits` encode a NaN.
pub fn is_nan(f: Format, bits: u64) -> bool {
    bits & !f.sign_mask() > f.infinity()
}

/// `bits`, NaNs replaced by the canonical one.
pub fn canonical(f: Format, bits: u64) -> u64 {
    if is_nan(f, bits) { f.quiet_nan() } else { bits }
}

/// Zeros, the ends and middles of the subnormal and normal ranges, neighbours of one, infinities and NaNs of both signs.
pub fn special_operands(f: Format) -> Vec<u64> {
    let smallest_normal = 1 << f.mantissa;
    let magnitudes = [
        0,
        1,
        2,
        smallest_normal / 2,
        smallest_normal - 1,
        smallest_normal,
        smallest_normal + 1,
        smallest_normal * 2,
        f.one() / 2,
        f.one() - smallest_normal,
        f.one() - 1,
        f.one(),
        f.one() + 1,
        f.one() + smallest_normal,
        f.one() + smallest_normal * 3 / 2,
        f.infinity() - smallest_normal,
        f.infinity() - 1,
        f.infinity(),
        f.infinity() + 1,
        f.quiet_nan(),
        f.sign_mask() - 1,
    ];
    magnitudes.into_iter().flat_map(|magnitude| [magnitude, magnitude | f.sign_mask()]).collect()
}

/// A random operand: any bits, a fraction of few bits or of few holes, or near `anchor`, where sums cancel.
pub fn random_operand(rng: &mut Rng, f: Format, anchor: u64) -> u64 {
    let mask = 2 * f.sign_mask() - 1;
    let fraction_mask = (1 << f.mantissa) - 1;
    let any = rng.u64(..) & mask;
    match rng.u8(..8) {
        0..4 => any,
        4 => any & (!fraction_mask | rng.u64(..) & rng.u64(..) & rng.u64(..)),
        5 => any | (fraction_mask & (rng.u64(..) | rng.u64(..) | rng.u64(..))),
        6 => (anchor ^ f.sign_mask()).wrapping_add(rng.u64(..8)) & mask,
        _ => (anchor & !fraction_mask | any & fraction_mask).wrapping_add(rng.u64(..3) << f.mantissa) & mask,
    }
}

/// `N` operands a case: every tuple where these are few, else all tuples of special operands and random ones.
pub fn operand_tuples<const N: usize>(f: Format) -> Box<dyn Iterator<Item = [u64; N]>> {
    const EXHAUSTIVE_BITS: u32 = 16;
    let width = f.width();
    if N as u32 * width <= EXHAUSTIVE_BITS {
        let operand = move |tuple: u64, i: usize| (tuple >> (i as u32 * width)) & (2 * f.sign_mask() - 1);
        let tuples = 0..1_u64 << (N as u32 * width);
        return Box::new(tuples.map(move |tuple| std::array::from_fn(|i| operand(tuple, i))));
    }
    let specials = special_operands(f);
    let mut rng = Rng::with_seed(seed());
    let tuples = specials.len().pow(N as u32);
    let directed = (0..tuples)
        .map(move |tuple| std::array::from_fn(|i| specials[tuple / specials.len().pow(i as u32) % specials.len()]));
    let random = (0..RANDOM_CASES).map(move |_| {
        let mut anchor = f.one();
        std::array::from_fn(|_| {
            anchor = random_operand(&mut rng, f, anchor);
            anchor
        })
    });
    Box::new(directed.chain(random))
}

/// Counts cases and mismatches of one operator in one format.
pub struct Tally {
    name: String,
    cases: u64,
    mismatches: u64,
    first: Option<String>,
}

impl Tally {
    pub fn new(operator: &str, format: impl std::fmt::Display) -> Self {
        Self { name: format!("fp.{operator}.{format}"), cases: 0, mismatches: 0, first: None }
    }

    pub fn check(&mut self, operands: &[u64], actual: u64, expected: u64) {
        self.cases += 1;
        if actual != expected {
            self.mismatches += 1;
            self.first.get_or_insert_with(|| format!("{operands:x?} gives {actual:x}, expected {expected:x}"));
        }
    }

    /// Prints the counts; panics on a mismatch or if there was no case.
    pub fn finish(self) {
        let Self { name, cases, mismatches, first } = self;
        println!("{name}.cases {cases}\n{name}.mismatches {mismatches}");
        assert!(cases > 0, "{name}: no case was compared");
        if let Some(first) = first {
            panic!("{name}: {mismatches} of {cases} differ, the first: {first}\n{}", reproduce());
        }
    }
}

/// The command that repeats this run.
pub fn reproduce() -> String {
    format!("reproduce with: POINTCORE_SEED={} cargo test -p pointcore-golden --test float", seed())
}
