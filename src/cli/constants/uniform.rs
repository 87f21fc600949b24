//! `subcert constants`.

use super::columns::{Columns, Wanted, columns};
use super::offset::OfFile;
use super::ring::local_constants;
use crate::cli::arguments::{ConstantsArguments, Format};
use crate::cli::console::csv;
use crate::cli::console::output::{Failure, Outcome, show_table, with_decimal};
use crate::cli::json::{SCHEMA, constants as form};
use subcert::bound::{
    ClassCap, Constants, DeltaCondition, Terms, best_offset, displacement, surface_factor,
};
use subcert::exact::{Rational, format::short};
use subcert::limit::{NaturalShift, natural_shift};
use subcert::report::{Grid, Sheet, json::Exact};
use subcert::scheme::{AnyScheme, Mask, Rules, Scheme, parse_any_scheme};

pub(crate) fn constants(arguments: &ConstantsArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
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
    let mut report = Report::of(&scheme, &wanted).map_err(|e| Failure::Input(e.to_string()))?;
    let name = &arguments.scheme;
    report.better_offsets = OfFile::all_of(name, &scheme)?;
    show_table(
        &arguments.output,
        || report.sheet(name),
        || report.form(name),
        || csv::constants(&report.form(name)),
    )
}

/// The constants of a scheme, computed once for every format.
struct Report {
    directions: Vec<Direction>,
    surface: Option<Surface>,
    better_offsets: Vec<OfFile>,
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
    columns: Columns,
    sigma: Vec<(String, Rational)>,
    shift: NaturalShift,
}

impl Report {
    fn of(scheme: &Scheme, wanted: &Wanted) -> Result<Report, ClassCap> {
        let constants: Vec<Constants> =
            scheme.masks().into_iter().cloned().map(Constants::new).collect();
        let directions = constants
            .iter()
            .map(|one| Direction::of(one, wanted))
            .collect::<Result<Vec<Direction>, ClassCap>>()?;
        let surface = match &constants[..] {
            [first, second] => {
                let factor = surface_factor(first.mask(), second.mask());
                let delta = DeltaCondition::surface(first, second)?;
                let product = |i: usize, j: usize| {
                    let columns: [&[Rational]; 2] =
                        [&directions[i].columns[0], &directions[j].columns[1]];
                    columns[0].iter().zip(columns[1]).map(|(t, norm)| t * norm).collect()
                };
                let products: [Vec<Rational>; 2] = [product(0, 1), product(1, 0)];
                let [left, right] = products;
                let constants = left.into_iter().zip(right).map(|(x, y)| x.max(y)).collect();
                Some(Surface { factor, delta, constants })
            }
            _ => None,
        };
        Ok(Report { directions, surface, better_offsets: Vec::new() })
    }
}

impl Direction {
    fn of(constants: &Constants, wanted: &Wanted) -> Result<Direction, ClassCap> {
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
        let columns = columns(&mask, &difference, wanted);
        let delta = DeltaCondition::curve(constants)?;
        let shift = natural_shift(&mask);
        Ok(Direction { delta, mask, difference, columns, sigma, shift })
    }

    /// For each c the values of all columns; `None` beyond reach.
    fn rows(&self) -> impl Iterator<Item = (usize, Vec<Option<&Rational>>)> {
        let longest = self.columns.iter().map(Vec::len).max().unwrap_or(0);
        (0..longest).map(|i| (i + 1, self.columns.iter().map(|column| column.get(i)).collect()))
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
        self.better_offsets.iter().for_each(|better| better.write(&mut sheet));
        sheet
    }

    fn form<'a>(&'a self, name: &'a str) -> form::Constants<'a> {
        let surface = |Surface { factor, delta, constants }: &Surface| form::Surface {
            factor: Exact::of(factor),
            delta: delta_form(delta),
            constants: constants.iter().map(Exact::of).collect(),
        };
        form::Constants {
            schema: SCHEMA,
            scheme: name,
            directions: self.directions.iter().map(Direction::form).collect(),
            surface: self.surface.as_ref().map(surface),
            better_offsets: self.better_offsets.iter().map(OfFile::form).collect(),
        }
    }
}

