//! The facts of a mask.

use super::distance::{Depths, LimitFacts};
use super::shape::{PointPlacement, centre, is_interpolating, kind, points};
use crate::bound::{
    Budget, Order, PowerSearch, Terms, best_offset, displacement, power_norm_generic,
};
use crate::exact::{FieldElement, Rational};
use crate::limit::{NaturalShift, natural_shift};
use crate::scheme::{Mask, Rules};
use crate::smoothness::{Coefficient, Smoothness, SmoothnessError, Symbol, reproduction_degree};

/// The constants are those of c = 1, …, this many levels.
pub const MAX_LEVELS: u32 = 8;

/// The most steps of the search for the constants of one operator.
const MAX_STEPS: u64 = 20_000_000;

/// The most rows of a power over a field of irrational numbers.
const MAX_FIELD_ROWS: usize = 1 << 8;

/// T_c and Λ_c for c = 1, 2, …, as far as the caps allow.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns<F> {
    /// T_1, T_2, …
    pub contraction: Vec<F>,
    /// Λ_1, Λ_2, …
    pub norm: Vec<F>,
}

/// What is known of a mask at once. What is not decided is `None`, shorter, or an `Err` that says why.
#[derive(Clone, Debug)]
pub struct CurveFacts<F = Rational> {
    /// The symbol, with the arity and the support.
    pub symbol: Symbol<F>,
    /// How many points a rule takes.
    pub points: usize,
    /// Whether the scheme is primal or dual, by its centre of symmetry or its natural shift; `None` where it has
    /// neither, or is neither.
    pub kind: Option<PointPlacement>,
    /// Whether it interpolates its data.
    pub interpolating: bool,
    /// The centre of the basic limit function; `None` without symmetry.
    pub centre: Option<Rational>,
    /// The order K of the sum rules: polynomials up to degree K − 1 are generated.
    pub sum_rules: usize,
    /// The degree up to which polynomials are reproduced at the natural shift.
    pub reproduction: usize,
    /// The natural shift, the parameter τ of the literature up to its sign.
    pub shift: NaturalShift<F>,
    /// C^m and the Hölder exponent.
    pub smoothness: Result<Smoothness<F>, SmoothnessError>,
    /// T_c and Λ_c.
    pub columns: Columns<F>,
    /// σ at the scheme's offset.
    pub displacement: F,
    /// The best offset and its σ; of rational masks.
    pub best_offset: Option<(i64, Rational)>,
    /// Depths of a polygon with differences up to 1.
    pub depths: Depths,
    /// Values and stencils of the limit.
    pub limit: Result<LimitFacts, String>,
}

impl CurveFacts {
    /// The facts of a rational mask.
    #[must_use]
    pub fn of_rational(mask: &Mask) -> CurveFacts {
        let columns =
            Columns { contraction: searched(&mask.difference()), norm: searched(mask.rules()) };
        let (depths, limit) = LimitFacts::with_depths(mask);
        let mut facts = CurveFacts::gathered(mask, columns, depths, limit);
        facts.best_offset = Some(best_offset(mask));
        facts
    }
}

impl CurveFacts<FieldElement> {
    /// The facts of a mask with irrational coefficients. Its limits have no values here, and polygons no depths.
    #[must_use]
    pub fn of_algebraic(mask: &Mask<FieldElement>) -> CurveFacts<FieldElement> {
        let columns =
            Columns { contraction: walked(&mask.difference()), norm: walked(mask.rules()) };
        let open = || {
            "the coefficients are irrational, and limits are computed of rational ones".to_owned()
        };
        let depths = Depths { indexed: Err(open()), natural: Err(open()) };
        CurveFacts::gathered(mask, columns, depths, Err(open()))
    }
}

impl<F: Coefficient> CurveFacts<F> {
    fn gathered(
        mask: &Mask<F>,
        columns: Columns<F>,
        depths: Depths,
        limit: Result<LimitFacts, String>,
    ) -> CurveFacts<F> {
        let symbol = Symbol::of(mask);
        let (centre, shift) = (centre(&symbol), natural_shift(mask));
        let place = centre.clone().or_else(|| match &shift.shift.coordinates()[..] {
            [place] if shift.keeps_lines => Some(place.clone()),
            _ => None,
        });
        CurveFacts {
            points: points(mask),
            kind: place.and_then(|place| kind(mask.arity(), &place)),
            interpolating: is_interpolating(mask),
            centre,
            sum_rules: symbol.sum_rules().0,
            reproduction: reproduction_degree(mask),
            shift,
            smoothness: Smoothness::of(mask),
            columns,
            displacement: displacement(mask, Terms::Each),
            best_offset: None,
            depths,
            limit,
            symbol,
        }
    }

    /// The facts that are open, each with its reason.
    #[must_use]
    pub fn open(&self) -> Vec<(&'static str, String)> {
        let mut open = Vec::new();
        match &self.smoothness {
            Err(error) => open.push(("smoothness", error.to_string())),
            Ok(found) => {
                if found.continuity.is_none() && found.continuity_fails.is_none() {
                    open.push((
                        "convergence",
                        "neither a contraction nor a divergent product is found".to_owned(),
                    ));
                }
                let exact = found.hoelder.as_ref().is_none_or(|hoelder| hoelder.formula.is_some());
                if !exact {
                    open.push((
                        "Hölder exponent",
                        "its bounds do not meet: no extremal hull is found within the caps"
                            .to_owned(),
                    ));
                }
            }
        }
        for (name, found) in [("T_c", &self.columns.contraction), ("Λ_c", &self.columns.norm)] {
            if found.len() < MAX_LEVELS as usize {
                let reason =
                    format!("beyond c = {} the search reaches its cap on work", found.len());
                open.push((name, reason));
            }
        }
        for (name, depth) in
            [("depth, indexed", &self.depths.indexed), ("depth, natural", &self.depths.natural)]
        {
            match depth {
                Err(reason) => open.push((name, reason.clone())),
                Ok(depth) if depth.lower < depth.upper => {
                    open.push((name, "the search for the distance reaches its cap".to_owned()));
                }
                Ok(_) => {}
            }
        }
        if let Err(reason) = &self.limit {
            open.push(("limit values", reason.clone()));
        }
        open
    }
}

/// The norms of the powers, by branch and bound.
fn searched(rules: &Rules) -> Vec<Rational> {
    let budget = Budget::new(MAX_STEPS);
    let mut search = PowerSearch::new(rules, Order::Adjoint).with_budget(budget);
    (1..=MAX_LEVELS).map_while(|c| Some(search.norm(c).ok()?.value)).collect()
}

/// The norms of the powers over a field, by a visit of all rows.
fn walked(rules: &Rules<FieldElement>) -> Vec<FieldElement> {
    let few = |c: &u32| rules.arity().checked_pow(*c).is_some_and(|rows| rows <= MAX_FIELD_ROWS);
    let levels = (1..=MAX_LEVELS).take_while(few);
    levels.map_while(|c| power_norm_generic(rules, c, Order::Adjoint).ok()).collect()
}
