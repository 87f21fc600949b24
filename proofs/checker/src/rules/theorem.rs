//! Rule `theorem`: open, refuted by control data, proved by finitely many levels, or proved or
//! refuted by a statement of THEOREMS.md.

use super::{Verdict, levels};
use crate::certificate::Block;
use crate::decimal::{Q, read_rational};
use crate::evaluate::Scope;
use crate::names::OF_THEOREMS;
use crate::paper::{Paper, formula_of};
use crate::reject::{Checked, Reason, Stop, require};
use crate::ring::Ring;
use crate::scheme::{Scheme, formula};
use crate::toml::Toml;
use crate::value::Value;
use crate::witness::{Setting, Witness};
use num_traits::Signed;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The most levels of a witness.
const MAX_LEVEL: u32 = 64;

/// The statements that may be cited.
const THEOREMS: &str = include_str!("../../../THEOREMS.md");

/// Checks a theorem.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Verdict> {
    require(block.maybe("open").is_none(), Reason::Open)?;
    for key in ["says", "bounds", "by"] {
        if claim.get(key).is_some() {
            block.restates(key, claim.text(key))?;
        }
    }
    let next = block.next_word();
    let (word, text, verdict) = match next {
        "proved-by" => ("proved-by", claim.text("proved_by"), "proved"),
        "refuted-by" => ("refuted-by", claim.text("refuted_by"), "refuted"),
        _ => {
            let instance = Instance::read(paper, claim, block)?;
            let rule = if block.next_word() == "grows" { levels::check } else { refuted };
            return rule(paper, claim, block, instance).map(|()| Verdict::Other);
        }
    };
    block.restates(word, text)?;
    let number = text.and_then(|text| text.strip_prefix("THEOREMS ")).unwrap_or_default();
    let number = number.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
    let heading = format!("**{number}. ");
    require(THEOREMS.lines().any(|line| line.starts_with(&heading)), Reason::NoStatement)?;
    block.word(verdict)?;
    let uses =
        claim.list("proof_uses").iter().filter_map(Toml::as_text).map(str::to_owned).collect();
    Ok(Verdict::Cited { statement: format!("THEOREMS.md, {number}"), uses })
}

/// A scheme and values that a theorem speaks of.
pub struct Instance<'a> {
    /// With the parameters.
    pub scope: Scope<'a>,
    /// The factors of the scheme; none of a ring.
    pub schemes: Vec<Rc<Scheme>>,
    /// The offset at which masks are taken, if not their own.
    pub offset: Option<i64>,
    /// What data are refined by.
    pub setting: Setting<'a>,
}

impl<'a> Instance<'a> {
    /// Reads `scheme …` and the lines `let …`.
    fn read(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Instance<'a>> {
        let reference = block.after("scheme")?;
        let known = claim.list("schemes").iter().map(Toml::as_text).chain([claim.text("scheme")]);
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let listed = known.flatten().any(|known| words(known) == words(reference));
        require(listed, Reason::Restated("scheme"))?;
        let mut scope = paper.scope();
        scope.values.clone_from(&paper.given);
        // What these mean is for the theorem to say, not for the paper.
        scope.values.retain(|name, _| !OF_THEOREMS.contains(&&name[..]));
        scope.reserved = &OF_THEOREMS;
        let mut left: BTreeSet<&String> =
            claim.entries("values").iter().map(|(name, _)| name).collect();
        while let Some(said) = block.maybe("let") {
            let (name, value) = said.split_once(' ').unwrap_or((said, ""));
            let value = paper.number(value.trim())?;
            let same = |text: &Toml| {
                let known = paper.nothing().value(&formula(text.as_text().unwrap_or_default())?)?;
                known.equals(&value)
            };
            let values = claim.get("values").map_or(&[][..], |values| values.list(name));
            let same = values.iter().map(same).collect::<Result<Vec<bool>, Stop>>()?;
            require(left.remove(&name.to_owned()) && same.contains(&true), Reason::NotListed)?;
            scope.values.insert(name.to_owned(), value);
        }
        require(left.is_empty(), Reason::NotListed)?;
        let (mut schemes, mut offset) = (Vec::new(), None);
        let setting = if paper.library.is_ring(reference) {
            let ring = |reference: &str| Ring::new(paper.library, reference, &scope);
            let (own, earlier) =
                (ring(reference)?, claim.text("interpolant").map(ring).transpose()?);
            let alike = earlier.as_ref().is_none_or(|earlier| earlier.names == own.names);
            require(alike, Reason::Malformed("an interpolant of the same points"))?;
            Setting::Ring(Box::new(own), earlier.map(Box::new))
        } else {
            schemes = paper.library.resolve(reference, &scope)?;
            let said = claim.text("offset").map(|text| scope.value(&formula(text)?)).transpose()?;
            offset = said.map(|offset| offset.integer(10_000)).transpose()?;
            scope.scheme = schemes.first().map(Rc::clone);
            Setting::masks(&scope, &schemes, offset)?
        };
        if let Some(supposed) = claim.get("supposes") {
            let of = |key| scope.value(&formula_of(supposed, key)?);
            require(of("value")?.compare(&of("below")?)?.is_lt(), Reason::Supposed)?;
        }
        Ok(Instance { scope, schemes, offset, setting })
    }
}

