//! Exponents, Riesz bounds and peaks of random masks, against floating-point numbers from refined data.

use crate::masks::relation_of;
use std::fmt::Write as _;
use subcert_check::Outcome;

/// Whether formulas have values between two bounds. Until then only exact values are compared.
const ENCLOSED: bool = true;

/// The numbers of a linear congruence.
struct Random(u64);

impl Random {
    fn below(&mut self, count: i64) -> i64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(self.0 >> 33).unwrap_or(0) % count
    }
}

/// A symbol σ^K·q, times a power of z, and its coefficients in floating point from the power l on.
struct Mask {
    n: i64,
    first: i64,
    order: u32,
    q: Vec<i64>,
    a: Vec<f64>,
    b: Vec<f64>,
}

fn product(p: &[f64], q: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; p.len() + q.len() - 1];
    for (i, x) in p.iter().enumerate() {
        for (j, y) in q.iter().enumerate() {
            sums[i + j] += x * y;
        }
    }
    sums
}

fn float(x: i64) -> f64 {
    f64::from(i32::try_from(x).unwrap_or(0))
}

impl Mask {
    fn new(n: i64, first: i64, order: u32, q: &[i64]) -> Mask {
        let total: i64 = q.iter().sum();
        let sigma = vec![1.0; usize::try_from(n).unwrap_or(2)];
        let factor = float(n).powi(1 - order.cast_signed()) / float(total);
        let b: Vec<f64> = q.iter().map(|c| float(*c) * factor).collect();
        let a = (0..order).fold(b.clone(), |a, _| product(&a, &sigma));
        Mask { n, first, order, q: q.to_vec(), a, b }
    }

    fn symbol(&self) -> String {
        let sigma = if self.n == 2 { "(1 + z)" } else { "(1 + z + z^2)" };
        let (total, mut q) = (self.q.iter().sum::<i64>(), String::new());
        for (k, c) in self.q.iter().enumerate() {
            let _ = write!(q, " + ({c})*z^{k}");
        }
        format!(
            "z^({})*{sigma}^{}*(0{q})*{}/({total}*{}^{})",
            self.first, self.order, self.n, self.n, self.order
        )
    }

    fn coefficient(&self, k: i64) -> f64 {
        let place = usize::try_from(k - self.first).ok();
        place.and_then(|place| self.a.get(place)).copied().unwrap_or(0.0)
    }

    /// The values at i/n^levels, from the integer `start` on.
    fn values(&self, levels: u32) -> (i64, Vec<f64>) {
        let last = self.first + i64::try_from(self.a.len()).unwrap_or(0) - 1;
        let (start, end) =
            (-(-self.first).div_euclid(self.n - 1) - 1, last.div_euclid(self.n - 1) + 1);
        // At the integers by iteration, and then φ(x) = Σ a_k φ(nx − k).
        let mut v = vec![0.0; usize::try_from(end - start + 1).unwrap_or(1)];
        let all = v.len();
        v.fill(1.0 / float(i64::try_from(all).unwrap_or(1)));
        let at = |v: &[f64], i: i64| {
            usize::try_from(i - start).ok().and_then(|i| v.get(i)).copied().unwrap_or(0.0)
        };
        for _ in 0..4000 {
            v = (start..=end)
                .map(|i| (start..=end).map(|j| self.coefficient(self.n * i - j) * at(&v, j)).sum())
                .collect();
        }
        let (mut scale, mut level) = (1_i64, v);
        for _ in 0..levels {
            let old = level.clone();
            let value = |i: i64| {
                // At the distance 1/scale: i − k·scale.
                (self.first..=last)
                    .map(|k| {
                        let place = i - (k + start) * scale;
                        let y = usize::try_from(place + start * scale - start * scale).ok();
                        self.coefficient(k) * y.and_then(|y| old.get(y)).copied().unwrap_or(0.0)
                    })
                    .sum::<f64>()
            };
            let finer = scale * self.n;
            level = (start * finer..=end * finer).map(value).collect();
            scale = finer;
        }
        (start, level)
    }

    /// log_n of the growth of f ↦ Σ_j nc_{nk−j}f_j.
    fn sobolev(&self) -> f64 {
        let length = i64::try_from(self.b.len()).unwrap_or(1);
        let at =
            |k: i64| usize::try_from(k).ok().and_then(|k| self.b.get(k)).copied().unwrap_or(0.0);
        let c = |k: i64| -> f64 { (0..length).map(|i| at(i + k) * at(i)).sum() };
        let scale = float(self.n).powi(2 * self.order.cast_signed() - 1);
        let j = length;
        let mut f = vec![1.0_f64; usize::try_from(2 * j + 1).unwrap_or(1)];
        let (mut logs, count) = (0.0, 3000);
        for round in 0..count {
            let next: Vec<f64> = (-j..=j)
                .map(|k| (-j..=j).zip(&f).map(|(l, x)| scale * c((self.n * k - l).abs()) * x).sum())
                .collect();
            let size = next.iter().map(|x: &f64| x.abs()).sum::<f64>();
            if round >= count / 2 {
                logs += size.ln();
            }
            f = next.iter().map(|x| x / size).collect();
        }
        let growth = logs / f64::from(count - count / 2);
        f64::from(self.order) - growth / float(self.n).ln() / 2.0
    }
}

