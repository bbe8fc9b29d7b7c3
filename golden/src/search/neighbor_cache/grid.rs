//! A coarse grid on which queries are near each other or not, its unit taken from the margins that comparisons compute.
//!
//! Places are integers of 12 bits an axis, cut out of the numbers' bits without rounding. That two far places may agree in
//! them, and that near ones may differ by a unit more than they should about 0, costs a query time and no neighbor.

use pointcore_contract::Format;
use pointcore_contract::search::records::Point;

/// Bits of a place on an axis.
const PLACE_BITS: u32 = 12;
/// By how much a unit's exponent is below that of the margin it is taken from.
const FINER: i32 = 3;
/// Exponents that a margin may be above the unit's before the unit changes.
const KEPT: std::ops::RangeInclusive<i32> = 2..=4;
/// Biased exponents of margins that a unit can be taken from.
const MEASURED: std::ops::RangeInclusive<i32> = 4..=254;
/// Shifts from which on nothing is left of a number.
const SHIFTS: i32 = 64;

/// A place on the grid.
pub(super) type Place = [u32; 3];

/// The shifts that make a place of a point.
pub(super) type Shifts = [i32; 3];

/// Sign, biased exponent, and significand with its leading one, whatever the exponent.
fn parts(format: Format, number: u32) -> (bool, i32, u64) {
    let mantissa = format.mantissa;
    let (sign, exponent) = (number >> (mantissa + 8) & 1 == 1, number >> mantissa & 0xff);
    (sign, exponent as i32, u64::from(1 << mantissa | number & ((1 << mantissa) - 1)))
}

/// The grid.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    format: Format,
    /// Biased exponent of the unit.
    unit: i32,
    /// Units from which on two places are not near on an axis.
    limit: u32,
    known: bool,
}

impl Grid {
    pub(super) const fn new(format: Format) -> Self {
        Self { format, unit: 0, limit: 0, known: false }
    }

    pub(super) fn shifts(&self, point: Point) -> Shifts {
        point.map(|x| self.unit + self.format.mantissa as i32 + PLACE_BITS as i32 - 1 - parts(self.format, x).1)
    }

    pub(super) fn place(&self, point: Point, shifts: Shifts) -> Place {
        std::array::from_fn(|axis| {
            let (sign, _, significand) = parts(self.format, point[axis]);
            let shift = shifts[axis];
            let inside = (0..SHIFTS).contains(&shift);
            let units = if inside { significand << (PLACE_BITS - 1) >> shift } else { 0 };
            let units = if sign { !units } else { units };
            units as u32 % (1 << PLACE_BITS)
        })
    }

    pub(super) fn is_near(&self, a: Place, b: Place) -> bool {
        let is_near_on = |axis: usize| {
            let offset = a[axis].wrapping_sub(b[axis]).wrapping_add(self.limit).wrapping_sub(1) % (1 << PLACE_BITS);
            offset < 2 * self.limit - 1
        };
        self.known && (0..3).all(is_near_on)
    }

    /// Follows a margin; whether the unit changes, so that no place taken before can be compared any more.
    pub(super) fn measure(&mut self, margin: u32) -> bool {
        let (sign, exponent, significand) = parts(self.format, margin);
        if sign || !MEASURED.contains(&exponent) {
            return false;
        }
        let keeps = self.known && KEPT.contains(&(exponent - self.unit));
        if !keeps {
            (self.unit, self.known) = (exponent - FINER, true);
        }
        self.limit = (significand << (exponent - self.unit) >> self.format.mantissa) as u32;
        !keeps
    }

    pub(super) fn forget(&mut self) {
        self.known = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMAT: Format = Format::F32;

    fn place(grid: &Grid, x: f32) -> Place {
        let point = [x, 0.0, 0.0].map(f32::to_bits);
        grid.place(point, grid.shifts(point))
    }

    #[test]
    fn places_within_the_margin_are_near() {
        let mut grid = Grid::new(FORMAT);
        assert!(!grid.is_near(place(&grid, 1.0), place(&grid, 1.0)), "no margin is known");
        assert!(grid.measure(0.25f32.to_bits()));
        for center in [0.0, 1.0, -3.0, 100.0, -0.125, 1e-9] {
            let is_near = |x: f32| grid.is_near(place(&grid, center), place(&grid, x));
            for near in [-0.2, -0.1, 0.0, 0.1, 0.2] {
                assert!(is_near(center + near), "{near} from {center}");
            }
            // 4096 units of a thirty-second are 128.
            for far in [-100.0, -1.0, -0.3, 0.3, 1.0, 100.0] {
                assert!(!is_near(center + far), "{far} from {center}");
            }
        }
    }

    #[test]
    fn the_unit_stays_while_the_margin_is_about_the_same() {
        let mut grid = Grid::new(FORMAT);
        let changes = [0.25f32, 0.3, 0.125, 0.99, 1.0, 0.5, 0.24, -1.0, 0.0, f32::INFINITY, f32::NAN, 1e-44, 8.0]
            .map(|margin| grid.measure(margin.to_bits()));
        assert_eq!(changes, [true, false, false, false, true, false, true, false, false, false, false, false, true]);
    }
}
