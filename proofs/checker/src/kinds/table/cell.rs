//! The rule `cell`: a printed number and its verdict.

use super::claim::{Place, Read, Table};
use super::family::members::{explained, values};
use super::reading::{PartRead, Reads};
use crate::numbers::{Decimal, Value, gives, has_digits, rounding, shown, slips, telling};
use crate::text::{Checked, Compared, Reason, Stop, Text, Verdict, agree, compare, require};
use std::collections::{BTreeMap, BTreeSet};

/// What a verdict needs of the family.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// The cell is refuted.
    Refuted,
    /// The cell is reproduced by the printed text.
    AsPrinted,
    /// The cell is reproduced by another reading.
    Reproduced,
    /// It needs nothing.
    Other,
}

/// Checks a cell: `ROW COLUMN "PRINTED" VALUE VERDICT … [assuming NAMES]`.
pub fn check(table: &Table<'_>, reads: &Reads, place: Place, said: &str) -> Checked<Standing> {
    let malformed = Reason::Malformed("cell ROW COLUMN \"PRINTED\" VALUE VERDICT");
    let position = format!("{} {} ", place.0 + 1, place.1 + 1);
    let said = said.strip_prefix(&position).ok_or(Reason::Cell)?;
    let (said, assumed) = said.split_once(" assuming ").unwrap_or((said, ""));
    let word = if table.is_blank(place) { "blank " } else { "lost " };
    let (printed, rest) = match (said.strip_prefix(word), table.printed(place)) {
        (Some(rest), None) => (None, rest),
        (None, Some((text, decimal))) => {
            let said = said.strip_prefix('"').and_then(|said| said.rsplit_once("\" "));
            let (found, rest) = said.ok_or(malformed.clone())?;
            agree(found, text, Reason::Printed)?;
            (Some((text, decimal)), rest)
        }
        _ => return Err(Reason::Lost.into()),
    };
    let words: Vec<&str> = rest.split_whitespace().collect();
    let (value, words) = words.split_first().ok_or(malformed.clone())?;
    let (needed, exact) = table.needed(place);
    let assumed: BTreeSet<String> = assumed.split_whitespace().map(str::to_owned).collect();
    let names = |names: &BTreeSet<String>| Vec::from_iter(names.clone()).join(" ");
    agree(&names(&assumed), &names(&needed), Reason::Assumed)?;
    let unknown = matches!(exact, Err(Stop::Unstated(_)));
    let exact = match exact {
        Err(Stop::Undefined(_) | Stop::Unstated(_)) => None,
        value => Some(value?),
    };
    same(table, value, exact.as_ref())?;
    let Some((text, decimal)) = printed else {
        require(words.is_empty(), malformed)?;
        return Ok(Standing::Other);
    };
    let verdict = words.split_first().map(|(word, rest)| (Verdict::named(word), rest));
    if unknown || verdict == Some((Some(Verdict::Unknown), &[])) {
        let found = if unknown { Verdict::Unknown.name() } else { "a value" };
        agree(&words.join(" "), found, Reason::Assumed)?;
        return Ok(Standing::Other);
    }
    let (Some(verdict), rest) = verdict.unwrap_or_default() else {
        return Err(Reason::Malformed("a verdict").into());
    };
    let cell = Cell { table, place, text, decimal, plain: needed.is_empty() };
    cell.judge(reads, exact.as_ref(), (verdict, rest))
}

/// Checks that a value of the certificate equals this value.
fn same(table: &Table<'_>, said: &str, value: Option<&Value>) -> Checked<()> {
    match value {
        Some(value) if said != "undefined" => {
            let equal = table.paper.number(said)?.equals(value)?;
            compare(equal, said, value, Reason::Value)
        }
        _ => agree(said, &shown(value), Reason::Value),
    }
}

struct Cell<'c> {
    table: &'c Table<'c>,
    place: Place,
    /// The printed text.
    text: &'c str,
    decimal: Decimal,
    /// Whether it needs no assumptions.
    plain: bool,
}

