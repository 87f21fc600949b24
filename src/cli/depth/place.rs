//! The parameters at which the points of a level are compared with the limit.

use crate::cli::console::quantity::Text;
use serde::Serialize;
use subcert::audit::PointsAt;
use subcert::exact::Rational;
use subcert::limit::{Parametrisation, natural_shift};
use subcert::report::parameters;
use subcert::scheme::Mask;

/// The parameters of the points, for each direction.
#[derive(Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Place {
    /// The offset of each direction.
    offsets: Vec<i64>,
    /// s for each direction.
    pub(super) shifts: Vec<Text<Rational>>,
    /// Along each direction, whether the scheme takes lines to lines. If so, lines stay where they
    /// are in the natural shift; if not, this shift is the best in the mean.
    keeps_lines: Vec<bool>,
    /// Whether a shift is rounded.
    #[serde(skip)]
    rounded: bool,
    #[serde(skip)]
    arities: Vec<usize>,
    #[serde(skip)]
    parametrisation: Parametrisation,
}

impl Place {
    pub(super) fn of(
        masks: &[&Mask],
        parametrisation: Parametrisation,
        shifts: Vec<Rational>,
    ) -> Place {
        let natural: Vec<_> = masks.iter().map(|mask| natural_shift(mask)).collect();
        Place {
            parametrisation,
            offsets: masks.iter().map(|mask| mask.offset()).collect(),
            shifts: shifts.into_iter().map(Text).collect(),
            keeps_lines: natural.iter().map(|natural| natural.keeps_lines).collect(),
            rounded: natural.iter().any(|natural| natural.rounded),
            arities: masks.iter().map(|mask| mask.arity()).collect(),
        }
    }

    /// The control data that the depth is about, in words.
    pub(super) fn whom(&self) -> &'static str {
        if self.arities.len() == 1 { "every control polygon" } else { "every control net" }
    }

    /// `(i − 1/2)/2^k`.
    pub(super) fn parameters(&self) -> String {
        let at = |(Text(shift), arity): (&Text<Rational>, &usize)| PointsAt {
            arity: *arity,
            shift: shift.clone(),
        };
        parameters(&self.shifts.iter().zip(&self.arities).map(at).collect::<Vec<PointsAt>>())
    }

    /// `(i − 1/2)/2^k, where lines stay where they are`.
    pub(super) fn text(&self) -> String {
        let why = match self.parametrisation {
            Parametrisation::Indexed => "as papers do",
            Parametrisation::Natural if self.keeps_lines.iter().all(|keeps| *keeps) => {
                "where lines stay where they are"
            }
            Parametrisation::Natural if self.rounded => {
                "the best place in the mean, rounded with an error below 1/2000: the scheme does \
                 not take lines to lines"
            }
            Parametrisation::Natural => {
                "the best place in the mean: the scheme does not take lines to lines"
            }
        };
        format!("{}, {why}", self.parameters())
    }
}
