//! Numbers as values of arguments: what is none, or out of range, is told what would be right, in the words of the option.

use std::ops::RangeBounds;
use std::str::FromStr;

/// Any whole number from 0 up.
pub const WHOLE: &str = "a whole number from 0 up";
/// Any length, time or frequency.
pub const POSITIVE: &str = "a positive number";

/// Takes numbers of a range, which `expected` describes.
pub fn within<T>(
    range: impl RangeBounds<T> + Clone + Send + Sync + 'static,
    expected: &'static str,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: FromStr + PartialOrd,
{
    move |text| {
        let number = text.parse().ok().filter(|number| range.contains(number));
        number.ok_or_else(|| format!("expected {expected}"))
    }
}

/// Takes numbers above zero.
pub fn positive() -> impl Fn(&str) -> Result<f64, String> + Clone + Send + Sync + 'static {
    within(f64::MIN_POSITIVE..=f64::MAX, POSITIVE)
}

/// Takes numbers from 0 up, such as seeds.
pub fn whole() -> impl Fn(&str) -> Result<u64, String> + Clone + Send + Sync + 'static {
    within(.., WHOLE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_out_of_range_or_no_number_is_told_what_is_expected() {
        let share = within(0.0..1.0, "a share");
        assert_eq!((share("0"), share("0.5")), (Ok(0.0), Ok(0.5)));
        for text in ["1", "-0.1", "nan", "inf", "some", ""] {
            assert_eq!(share(text), Err("expected a share".to_owned()), "{text}");
        }
        assert!(positive()("1e-3").is_ok() && positive()("0").is_err() && positive()("inf").is_err());
        assert!(whole()("18446744073709551615").is_ok() && whole()("-1").is_err() && whole()("1.5").is_err());
    }
}
