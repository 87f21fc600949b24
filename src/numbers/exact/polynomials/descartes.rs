//! Isolating intervals of real roots by Descartes' rule of signs.

use super::sturm::changes;
use crate::exact::{Integer, IntegerPolynomial};

/// A place in the interval [0, 1] that holds one root of a polynomial in it.
pub(crate) enum Place {
    /// The root is numerator/2^level.
    Point { numerator: Integer, level: u32 },
    /// The root is in the open interval from numerator/2^level to (numerator + 1)/2^level.
    Between {
        numerator: Integer,
        level: u32,
        /// The sign of the polynomial just to the right of the lower end.
        sign: i8,
        /// Whether an end of the interval is another root.
        touches: bool,
    },
}

/// An interval of the search: [numerator, numerator + 1]/2^level.
struct Part {
    numerator: Integer,
    level: u32,
    /// b_0, …, b_d with f = Σ b_i C(d, i) t^i (1 − t)^(d−i) for t from 0 to 1 on the interval, up to one positive
    /// factor.
    bernstein: Vec<Integer>,
}

enum Task {
    Search(Part),
    Found(Place),
}

/// The places of the roots of f in the open interval (0, 1), in increasing order. f is given by c_0, …, c_d with c_d ≠ 0,
/// and is square-free.
///
/// The number of sign changes in b_0, …, b_d is at least the number of roots in the open interval, of the same parity,
/// so that 0 and 1 settle an interval. Others are halved, by de Casteljau's algorithm. A short interval is
/// settled, as f is square-free (Vincent; Obreshkoff's theorem of two circles).
pub(crate) fn isolated(coefficients: &[Integer]) -> Vec<Place> {
    let start = Part { numerator: Integer::zero(), level: 0, bernstein: bernstein(coefficients) };
    let (mut tasks, mut found) = (vec![Task::Search(start)], Vec::new());
    while let Some(task) = tasks.pop() {
        let part = match task {
            Task::Search(part) => part,
            Task::Found(place) => {
                found.push(place);
                continue;
            }
        };
        let signs = || part.bernstein.iter().map(Integer::sign);
        let changes = changes(signs());
        if changes == 1 {
            let sign = signs().find(|&sign| sign != 0).unwrap_or(0);
            let touches = [part.bernstein.first(), part.bernstein.last()]
                .iter()
                .any(|end| end.is_some_and(Integer::is_zero));
            let (numerator, level) = (part.numerator, part.level);
            found.push(Place::Between { numerator, level, sign, touches });
        } else if changes > 1 {
            let [left, right] = part.halves();
            let middle = right.bernstein[0]
                .is_zero()
                .then(|| Place::Point { numerator: right.numerator.clone(), level: right.level });
            // What is on top of the stack is taken first.
            tasks.push(Task::Search(right));
            tasks.extend(middle.map(Task::Found));
            tasks.push(Task::Search(left));
        }
    }
    found
}

impl Part {
    fn halves(self) -> [Part; 2] {
        let mut right = self.bernstein;
        let degree = right.len() - 1;
        // After r steps, the entry i is 2^r times the one of de Casteljau's scheme.
        let mut left = vec![right[0].clone()];
        for r in 1..=degree {
            for i in 0..=degree - r {
                let (low, high) = right.split_at_mut(i + 1);
                low[i] += &high[0];
            }
            left.push(right[0].clone());
        }
        // The entries of both halves, times 2^d.
        left.iter_mut().rev().zip(0..).for_each(|(b, places)| *b = b.shifted_left(places));
        right.iter_mut().zip(0..).for_each(|(b, places)| *b = b.shifted_left(places));
        let numerator = self.numerator.shifted_left(1);
        let next = &numerator + Integer::one();
        [(numerator, left), (next, right)].map(|(numerator, bernstein)| Part {
            numerator,
            level: self.level + 1,
            bernstein: reduced(bernstein),
        })
    }
}

/// The numbers without their common power of 2.
fn reduced(mut numbers: Vec<Integer>) -> Vec<Integer> {
    let zeros = numbers.iter().filter_map(Integer::trailing_zeros).min();
    if let Some(zeros) = zeros.filter(|zeros| *zeros > 0) {
        for number in &mut numbers {
            *number = number.shifted_right(zeros);
        }
    }
    numbers
}

/// The Bernstein coefficients on [0, 1], times the least common multiple of the C(d, j): b_i = Σ_{j≤i} C(i, j)
/// c_j/C(d, j).
pub(crate) fn bernstein(coefficients: &[Integer]) -> Vec<Integer> {
    let degree = u32::try_from(coefficients.len() - 1).expect("a degree that fits in memory");
    let binomials: Vec<Integer> = (0..=degree).map(|j| Integer::binomial(degree, j)).collect();
    let common = binomials.iter().fold(Integer::one(), |common, binomial| common.lcm(binomial));
    let scaled = coefficients.iter().zip(&binomials).map(|(c, b)| c * common.div_exact(b));
    let mut sums: Vec<Integer> = scaled.collect();
    for done in 1..sums.len() {
        for i in (done..sums.len()).rev() {
            let (low, high) = sums.split_at_mut(i);
            high[0] += &low[i - 1];
        }
    }
    reduced(sums)
}

impl IntegerPolynomial {
    /// The coefficients of f(low + (high − low)x), times a positive number, for low and high over one denominator.
    pub(crate) fn on(&self, low: &Integer, high: &Integer, denominator: &Integer) -> Vec<Integer> {
        let degree = self.coefficients().len().saturating_sub(1);
        let mut shifted = self.coefficients().to_vec();
        let mut scale = Integer::one();
        for c in shifted.iter_mut().rev().skip(1) {
            scale *= denominator;
            *c *= &scale;
        }
        if !low.is_zero() {
            for done in 0..degree {
                for i in (done..degree).rev() {
                    let next = &shifted[i + 1] * low;
                    shifted[i] += &next;
                }
            }
        }
        let (length, mut scale) = (high - low, Integer::one());
        for c in shifted.iter_mut().skip(1) {
            scale *= &length;
            *c *= &scale;
        }
        shifted
    }
}
