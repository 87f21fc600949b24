//! Values of limits, and depths.

use crate::bound::Budget;
use crate::exact::Rational;
use crate::limit::{Distances, Functional, Limit, LimitError, Parametrisation, TwoSidedDepth};
use crate::scheme::Mask;

/// The most steps of the search for one depth.
const MAX_STEPS: u64 = 20_000_000;

/// The depths of a polygon with differences up to 1.
#[derive(Clone, Debug)]
pub struct Depths {
    /// With x^k_i at i/n^k.
    pub indexed: Result<TwoSidedDepth, String>,
    /// With x^k_i at (i + s)/n^k, s the natural shift.
    pub natural: Result<TwoSidedDepth, String>,
}

impl Depths {
    /// Their tolerance.
    #[must_use]
    pub fn tolerance() -> Rational {
        Rational::new(1, 100)
    }
}

/// Values of the basic limit function φ, and stencils.
#[derive(Clone, Debug)]
pub struct LimitFacts {
    /// Σ_i φ(−i) x_i is the limit at 0. The stencil of the limit at the integer 0.
    pub at_zero: Functional,
    /// The natural shift s, and the limit at s, where x_0 tends to; `None` where s is 0, or has no value.
    pub at_shift: Option<(Rational, Functional)>,
}

impl LimitFacts {
    /// The values φ(k), k an integer, that are not 0.
    #[must_use]
    pub fn values(&self) -> Vec<(i64, Rational)> {
        self.at_zero.terms().rev().map(|(i, value)| (-i, value.clone())).collect()
    }

    /// The depths and values of a mask.
    pub(super) fn with_depths(mask: &Mask) -> (Depths, Result<LimitFacts, String>) {
        let limit = match Limit::new(mask) {
            Ok(limit) => limit,
            Err(error) => {
                let reason = error.to_string();
                let depths = Depths { indexed: Err(reason.clone()), natural: Err(reason.clone()) };
                return (depths, Err(reason));
            }
        };
        let [indexed, natural] = [Parametrisation::Indexed, Parametrisation::Natural];
        let depths = Depths { indexed: depth(&limit, indexed), natural: depth(&limit, natural) };
        (depths, LimitFacts::of(&limit).map_err(|error| error.to_string()))
    }

    /// The stencils of a limit.
    ///
    /// # Errors
    /// When the limit has no value at 0.
    ///
    /// ```
    /// use subcert::facts::LimitFacts;
    /// use subcert::limit::Limit;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("[1, 4, 6, 4, 1]/8")?;
    /// let facts = LimitFacts::of(&Limit::new(scheme.masks()[0])?)?;
    /// let values: Vec<String> = facts.values().iter().map(|(_, value)| value.to_string()).collect();
    /// assert_eq!(values, ["1/6", "2/3", "1/6"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(limit: &Limit) -> Result<LimitFacts, LimitError> {
        let at_zero = limit.at(&Rational::zero())?;
        let shift = Parametrisation::Natural.shift(limit.mask());
        let moved = (!shift.is_zero()).then_some(shift);
        let at_shift = moved.and_then(|shift| {
            let stencil = limit.at(&shift).ok()?;
            Some((shift, stencil))
        });
        Ok(LimitFacts { at_zero, at_shift })
    }
}

fn depth(limit: &Limit, parametrisation: Parametrisation) -> Result<TwoSidedDepth, String> {
    let distances = Distances::placed(limit, parametrisation).map_err(|error| error.to_string())?;
    let distances = distances.with_budget(Budget::new(MAX_STEPS));
    distances.depth(&Rational::one(), &Depths::tolerance()).map_err(|error| error.to_string())
}
