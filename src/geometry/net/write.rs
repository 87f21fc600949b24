//! Nets as text.

use super::grid::Net;
use crate::exact::Rational;
use crate::mesh::{BeyondF64, decimals, one_line};
use std::fmt::Write as _;

/// A net as CSV: a line for each row, its points separated by commas, the coordinates of a point by
/// blanks; the nearest f64 of each coordinate, as the shortest decimal that reads back.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, to_csv};
///
/// let point = |k: i64| [Rational::new(k % 2, 3), Rational::from(k / 2), Rational::zero()];
/// let net = Net::new((0..4).map(point).collect(), 2, Closed::default())?;
/// let text = to_csv(&net, "a square")?;
/// assert!(text.ends_with("\n0.0 1.0 0.0, 0.3333333333333333 1.0 0.0\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_csv(net: &Net<Rational>, title: &str) -> Result<String, BeyondF64> {
    let mut text = format!("# {}\n", one_line(title));
    for row in net.points().chunks(net.columns()) {
        for (j, point) in row.iter().enumerate() {
            let separator = if j == 0 { "" } else { ", " };
            write!(text, "{separator}{}", decimals(point)?.join(" ")).expect("memory");
        }
        text.push('\n');
    }
    Ok(text)
}
