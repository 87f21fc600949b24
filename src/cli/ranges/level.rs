//! Where the differences contract in c levels, and T_c as a function.

use super::sets::Set;
use serde::Serialize;
use subcert::exact::{PiecewisePolynomial, RealAlgebraic};
use subcert::report::json::RootNumber;
use subcert::report::{Grid, number};

/// Where T_c < 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Level {
    /// c.
    pub(crate) c: u32,
    /// The set.
    pub(crate) intervals: Set,
    /// T_c as a function of the parameter; null where it was not asked for.
    pub(crate) function: Option<Function>,
}

/// A piecewise polynomial function.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Function {
    /// Where one piece ends and the next begins.
    breaks: Vec<RootNumber>,
    /// The polynomials, one more than there are breaks.
    pieces: Vec<String>,
    /// The same numbers.
    #[serde(skip)]
    pub(crate) places: Vec<RealAlgebraic>,
}

impl Function {
    pub(crate) fn of(function: &PiecewisePolynomial, parameter: &str) -> Function {
        let places = function.breakpoints();
        Function {
            breaks: places.iter().map(|place| RootNumber::of(place, parameter)).collect(),
            pieces: function.pieces().iter().map(|piece| piece.describe(parameter)).collect(),
            places: places.to_vec(),
        }
    }

    pub(crate) fn grid(&self) -> Grid {
        let text = |place: Option<&RealAlgebraic>| place.map_or_else(String::new, number);
        let row = |(i, piece): (usize, &String)| {
            let low = i.checked_sub(1).map(|below| &self.places[below]);
            vec![text(low), text(self.places.get(i)), piece.clone()]
        };
        let header = ["from".to_owned(), "to".to_owned(), "T_c".to_owned()].to_vec();
        Grid::of(header, self.pieces.iter().enumerate().map(row), 3)
    }
}