/// Whether a value of a mask is between two numbers; `None` if it is not known.
fn between(mask: &Mask, formula: &str, [low, high]: [f64; 2]) -> Option<bool> {
    let schemes = format!("[[scheme]]\nname = 's'\nsymbol = '{}'\n", mask.symbol());
    let states = format!("{low:.9} ≤ {formula} ≤ {high:.9}");
    let fields = format!("scheme = 's'\nstates = '{states}'");
    match relation_of(&schemes, &fields, &format!("states {states}\n holds 2")) {
        Outcome::Valid => Some(true),
        Outcome::Incomplete(_) => None,
        _ => Some(false),
    }
}

/// Masks with small coefficients, among them some that are known from papers.
fn masks() -> Vec<Mask> {
    let mut all = vec![
        Mask::new(2, -3, 4, &[-1, 4, -1]),
        Mask::new(2, -5, 6, &[3, -18, 38, -18, 3]),
        Mask::new(2, 0, 2, &[3, -1]),
        Mask::new(2, -1, 1, &[2, -1, 2]),
        Mask::new(2, 4, 3, &[-1, 3]),
        Mask::new(3, -2, 2, &[-1, 3, -1]),
        Mask::new(3, -5, 3, &[-1, 3, 3, -1]),
        Mask::new(3, 0, 2, &[2, 2, -1]),
    ];
    let mut random = Random(7);
    for _ in 0..16 {
        let (n, order) = (2 + random.below(2), 1 + random.below(4));
        let length = 1 + random.below(4);
        let q: Vec<i64> = (0..length).map(|_| random.below(9) - 3).collect();
        let ends = q.first() != Some(&0) && q.last() != Some(&0);
        if ends && q.iter().sum::<i64>() > 1 {
            let order = u32::try_from(order).unwrap_or(1);
            all.push(Mask::new(n, random.below(7) - 5, order, &q));
        }
    }
    all
}

#[test]
fn exponents_of_sobolev() {
    let mut known = 0;
    for mask in masks() {
        let s = mask.sobolev();
        let found = between(&mask, "sobolev()", [s - 2e-3, s + 2e-3]);
        assert_ne!(found, Some(false), "{}: {s}", mask.symbol());
        known += usize::from(found.is_some());
    }
    assert!(!ENCLOSED || known > 12, "{known}");
}

#[test]
fn peaks_and_riesz_bounds() {
    let mut known = [0; 4];
    for mask in masks() {
        let levels = if mask.n == 2 { 11 } else { 7 };
        let (start, values) = mask.values(levels);
        let scale = usize::try_from(mask.n).unwrap_or(2).pow(levels);
        let shifts = values.len() / scale + 1;
        let at = |i: usize| values.get(i).copied().unwrap_or(0.0);
        let (mut overshoot, mut gibbs) = (1.0_f64, 1.0_f64);
        for x in 0..scale {
            overshoot = overshoot.max((0..shifts).map(|k| at(x + k * scale).max(0.0)).sum());
            let mut sum = 0.0;
            for k in 0..shifts {
                sum += at(x + k * scale);
                gibbs = gibbs.max(sum);
            }
        }
        let step = 1.0 / float(i64::try_from(scale).unwrap_or(1));
        let g: Vec<f64> = (0..shifts)
            .map(|k| values.iter().enumerate().map(|(i, x)| x * at(i + k * scale) * step).sum())
            .collect();
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for t in 0..2000_u32 {
            let xi = std::f64::consts::PI * f64::from(t) / 2000.0;
            let sum: f64 = g
                .iter()
                .zip(0_u32..)
                .map(|(g, k)| if k == 0 { *g } else { 2.0 * g * (xi * f64::from(k)).cos() })
                .sum();
            (least, most) = (least.min(sum), most.max(sum));
        }
        // The supremum is above the values at points, and not far if the limit is smooth.
        let smooth = mask.sobolev() > 1.2;
        let off = if smooth { 3e-3 } else { 0.2 };
        for (place, (formula, bounds)) in [
            ("overshoot()", [overshoot - 1e-6, overshoot + off]),
            ("gibbs()", [gibbs - 1e-6, gibbs + off]),
            ("riesz_lower()", [least - off, least + off]),
            ("riesz_upper()", [most - off, most + off]),
        ]
        .into_iter()
        .enumerate()
        {
            let found = between(&mask, formula, bounds);
            assert_ne!(found, Some(false), "{} {start} {formula}: {bounds:?}", mask.symbol());
            known[place] += usize::from(found.is_some());
        }
    }
    assert!(!ENCLOSED || known.iter().all(|known| *known > 8), "{known:?}");
}
