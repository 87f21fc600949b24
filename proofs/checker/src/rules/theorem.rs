//! The rule `theorem`: a theorem is open, or control data refute it, or finitely many levels prove
//! it, or a statement of THEOREMS.md decides it.

use super::instance::{Instance, first_level};
use super::levels;
use crate::certificate::Block;
use crate::decimal::{Q, read_rational};
use crate::definitions::formula_of;
use crate::paper::Paper;
use crate::reject::{Checked, Reason, require};
use crate::toml::Toml;
use crate::value::Value;
use crate::witness::{Points, Witness, violated};
use num_traits::Signed;

/// The greatest level of a witness.
const MAX_LEVEL: u32 = 64;

/// The statements that may be cited.
const THEOREMS: &str = include_str!("../../THEOREMS.md");

/// A statement of THEOREMS.md that decides a theorem, if some claims hold.
pub struct Citation {
    /// The statement.
    pub statement: String,
    /// The ids of the claims.
    pub uses: Vec<String>,
}

/// Checks a theorem; gives the statement that is cited, if one is.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
) -> Checked<Option<Citation>> {
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
            if block.next_word() == "grows" {
                return levels::check(paper, claim, block, instance).map(|()| None);
            }
            refuted(paper, claim, block, instance, Points::Indexed)?;
            if block.next_word() == "naturally" {
                block.word("naturally")?;
                let instance = Instance::read(paper, claim, block)?;
                refuted(paper, claim, block, instance, Points::Natural)?;
            }
            block.word("refuted")?;
            return Ok(None);
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
    Ok(Some(Citation { statement: format!("THEOREMS.md, {number}"), uses }))
}

/// Checks control data that violate the bound, with the points there.
fn refuted<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    Instance { mut scope, setting, .. }: Instance<'a>,
    points: Points,
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
    let left = witness.value(&setting, quantity, (level, points))?;
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
        // The theorem calls this level deep enough.
        require(by.compare(&Value::int(level.into()))?.is_le(), Reason::Level)?;
    }
    let right = tolerance.unwrap_or(by);
    // A negative bound presupposes something that does not hold, such as a constant below 1.
    require(right.sign(None)? >= 0, Reason::Negative)?;
    violated(paper, said, &left, &right)
}
