//! The answers in one parametrisation: for all control data of a spread, and for one polygon.

use super::exact::{Asked, Exact};
use super::polygon::{OfPolygon, Points};
use crate::cli::console::output::Failure;
use subcert::bound::Budget;
use subcert::limit::{Distances, Limit, LimitError, Parametrisation};
use subcert::scheme::{Mask, Scheme};

/// The answers in one parametrisation; the error says why no limit is shown to exist.
pub(super) struct Answer {
    pub(super) exact: Result<Exact, String>,
    /// The answer for the control polygon, if one was given.
    pub(super) polygon: Option<Result<OfPolygon, String>>,
}

impl Answer {
    /// Finds the answer in one parametrisation: `budgets` has one for all control data, and one
    /// more for the polygon, if there is one.
    pub(super) fn of(
        scheme: &Scheme,
        parametrisation: Parametrisation,
        points: Option<&Points>,
        asked: &Asked<'_>,
        budgets: &[Budget],
    ) -> Result<Answer, Failure> {
        let mask = match scheme {
            Scheme::Curve(mask) => mask,
            Scheme::Tensor(first, second) => {
                let masks = [first, second];
                let exact = Exact::of_surface(masks, parametrisation, asked, &budgets[0]);
                return Ok(Answer { exact: exact.map_err(|e| e.to_string()), polygon: None });
            }
        };
        let distances = match distances(mask, parametrisation) {
            Ok(distances) => distances,
            Err(error) => {
                let why = Err(error.to_string());
                let polygon = points.map(|_| Err(error.to_string()));
                return Ok(Answer { exact: why, polygon });
            }
        };
        let all = distances.clone().with_budget(budgets[0].clone());
        let exact = Exact::of(mask, parametrisation, &all, asked);
        let own = |points: &Points| {
            let distances = distances.clone().with_budget(budgets[1].clone());
            match OfPolygon::of(&distances, points, asked.tolerance, asked.width) {
                Err(error @ LimitError::TooFew { .. }) => {
                    Err(Failure::Input(format!("--polygon: {error}")))
                }
                own => Ok(own.map_err(|error| error.to_string())),
            }
        };
        let polygon = points.map(own).transpose()?;
        Ok(Answer { exact: exact.map_err(|error| error.to_string()), polygon })
    }
}

/// The steps that the exact distances of one command may take.
pub(super) const MAX_STEPS: u64 = 1_000_000_000;

fn distances(mask: &Mask, parametrisation: Parametrisation) -> Result<Distances, LimitError> {
    let distances = Distances::placed(&Limit::new(mask)?, parametrisation)?;
    Ok(distances.with_cells(u32::MAX))
}
