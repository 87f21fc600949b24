//! The sound bound of a printed depth against the level.

use super::level_chart::{LevelChart, Line};
use crate::audit::DepthLevels;
use crate::exact::{Rational, format::short};
use crate::float::nearest;
use maud::Markup;

/// Levels, and constants of so many levels; `None` where a value is 0.
pub(crate) fn levels(found: &DepthLevels, locus: &str) -> Option<Markup> {
    let DepthLevels { tolerance, printed, sound, bounds, constants } = found;
    let places = |values: &[Rational]| -> Vec<(u32, f64)> {
        (0..).zip(values.iter().take(bounds.len()).map(nearest)).collect()
    };
    let says = format!(
        "{locus}: the sound bound of the distance against the level, and the constants of c levels, on a \
         logarithmic scale. The bound meets ε = {} from level {sound} on; level {printed} is printed.",
        short(tolerance, 6)
    );
    let line = |name: &str, class, values, ring: Option<u32>| Line {
        name: name.to_owned(),
        class,
        is_dashed: ring.is_none(),
        values: places(values),
        ring,
    };
    let lines = vec![
        line("constants", "c2", constants, None),
        line("sound bound", "c1", bounds, Some(*sound)),
    ];
    LevelChart {
        title: "Sound bound against the level".to_owned(),
        says,
        tolerance: nearest(tolerance),
        lines,
        promised: vec![(*printed, format!("printed {printed}"))],
    }
    .drawn()
}
