//! Polynomials in two variables over the rationals.

use crate::exact::{Integer, Polynomial, Rational, RationalPolynomial, Scalar};

/// A polynomial Σ c_{i,j} x^i y^j over the rationals.
///
/// ```
/// use subcert::exact::{BivariatePolynomial, Polynomial, Rational};
///
/// let (v, w) = (Polynomial::variable("v"), Polynomial::variable("w"));
/// let p = (&v * &w).in_variables(["v", "w"]).expect("a polynomial in these");
/// assert_eq!(p.value_at([&Rational::from(2), &Rational::new(1, 4)]), Rational::new(1, 2));
/// assert_eq!(p.degrees(), [1, 1]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BivariatePolynomial {
    /// c_{i,j} as the member j of the row i. No row ends with 0, and the last one is not empty.
    rows: Vec<Vec<Rational>>,
}

impl BivariatePolynomial {
    /// The polynomial with these c_{i,j}, i the row.
    #[must_use]
    pub fn new(mut rows: Vec<Vec<Rational>>) -> BivariatePolynomial {
        for row in &mut rows {
            let length = row.iter().rposition(|c| !c.is_zero()).map_or(0, |last| last + 1);
            row.truncate(length);
        }
        let length = rows.iter().rposition(|row| !row.is_empty()).map_or(0, |last| last + 1);
        rows.truncate(length);
        BivariatePolynomial { rows }
    }

    /// c_{i,j} as the member j of the row i. No row ends with 0, and the last one is not empty.
    #[must_use]
    pub fn coefficients(&self) -> &[Vec<Rational>] {
        &self.rows
    }

    /// This as a polynomial in x, if y does not occur.
    #[must_use]
    pub fn in_first(&self) -> Option<RationalPolynomial> {
        let first = |row: &Vec<Rational>| row.first().cloned().unwrap_or_else(Rational::zero);
        let coefficients: Vec<Rational> = self.rows.iter().map(first).collect();
        (self.degrees()[1] == 0).then(|| RationalPolynomial::new(&coefficients))
    }

    /// The greatest exponents of x and of y; 0 for constants.
    #[must_use]
    pub fn degrees(&self) -> [usize; 2] {
        let longest = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        [self.rows.len().saturating_sub(1), longest.saturating_sub(1)]
    }

    /// The value at a point.
    #[must_use]
    pub fn value_at(&self, [x, y]: [&Rational; 2]) -> Rational {
        let inner = |row: &Vec<Rational>| horner(row, y);
        self.rows.iter().rev().fold(Rational::zero(), |value, row| value * x + inner(row))
    }

    /// The coefficients C_{k,l}, k ≤ d, l ≤ e, with which this is Σ C_{k,l} b_k(s) b_l(t), where the point goes from one
    /// corner of a box to the other as s and t go from 0 to 1, and the b are the Bernstein polynomials of the degrees d
    /// and e. Since these are not negative and sum to 1, all values in the box are between the least and the greatest
    /// coefficient.
    ///
    /// # Panics
    /// When d or e is less than the degree.
    ///
    /// ```
    /// use subcert::exact::{Polynomial, Rational};
    ///
    /// let p = Polynomial::variable("v").in_variables(["v", "w"]).expect("a polynomial");
    /// let ends = [-1, 0].map(Rational::from);
    /// let bernstein = p.bernstein([&ends, &ends], [1, 0]);
    /// assert_eq!(bernstein, [[Rational::from(-1)], [Rational::zero()]]);
    /// ```
    #[must_use]
    pub fn bernstein(&self, [x, y]: [&[Rational; 2]; 2], [d, e]: [usize; 2]) -> Vec<Vec<Rational>> {
        let along_y = self.rows.iter().map(|row| bernstein(row, y, e));
        let rows: Vec<Vec<Rational>> = along_y.collect();
        let column = |l: usize| rows.iter().map(|row| row[l].clone()).collect::<Vec<Rational>>();
        let columns: Vec<Vec<Rational>> = (0..=e).map(|l| bernstein(&column(l), x, d)).collect();
        (0..=d).map(|k| columns.iter().map(|column| column[k].clone()).collect()).collect()
    }

