//! The greatest values of the levels and of the limit of a polygon. No shift of the parameter
//! changes them.

use crate::bound::{Terms, displacement};
use crate::exact::{Integer, Rational};
use crate::limit::functional::ExtremalPolygon;
use crate::limit::row::Refinement;
use crate::limit::value::Limit;

/// The greatest number of points of a level.
const MAX_POINTS: usize = 1 << 14;

/// The greatest number of residue classes of the constant T_c in [`near`].
const MAX_CLASSES: usize = 1 << 12;

/// A polygon that is constant beyond its ends, with the greatest point of each computed
/// level.
///
/// Source: `proofs/THEOREMS.md`, 89.
#[derive(Clone, Debug)]
pub(crate) struct Summits {
    polygon: ExtremalPolygon,
    levels: Vec<Level>,
    /// The points of the last computed level, times their denominator, and the index of
    /// the first one.
    first: i64,
    points: Vec<Integer>,
    denominator: Integer,
}

/// The greatest point and the spread of a level.
#[derive(Clone, Debug)]
struct Level {
    greatest: Rational,
    /// The index of the greatest point.
    index: i64,
    /// max|Δ|.
    spread: Rational,
}

impl Summits {
    pub(super) fn new(polygon: ExtremalPolygon) -> Summits {
        let points: Vec<Integer> = polygon.points.iter().map(|x| Integer::from(*x)).collect();
        let (first, denominator) = (polygon.first, Integer::one());
        let mut summits = Summits { polygon, levels: Vec::new(), first, points, denominator };
        summits.note();
        summits
    }

    /// Stores the greatest point and the spread of the last level.
    fn note(&mut self) {
        let over = |value: &Integer| Rational::new(value.clone(), self.denominator.clone());
        let greatest =
            (self.first..).zip(&self.points).max_by(|(i, x), (j, y)| (x, j).cmp(&(y, i)));
        let (index, greatest) = greatest.expect("a polygon has points");
        let differences = self.points.windows(2).map(|pair| (&pair[1] - &pair[0]).abs());
        let spread = differences.max().unwrap_or_else(Integer::zero);
        let level = Level { greatest: over(greatest), index, spread: over(&spread) };
        self.levels.push(level);
    }

    /// Refines up to a level; `false` if that level has too many points.
    fn reach(&mut self, rules: &Refinement, level: u32) -> bool {
        while self.levels.len() <= level as usize {
            let arity = usize::try_from(rules.arity()).unwrap_or(usize::MAX);
            if (self.points.len() + rules.width()).saturating_mul(arity) > MAX_POINTS {
                return false;
            }
            (self.first, self.points) = rules.refine(self.first, &self.points);
            self.denominator = &self.denominator * rules.denominator();
            self.note();
        }
        true
    }

    /// The polygon.
    pub(crate) fn polygon(&self) -> &ExtremalPolygon {
        &self.polygon
    }

    /// The greatest point of a level; `None` if it has too many points.
    pub(super) fn greatest(&mut self, rules: &Refinement, level: u32) -> Option<Rational> {
        self.reach(rules, level).then(|| self.levels[level as usize].greatest.clone())
    }

    /// An upper bound of the limit from the points of a level; `None` if there is none.
    pub(super) fn at_most(&mut self, limits: &Peaked, level: u32) -> Option<Rational> {
        let near = limits.near.clone()?;
        let of = self.reach(&limits.rules, level).then(|| &self.levels[level as usize])?;
        Some(&of.greatest + near * &of.spread)
    }

    /// A value of the limit near the greatest point of a level, and its parameter.
    pub(super) fn at_least(&mut self, limits: &Peaked, level: u32) -> Option<(Rational, Rational)> {
        let of = self.reach(&limits.rules, level).then(|| &self.levels[level as usize])?;
        // For level m, the parameter j/n^{m+1} that is nearest to the natural parameter
        // of the point.
        let arity = Rational::from(limits.limit.mask().arity());
        let places = arity.pow((level + 1).cast_signed());
        let at = (Rational::from(of.index) + &limits.shift) * arity;
        let place = Rational::from((at + Rational::new(1, 2)).floor()) / places;
        let last = self.polygon.points.len() - 1;
        let control = |i: i64| {
            let i = usize::try_from(i - self.polygon.first).unwrap_or(0).min(last);
            Rational::from(self.polygon.points[i])
        };
        Some((limits.limit.at(&place).ok()?.apply(control), place))
    }
}

/// A scheme, prepared for the greatest values of its limits.
pub(super) struct Peaked {
    pub(crate) limit: Limit,
    pub(super) rules: Refinement,
    /// The natural shift.
    pub(super) shift: Rational,
    /// A number f such that P^∞ ≤ max x + f·max|Δ|; `None` if none is known.
    near: Option<Rational>,
}

impl Peaked {
    pub(super) fn new(limit: &Limit, shift: Rational) -> Peaked {
        let rules = Refinement::of(limit.mask().rules());
        Peaked { near: near(limit), limit: limit.clone(), rules, shift }
    }
}

/// The f of [`Peaked`]: 0 if no entry of the mask is negative; otherwise σ(T_0 + … +
/// T_{c−1})/(1 − T_c) for the least c with T_c < 1, if that has at most `MAX_CLASSES`
/// residue classes.
fn near(limit: &Limit) -> Option<Rational> {
    let mask = limit.mask();
    if mask.rules().rows().iter().flatten().all(|entry| entry.sign() >= 0) {
        return Some(Rational::zero());
    }
    let constants = limit.contraction();
    let block = constants.iter().position(|constant| *constant < Rational::one())?;
    let classes = mask.arity().checked_pow(u32::try_from(block).ok()?)?;
    let sum: Rational = constants[..block].iter().cloned().sum();
    let factor = displacement(mask, Terms::Each) * sum;
    (classes <= MAX_CLASSES).then(|| factor / (Rational::one() - &constants[block]))
}
