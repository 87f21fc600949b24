//! Masks whose smoothness is known in a naive way, and certificates of radii that are easily written.

use super::floats::{eigenvalue, radius_from_below};
use super::mutator::Random;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A rational number.
pub type Q = BigRational;

/// An integer as a fraction.
pub fn int(x: i64) -> Q {
    Q::from_integer(BigInt::from(x))
}

/// The nearest float.
pub fn float(x: &Q) -> f64 {
    x.to_f64().unwrap_or(f64::NAN)
}

/// A mask by its symbol.
#[derive(Clone)]
pub struct Mask {
    /// The number of rules.
    pub n: usize,
    /// The coefficients of the symbol, from the constant one upwards.
    pub symbol: Vec<Q>,
    /// The greatest K such that σ^K divides the symbol.
    pub order: usize,
    /// The Hölder exponent of the limits is between these numbers. Where the lower one is positive, the
    /// scheme converges.
    pub exponent: [f64; 2],
}

/// The product of two polynomials.
pub fn times(p: &[Q], q: &[Q]) -> Vec<Q> {
    let mut product = vec![Q::zero(); p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// p/σ, if σ(z) = 1 + z + … + z^{n−1} divides p.
fn over_sigma(p: &[Q], n: usize) -> Option<Vec<Q>> {
    let mut rest = p.to_vec();
    let mut quotient = Vec::new();
    for i in 0..(p.len() + 1).checked_sub(n)? {
        let c = rest[i].clone();
        rest[i..i + n].iter_mut().for_each(|x| *x -= &c);
        quotient.push(c);
    }
    rest.iter().all(Q::is_zero).then_some(quotient).filter(|quotient| !quotient.is_empty())
}

impl Mask {
    /// The mask of a symbol, with what the norms and traces of products of a few factors say.
    pub fn new(n: usize, symbol: Vec<Q>) -> Mask {
        let mut mask = Mask { n, symbol, order: 0, exponent: [0.0; 2] };
        while mask.difference(mask.order + 1).is_some() {
            mask.order += 1;
        }
        mask.exponent = mask.bounds();
        if mask.exponent[0] < 0.05 || !mask.is_independent() {
            // Then it may be that some factor has no part in the limits; but a scheme that does not
            // contract does not converge.
            mask.exponent[1] =
                if mask.exponent[1] < 0.0 { mask.exponent[1] } else { f64::INFINITY };
        }
        mask
    }

    /// n^K A/σ^K.
    pub fn difference(&self, order: usize) -> Option<Vec<Q>> {
        let whole = int(self.n.try_into().unwrap_or(2));
        (0..order).try_fold(self.symbol.clone(), |p, _| {
            Some(over_sigma(&p, self.n)?.iter().map(|c| c * &whole).collect())
        })
    }

    /// Bounds of the exponent where the shifts are independent: K − log_n ϱ, ϱ by norms of powers from
    /// above, and by traces of products of the matrices from below.
    fn bounds(&self) -> [f64; 2] {
        let b = self.difference(self.order).expect("the sum rules");
        let symbol: Vec<f64> = b.iter().map(float).collect();
        let (n, levels) = (self.n, if self.n == 2 { 9 } else { 6 });
        let mut product = vec![1.0];
        let mut stretch = 1;
        let mut above = f64::INFINITY;
        for l in 1..=levels {
            let mut next = vec![0.0; product.len() + (symbol.len() - 1) * stretch];
            for (i, x) in product.iter().enumerate() {
                for (j, y) in symbol.iter().enumerate() {
                    next[i + j * stretch] += x * y;
                }
            }
            (product, stretch) = (next, stretch * n);
            let class = |class: usize| {
                product.iter().skip(class).step_by(stretch).copied().map(f64::abs).sum()
            };
            let norm = (0..stretch).map(class).fold(0.0, f64::max);
            above = above.min(norm.powf(1.0 / f64::from(l)));
        }
        let matrices: Vec<Vec<Vec<f64>>> = (self.matrices(self.order).iter())
            .map(|m| m.iter().map(|row| row.iter().map(float).collect()).collect())
            .collect();
        let below = radius_from_below(&matrices, if n == 2 { 6 } else { 4 });
        let base = (n as f64).ln();
        [above, below].map(|radius| self.order as f64 - radius.ln() / base)
    }

    /// Whether the shifts of the limit function are independent on [0, 1], by its values.
    fn is_independent(&self) -> bool {
        let symbol: Vec<f64> = self.symbol.iter().map(float).collect();
        let first = symbol.iter().position(|x| *x != 0.0).unwrap_or(0);
        let last = symbol.iter().rposition(|x| *x != 0.0).unwrap_or(0);
        let symbol = &symbol[first..=last];
        let mut values = vec![1.0];
        let mut samples = 1;
        while samples < 200 {
            let mut next = vec![0.0; (values.len() - 1) * self.n + symbol.len()];
            for (i, x) in values.iter().enumerate() {
                for (j, y) in symbol.iter().enumerate() {
                    next[i * self.n + j] += x * y;
                }
            }
            (values, samples) = (next, samples * self.n);
        }
        let shifts = (symbol.len() - 1).div_ceil(self.n - 1);
        let at = |place: usize| values.get(place).copied().unwrap_or(0.0);
        let mut rows: Vec<Vec<f64>> =
            (0..samples).map(|s| (0..shifts).map(|j| at(s + j * samples)).collect()).collect();
        for step in 0..shifts {
            let size = |row: &Vec<f64>| row[step].abs();
            let pivot =
                (step..rows.len()).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])));
            let Some(pivot) = pivot.filter(|pivot| size(&rows[*pivot]) > 1e-7) else {
                return false;
            };
            rows.swap(step, pivot);
            let top = rows[step].clone();
            for row in &mut rows[step + 1..] {
                let factor = row[step] / top[step];
                row.iter_mut().zip(&top).for_each(|(x, t)| *x -= factor * t);
            }
        }
        true
    }

    /// The matrices of the differences of order K, as proofs/format/radius.md says.
    pub fn matrices(&self, order: usize) -> Vec<Vec<Vec<Q>>> {
        let b = self.difference(order).expect("the sum rules");
        let first = b.iter().position(|x| !x.is_zero()).unwrap_or(0);
        let last = b.iter().rposition(|x| !x.is_zero()).unwrap_or(0);
        let (b, n) = (&b[first..=last], self.n);
        let degree = b.len() - 1;
        let width = if degree == 0 { 1 } else { (degree - 1).div_ceil(n - 1) + 1 };
        let entry = |e: usize, i: usize, j: usize| {
            let place = (degree + 1 + e + i).checked_sub(n * (j + 1));
            place.and_then(|place| b.get(place)).cloned().unwrap_or_default()
        };
        let matrix = |e| (0..width).map(|i| (0..width).map(|j| entry(e, i, j)).collect()).collect();
        (0..n).map(matrix).collect()
    }

    /// `mask = [['1/2', …], …]`.
    pub fn toml(&self) -> String {
        let width = self.symbol.len().div_ceil(self.n);
        let entry = |alpha: usize, j: usize| {
            let a = self.symbol.get(self.n * (width - 1 - j) + alpha).cloned().unwrap_or_default();
            format!("'{a}'")
        };
        let rule = |alpha| (0..width).map(|j| entry(alpha, j)).collect::<Vec<_>>().join(", ");
        let rules: Vec<String> = (0..self.n).map(|alpha| format!("[{}]", rule(alpha))).collect();
        format!("mask = [{}]", rules.join(", "))
    }

    /// The lines from `order` to `end` for the differences of order K: an upper bound by the norm of
    /// the matrices, a lower one that may be wrong, and what may follow.
    pub fn radius(&self, random: &mut Random, order: usize) -> Vec<String> {
        let matrices = self.matrices(order);
        let norm = norm(&matrices);
        let mut lines = vec![format!("order {order}")];
        if !random.once_in(5) {
            let count = 1 + random.below(2);
            let factors: Vec<usize> = (0..count).map(|_| random.below(self.n)).collect();
            let words: Vec<String> = factors.iter().map(usize::to_string).collect();
            lines.push(format!("product {}", words.join(" ")));
            let n = int(self.n.try_into().unwrap_or(2));
            let power = random.below(order + 2);
            let q = match random.below(8) {
                0 => (0..power).fold(Q::one(), |q, _| q * &n),
                1 => factors.iter().fold(Q::one(), |q, _| q * &norm),
                2 => diagonal(&matrices, &factors, random),
                _ => eigenvalue(&matrices, &factors),
            };
            let kind = if q.is_negative() { "negative" } else { "positive" };
            lines.push(format!("eigenvalue {kind} {}", q.abs()));
        }
        lines.extend(trivial_hull(&norm, matrices[0].len() * self.n));
        let n = self.n as f64;
        let most =
            (0..order).rev().find(|m| float(&norm) < n.powi((order - m).try_into().unwrap_or(0)));
        if let Some(most) = most {
            lines.push(format!("continuous {}", most.saturating_sub(random.below(4) / 3)));
        }
        if !random.once_in(3) {
            lines.push(format!("not-continuous {}", random.below(order + 2)));
        }
        lines.push("end".to_owned());
        lines
    }
}

