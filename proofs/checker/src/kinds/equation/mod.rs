//! The rule `equation`: two sides as polynomials in the symbols, in every case.

pub mod cases;
mod hypotheses;
pub mod scopes;

use super::kind::{Kind, Proof};
use crate::claims::{Axis, Paper};
use crate::formulas::{Expr, formula, formula_of};
use crate::text::{Block, Checked, Reason, Stop, Toml, Verdict, require};
use cases::{Index, Listing, Values, cases, name_of};
use scopes::scope;
use std::rc::Rc;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "equation",
    fields: "equation: claim symbols=*text hypotheses=*text indices=*axis left=text|*text right=text \
 absent=text",
    names,
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// Checks an equation.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if claim.get("absent").is_some() {
        let sides = claim.get("left").or(claim.get("right"));
        require(sides.is_none(), Reason::Malformed("sides, or what is absent, but not both"))?;
        return block.restates("absent", claim.text("absent"));
    }
    let each = claim.list("left");
    let mut lefts: Vec<Option<&str>> = each.iter().map(Toml::as_text).collect();
    if each.is_empty() {
        lefts.push(claim.text("left"));
    }
    for left in &lefts {
        block.restates("left", *left)?;
    }
    block.restates("right", claim.text("right"))?;
    let lefts = lefts.into_iter().map(|left| formula(left.unwrap_or("")));
    let lefts = lefts.collect::<Result<Vec<Expr>, Stop>>()?;
    let (right, indices) = (formula_of(claim, "right")?, indices(claim)?);
    let cases = cases(paper, &indices)?;
    if !each.is_empty() && lefts.len() != cases.len() {
        return Err(Stop::Wrong("the number of left sides is not that of the cases".into()).into());
    }
    let mut listing = Listing::read(block, &[Verdict::Holds, Verdict::Fails], cases.len())?;
    let memory = Rc::default();
    for (case, left) in cases.iter().zip(lefts.iter().cycle()) {
        let scope = scope(paper, claim, case, &memory)?;
        let difference = scope.value(left)?.minus(&scope.value(&right)?)?;
        let differs = !difference.is_zero();
        listing.check(block, &name_of(case), (differs, &difference), &scope)?;
    }
    listing.finished(block)
}

/// The indices of an equation.
fn indices(claim: &Toml) -> Result<Vec<Index<'_>>, Stop> {
    let index = |table| {
        let fields = ["name", "from", "to"].map(|key| Toml::text(table, key));
        if let [Some(name), Some(from), Some(to)] = fields {
            let values = Values::Between(Box::new([formula(from)?, formula(to)?]));
            return Ok(Index { name, values });
        }
        let Axis { name, entries } = Axis::read(table)?;
        let listed = entries.into_iter().map(|(_, value)| value).collect();
        Ok(Index { name, values: Values::Listed(listed) })
    };
    claim.list("indices").iter().map(index).collect()
}

/// The symbols and the indices of an equation.
fn names(claim: &Toml) -> Vec<&str> {
    let indices = claim.list("indices").iter().filter_map(|axis| axis.text("name"));
    claim.texts("symbols").chain(indices).collect()
}
