//! `subcert constants`.

use super::Outcome;
use super::arguments::ConstantsArguments;
use super::output::{Failure, show, with_decimal};
use super::ring_constants::ring_constants;
use serde_json::{Value, json};
use subcert::bound::{
    ClassCap, Constants, DeltaCondition, Operator, Order, Terms, best_offset, displacement,
    surface_factor,
};
use subcert::exact::{Rational, format::short};
use subcert::report::{Grid, Sheet, exact_json};
use subcert::scheme::{AnyScheme, Mask, Rules, Scheme, parse_any_scheme};

pub(super) fn constants(arguments: &ConstantsArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::Ring(ring) => return ring_constants(&ring, arguments),
    };
    let levels = arguments.block.levels;
    let report = Report::of(&scheme, levels).map_err(|e| Failure::Input(e.to_string()))?;
    let name = &arguments.scheme;
    show(arguments.output.format, || report.sheet(name), || report.json(name))
}

/// The constants of a scheme, computed once for every format.
struct Report {
    directions: Vec<Direction>,
    surface: Option<Surface>,
}

/// A tensor product: the factor, δ, and C_c for each c.
struct Surface {
    factor: Rational,
    delta: DeltaCondition,
    constants: Vec<Rational>,
}

struct Direction {
    delta: DeltaCondition,
    mask: Mask,
    difference: Rules,
    /// For each c = 1, 2, …: T_c and Λ_c in adjoint and in forward order.
    rows: Vec<[Rational; 4]>,
    sigma: Vec<(String, Rational)>,
}

impl Report {
    fn of(scheme: &Scheme, levels: u32) -> Result<Report, ClassCap> {
        for mask in scheme.masks() {
            ClassCap::check(mask.arity(), levels)?;
        }
        let constants: Vec<Constants> =
            scheme.masks().into_iter().cloned().map(Constants::new).collect();
        let directions = constants
            .iter()
            .map(|one| Direction::of(one, levels))
            .collect::<Result<Vec<_>, _>>()?;
        let surface = match &constants[..] {
            [first, second] => {
                let factor = surface_factor(first.mask(), second.mask());
                let row = |c| Ok(first.tensor_with(second, c)?.max(second.tensor_with(first, c)?));
                let delta = DeltaCondition::surface(first, second)?;
                let constants = (1..=levels).map(row).collect::<Result<Vec<_>, _>>()?;
                Some(Surface { factor, delta, constants })
            }
            _ => None,
        };
        Ok(Report { directions, surface })
    }
}

impl Direction {
    fn of(constants: &Constants, levels: u32) -> Result<Direction, ClassCap> {
        let row = |c| {
            Ok([
                constants.norm(Operator::Difference, c, Order::Adjoint)?,
                constants.norm(Operator::Scheme, c, Order::Adjoint)?,
                constants.norm(Operator::Difference, c, Order::Forward)?,
                constants.norm(Operator::Scheme, c, Order::Forward)?,
            ])
        };
        let mask = constants.mask().clone();
        let (best, least) = best_offset(&mask);
        let own = mask.offset();
        let unshifted = mask.with_offset(0);
        let sigma = vec![
            (format!("σ at the scheme's offset {own}"), displacement(&mask, Terms::Each)),
            (format!("σ at the best offset {best}"), least),
            ("σ at offset 0".to_owned(), displacement(&unshifted, Terms::Each)),
            ("|Σ| in place of σ at offset 0".to_owned(), displacement(&unshifted, Terms::Total)),
        ];
        let difference = constants.difference().clone();
        let rows = (1..=levels).map(row).collect::<Result<Vec<_>, _>>()?;
        let delta = DeltaCondition::curve(constants)?;
        Ok(Direction { delta, mask, difference, rows, sigma })
    }
}