    /// The greatest i + j with c_{i,j} ≠ 0; 0 for 0.
    #[must_use]
    pub fn total_degree(&self) -> usize {
        let last = |(i, row): (usize, &Vec<Rational>)| {
            row.iter().rposition(|c| !c.is_zero()).map(|j| i + j)
        };
        self.rows.iter().enumerate().filter_map(last).max().unwrap_or(0)
    }

    /// \[a, b, c\] if this is ax + by + c and not constant.
    #[must_use]
    pub fn line(&self) -> Option<[Rational; 3]> {
        let coefficient = |i: usize, j: usize| {
            self.rows.get(i).and_then(|row| row.get(j)).cloned().unwrap_or_else(Rational::zero)
        };
        (self.total_degree() == 1)
            .then(|| [coefficient(1, 0), coefficient(0, 1), coefficient(0, 0)])
    }

    /// The coefficients C_{k,l}, k + l ≤ d, row by row, with which this is Σ C_{k,l} d!/(k! l! (d−k−l)!) s^k t^l (1−s−t)^{d−k−l} at the point
    /// A + s(B − A) + t(C − A) of a triangle with the corners A, B, C. These Bernstein polynomials are not negative there, and sum to 1.
    ///
    /// # Panics
    /// When d is less than the total degree.
    ///
    /// ```
    /// use subcert::exact::{Polynomial, Rational};
    ///
    /// let p = Polynomial::variable("v").in_variables(["v", "w"]).expect("a polynomial");
    /// let corners = [[2, 0], [3, 1], [5, 0]].map(|corner| corner.map(Rational::from));
    /// assert_eq!(p.on_triangle(&corners, 1), [2, 5, 3].map(Rational::from));
    /// ```
    #[must_use]
    pub fn on_triangle(&self, corners: &[[Rational; 2]; 3], degree: usize) -> Vec<Rational> {
        assert!(self.total_degree() <= degree, "a degree of at least that of the polynomial");
        let [a, b, c] = corners;
        let line = |i: usize| {
            BivariatePolynomial::new(vec![vec![a[i].clone(), &c[i] - &a[i]], vec![&b[i] - &a[i]]])
        };
        let [x, y] = [line(0), line(1)];
        let value = |row: &Vec<Rational>| {
            row.iter()
                .rev()
                .fold(Self::zero(), |sum, c| sum.times(&y).plus(&Self::from_rational(c)))
        };
        let rows = self.rows.iter().rev();
        let moved = rows.fold(Self::zero(), |sum, row| sum.times(&x).plus(&value(row)));
        // s^i t^j = Σ (k)_i (l)_j/(d)_{i+j} B_{k,l}, with the falling factorials (k)_i = k(k−1)…(k−i+1).
        let falling = |top: usize, count: usize| {
            (0..count).fold(Rational::one(), |product, i| product * Rational::from(top - i))
        };
        let coefficient = |(k, l): (usize, usize)| {
            let mut sum = Rational::zero();
            for (i, row) in moved.rows.iter().enumerate().take(k + 1) {
                for (j, c) in row.iter().enumerate().take(l + 1) {
                    sum += &(c * falling(k, i) * falling(l, j) / falling(degree, i + j));
                }
            }
            sum
        };
        let places = (0..=degree).flat_map(|k| (0..=degree - k).map(move |l| (k, l)));
        places.map(coefficient).collect()
    }
}

fn horner(c: &[Rational], x: &Rational) -> Rational {
    c.iter().rev().fold(Rational::zero(), |value, c| value * x + c)
}

