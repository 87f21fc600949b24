//! Facts of a mask by definition, in slow ways that share nothing with the program but numbers and the coefficients.

use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::scheme::Mask;

/// n, the least index s, and a_s with x'_r = Σ_k a_{r−nk} x_k.
pub struct Plain {
    pub n: i64,
    pub first: i64,
    pub a: Vec<Rational>,
}

fn int(n: usize) -> i64 {
    i64::try_from(n).expect("a small number")
}

fn index(n: i64) -> usize {
    usize::try_from(n).expect("not negative")
}

impl Plain {
    /// x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}: s = α − n(o + j).
    pub fn of(mask: &Mask) -> Plain {
        let n = int(mask.arity());
        let mut terms = Vec::new();
        for (alpha, row) in mask.rules().rows().iter().enumerate() {
            for (j, entry) in row.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
                terms.push((int(alpha) - n * (mask.offset() + int(j)), entry.clone()));
            }
        }
        let first = terms.iter().map(|(s, _)| *s).min().expect("a coefficient");
        let last = terms.iter().map(|(s, _)| *s).max().expect("a coefficient");
        let mut a = vec![Rational::zero(); index(last - first + 1)];
        for (s, entry) in terms {
            a[index(s - first)] += &entry;
        }
        Plain { n, first, a }
    }

    /// The sequence that n-adic refinement makes of one, from the index `first` on.
    fn refined(&self, (first, x): &(i64, Vec<Rational>)) -> (i64, Vec<Rational>) {
        let length = index(self.n) * (x.len() - 1) + self.a.len();
        let mut y = vec![Rational::zero(); length];
        for (k, value) in x.iter().enumerate().filter(|(_, value)| !value.is_zero()) {
            for (s, a) in self.a.iter().enumerate() {
                y[index(self.n) * k + s] += &(a * value);
            }
        }
        (self.n * first + self.first, y)
    }

    /// What `levels` refinements make of x_0 = 1 and all other points 0.
    pub fn of_one_point(&self, levels: u32) -> (i64, Vec<Rational>) {
        (0..levels).fold((0, vec![Rational::one()]), |x, _| self.refined(&x))
    }

    /// The greatest K such that for each j < K the sums Σ_k a_{e+nk} (e + nk)^j are the same for all e.
    pub fn sum_rules(&self) -> usize {
        let holds = |j: &usize| {
            let power = i32::try_from(*j).expect("a small power");
            let sum = |e: i64| {
                let terms = (self.first..).zip(&self.a).filter(|(s, _)| s.rem_euclid(self.n) == e);
                terms.map(|(s, a)| a * &Rational::from(s).pow(power)).sum::<Rational>()
            };
            (1..self.n).all(|e| sum(e) == sum(0))
        };
        (0..=self.a.len()).take_while(holds).count()
    }

    /// Λ_c: the greatest Σ_m |h_{e+n^c m}| of what becomes of one point.
    pub fn norm(&self, c: u32) -> Rational {
        greatest(&self.of_one_point(c).1, self.n.pow(c))
    }

    /// T_c: the same of the differences of what becomes of a step, written out on a finite piece.
    pub fn contraction(&self, c: u32) -> Rational {
        // The step from 0 to 1 between the points −1 and 0 is continued far enough that its end does not matter.
        let length = self.a.len() + 2;
        let (_, y) = (0..c).fold((0, vec![Rational::one(); length]), |x, _| self.refined(&x));
        let near = self.of_one_point(c).1.len();
        let before = std::iter::once(Rational::zero()).chain(y.iter().cloned());
        let differences: Vec<Rational> =
            y.iter().zip(before).map(|(y, before)| y - &before).take(near).collect();
        greatest(&differences, self.n.pow(c))
    }

    /// b with A = σ^K B, times n^K.
    fn scaled(&self, k: usize) -> Plain {
        let mut rest = self.a.clone();
        for _ in 0..k {
            // Division by 1 + z + … + z^{n−1}, from the lowest power on.
            let length = rest.len() - index(self.n - 1);
            let mut quotient: Vec<Rational> = Vec::new();
            for (i, value) in rest.iter().enumerate().take(length) {
                let from = (i + 1).saturating_sub(index(self.n));
                let known: Rational = quotient[from..].iter().sum();
                quotient.push(value - &known);
            }
            rest = quotient;
        }
        let factor = Rational::from(self.n).pow(i32::try_from(k).expect("small"));
        let a = rest.iter().map(|b| b * &factor).collect();
        Plain { n: self.n, first: 0, a }
    }

    /// Numbers below and above the joint spectral radius of the differences of order K, times n^K, in f64: by traces of
    /// powers of products, and by the norm of the c-th power.
    pub fn radius(&self, k: usize, factors: u32) -> [f64; 2] {
        let scaled = self.scaled(k);
        let b: Vec<f64> = scaled.a.iter().map(nearest).collect();
        let size = (b.len() - 1).div_ceil(index(self.n - 1)).max(1);
        let matrix = |e: usize| -> Vec<Vec<f64>> {
            let entry = |i: usize, j: usize| {
                let s = e + index(self.n) * i;
                s.checked_sub(j).and_then(|s| b.get(s)).copied().unwrap_or(0.0)
            };
            (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
        };
        let matrices: Vec<_> = (0..index(self.n)).map(matrix).collect();
        let mut products = matrices.clone();
        let mut low = 0.0_f64;
        for length in 1..=factors {
            if length > 1 {
                products = products
                    .iter()
                    .flat_map(|left| matrices.iter().map(|right| times(left, right)))
                    .collect();
            }
            for product in &products {
                low = low.max(by_traces(product).powf(1.0 / f64::from(length)));
            }
        }
        let norm = nearest(&scaled.norm(factors));
        [low, norm.powf(1.0 / f64::from(factors))]
    }
}

fn times(left: &[Vec<f64>], right: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let entry = |row: &Vec<f64>, j: usize| row.iter().zip(right).map(|(x, y)| x * y[j]).sum();
    left.iter().map(|row| (0..right.len()).map(|j| entry(row, j)).collect()).collect()
}

/// max_m (|tr P^m|/d)^{1/m} for m = 1, 2, 4, 8, 16: not above the spectral radius. Higher powers leave the range of f64.
fn by_traces(product: &[Vec<f64>]) -> f64 {
    let (mut power, mut m, mut best) = (product.to_vec(), 1.0, 0.0_f64);
    let size = f64::from(u32::try_from(product.len()).expect("small"));
    while m <= 16.0 {
        let trace: f64 = power.iter().enumerate().map(|(i, row)| row[i]).sum();
        best = best.max((trace.abs() / size).powf(1.0 / m));
        power = times(&power, &power);
        m *= 2.0;
    }
    best
}

fn greatest(values: &[Rational], step: i64) -> Rational {
    let sum = |e: usize| values.iter().skip(e).step_by(index(step)).map(Rational::abs).sum();
    let sums = (0..index(step)).map(sum);
    sums.max().expect("a class")
}
