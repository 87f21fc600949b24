//! The cases of a claim: combinations of indices, and the lines about those that are false.

#![warn(clippy::arithmetic_side_effects)]

use crate::claims::{Paper, value};
use crate::formulas::{Expr, MAX_INTEGER, Scope};
use crate::numbers::{Number, Q, Value, int, read_rational};
use crate::text::{Block, Checked, Reason, Stop, Text, Verdict, agree, compare, require};

/// The most cases of a claim.
pub const MAX_CASES: usize = 100_000;

/// The first values of an index that has all values.
pub const FIRST: usize = 24;

/// The values of the indices.
pub type Case<'a> = Vec<(&'a str, Q)>;

/// An index of a claim.
pub struct Index<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its values.
    pub values: Values<'a>,
}

/// The values of an index.
pub enum Values<'a> {
    /// These numbers.
    Listed(Vec<Q>),
    /// The integers between two bounds, in the names of the indices before it.
    Between(Box<[Expr; 2]>),
    /// Rows of numbers for several names.
    Rows(Vec<&'a str>, Vec<Vec<Q>>),
    /// All integers from this one on.
    From(i64),
}

/// The bounds of the values of an index, where those before it have these values.
fn integers(paper: &Paper<'_>, case: &Case<'_>, bounds: &[Expr; 2]) -> Result<[i64; 2], Stop> {
    let mut scope = paper.library.closed();
    scope.filters = true;
    let values = case.iter().map(|(name, value)| ((*name).into(), value.clone().into()));
    scope.values.extend(values);
    let bound = |bound| scope.value(bound)?.integer(MAX_INTEGER);
    Ok([bound(&bounds[0])?, bound(&bounds[1])?])
}

impl<'a> Index<'a> {
    /// Its values, where the indices before it have these, or the first ones.
    fn listed(&self, paper: &Paper<'_>, case: &Case<'_>) -> Result<Vec<Vec<Q>>, Stop> {
        let values: Vec<Q> = match &self.values {
            Values::Rows(_, rows) => return Ok(rows.clone()),
            Values::Listed(values) => values.clone(),
            Values::Between(bounds) => {
                let [from, to] = integers(paper, case, bounds)?;
                (from..=to).take(MAX_CASES.saturating_add(1)).map(int).collect()
            }
            Values::From(least) => (*least..).take(FIRST).map(int).collect(),
        };
        Ok(values.into_iter().map(|value| vec![value]).collect())
    }

    /// Whether this is one of its values, where the indices before it have these.
    pub fn has(&self, paper: &Paper<'_>, case: &Case<'_>, values: &[Q]) -> Result<bool, Stop> {
        if let Values::Rows(_, rows) = &self.values {
            return Ok(rows.iter().any(|row| row == values));
        }
        let [value] = values else { return Ok(false) };
        Ok(match &self.values {
            Values::Rows(..) => false,
            Values::Listed(values) => values.contains(value),
            Values::Between(bounds) => {
                let [from, to] = integers(paper, case, bounds)?.map(int);
                value.is_integer() && from <= *value && *value <= to
            }
            Values::From(least) => value.is_integer() && *value >= int(*least),
        })
    }

    /// Its name, or the names of several.
    pub fn names(&self) -> Vec<&'a str> {
        match &self.values {
            Values::Rows(names, _) => names.clone(),
            _ => vec![self.name],
        }
    }

    /// Whether it has all values from one on.
    pub fn is_all(&self) -> bool {
        matches!(self.values, Values::From(_))
    }
}

/// Every combination of the indices, the first one slowest. Of an index with all values, the first ones count.
pub fn cases<'a>(
    paper: &Paper<'_>,
    indices: impl IntoIterator<Item = &'a Index<'a>>,
) -> Result<Vec<Case<'a>>, Stop> {
    let mut cases: Vec<Case<'a>> = vec![Vec::new()];
    for index in indices {
        let mut longer = Vec::new();
        for case in cases {
            let values = index.listed(paper, &case)?;
            if longer.len().saturating_add(values.len()) > MAX_CASES {
                return Err(Stop::Capped("the number of cases"));
            }
            longer.extend(values.into_iter().map(|values| {
                let named: Case<'_> = index.names().into_iter().zip(values).collect();
                [&case[..], &named[..]].concat()
            }));
        }
        cases = longer;
    }
    Ok(cases)
}

/// The values of the indices of a case, as certificates write them.
pub fn name_of(case: &Case<'_>) -> String {
    case.iter().map(|(_, value)| value.to_string()).collect::<Vec<_>>().join(" ")
}

/// What follows `in` in the next line, if it is about this case: `case 3 in 1/8 1/4`.
fn bounds(block: &mut Block<'_>, name: &str) -> Option<String> {
    let line = block.peek().map(|line| line.word()).filter(|(word, _)| *word == "case")?.1;
    let (case, said) = line.split_once("in ")?;
    let spaced = case.is_empty() || case.ends_with(' ');
    (spaced && case.trim() == name).then(|| said.trim().to_owned())
}

