//! Numbers of the field Q(α) of a real root α of a polynomial, which need not be irreducible.
//!
//! A number p(α) has many coordinates p, if the polynomial is reducible. It is 0 if and only if the greatest common
//! divisor of p and the polynomial has the root α. THEOREMS.md, 120.

use crate::decimal::{Q, bits, int};
use crate::meter::Meter;
use crate::polynomial::{at, divide, gcd, roots_between, signum, steps_of_gcd, trimmed};
use num_traits::{One, Zero};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

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

    fn sign(&self, p: &[Q]) -> i8 {
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
    fn affords(&self, p: &[Q]) -> bool {
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

/// The number p(α).
#[derive(Clone)]
pub struct Element {
    p: Vec<Q>,
    /// `None` for a fraction.
    field: Option<Rc<Field>>,
}

impl Element {
    /// The number with these coordinates, of a degree below that of the polynomial.
    pub fn new(p: Vec<Q>, field: Option<Rc<Field>>) -> Element {
        Element { p: trimmed(p), field }
    }

    /// The coordinates.
    pub fn coordinates(&self) -> &[Q] {
        &self.p
    }

    /// By how many binary digits the coordinates of a product grow where the polynomial divides it.
    pub fn growth(&self) -> u64 {
        let polynomial =
            self.field.as_ref().filter(|_| self.p.len() > 1).map(|field| &field.polynomial);
        polynomial.map_or(0, |p| self.p.len() as u64 * p.last().map_or(0, bits))
    }

    fn with(&self, other: &Element, p: Vec<Q>) -> Element {
        let field = self.field.as_ref().or(other.field.as_ref()).cloned();
        Element::new(p, field)
    }

    /// The sum.
    pub fn plus(&self, other: &Element) -> Element {
        let mut sum = self.p.clone();
        sum.resize(sum.len().max(other.p.len()), Q::zero());
        for (x, y) in sum.iter_mut().zip(&other.p) {
            *x += y;
        }
        self.with(other, sum)
    }

    /// The product with a fraction.
    pub fn scaled(&self, factor: &Q) -> Element {
        Element::new(self.p.iter().map(|x| x * factor).collect(), self.field.clone())
    }

    /// The product.
    pub fn times(&self, other: &Element) -> Element {
        let product = self.with(other, multiplied(&self.p, &other.p));
        let Some(field) = &product.field else { return product };
        let reduced = if product.p.len() > field.degree() {
            divide(product.p.clone(), &field.polynomial).1
        } else {
            return product;
        };
        Element::new(reduced, product.field.clone())
    }

    /// The sign of p(α).
    pub fn sign(&self) -> i8 {
        match &self.field {
            Some(field) if self.p.len() > 1 => field.sign(&self.p),
            _ => self.p.first().map_or(0, signum),
        }
    }

    /// 1/p(α), for p(α) ≠ 0: the inverse of p modulo the part of the polynomial that has no divisor with p in common.
    /// This part has the root α.
    pub fn inverse(&self) -> Element {
        let (Some(field), true) = (&self.field, self.p.len() > 1) else {
            let value = self.p.first().map(Q::recip);
            return Element::new(value.into_iter().collect(), self.field.clone());
        };
        if !field.affords(&self.p) {
            return Element::new(Vec::new(), self.field.clone());
        }
        let (modulus, _) = divide(field.polynomial.clone(), &gcd(&self.p, &field.polynomial));
        // The remainders of Euclid's algorithm are r = u·p modulo the modulus.
        let (mut before, mut rest) = (modulus.clone(), divide(self.p.clone(), &modulus).1);
        let (mut factor_before, mut factor) = (Vec::new(), vec![Q::one()]);
        rest = trimmed(rest);
        while rest.len() > 1 {
            let (quotient, next) = divide(before, &rest);
            let product = multiplied(&quotient, &factor);
            let mut difference: Vec<Q> = factor_before;
            difference.resize(difference.len().max(product.len()), Q::zero());
            for (x, y) in difference.iter_mut().zip(&product) {
                *x -= y;
            }
            // With the leading coefficient 1 the fractions remain short.
            let mut next = trimmed(next);
            let scale = next.last().map_or_else(Q::one, Q::recip);
            next.iter_mut().chain(&mut difference).for_each(|x| *x *= &scale);
            (before, rest) = (rest, next);
            (factor_before, factor) = (factor, difference);
        }
        let scale = rest.first().map_or_else(Q::zero, Q::recip);
        let inverse = factor.iter().map(|x| x * &scale).collect();
        Element::new(inverse, self.field.clone())
    }
}

fn multiplied(p: &[Q], q: &[Q]) -> Vec<Q> {
    let mut product = vec![Q::zero(); (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}
