//! Least squares with few unknowns that may not be negative.

/// Unknowns.
pub const TERMS: usize = 4;
/// A pivot below this share of the largest entry is none.
const PIVOT_SHARE: f64 = 1e-12;

/// The weights, none of them negative, that come nearest to `Σ weight·term = value` over all rows, each row's error as a share of its value;
/// none where the rows do not determine any.
#[must_use]
pub fn fit(rows: &[([f64; TERMS], f64)]) -> Option<[f64; TERMS]> {
    // So few unknowns that every choice of those that are not zero can be tried.
    let choices = 1..1_usize << TERMS;
    let solved = choices.filter_map(|choice| solve(rows, choice)).filter(|weights| weights.iter().all(|w| *w >= 0.0));
    solved
        .map(|weights| (error(rows, &weights), weights))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, weights)| weights)
}

/// What the weights make of a row.
#[must_use]
pub fn predict(weights: &[f64; TERMS], terms: &[f64; TERMS]) -> f64 {
    weights.iter().zip(terms).map(|(weight, term)| weight * term).sum()
}

fn error(rows: &[([f64; TERMS], f64)], weights: &[f64; TERMS]) -> f64 {
    rows.iter().map(|(terms, value)| (predict(weights, terms) / value - 1.0).powi(2)).sum()
}

/// The normal equations of the unknowns in `choice`, a bit each, by elimination.
fn solve(rows: &[([f64; TERMS], f64)], choice: usize) -> Option<[f64; TERMS]> {
    let chosen: Vec<usize> = (0..TERMS).filter(|term| choice >> term & 1 == 1).collect();
    let count = chosen.len();
    let entry = |i: usize, j: usize| -> f64 {
        let share = |(terms, value): &([f64; TERMS], f64)| {
            let right = if j == count { 1.0 } else { terms[chosen[j]] / value };
            terms[chosen[i]] / value * right
        };
        rows.iter().map(share).sum()
    };
    let mut matrix: Vec<Vec<f64>> = (0..count).map(|i| (0..=count).map(|j| entry(i, j)).collect()).collect();
    let largest = matrix.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    for column in 0..count {
        let pivot = (column..count).max_by(|&a, &b| matrix[a][column].abs().total_cmp(&matrix[b][column].abs()))?;
        matrix.swap(column, pivot);
        let row = matrix[column].clone();
        if row[column].abs() <= PIVOT_SHARE * largest {
            return None;
        }
        for (_, other) in matrix.iter_mut().enumerate().filter(|(index, _)| *index != column) {
            let factor = other[column] / row[column];
            other.iter_mut().zip(&row).for_each(|(entry, pivot)| *entry -= factor * pivot);
        }
    }
    let mut weights = [0.0; TERMS];
    for (row, &term) in chosen.iter().enumerate() {
        weights[term] = matrix[row][count] / matrix[row][row];
    }
    Some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(weights: [f64; TERMS]) -> Vec<([f64; TERMS], f64)> {
        let terms = |i: usize| [i as f64 + 1.0, (i * i % 7) as f64, (i * 5 % 11) as f64, (i % 3) as f64];
        (0..12).map(|i| (terms(i), predict(&weights, &terms(i)))).collect()
    }

    #[test]
    fn weights_are_found_again() {
        for weights in [[1.0, 0.5, 2.0, 0.25], [0.5, 0.0, 0.0, 3.0]] {
            let found = fit(&rows(weights)).expect("the rows determine them");
            assert!(found.iter().zip(weights).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
        }
    }

    #[test]
    fn none_is_negative_and_nothing_comes_of_nothing() {
        let found = fit(&rows([3.0, -0.1, 0.2, 0.5])).expect("the rows determine others");
        assert!(found.iter().all(|weight| *weight >= 0.0), "{found:?}");
        assert_eq!(fit(&[]), None);
    }
}
