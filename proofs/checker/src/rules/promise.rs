//! Rule `promise`: whether what a table promises of its printed numbers is true for all control
//! data, cell by cell.

use super::place;
use super::sound::Promised;
use super::theorem::violated;
use crate::certificate::{Block, Line};
use crate::convolution::classes;
use crate::decimal::Q;
use crate::functional::{MAX_LEVEL, Rules};
use crate::functions::greatest;
use crate::reject::{Checked, Reason};
use crate::ring::Ring;
use crate::table::Table;
use crate::value::{Stop, Value};
use crate::witness::{Setting, Witness, converges};
use num_traits::Zero;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most points of a level that are looked at.
const MAX_POINTS: i64 = 1 << 16;

/// Checks the lines `witness`, and those of the cells.
pub fn check<'a>(table: &'a Table<'a>, block: &mut Block<'_>) -> Checked<()> {
    let mut witnesses = BTreeMap::new();
    while let Some((line, name)) = block.optional("witness") {
        let witness = Witness::read(table.paper, block)?;
        if witnesses.insert(name, witness).is_some() {
            return Err(line.reject(Reason::Taken));
        }
    }
    if table.claim.get("promise").is_none() {
        return Ok(());
    }
    let mut settings = Settings::new();
    let (rows, columns) = table.size();
    for at in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let Some((_, printed)) = table.printed(at.0, at.1) else { continue };
        let (verdict, (line, said)) = ["kept", "broken", "undecided"]
            .into_iter()
            .find_map(|verdict| Some((verdict, block.optional(verdict)?)))
            .ok_or_else(|| block.peek().unwrap_or(block.head).reject(Reason::Promises))?;
        let (found, said) = place(table, line, said)?;
        if found != at || verdict == "undecided" && !said.is_empty() {
            return Err(line.reject(Reason::Promises));
        }
        if verdict == "undecided" {
            continue;
        }
        let promised = Promised::new(table, line, at)?;
        let printed = Value::from(printed.value());
        let (level, most) = match (&promised.level, &promised.tolerance) {
            (Some(level), _) => (*level, printed),
            (None, Some(tolerance)) => {
                (printed.integer(MAX_LEVEL.into()).unwrap_or(-1), tolerance.clone())
            }
            (None, None) => return Err(line.reject(Reason::NoPromise)),
        };
        let level = u32::try_from(level).ok().filter(|level| *level <= MAX_LEVEL);
        let level = level.ok_or_else(|| line.reject(Reason::Malformed("a level")))?;
        let setting = setting(&promised, line, &mut settings)?;
        if verdict == "kept" {
            kept(&promised, &setting, line, said, (level, &most))?;
            continue;
        }
        let (name, sides) = said.split_once(' ').unwrap_or((said, ""));
        let witness = witnesses.get(name).ok_or_else(|| line.reject(Reason::NoWitness))?;
        let spread = witness.spreads(&setting)?.into_iter().max().unwrap_or_else(Q::zero);
        if spread.is_zero() {
            return Err(witness.line.reject(Reason::Malformed("data that are not all equal")));
        }
        let distance = witness.value(&setting, "distance", level)?;
        let left = distance.times(&promised.spread).and_then(|left| left.over(&spread.into()));
        let left = left.map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        violated(table.paper, line, sides, &left, &most)?;
    }
    Ok(())
}

/// Schemes of which all control data have limits.
type Settings<'a> = BTreeMap<String, Rc<Setting<'a>>>;