/// The largest sum of a row.
pub fn norm(matrices: &[Vec<Vec<Q>>]) -> Q {
    let sum = |row: &Vec<Q>| row.iter().map(Q::abs).sum::<Q>();
    matrices.iter().flatten().map(sum).max().unwrap_or_default()
}

/// The lines of the upper bound by the norm.
pub fn trivial_hull(norm: &Q, images: usize) -> Vec<String> {
    let lines = [format!("at-most {norm}"), "unit 1".to_owned()];
    lines.into_iter().chain(vec!["image".to_owned(); images]).collect()
}

/// An entry of the diagonal of a product.
pub fn diagonal(matrices: &[Vec<Vec<Q>>], factors: &[usize], random: &mut Random) -> Q {
    let size = matrices[0].len();
    let at = random.below(size);
    let mut row: Vec<Q> = (0..size).map(|j| if j == at { Q::one() } else { Q::zero() }).collect();
    for factor in factors {
        let matrix = &matrices[*factor];
        row = (0..size).map(|j| (0..size).map(|i| &row[i] * &matrix[i][j]).sum()).collect();
    }
    if row[at].is_zero() { Q::one() } else { row[at].clone() }
}

/// σ^K b, scaled to the sum n: a random mask of up to `most` sum rules.
pub fn random_mask(random: &mut Random, most: usize) -> Mask {
    let n = if random.once_in(4) { 3 } else { 2 };
    let order = 1 + random.below(most);
    loop {
        let length = 1 + random.below(3);
        let mut b: Vec<Q> = (0..length).map(|_| int(random.within(-3, 5))).collect();
        if random.once_in(4) && n == 2 {
            // c(z²)/c(z): shifts of the limit function that depend on each other.
            b = vec![int(1), int(-1), int(1)];
        }
        let sum: Q = b.iter().sum();
        if b.iter().any(Q::is_zero) && length < 3 || sum.is_zero() {
            continue;
        }
        return Mask::new(n, spline_times(n, order, &b));
    }
}

/// σ^K b, scaled to the sum n.
pub fn spline_times(n: usize, order: usize, b: &[Q]) -> Vec<Q> {
    let sigma = vec![Q::one(); n];
    let p = (0..order).fold(b.to_vec(), |p, _| times(&p, &sigma));
    let sum: Q = p.iter().sum();
    let scale = int(n.try_into().unwrap_or(2)) / sum;
    p.iter().map(|c| c * &scale).collect()
}
