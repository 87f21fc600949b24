//! The constants of a scheme in any arithmetic, as a list of named values.

use super::apriori::Tracked;
use super::error::{CertifyError, MAX_STEPS};
use crate::bound::{
    Budget, ClassCap, Order, PowerSearch, Terms, displacement, power_norm_generic, steps_of_visit,
    surface_factor,
};
use crate::exact::{Rational, Real};
use crate::scheme::{Mask, Rules, Scheme};

/// A number type with its own method for the norms of powers.
pub(super) trait Arithmetic: Real {
    /// ‖Rᶜ‖_∞ for c = 1, …, `levels`, in the adjoint order.
    fn norms(rules: &Rules<Self>, levels: u32, budget: &Budget) -> Result<Vec<Self>, CertifyError>;
}

impl Arithmetic for Rational {
    /// The exact path, by [`PowerSearch`].
    fn norms(
        rules: &Rules<Rational>,
        levels: u32,
        budget: &Budget,
    ) -> Result<Vec<Rational>, CertifyError> {
        let mut search = PowerSearch::new(rules, Order::Adjoint).with_budget(budget.clone());
        (1..=levels).map(|c| Ok(search.norm(c)?.value)).collect()
    }
}

impl Arithmetic for f64 {
    fn norms(rules: &Rules<f64>, levels: u32, budget: &Budget) -> Result<Vec<f64>, CertifyError> {
        walked(rules, levels, budget)
    }
}

impl Arithmetic for Tracked {
    fn norms(
        rules: &Rules<Tracked>,
        levels: u32,
        budget: &Budget,
    ) -> Result<Vec<Tracked>, CertifyError> {
        walked(rules, levels, budget)
    }
}

/// The norms by visiting every residue class. The greatest c comes first, so that too many
/// classes are refused at once.
fn walked<S: Real>(rules: &Rules<S>, levels: u32, budget: &Budget) -> Result<Vec<S>, CertifyError> {
    let norm = |c| {
        ClassCap::check(rules.arity(), c)?;
        if !budget.take(steps_of_visit(rules.arity(), rules.width(), c)) {
            return Err(CertifyError::Walk { levels: c, steps: budget.total() });
        }
        Ok(power_norm_generic(rules, c, Order::Adjoint)?)
    };
    let mut norms = (1..=levels).rev().map(norm).collect::<Result<Vec<S>, CertifyError>>()?;
    norms.reverse();
    Ok(norms)
}

/// Named values, and the values from which depths are computed.
pub(super) struct Outcome<S> {
    /// Every quantity, in the order of the report.
    pub named: Vec<(String, S)>,
    /// σ, or the factor of a surface.
    pub factor: S,
    /// For c = 1, 2, …: T_c for a curve; for a surface, T_cΛ_c in the direction where it
    /// is greater.
    pub ratios: Vec<S>,
}

impl<S: Arithmetic> Outcome<S> {
    /// The constants of `scheme` for c = 1, …, `blocks`.
    pub(super) fn constants(scheme: &Scheme, blocks: u32) -> Result<Outcome<S>, CertifyError> {
        let budget = Budget::new(MAX_STEPS);
        let mut named = Vec::new();
        match scheme {
            Scheme::Curve(mask) => {
                let mask = mask.map(S::from_rational);
                let along = Direction::new(&mask, blocks, &budget)?;
                along.report("", &mut named);
                for (c, (t, lambda)) in (1..).zip(along.contraction.iter().zip(&along.norm)) {
                    named.push((format!("T_{c}*Lambda_{c}"), t.times(lambda)));
                }
                named.push(("surface factor".to_owned(), surface_factor(&mask, &mask)));
                Ok(Outcome { named, factor: along.sigma, ratios: along.contraction })
            }
            Scheme::Tensor(first, second) => {
                let masks = [first.map(S::from_rational), second.map(S::from_rational)];
                let first = Direction::new(&masks[0], blocks, &budget)?;
                let second = Direction::new(&masks[1], blocks, &budget)?;
                first.report("first ", &mut named);
                second.report("second ", &mut named);
                let mut ratios = Vec::new();
                for at in 0..first.norm.len() {
                    let c = at + 1;
                    let along = first.contraction[at].times(&second.norm[at]);
                    let across = second.contraction[at].times(&first.norm[at]);
                    let ratio = along.greater(&across);
                    named.push((format!("first T_{c}*second Lambda_{c}"), along));
                    named.push((format!("second T_{c}*first Lambda_{c}"), across));
                    ratios.push(ratio);
                }
                let factor = surface_factor(&masks[0], &masks[1]);
                named.push(("surface factor".to_owned(), factor.clone()));
                Ok(Outcome { named, factor, ratios })
            }
        }
    }

    /// Adds the error bounds σβ C^k/(1 − C) at the levels k, for every block length c =
    /// 1, 2, … for which `contracts` is true, that is, the exact C is below 1.
    pub(super) fn add_bounds(&mut self, spread: &Rational, levels: &[u32], contracts: &[bool]) {
        let spread = S::from_rational(spread);
        for (c, (ratio, contracts)) in (1..).zip(self.ratios.iter().zip(contracts)) {
            for &k in levels.iter().filter(|_| *contracts) {
                let bound = error_bound(&self.factor, &spread, ratio, k);
                self.named.push((format!("error(c={c}, k={k})"), bound));
            }
        }
    }
}

/// σβ·C^k/(1 − C), where the power takes k multiplications.
fn error_bound<S: Real>(sigma: &S, spread: &S, ratio: &S, k: u32) -> S {
    let one = S::from_rational(&Rational::one());
    let power = (0..k).fold(one.clone(), |power, _| power.times(ratio));
    sigma.times(spread).times(&power).over(&one.minus(ratio))
}

/// The constants of one mask.
struct Direction<S> {
    difference: Rules<S>,
    contraction: Vec<S>,
    norm: Vec<S>,
    sigma: S,
    sigma_at_zero: S,
}

impl<S: Arithmetic> Direction<S> {
    fn new(mask: &Mask<S>, blocks: u32, budget: &Budget) -> Result<Direction<S>, CertifyError> {
        let difference = mask.difference();
        Ok(Direction {
            contraction: S::norms(&difference, blocks, budget)?,
            norm: S::norms(mask.rules(), blocks, budget)?,
            sigma: displacement(mask, Terms::Each),
            sigma_at_zero: displacement(&mask.with_offset(0), Terms::Each),
            difference,
        })
    }

    fn report(&self, prefix: &str, named: &mut Vec<(String, S)>) {
        for (beta, row) in self.difference.rows().iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                named.push((format!("{prefix}b[{beta}][{j}]"), entry.clone()));
            }
        }
        for (symbol, constants) in [("T", &self.contraction), ("Lambda", &self.norm)] {
            for (c, constant) in (1..).zip(constants) {
                named.push((format!("{prefix}{symbol}_{c}"), constant.clone()));
            }
        }
        named.push((format!("{prefix}sigma"), self.sigma.clone()));
        named.push((format!("{prefix}sigma(o=0)"), self.sigma_at_zero.clone()));
    }
}
