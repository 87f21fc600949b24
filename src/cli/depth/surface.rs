//! The true depth of tensor product surfaces, for every control net of a spread.

use super::exact::{Asked, Exact, Known, TooFar, points_text};
use super::place::Place;
use crate::cli::json::depth as form;
use subcert::audit::{Attained, Control, Place as AttainedAt};
use subcert::bound::Budget;
use subcert::exact::format::short;
use subcert::limit::{
    Comparison, Limit, Parametrisation, Spreads, SurfaceDistances, SurfaceError, SurfaceWitness,
};
use subcert::report::json::Exact as ExactForm;
use subcert::scheme::Mask;

/// The most rows of a net that are shown in a text.
const MAX_SHOWN_ROWS: usize = 6;

impl Exact {
    /// β is the largest difference along either direction.
    pub(super) fn of_surface(
        masks: [&Mask; 2],
        parametrisation: Parametrisation,
        asked: &Asked<'_>,
        budget: &Budget,
    ) -> Result<Exact, SurfaceError> {
        let spreads = Spreads::new(asked.spread, asked.spread)?;
        let [first, second] = [Limit::new(masks[0])?, Limit::new(masks[1])?];
        let distances = SurfaceDistances::placed(&first, &second, parametrisation, budget)?;
        let depth = distances.depth(&spreads, asked.tolerance)?;
        let (enclosure, _) = distances.constant(depth.upper, asked.width, &spreads)?;
        let narrow = enclosure.width() <= *asked.width;
        let too_far = match depth.lower.checked_sub(1) {
            None => None,
            Some(level) => match distances.compare(level, asked.tolerance, &spreads)? {
                Comparison::Exceeds(witness) => Some(too_far(&witness)),
                Comparison::Within | Comparison::Undecided(_) => None,
            },
        };
        let distance = Known { enclosure, narrow, parameter: None };
        let shifts = distances.shifts().map(Clone::clone).to_vec();
        let place = Place::of(&masks, parametrisation, shifts);
        Ok(Exact { place, depth, distance, too_far, levels: Vec::new(), caps: distances.caps() })
    }
}

fn too_far(witness: &SurfaceWitness) -> TooFar {
    let SurfaceWitness { first: [i, j], net, unit, level, parameters: [s, t], distance } = witness;
    let rows = net.iter().take(MAX_SHOWN_ROWS).map(|row| points_text(row));
    let more = if net.len() > MAX_SHOWN_ROWS { " / … (all in --format json)" } else { "" };
    let text = format!(
        "β times {}{more}, from index ({i}, {j}): {} from its limit at ({s}, {t})",
        rows.collect::<Vec<String>>().join(" / "),
        short(distance, 9)
    );
    let form = form::Witness::Net {
        level: *level,
        first: [*i, *j],
        net: net.clone(),
        times: unit.to_string(),
        parameters: [s.to_string(), t.to_string()],
        distance: ExactForm::of(distance),
    };
    let attained = Attained {
        control: Control::Net { first: [*i, *j], rows: net.clone() },
        place: AttainedAt::Parameters([s.clone(), t.clone()]),
        value: (distance / unit).into(),
    };
    TooFar { level: *level, text, form, attained }
}