/// The Bernstein coefficients of Σ c_i x^i on an interval.
fn bernstein(c: &[Rational], [low, high]: &[Rational; 2], degree: usize) -> Vec<Rational> {
    assert!(c.len() <= degree + 1, "a degree of at least that of the polynomial");
    // In t, where x = low + (high − low)t: Horner's rule, and the weights of 1, t, t², ….
    let width = high - low;
    let mut moved: Vec<Rational> = Vec::with_capacity(c.len());
    for c in c.iter().rev() {
        let above: Vec<Rational> = moved.iter().map(|m| m * &width).collect();
        for m in &mut moved {
            *m *= low;
        }
        moved.push(Rational::zero());
        for (m, a) in moved[1..].iter_mut().zip(&above) {
            *m += a;
        }
        moved[0] += c;
    }
    let choose = |top: usize, bottom: usize| {
        let small = |x| u32::try_from(x).expect("a low degree");
        Integer::binomial(small(top), small(bottom))
    };
    let weight = |k: usize, i: usize| Rational::new(choose(k, i), choose(degree, i));
    let sum = |k: usize| moved.iter().enumerate().take(k + 1).map(|(i, m)| m * weight(k, i)).sum();
    (0..=degree).map(sum).collect()
}

impl From<&RationalPolynomial> for BivariatePolynomial {
    /// The polynomial in x.
    fn from(polynomial: &RationalPolynomial) -> BivariatePolynomial {
        BivariatePolynomial::new(polynomial.coefficients().into_iter().map(|c| vec![c]).collect())
    }
}

impl Scalar for BivariatePolynomial {
    fn from_rational(value: &Rational) -> Self {
        BivariatePolynomial::new(vec![vec![value.clone()]])
    }
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.rows.clone();
        sum.resize(sum.len().max(other.rows.len()), Vec::new());
        for (row, others) in sum.iter_mut().zip(&other.rows) {
            row.resize(row.len().max(others.len()), Rational::zero());
            row.iter_mut().zip(others).for_each(|(x, y)| *x += y);
        }
        BivariatePolynomial::new(sum)
    }
    fn minus(&self, other: &Self) -> Self {
        let negative = other.rows.iter().map(|row| row.iter().map(|c| -c).collect()).collect();
        self.plus(&BivariatePolynomial { rows: negative })
    }
    fn times(&self, other: &Self) -> Self {
        let ([a, b], [c, d]) = (self.degrees(), other.degrees());
        let mut product = vec![vec![Rational::zero(); b + d + 1]; a + c + 1];
        for (i, row) in self.rows.iter().enumerate() {
            for (k, others) in other.rows.iter().enumerate() {
                for (j, x) in row.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
                    for (l, y) in others.iter().enumerate() {
                        product[i + k][j + l] += &(x * y);
                    }
                }
            }
        }
        BivariatePolynomial::new(product)
    }
}

impl Polynomial {
    /// Whether this variable occurs.
    #[must_use]
    pub fn has(&self, variable: &str) -> bool {
        let is_here = |(name, _): &(std::sync::Arc<str>, u32)| **name == *variable;
        self.other_terms().iter().any(|(monomial, _)| monomial.powers().iter().any(is_here))
    }

    /// This as a polynomial in two variables over the rationals; `None` when a third variable or an irrational
    /// coefficient occurs.
    #[must_use]
    pub fn in_variables(&self, variables: [&str; 2]) -> Option<BivariatePolynomial> {
        let constant = self.constant_term().as_rational()?;
        let mut rows = vec![vec![constant.clone()]];
        for (monomial, coefficient) in self.other_terms() {
            let mut place = [0; 2];
            for (name, exponent) in monomial.powers() {
                let which = variables.iter().position(|variable| **variable == **name)?;
                place[which] = usize::try_from(*exponent).ok()?;
            }
            let [i, j] = place;
            rows.resize(rows.len().max(i + 1), Vec::new());
            let length = rows[i].len().max(j + 1);
            rows[i].resize(length, Rational::zero());
            rows[i][j] = coefficient.as_rational()?.clone();
        }
        Some(BivariatePolynomial::new(rows))
    }
}
