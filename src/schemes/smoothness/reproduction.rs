//! Polynomials that a scheme reproduces.

use crate::exact::{Rational, Scalar};
use crate::limit::rule_shifts;
use crate::scheme::Mask;

/// The largest d such that one refinement takes the values of every polynomial p of degree at most d at
/// i + s to those at (i + s)/n, with the natural shift s.
///
/// That is Σ_j a_{α,j} (o + j + s)^k = ((α + s)/n)^k for all α and k ≤ d: powers of i on both sides follow
/// by the binomial theorem. Of N points, with no point of level 1 among them, at most polynomials of
/// degree N − 1 are reproduced, so that d < N.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::reproduction_degree;
///
/// let degree = |name| Ok::<_, subcert::scheme::SchemeError>(reproduction_degree(parse_scheme(name)?.masks()[0]));
/// assert_eq!((degree("four-point:w=1/16")?, degree("four-point:w=1/15")?, degree("chaikin")?), (3, 1, 1));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn reproduction_degree<F: Scalar + PartialEq>(mask: &Mask<F>) -> usize {
    let shifts = rule_shifts(mask);
    // Without one shift for all rules lines are not reproduced.
    if shifts.iter().all(|shift| *shift == shifts[0]) {
        reproduction_degree_at(mask, &shifts[0])
    } else {
        0
    }
}

/// As [`reproduction_degree`], with the points i of level k at (i + s)/n^k for this s: 0 for the parameters i/n^k.
#[must_use]
pub fn reproduction_degree_at<F: Scalar + PartialEq>(mask: &Mask<F>, shift: &F) -> usize {
    let number = |x: Rational| F::from_rational(&x);
    let inverse = number(Rational::from(mask.arity()).recip());
    let holds = |degree: usize| {
        let power = |x: F| (0..degree).fold(number(Rational::one()), |power, _| power.times(&x));
        (0..).zip(mask.rules().rows()).all(|(alpha, row)| {
            let places = (mask.offset()..).map(|i| power(number(Rational::from(i)).plus(shift)));
            let terms = row.iter().zip(places);
            let sum = terms.fold(F::zero(), |sum, (a, x)| sum.plus(&a.times(&x)));
            sum == power(number(Rational::from(alpha)).plus(shift).times(&inverse))
        })
    };
    (1..mask.width()).find(|&degree| !holds(degree)).unwrap_or(mask.width()) - 1
}
