//! The depth by the sound bound, and as papers compute it.

use crate::cli::json::depth as form;
use subcert::bound::{
    ClassCap, Constants, DepthError, Operator, Order, SoundBound, SoundDepth, Terms, displacement,
    least_level, surface_displacement,
};
use subcert::exact::{Rational, format::short};
use subcert::report::{Grid, json::Exact};

/// The most residue classes for which the sound bound takes longer blocks than were asked for.
const SOUND_CLASSES: u64 = 1 << 12;

type Depth = Result<u32, DepthError>;

pub(super) struct Bounds {
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
        Ok(Bounds { sound: bound.depth(spread, tolerance), printed })
    }

    pub(super) fn facts(&self) -> Vec<(String, String)> {
        let sound = match &self.sound {
            Ok(depth) => format!("{} levels, by blocks of {}", depth.level, depth.block),
            Err(error) => format!("none: {error}"),
        };
        let depths = (1..).zip(&self.printed).filter_map(|(c, (_, depth)): (u32, _)| {
            let depth = depth.as_ref().ok()?;
            Some((*depth, c))
        });
        let printed = depths.min().map(|(depth, c)| format!("{depth} levels, with c = {c}"));
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
