//! How smooth the limits of a mask on Z^d are.

use super::constants::LatticeConstants;
use super::exponent::exponent;
use super::polynomials::sum_rules;
use super::product::{directions, factors, least_cut};
use super::radius::{LatticeRadius, differences, nearest};
use super::shape::is_isotropic;
use crate::exact::{Rational, RealAlgebraic};
use crate::scheme::{LatticeMask, Mask};
use crate::smoothness::{ExponentFormula, Hoelder, Smoothness, SmoothnessError, log_of};
use crate::stop::Stop;

/// The most functionals of a constant that is to show convergence.
const MAX_FUNCTIONALS: usize = 1 << 11;

/// What is proven of the limits of a mask on Z^d.
#[derive(Clone, Debug)]
pub struct LatticeSmoothness {
    /// The order K of the sum rules.
    pub sum_rules: u32,
    /// The order K' of the accuracy: the largest for which all polynomials of degree below are sums of shifts of φ. `None` where that is open.
    pub accuracy: Option<u32>,
    /// c and T_c < 1, if convergence is shown so.
    pub contraction: Option<(u32, Rational)>,
    /// Whether the scheme converges for all data; `None` where that is open.
    pub converges: Option<bool>,
    /// The factors and what is proven of their limits, where the mask is a product of masks of curves.
    pub factors: Option<Vec<(Mask, Smoothness)>>,
    /// The radius that decides on convergence, where no T_c does.
    pub differences: Option<LatticeRadius>,
    /// The radius that decides on the smoothness; of an isotropic M, where the mask is no product.
    pub radius: Option<LatticeRadius>,
    /// The largest m for which the limits are proven to be C^m.
    pub continuity: Option<u32>,
    /// The least m for which it is proven that not all limits are C^m.
    pub continuity_fails: Option<u32>,
    /// The Hölder exponent; of an isotropic M.
    pub hoelder: Option<Hoelder>,
    /// Why something is open.
    pub open: Option<String>,
}

