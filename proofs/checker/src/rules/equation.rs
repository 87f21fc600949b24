//! Rule `equation`: two sides, as polynomials in the symbols, in every case.

use crate::certificate::{Block, Line};
use crate::decimal::{Q, int};
use crate::evaluate::Scope;
use crate::formula::Expr;
use crate::paper::{Axis, Paper, formula_of, restates, value};
use crate::reject::{Checked, Reason};
use crate::scheme::formula;
use crate::toml::Toml;
use crate::value::{Stop, Value};

/// The most cases of an equation.
const MAX_CASES: usize = 100_000;

/// The values of the indices.
type Case<'a> = Vec<(&'a str, Q)>;

/// Checks an equation.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if let Some((line, said)) = block.optional("absent") {
        return restates(line, "absent", said, claim.text("absent"));
    }
    let lefts = match claim.get("left") {
        Some(Toml::List(lefts)) => lefts.iter().map(Toml::as_text).collect(),
        left => vec![left.and_then(Toml::as_text)],
    };
    for left in &lefts {
        let (line, said) = block.take("left")?;
        restates(line, "left", said, *left)?;
    }
    let (line, said) = block.take("right")?;
    restates(line, "right", said, claim.text("right"))?;
    let head = block.head;
    let equation = Equation::new(paper, claim, &lefts);
    let equation = equation.map_err(|stop| head.reject(Reason::Stopped(stop)))?;
    let line = block.peek().unwrap_or(head);
    let (verdict, count) = line.word();
    block.take(if verdict == "fails" { "fails" } else { "holds" })?;
    if count != equation.cases.len().to_string() {
        return Err(line.reject(Reason::Cases));
    }
    let mut listed = 0;
    for (i, case) in equation.cases.iter().enumerate() {
        let name = case.iter().map(|(_, value)| value.to_string()).collect::<Vec<_>>().join(" ");
        let scope = equation.scope(case).map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        let difference = equation.difference(i, &scope);
        let difference = difference.map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        let Some((line, said)) = block.peek().and_then(|line| listing(line, &name)) else {
            if difference.is_zero() {
                continue;
            }
            return Err(line.reject(Reason::Differ(name)));
        };
        block.take("case")?;
        let said = value(line, said, &equation.symbols())?;
        if said.is_zero() {
            return Err(line.reject(Reason::NoDifference));
        }
        let off = difference.plus(-1, &said).map_err(|stop| line.reject(Reason::Stopped(stop)))?;
        if !off.is_zero() {
            return Err(line.reject(Reason::Difference));
        }
        listed += 1;
    }
    if let Some(line) = block.peek().filter(|line| line.word().0 == "case") {
        return Err(line.reject(Reason::Case));
    }
    if (listed > 0) == (verdict == "fails") { Ok(()) } else { Err(line.reject(Reason::Verdict)) }
}

/// The difference that a line gives, if it is about this case: `case 3 1/2 = p[0] - p[1]`.
fn listing<'l>(line: Line<'l>, case: &str) -> Option<(Line<'l>, &'l str)> {
    let said = line.after("case").ok()?;
    let (name, difference) = said.split_once('=')?;
    (name.trim() == case).then_some((line, difference))
}

struct Equation<'a> {
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    lefts: Vec<Expr>,
    right: Expr,
    hypotheses: Vec<(String, Vec<Expr>, Expr)>,
    cases: Vec<Case<'a>>,
}

impl<'a> Equation<'a> {
    fn new(
        paper: &'a Paper<'a>,
        claim: &'a Toml,
        lefts: &[Option<&str>],
    ) -> Result<Equation<'a>, Stop> {
        let lefts = lefts.iter().map(|left| formula(left.unwrap_or("")));
        let lefts = lefts.collect::<Result<Vec<Expr>, Stop>>()?;
        let hypothesis = |text: &Toml| {
            let wrong = Stop::Wrong("a hypothesis is `q[i] = …`".into());
            let (member, value) =
                text.as_text().and_then(|text| text.split_once('=')).ok_or(wrong.clone())?;
            match formula(member.trim())? {
                Expr::Member(name, positions) => Ok((name, positions, formula(value.trim())?)),
                _ => Err(wrong),
            }
        };
        let hypotheses = claim.list("hypotheses").iter().map(hypothesis);
        let hypotheses = hypotheses.collect::<Result<Vec<_>, Stop>>()?;
        let (right, cases) = (formula_of(claim, "right")?, cases(paper, claim)?);
        let each = matches!(claim.get("left"), Some(Toml::List(_)));
        if each && lefts.len() != cases.len() {
            return Err(Stop::Wrong("as many left sides as cases are needed".into()));
        }
        Ok(Equation { paper, claim, lefts, right, hypotheses, cases })
    }

    /// A scope of the symbols.
    fn symbols(&self) -> Scope<'a> {
        let mut scope = self.paper.scope();
        for symbol in self.claim.list("symbols").iter().filter_map(Toml::as_text) {
            scope.values.insert(symbol.to_owned(), Value::symbol(symbol));
            scope.families.insert(symbol.to_owned());
        }
        scope
    }

    fn scope(&self, case: &Case<'a>) -> Result<Scope<'a>, Stop> {
        let mut scope = self.symbols();
        for (name, value) in case {
            scope.values.insert((*name).to_owned(), value.clone().into());
        }
        for (name, positions, value) in &self.hypotheses {
            let mut key = Vec::new();
            for position in positions {
                key.push(scope.value(position)?.integer(1_000_000)?.to_string());
            }
            let value = scope.value(value)?;
            scope.values.insert(format!("{name}[{}]", key.join(",")), value);
        }
        if let Some(reference) = self.claim.text("scheme") {
            scope.scheme = self.paper.library.resolve(reference, &scope)?.first().cloned();
        }
        Ok(scope)
    }

    /// left − right in the case of this place.
    fn difference(&self, place: usize, scope: &Scope<'_>) -> Result<Value, Stop> {
        let left = if self.lefts.len() > 1 { place } else { 0 };
        scope.value(&self.lefts[left])?.plus(-1, &scope.value(&self.right)?)
    }
}

/// Every combination of the indices, the first one slowest.
fn cases<'a>(paper: &'a Paper<'a>, claim: &'a Toml) -> Result<Vec<Case<'a>>, Stop> {
    let mut cases: Vec<Case<'a>> = vec![Vec::new()];
    for index in claim.list("indices") {
        let mut longer = Vec::new();
        for case in cases {
            let bounds = index.text("name").zip(index.text("from")).zip(index.text("to"));
            let (name, values): (&str, Vec<Q>) = if let Some(((name, from), to)) = bounds {
                let mut scope = paper.nothing();
                for (name, value) in &case {
                    scope.values.insert((*name).to_owned(), value.clone().into());
                }
                let bound = |text| scope.value(&formula(text)?)?.integer(1_000_000);
                let (from, to) = (bound(from)?, bound(to)?);
                if usize::try_from(to - from).is_ok_and(|more| more >= MAX_CASES) {
                    return Err(Stop::Capped("the number of cases"));
                }
                (name, (from..=to).map(int).collect())
            } else {
                let axis = Axis::read(index)?;
                (axis.name, axis.entries.into_iter().map(|(_, value)| value).collect())
            };
            if longer.len() + values.len() > MAX_CASES {
                return Err(Stop::Capped("the number of cases"));
            }
            for value in values {
                let mut case = case.clone();
                case.push((name, value));
                longer.push(case);
            }
        }
        cases = longer;
    }
    Ok(cases)
}
