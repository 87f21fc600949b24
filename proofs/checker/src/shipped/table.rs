//! Tables of constants as a claim file describes them.

use super::language::Language;
use super::rounding::Type;
use super::value::Values;
use crate::claims::misfit;
use crate::formulas::{Definitions, Expr, formula, is_name};
use crate::text::{Checked, Reason, Stop, Toml};

/// The most numbers of a table.
const MAX_NUMBERS: usize = 20_000;

/// A table of a claim file.
pub struct Table<'a> {
    /// The type of its numbers.
    pub of: Type,
    /// The language of its numbers.
    pub language: Language,
    /// How many numbers it has.
    pub count: usize,
    /// The numbers, if they are typed into the claim file.
    pub typed: Option<Vec<&'a str>>,
    /// What they are said to equal.
    pub exact: Exact,
    /// Other values.
    pub conventions: Vec<Exact>,
    indices: Vec<Index>,
}

/// An index: its name, its first value and how many it has.
struct Index {
    name: String,
    first: i64,
    count: usize,
}

/// One formula in the indices, or one for each number.
pub enum Exact {
    /// One for all.
    One(Expr),
    /// One for each.
    Each(Vec<Expr>),
}

/// The fields of the tables.
const FIELDS: &str = "shipped: id=text locus=text title=text type=text indices=*text equals=text \
 equals_cells=nested cells=nested cells_from=source language=text tolerance=text note=text \
 convention=*convention
source: file=text after=nested shape=*text skip=text
convention: label=text equals=text equals_cells=nested";

fn wrong(why: impl Into<String>) -> Stop {
    Stop::Wrong(why.into())
}

impl<'a> Table<'a> {
    /// Reads a table.
    pub fn read(claim: &'a Toml, definitions: &Definitions) -> Checked<Table<'a>> {
        // An unknown field could change the meaning of the claim.
        if let Some(path) = misfit(claim, "shipped", FIELDS) {
            return Err(Reason::Field(path).into());
        }
        let of =
            claim.text("type").and_then(Type::read).ok_or_else(|| wrong("`type` is no type"))?;
        let indices: Vec<Index> = claim
            .list("indices")
            .iter()
            .map(|text| Index::read(text.as_text().unwrap_or_default()))
            .collect::<Result<_, Stop>>()?;
        for (place, index) in indices.iter().enumerate() {
            let twice = indices[..place].iter().any(|other| other.name == index.name);
            if twice || definitions.contains_key(&index.name) {
                return Err(wrong(format!("the index `{}` has another meaning", index.name)).into());
            }
        }
        let count = indices.iter().try_fold(1_usize, |count, index| count.checked_mul(index.count));
        let count = count.filter(|count| *count <= MAX_NUMBERS);
        let count = count.ok_or(Stop::Capped("the numbers of a table"))?;
        let typed = claim.get("cells").map(texts).transpose()?;
        if typed.as_ref().is_some_and(|typed| typed.len() != count) {
            return Err(wrong("`cells` has another number of numbers than the indices").into());
        }
        let source = claim.get("cells_from");
        if typed.is_some() == source.is_some() {
            return Err(wrong("needed is one of `cells` and `cells_from`").into());
        }
        let language = match (claim.text("language"), source.and_then(|from| from.text("file"))) {
            (Some(name), _) => Language::read(name),
            (None, Some(file)) => Language::of_file(file),
            (None, None) => Some(Language::C),
        };
        let language = language.ok_or_else(|| wrong("the language is not known"))?;
        let conventions = claim.list("convention").iter().map(|other| Exact::read(other, count));
        Ok(Table {
            of,
            language,
            count,
            typed,
            exact: Exact::read(claim, count)?,
            conventions: conventions.collect::<Result<_, Stop>>()?,
            indices,
        })
    }

    /// The indices of the number at a place, in order; the last one runs fastest.
    pub fn at(&self, place: usize) -> Vec<(String, i64)> {
        let (mut rest, mut found) = (place, Vec::new());
        for index in self.indices.iter().rev() {
            let step = i64::try_from(rest % index.count).unwrap_or(0);
            found.push((index.name.clone(), index.first + step));
            rest /= index.count;
        }
        found.reverse();
        found
    }

    /// The ends of an enclosure of the exact value at a place.
    pub fn value(
        &self,
        exact: &Exact,
        place: usize,
        values: &Values<'_>,
    ) -> Result<super::decided::Ends, Stop> {
        let formula = match exact {
            Exact::One(formula) => formula,
            Exact::Each(formulas) => &formulas[place],
        };
        Ok(values.value(formula, &self.at(place))?.ends())
    }
}

impl Index {
    /// Reads `n = 3..9`.
    fn read(text: &str) -> Result<Index, Stop> {
        let otherwise = || wrong(format!("`{text}` is no index with a range"));
        let (name, range) = text.split_once('=').ok_or_else(otherwise)?;
        let (first, last) = range.split_once("..").ok_or_else(otherwise)?;
        let integer = |text: &str| text.trim().parse::<i64>().ok();
        let (Some(first), Some(last)) = (integer(first), integer(last)) else {
            return Err(otherwise());
        };
        let count = last.checked_sub(first).and_then(|more| usize::try_from(more).ok());
        let count = count.filter(|more| *more < MAX_NUMBERS).ok_or_else(otherwise)? + 1;
        let name = name.trim();
        if !is_name(name) || name == "pi" {
            return Err(otherwise());
        }
        Ok(Index { name: name.to_owned(), first, count })
    }
}

impl Exact {
    /// Reads `equals` or `equals_cells`.
    fn read(claim: &Toml, count: usize) -> Result<Exact, Stop> {
        match (claim.text("equals"), claim.get("equals_cells")) {
            (Some(text), None) => formula(text).map(Exact::One),
            (None, Some(list)) => {
                let texts = texts(list)?;
                if texts.len() != count {
                    return Err(wrong(
                        "`equals_cells` has another number of formulas than the indices",
                    ));
                }
                texts.into_iter().map(formula).collect::<Result<_, Stop>>().map(Exact::Each)
            }
            _ => Err(wrong("needed is one of `equals` and `equals_cells`")),
        }
    }
}

/// The texts of nested lists, in order. Those beside each other have equally many.
fn texts(value: &Toml) -> Result<Vec<&str>, Stop> {
    let kind = |one: &Toml| one.as_text().is_none().then(|| flattened(one).len());
    let items = value.as_list();
    let even = items.iter().all(|one| kind(one) == items.first().and_then(kind));
    let inner = items.iter().filter(|one| one.as_text().is_none());
    if !even || inner.map(texts).any(|inner| inner.is_err()) {
        return Err(wrong("lists beside each other do not have equally many entries"));
    }
    Ok(flattened(value))
}

/// The texts of nested lists, in order.
fn flattened(value: &Toml) -> Vec<&str> {
    match value {
        Toml::Text(text) => vec![text],
        other => other.as_list().iter().flat_map(flattened).collect(),
    }
}