impl LatticeSmoothness {
    /// What can be proven of the limits, until the search is stopped. Those of a product of masks of curves are as smooth as the least smooth of its
    /// factors, and those of box splines as their directions say; of other masks the [`general`](Self::general) way is taken.
    ///
    /// ```
    /// use subcert::lattice::LatticeSmoothness;
    /// use subcert::scheme::parse_lattice;
    /// use subcert::stop::Stop;
    ///
    /// // Zwart and Powell's element: sum rules of order 2, but quadratic polynomials are sums of its shifts.
    /// let mask = parse_lattice("(1+x)*(1+y)*(1+x*y)*(1+x/y)/4")?;
    /// let found = LatticeSmoothness::until(&mask, &Stop::default());
    /// assert_eq!((found.sum_rules, found.accuracy, found.continuity), (2, Some(3), Some(1)));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn until(mask: &LatticeMask, stop: &Stop) -> LatticeSmoothness {
        if factors(mask).is_none()
            && let Some(directions) = directions(mask)
        {
            let mut found = LatticeSmoothness::none(mask);
            found.contraction = contraction(mask);
            if found.contraction.is_some() {
                found.of_box_spline(least_cut(&directions, mask.dimension()));
                return found;
            }
        }
        LatticeSmoothness::by_radii(mask, stop)
    }

    /// The same by radii of matrices alone, which certificates have.
    #[must_use]
    pub fn by_radii(mask: &LatticeMask, stop: &Stop) -> LatticeSmoothness {
        let Some(factors) = factors(mask) else { return LatticeSmoothness::general(mask, stop) };
        let mut found = LatticeSmoothness::none(mask);
        found.of_factors(&factors, stop);
        found
    }

    /// That of a box spline whose directions span no more without so many of them, where the scheme converges.
    fn of_box_spline(&mut self, cut: usize) {
        let order = u32::try_from(cut).ok();
        self.converges = Some(true);
        self.accuracy = order;
        self.continuity = order.and_then(|order| order.checked_sub(2));
        self.continuity_fails = order.and_then(|order| order.checked_sub(1));
        let exponent = cut.saturating_sub(1);
        let formula = ExponentFormula::new(exponent, 2, &RealAlgebraic::from(Rational::one()), 1);
        let value = || Rational::from(exponent);
        self.hoelder = Some(Hoelder {
            lower: value(),
            upper: value(),
            formula: Some(formula),
            attained: Some(true),
        });
    }

    /// Convergence alone.
    #[must_use]
    pub fn convergence(mask: &LatticeMask, stop: &Stop) -> LatticeSmoothness {
        let mut found = LatticeSmoothness::none(mask);
        found.contraction = contraction(mask);
        let sum_rules = found.sum_rules;
        if found.contraction.is_some() {
            found.converges = Some(true);
            return found;
        }
        match differences(mask, sum_rules, stop) {
            Ok(mut differences) => {
                differences.seek(&[differences.factor.clone()], stop);
                found.converges = differences.is_below(&Rational::one());
                found.differences = Some(differences);
            }
            Err(cap) => found.open = Some(cap.to_string()),
        }
        found
    }

    fn none(mask: &LatticeMask) -> LatticeSmoothness {
        LatticeSmoothness {
            sum_rules: sum_rules(mask),
            accuracy: None,
            contraction: None,
            converges: None,
            factors: None,
            differences: None,
            radius: None,
            continuity: None,
            continuity_fails: None,
            hoelder: None,
            open: None,
        }
    }

    /// The same without a look at factors.
    ///
    /// Convergence is shown by T_c < 1, or by the radius ϱ_K on differences of order K, and C^m of any M by that on differences of order m + 1. Of an isotropic M the exponent is −log_s ϱ, s^d = m, with the radius
    /// ϱ of the steps on the differences of the order of the accuracy, of the values of φ near a tile: an alcove, where the mask has its symmetries, or the
    /// tile of the digits. `proofs/THEOREMS.md`, 146 to 149.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn general(mask: &LatticeMask, stop: &Stop) -> LatticeSmoothness {
        let mut found = LatticeSmoothness::convergence(mask, stop);
        match found.converges {
            Some(true) => found.continuity = Some(0),
            Some(false) => {
                found.continuity_fails = Some(0);
                return found;
            }
            None => return found,
        }
        if !is_isotropic(mask.dilation()) {
            let order = |m: &u32| {
                differences(mask, m + 1, stop).is_ok_and(|found| found.outweighs(mask, *m))
            };
            let orders = (1..found.sum_rules).take_while(order);
            found.continuity = orders.last().or(Some(0));
            found.open = Some(
                "the eigenvalues of the dilation matrix have several moduli, or it is not diagonalisable: the exponent is open, and higher orders are"
                    .to_owned(),
            );
            return found;
        }
        match nearest(mask, stop) {
            Ok(Some((accuracy, radius))) => found.decide(mask, accuracy, radius, stop),
            Ok(None) => found.open = Some("φ has no values at the integers".to_owned()),
            Err(cap) => found.open = Some(cap.to_string()),
        }
        found
    }

    /// A product converges if and only if each factor does, and φ(x) = φ_1(x_1)⋯φ_d(x_d) is as smooth as the least smooth of its factors.
    fn of_factors(&mut self, masks: &[Mask], stop: &Stop) {
        let all: Result<Vec<Smoothness>, SmoothnessError> =
            masks.iter().map(|mask| Smoothness::until(mask, stop)).collect();
        let all = match all {
            Ok(all) => all,
            Err(error) => {
                self.open = Some(error.to_string());
                return;
            }
        };
        let order = |m: Option<usize>| m.and_then(|m| u32::try_from(m).ok());
        let fails = all.iter().filter_map(|one| order(one.continuity_fails)).min();
        self.continuity_fails = fails;
        let proven: Option<Vec<u32>> = all.iter().map(|one| order(one.continuity)).collect();
        self.continuity = proven.and_then(|all| all.into_iter().min());
        self.converges = match (self.continuity, fails) {
            (Some(_), _) => Some(true),
            (None, Some(0)) => Some(false),
            _ => None,
        };
        let accuracy = all.iter().map(|one| one.deciding().order).min();
        self.accuracy = order(accuracy).filter(|_| self.converges == Some(true));
        let exponents: Vec<Option<Hoelder>> = all.iter().map(|one| one.hoelder.clone()).collect();
        self.hoelder = least(&exponents);
        self.factors = Some(masks.iter().cloned().zip(all).collect());
    }

    fn decide(&mut self, mask: &LatticeMask, accuracy: u32, mut found: LatticeRadius, stop: &Stop) {
        let m = mask.dilation().class_count();
        let d = mask.dimension();
        found.seek_roots(accuracy, m, d, stop);
        self.accuracy = Some(accuracy);
        let scaled = (found.order, &found.factor);
        let exponent = exponent(&found.radius, scaled, mask.dilation());
        // s^{−k} for M with |det M| = m = s^d is a d-th root.
        let below = |k: u32| found.is_below_root(k, m, d);
        self.continuity = (0..accuracy).take_while(|k| below(*k) == Some(true)).last().or(Some(0));
        // No φ is C^{K'}.
        let fails = (1..accuracy).find(|k| below(*k) == Some(false));
        self.continuity_fails = fails.or(Some(accuracy));
        self.hoelder = exponent;
        // |φ(x) − φ(y)| is at most a multiple of T_c for points at a distance of the order of s^{−c}.
        if let (Some(hoelder), Some((c, bound))) = (&mut self.hoelder, &self.contraction)
            && hoelder.formula.is_none()
        {
            let per_level = Rational::from(d) / Rational::from(*c);
            let lower = -(log_of(bound, m, 1).upper().clone() * per_level);
            let lower = lower.min(Rational::one()).max(Rational::zero());
            hoelder.lower = lower.max(hoelder.lower.clone());
        }
        if self.hoelder.as_ref().is_none_or(|hoelder| hoelder.formula.is_none()) {
            self.open = Some("the bounds of the radius do not meet".to_owned());
        }
        self.radius = Some(found);
    }
}

