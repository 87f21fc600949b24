//! `subcert depth`.

use super::Outcome;
use super::arguments::DepthArguments;
use super::output::{Failure, positive, show};
use serde_json::{Value, json};
use subcert::bound::{
    ClassCap, Constants, DepthError, Operator, Order, SoundBound, SoundDepth, Terms, displacement,
    least_level, surface_displacement,
};
use subcert::exact::{Rational, format::short};
use subcert::report::{Grid, Sheet};
use subcert::scheme::parse_scheme;

pub(super) fn depth(arguments: &DepthArguments) -> Outcome {
    let scheme = parse_scheme(&arguments.scheme)?;
    let tolerance = positive("--tolerance", &arguments.tolerance)?;
    let spread = positive("--spread", &arguments.spread.spread)?;
    let constants: Vec<Constants> =
        scheme.masks().into_iter().cloned().map(Constants::new).collect();
    let report = Report::of(&constants, arguments.block.levels, &tolerance, &spread)
        .map_err(|error| Failure::Input(error.to_string()))?;
    show(
        arguments.output.format,
        || report.sheet(arguments),
        || report.json(&arguments.scheme, &tolerance, &spread),
    )
}

type Depth = Result<u32, DepthError>;

struct Report {
    sound: Result<SoundDepth, DepthError>,
    /// For each c: the constant as papers print it, and the depth it gives.
    printed: Vec<(Rational, Depth)>,
}

impl Report {
    fn of(
        constants: &[Constants],
        levels: u32,
        tolerance: &Rational,
        spread: &Rational,
    ) -> Result<Report, ClassCap> {
        for one in constants {
            ClassCap::check(one.mask().arity(), levels)?;
        }
        let first = &constants[0];
        let bound = match constants {
            [first, second] => SoundBound::surface(first, second, levels)?,
            _ => SoundBound::curve(first, levels)?,
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
        Ok(Report { sound: bound.depth(spread, tolerance), printed })
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        sheet.heading(
            1,
            format!(
                "{}, ε = {}, β = {}",
                arguments.scheme, arguments.tolerance, arguments.spread.spread
            ),
        );
        let sound = match &self.sound {
            Ok(depth) => format!("{} levels, by blocks of {}", depth.level, depth.block),
            Err(error) => format!("none: {error}"),
        };
        sheet.facts(vec![("sound depth".to_owned(), sound)]);
        let header = ["c", "constant as printed", "depth by the printed formula"];
        let header = header.map(str::to_owned).to_vec();
        let rows = (1..).zip(&self.printed).map(|(c, (constant, depth)): (u32, _)| {
            let depth = match depth {
                Ok(level) => level.to_string(),
                Err(error) => error.to_string(),
            };
            vec![c.to_string(), short(constant, 8), depth]
        });
        sheet.grid(Grid { header, rows: rows.collect(), left_columns: 0 });
        sheet.text(
            "The sound depth meets the tolerance for every control polygon of this spread, at the \
             scheme's own offset. The printed formula, σβT^k/(1 − T) with one power of the \
             constant for each level, |Σ| in place of σ and offset 0, does not promise that.",
        );
        sheet
    }

    fn json(&self, name: &str, tolerance: &Rational, spread: &Rational) -> Value {
        let printed = (1..).zip(&self.printed).map(|(c, (constant, depth)): (u32, _)| {
            json!({
                "c": c,
                "constant": subcert::report::exact_json(constant),
                "depth": depth.as_ref().ok(),
                "note": depth.as_ref().err().map(ToString::to_string),
            })
        });
        let sound = match &self.sound {
            Ok(depth) => json!({ "depth": depth.level, "block": depth.block }),
            Err(error) => json!({ "depth": null, "note": error.to_string() }),
        };
        json!({
            "schema": 1,
            "scheme": name,
            "tolerance": tolerance.to_string(),
            "spread": spread.to_string(),
            "sound": sound,
            "printed_formula": printed.collect::<Vec<Value>>(),
        })
    }
}
