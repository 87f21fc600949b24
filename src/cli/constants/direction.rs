//! The constants of a mask.

use super::columns::{Wanted, columns};
use super::delta::Delta;
use crate::cli::console::quantity::{Number, Text, misplaced_rows};
use serde::Serialize;
use subcert::bound::{self, ClassCap, DeltaCondition, Terms, best_offset, displacement};
use subcert::exact::{Rational, format::short};
use subcert::limit::natural_shift;
use subcert::report::{Grid, Sheet};
use subcert::scheme::Rules;

/// The constants of a mask.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Direction {
    /// How many rules there are.
    arity: usize,
    /// How many coefficients a rule has.
    width: usize,
    /// The offset of the indices.
    offset: i64,
    /// The mask, rule by rule.
    mask: Vec<Vec<Text<Rational>>>,
    /// The difference mask.
    difference: Vec<Vec<Text<Rational>>>,
    /// δ = T_1.
    delta: Delta,
    /// σ at several offsets.
    pub(super) displacement: Vec<Displacement>,
    /// Whether the mask takes lines to lines, with some shift of the parameter.
    keeps_lines: bool,
    /// The shifts of the parameter, rule by rule.
    #[serde(skip)]
    shifts: Vec<Rational>,
    /// The rows that belong so many places further.
    #[serde(skip)]
    misplaced: Vec<(usize, i64)>,
    /// Whether the forward order was asked for.
    #[serde(skip)]
    forward: bool,
    /// T_c and Λ_c for c = 1, 2, …
    pub(super) levels: Vec<Level>,
    /// Why some of them are missing; absent where none is.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
    /// The number of levels that was asked for.
    #[serde(skip)]
    asked: u32,
}

/// σ at one offset.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Displacement {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub(super) value: Number,
    /// The name of this σ.
    pub(super) name: String,
}

/// The constants for blocks of c levels; null where they are beyond reach.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Level {
    /// c.
    pub(super) c: usize,
    /// T_c.
    pub(super) contraction: Option<Number>,
    /// Λ_c.
    pub(super) norm: Option<Number>,
    /// Both with the masks read forwards; its fields stand here, and are missing where they were not asked for.
    #[serde(flatten)]
    forward: Option<Forward>,
}

/// The constants for blocks of c levels with the masks read forwards; null where they are beyond reach.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Forward {
    /// T_c.
    contraction_forward: Option<Number>,
    /// Λ_c.
    norm_forward: Option<Number>,
}

impl Direction {
    pub(super) fn of(constants: &bound::Constants, wanted: &Wanted) -> Result<Direction, ClassCap> {
        let mask = constants.mask();
        let (best, least) = best_offset(mask);
        let own = mask.offset();
        let unshifted = mask.with_offset(0);
        let sigma = |name: String, value| Displacement { value: Number::Rational(value), name };
        let (columns, ended) = columns(mask, constants.difference(), wanted);
        let value = |column: usize, i: usize| columns[column].get(i).map(Number::from);
        let level = |i| Level {
            c: i + 1,
            contraction: value(0, i),
            norm: value(1, i),
            forward: wanted
                .forward
                .then(|| Forward { contraction_forward: value(2, i), norm_forward: value(3, i) }),
        };
        let longest = columns.iter().map(Vec::len).max().unwrap_or(0);
        let texts = |rules: &Rules| {
            let row = |row: &Vec<Rational>| row.iter().cloned().map(Text).collect();
            rules.rows().iter().map(row).collect()
        };
        let shift = natural_shift(mask);
        Ok(Direction {
            arity: mask.arity(),
            width: mask.width(),
            offset: own,
            mask: texts(mask.rules()),
            difference: texts(constants.difference()),
            delta: Delta::of(&DeltaCondition::curve(constants)?),
            displacement: vec![
                sigma(format!("σ at the scheme's offset {own}"), displacement(mask, Terms::Each)),
                sigma(format!("σ at the best offset {best}"), least),
                sigma("σ at offset 0".to_owned(), displacement(&unshifted, Terms::Each)),
                sigma(
                    "|Σ| in place of σ at offset 0".to_owned(),
                    displacement(&unshifted, Terms::Total),
                ),
            ],
            keeps_lines: shift.keeps_lines,
            misplaced: shift.misplaced(),
            shifts: shift.of_rules,
            forward: wanted.forward,
            levels: (0..longest).map(level).collect(),
            ended,
            asked: wanted.levels,
        })
    }