/// What a cell speaks of.
fn setting<'a>(
    promised: &Promised<'a>,
    line: Line<'_>,
    known: &mut Settings<'a>,
) -> Checked<Rc<Setting<'a>>> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let Promised { table, scope, schemes, offset, .. } = promised;
    let library = table.paper.library;
    let ring = table.claim.get("promise").and_then(|promise| promise.text("ring"));
    let key = match ring {
        Some(ring) => format!("{:?}", library.entry(ring, scope).map_err(stopped)?.2),
        None => format!("{:?} {offset:?}", schemes.iter().map(Rc::as_ptr).collect::<Vec<_>>()),
    };
    if let Some(known) = known.get(&key) {
        return Ok(Rc::clone(known));
    }
    let (setting, contracts) = if let Some(ring) = ring {
        let ring = Ring::new(library, ring, scope).map_err(stopped)?;
        let contracts = ring.contracts();
        (Setting::Ring(ring, None), contracts)
    } else {
        let masks = Setting::masks(library, schemes, *offset).filter(|_| !schemes.is_empty());
        let each = schemes.iter().map(|scheme| converges(scope, scheme));
        let each = each.collect::<Result<Vec<bool>, Stop>>();
        let rational = || line.reject(Reason::Malformed("rational masks"));
        (masks.ok_or_else(rational)?, each.map(|each| !each.contains(&false)))
    };
    if !contracts.map_err(stopped)? {
        return Err(line.reject(Reason::NoLimit));
    }
    let setting = Rc::new(setting);
    known.insert(key, Rc::clone(&setting));
    Ok(setting)
}

/// Checks `L M c`: the sound bound at level L, and how far level L is from level k, are together
/// at most what is promised.
fn kept(
    promised: &Promised<'_>,
    setting: &Setting<'_>,
    line: Line<'_>,
    said: &str,
    (level, most): (u32, &Value),
) -> Checked<()> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let malformed = || line.reject(Reason::Malformed("ROW COLUMN L M c, L from the level on"));
    let [later, constants] = said.splitn(2, ' ').collect::<Vec<&str>>()[..] else {
        return Err(malformed());
    };
    let later: u32 = later.parse().ok().filter(|l| *l >= level).ok_or_else(malformed)?;
    let bound = promised.bound(line, i64::from(later), constants)?;
    let change = if later == level {
        Value::int(0)
    } else {
        let Setting::Masks(rules) = setting else { return Err(malformed()) };
        change(promised, rules, level, later).map_err(stopped)?
    };
    let sum = change.times(&promised.spread).and_then(|change| bound.plus(1, &change));
    let above = sum.and_then(|sum| sum.plus(-1, most)?.sign(None)).map_err(stopped)?;
    if above > 0 { Err(line.reject(Reason::TooLarge)) } else { Ok(()) }
}

/// A bound of ‖P^l − P^k‖ for the spread 1.
fn change(promised: &Promised<'_>, rules: &[Rules<'_>], k: u32, l: u32) -> Result<Value, Stop> {
    let largest = |rules: &Rules<'_>| -> Result<Value, Stop> {
        let count = rules.arity().checked_pow(l).filter(|count| *count <= MAX_POINTS);
        let count = count.ok_or(Stop::Capped("the points of a level"))?;
        let mut largest = Q::zero();
        for i in 0..count {
            let new = rules.at(l, &Q::from_integer(i.into()))?;
            let old = rules.polygon(k, &Q::new(i.into(), count.into()))?;
            largest = largest.max(new.minus(&old).norm_on_differences());
        }
        Ok(largest.into())
    };
    let [first, second] = rules else { return largest(&rules[0]) };
    // THEOREMS.md, 32, with level l in place of the limit.
    let norm = |axis: usize, level: u32| {
        let scheme = &promised.schemes[axis];
        let sums = classes(&promised.scope, scheme, "a", false, &Value::int(level.into()))?;
        greatest(&promised.scope, &sums)
    };
    let (c, d) = (largest(first)?, largest(second)?);
    let one = c.times(&norm(1, l)?)?.plus(1, &d.times(&norm(0, k)?)?)?;
    let other = d.times(&norm(0, l)?)?.plus(1, &c.times(&norm(1, k)?)?)?;
    let least = one.plus(1, &other)?.plus(-1, &one.max(&other, None)?)?;
    Ok(least)
}
