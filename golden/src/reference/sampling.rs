//! Where a frame's samples lie, in pixels.

use pointcore_contract::Sampling;

/// Place `[x, y]` of the sample in a column and a row, px.
#[must_use]
pub fn position(sampling: Sampling, column: usize, row: usize) -> [f64; 2] {
    let y = row as f64;
    match sampling {
        Sampling::Center => [column as f64 + 0.5, y + 0.5],
        Sampling::Flipquad => {
            let pixel = column / 2;
            let x = pixel as f64;
            let mirrored = if (pixel + row).is_multiple_of(2) { 0.0 } else { 0.25 };
            if column.is_multiple_of(2) { [x, y + 0.625 - mirrored] } else { [x + 0.375 + mirrored, y] }
        }
    }
}

/// From a pixel's corner to the nearest and the farthest of its samples along an axis, px.
pub(super) const fn reach(sampling: Sampling) -> (f64, f64) {
    match sampling {
        Sampling::Center => (0.5, 0.5),
        Sampling::Flipquad => (0.0, 0.625),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flipquad_has_a_sample_on_each_side_mirrored_from_pixel_to_pixel() {
        // Left, top, right and bottom of a pixel, from its corner.
        let sides = |column: usize, row: usize| {
            [(2 * column, row), (2 * column + 1, row), (2 * column + 2, row), (2 * column + 1, row + 1)].map(
                |(c, r)| {
                    let [x, y] = position(Sampling::Flipquad, c, r);
                    [x - column as f64, y - row as f64]
                },
            )
        };
        let pattern = [[0.0, 0.625], [0.375, 0.0], [1.0, 0.375], [0.625, 1.0]];
        let mirrored = [[0.0, 0.375], [0.625, 0.0], [1.0, 0.625], [0.375, 1.0]];
        for (column, row) in [(0, 0), (3, 0), (0, 5), (6, 7), (2, 8)] {
            assert_eq!(sides(column, row), if (column + row) % 2 == 0 { pattern } else { mirrored });
        }
    }
}
