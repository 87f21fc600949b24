//! Polynomials on a square or a triangle in Bernstein form.

use super::net::ratio;
use crate::exact::Scalar;

/// Σ x_{i,j} B_i(u)B_j(v) of degrees (d, e), or Σ x_{i,j} B_{i,j}(u, v) of total degree d = e, i + j ≤ d.
#[derive(Clone, Debug)]
pub(super) struct Form<R> {
    pub(super) triangle: bool,
    pub(super) degrees: (usize, usize),
    pub(super) rows: Vec<Vec<R>>,
}

fn binomial(n: usize, k: usize) -> i64 {
    (0..k).fold(1, |product, i| {
        let (top, below) = (i64::try_from(n - i), i64::try_from(i + 1));
        product * top.expect("a small degree") / below.expect("a small degree")
    })
}

impl<R: Scalar> Form<R> {
    /// The factor of u^i v^j (…) in the basis function (i, j).
    fn weight(&self, i: usize, j: usize) -> i64 {
        let (d, e) = self.degrees;
        let rest = if self.triangle { d - i } else { e };
        binomial(d, i) * binomial(rest, j)
    }

    /// All coefficients.
    pub(super) fn coefficients(&self) -> impl Iterator<Item = &R> {
        self.rows.iter().flatten()
    }

    /// The derivative along u.
    pub(super) fn along_u(&self) -> Form<R> {
        let (d, e) = self.degrees;
        let factor = ratio::<R>(i64::try_from(d).expect("a small degree"), 1);
        let row = |i: usize| {
            let pairs = self.rows[i + 1].iter().zip(&self.rows[i]);
            pairs.map(|(next, this)| next.minus(this).times(&factor)).collect()
        };
        let degrees = (d - 1, if self.triangle { d - 1 } else { e });
        Form { triangle: self.triangle, degrees, rows: (0..d).map(row).collect() }
    }

    /// u and v exchanged.
    pub(super) fn transposed(&self) -> Form<R> {
        let (d, e) = self.degrees;
        let column =
            |j: usize| self.rows.iter().filter_map(|row| row.get(j).cloned()).collect::<Vec<R>>();
        Form { triangle: self.triangle, degrees: (e, d), rows: (0..=e).map(column).collect() }
    }

    /// The derivative along v.
    pub(super) fn along_v(&self) -> Form<R> {
        self.transposed().along_u().transposed()
    }

    /// self·other.
    pub(super) fn times(&self, other: &Form<R>) -> Form<R> {
        let ((d, e), (f, g)) = (self.degrees, other.degrees);
        let length = |i: usize| if self.triangle { d + f - i + 1 } else { e + g + 1 };
        let rows = (0..=d + f).map(|i| vec![R::zero(); length(i)]).collect();
        let mut product = Form { triangle: self.triangle, degrees: (d + f, e + g), rows };
        for (i, row) in self.rows.iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                let x = x.times(&ratio(self.weight(i, j), 1));
                for (k, others) in other.rows.iter().enumerate() {
                    for (l, y) in others.iter().enumerate() {
                        let y = y.times(&ratio(other.weight(k, l), 1));
                        product.rows[i + k][j + l].accumulate(&x.times(&y));
                    }
                }
            }
        }
        for i in 0..product.rows.len() {
            for j in 0..product.rows[i].len() {
                let share = ratio(1, product.weight(i, j));
                product.rows[i][j] = product.rows[i][j].times(&share);
            }
        }
        product
    }

    /// self − other, of the same degrees.
    pub(super) fn minus(&self, other: &Form<R>) -> Form<R> {
        let rows = self.rows.iter().zip(&other.rows);
        let row = |(x, y): (&Vec<R>, &Vec<R>)| x.iter().zip(y).map(|(x, y)| x.minus(y)).collect();
        Form { triangle: self.triangle, degrees: self.degrees, rows: rows.map(row).collect() }
    }

    /// The value at (u, v), where `at` is u, v, w = 1 − u − v (of a triangle), and 1.
    pub(super) fn value(&self, at: &[&R; 4]) -> R {
        let [u, v, w, one] = at;
        let power = |x: &R, k: usize| (0..k).fold((*one).clone(), |product, _| product.times(x));
        let (d, e) = self.degrees;
        let mut sum = R::zero();
        for (i, row) in self.rows.iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                let rest = if self.triangle {
                    power(w, d - i - j)
                } else {
                    power(&one.minus(u), d - i).times(&power(&one.minus(v), e - j))
                };
                let basis = power(u, i).times(&power(v, j)).times(&rest);
                sum.accumulate(&basis.times(&ratio(self.weight(i, j), 1)).times(x));
            }
        }
        sum
    }

    /// The values at the corners: (0, 0), (1, 0), (0, 1), and for a square (1, 1).
    pub(super) fn corners(&self) -> Vec<&R> {
        let (d, e) = self.degrees;
        let mut corners = vec![&self.rows[0][0], &self.rows[d][0], &self.rows[0][e]];
        if !self.triangle {
            corners.push(&self.rows[d][e]);
        }
        corners
    }

    /// The halves at u < 1/2 and u > 1/2 of a square, each from 0 to 1 and with u and v exchanged. Of a
    /// triangle: the parts beside the line from (0, 1) to the midpoint of the opposite side, both with their
    /// corners in the order (0, 1), an end of that side, the midpoint.
    pub(super) fn halves(&self) -> [Form<R>; 2] {
        let half = ratio::<R>(1, 2);
        let columns = self.transposed().rows;
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for column in columns {
            let (mut rest, mut left, mut right) = (column, Vec::new(), Vec::new());
            while let (Some(first), Some(last)) = (rest.first(), rest.last()) {
                left.push(first.clone());
                right.push(last.clone());
                rest = rest.windows(2).map(|x| x[0].plus(&x[1]).times(&half)).collect();
            }
            low.push(left);
            high.push(right);
        }
        if !self.triangle {
            for column in &mut high {
                column.reverse();
            }
        }
        let (d, e) = self.degrees;
        [low, high].map(|columns| {
            let form = Form { triangle: self.triangle, degrees: (e, d), rows: columns };
            if self.triangle { form.turned() } else { form }
        })
    }

    /// A half of a triangle, given by its columns j: in column j stand the coefficients to the power j at
    /// (0, 1), from those at the end of the side to those at the midpoint. The origin becomes (0, 1), the
    /// corner u becomes the end, and v the midpoint: the next cut is through the midpoint.
    fn turned(&self) -> Form<R> {
        let d = self.degrees.0;
        // The power at the end is i, at the midpoint j, at (0, 1) d − i − j.
        let at = |i: usize, j: usize| self.rows[d - i - j][j].clone();
        let rows = (0..=d).map(|i| (0..=d - i).map(|j| at(i, j)).collect()).collect();
        Form { triangle: true, degrees: (d, d), rows }
    }
}
