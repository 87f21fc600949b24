//! The rules inside of a sector, and its blocks.

use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::spectrum::polynomial::Polynomial;

/// The rules inside of a sector. Loop and Warren differ at smooth vertices only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rules {
    CatmullClark,
    Loop,
}

pub(super) fn number(numerator: i64, denominator: i64) -> RealCyclotomic {
    Rational::new(numerator, denominator).into()
}

/// cos(πj/F).
pub(super) fn cosine(j: usize, faces: usize) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(j, 2 * faces)).expect("few faces")
}

/// The characteristic polynomial of block j, 1 ≤ j ≤ F; 1 where there is none.
pub(super) fn block(rules: Rules, j: usize, faces: usize) -> Polynomial {
    let c = cosine(j, faces);
    match rules {
        Rules::CatmullClark if j == faces => vec![number(-1, 4), number(1, 1)],
        Rules::CatmullClark => {
            vec![number(1, 16), c.plus(&number(5, 1)).times(&number(-1, 8)), number(1, 1)]
        }
        Rules::Loop if j == faces => vec![number(1, 1)],
        Rules::Loop => vec![c.times(&number(-1, 4)).minus(&number(3, 8)), number(1, 1)],
    }
}