fn delta_text(condition: &DeltaCondition) -> String {
    let holds = if condition.holds() { "< 1: one level contracts" } else { "not < 1" };
    format!("{}, {holds}", with_decimal(&condition.delta))
}

fn delta_form(condition: &DeltaCondition) -> form::Delta {
    form::Delta { value: Exact::of(&condition.delta), holds: condition.holds() }
}

fn row_texts(rows: &[Vec<Rational>]) -> Vec<Vec<String>> {
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
        let names = ["c", "T_c", "Λ_c", "T_c forward", "Λ_c forward"];
        let header = names[..=self.columns.len()].iter().map(|&name| name.to_owned()).collect();
        let rows = self.rows().map(|(c, row)| {
            let cell = |value: Option<&Rational>| value.map_or("–".to_owned(), |x| short(x, 10));
            std::iter::once(c.to_string()).chain(row.into_iter().map(cell)).collect()
        });
        sheet.grid(Grid { header, rows: rows.collect(), left_columns: 0 });
        let mut meaning = "T_c bounds the differences after c levels".to_owned();
        if self.columns.len() > 2 {
            meaning += "; the forward columns are what papers that read the masks forwards \
                        compute, and bound nothing";
        }
        sheet.text(meaning + ".");
        if self.rows().any(|(_, row)| row.contains(&None)) {
            sheet.text(
                "–: not found within the caps on work, by branch and bound, by extreme rows or by a \
                 visit of all rows.",
            );
        }
        if !self.shift.keeps_lines {
            let shifts = self.shift.of_rules.iter().map(|shift| short(shift, 6));
            sheet.text(format!(
                "Lines are not kept: from points at equal distances on a line, the rules make \
                 points at unequal distances, for the shift of the parameter differs from rule to \
                 rule: {}. As a rule, schemes with smooth (C1) limits keep lines. If this one is \
                 meant to have such limits, one of its coefficients is wrong.",
                shifts.collect::<Vec<String>>().join(", ")
            ));
        }
    }

    fn form(&self) -> form::Direction<'_> {
        let levels = self.rows().map(|(c, row)| {
            let mut row = row.into_iter().map(|value| value.map(Exact::of));
            let (contraction, norm) = (row.next().flatten(), row.next().flatten());
            let forward = (self.columns.len() > 2).then(|| form::Forward {
                contraction_forward: row.next().flatten(),
                norm_forward: row.next().flatten(),
            });
            form::Level { c, contraction, norm, forward }
        });
        let sigma = self.sigma.iter();
        let sigma = sigma.map(|(name, value)| form::Displacement { value: Exact::of(value), name });
        form::Direction {
            arity: self.mask.arity(),
            width: self.mask.width(),
            offset: self.mask.offset(),
            mask: row_texts(self.mask.rules().rows()),
            difference: row_texts(self.difference.rows()),
            delta: delta_form(&self.delta),
            displacement: sigma.collect(),
            keeps_lines: self.shift.keeps_lines,
            levels: levels.collect(),
        }
    }
}

/// The longest fraction that is shown in a mask; one with a longer one is shown in decimals.
const MAX_FRACTION: usize = 40;

fn rules_text(rows: &[Vec<Rational>]) -> String {
    let exact = rows.iter().flatten().all(|entry| entry.to_string().len() <= MAX_FRACTION);
    let entry = |entry: &Rational| if exact { entry.to_string() } else { short(entry, 9) };
    let row = |row: &Vec<Rational>| row.iter().map(entry).collect::<Vec<String>>().join("  ");
    let mut lines: Vec<String> = rows.iter().map(row).collect();
    if !exact {
        lines.push("(exact in --format json)".to_owned());
    }
    lines.join("\n")
}
