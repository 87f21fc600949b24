//! Rule `cell`: a printed number and its verdict.

use super::reading::Reads;
use crate::certificate::Line;
use crate::decimal::Decimal;
use crate::reject::{Checked, Reason};
use crate::rounding::{Rounding, gives, has_digits, rounding, slips};
use crate::table::{Read, Table};
use crate::value::{Stop, Value};
use std::collections::{BTreeMap, BTreeSet};

/// Checks a cell: `ROW COLUMN "PRINTED" VALUE VERDICT … [assuming NAMES]`. Gives whether
/// the verdict is `refuted`.
pub fn check(
    table: &Table<'_>,
    reads: &Reads,
    place: (usize, usize),
    line: Line<'_>,
    said: &str,
) -> Checked<bool> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let wrong = line.reject(Reason::Malformed("cell ROW COLUMN \"PRINTED\" VALUE VERDICT"));
    let position = format!("{} {} ", place.0 + 1, place.1 + 1);
    let said = said.strip_prefix(&position).ok_or(line.reject(Reason::Cell))?;
    let (said, assumed) = said.split_once(" assuming ").unwrap_or((said, ""));
    let printed = table.printed(place.0, place.1);
    let (printed, rest) = match (said.strip_prefix("lost "), printed) {
        (Some(rest), None) => (None, rest),
        (None, Some((text, decimal))) => {
            let said = said.strip_prefix('"').ok_or(wrong.clone())?;
            let (found, rest) = said.rsplit_once("\" ").ok_or(wrong.clone())?;
            if found != text {
                return Err(line.reject(Reason::Printed));
            }
            (Some(decimal), rest)
        }
        _ => return Err(line.reject(Reason::Lost)),
    };
    let words: Vec<&str> = rest.split_whitespace().collect();
    let Some((value, verdict)) = words.split_first() else { return Err(wrong) };
    // The value of the definition as printed.
    let (needed, exact) = table.needed(place);
    let assumed: BTreeSet<String> = assumed.split_whitespace().map(str::to_owned).collect();
    if assumed != needed {
        return Err(line.reject(Reason::Assumed));
    }
    let exact = match exact {
        Err(Stop::Undefined(_)) => None,
        value => Some(value.map_err(stopped)?),
    };
    same(table, line, value, exact.as_ref())?;
    let Some(decimal) = printed else {
        return if verdict.is_empty() { Ok(false) } else { Err(wrong) };
    };
    let cell = Cell { table, place, needed, decimal, exact };
    cell.judge(reads, line, verdict)
}

/// Makes sure that a value of the certificate is this one.
fn same(table: &Table<'_>, line: Line<'_>, said: &str, value: Option<&Value>) -> Checked<()> {
    let equal = match value {
        _ if said == "undefined" => value.is_none(),
        None => false,
        Some(value) => {
            let said = table.paper.closed(line, said)?;
            value.plus(-1, &said).map_err(|stop| line.reject(Reason::Stopped(stop)))?.is_zero()
        }
    };
    if equal { Ok(()) } else { Err(line.reject(Reason::Value)) }
}

struct Cell<'c> {
    table: &'c Table<'c>,
    place: (usize, usize),
    needed: BTreeSet<String>,
    decimal: Decimal,
    exact: Option<Value>,
}

