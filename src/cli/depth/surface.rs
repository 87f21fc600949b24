//! The true depth of tensor product surfaces, for every control net of a spread.

use super::distance::{Distance, Interval};
use super::exact::{Asked, Exactly, Witness};
use super::place::Place;
use crate::cli::console::quantity::Text;
use subcert::audit::{Attained, Control, Place as AttainedAt};
use subcert::bound::Budget;
use subcert::limit::{
    Comparison, Limit, Parametrisation, Spreads, SurfaceDistances, SurfaceError, SurfaceWitness,
};
use subcert::scheme::Mask;

impl Exactly {
    /// β is the largest difference along either direction.
    pub(super) fn of_surface(
        masks: [&Mask; 2],
        parametrisation: Parametrisation,
        asked: &Asked<'_>,
        budget: &Budget,
    ) -> Result<Exactly, SurfaceError> {
        let spreads = Spreads::new(asked.spread, asked.spread)?;
        let [first, second] = [Limit::new(masks[0])?, Limit::new(masks[1])?];
        let distances = SurfaceDistances::placed(&first, &second, parametrisation, budget)?;
        let depth = distances.depth(&spreads, asked.tolerance)?;
        let (enclosure, _) = distances.constant(depth.upper, asked.width, &spreads)?;
        let within_width = enclosure.width() <= *asked.width;
        let interval = Interval(enclosure);
        let distance = Distance { interval, level: depth.upper, within_width, parameter: None };
        let below = depth.lower.checked_sub(1);
        let below = below.map(|level| distances.compare(level, asked.tolerance, &spreads));
        let (witness, attained) = match below.transpose()? {
            Some(Comparison::Exceeds(found)) => {
                let SurfaceWitness { first, net, unit, level, parameters, distance } = found;
                let witness = Witness::Net {
                    level,
                    first,
                    net: net.clone(),
                    times: Text(unit.clone()),
                    parameters: parameters.clone().map(Text),
                    distance: (&distance).into(),
                };
                let control = Control::Net { first, rows: net };
                let (place, value) =
                    (AttainedAt::Parameters(parameters), (&distance / &unit).into());
                (Some(witness), Some(Attained { control, place, value }))
            }
            Some(Comparison::Within | Comparison::Undecided(_)) | None => (None, None),
        };
        let shifts = distances.shifts().map(Clone::clone).to_vec();
        Ok(Exactly {
            place: Place::of(&masks, parametrisation, shifts),
            depth: depth.into(),
            distance,
            witness,
            attained,
            levels: Vec::new(),
            caps: distances.caps(),
        })
    }
}
