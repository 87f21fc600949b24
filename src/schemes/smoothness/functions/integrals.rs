//! Integrals of basic limit functions.

use crate::exact::{Integer, Rational, Scalar};
use crate::limit::{Limit, LimitError};
use crate::scheme::{Mask, MaskError};
use crate::smoothness::symbol::Symbol;

/// Why there are no inner products.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum InnerProductError {
    /// The schemes have different arities.
    #[error("the arities differ: {0} and {1}")]
    Arities(usize, usize),
    /// One of the schemes, or that of their inner products, is not shown to have continuous limits.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// The mask of the inner products is too large.
    #[error(transparent)]
    Mask(#[from] MaskError),
}

/// The function g(y) = ∫ φ(x) ψ(x − y) dx of the basic limit functions φ and ψ of two masks of one arity.
///
/// It is the basic limit function of the scheme with the symbol (1/n) a(z) b(1/z), see [`Symbol::correlation`], as ∫ φ =
/// ∫ ψ = 1.
pub struct InnerProducts(Limit);

impl InnerProducts {
    /// Those of these masks.
    ///
    /// # Errors
    /// When the arities differ, the mask is too large, φ or ψ is not shown to be in L², or the scheme of g is not shown to
    /// converge. φ is in L² if its scheme converges, or that of ∫ φ(x) φ(x − y) dx. `proofs/THEOREMS.md`, 138.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::smoothness::InnerProducts;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let hats = parse_scheme("b-spline:degree=1")?;
    /// let products = InnerProducts::new(hats.masks()[0], hats.masks()[0])?;
    /// let values = [-1, 0, 1, 2].map(|k| products.at(&Rational::from(k)));
    /// let [sixth, two_thirds] = [Rational::new(1, 6), Rational::new(2, 3)];
    /// assert_eq!(values.map(Result::unwrap), [sixth.clone(), two_thirds, sixth, Rational::zero()]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(first: &Mask, second: &Mask) -> Result<InnerProducts, InnerProductError> {
        if first.arity() != second.arity() {
            return Err(InnerProductError::Arities(first.arity(), second.arity()));
        }
        square_integrable(first)?;
        square_integrable(second)?;
        let symbol = Symbol::of(first).correlation(&Symbol::of(second));
        Ok(InnerProducts(Limit::new(&symbol.mask()?)?))
    }

    /// g(y).
    ///
    /// # Errors
    /// When y is too large, or its digits repeat too late.
    pub fn at(&self, y: &Rational) -> Result<Rational, LimitError> {
        basic(&self.0, y)
    }
}

/// Checks that φ is in L²: that the scheme converges, or that of ∫ φ(x) φ(x − y) dx, so that the scheme converges in L².
fn square_integrable(mask: &Mask) -> Result<(), InnerProductError> {
    let Err(error) = Limit::new(mask) else { return Ok(()) };
    let symbol = Symbol::of(mask);
    match Limit::new(&symbol.correlation(&symbol).mask()?) {
        Ok(_) => Ok(()),
        Err(_) => Err(error.into()),
    }
}

/// φ(x): the limit at x of the data 1 at 0 and 0 elsewhere, with the points i of level k at i/n^k.
///
/// # Errors
/// When x is too large, or its digits repeat too late.
pub fn basic(limit: &Limit, x: &Rational) -> Result<Rational, LimitError> {
    Ok(limit.at(x)?.coefficient(0))
}

/// The symbol of ψ with φ^{(m)}(x) = Σ_i (−1)^i binomial(m, i) ψ(x − i): n^m A/σ^m; `None` where the order of the sum rules is
/// less than m.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, derivative_symbol};
///
/// // The slope of the hat function is made of two boxes.
/// let hat = Symbol::of(parse_scheme("b-spline:degree=1")?.masks()[0]);
/// let boxes = Symbol::of(parse_scheme("haar")?.masks()[0]);
/// assert_eq!(derivative_symbol(&hat, 1).expect("sum rules").coefficients(), boxes.coefficients());
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn derivative_symbol<F: Scalar + PartialEq>(symbol: &Symbol<F>, m: u32) -> Option<Symbol<F>> {
    let factor = Rational::from(Integer::from(symbol.arity()).pow(m));
    symbol.difference(m as usize, &factor)
}

/// The symbol Aσ/n of χ with ∫_{x−1}^x φ = χ(x).
#[must_use]
pub fn integral_symbol<F: Scalar + PartialEq>(symbol: &Symbol<F>) -> Symbol<F> {
    let n = symbol.arity();
    let mut sums = vec![F::zero(); symbol.coefficients().len() + n - 1];
    let share = F::from_rational(&Rational::new(1, n));
    for (k, a) in symbol.coefficients().iter().enumerate() {
        let part = a.times(&share);
        for sum in &mut sums[k..k + n] {
            sum.accumulate(&part);
        }
    }
    Symbol::new(n, symbol.powers().0, sums)
}

/// M_m = ∫ x^m φ(x) dx for m = 0, …, `last`, in the sense of distributions if φ is none else.
///
/// With M_0 = 1 and S_p = Σ_k k^p a_k, (n^{m+1} − n) M_m = Σ_{i<m} binomial(m, i) S_{m−i} M_i.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::smoothness::moments;
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::Symbol;
///
/// // The hat function on [−1, 1].
/// let hat = moments(&Symbol::of(parse_scheme("b-spline:degree=1")?.masks()[0]), 2);
/// assert_eq!(hat, [Rational::one(), Rational::zero(), Rational::new(1, 6)]);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[must_use]
pub fn moments<F: Scalar + PartialEq>(symbol: &Symbol<F>, last: u32) -> Vec<F> {
    let number = |x: Integer| F::from_rational(&Rational::from(x));
    let power = |k: i64, p: u32| number(Integer::from(k).pow(p));
    let sum =
        |p: u32| symbol.terms().fold(F::zero(), |sum, (k, a)| sum.plus(&a.times(&power(k, p))));
    let sums: Vec<F> = (0..=last).map(sum).collect();
    let n = Integer::from(symbol.arity());
    let mut moments = vec![F::from_rational(&Rational::one())];
    for m in 1..=last {
        // binomial(m, i)
        let mut binomial = Integer::one();
        let mut total = F::zero();
        for (i, moment) in (0..m).zip(&moments) {
            let term = sums[(m - i) as usize].times(moment).times(&number(binomial.clone()));
            total.accumulate(&term);
            binomial = Rational::new(binomial * Integer::from(m - i), Integer::from(i + 1)).floor();
        }
        let factor = Rational::from(n.pow(m + 1) - n.clone()).recip();
        moments.push(total.times(&F::from_rational(&factor)));
    }
    moments
}