impl Cell<'_> {
    fn judge(&self, reads: &Reads, line: Line<'_>, verdict: &[&str]) -> Checked<bool> {
        let stopped = |stop| line.reject(Reason::Stopped(stop));
        let require = |holds: bool, reason: Reason| {
            if holds { Ok(()) } else { Err(line.reject(reason)) }
        };
        let depth = self.table.tolerance.is_some();
        let found = match &self.exact {
            None => Rounding::Neither,
            Some(exact) => rounding(&self.decimal, exact).map_err(stopped)?,
        };
        match verdict {
            ["confirmed"] => require(found == Rounding::Nearest, Reason::NotNearest)?,
            ["rounding", way @ ("cut" | "away")] => {
                require(!depth, Reason::Depth)?;
                let way = if *way == "cut" { Rounding::Cut } else { Rounding::Away };
                require(found == way, Reason::NotRounded)?;
            }
            ["rounding", way @ ("down" | "nearest")] => {
                require(depth, Reason::Depth)?;
                require(found != Rounding::Nearest, Reason::Nearest)?;
                require(self.rounded(way).map_err(stopped)?, Reason::NotRounded)?;
            }
            ["misprint", slip @ ..] => {
                require(!depth, Reason::Depth)?;
                require(found != Rounding::Nearest, Reason::Nearest)?;
                self.slip(line, &slip.join(" "), self.exact.as_ref(), true)?;
            }
            ["other-reading", value, rest @ ..] => {
                require(found != Rounding::Nearest, Reason::Nearest)?;
                let (rest, read) = match rest {
                    [rest @ .., "by", line, number] => {
                        (rest, reads.by(self.place, &format!("{line} {number}")))
                    }
                    _ => (rest, reads.table.as_ref()),
                };
                let read = read.ok_or(line.reject(Reason::NoReading))?;
                let value_read = self.read(read, line)?;
                same(self.table, line, value, Some(&value_read))?;
                match rest {
                    [] => {
                        let given = gives(&self.decimal, &value_read, read.decimals());
                        require(given.map_err(stopped)?, Reason::NotExplained)?;
                    }
                    ["rounding", way @ ("cut" | "away")] => {
                        require(!depth, Reason::Depth)?;
                        require(found == Rounding::Neither, Reason::Nearest)?;
                        let way = if *way == "cut" { Rounding::Cut } else { Rounding::Away };
                        let found = rounding(&self.decimal, &value_read).map_err(stopped)?;
                        require(found == way, Reason::NotRounded)?;
                        require(has_digits(&self.decimal, "rounding"), Reason::FewDigits)?;
                    }
                    [word, slip @ ..] => {
                        require(!depth && *word == "misprint", Reason::Depth)?;
                        self.slip(line, &slip.join(" "), Some(&value_read), false)?;
                    }
                }
            }
            [word @ ("refuted" | "differs")] => {
                // Under assumptions there is no refutation, only a difference.
                let plain = self.needed.is_empty();
                require(plain == (*word == "refuted"), Reason::Assumed)?;
                require(found == Rounding::Neither, Reason::Nearest)?;
                self.no_slip(line, self.exact.as_ref(), true)?;
                if depth {
                    for way in ["down", "nearest"] {
                        require(!self.rounded(way).map_err(stopped)?, Reason::Slip)?;
                    }
                }
                for read in reads.of(self.place) {
                    let value = self.value(read).map_err(stopped)?;
                    if let Some(value) = &value {
                        let given =
                            gives(&self.decimal, value, read.decimals()).map_err(stopped)?;
                        let near = rounding(&self.decimal, value).map_err(stopped)?;
                        let near = near != Rounding::Neither
                            && !depth
                            && has_digits(&self.decimal, "rounding");
                        require(!given && !near, Reason::Explained)?;
                    }
                    self.no_slip(line, value.as_ref(), false)?;
                }
                return Ok(plain);
            }
            _ => return Err(line.reject(Reason::Malformed("a verdict"))),
        }
        Ok(false)
    }

    /// The value under a reading; `None` if it is undefined.
    fn value(&self, read: &Read) -> Result<Option<Value>, Stop> {
        match self.table.value(self.place, read, &self.needed) {
            Err(Stop::Undefined(_)) => Ok(None),
            value => value.map(Some),
        }
    }

    fn read(&self, read: &Read, line: Line<'_>) -> Checked<Value> {
        let value = self.value(read).map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        value.ok_or(line.reject(Reason::NotExplained))
    }

    /// Whether the printed number is the depth rounded in another way.
    fn rounded(&self, way: &str) -> Result<bool, Stop> {
        let mut read = Read::default();
        read.reading.words = BTreeMap::from([("rounded".to_owned(), way.to_owned())]);
        let printed = Value::from(self.decimal.value());
        let value = self.value(&read)?;
        Ok(value.is_some_and(|value| printed.plus(-1, &value).is_ok_and(|d| d.is_zero())))
    }

    /// Makes sure that this slip leads from the value to the printed number.
    fn slip(&self, line: Line<'_>, slip: &str, value: Option<&Value>, near: bool) -> Checked<()> {
        let found = self.slips(value, near).map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        if !found.iter().any(|known| known == slip) {
            return Err(line.reject(Reason::NotThisSlip));
        }
        let enough = has_digits(&self.decimal, slip);
        if enough { Ok(()) } else { Err(line.reject(Reason::FewDigits)) }
    }

    /// Makes sure that no slip leads from the value to the printed number.
    fn no_slip(&self, line: Line<'_>, value: Option<&Value>, near: bool) -> Checked<()> {
        let found = self.slips(value, near).map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        let slip = found.iter().any(|slip| has_digits(&self.decimal, slip));
        if slip { Err(line.reject(Reason::Slip)) } else { Ok(()) }
    }

    /// The slips from the value; with `near`, also from the values of the cells around.
    fn slips(&self, value: Option<&Value>, near: bool) -> Result<Vec<String>, Stop> {
        let Some(value) = value.filter(|_| self.table.tolerance.is_none()) else {
            return Ok(Vec::new());
        };
        if rounding(&self.decimal, value)? != Rounding::Neither {
            return Ok(Vec::new());
        }
        let mut slips = slips(&self.decimal, value)?;
        let (rows, columns) = self.table.size();
        for (down, right) in [(0, 1), (0, -1), (1, 0), (-1, 0)].into_iter().filter(|_| near) {
            let row = self.place.0.checked_add_signed(down).filter(|row| *row < rows);
            let column = self.place.1.checked_add_signed(right).filter(|at| *at < columns);
            let Some(place) = row.zip(column) else { continue };
            if let (_, Ok(other)) = self.table.needed(place)
                && !other.plus(-1, value)?.is_zero()
                && rounding(&self.decimal, &other)? != Rounding::Neither
            {
                slips.push(format!("neighbour {down} {right}"));
            }
        }
        Ok(slips)
    }
}