/// c and T_c, for the first c with T_c < 1.
fn contraction(mask: &LatticeMask) -> Option<(u32, Rational)> {
    let mut constants = LatticeConstants::new(mask);
    loop {
        if constants.next_count() > MAX_FUNCTIONALS {
            return None;
        }
        constants.advance().ok()?;
        let found = constants.contraction().ok()?;
        if found.value < Rational::one() {
            return Some((found.count, found.value));
        }
    }
}

/// The exponent of a product: the least one, if it is known to be the least.
fn least(exponents: &[Option<Hoelder>]) -> Option<Hoelder> {
    let all: Vec<&Hoelder> = exponents.iter().map(Option::as_ref).collect::<Option<_>>()?;
    let lower = all.iter().map(|one| &one.lower).min()?.clone();
    let upper = all.iter().map(|one| &one.upper).min()?.clone();
    let first = *all.iter().min_by_key(|one| &one.upper)?;
    let formula = |one: &Hoelder| one.formula.as_ref().map(ToString::to_string);
    let is_least = |one: &&Hoelder| one.lower >= first.upper || formula(one) == formula(first);
    let known = first.formula.clone().filter(|_| all.iter().all(is_least));
    // The supremum is attained if it is in each factor that has it.
    let own = all.iter().filter(|one| one.lower < first.upper || formula(one) == formula(first));
    let attained = own.map(|one| one.attained).reduce(|a, b| match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    });
    let attained = attained.flatten().filter(|_| known.is_some());
    Some(Hoelder { lower, upper, formula: known, attained })
}
