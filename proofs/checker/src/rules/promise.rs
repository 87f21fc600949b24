//! Rule `promise`: whether what a table promises of its printed numbers is true for all control
//! data, cell by cell.

use super::place;
use super::sound::Promised;
use super::theorem::violated;
use crate::certificate::Block;
use crate::convolution::classes;
use crate::decimal::Q;
use crate::functional::{MAX_LEVEL, Rules};
use crate::functions::greatest;
use crate::reject::{Checked, Reason, Stop, require};
use crate::ring::Ring;
use crate::table::Table;
use crate::value::Value;
use crate::witness::{Setting, Witness, converge};
use num_traits::Zero;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most points of a level that are looked at.
const MAX_POINTS: i64 = 1 << 16;

/// Checks the lines `witness`, and those of the cells.
pub fn check<'a>(table: &'a Table<'a>, block: &mut Block<'_>) -> Checked<()> {
    let mut witnesses = BTreeMap::new();
    while let Some(name) = block.maybe("witness") {
        require(!witnesses.contains_key(name), Reason::Taken)?;
        witnesses.insert(name, Witness::read(table.paper, block)?);
    }
    if table.claim.get("promise").is_none() {
        return Ok(());
    }
    let mut settings = Settings::new();
    for at in table.places() {
        let Some((_, printed)) = table.printed(at) else { continue };
        let verdict = block.next_word();
        block.look();
        require(["kept", "broken", "undecided"].contains(&verdict), Reason::Promises)?;
        let (found, said) = place(table, block.any()?.1)?;
        let proper = found == at && (verdict != "undecided" || said.is_empty());
        require(proper, Reason::Promises)?;
        if verdict == "undecided" {
            continue;
        }
        let promised = Promised::new(table, at)?;
        let printed = Value::from(printed.value());
        let (level, most) = match (&promised.level, &promised.tolerance) {
            (Some(level), _) => (*level, printed),
            (None, Some(tolerance)) => {
                (printed.integer(MAX_LEVEL.into()).unwrap_or(-1), tolerance.clone())
            }
            (None, None) => return Err(Reason::NoPromise.into()),
        };
        let level = u32::try_from(level).ok().filter(|level| *level <= MAX_LEVEL);
        let level = level.ok_or(Reason::Malformed("a level"))?;
        let setting = setting(&promised, &mut settings)?;
        if verdict == "kept" {
            kept(&promised, &setting, said, level, &most)?;
            continue;
        }
        let (name, sides) = said.split_once(' ').unwrap_or((said, ""));
        let witness = witnesses.get(name).ok_or(Reason::NoWitness)?;
        let spread = witness.spreads(&setting)?.into_iter().max().unwrap_or_else(Q::zero);
        let flat = require(!spread.is_zero(), Reason::Malformed("data that are not all equal"));
        flat.map_err(|rejection| rejection.at(witness.line))?;
        let distance = witness.value(&setting, "distance", level)?;
        let left = distance.times(&promised.spread)?.over(&spread.into())?;
        violated(table.paper, sides, &left, &most)?;
    }
    Ok(())
}

/// Schemes of which all control data have limits.
type Settings<'a> = BTreeMap<String, Rc<Setting<'a>>>;

/// What a cell speaks of.
fn setting<'a>(promised: &Promised<'a>, known: &mut Settings<'a>) -> Checked<Rc<Setting<'a>>> {
    let Promised { table, scope, schemes, offset, .. } = promised;
    let library = table.paper.library;
    let ring = table.claim.get("promise").and_then(|promise| promise.text("ring"));
    let key = match ring {
        Some(ring) => format!("{:?}", library.entry(ring, scope)?.2),
        None => format!("{:?} {offset:?}", schemes.iter().map(Rc::as_ptr).collect::<Vec<_>>()),
    };
    if let Some(known) = known.get(&key) {
        return Ok(Rc::clone(known));
    }
    let (setting, contracts) = if let Some(ring) = ring {
        let ring = Ring::new(library, ring, scope)?;
        let contracts = ring.contracts()?;
        (Setting::Ring(ring, None), contracts)
    } else {
        let masks = Setting::masks(library, schemes, *offset).filter(|_| !schemes.is_empty());
        (masks.ok_or(Reason::Malformed("rational masks"))?, converge(scope, schemes)?)
    };
    require(contracts, Reason::NoLimit)?;
    let setting = Rc::new(setting);
    known.insert(key, Rc::clone(&setting));
    Ok(setting)
}

/// Checks `L M c`: the sound bound at level L, and how far level L is from level k, are together
/// at most what is promised.
fn kept(
    promised: &Promised<'_>,
    setting: &Setting<'_>,
    said: &str,
    level: u32,
    most: &Value,
) -> Checked<()> {
    let malformed = Reason::Malformed("ROW COLUMN L M c, L from the level on");
    let (later, constants) = said.split_once(' ').ok_or(malformed.clone())?;
    let later: u32 = later.parse().ok().filter(|l| *l >= level).ok_or(malformed.clone())?;
    let bound = promised.bound(i64::from(later), constants)?;
    let change = match setting {
        _ if later == level => Value::int(0),
        Setting::Masks(rules) => change(promised, rules, level, later)?,
        Setting::Ring(..) => return Err(malformed.into()),
    };
    let sum = bound.plus(1, &change.times(&promised.spread)?)?;
    require(sum.compare(most)?.is_le(), Reason::TooLarge)
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
    Ok(if one.compare(&other)?.is_lt() { one } else { other })
}
