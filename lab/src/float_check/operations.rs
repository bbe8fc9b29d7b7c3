//! The operators that are compared.

use pointcore::operators::{ON_FLOATS, Operation};
use pointcore_contract::{Fixed, Format, Signedness, TableShape};
use pointcore_golden::float as golden;
use pointcore_hdl::float as hdl;

/// Pipeline registers of the operators under test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stages {
    /// Each operator's default.
    Default,
    /// This many, as far as an operator allows.
    Fixed(u32),
}

impl Stages {
    const fn or(self, default: u32) -> u32 {
        match self {
            Self::Default => default,
            Self::Fixed(stages) => stages,
        }
    }
}

/// Fixed-point formats to convert from and to: plain, with all bits below the point, and with bits only far below it, where
/// subnormal numbers of small formats count.
const FIXED: [Fixed; 4] = [
    Fixed { width: 32, fraction: 0, signed: Signedness::Signed },
    Fixed { width: 20, fraction: 8, signed: Signedness::Signed },
    Fixed { width: 9, fraction: 9, signed: Signedness::Unsigned },
    Fixed { width: 12, fraction: 34, signed: Signedness::Unsigned },
];

/// Shape of the interpolated tables under test.
const TABLE: TableShape = TableShape { index_bits: 6, fraction_bits: 10, value_bits: 12 };
/// Decay of the Gaussian under test.
const GAMMA: f64 = 4.0;

/// Every operator of a format.
pub(super) fn operations(format: Format, stages: Stages) -> Vec<Operation> {
    let on_floats = ON_FLOATS.iter().map(|of| Operation::on_floats(format, of, stages.or((of.stages)(format))));
    on_floats.chain(conversions(format, stages)).chain(tables(format, stages)).collect()
}

fn conversions(format: Format, stages: Stages) -> impl Iterator<Item = Operation> {
    use hdl::{convert, from_fixed, to_fixed};
    let floats = Format::NAMED.into_iter().flat_map(|(_, other)| [other, other.flushed()]);
    let converted = floats.map(move |to| Operation::convert(format, to, stages.or(convert::stages(format, to))));
    let fixed = FIXED.into_iter().flat_map(move |fixed| {
        [
            Operation::to_fixed(format, fixed, stages.or(to_fixed::stages(format, fixed))),
            Operation::from_fixed(format, fixed, stages.or(from_fixed::stages(format, fixed))),
        ]
    });
    converted.chain(fixed)
}

fn tables(format: Format, stages: Stages) -> impl Iterator<Item = Operation> {
    let bits = TABLE.index_bits + TABLE.fraction_bits;
    let tables = [
        ("exp_neg", hdl::exp_neg::samples(GAMMA, TABLE), golden::kernel_table(GAMMA, TABLE)),
        ("erf", hdl::erf::samples(TABLE), golden::erf_table(TABLE)),
        ("integral", hdl::erf::integral_samples(GAMMA, TABLE), golden::kernel_integral_table(GAMMA, TABLE)),
    ];
    tables.into_iter().map(move |(name, samples, table)| {
        let operator = hdl::table::module(TABLE, &samples, stages.or(hdl::table::stages(TABLE)));
        Operation::table(name, format, operator, bits, move |place| table.interpolate(place))
    })
}
