//! Whether a dilation shrinks all directions alike.

#![warn(clippy::arithmetic_side_effects)]

use crate::schemes::Dilation;
use num_bigint::BigInt;
use num_traits::{Signed as _, Zero as _};

/// Whether all eigenvalues of M have one modulus, and M is diagonalisable.
pub fn is_similar(dilation: &Dilation) -> bool {
    let rows = dilation.rows().map(|row| row.map(BigInt::from));
    let determinant = BigInt::from(dilation.adjugate().1);
    let trace: BigInt = (0..dilation.d).map(|i| &rows[i][i]).sum();
    if dilation.d == 2 {
        // λ² − tr·λ + det: two conjugate numbers, or λ and −λ, or one number, and then M is a multiple of I.
        let conjugate = &trace * &trace < &determinant * 4;
        let opposite = trace.is_zero() && determinant.is_negative();
        return conjugate || opposite || is_scalar(&rows, 2);
    }
    let (adjugate, _) = dilation.adjugate();
    // λ³ − tr·λ² + minors·λ − det, where the minors are the diagonal of the adjugate.
    let minors: BigInt = (0..3).map(|i| BigInt::from(adjugate[i][i])).sum();
    let size = determinant.abs().cbrt();
    if &size * &size * &size != determinant.abs() {
        // The real root is no integer: its polynomial is λ³ − det, which divides the other one.
        return trace.is_zero() && minors.is_zero();
    }
    // The real root of the modulus n = |det|^{1/3} has the sign of the determinant, as the product of the others is n²:
    // (λ − r)(λ² + bλ + n²), b = r − tr.
    let root = if determinant.is_negative() { -&size } else { size.clone() };
    let b = &root - &trace;
    let square = &size * &size;
    if minors != &square - &root * &b {
        return false;
    }
    match b.abs().cmp(&(&size * 2)) {
        std::cmp::Ordering::Less => true,
        // All roots are n or −n.
        std::cmp::Ordering::Equal => square_is_scalar(dilation, &rows),
        std::cmp::Ordering::Greater => false,
    }
}

fn is_scalar(rows: &[[BigInt; 3]; 3], d: usize) -> bool {
    let entries = (0..d).flat_map(|i| (0..d).map(move |j| (i, j)));
    entries
        .into_iter()
        .all(|(i, j)| if i == j { rows[i][i] == rows[0][0] } else { rows[i][j].is_zero() })
}

/// Whether M² is a multiple of I.
fn square_is_scalar(dilation: &Dilation, rows: &[[BigInt; 3]; 3]) -> bool {
    let square = [0, 1, 2]
        .map(|i: usize| [0, 1, 2].map(|j: usize| (0..3).map(|k| &rows[i][k] * &rows[k][j]).sum()));
    is_scalar(&square, dilation.d)
}

/// ±n, if M = ±nI.
pub fn scalar(dilation: &Dilation) -> Option<i64> {
    let rows = dilation.rows();
    is_scalar(&rows.map(|row| row.map(BigInt::from)), dilation.d).then_some(rows[0][0])
}

/// n, if m = n^d.
pub fn root(dilation: &Dilation) -> Option<u64> {
    let m = dilation.arity();
    let power = |n: u64| u32::try_from(dilation.d).ok().and_then(|d| n.checked_pow(d));
    (2..=m).find(|n| power(*n) == Some(m))
}
