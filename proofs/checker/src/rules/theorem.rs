//! Rule `theorem`: open, refuted by control data, or proved or refuted by a statement of
//! THEOREMS.md.

use super::Verdict;
use crate::certificate::Block;
use crate::decimal::{Q, read_rational};
use crate::evaluate::Scope;
use crate::paper::{Paper, formula_of};
use crate::reject::{Checked, Reason, Stop, require};
use crate::ring::Ring;
use crate::scheme::{Scheme, formula};
use crate::toml::Toml;
use crate::value::Value;
use crate::witness::{Setting, Witness, converge};
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
    require(block.maybe("open").is_none(), Reason::Open)?;
    for key in ["says", "bounds", "by"].into_iter().filter(|key| claim.get(key).is_some()) {
        block.restates(key, claim.text(key))?;
    }
    for (key, word, verdict) in
        [("proved_by", "proved-by", "proved"), ("refuted_by", "refuted-by", "refuted")]
    {
        if block.next_word() == word {
            block.restates(word, claim.text(key))?;
            let said = claim.text(key).unwrap_or_default().trim();
            let number = said.strip_prefix("THEOREMS ").unwrap_or_default();
            let number = number.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
            let mut known = THEOREMS.lines();
            let known = known.any(|line| line.starts_with(&format!("**{number}. ")));
            require(known, Reason::NoStatement)?;
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
        let reference = block.after("scheme")?;
        let line = block.at;
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let mut known =
            claim.list("schemes").iter().filter_map(Toml::as_text).chain(claim.text("scheme"));
        let known = known.any(|known| words(known) == words(reference));
        require(known, Reason::Restated("scheme"))?;
        let mut scope = paper.scope();
        scope.values.clone_from(&paper.given);
        let mut left: BTreeSet<&str> =
            claim.entries("values").iter().map(|(name, _)| name.as_str()).collect();
        while let Some(said) = block.maybe("let") {
            let (name, value) = said.split_once(' ').unwrap_or((said, ""));
            let value = paper.number(value.trim())?;
            let is_this = |text: &Toml| -> Result<bool, Stop> {
                let text = formula(text.as_text().unwrap_or_default())?;
                paper.nothing().value(&text)?.equals(&value)
            };
            let listed = claim.get("values").map_or(&[][..], |values| values.list(name)).iter();
            let listed = listed.map(is_this).collect::<Result<Vec<bool>, Stop>>()?;
            require(left.remove(name) && listed.contains(&true), Reason::NotListed)?;
            scope.values.insert(name.to_owned(), value);
        }
        let complete = require(left.is_empty(), Reason::NotListed);
        let instance = complete.and_then(|()| Self::new(paper, claim, scope, reference));
        instance.map_err(|rejection| rejection.at(line))
    }

    /// A scheme in a scope with all values.
    fn new(
        paper: &'a Paper<'a>,
        claim: &'a Toml,
        mut scope: Scope<'a>,
        reference: &str,
    ) -> Checked<Instance<'a>> {
        let of = |key: &str| claim.text(key).map(|text| scope.value(&formula(text)?)).transpose();
        let offset = of("offset")?.map(|offset| offset.integer(10_000)).transpose()?;
        let (setting, schemes) = if paper.library.is_ring(reference) {
            let ring = |reference| Ring::new(paper.library, reference, &scope);
            let (own, earlier) =
                (ring(reference)?, claim.text("interpolant").map(ring).transpose()?);
            let same = earlier.as_ref().is_none_or(|earlier| earlier.names == own.names);
            require(same, Reason::Malformed("an interpolant of the same points"))?;
            (Setting::Ring(own, earlier), Vec::new())
        } else {
            let schemes = paper.library.resolve(reference, &scope)?;
            let setting = Setting::masks(paper.library, &schemes, offset);
            scope.scheme = schemes.first().cloned();
            (setting.ok_or(Reason::Malformed("rational masks"))?, schemes)
        };
        let instance = Instance { scope, setting, schemes };
        if let Some(supposed) = claim.get("supposes") {
            let (value, below) =
                (instance.value(supposed, "value")?, instance.value(supposed, "below")?);
            require(value.compare(&below)?.is_lt(), Reason::Supposed)?;
        }
        Ok(instance)
    }

    /// Makes sure that all control data have limits.
    fn converges(&self) -> Checked<()> {
        let converges = match &self.setting {
            Setting::Ring(ring, _) => ring.contracts()?,
            Setting::Masks(_) => converge(&self.scope, &self.schemes)?,
        };
        require(converges, Reason::NoLimit)
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
        let number = read_rational(block.after("tolerance")?).filter(Q::is_positive);
        tolerance = Some(Value::from(number.ok_or(Reason::Malformed("a positive number"))?));
    } else if !["difference", "step", "distance"].contains(&bounds) {
        return Err(block.head.reject(Reason::Malformed("a theorem about a bound")));
    }
    let level = block.after("level")?.parse().map_err(|_| Reason::Malformed("a level"))?;
    let level_line = block.at;
    let from: u32 = claim.text("from").and_then(|from| from.parse().ok()).unwrap_or(0);
    require((from..=MAX_LEVEL).contains(&level), Reason::Level)?;
    let witness = Witness::read(paper, block)?;
    let spreads = witness.spreads(&instance.setting)?;
    let quantity = if tolerance.is_some() { "distance" } else { bounds };
    if quantity == "distance" {
        instance.converges()?;
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
    let sides = block.after("sides")?;
    let by = instance.value(claim, "by")?;
    if tolerance.is_some() {
        // The level is one that the theorem calls deep enough.
        let deep = by.compare(&Value::int(level.into()))?.is_le();
        require(deep, Reason::Level).map_err(|rejection| rejection.at(level_line))?;
    }
    violated(paper, sides, &left, &tolerance.unwrap_or(by))?;
    block.word("refuted")
}

/// Makes sure that these are the two sides, and that the first one is larger.
pub fn violated(paper: &Paper<'_>, said: &str, left: &Value, right: &Value) -> Checked<()> {
    let [one, other] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(Reason::Malformed("two sides").into());
    };
    require(paper.number(one)?.equals(left)?, Reason::Value)?;
    require(paper.number(other)?.equals(right)?, Reason::Value)?;
    // A bound that is negative presupposes what does not hold, such as a constant below 1.
    require(right.sign(None)? >= 0, Reason::Negative)?;
    require(left.compare(right)?.is_gt(), Reason::NotViolated)
}
