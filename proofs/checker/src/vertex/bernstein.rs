//! Polynomials on a square or a triangle by their coefficients in Bernstein form.

use super::ball::Ball;
use crate::numbers::{Q, count, int};
use num_traits::Pow;

/// The coefficients x_{i,j} of Σ x_{i,j} C(d,i)u^i(1−u)^{d−i} C(d,j)v^j(1−v)^{d−j}; or, on a triangle, for i + j ≤ d, of
/// Σ x_{i,j} d!/(i!j!(d−i−j)!) u^i v^j (1−u−v)^{d−i−j}.
#[derive(Clone, Debug)]
pub struct Form {
    /// Whether it is a polynomial on a triangle.
    pub triangle: bool,
    /// The coefficients.
    pub rows: Vec<Vec<Ball>>,
}

fn choose(n: usize, k: usize) -> Q {
    (0..k).fold(int(1), |product, i| product * count(n - i) / count(i + 1))
}

/// C(d,i)u^i(1−u)^{d−i}.
fn on_line(d: usize, i: usize, u: &Q) -> Q {
    choose(d, i) * Pow::pow(u, i) * Pow::pow(&(int(1) - u), d - i)
}

/// d!/(i!j!(d−i−j)!) u^i v^j (1−u−v)^{d−i−j}.
pub fn on_triangle(d: usize, (i, j): (usize, usize), u: &Q, v: &Q) -> Q {
    let rest = Pow::pow(&(int(1) - u - v), d - i - j);
    choose(d, i) * choose(d - i, j) * Pow::pow(u, i) * Pow::pow(v, j) * rest
}

/// The columns of rows, which may be shorter one after the other.
fn columns<T: Clone>(rows: &[Vec<T>]) -> Vec<Vec<T>> {
    let count = rows.first().map_or(0, Vec::len);
    let column = |j: usize| rows.iter().filter_map(|row| row.get(j).cloned()).collect();
    (0..count).map(column).collect()
}

/// The coefficients on a half. A square is cut at u = 1/2, and u and v are exchanged then. A triangle with the corners A, B, C at
/// (0, 0), (1, 0), (0, 1) is cut from C to the middle M of AB; the halves have the corners C, A, M and C, B, M. The coefficient m
/// of a row comes from m means.
pub fn halved<T: Clone>(
    rows: &[Vec<T>],
    triangle: bool,
    second: bool,
    mean: impl Fn(&T, &T) -> T,
) -> Vec<Vec<T>> {
    // The columns: polynomials in u of degree d − j, or d.
    let columns = columns(rows).into_iter().map(|mut line| {
        let mut kept = Vec::new();
        while let (Some(first), Some(last)) = (line.first(), line.last()) {
            kept.push(if second { last.clone() } else { first.clone() });
            line = line.windows(2).map(|pair| mean(&pair[0], &pair[1])).collect();
        }
        if second && !triangle {
            kept.reverse();
        }
        kept
    });
    let columns: Vec<Vec<T>> = columns.collect();
    if !triangle {
        return columns;
    }
    // In column j, the entry m has the powers j at C, m at M and d − j − m at the other end.
    let d = rows.len() - 1;
    let row = |end: usize| (0..=d - end).map(|m| columns[d - end - m][m].clone()).collect();
    (0..=d).map(row).collect()
}

impl Form {
    /// The degree in u and in v; that of v where both differ comes last.
    fn degrees(&self) -> (usize, usize) {
        (self.rows.len() - 1, self.rows.first().map_or(1, Vec::len) - 1)
    }

    fn binomial(&self, i: usize, j: usize) -> Q {
        let (d, e) = self.degrees();
        choose(d, i) * choose(if self.triangle { d - i } else { e }, j)
    }

    fn map(&self, entry: impl Fn(usize, usize) -> Ball) -> Form {
        let row = |(i, row): (usize, &Vec<Ball>)| (0..row.len()).map(|j| entry(i, j)).collect();
        Form { triangle: self.triangle, rows: self.rows.iter().enumerate().map(row).collect() }
    }

    /// The derivative along u.
    pub fn along_u(&self) -> Form {
        let d = self.rows.len() - 1;
        let factor = Ball::from(i64::try_from(d).unwrap_or(1));
        let row = |i: usize| {
            let pairs = self.rows[i + 1].iter().zip(&self.rows[i]);
            pairs.map(|(next, this)| next.minus(this).times(&factor)).collect()
        };
        Form { triangle: self.triangle, rows: (0..d).map(row).collect() }
    }

    /// u and v exchanged.
    pub fn exchanged(&self) -> Form {
        Form { triangle: self.triangle, rows: columns(&self.rows) }
    }

    /// The product.
    pub fn times(&self, other: &Form) -> Form {
        let ((d, e), (f, g)) = (self.degrees(), other.degrees());
        let length = |i: usize| if self.triangle { d + f - i + 1 } else { e + g + 1 };
        let rows = (0..=d + f).map(|i| vec![Ball::from(0); length(i)]).collect();
        let mut sum = Form { triangle: self.triangle, rows };
        for (i, row) in self.rows.iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                for (k, others) in other.rows.iter().enumerate() {
                    for (l, y) in others.iter().enumerate() {
                        let weight = self.binomial(i, j) * other.binomial(k, l);
                        let weight = Ball::from(&(weight / sum.binomial(i + k, j + l)));
                        let term = x.times(y).times(&weight);
                        sum.rows[i + k][j + l] = sum.rows[i + k][j + l].plus(&term);
                    }
                }
            }
        }
        sum
    }

    /// self − other.
    pub fn minus(&self, other: &Form) -> Form {
        self.map(|i, j| self.rows[i][j].minus(&other.rows[i][j]))
    }

    /// Times a number.
    pub fn scaled(&self, factor: &Ball) -> Form {
        self.map(|i, j| self.rows[i][j].times(factor))
    }

    /// A half.
    pub fn half(&self, second: bool) -> Form {
        let half = Ball::from(&(int(1) / int(2)));
        let mean = |a: &Ball, b: &Ball| a.plus(b).times(&half);
        Form { triangle: self.triangle, rows: halved(&self.rows, self.triangle, second, mean) }
    }

    /// The value at a place.
    pub fn at(&self, u: &Q, v: &Q) -> Ball {
        let (d, e) = self.degrees();
        let entries = self.rows.iter().enumerate().flat_map(|(i, row)| {
            row.iter().enumerate().map(move |(j, x)| {
                let rest = || on_triangle(d, (i, j), u, v);
                (x, if self.triangle { rest() } else { on_line(d, i, u) * on_line(e, j, v) })
            })
        });
        Ball::combined(entries)
    }
}
