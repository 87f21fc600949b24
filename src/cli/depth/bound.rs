//! The depth by the sound bound, and as papers compute it.

use super::numbers::levels;
use crate::cli::console::quantity::Number;
use serde::Serialize;
use subcert::bound::{
    ClassCap, Constants, DepthError, Operator, Order, SoundBound, Terms, displacement, least_level,
    levels_within, surface_displacement,
};
use subcert::exact::{Rational, format::short};
use subcert::float::nearest;
use subcert::report::Grid;
use subcert::report::html::LevelLine;

/// The most residue classes for which the sound bound takes longer blocks than were asked for, and the most products of
/// words of their visit.
const SOUND_CLASSES: u64 = 1 << 12;
const SOUND_WORK: u64 = 1 << 27;

/// The products of words that all constants of one command may take.
pub(super) const MAX_NORM_STEPS: u64 = 4_000_000_000;

/// How many levels after the last one of interest a picture shows, and how many at most.
const AFTER: u32 = 1;
const MAX_LEVELS: u32 = 60;

/// What bounds promise.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Bounds {
    /// The depth by the sound bound.
    sound: Sound,
    /// The depths that papers compute.
    printed_formula: Vec<Printed>,
    #[serde(skip)]
    bound: SoundBound,
}

/// The depth by the sound bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Sound {
    /// The depth; null where there is none.
    depth: Option<u32>,
    /// The block length of the bound; missing where there is no depth.
    #[serde(skip_serializing_if = "Option::is_none")]
    block: Option<u32>,
    /// Why there is no depth; missing where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
}

/// The depth by the printed formula.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Printed {
    /// The block length c.
    c: u32,
    /// The constant as papers print it.
    constant: Number,
    /// The depth.
    depth: Option<u32>,
    /// Why there is none.
    note: Option<String>,
}

impl Bounds {
    /// The printed formula for blocks of up to `levels`, and the sound bound for blocks of up to
    /// `levels` or, if more, as many levels as are quickly computed.
    pub(super) fn of(
        constants: &[Constants],
        levels: u32,
        tolerance: &Rational,
        spread: &Rational,
    ) -> Result<Bounds, ClassCap> {
        let mut longest = u32::MAX;
        for one in constants {
            let arity = one.mask().arity();
            longest = longest.min(SOUND_CLASSES.ilog(arity as u64));
            longest = longest.min(levels_within(one.difference(), SOUND_WORK));
        }
        let block = longest.max(levels);
        let first = &constants[0];
        let bound = match constants {
            [first, second] => SoundBound::surface(first, second, block)?,
            _ => SoundBound::curve(first, block)?,
        };
        let factor = match constants {
            [_, _] => surface_displacement(first.mask(), [spread; 3], Terms::Total),
            _ => displacement(&first.mask().with_offset(0), Terms::Total) * spread,
        };
        let constant = |c| match constants {
            [first, second] => first.tensor_with(second, c),
            _ => first.norm(Operator::Difference, c, Order::Forward),
        };
        let one = Rational::one();
        let printed = (1..=levels).map(|c| {
            let constant = constant(c)?;
            let depth = if constant < one {
                least_level(&(&factor / (&one - &constant)), &constant, tolerance)
            } else {
                Err(DepthError::NoContraction(short(&constant, 6)))
            };
            let note = depth.as_ref().err().map(ToString::to_string);
            Ok(Printed { c, constant: (&constant).into(), depth: depth.ok(), note })
        });
        let printed_formula = printed.collect::<Result<Vec<_>, ClassCap>>()?;
        let sound = match bound.depth(spread, tolerance) {
            Ok(found) => Sound { depth: Some(found.level), block: Some(found.block), note: None },
            Err(why) => Sound { depth: None, block: None, note: Some(why.to_string()) },
        };
        Ok(Bounds { sound, printed_formula, bound })
    }

    /// The sound bound against the level, and the constants, up to `last` and to where the bound meets the tolerance;
    /// and what the formula of papers promises.
    pub(super) fn lines(
        &self,
        spread: &Rational,
        last: u32,
    ) -> (Vec<LevelLine>, Vec<(u32, String)>) {
        let met = self.sound.depth;
        let last = met.unwrap_or(0).max(last).saturating_add(AFTER).min(MAX_LEVELS);
        let bounds = self.bound.levels(last).unwrap_or_default();
        let bounds = bounds.iter().map(|bound| nearest(&(bound * spread)));
        let constants = self.bound.constants().iter().take(last as usize + 1).map(nearest);
        let line = |name: &str, values: Vec<f64>, met, is_constant| LevelLine {
            name: name.to_owned(),
            values: (0..).zip(values).collect(),
            met,
            is_constant,
        };
        let bound = line("sound bound", bounds.collect(), met, false);
        let constants = line("constants", constants.collect(), None, true);
        let printed = self.printed_formula.iter().filter_map(|printed| printed.depth).min();
        let promised = printed.map(|level| (level, "by the printed formula".to_owned()));
        (vec![bound, constants], promised.into_iter().collect())
    }

    pub(super) fn facts(&self) -> Vec<(String, String)> {
        let sound = match &self.sound {
            Sound { depth: Some(depth), block: Some(block), .. } => {
                format!("{}, with c = {block}", levels(*depth))
            }
            Sound { note, .. } => format!("none: {}", note.as_deref().unwrap_or_default()),
        };
        let none = || {
            let note = self.printed_formula.iter().find_map(|one| one.note.as_deref());
            format!("none: {}", note.unwrap_or_default())
        };
        let depths = self.printed_formula.iter().filter_map(|one| Some((one.depth?, one.c)));
        let printed = depths.min().map(|(depth, c)| format!("{}, with c = {c}", levels(depth)));
        vec![
            ("depth by the sound bound".to_owned(), sound),
            ("by the printed formula".to_owned(), printed.unwrap_or_else(none)),
        ]
    }

    pub(super) fn grid(&self) -> Grid {
        let header = ["c", "constant as printed", "depth by the printed formula"];
        let rows = self.printed_formula.iter().map(|Printed { c, constant, depth, note }| {
            let depth = depth.map_or_else(|| note.clone().unwrap_or_default(), |n| n.to_string());
            vec![c.to_string(), constant.short(8), depth]
        });
        Grid::of(header, rows, 0)
    }
}
