//! What a claim file says of a project and its tables, as data.

use crate::diagnostic::SourceText;
use crate::exact::Rational;
use crate::formula::LocatedFormula;
use crate::literal::Language;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// A claim file about constants that a program ships.
#[derive(Clone, Debug)]
pub struct Project {
    /// The short name that ids begin with.
    pub key: String,
    /// The project's name.
    pub name: String,
    /// Where its source is public, if it is.
    pub repository: Option<String>,
    /// The commit whose source is described, 40 hexadecimal digits.
    pub commit: Option<String>,
    /// The licence of the source.
    pub licence: Option<String>,
    /// A note for the reader.
    pub note: Option<String>,
    /// Named formulas.
    pub definitions: BTreeMap<String, LocatedFormula>,
    /// The tables, in the order of the file.
    pub shipped: Vec<ShippedClaim>,
    /// The claim file.
    pub source: Arc<SourceText>,
}

impl Project {
    /// Where the source stands, as far as the file says it: the repository, `commit …`, `licence …`.
    #[must_use]
    pub fn source_words(&self) -> Vec<String> {
        let commit = self.commit.as_ref().map(|commit| format!("commit {commit}"));
        let licence = self.licence.as_ref().map(|licence| format!("licence {licence}"));
        [self.repository.clone(), commit, licence].into_iter().flatten().collect()
    }
}

/// A table of numbers in a program, and what they are said to equal.
#[derive(Clone, Debug)]
pub struct ShippedClaim {
    /// Its id within the project.
    pub id: String,
    /// Its range of bytes in the claim file.
    pub span: Range<usize>,
    /// Where it stands: file and name.
    pub locus: String,
    /// What it is, in words.
    pub title: String,
    /// The type of the numbers.
    pub kind: NumberType,
    /// The indices; the last one runs fastest.
    pub indices: Vec<TableIndex>,
    /// What the numbers are said to equal.
    pub exact: ExactValues,
    /// Other exact tables that are in use.
    pub conventions: Vec<Convention>,
    /// The numbers, in order.
    pub numbers: Vec<ShippedNumber>,
    /// Where the numbers were read.
    pub origin: Origin,
    /// An error that the project or its users accept, as written and as a number.
    pub tolerance: Option<(String, Rational)>,
    /// A note for the reader.
    pub note: Option<String>,
}

impl ShippedClaim {
    /// The values of the indices at number `place` of the table, with their names.
    #[must_use]
    pub fn at(&self, place: usize) -> Vec<(&str, i64)> {
        let mut rest = place;
        let mut found: Vec<(&str, i64)> = Vec::with_capacity(self.indices.len());
        for index in self.indices.iter().rev() {
            let step = i64::try_from(rest % index.count()).unwrap_or(0);
            found.push((&index.name, index.from + step));
            rest /= index.count();
        }
        found.reverse();
        found
    }

    /// How many numbers a line along the last index has; 1 without indices.
    #[must_use]
    pub fn line(&self) -> usize {
        self.indices.last().map_or(1, TableIndex::count)
    }
}

/// An index of a table, with its inclusive range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableIndex {
    /// Its name in formulas.
    pub name: String,
    /// The first value.
    pub from: i64,
    /// The last value, at least `from`.
    pub to: i64,
}

impl TableIndex {
    /// The number of values.
    #[must_use]
    pub fn count(&self) -> usize {
        usize::try_from(self.to - self.from + 1).unwrap_or(1)
    }
}

/// The type of shipped numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberType {
    /// IEEE binary32.
    Single,
    /// IEEE binary64.
    Double,
    /// A decimal with so many digits after the point.
    Decimal(u32),
}

impl NumberType {
    /// Its name in claim files: `f32`, `f64` or `decimal:D`.
    ///
    /// ```
    /// use subcert::shipped::NumberType;
    ///
    /// assert_eq!(NumberType::parse("decimal:6").map(NumberType::name).as_deref(), Some("decimal:6"));
    /// assert_eq!(NumberType::parse("f16"), None);
    /// ```
    #[must_use]
    pub fn name(self) -> String {
        match self {
            NumberType::Single => "f32".to_owned(),
            NumberType::Double => "f64".to_owned(),
            NumberType::Decimal(digits) => format!("decimal:{digits}"),
        }
    }

    /// The type of this name.
    #[must_use]
    pub fn parse(name: &str) -> Option<NumberType> {
        match name {
            "f32" => Some(NumberType::Single),
            "f64" => Some(NumberType::Double),
            _ => {
                let digits = name.strip_prefix("decimal:")?.parse().ok()?;
                let plain = name == format!("decimal:{digits}");
                ((1..=100).contains(&digits) && plain).then_some(NumberType::Decimal(digits))
            }
        }
    }
}

/// Exact values of all numbers of a table.
#[derive(Clone, Debug)]
pub enum ExactValues {
    /// One formula in the indices.
    Formula(LocatedFormula),
    /// One formula for each number.
    Each(Vec<LocatedFormula>),
}

impl ExactValues {
    /// The formula of number `place`.
    #[must_use]
    pub fn of(&self, place: usize) -> &LocatedFormula {
        match self {
            ExactValues::Formula(formula) => formula,
            ExactValues::Each(formulas) => &formulas[place],
        }
    }

    /// All formulas.
    #[must_use]
    pub fn formulas(&self) -> &[LocatedFormula] {
        match self {
            ExactValues::Formula(formula) => std::slice::from_ref(formula),
            ExactValues::Each(formulas) => formulas,
        }
    }
}

/// Another exact table that is in use.
#[derive(Clone, Debug)]
pub struct Convention {
    /// What it is called.
    pub label: String,
    /// Its values.
    pub exact: ExactValues,
}

/// Where numbers were read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// In the claim file, by the rules of this language.
    Typed(Language),
    /// In a source file.
    Source {
        /// The file, as the claim file names it.
        file: String,
        /// The name that the table has there, or the names of its numbers with commas between them.
        after: String,
    },
}

/// A shipped number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShippedNumber {
    /// Its text in the source, with single blanks.
    pub text: String,
    /// What its digits say, if it is one literal.
    pub written: Option<Digits>,
    /// The number that the program holds; of decimals, the number as written.
    pub held: Rational,
    /// Its line in the source file, if it was read there.
    pub line: Option<usize>,
}

/// The digits of a literal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Digits {
    /// Its value.
    pub value: Rational,
    /// How many digits it has from the first that is not 0, and how many after the point, with the exponent
    /// applied; `None` in hexadecimal.
    pub count: Option<(usize, i64)>,
}