    pub(super) fn write(&self, sheet: &mut Sheet) {
        // Without `..`, so that the compiler names this place for a new value.
        let Direction {
            arity,
            width: _,
            offset: _,
            mask,
            difference,
            delta,
            displacement,
            keeps_lines,
            shifts,
            misplaced,
            forward,
            levels,
            ended,
            asked,
        } = self;
        let mut facts = vec![
            ("arity n".to_owned(), arity.to_string()),
            ("mask".to_owned(), rules_text(mask)),
            ("difference mask".to_owned(), rules_text(difference)),
            ("δ = T_1".to_owned(), delta.words()),
        ];
        facts.extend(displacement.iter().map(|one| (one.name.clone(), one.value.words())));
        sheet.facts(facts);
        let rows: Vec<Vec<Option<&Number>>> =
            levels.iter().map(|level| level.values().map(|(_, value)| value).collect()).collect();
        let width = if *forward { 4 } else { 2 };
        let names = ["c", "T_c", "Λ_c", "T_c forward", "Λ_c forward"];
        let header = names[..=width].iter().map(|&name| name.to_owned());
        let cells = levels.iter().zip(&rows).map(|(level, row)| {
            let cell =
                |value: Option<&Number>| value.map_or("–".to_owned(), |value| value.short(10));
            std::iter::once(level.c.to_string()).chain(row.iter().copied().map(cell)).collect()
        });
        sheet.grid(Grid::of(header, cells, 0));
        let mut meaning = "T_c bounds the differences after c levels".to_owned();
        if *forward {
            meaning += "; the forward columns are what papers that read the masks forwards \
                        compute, and bound nothing";
        }
        sheet.text(meaning + ".");
        if let Some(why) = ended {
            let further = match levels.len() + 1 {
                next if next as u64 <= u64::from(*asked) => format!("– and c from {next} on"),
                _ => "–".to_owned(),
            };
            sheet.text(format!("{further}: {why}."));
        }
        if !*keeps_lines {
            let shifts = shifts.iter().map(|shift| short(shift, 6));
            sheet.text(format!(
                "Lines are not kept: from points at equal distances on a line, the rules make \
                 points at unequal distances, for the shift of the parameter differs from rule to \
                 rule: {}. As a rule, schemes with smooth (C1) limits keep lines. If this one is \
                 meant to have such limits, {}.",
                shifts.collect::<Vec<String>>().join(", "),
                misplaced_rows(misplaced)
                    .unwrap_or_else(|| "one of its coefficients is wrong".to_owned())
            ));
        }
    }
}

impl Level {
    /// The columns by their names in JSON.
    pub(super) fn values(&self) -> impl Iterator<Item = (&'static str, Option<&Number>)> {
        let forward = self.forward.as_ref().map(|both| {
            [
                ("contraction_forward", both.contraction_forward.as_ref()),
                ("norm_forward", both.norm_forward.as_ref()),
            ]
        });
        let own = [("contraction", self.contraction.as_ref()), ("norm", self.norm.as_ref())];
        own.into_iter().chain(forward.into_iter().flatten())
    }
}

/// The longest fraction that is shown in a mask; one with a longer one is shown in decimals.
const MAX_FRACTION: usize = 40;

fn rules_text(rows: &[Vec<Text<Rational>>]) -> String {
    let exact = rows.iter().flatten().all(|entry| entry.0.to_string().len() <= MAX_FRACTION);
    let entry =
        |entry: &Text<Rational>| if exact { entry.0.to_string() } else { short(&entry.0, 9) };
    let row = |row: &Vec<Text<Rational>>| row.iter().map(entry).collect::<Vec<String>>().join("  ");
    let mut lines: Vec<String> = rows.iter().map(row).collect();
    if !exact {
        lines.push("(exact in --format json)".to_owned());
    }
    lines.join("\n")
}
