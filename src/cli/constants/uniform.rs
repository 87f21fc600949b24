//! `subcert constants`.

use super::columns::Wanted;
use super::delta::{Delta, number_row};
use super::direction::{Direction, Level};
use super::lattice::lattice_constants;
use super::offset::BetterOffset;
use super::ring::local_constants;
use crate::cli::arguments::{ConstantsArguments, Format};
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::Number;
use serde::Serialize;
use subcert::bound::{self, ClassCap, DeltaCondition, surface_factor};
use subcert::report::{Grid, Sheet};
use subcert::scheme::{AnyScheme, Scheme, parse_any_scheme};

pub(crate) fn constants(arguments: &ConstantsArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::Lattice(mask) => return lattice_constants(&mask, arguments),
        AnyScheme::LocalRules(_) if arguments.forward => {
            let problem = "--forward: the rules of a ring have no order; leave it out";
            return Err(Failure::Input(problem.to_owned()));
        }
        AnyScheme::LocalRules(ring) => return local_constants(&ring, arguments),
    };
    let wanted = Wanted {
        levels: arguments.block.levels,
        forward: arguments.forward,
        progress: arguments.output.format != Format::Json,
    };
    let name = &arguments.scheme;
    let mut answer =
        Constants::of(name, &scheme, &wanted).map_err(|e| Failure::Input(e.to_string()))?;
    answer.better_offsets = BetterOffset::all_of(name, &scheme)?;
    show(&arguments.output, &answer)
}

/// The constants of a mask, or of a tensor product of two.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Constants<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The masks.
    directions: Vec<Direction>,
    /// The tensor product; null of a curve.
    surface: Option<Surface>,
    /// The better offsets of files that state none; missing where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    better_offsets: Vec<BetterOffset>,
}

/// The constants of a tensor product.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Surface {
    /// The factor σ of the surface.
    factor: Number,
    /// δ = T_1·Λ_1.
    delta: Delta,
    /// T_c·Λ_c for c = 1, 2, …
    constants: Vec<Number>,
}

impl<'a> Constants<'a> {
    fn of(name: &'a str, scheme: &Scheme, wanted: &Wanted) -> Result<Constants<'a>, ClassCap> {
        let constants: Vec<bound::Constants> =
            scheme.masks().into_iter().cloned().map(bound::Constants::new).collect();
        let directions = constants
            .iter()
            .map(|one| Direction::of(one, wanted))
            .collect::<Result<Vec<Direction>, ClassCap>>()?;
        let surface = match (&constants[..], &directions[..]) {
            ([first, second], [u, v]) => {
                let product = |t: &Level, norm: &Level| match (&t.contraction, &norm.norm) {
                    (Some(Number::Rational(t)), Some(Number::Rational(norm))) => Some(t * norm),
                    _ => None,
                };
                let constant = |(u, v): (&Level, &Level)| {
                    Some(Number::Rational(product(u, v)?.max(product(v, u)?)))
                };
                Some(Surface {
                    factor: (&surface_factor(first.mask(), second.mask())).into(),
                    delta: Delta::of(&DeltaCondition::surface(first, second)?),
                    constants: u.levels.iter().zip(&v.levels).map_while(constant).collect(),
                })
            }
            _ => None,
        };
        Ok(Constants {
            schema: SCHEMA,
            scheme: name,
            directions,
            surface,
            better_offsets: Vec::new(),
        })
    }
}

impl Answer for Constants<'_> {
    const NAME: &'static str = "constants";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(self.scheme);
        for (i, direction) in self.directions.iter().enumerate() {
            if self.directions.len() > 1 {
                sheet.heading(2, format!("Direction {}", i + 1));
            }
            direction.write(&mut sheet);
        }
        if let Some(Surface { factor, delta, constants }) = &self.surface {
            sheet.heading(2, "Tensor product");
            let mut facts = vec![
                ("factor σ of the surface".to_owned(), factor.words()),
                ("δ = T_1·Λ_1".to_owned(), delta.words()),
            ];
            let constants = (1..).zip(constants);
            facts.extend(constants.map(|(c, value)| (format!("T_{c}·Λ_{c}"), value.words())));
            sheet.facts(facts);
        }
        self.better_offsets.iter().for_each(|better| sheet.text(better.words.clone()));
        sheet
    }

    /// One row for each number.
    fn grid(&self) -> Option<Grid> {
        let mut rows = Vec::new();
        for (number, direction) in (1_u32..).zip(&self.directions) {
            let number = &number.to_string();
            let sigma = direction.displacement.iter();
            rows.extend(sigma.map(|sigma| number_row(&[number, &sigma.name, ""], &sigma.value)));
            for level in &direction.levels {
                let c = &level.c.to_string();
                let found = level.values().filter_map(|(name, value)| Some((name, value?)));
                rows.extend(found.map(|(name, value)| number_row(&[number, name, c], value)));
            }
        }
        if let Some(Surface { factor, delta, constants }) = &self.surface {
            rows.push(number_row(&["surface", "factor", ""], factor));
            rows.push(number_row(&["surface", "delta", ""], &delta.value));
            rows.extend((1_u32..).zip(constants).map(|(c, value)| {
                number_row(&["surface", "contraction_norm", &c.to_string()], value)
            }));
        }
        let header = ["direction", "quantity", "c", "exact", "decimal"];
        Some(Grid::of(header, rows, 3))
    }
}
