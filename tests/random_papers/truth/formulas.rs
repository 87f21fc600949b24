//! Equations, functions and ranges, at many values of what is free in them.

use crate::random_papers::draft::{Draft, Identity, Parametric};
use crate::random_papers::formula::{Env, Tree};
use crate::random_papers::naive::{Q, int};
use crate::random_papers::program::Block;
use num_traits::Signed;

/// Numbers without a simple relation between them.
fn arbitrary(turn: i64, place: i64) -> Q {
    Q::new((7 * turn * turn + 13 * place * turn + 3 * place + 5).into(), (turn + 11).into())
}

/// Whether an equation holds in all cases, where its hypotheses do; `None` where that is not looked
/// at.
fn holds(draft: &Draft, identity: &Identity) -> Option<bool> {
    let hypotheses = identity.hypotheses.as_ref()?;
    for case in &identity.cases {
        for turn in 1..=6 {
            let mut env = Env { definitions: Some(&draft.names.definitions), ..Env::default() };
            for (place, symbol) in (0..).zip(["a", "b"]) {
                env.values.insert(symbol.to_owned(), arbitrary(turn, place));
            }
            for i in -1..=4 {
                env.values.insert(format!("q[{i}]"), arbitrary(turn, 5 + i));
            }
            env.values.extend(case.iter().cloned());
            for [member, value] in hypotheses {
                let value = env.value(value)?;
                env.values.insert(member.to_string(), value);
            }
            if env.value(&identity.left)? != env.value(&identity.right)? {
                return Some(false);
            }
        }
    }
    Some(true)
}

pub fn equation(draft: &Draft, identity: &Identity, block: &Block) -> Result<(), String> {
    let said = block.after("holds").is_some();
    match holds(draft, identity) {
        Some(found) if found != said => {
            Err(format!("the equation does otherwise: holds is {found}"))
        }
        _ => Ok(()),
    }
}

/// Sides at a value of the parameter.
fn at(draft: &Draft, claim: &Parametric, tree: &Tree, w: &Q) -> Option<Q> {
    let (family, factor) = &claim.scheme;
    let curve = draft.families[*family].at(&(w * factor));
    let mut values = draft.names.given.clone();
    values.insert("w".to_owned(), w.clone());
    Env { values, definitions: Some(&draft.names.definitions), scheme: Some(&curve) }.value(tree)
}

pub fn parametric(draft: &Draft, claim: &Parametric, block: &Block) -> Result<(), String> {
    let samples = (-12..=12).chain([-30, 30]).map(|p| Q::new((2 * p + 1).into(), 17.into()));
    let samples: Vec<Q> = samples.chain((-3..=3).map(|p| Q::new(p.into(), 4.into()))).collect();
    if let Some([left, right]) = &claim.sides {
        let differs = |w: &&Q| at(draft, claim, left, w) != at(draft, claim, right, w);
        let different = samples.iter().find(differs);
        if let (Some(w), "holds") = (different, block.verdict()) {
            return Err(format!("the sides differ: at {w}"));
        }
        if let Some(example) = block.after("fails") {
            let numbers: Vec<Q> = example.split(' ').filter_map(|text| text.parse().ok()).collect();
            let [w, one, other] = &numbers[..] else { return Ok(()) };
            let sides = [left, right].map(|side| at(draft, claim, side, w));
            if sides != [Some(one.clone()), Some(other.clone())] || one == other {
                return Err(format!("the example is wrong: {sides:?}"));
            }
        }
    }
    if let Some((value, at_most, ends)) = &claim.range {
        if block.verdict() == "inexact" {
            return Ok(());
        }
        let [from, to] = ends;
        let near = Q::new(1.into(), 50.into());
        for w in &samples {
            if (w - from).abs() < near || (w - to).abs() < near {
                continue;
            }
            let Some(value) = at(draft, claim, value, w) else { continue };
            let inside = value < int(1) || (*at_most && value == int(1));
            if inside != (from < w && w < to) {
                return Err(format!("the range is another one: at {w} the value is {value}"));
            }
        }
    }
    Ok(())
}