impl Cell<'_> {
    fn judge(
        &self,
        reads: &Reads,
        exact: Option<&Value>,
        (verdict, rest): (Verdict, &[&str]),
    ) -> Checked<Standing> {
        let as_printed = &self.table.as_printed;
        let found = self.rounding(exact)?;
        let not_nearest = || self.need(found != "nearest", exact, Reason::Nearest);
        match (verdict, rest) {
            (Verdict::Confirmed, []) => self.need(found == "nearest", exact, Reason::NotNearest)?,
            (Verdict::Rounding, [way @ ("cut" | "away")]) => self.rounded(exact, way)?,
            (Verdict::Rounding, [way @ ("down" | "nearest")]) => {
                require(self.is_depth(), Reason::Depth)?;
                not_nearest()?;
                let (equal, value) = self.depth_rounded(way)?;
                self.need(equal, value.as_ref(), Reason::NotRounded)?;
            }
            (Verdict::Misprint, slip) => {
                not_nearest()?;
                self.slip(&slip.join(" "), exact, Some(as_printed))?;
            }
            (Verdict::Reproduced, []) => {
                self.recovered()?;
                self.need(found == "nearest", exact, Reason::NotNearest)?;
                let read = reads.by(self.table, self.place, "");
                require(read.is_none(), Reason::NoReading)?;
                return Ok(Standing::AsPrinted);
            }
            (Verdict::OtherReading | Verdict::Reproduced, [value, rest @ ..]) => {
                let reproduced = verdict == Verdict::Reproduced;
                if reproduced {
                    self.recovered()?;
                } else {
                    not_nearest()?;
                }
                let by = rest.iter().position(|word| *word == "by");
                let (rest, by) = rest.split_at(by.unwrap_or(rest.len()));
                let name = by.get(1..).unwrap_or_default().join(" ");
                let part = reads.by(self.table, self.place, &name).ok_or(Reason::NoReading)?;
                let known = part.value(self.table, self.place)?;
                self.need(known.is_some(), None, Reason::NotExplained)?;
                same(self.table, value, known.as_ref())?;
                if reproduced {
                    require(rest.is_empty() && part.slip().is_none(), Reason::NotRecovered)?;
                    self.need(
                        self.gives(part, known.as_ref())?,
                        known.as_ref(),
                        Reason::NotExplained,
                    )?;
                    return Ok(Standing::Reproduced);
                }
                self.explained(part, known.as_ref(), rest, exact)?;
            }
            (Verdict::Refuted | Verdict::Differs, []) => {
                // Under assumptions there is no refutation, only a difference.
                let due = if self.plain { Verdict::Refuted } else { Verdict::Differs };
                compare(verdict == due, &verdict, &due, Reason::Assumed)?;
                // A depth is neither cut nor rounded away.
                let is_near = if self.is_depth() { found == "nearest" } else { found != "neither" };
                self.need(!is_near, exact, Reason::Nearest)?;
                self.no_slip(exact, Some(as_printed))?;
                for way in ["down", "nearest"].iter().filter(|_| self.is_depth()) {
                    let slip = Reason::Slip(Text(format!("{} {way}", Verdict::Rounding)));
                    require(!self.depth_rounded(way)?.0, slip)?;
                }
                self.unexplained(reads)?;
                return Ok(if self.plain { Standing::Refuted } else { Standing::Other });
            }
            _ => return Err(Reason::Malformed("a verdict").into()),
        }
        Ok(Standing::Other)
    }

    /// Checks that some parameter is not stated, and that all such parameters were recovered.
    fn recovered(&self) -> Checked<()> {
        let (needed, _) = self.table.needed(self.place);
        let known = needed.iter().all(|name| self.table.recovered.contains_key(name));
        require(known && !self.plain, Reason::NotRecovered)
    }

    /// Checks that the value under a reading explains the printed number, in the way that the words
    /// `rest` say. `exact` is the value as printed.
    fn explained(
        &self,
        part: &PartRead,
        known: Option<&Value>,
        rest: &[&str],
        exact: Option<&Value>,
    ) -> Checked<()> {
        let given = self.gives(part, known)?;
        match (rest, part.slip()) {
            (_, Some(slip)) => {
                agree(
                    &rest.join(" "),
                    &format!("{} {slip}", Verdict::Misprint),
                    Reason::NotThisSlip,
                )?;
                self.need(given, known, Reason::NotExplained)
            }
            ([], None) => self.need(given, known, Reason::NotExplained),
            ([word, way @ ("cut" | "away")], None) if *word == Verdict::Rounding.name() => {
                self.need(self.rounding(exact)? == "neither", exact, Reason::Nearest)?;
                self.rounded(known, way)?;
                self.digits("rounding")?;
                require(self.bears(part)?, Reason::GivesFew)
            }
            ([word, slip @ ..], None) => {
                require(*word == Verdict::Misprint.name(), Reason::Depth)?;
                self.slip(&slip.join(" "), known, around(part))?;
                require(self.bears(part)?, Reason::GivesFew)
            }
        }
    }

    /// Checks that no reading explains the printed number, neither directly nor by a rounding or a
    /// slip.
    fn unexplained(&self, reads: &Reads) -> Checked<()> {
        for part in reads.of(self.table, self.place) {
            let value = part.value(self.table, self.place)?;
            let Some(value) = value.as_ref() else { continue };
            let given = self.gives(part, Some(value))?;
            self.need(!given, Some(value), Reason::Explained)?;
            if part.slip().is_none() && self.bears(part)? {
                let near = ["cut", "away"].contains(&self.rounding(Some(value))?);
                let near = near && !self.is_depth() && has_digits(&self.decimal, "rounding");
                self.need(!near, Some(value), Reason::Explained)?;
                self.no_slip(Some(value), around(part))?;
            }
        }
        Ok(())
    }

    /// Whether a reading bears roundings and slips: it is that of a row or column, or gives half of the cells that it is
    /// about, or more. A reading that gives few of them may give these by luck, and a slip from its value even more so.
    fn bears(&self, part: &PartRead) -> Checked<bool> {
        if !part.is_whole() {
            return Ok(true);
        }
        let cells = self.table.cells(self.plain);
        let given =
            explained(&cells, &values(self.table, &cells, &part.read)?, part.read.decimals())?;
        Ok(given.len() * 2 >= cells.len())
    }

    /// Checks a side condition on the printed number and a value.
    fn need(&self, holds: bool, value: Option<&Value>, otherwise: Compared) -> Checked<()> {
        if holds { Ok(()) } else { compare(false, self.text, &shown(value), otherwise) }
    }

    /// Checks that the printed number has the digits that a slip needs.
    fn digits(&self, slip: &str) -> Checked<()> {
        require(has_digits(&self.decimal, slip), Reason::FewDigits(Text(self.text.to_string())))
    }

    fn gives(&self, part: &PartRead, value: Option<&Value>) -> Result<bool, Stop> {
        value.map_or(Ok(false), |value| gives(&self.decimal, value, part.read.decimals()))
    }

    fn is_depth(&self) -> bool {
        self.table.tolerance.is_some()
    }

    fn rounding(&self, value: Option<&Value>) -> Result<&'static str, Stop> {
        let Some(value) = value else { return Ok("neither") };
        Ok(match rounding(&self.decimal, value)? {
            // Of a number that is cut some digit is left.
            "cut" if telling(&self.decimal) == 0 => "neither",
            found => found,
        })
    }

    /// Checks that the printed number is the value, cut or rounded away.
    fn rounded(&self, value: Option<&Value>, way: &str) -> Checked<()> {
        require(!self.is_depth(), Reason::Depth)?;
        self.need(self.rounding(value)? == way, value, Reason::NotRounded)
    }

    /// The depth rounded in another way, and whether it is the printed number.
    fn depth_rounded(&self, way: &str) -> Result<(bool, Option<Value>), Stop> {
        let mut read = Read::default();
        read.reading.words = BTreeMap::from([("rounded".to_owned(), way.to_owned())]);
        let value = self.table.read(self.place, &read)?;
        let printed = self.decimal.value.clone().into();
        let equal = value.as_ref().map_or(Ok(false), |value| value.equals(&printed));
        equal.map(|equal| (equal, value))
    }

    /// Checks that this slip leads from the value to the printed number.
    fn slip(&self, slip: &str, value: Option<&Value>, around: Option<&Read>) -> Checked<()> {
        require(!self.is_depth(), Reason::Depth)?;
        let found = self.slips(value, around)?;
        let known = found.iter().any(|known| known == slip);
        compare(known, slip, &found.join(", "), Reason::NotThisSlip)?;
        self.digits(slip)
    }

    /// Checks that no slip leads from the value to the printed number.
    fn no_slip(&self, value: Option<&Value>, around: Option<&Read>) -> Checked<()> {
        let found = self.slips(value, around)?;
        match found.iter().find(|slip| has_digits(&self.decimal, slip)) {
            Some(slip) => Err(Reason::Slip(Text(slip.clone())).into()),
            None => Ok(()),
        }
    }

    /// The slips from the value, and from the values of the cells around under a reading.
    fn slips(&self, value: Option<&Value>, around: Option<&Read>) -> Result<Vec<String>, Stop> {
        let Some(value) = value.filter(|_| !self.is_depth()) else { return Ok(Vec::new()) };
        if self.rounding(Some(value))? != "neither" {
            return Ok(Vec::new());
        }
        let mut slips = slips(&self.decimal, value)?;
        let steps = [(0, 1), (0, -1), (1, 0), (-1, 0)].into_iter();
        for (step, read) in steps.filter_map(|step| around.map(|read| (step, read))) {
            let Some(place) = self.table.moved(self.place, step) else { continue };
            // Values that need assumptions do not count for a plain cell, and the reading of one
            // kind of cells does not apply to the other.
            let plain = self.table.is_plain(place);
            let alike = plain == self.plain || plain && self.table.is_as_printed(read);
            if !alike {
                continue;
            }
            let Some(other) = self.table.read(place, read)? else { continue };
            if other.equals(value)? || self.rounding(Some(&other))? == "neither" {
                continue;
            }
            slips.push(format!("neighbour {} {}", step.0, step.1));
            // Both cells print the value of the other.
            if let Some((_, printed)) = self.table.printed(place)
                && rounding(&printed, &other)? == "neither"
                && rounding(&printed, value)? != "neither"
                && telling(&printed) > 0
                && telling(&printed) + telling(&self.decimal) >= 5
            {
                slips.push(format!("exchanged {} {}", step.0, step.1));
            }
        }
        Ok(slips)
    }
}

/// The reading of the cells around a cell. If a row or column has its own reading, there is none.
fn around(part: &PartRead) -> Option<&Read> {
    part.is_whole().then_some(&part.read)
}
