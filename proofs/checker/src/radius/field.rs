//! The field Q(α) of a real root α of a polynomial, which need not be irreducible, and the signs of its numbers.
//!
//! A number p(α) has many coordinates p, if the polynomial is reducible. It is 0 if and only if the greatest common
//! divisor of p and the polynomial has the root α. THEOREMS.md, 120.

use crate::numbers::{Meter, Q, at, bits, gcd, int, roots_between, signum, steps_of_gcd, trimmed};
use num_traits::Zero;
use std::cell::{Cell, RefCell};

/// The most halvings for one sign.
const MAX_HALVINGS: usize = 1_000;

/// The most binary digits of a coefficient, times the degree.
const MAX_BITS: u64 = 1 << 15;

/// A square-free polynomial, and an interval with one of its roots α.
pub struct Field {
    polynomial: Vec<Q>,
    low: Q,
    high: Q,
    /// An interval around α that becomes narrower when a sign needs it.
    near: RefCell<(Q, Q)>,
    /// Whether a sign or an inverse was not found within the halvings and steps that are allowed.
    gave_up: Cell<bool>,
    /// The steps of common divisors.
    meter: Meter,
}

impl Field {
    /// The field of the only root between these numbers; `None` unless the polynomial is square-free, and has just one
    /// root between them, and none at them.
    pub fn new(polynomial: Vec<Q>, low: Q, high: Q) -> Option<Field> {
        let polynomial = trimmed(polynomial);
        let long = polynomial.iter().chain([&low, &high]).map(bits).max().unwrap_or(0);
        if polynomial.len() < 3 || low >= high || long * polynomial.len() as u64 > MAX_BITS {
            return None;
        }
        let derivative: Vec<Q> = (1_i64..).zip(&polynomial[1..]).map(|(i, c)| c * int(i)).collect();
        let simple = gcd(&polynomial, &derivative).len() == 1;
        let ends = [&low, &high].map(|x| signum(&at(&polynomial, x)));
        let one = ends[0] * ends[1] < 0 && roots_between(&polynomial, &low, &high) == 1;
        let near = RefCell::new((low.clone(), high.clone()));
        let (gave_up, meter) = (Cell::new(false), Meter::default());
        (simple && one).then_some(Field { polynomial, low, high, near, gave_up, meter })
    }

    /// The polynomial.
    pub fn polynomial(&self) -> &[Q] {
        &self.polynomial
    }

    /// The degree of the polynomial.
    pub fn degree(&self) -> usize {
        self.polynomial.len() - 1
    }

    /// Whether a divisor of the polynomial has the root α, which is then simple.
    fn is_root(&self, divisor: &[Q]) -> bool {
        signum(&at(divisor, &self.low)) != signum(&at(divisor, &self.high))
    }

    /// The sign of p(α), if the interval around α shows it.
    fn sign_near(&self, p: &[Q]) -> Option<i8> {
        let (low, high) = &*self.near.borrow();
        let (mut least, mut greatest) = (Q::zero(), Q::zero());
        for c in p.iter().rev() {
            let products = [&least * low, &least * high, &greatest * low, &greatest * high];
            least = products.iter().min().cloned()? + c;
            greatest = products.into_iter().max()? + c;
        }
        let signs = (signum(&least), signum(&greatest));
        (signs.0 == signs.1).then_some(signs.0)
    }

    fn halve(&self) {
        let mut near = self.near.borrow_mut();
        let middle = (&near.0 + &near.1) / int(2);
        let sign = |x: &Q| signum(&at(&self.polynomial, x));
        match sign(&middle) {
            0 => *near = (middle.clone(), middle),
            other if other == sign(&near.0) => near.0 = middle,
            _ => near.1 = middle,
        }
    }

    /// The sign of p(α); 0 if it was not found.
    pub fn sign(&self, p: &[Q]) -> i8 {
        if let Some(sign) = self.sign_near(p) {
            return sign;
        }
        if !self.affords(p) || self.is_root(&gcd(p, &self.polynomial)) {
            return 0;
        }
        for _ in 0..MAX_HALVINGS {
            self.halve();
            if let Some(sign) = self.sign_near(p) {
                return sign;
            }
        }
        self.gave_up.set(true);
        0
    }

    /// Whether a common divisor with the polynomial is within the steps that are allowed.
    pub fn affords(&self, p: &[Q]) -> bool {
        if self.meter.spend(steps_of_gcd(p, &self.polynomial)).is_err() {
            self.gave_up.set(true);
        }
        !self.gave_up()
    }

    /// Whether a sign was not found. Then nothing is known.
    pub fn gave_up(&self) -> bool {
        self.gave_up.get()
    }
}
