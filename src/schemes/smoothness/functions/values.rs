//! Values of the basic limit function over any ordered field.

use crate::bound::{Order, power_norm_generic};
use crate::exact::{Rational, Real, only_solution};
use crate::scheme::Mask;
use crate::smoothness::symbol::Symbol;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The greatest k of a place i/n^k.
const MAX_LEVELS: usize = 16;

/// The most integers inside of a support.
const MAX_INTEGERS: i64 = 64;

/// Whether T_c < 1 for some c, where the number n^c of residue classes is at most `most`, so that the scheme of the mask converges.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::is_contractive;
///
/// let of = |text| is_contractive(parse_scheme(text).unwrap().masks()[0], 256);
/// assert!(of("four-point") && !of("haar"));
/// ```
#[must_use]
pub fn is_contractive<F: Real + PartialEq>(mask: &Mask<F>, most: usize) -> bool {
    let one = F::from_rational(&Rational::one());
    let difference = mask.difference();
    let classes = |c: &u32| mask.arity().checked_pow(*c).is_some_and(|count| count <= most);
    let mut constants = (1..)
        .take_while(classes)
        .filter_map(|c| power_norm_generic(&difference, c, Order::Adjoint).ok());
    // The greater of T_c and 1 is 1, and T_c is not.
    constants.any(|constant| one.greater(&constant) == one && constant != one)
}

/// The values of φ, φ(x) = Σ_k a_k φ(nx − k) and Σ_k φ(x − k) = 1, at x = i/n^k, k ≤ 16, for a scheme that converges.
///
/// The values at the integers inside the support are the only solution of this equation there with the sum 1. All others follow from
/// it. Source: Daubechies, Lagarias 1991.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{LimitValues, Symbol};
///
/// let values = LimitValues::new(&Symbol::of(parse_scheme("four-point")?.masks()[0])).expect("it converges");
/// assert_eq!(values.at(&Rational::new(1, 2)), Some(Rational::new(9, 16)));
/// assert_eq!(values.at(&Rational::new(1, 3)), None);
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
#[derive(Debug)]
pub struct LimitValues<F> {
    symbol: Symbol<F>,
    known: RefCell<BTreeMap<Rational, F>>,
}

impl<F: Real + PartialEq> LimitValues<F> {
    /// Solves for the values at the integers; `None` if they are not determined, or more than 64.
    #[must_use]
    pub fn new(symbol: &Symbol<F>) -> Option<LimitValues<F>> {
        let n = i64::try_from(symbol.arity()).ok()?;
        let (low, high) = symbol.powers();
        // l < i(n − 1) < K
        let first = low.div_euclid(n - 1) + 1;
        let last = (high - 1).div_euclid(n - 1);
        if last - first >= MAX_INTEGERS {
            return None;
        }
        let one = F::from_rational(&Rational::one());
        let row = |i: i64| {
            let mut row: Vec<F> = (first..=last).map(|j| symbol.coefficient(n * i - j)).collect();
            let own = usize::try_from(i - first).unwrap_or(0);
            row[own] = row[own].minus(&one);
            row.push(F::zero());
            row
        };
        let mut rows: Vec<Vec<F>> = (first..=last).map(row).collect();
        rows.push(vec![one; rows.len() + 1]);
        let values = only_solution(rows)?;
        let known = (first..).map(Rational::from).zip(values).collect();
        Some(LimitValues { symbol: symbol.clone(), known: RefCell::new(known) })
    }

    /// φ(x); `None` if xn^k is no integer for k ≤ 16.
    pub fn at(&self, x: &Rational) -> Option<F> {
        let n = Rational::from(self.symbol.arity());
        let mut levels = (0..=MAX_LEVELS).scan(x.clone(), |place, _| {
            let next = &*place * &n;
            Some(std::mem::replace(place, next).is_integer())
        });
        levels.any(|whole| whole).then(|| self.value(x, &n))
    }

    fn value(&self, x: &Rational, n: &Rational) -> F {
        let (first, last) = self.symbol.support();
        if *x <= first || *x >= last {
            return F::zero();
        }
        if let Some(value) = self.known.borrow().get(x) {
            return value.clone();
        }
        let finer = x * n;
        let terms = self
            .symbol
            .terms()
            .map(|(k, a)| a.times(&self.value(&(&finer - Rational::from(k)), n)));
        let value = terms.fold(F::zero(), |sum, term| sum.plus(&term));
        self.known.borrow_mut().insert(x.clone(), value.clone());
        value
    }
}