/// The first level that a bound is stated for.
pub fn first_level(claim: &Toml) -> Result<u32, Stop> {
    match claim.text("from") {
        None if claim.text("bounds") == Some("depth") => Ok(0),
        from => {
            from.and_then(|from| from.parse().ok()).ok_or(Stop::Wrong("`from` is no level".into()))
        }
    }
}

/// Control data for which the bound is false.
fn refuted<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    Instance { mut scope, setting, .. }: Instance<'a>,
) -> Checked<()> {
    let (bounds, mut tolerance) = (claim.text("bounds").unwrap_or_default(), None);
    if bounds == "depth" {
        let number = read_rational(block.after("tolerance")?).filter(Q::is_positive);
        tolerance = Some(Value::from(number.ok_or(Reason::Malformed("a positive number"))?));
    }
    let said = block.after("level")?;
    let from = first_level(claim)?;
    let level: u32 = said.parse().map_err(|_| Reason::Malformed("a level"))?;
    require((from..=MAX_LEVEL).contains(&level), Reason::Level)?;
    let witness = Witness::read(paper, block)?;
    let spreads = witness.spreads(&setting)?;
    let quantity = if tolerance.is_some() { "distance" } else { bounds };
    let left = witness.value(&setting, quantity, level)?;
    let mut name = |name: &str, value: Value| scope.values.insert(name.to_owned(), value);
    name("beta", spreads.iter().max().cloned().unwrap_or_default().into());
    if let [first, second] = &spreads[..] {
        name("beta_1", first.clone().into());
        name("beta_2", second.clone().into());
        name("beta_3", first.clone().into());
    }
    match &tolerance {
        Some(tolerance) => name("epsilon", tolerance.clone()),
        None => name("k", Value::int(level.into())),
    };
    let said = block.after("sides")?;
    let by = scope.value(&formula_of(claim, "by")?)?;
    if tolerance.is_some() {
        // The level is one that the theorem calls deep enough.
        require(by.compare(&Value::int(level.into()))?.is_le(), Reason::Level)?;
    }
    let right = tolerance.unwrap_or(by);
    // A bound that is negative presupposes what does not hold, such as a constant below 1.
    require(right.sign(None)? >= 0, Reason::Negative)?;
    violated(paper, said, &left, &right)?;
    block.word("refuted")
}

/// Makes sure that these are the two sides, and that the first one is larger.
pub fn violated(paper: &Paper<'_>, said: &str, left: &Value, right: &Value) -> Checked<()> {
    let [one, other] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(Reason::Malformed("two sides").into());
    };
    require(paper.number(one)?.equals(left)?, Reason::Value)?;
    require(paper.number(other)?.equals(right)?, Reason::Value)?;
    require(left.compare(right)?.is_gt(), Reason::NotViolated)
}
