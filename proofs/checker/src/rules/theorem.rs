//! Rule `theorem`: open, refuted by control data, or proved or refuted by a statement of
//! THEOREMS.md.

use super::Verdict;
use crate::certificate::{Block, Line};
use crate::decimal::{Q, read_rational};
use crate::evaluate::Scope;
use crate::paper::{Paper, formula_of, restates};
use crate::reject::{Checked, Reason};
use crate::ring::Ring;
use crate::scheme::{Scheme, formula};
use crate::toml::Toml;
use crate::value::{Stop, Value};
use crate::witness::{Setting, Witness, converges};
use num_traits::Signed;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The most levels of a witness.
const MAX_LEVEL: u32 = 64;

/// The names that have values of their own in a bound.
const OWN: [&str; 6] = ["k", "epsilon", "beta", "beta_1", "beta_2", "beta_3"];

/// The statements that may be cited.
const THEOREMS: &str = include_str!("../../../THEOREMS.md");

/// Checks a theorem.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Verdict<'a>> {
    if let Some((line, _)) = block.optional("open") {
        return Err(line.reject(Reason::Open));
    }
    for key in ["says", "bounds", "by"].into_iter().filter(|key| claim.get(key).is_some()) {
        let (line, said) = block.take(key)?;
        restates(line, key, said, claim.text(key))?;
    }
    for (key, word, verdict) in
        [("proved_by", "proved-by", "proved"), ("refuted_by", "refuted-by", "refuted")]
    {
        if let Some((line, said)) = block.optional(word) {
            restates(line, word, said, claim.text(key))?;
            let number = said.strip_prefix("THEOREMS ").unwrap_or_default();
            let number = number.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
            if !THEOREMS.lines().any(|line| line.starts_with(&format!("**{number}. "))) {
                return Err(line.reject(Reason::NoStatement));
            }
            block.word(verdict)?;
            let uses = claim.list("proof_uses").iter().filter_map(Toml::as_text).collect();
            return Ok(Verdict::Cited { statement: format!("THEOREMS.md, {number}"), uses });
        }
    }
    refuted(paper, claim, block).map(|()| Verdict::Other)
}

/// A scheme and values that a theorem speaks of.
struct Instance<'a> {
    scope: Scope<'a>,
    setting: Setting<'a>,
    /// The schemes, where they are masks.
    schemes: Vec<Rc<Scheme>>,
}

impl<'a> Instance<'a> {
    /// Reads `scheme …` and the lines `let …`.
    fn read(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Instance<'a>> {
        let (line, reference) = block.take("scheme")?;
        let stopped = |stop| line.reject(Reason::Stopped(stop));
        let mut known =
            claim.list("schemes").iter().map(Toml::as_text).chain([claim.text("scheme")]);
        if !known.any(|known| restates(line, "scheme", reference, known).is_ok()) {
            return Err(line.reject(Reason::Restated("scheme")));
        }
        let mut scope = paper.scope();
        scope.values.clone_from(&paper.given);
        let values = claim.get("values");
        let mut left: BTreeSet<&str> =
            claim.entries("values").iter().map(|(name, _)| name.as_str()).collect();
        while let Some((line, said)) = block.optional("let") {
            let (name, value) = said.split_once(' ').unwrap_or((said, ""));
            let value = paper.closed(line, value.trim())?;
            let is_this = |text: &Toml| -> Result<bool, Stop> {
                let text = formula(text.as_text().unwrap_or_default())?;
                Ok(paper.nothing().value(&text)?.plus(-1, &value)?.is_zero())
            };
            let listed = values.map_or(&[][..], |values| values.list(name)).iter().map(is_this);
            let listed = listed.collect::<Result<Vec<bool>, Stop>>().map_err(stopped)?;
            if !left.remove(name) || !listed.contains(&true) {
                return Err(line.reject(Reason::NotListed));
            }
            scope.values.insert(name.to_owned(), value);
        }
        if !left.is_empty() {
            return Err(line.reject(Reason::NotListed));
        }
        let of = |key: &str| claim.text(key).map(|text| scope.value(&formula(text)?)).transpose();
        let offset = of("offset").and_then(|offset| offset.map(|o| o.integer(10_000)).transpose());
        let offset = offset.map_err(stopped)?;
        let rational = || line.reject(Reason::Malformed("rational masks"));
        let (setting, schemes) = if paper.library.is_ring(reference) {
            let ring = |reference| Ring::new(paper.library, reference, &scope).map_err(stopped);
            let (own, earlier) =
                (ring(reference)?, claim.text("interpolant").map(ring).transpose()?);
            if earlier.as_ref().is_some_and(|earlier| earlier.names != own.names) {
                return Err(line.reject(Reason::Malformed("an interpolant of the same points")));
            }
            (Setting::Ring(own, earlier), Vec::new())
        } else {
            let schemes = paper.library.resolve(reference, &scope).map_err(stopped)?;
            let setting = Setting::masks(paper.library, &schemes, offset).ok_or_else(rational)?;
            scope.scheme = schemes.first().cloned();
            (setting, schemes)
        };
        let instance = Instance { scope, setting, schemes };
        if let Some(supposed) = claim.get("supposes") {
            let of = |key| formula_of(supposed, key).and_then(|text| instance.scope.value(&text));
            let above = of("value").and_then(|value| value.plus(-1, &of("below")?)?.sign(None));
            if above.map_err(stopped)? >= 0 {
                return Err(line.reject(Reason::Supposed));
            }
        }
        Ok(instance)
    }

