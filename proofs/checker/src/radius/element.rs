//! Entries of matrices: fractions, or numbers of one field Q(α) by their coordinates.

use super::field::Field;
use crate::numbers::{
    Meter, Q, bits, divide, gcd, int, multiplied, product_steps, signum, trimmed,
};
use crate::text::Stop;
use num_traits::{One, Zero};
use std::rc::Rc;

/// The number p(α), or a fraction.
#[derive(Clone)]
pub struct Element {
    p: Vec<Q>,
    /// `None` for a fraction.
    field: Option<Rc<Field>>,
}

impl Element {
    fn new(p: Vec<Q>, field: Option<Rc<Field>>) -> Element {
        Element { p: trimmed(p), field }
    }

    /// The number with these coordinates, of a degree below that of the polynomial.
    pub fn of(coordinates: &[Q], field: Option<&Rc<Field>>) -> Element {
        Element::new(coordinates.to_vec(), field.cloned())
    }

    /// A fraction.
    pub fn fraction(value: &Q) -> Element {
        Element::of(std::slice::from_ref(value), None)
    }

    /// An integer.
    pub fn whole(value: i64) -> Element {
        Element::fraction(&int(value))
    }

    fn with(&self, other: &Element, p: Vec<Q>) -> Element {
        Element::new(p, self.field.as_ref().or(other.field.as_ref()).cloned())
    }

    /// The sum.
    pub fn plus(&self, other: &Element) -> Element {
        self.with(other, combined(self.p.clone(), &int(1), &other.p))
    }

    /// The difference.
    pub fn minus(&self, other: &Element) -> Element {
        self.with(other, combined(self.p.clone(), &int(-1), &other.p))
    }

    /// The absolute value.
    pub fn size(&self) -> Element {
        if self.sign() < 0 { self.negated() } else { self.clone() }
    }

    /// The product with a fraction.
    pub fn scaled(&self, factor: &Q) -> Element {
        Element::new(self.p.iter().map(|x| x * factor).collect(), self.field.clone())
    }

    /// The product.
    pub fn times(&self, other: &Element) -> Element {
        let product = self.with(other, multiplied(&self.p, &other.p));
        match &product.field {
            Some(field) if product.p.len() > field.degree() => {
                let rest = divide(product.p, field.polynomial()).1;
                Element::new(rest, product.field)
            }
            _ => product,
        }
    }

    /// −1, 0 or 1.
    pub fn sign(&self) -> i8 {
        match &self.field {
            Some(field) if self.p.len() > 1 => field.sign(&self.p),
            _ => self.p.first().map_or(0, signum),
        }
    }

    /// 1/p(α), for p(α) ≠ 0: the inverse of p modulo the part of the polynomial that has no divisor with p in common. This part has the
    /// root α.
    pub fn inverse(&self) -> Element {
        let (Some(field), true) = (&self.field, self.p.len() > 1) else {
            let value = self.p.first().map(Q::recip);
            return Element::new(value.into_iter().collect(), self.field.clone());
        };
        if !field.affords(&self.p) {
            return Element::new(Vec::new(), self.field.clone());
        }
        let (modulus, _) = divide(field.polynomial().to_vec(), &gcd(&self.p, field.polynomial()));
        // The remainders of Euclid's algorithm are r = u·p modulo the modulus.
        let (mut before, mut rest) = (modulus.clone(), divide(self.p.clone(), &modulus).1);
        let (mut factor_before, mut factor) = (Vec::new(), vec![Q::one()]);
        rest = trimmed(rest);
        while rest.len() > 1 {
            let (quotient, next) = divide(before, &rest);
            let product = multiplied(&quotient, &factor);
            let mut difference = combined(factor_before, &int(-1), &product);
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

    /// As a certificate writes it.
    pub fn text(&self) -> String {
        match &self.p[..] {
            [] => "0".to_owned(),
            p => p.iter().map(Q::to_string).collect::<Vec<String>>().join(","),
        }
    }

    /// The fraction that it is, if it is none of a field.
    pub fn as_fraction(&self) -> Option<Q> {
        let value = || self.p.first().cloned().unwrap_or_else(Q::zero);
        (self.p.len() <= 1).then(value)
    }

    /// The binary digits of the longest coordinate.
    fn longest(&self) -> u64 {
        self.p.iter().map(bits).max().unwrap_or(0)
    }

    /// Adds x·y, after its steps are counted.
    pub fn add_product(&mut self, x: &Element, y: &Element, meter: &Meter) -> Result<(), Stop> {
        if x.p.is_empty() || y.p.is_empty() {
            return Ok(());
        }
        meter.spend(steps_of([self, x, y]))?;
        *self = self.plus(&x.times(y));
        Ok(())
    }

    /// The number times −1.
    pub fn negated(&self) -> Element {
        self.scaled(&int(-1))
    }

    /// The product, after its steps are counted.
    pub fn metered_times(&self, other: &Element, meter: &Meter) -> Result<Element, Stop> {
        let mut product = Element::whole(0);
        product.add_product(self, other, meter).map(|()| product)
    }
}

/// The steps of a sum or a product of these numbers.
fn steps_of(numbers: [&Element; 3]) -> u64 {
    let field = numbers.iter().find_map(|x| x.field.as_ref());
    let degree = numbers.iter().map(|x| x.p.len() as u64).max().unwrap_or(1);
    let Some(field) = field.filter(|_| degree > 1) else {
        return product_steps(numbers.map(Element::longest).iter().sum());
    };
    // The coordinates of a product grow where the polynomial divides it.
    let leading = field.polynomial().last().map_or(0, bits);
    let longest = numbers.map(Element::longest).into_iter().max().unwrap_or(0) + degree * leading;
    // Each of these fractions takes a common divisor.
    1 + degree * degree * (longest / 32 + product_steps(longest) / 2)
}

/// p + factor·q.
fn combined(mut p: Vec<Q>, factor: &Q, q: &[Q]) -> Vec<Q> {
    p.resize(p.len().max(q.len()), Q::zero());
    p.iter_mut().zip(q).for_each(|(x, y)| *x += factor * y);
    p
}