impl Report {
    fn sheet(&self, name: &str) -> Sheet {
        let mut sheet = Sheet::default();
        sheet.heading(1, name);
        for (i, direction) in self.directions.iter().enumerate() {
            if self.directions.len() > 1 {
                sheet.heading(2, format!("Direction {}", i + 1));
            }
            direction.write(&mut sheet);
        }
        if let Some(Surface { factor, delta, constants }) = &self.surface {
            sheet.heading(2, "Tensor product");
            let mut facts = vec![
                ("factor σ of the surface".to_owned(), with_decimal(factor)),
                ("δ = T_1·Λ_1".to_owned(), delta_text(delta)),
            ];
            facts.extend(
                (1..)
                    .zip(constants)
                    .map(|(c, constant)| (format!("T_{c}·Λ_{c}"), with_decimal(constant))),
            );
            sheet.facts(facts);
        }
        sheet
    }

    fn json(&self, name: &str) -> Value {
        let surface = self.surface.as_ref().map(|Surface { factor, delta, constants }| {
            json!({
                "factor": exact_json(factor),
                "delta": delta_json(delta),
                "constants": constants.iter().map(exact_json).collect::<Vec<Value>>(),
            })
        });
        json!({
            "schema": 1,
            "scheme": name,
            "directions": self.directions.iter().map(Direction::json).collect::<Vec<Value>>(),
            "surface": surface,
        })
    }
}

fn delta_text(condition: &DeltaCondition) -> String {
    let holds = if condition.holds() { "< 1: one level contracts" } else { "not < 1" };
    format!("{}, {holds}", with_decimal(&condition.delta))
}

fn delta_json(condition: &DeltaCondition) -> Value {
    let mut value = exact_json(&condition.delta);
    value["holds"] = json!(condition.holds());
    value
}

fn rows_json(rows: &[Vec<Rational>]) -> Vec<Vec<String>> {
    rows.iter().map(|row| row.iter().map(Rational::to_string).collect()).collect()
}

impl Direction {
    fn write(&self, sheet: &mut Sheet) {
        let mut facts = vec![
            ("arity n".to_owned(), self.mask.arity().to_string()),
            ("mask".to_owned(), rules_text(self.mask.rules().rows())),
            ("difference mask".to_owned(), rules_text(self.difference.rows())),
        ];
        facts.push(("δ = T_1".to_owned(), delta_text(&self.delta)));
        facts.extend(self.sigma.iter().map(|(name, value)| (name.clone(), with_decimal(value))));
        sheet.facts(facts);
        let header = ["c", "T_c", "Λ_c", "T_c forward", "Λ_c forward"].map(str::to_owned).to_vec();
        let rows = (1..).zip(&self.rows).map(|(c, row): (u32, _)| {
            std::iter::once(c.to_string()).chain(row.iter().map(|x| short(x, 10))).collect()
        });
        sheet.grid(Grid { header, rows: rows.collect(), left_columns: 0 });
        sheet.text(
            "T_c bounds the differences after c levels; the forward columns are what papers that \
             read the masks forwards compute, and bound nothing.",
        );
    }

    fn json(&self) -> Value {
        let rows = (1..).zip(&self.rows).map(|(c, row): (u32, _)| {
            json!({
                "c": c,
                "contraction": exact_json(&row[0]),
                "norm": exact_json(&row[1]),
                "contraction_forward": exact_json(&row[2]),
                "norm_forward": exact_json(&row[3]),
            })
        });
        let sigma = self.sigma.iter().map(|(name, value)| {
            let mut entry = exact_json(value);
            entry["name"] = json!(name);
            entry
        });
        json!({
            "arity": self.mask.arity(),
            "width": self.mask.width(),
            "offset": self.mask.offset(),
            "mask": rows_json(self.mask.rules().rows()),
            "difference": rows_json(self.difference.rows()),
            "delta": delta_json(&self.delta),
            "displacement": sigma.collect::<Vec<Value>>(),
            "levels": rows.collect::<Vec<Value>>(),
        })
    }
}

fn rules_text(rows: &[Vec<Rational>]) -> String {
    let row = |row: &Vec<Rational>| {
        row.iter().map(Rational::to_string).collect::<Vec<String>>().join("  ")
    };
    rows.iter().map(row).collect::<Vec<String>>().join("\n")
}
