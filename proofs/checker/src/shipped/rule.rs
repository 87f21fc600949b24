//! The rule for constants of programs (proofs/format/shipped.md).

use super::literal::{read as read_literal, same};
use super::reading::Reading;
use super::table::Table;
use super::value::{Change, Values};
use super::verdict::{Verdict, verdict};
use crate::claims::Counts;
use crate::enclosures::Interval;
use crate::formulas::Definitions;
use crate::numbers::Meter;
use crate::text::{At, Block, Checked, Outcome, Reason, Stop, Toml, agree, compare, require};

/// The least and the greatest number of binary digits of enclosures.
const BITS: std::ops::RangeInclusive<u64> = 64..=20_000;

/// Checks a block about a table, and says the outcome with the counts of the verdicts.
pub fn check(claim: &Toml, definitions: &Definitions, mut block: Block<'_>) -> Checked<String> {
    judge(claim, definitions, &mut block).at(block.at)
}

fn judge(claim: &Toml, definitions: &Definitions, block: &mut Block<'_>) -> Checked<String> {
    let meter = &Meter::default();
    let table = Table::read(claim, definitions)?;
    let bits: Option<u64> = block.after("bits")?.parse().ok();
    let bits = bits.filter(|bits| BITS.contains(bits));
    let bits = bits.ok_or(Reason::Malformed("`bits` and a number from 64 to 20000"))?;
    let reading = if let Some(text) = block.maybe("convention") {
        Some(Reading::convention(text, &table)?)
    } else if let Some(text) = block.maybe("early") {
        Some(Reading::early(text, definitions)?)
    } else {
        None
    };
    let rounding = |value: &Interval| match &reading {
        Some(Reading::Early(_, rounding)) => rounding.of(value),
        _ => Ok(value.clone()),
    };
    let change: Option<Change<'_>> = match &reading {
        Some(Reading::Early(name, _)) => Some((name, &rounding)),
        _ => None,
    };
    let printed = Values::new(definitions, bits, meter, None);
    let read = Values::new(definitions, bits, meter, change);
    let mut counts = Counts::default();
    let (mut worst, mut better, mut is_open) = (Outcome::Nearest, false, false);
    for place in 0..table.count {
        let (said, number) = cell(&table, block, place)?;
        let found = if Outcome::named(said) == Some(Outcome::Open) {
            Verdict::Open
        } else {
            verdict(&table.value(&table.exact, place, &printed)?, &number, table.of)?
        };
        compare(found.to_string() == said, said, &found, Reason::Verdict)?;
        is_open |= found == Verdict::Open;
        // What is open is not shown to be wrong, and so no need of a reading.
        require(reading.is_none() || found != Verdict::Open, Reason::NoNeed)?;
        if let Some(reading) = &reading {
            let by_reading = table.value(reading.exact(&table), place, &read)?;
            let by_reading = verdict(&by_reading, &number, table.of)?;
            compare(by_reading.is_right(), &(place + 1), &by_reading, Reason::NotRight)?;
            better |= by_reading.outcome() < found.outcome();
        }
        counts.add(found.outcome().name());
        worst = worst.max(found.outcome());
    }
    let outcome = match &reading {
        // Numbers that are the nearest, rounded or cut need no reading.
        // A reading by which no number is better explains nothing.
        Some(_) if worst <= Outcome::Cut || !better => return Err(Reason::NoNeed.into()),
        Some(_) => Outcome::Otherwise,
        None => worst,
    };
    let said = block.after("outcome")?;
    agree(said, outcome.name(), Reason::Verdict)?;
    block.finished()?;
    // Nothing is computed of a number that is open, and so nothing of the table is certified.
    require(!is_open, Reason::OpenNumber)?;
    Ok(format!("{outcome}: {}", counts.text()))
}

/// Takes the line of a number: `cell I… "LITERAL" VERDICT`. Gives the verdict that it states, and
/// the number.
fn cell<'b>(
    table: &Table<'_>,
    block: &mut Block<'b>,
    place: usize,
) -> Checked<(&'b str, super::literal::Shipped)> {
    require(block.next_word() == "cell", Reason::CellsMissing)?;
    let line = block.after("cell")?;
    let malformed = || Reason::Malformed("a number in quotes, and its verdict");
    let (at, rest) = line.split_once('"').ok_or_else(malformed)?;
    let (literal, said) = rest.rsplit_once('"').ok_or_else(malformed)?;
    let at: Vec<&str> = at.split_whitespace().collect();
    let indices = table.at(place);
    let is_here = |(text, (_, value)): (&&str, &(String, i64))| *text == value.to_string();
    let here = at.len() == indices.len() && at.iter().zip(&indices).all(is_here);
    require(here, Reason::Cell)?;
    if let Some(typed) = &table.typed {
        compare(same(typed[place], literal), literal, typed[place], Reason::Printed)?;
    }
    let number = read_literal(literal, table.language, table.of)?;
    if number.held.is_none() {
        return Err(Stop::Wrong(format!("{literal} is not finite")).into());
    }
    Ok((said.trim(), number))
}