/// The verdict of a certificate, and how many cases it lists as false.
pub struct Listing {
    verdict: Verdict,
    listed: usize,
    /// Whether bounds leave some case open.
    open: bool,
}

impl Listing {
    /// A verdict that has been read, before its first case.
    pub fn of(verdict: Verdict) -> Listing {
        Listing { verdict, listed: 0, open: false }
    }

    /// Reads one of these verdicts, whose number of cases has to be this.
    pub fn read(block: &mut Block<'_>, of: &[Verdict], cases: usize) -> Checked<Listing> {
        // Without cases nothing is stated.
        require(cases > 0, Reason::NoCase)?;
        let (verdict, count) = block.any()?;
        let verdict = Verdict::named(verdict);
        let verdict = verdict.filter(|said| of.contains(said));
        let verdict = verdict.ok_or(Reason::Malformed("a verdict on all cases"))?;
        agree(count, &cases.to_string(), Reason::Cases)?;
        Ok(Listing::of(verdict))
    }

    /// The formula of the next line, if it is about this case: `case 3 1/2 = p[0] - p[1]`.
    pub fn said(block: &mut Block<'_>, name: &str) -> Option<String> {
        let line = block.peek().map(|line| line.word()).filter(|(word, _)| *word == "case")?.1;
        let (case, said) = line.split_once('=')?;
        (case.trim() == name).then(|| said.to_owned())
    }

    /// Checks the line about a case, or that there is none if the case is not false.
    pub fn check(
        &mut self,
        block: &mut Block<'_>,
        name: &str,
        (fails, difference): (bool, &Value),
        scope: &Scope<'_>,
    ) -> Checked<()> {
        if let Some(said) = bounds(block, name) {
            difference.number()?;
            block.after("case")?;
            return self.list(name, fails, &said, [difference.clone(), difference.clone()]);
        }
        let Some(said) = Listing::said(block, name) else {
            let reason = || Reason::Differ(name.to_owned(), Text(difference.to_string()));
            return if fails { Err(reason().into()) } else { Ok(()) };
        };
        block.after("case")?;
        let said = value(&said, scope)?;
        require(fails || !said.is_zero(), Reason::NoDifference)?;
        compare(difference.equals(&said)?, &said, difference, Reason::Difference)?;
        require(fails, Reason::NotFalse(name.to_owned()))?;
        self.listed = self.listed.saturating_add(1);
        Ok(())
    }

    /// The same of a case with other real numbers: bounds of the difference, and the difference if it is known. Without a verdict on the
    /// case, there is no line.
    pub fn check_real(
        &mut self,
        block: &mut Block<'_>,
        name: &str,
        (fails, [low, high], number): (Option<bool>, &[Q; 2], Option<&Number>),
        scope: &Scope<'_>,
    ) -> Checked<()> {
        let is_listed = bounds(block, name).is_some() || Listing::said(block, name).is_some();
        if fails.is_none() && is_listed {
            return Err(Stop::Undecided("whether a comparison is false in a case").into());
        }
        if let Some(number) = number
            && bounds(block, name).is_none()
        {
            let number = Value::from(number.clone());
            return self.check(block, name, (fails == Some(true), &number), scope);
        }
        let Some(said) = bounds(block, name) else {
            self.open |= fails.is_none();
            let reason = || Reason::Differ(name.to_owned(), Text(format!("{low} to {high}")));
            return if fails == Some(true) { Err(reason().into()) } else { Ok(()) };
        };
        block.after("case")?;
        self.list(name, fails == Some(true), &said, [low.clone().into(), high.clone().into()])
    }

    /// Notes a case that is listed with bounds of a difference which is between two numbers.
    fn list(
        &mut self,
        name: &str,
        fails: bool,
        said: &str,
        [low, high]: [Value; 2],
    ) -> Checked<()> {
        let words = said.split_once(' ');
        let ends = words.and_then(|(l, h)| read_rational(l).zip(read_rational(h.trim())));
        let (least, most) =
            ends.map(|(l, h)| (Value::from(l), Value::from(h))).ok_or(Reason::Case)?;
        let apart = least.compare(&most)?.is_lt();
        let within = least.compare(&low)?.is_le() && high.compare(&most)?.is_le();
        require(apart && within, Reason::Bounds(name.to_owned()))?;
        require(fails, Reason::NotFalse(name.to_owned()))?;
        self.listed = self.listed.saturating_add(1);
        Ok(())
    }

    /// Checks that no other case is listed, and that the verdict fits.
    pub fn finished(self, block: &mut Block<'_>) -> Checked<()> {
        require(block.maybe("case").is_none(), Reason::Case)?;
        if self.open && self.listed == 0 {
            return Err(Stop::Undecided("a comparison of numbers that are known by bounds").into());
        }
        let found = match self.verdict {
            _ if self.listed > 0 => Verdict::Fails,
            Verdict::Tried => Verdict::Tried,
            _ => Verdict::Holds,
        };
        compare(self.verdict == found, &self.verdict, &found, Reason::Verdict)
    }
}
