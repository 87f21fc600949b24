//! The depth by the sound bound, and as papers compute it.

use super::numbers::levels;
use crate::cli::json::depth as form;
use subcert::bound::{
    ClassCap, Constants, DepthError, Operator, Order, SoundBound, SoundDepth, Terms, displacement,
    least_level, levels_within, surface_displacement,
};
use subcert::exact::{Rational, format::short};
use subcert::float::nearest;
use subcert::report::html::LevelLine;
use subcert::report::{Grid, json::Exact};

/// The most residue classes for which the sound bound takes longer blocks than were asked for, and the most products of
/// words of their visit.
const SOUND_CLASSES: u64 = 1 << 12;
const SOUND_WORK: u64 = 1 << 27;

/// The products of words that all constants of one command may take.
pub(super) const MAX_NORM_STEPS: u64 = 4_000_000_000;

/// How many levels after the last one of interest a picture shows, and how many at most.
const AFTER: u32 = 1;
const MAX_LEVELS: u32 = 60;

type Depth = Result<u32, DepthError>;

pub(super) struct Bounds {
    bound: SoundBound,
    sound: Result<SoundDepth, DepthError>,
    /// For each c: the constant as papers print it, and the depth it gives.
    printed: Vec<(Rational, Depth)>,
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
            Ok((constant, depth))
        });
        let printed = printed.collect::<Result<Vec<_>, ClassCap>>()?;
        Ok(Bounds { sound: bound.depth(spread, tolerance), bound, printed })
    }

    /// The sound bound against the level, and the constants, up to `last` and to where the bound meets the tolerance;
    /// and what the formula of papers promises.
    pub(super) fn lines(
        &self,
        spread: &Rational,
        last: u32,
    ) -> (Vec<LevelLine>, Vec<(u32, String)>) {
        let met = self.sound.as_ref().ok().map(|depth| depth.level);
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
        let printed = self.printed.iter().filter_map(|(_, depth)| depth.as_ref().ok()).min();
        let promised = printed.map(|level| (*level, "by the printed formula".to_owned()));
        (vec![bound, constants], promised.into_iter().collect())
    }

    pub(super) fn facts(&self) -> Vec<(String, String)> {
        let sound = match &self.sound {
            Ok(depth) => format!("{}, with c = {}", levels(depth.level), depth.block),
            Err(error) => format!("none: {error}"),
        };
        let depths = (1..).zip(&self.printed).filter_map(|(c, (_, depth)): (u32, _)| {
            let depth = depth.as_ref().ok()?;
            Some((*depth, c))
        });
        let printed = depths.min().map(|(depth, c)| format!("{}, with c = {c}", levels(depth)));
        vec![
            ("depth by the sound bound".to_owned(), sound),
            ("by the printed formula".to_owned(), printed.unwrap_or_else(|| "none".to_owned())),
        ]
    }

    pub(super) fn grid(&self) -> Grid {
        let header = ["c", "constant as printed", "depth by the printed formula"];
        let header = header.map(str::to_owned).to_vec();
        let rows = (1..).zip(&self.printed).map(|(c, (constant, depth)): (u32, _)| {
            let depth = match depth {
                Ok(level) => level.to_string(),
                Err(error) => error.to_string(),
            };
            vec![c.to_string(), short(constant, 8), depth]
        });
        Grid { header, rows: rows.collect(), left_columns: 0 }
    }

    pub(super) fn sound_form(&self) -> form::Sound {
        let (found, error) = (self.sound.as_ref().ok(), self.sound.as_ref().err());
        form::Sound {
            depth: found.map(|depth| depth.level),
            block: found.map(|depth| depth.block),
            note: error.map(ToString::to_string),
        }
    }

    pub(super) fn printed_forms(&self) -> Vec<form::Printed> {
        let printed =
            (1..).zip(&self.printed).map(|(c, (constant, depth)): (u32, _)| form::Printed {
                c,
                constant: Exact::of(constant),
                depth: depth.as_ref().ok().copied(),
                note: depth.as_ref().err().map(ToString::to_string),
            });
        printed.collect()
    }
}
