//! Points of refined control data and of their limits, as functionals of the data.

use super::polygon::Polygon;
use crate::numbers::{Meter, Q, Value, capped, int, over_one_denominator, solve};
use crate::schemes::Scheme;
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero as _};
use std::cell::OnceCell;
use std::collections::BTreeMap;

/// The largest window of a limit.
const MAX_WINDOW: i64 = 200;

/// The greatest index.
const MAX_INDEX: i64 = 1 << 40;

/// The highest level.
const MAX_LEVEL: u32 = 1_000;

/// The most points of a refined polygon.
const MAX_POINTS: i64 = 1 << 16;

/// A functional Σ_i f_i x_i with integers f_i over one denominator.
#[derive(Clone, Debug)]
pub struct Functional {
    weights: BTreeMap<i64, BigInt>,
    over: BigInt,
}

impl Functional {
    /// The functional P(u), 0 ≤ u < 1, where P is piecewise linear and P(i) = x_i.
    fn at(u: &Q) -> Functional {
        let weights = [(0, u.denom() - u.numer()), (1, u.numer().clone())];
        let weights = weights.into_iter().filter(|(_, weight)| !weight.is_zero());
        Functional { weights: weights.collect(), over: u.denom().clone() }
    }

    /// The functional with each weight f_i at the index i + `by`.
    fn moved(self, by: &BigInt) -> Result<Functional, Stop> {
        let by = capped(by, MAX_INDEX).ok_or(Stop::Capped("the parameters of control data"))?;
        let weights = self.weights.into_iter().map(|(i, weight)| (i + by, weight)).collect();
        Ok(Functional { weights, ..self })
    }

    /// The value at a polygon.
    pub fn of(&self, x: &Polygon) -> Q {
        Q::new(self.weights.iter().map(|(i, weight)| weight * x.at(*i)).sum(), self.over.clone())
    }

    /// The functional x_0.
    pub fn unit() -> Functional {
        Functional { weights: BTreeMap::from([(0, BigInt::one())]), over: BigInt::one() }
    }

    /// The difference of two functionals.
    pub fn minus(&self, other: &Functional) -> Functional {
        let mut weights = BTreeMap::new();
        for (functional, factor) in [(self, &other.over), (other, &-&self.over)] {
            for (i, weight) in &functional.weights {
                *weights.entry(*i).or_default() += weight * factor;
            }
        }
        Functional { weights, over: &self.over * &other.over }
    }

    /// The greatest value of a functional whose weights sum to 0, for |x_{i+1} − x_i| ≤ 1. It is
    /// Σ_p |Σ_{i≤p} f_i|.
    pub fn norm_on_differences(&self) -> Q {
        let (mut total, mut sum, mut last) = (BigInt::default(), BigInt::default(), None);
        for (i, weight) in &self.weights {
            total += sum.abs() * (i - last.unwrap_or(*i));
            sum += weight;
            last = Some(*i);
        }
        Q::new(total, self.over.clone())
    }
}

/// A mask of rational numbers at an offset.
pub struct Rules<'a> {
    /// The a_{α,j} as integers over one denominator.
    rows: Vec<Vec<BigInt>>,
    over: BigInt,
    offset: i64,
    meter: &'a Meter,
    zero: OnceCell<Zero>,
}

/// The limit at 0, if it exists: l, and the weights of x_l, x_{l+1}, …
type Zero = Result<Option<(i64, Vec<Q>)>, Stop>;

