//! Luck: how many cells readings of unrelated values would explain.

use crate::decimal::{Decimal, Q, int};
use crate::table::{Cells, Place, Table};
use num_traits::{One, Pow, Signed, Zero};

/// Whether m cells may be explained by luck. It compares with 1/1000 a bound of the expected number
/// of readings of unrelated values that give m of these cells: the number of readings times the
/// m-th elementary symmetric polynomial of the likelihoods of the cells. A cell that is printed as
/// 0 is no evidence; it is left out, and m is one less.
pub fn is_luck(table: &Table<'_>, cells: &Cells, m: usize, readings: &Q) -> bool {
    let depth = table.tolerance.is_some();
    let telling = |cell: &&(Place, Decimal)| depth || !cell.1.digits.is_zero();
    let m = m.saturating_sub(cells.len() - cells.iter().filter(telling).count());
    let mut symmetric = vec![Q::zero(); m + 1];
    symmetric[0] = Q::one();
    for (_, decimal) in cells.iter().filter(telling) {
        let digits = decimal.digits.abs().to_string();
        let digits = i32::try_from(digits.trim_end_matches('0').len()).unwrap_or(i32::MAX);
        let likely = if depth { int(4).recip() } else { int(10).pow(1 - digits) / int(9) };
        for k in (1..=m).rev() {
            let more = &symmetric[k - 1] * &likely;
            symmetric[k] += more;
        }
    }
    &symmetric[m] * readings > int(1_000).recip()
}
