//! What is proved, or refuted, by data refined by the letter of the definitions.

mod formulas;
mod proved;
mod refuted;
mod shift;

pub use refuted::Witness;

use crate::random_papers::draft::{Bound, Claim, Draft, Instance, Known, Shape, environment};
use crate::random_papers::failure::{Checked, Failure};
use crate::random_papers::formula::Env;
use crate::random_papers::naive::{Net, Q, int};
use crate::random_papers::program::{Block, blocks, checked, written};
use subcert_check::Outcome;

/// The names of a bound in an instance: spreads, and the level or the tolerance.
pub fn names<'d>(
    draft: &'d Draft,
    instance: &'d Instance,
    spreads: &[Q],
    last: (&str, Q),
) -> Env<'d> {
    let mut env = environment(draft, &instance.values);
    env.scheme = match &instance.shape {
        Shape::Curve(curve) | Shape::Net(Net([curve, _])) => Some(curve),
        Shape::LocalRules(..) => None,
    };
    let mut name = |name: &str, value: Q| env.values.insert(name.to_owned(), value);
    name("beta", spreads.iter().max().cloned().unwrap_or_default());
    if let [first, second] = spreads {
        name("beta_1", first.clone());
        name("beta_2", second.clone());
        name("beta_3", first.clone());
    }
    name(last.0, last.1);
    env
}

/// Whether what the theorem supposes holds in an instance.
fn supposed(draft: &Draft, bound: &Bound, instance: &Instance) -> bool {
    let Some([value, below]) = &bound.supposes else { return true };
    let mut env = names(draft, instance, &[], ("", int(0)));
    for name in ["beta", ""] {
        env.values.remove(name);
    }
    env.values.extend(draft.names.given.clone());
    env.values.extend(instance.values.iter().cloned());
    matches!((env.value(value), env.value(below)), (Some(value), Some(below)) if value < below)
}

/// Every claim whose verdict is certified is true or false as the certificate says.
pub fn of_claims(draft: &Draft) -> Checked {
    let text = draft.text();
    let Some(certificate) = written(&text) else { return Ok(()) };
    let blocks = blocks(&certificate);
    let outcomes = checked(&text, &certificate).unwrap_or_default();
    for claim in &draft.claims {
        let valid = outcomes.contains(&(claim.id.clone(), Outcome::Valid));
        let block = blocks.iter().find(|block| block.id == claim.id);
        if let (Some(block), true) = (block, valid) {
            stands(draft, claim, block)?;
        }
    }
    Ok(())
}

/// A block is right by the letter.
fn stands(draft: &Draft, claim: &Claim, block: &Block) -> Checked {
    let found = match (&claim.known, block.verdict()) {
        (Known::Bound(bound), "proved") => proved::holds(draft, bound),
        (Known::Bound(bound), "refuted") => refuted::violates(draft, bound, block),
        (Known::Identity(identity), _) => formulas::equation(draft, identity, block),
        (Known::Parametric(parametric), _) => formulas::parametric(draft, parametric, block),
        _ => Ok(()),
    };
    found.map_err(|why| {
        let kind = why.split(':').next().unwrap_or_default();
        let what = format!("a certified {} is not so: {kind}", claim.kind);
        Failure::new(what, &draft.with([claim]), format!("{why}\n{}", block.text))
    })
}
