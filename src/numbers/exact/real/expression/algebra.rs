//! Expressions as elements of an algebra over one cyclotomic field.

use super::node::{Field, Generator, Operation, RealExpression};
use crate::exact::polynomials::dense::product;
use crate::exact::{Adjugate, Rational, Real, RealCyclotomic, Scalar};
use std::collections::HashMap;
use std::sync::Arc;

/// The coefficients of an element at the products of powers of the roots. The exponent of the first
/// root runs fastest.
pub(super) type Element = Vec<RealCyclotomic>;

/// K\[θ_1, …, θ_r\] modulo the polynomials by which the roots are defined: an algebra of dimension
/// d_1⋯d_r over K = Q(2cos(2π/n)). Evaluation at the roots maps it to the reals. It need not be a field.
pub(super) struct Algebra<'a> {
    generators: &'a [Arc<Generator>],
    /// For each root its degree d, and a_0, …, a_{d−1} with θ^d = Σ a_k θ^k over the roots before it.
    relations: Vec<Vec<Element>>,
    known: HashMap<*const (), Element>,
}

impl<'a> Algebra<'a> {
    /// That of the roots of a field whose conductor is within the cap.
    pub(super) fn new(field: &'a Field) -> Algebra<'a> {
        let mut algebra =
            Algebra { generators: &field.generators, relations: Vec::new(), known: HashMap::new() };
        for generator in &field.generators {
            algebra.known.clear();
            let relation = match &**generator {
                Generator::Square(radicand) => vec![algebra.element(radicand), algebra.constant(0)],
                Generator::Isolated(root) => {
                    let (leading, lower) = root.given.split_last().expect("a polynomial");
                    let scaled = lower.iter().map(|c| -&c.over(leading));
                    scaled.map(|c| algebra.scalar(c)).collect()
                }
            };
            algebra.relations.push(relation);
        }
        algebra.known.clear();
        algebra
    }

    fn degree(&self, root: usize) -> usize {
        self.relations[root].len()
    }

    /// The dimension over K.
    fn dimension(&self) -> usize {
        (0..self.relations.len()).map(|root| self.degree(root)).product()
    }

    fn scalar(&self, value: RealCyclotomic) -> Element {
        let mut element = vec![RealCyclotomic::zero(); self.dimension()];
        element[0] = value;
        element
    }

    fn constant(&self, value: i64) -> Element {
        self.scalar(RealCyclotomic::from(value))
    }

    /// An element whose value is that of the expression.
    pub(super) fn element(&mut self, expression: &RealExpression) -> Element {
        let key = Arc::as_ptr(&expression.0).cast::<()>();
        if let Some(element) = self.known.get(&key) {
            return element.clone();
        }
        let element = match &expression.0.operation {
            Operation::Number(value) => self.scalar(value.clone()),
            Operation::Sum(a, b) => sum(&self.element(a), &self.element(b)),
            Operation::Difference(a, b) => difference(&self.element(a), &self.element(b)),
            Operation::Product(a, b) => {
                let (a, b) = (self.element(a), self.element(b));
                self.product(&a, &b)
            }
            Operation::Quotient(a, b) => {
                let (a, b) = (self.element(a), self.element(b));
                self.product(&a, &self.inverse(&b))
            }
            Operation::Root(root) => self.root(root),
        };
        self.known.insert(key, element.clone());
        element
    }

    fn root(&self, root: &Arc<Generator>) -> Element {
        let place = self.generators.iter().position(|one| one.same(root)).expect("a known root");
        let mut element = self.constant(0);
        let unit: usize = (0..place).map(|root| self.degree(root)).product();
        element[unit] = RealCyclotomic::from(1);
        element
    }

    fn product(&self, a: &Element, b: &Element) -> Element {
        self.product_over(self.relations.len(), a, b)
    }

    /// The product of two elements over the first `roots` roots.
    fn product_over(&self, roots: usize, a: &[RealCyclotomic], b: &[RealCyclotomic]) -> Element {
        let Some(last) = roots.checked_sub(1) else { return vec![a[0].times(&b[0])] };
        let (degree, unit) = (self.degree(last), a.len() / self.degree(last));
        let zero = |part: &[RealCyclotomic]| part.iter().all(|c| c.sign() == 0);
        let parts = |element: &'_ [RealCyclotomic]| -> Vec<Element> {
            element.chunks(unit).map(<[RealCyclotomic]>::to_vec).collect()
        };
        let mut powers = vec![vec![RealCyclotomic::zero(); unit]; 2 * degree - 1];
        for (i, x) in parts(a).iter().enumerate().filter(|(_, x)| !zero(x)) {
            for (j, y) in parts(b).iter().enumerate().filter(|(_, y)| !zero(y)) {
                powers[i + j] = sum(&powers[i + j], &self.product_over(last, x, y));
            }
        }
        while powers.len() > degree {
            let top = powers.pop().expect("longer than the degree");
            if zero(&top) {
                continue;
            }
            let shift = powers.len() - degree;
            for (k, relation) in self.relations[last].iter().enumerate() {
                powers[shift + k] =
                    sum(&powers[shift + k], &self.product_over(last, &top, relation));
            }
        }
        powers.concat()
    }

    /// The characteristic polynomial over K of the multiplication by an element. The element is a root
    /// of it (Cayley and Hamilton), and so is its value.
    pub(super) fn characteristic(&self, element: &Element) -> Vec<RealCyclotomic> {
        let dimension = self.dimension();
        let unit = |i: usize| {
            let mut unit = self.constant(0);
            unit[i] = RealCyclotomic::from(1);
            unit
        };
        let columns: Vec<Element> =
            (0..dimension).map(|i| self.product(element, &unit(i))).collect();
        Adjugate::of(&columns).characteristic
    }

    /// An element whose value is the inverse of that of `element`, which is not 0. The value y is a root
    /// of the characteristic polynomial and so of g(x) = Σ g_k x^k with g_0 ≠ 0, which is this polynomial
    /// without its factors x. So 1/y = −Σ_{k≥1} g_k y^{k−1}/g_0.
    fn inverse(&self, element: &Element) -> Element {
        let mut polynomial = self.characteristic(element);
        polynomial.drain(..polynomial.iter().take_while(|c| c.sign() == 0).count());
        let (first, rest) = polynomial.split_first().expect("a leading coefficient of 1");
        let factor = -&first.recip();
        let value = rest.iter().rev().fold(self.constant(0), |value, c| {
            sum(&self.product(&value, element), &self.scalar(c.clone()))
        });
        value.iter().map(|c| c.times(&factor)).collect()
    }
}

impl Algebra<'_> {
    /// Π p^σ over the conjugates p^σ of a polynomial over K, which has rational coefficients.
    pub(super) fn norm(polynomial: &[RealCyclotomic]) -> Vec<Rational> {
        let n = polynomial.iter().fold(1, |n, c| num_integer::lcm(n, c.conductor()));
        let units = (1..=(n / 2).max(1)).filter(|a| num_integer::gcd(*a, n) == 1);
        let conjugates = units.map(|a| -> Vec<RealCyclotomic> {
            polynomial.iter().map(|c| c.conjugate(a)).collect()
        });
        let product = conjugates.reduce(|a, b| product(&a, &b));
        let rational = |c: &RealCyclotomic| c.as_rational().expect("a norm is rational").clone();
        product.unwrap_or_default().iter().map(rational).collect()
    }
}

fn sum(a: &[RealCyclotomic], b: &[RealCyclotomic]) -> Element {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

fn difference(a: &[RealCyclotomic], b: &[RealCyclotomic]) -> Element {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