impl<'a> Rules<'a> {
    /// The rules of a scheme at an offset; `None` if they are not rational.
    pub fn new(meter: &'a Meter, scheme: &Scheme, offset: i64) -> Result<Option<Rules<'a>>, Stop> {
        let Some(mask) = Value::rationals(&scheme.mask) else { return Ok(None) };
        Rules::of(meter, &mask, offset).map(Some)
    }

    /// The rules of a mask at an offset.
    pub fn of(meter: &'a Meter, mask: &[Vec<Q>], offset: i64) -> Result<Rules<'a>, Stop> {
        let (rows, over) = over_one_denominator(mask)?;
        Ok(Rules { rows, over, offset, meter, zero: OnceCell::new() })
    }

    /// The arity n.
    pub fn arity(&self) -> i64 {
        size(&self.rows)
    }

    /// A polygon over a denominator, refined once: `x'_{ni+α} = Σ_j a_{α,j} x_{i+o+j}` for all i
    /// except where all x_{i+o+j} are the same end.
    pub fn refined(&self, (x, over): (&Polygon, &BigInt)) -> Result<(Polygon, BigInt), Stop> {
        let (n, width) = (self.arity(), size(&self.rows[0]));
        let from = x.first - self.offset - width;
        let to = x.first + size(&x.points) - self.offset;
        if (to - from + 1) * n > MAX_POINTS {
            return Err(Stop::Capped("the points of a refined polygon"));
        }
        self.meter.spend(((to - from + 1) * n * width).cast_unsigned())?;
        let point = |i: i64, rule: &Vec<BigInt>| {
            (i + self.offset..).zip(rule).map(|(at, a)| a * x.at(at)).sum::<BigInt>()
        };
        let points = (from..=to).flat_map(|i| self.rows.iter().map(move |rule| point(i, rule)));
        Ok((Polygon { first: n * from, points: points.collect() }, over * &self.over))
    }

    /// Whether no weight is negative.
    pub fn averages(&self) -> bool {
        self.rows.iter().flatten().all(|a| !a.is_negative())
    }

    /// The functional f of the refined points x', as a functional of x; `x'_{ni+α} = Σ_j a_{α,j}
    /// x_{i+o+j}`.
    fn before(&self, f: &Functional) -> Result<Functional, Stop> {
        let mut weights = BTreeMap::new();
        for (at, weight) in &f.weights {
            let rule = &self.rows[usize::try_from(at.rem_euclid(self.arity())).unwrap_or(0)];
            self.meter.spend(rule.len() as u64 * (1 + weight.bits() / 1024))?;
            for (i, a) in (at.div_euclid(self.arity()) + self.offset..).zip(rule) {
                *weights.entry(i).or_default() += weight * a;
            }
        }
        Ok(Functional { weights, over: &f.over * &self.over })
    }

    /// The functional f of the points of level k from a given one on, as a functional of the
    /// control data.
    fn of_level(&self, k: u32, mut from: BigInt, mut f: Functional) -> Result<Functional, Stop> {
        if k > MAX_LEVEL {
            return Err(Stop::Capped("the levels of a refinement"));
        }
        for _ in 0..k {
            let (rest, digit) = from.div_mod_floor(&self.arity().into());
            (from, f) = (rest, self.before(&f.moved(&digit)?)?);
        }
        f.moved(&from)
    }

    /// The functional P(u), where P is piecewise linear and P(i) = x^k_i.
    pub fn at(&self, k: u32, u: &Q) -> Result<Functional, Stop> {
        self.of_level(k, u.floor().to_integer(), Functional::at(&(u - u.floor())))
    }

    /// The functional P^k(t), where P^k is piecewise linear and P^k((i + s)/n^k) = x^k_i.
    pub fn polygon(&self, k: u32, t: &Q, s: &Q) -> Result<Functional, Stop> {
        self.at(k, &(t * int(self.arity()).pow(k.min(MAX_LEVEL).cast_signed()) - s))
    }

    /// The natural shift s: the points x_i = i + s, for all i, are refined to x'_i = (i + s)/n.
    /// `None` if there is no such s.
    pub fn natural_shift(&self) -> Option<Q> {
        let n = int(self.arity());
        let mut shifts = (0..).zip(&self.rows).map(|(alpha, row)| {
            let moments = (0..).zip(row).map(|(j, a)| a * BigInt::from(j)).sum::<BigInt>();
            let mean = Q::new(moments, self.over.clone()) + int(self.offset);
            (int(alpha) - &n * mean) / (&n - Q::one())
        });
        let shift = shifts.next()?;
        shifts.all(|other| other == shift).then_some(shift)
    }

    /// The functional P^∞(t) of a scheme that converges. It is `None` if tn^m is an integer for no
    /// m, or if there is no limit (THEOREMS.md, 3 and 4).
    pub fn limit(&self, t: &Q) -> Result<Option<Functional>, Stop> {
        let (mut at, mut levels) = (t.clone(), 0);
        while !at.is_integer() {
            (at, levels) = (at * int(self.arity()), levels + 1);
            if levels > MAX_LEVEL {
                return Ok(None);
            }
        }
        let zero = self.zero.get_or_init(|| self.limit_at_zero()).as_ref();
        let Some((first, weights)) = zero.map_err(Clone::clone)? else { return Ok(None) };
        let over = weights.iter().fold(BigInt::one(), |over, w| over.lcm(w.denom()));
        let top = |w: &Q| w.numer() * (&over / w.denom());
        let weights = (*first..).zip(weights.iter().map(top)).collect();
        self.of_level(levels, at.to_integer(), Functional { weights, over }).map(Some)
    }

    /// The limit at 0. It exists if the equations wA = w, Σw = 1 have exactly one solution.
    fn limit_at_zero(&self) -> Zero {
        let (arity, width) = (self.arity(), size(&self.rows[0]));
        // Row i of A has its entries in the columns from ⌊i/n⌋ + o to ⌊i/n⌋ + o + N − 1. For l ≤ i
        // ≤ h these are between l and h, if l is the least i with i − ⌊i/n⌋ = o, and h the greatest
        // i with i − ⌊i/n⌋ = o + N − 1, since i − ⌊i/n⌋ does not decrease.
        let reach = |i: i64| i - i.div_euclid(arity);
        let bound = 2 * (self.offset.abs() + width) + 2;
        let l = (-bound..=bound).find(|&i| reach(i) == self.offset);
        let h = (-bound..=bound).rev().find(|&i| reach(i) == self.offset + width - 1);
        let (Some(l), Some(h)) = (l, h) else { return Ok(None) };
        if h - l >= MAX_WINDOW {
            return Err(Stop::Capped("the window of a limit"));
        }
        let place = |i: i64| usize::try_from(i - l).unwrap_or(0);
        let count = place(h) + 1;
        self.meter.spend(count.pow(3) as u64)?;
        let mut equations = vec![vec![Q::zero(); count + 1]; count];
        for i in l..=h {
            let row = &self.rows[usize::try_from(i.rem_euclid(arity)).unwrap_or(0)];
            for (column, a) in (i.div_euclid(arity) + self.offset..).zip(row) {
                equations[place(column)][place(i)] += Q::new(a.clone(), self.over.clone());
            }
            equations[place(i)][place(i)] -= Q::one();
        }
        // The rows of A sum to 1, so that the first equation follows from the others.
        equations[0] = vec![Q::one(); count + 1];
        Ok(solve(equations).map(|weights| (l, weights)))
    }
}

fn size<T>(list: &[T]) -> i64 {
    i64::try_from(list.len()).unwrap_or(i64::MAX)
}

/// Σ_{i,j} f_i g_j x(i, j).
pub fn product(f: &Functional, g: &Functional, x: impl Fn(i64, i64) -> BigInt) -> Q {
    let row = |i| g.weights.iter().map(|(j, weight)| weight * x(i, *j)).sum::<BigInt>();
    let sum = f.weights.iter().map(|(i, weight)| weight * row(*i)).sum();
    Q::new(sum, &f.over * &g.over)
}
