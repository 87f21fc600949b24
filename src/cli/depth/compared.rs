//! The depth in one parametrisation: for all control data of a spread, and for one polygon.

use super::exact::{Asked, Exactly};
use super::points::Points;
use super::polygon::OfPolygon;
use crate::cli::console::answer::OrNone;
use crate::cli::console::output::Failure;
use subcert::bound::Budget;
use subcert::limit::{Distances, Limit, LimitError, Parametrisation};
use subcert::scheme::{Mask, Scheme};

/// The depth in one parametrisation, or why no limit is shown to exist.
#[derive(Clone)]
pub(super) struct Compared {
    pub(super) exact: OrNone<Exactly>,
    /// That of the control polygon, if one was given.
    pub(super) polygon: Option<OrNone<OfPolygon>>,
}

impl Compared {
    /// Finds the depth in one parametrisation: `budgets` has one for all control data, and one
    /// more for the polygon, if there is one.
    pub(super) fn of(
        scheme: &Scheme,
        parametrisation: Parametrisation,
        points: Option<&Points>,
        asked: &Asked<'_>,
        budgets: &[Budget],
    ) -> Result<Compared, Failure> {
        let mask = match scheme {
            Scheme::Curve(mask) => mask,
            Scheme::Tensor(first, second) => {
                let masks = [first, second];
                let exact = Exactly::of_surface(masks, parametrisation, asked, &budgets[0]);
                return Ok(Compared { exact: exact.into(), polygon: None });
            }
        };
        let distances = match distances(mask, parametrisation) {
            Ok(distances) => distances,
            Err(error) => {
                let polygon = points.map(|_| Err(&error).into());
                return Ok(Compared { exact: Err(error).into(), polygon });
            }
        };
        let all = distances.clone().with_budget(budgets[0].clone());
        let exact = Exactly::of(mask, parametrisation, &all, asked);
        let own = |points: &Points| {
            let distances = distances.clone().with_budget(budgets[1].clone());
            match OfPolygon::of(&distances, points, asked.tolerance, asked.width) {
                Err(error @ LimitError::TooFew { .. }) => {
                    Err(Failure::Input(format!("--polygon: {error}")))
                }
                own => Ok(own.into()),
            }
        };
        let polygon = points.map(own).transpose()?;
        Ok(Compared { exact: exact.into(), polygon })
    }
}

/// The steps that the exact distances of one command may take.
pub(super) const MAX_STEPS: u64 = 1_000_000_000;

fn distances(mask: &Mask, parametrisation: Parametrisation) -> Result<Distances, LimitError> {
    let distances = Distances::placed(&Limit::new(mask)?, parametrisation)?;
    Ok(distances.with_cells(u32::MAX))
}