    /// Makes sure that all control data have limits.
    fn converges(&self, line: Line<'_>) -> Checked<()> {
        let converges = match &self.setting {
            Setting::Ring(ring, _) => ring.contracts(),
            Setting::Masks(_) => {
                let each = self.schemes.iter().map(|scheme| converges(&self.scope, scheme));
                each.collect::<Result<Vec<bool>, Stop>>().map(|each| !each.contains(&false))
            }
        };
        match converges {
            Ok(true) => Ok(()),
            Ok(false) => Err(line.reject(Reason::NoLimit)),
            Err(stop) => Err(line.reject(Reason::Stopped(stop))),
        }
    }

    /// The value of a formula of the theorem.
    fn value(&self, claim: &Toml, key: &str) -> Result<Value, Stop> {
        self.scope.value(&formula_of(claim, key)?)
    }
}

/// Control data for which the bound is false.
fn refuted<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let mut instance = Instance::read(paper, claim, block)?;
    let bounds = claim.text("bounds").unwrap_or_default();
    let mut tolerance = None;
    if bounds == "depth" {
        let (line, said) = block.take("tolerance")?;
        let number = read_rational(said).filter(Q::is_positive);
        let number = number.ok_or_else(|| line.reject(Reason::Malformed("a positive number")))?;
        tolerance = Some(Value::from(number));
    } else if !["difference", "step", "distance"].contains(&bounds) {
        return Err(block.head.reject(Reason::Malformed("a theorem about a bound")));
    }
    let (line, said) = block.take("level")?;
    let from: u32 = claim.text("from").and_then(|from| from.parse().ok()).unwrap_or(0);
    let level: u32 = said.parse().map_err(|_| line.reject(Reason::Malformed("a level")))?;
    if level < from || level > MAX_LEVEL {
        return Err(line.reject(Reason::Level));
    }
    let level_line = line;
    let witness = Witness::read(paper, block)?;
    let spreads = witness.spreads(&instance.setting)?;
    let quantity = if tolerance.is_some() { "distance" } else { bounds };
    if quantity == "distance" {
        instance.converges(witness.line)?;
    }
    let left = witness.value(&instance.setting, quantity, level)?;
    let values = &mut instance.scope.values;
    values.extend(tolerance.iter().map(|value| ("epsilon".to_owned(), value.clone())));
    let beta = spreads.iter().max().cloned();
    for (name, value) in
        OWN[2..].iter().zip([beta.as_ref(), spreads.first(), spreads.get(1), spreads.first()])
    {
        // A curve and a ring have one spread, and no beta_1.
        if let Some(value) = value.filter(|_| *name == "beta" || spreads.len() == 2) {
            values.insert((*name).to_owned(), value.clone().into());
        }
    }
    if tolerance.is_none() {
        values.insert("k".to_owned(), Value::int(level.into()));
    }
    let (line, said) = block.take("sides")?;
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let by = instance.value(claim, "by").map_err(stopped)?;
    if tolerance.is_some() {
        // The level is one that the theorem calls deep enough.
        let above = by.plus(-1, &Value::int(level.into())).and_then(|above| above.sign(None));
        if above.map_err(stopped)? > 0 {
            return Err(level_line.reject(Reason::Level));
        }
    }
    violated(paper, line, said, &left, &tolerance.unwrap_or(by))?;
    block.word("refuted")
}

/// Makes sure that these are the two sides, and that the first one is larger.
pub fn violated(
    paper: &Paper<'_>,
    line: Line<'_>,
    said: &str,
    left: &Value,
    right: &Value,
) -> Checked<()> {
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let [one, other] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(line.reject(Reason::Malformed("two sides")));
    };
    for (said, side) in [(one, left), (other, right)] {
        let off = paper.closed(line, said)?.plus(-1, side).map_err(stopped)?;
        if !off.is_zero() {
            return Err(line.reject(Reason::Value));
        }
    }
    // A bound that is negative presupposes what does not hold, such as a constant below 1.
    if right.sign(None).map_err(stopped)? < 0 {
        return Err(line.reject(Reason::Negative));
    }
    let above = left.plus(-1, right).and_then(|above| above.sign(None)).map_err(stopped)?;
    if above > 0 { Ok(()) } else { Err(line.reject(Reason::NotViolated)) }
}
