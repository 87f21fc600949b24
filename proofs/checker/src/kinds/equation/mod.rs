//! The rule `equation`: two sides as polynomials in the symbols, in every case.

mod hypotheses;

use super::kind::{Kind, Proof};
use crate::claims::{Axis, Paper, value};
use crate::formulas::{Expr, MAX_INTEGER, Memory, Scope, formula, formula_of};
use crate::numbers::{Q, Value, int};
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, Verdict, agree, compare, require};
use std::rc::Rc;

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "equation",
    fields: "equation: claim symbols=*text hypotheses=*text indices=*axis left=text|*text right=text \
 absent=text",
    names,
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// The most cases of an equation.
const MAX_CASES: usize = 100_000;

/// The values of the indices.
type Case<'a> = Vec<(&'a str, Q)>;

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
    let (right, cases) = (formula_of(claim, "right")?, cases(paper, claim)?);
    if !each.is_empty() && lefts.len() != cases.len() {
        return Err(Stop::Wrong("the number of left sides is not that of the cases".into()).into());
    }
    // An equation without cases states nothing.
    require(!cases.is_empty(), Reason::NoCase)?;
    let (verdict, count) = block.any()?;
    let verdict = Verdict::named(verdict);
    let verdict = verdict.filter(|said| matches!(said, Verdict::Holds | Verdict::Fails));
    let verdict = verdict.ok_or(Reason::Malformed("holds or fails"))?;
    agree(count, &cases.len().to_string(), Reason::Cases)?;
    let (mut listed, memory) = (0, Rc::default());
    for (case, left) in cases.iter().zip(lefts.iter().cycle()) {
        let name = case.iter().map(|(_, value)| value.to_string()).collect::<Vec<_>>().join(" ");
        let scope = scope(paper, claim, case, &memory)?;
        let difference = scope.value(left)?.minus(&scope.value(&right)?)?;
        // `case 3 1/2 = p[0] - p[1]`, if the next line is about this case.
        let line = block.peek().map(|line| line.word()).filter(|(word, _)| *word == "case");
        let line = line.and_then(|(_, said)| said.split_once('='));
        let Some((_, said)) = line.filter(|(case, _)| case.trim() == name) else {
            if difference.is_zero() {
                continue;
            }
            return Err(Reason::Differ(name, Text(difference.to_string())).into());
        };
        block.after("case")?;
        let said = value(said, &scope)?;
        require(!said.is_zero(), Reason::NoDifference)?;
        compare(difference.equals(&said)?, &said, &difference, Reason::Difference)?;
        listed += 1;
    }
    require(block.maybe("case").is_none(), Reason::Case)?;
    let found = if listed > 0 { Verdict::Fails } else { Verdict::Holds };
    compare(verdict == found, &verdict, &found, Reason::Verdict)
}

/// The scope of a case. It shares the known values of definitions with other cases.
fn scope<'a>(
    paper: &'a Paper<'a>,
    claim: &Toml,
    case: &Case<'_>,
    memory: &Rc<Memory>,
) -> Result<Scope<'a>, Stop> {
    let mut scope = paper.scope();
    for symbol in claim.texts("symbols") {
        scope.values.insert(symbol.to_owned(), Value::symbol(symbol));
        scope.families.insert(symbol.to_owned());
    }
    scope.memory = Rc::clone(memory);
    for (name, value) in case {
        scope.hidden.insert((*name).to_owned());
        scope.values.insert((*name).to_owned(), value.clone().into());
    }
    hypotheses::suppose(claim, &mut scope)?;
    if let Some(reference) = claim.text("scheme") {
        scope.scheme = paper.library.resolve(reference, &scope)?.first().cloned();
    }
    Ok(scope)
}

/// Every combination of the indices, the first one slowest.
fn cases<'a>(paper: &'a Paper<'a>, claim: &'a Toml) -> Result<Vec<Case<'a>>, Stop> {
    let mut cases: Vec<Case<'a>> = vec![Vec::new()];
    for index in claim.list("indices") {
        let mut longer = Vec::new();
        for case in cases {
            let bounds = index.text("name").zip(index.text("from")).zip(index.text("to"));
            let (name, values): (&str, Vec<Q>) = if let Some(((name, from), to)) = bounds {
                let mut scope = paper.library.closed();
                let values =
                    case.iter().map(|(name, value)| ((*name).into(), value.clone().into()));
                scope.values.extend(values);
                let bound = |text| scope.value(&formula(text)?)?.integer(MAX_INTEGER);
                (name, (bound(from)?..=bound(to)?).take(MAX_CASES + 1).map(int).collect())
            } else {
                let axis = Axis::read(index)?;
                (axis.name, axis.entries.into_iter().map(|(_, value)| value).collect())
            };
            if longer.len() + values.len() > MAX_CASES {
                return Err(Stop::Capped("the number of cases"));
            }
            let cases = values.into_iter().map(|value| [&case[..], &[(name, value)]].concat());
            longer.extend(cases);
        }
        cases = longer;
    }
    Ok(cases)
}

/// The symbols and the indices of an equation.
fn names(claim: &Toml) -> Vec<&str> {
    let indices = claim.list("indices").iter().filter_map(|axis| axis.text("name"));
    claim.texts("symbols").chain(indices).collect()
}
