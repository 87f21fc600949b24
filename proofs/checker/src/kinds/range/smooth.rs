//! The rule `range` of smoothness: the values of a parameter for which the limits of a scheme are C^m.

use crate::claims::Paper;
use crate::formulas::Scope;
use crate::kinds::smoothness::{order, scope, valences, vertex};
use crate::lines::domain::{Domain, Ends};
use crate::lines::lattice::covered;
use crate::lines::limits::LimitProof;
use crate::lines::pieces::Free;
use crate::numbers::{Meter, Q, Value, int, read_rational};
use crate::schemes::{Convolution, MAX_LENGTH, Product, Sequence};
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, Verdict, require};
use crate::vertex::Found;
use std::rc::Rc;

/// The most levels of a contraction.
const MAX_LEVELS: u32 = 16;

/// The most coefficients of a polynomial that reduces the symbol.
const MAX_COEFFICIENTS: usize = 65;

/// Checks a range.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let other = ["value", "below", "at_most"].iter().find(|key| claim.get(key).is_some());
    require(other.is_none(), Reason::Malformed("`smoothness` alone"))?;
    let reference = claim.text("scheme").unwrap_or_default();
    let rules = paper.library.is_ring(reference);
    let free = Free::read(paper, claim, block)?;
    block.restates("smoothness", claim.text("smoothness"))?;
    let m = order(claim.text("smoothness").unwrap_or_default())?;
    let only = claim.is_set("only");
    let domain = Domain::read(paper, claim)?;
    require(domain.has_ends(), Reason::Malformed("an end"))?;
    let valences = valences(claim)?;
    if valences.is_some() {
        require(rules, Reason::Malformed("rules around a vertex"))?;
        block.restates("valences", claim.text("valences"))?;
    }
    let lattice = paper.library.is_lattice(reference);
    if lattice && block.next_word() == "tile" {
        require(!only, Reason::NotShown)?;
        return cover(paper, claim, (m, &domain), block);
    }
    if !rules
        && !lattice
        && let Some(said) = block.maybe("contraction")
    {
        // For other values nothing is shown.
        require(!only, Reason::NotShown)?;
        let (levels, reduction) = contraction((said, MAX_LEVELS), block)?;
        let above = |scope: &Scope<'_>| {
            let symbol = Symbol::new(paper, (scope, reference), m, &reduction)?;
            let product = symbol.product(paper, levels)?;
            let sums = product.classes(paper.library.meter, scope.piece.as_ref())?;
            sums.greatest(scope.piece.as_ref())?.minus(&Value::int(1))
        };
        let pieces = free.pieces(block, &above)?;
        let within = domain.all(Ends::Printed, &pieces, |sign| sign < 0, paper.library.meter)?;
        require(within, Reason::Uncovered)?;
        return block.verdict(Verdict::Confirmed);
    }
    let said = block.after("at")?;
    let at = read_rational(said).ok_or(Reason::Malformed("a number"))?;
    let mut scope = scope(paper, claim)?;
    let variable = claim.text("variable").unwrap_or_default();
    scope.values.insert(variable.to_owned(), at.clone().into());
    // Whether not all limits are C^m at this value, and whether all are.
    let (fails, holds) = if rules {
        require(m == 1, Reason::Malformed("smoothness 1 of rules"))?;
        let said = block.after("vertex")?;
        let (_, found) = vertex(paper, claim, (said, valences), &mut scope, block)?;
        (found == Found::Rough, matches!(found, Found::Smooth(_)))
    } else {
        let shown = LimitProof::read(paper, claim, &scope, block)?;
        (shown.not_continuous(m), shown.continuous(m))
    };
    let [inside, outside] = domain.sides(&at)?;
    let refutes = inside && fails || outside && only && holds;
    require(refutes, Reason::NoRefutation(Text(said.to_string())))?;
    block.verdict(Verdict::Refuted)
}

/// Checks the lines that show that the limits of a mask on Z^d are C^m in the whole range.
fn cover<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    (m, domain): (usize, &Domain),
    block: &mut Block<'_>,
) -> Checked<()> {
    let variable = claim.text("variable").unwrap_or_default();
    let mut scope = scope(paper, claim)?;
    scope.values.insert(variable.to_owned(), Value::symbol(variable));
    let lattice = paper.library.lattice(claim.text("scheme").unwrap_or_default(), &scope)?;
    for covered in covered(paper.library.meter, (&lattice, variable), m, block)? {
        require(domain.is_in(&covered)?, Reason::Uncovered)?;
    }
    block.verdict(Verdict::Confirmed)
}

/// The number of levels that a line `contraction` says, and the lines `shifts` after it.
pub fn contraction(
    (said, most): (&str, u32),
    block: &mut Block<'_>,
) -> Checked<(u32, Vec<Vec<Q>>)> {
    let levels = said.parse().ok().filter(|c| (1..=most).contains(c));
    let levels = levels.ok_or(Reason::Malformed("a number of levels"))?;
    let mut reduction = Vec::new();
    while let Some(said) = block.maybe("shifts") {
        let read = said.split_whitespace().map(read_rational).collect::<Option<Vec<Q>>>();
        let g = read.filter(|g| (2..=MAX_COEFFICIENTS).contains(&g.len()));
        let g = g.filter(|g| g.last().is_some_and(|last| *last != int(0)));
        reduction.push(g.ok_or(Reason::Malformed("the coefficients of a polynomial"))?);
    }
    Ok((levels, reduction))
}

/// n^m A/σ^{m+1}, the symbol of the differences of order m + 1, after the reduction of A.
pub struct Symbol {
    arity: usize,
    /// Its coefficients.
    pub coefficients: Vec<Value>,
}

impl Symbol {
    /// That of a scheme.
    pub fn new(
        paper: &Paper<'_>,
        (scope, reference): (&Scope<'_>, &str),
        m: usize,
        reduction: &[Vec<Q>],
    ) -> Result<Symbol, Stop> {
        let schemes = paper.library.resolve(reference, scope)?;
        let [scheme] = &schemes[..] else {
            return Err(Stop::Wrong("smoothness is that of one scheme alone".into()));
        };
        let n = scheme.arity();
        let mut symbol = Sequence { rules: &scheme.mask, forward: false }.values();
        for g in reduction {
            symbol = reduced(symbol, g, n, paper.library.meter)?;
        }
        for order in 0..=m {
            let mut quotient: Vec<Value> = Vec::new();
            for (i, a) in symbol.iter().enumerate() {
                let known = quotient.iter().rev().take((n - 1).min(i));
                let rest = known.cloned().try_fold(a.clone(), |rest, q| rest.minus(&q))?;
                quotient.push(rest);
            }
            // The quotient has n − 1 coefficients less than the symbol; the others are the remainder.
            let kept = quotient.len().saturating_sub(n - 1);
            if quotient[kept..].iter().any(|x| !x.is_zero()) {
                return Err(Stop::Undefined("the sum rules do not hold for all values"));
            }
            quotient.truncate(kept);
            let factor = Value::int(if order < m { i64::try_from(n).unwrap_or(0) } else { 1 });
            symbol = quotient.iter().map(|x| x.times(&factor)).collect::<Result<_, _>>()?;
        }
        Ok(Symbol { arity: n, coefficients: symbol })
    }

    /// The product of c factors. The norm of (n^m S_{m+1})^c is its greatest class sum.
    pub fn product(&self, paper: &Paper<'_>, c: u32) -> Result<Rc<Product>, Stop> {
        let (library, how) = (paper.library, Convolution { c, arity: self.arity, printed: false });
        let product = library.products.of(how, &self.coefficients, MAX_LENGTH + 1)?;
        if product.is_long() {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        Ok(product)
    }
}

/// A(z)·g(z)/g(z^n), where g(z^n) divides A for all values. THEOREMS.md, 112 (d).
fn reduced(mut rest: Vec<Value>, g: &[Q], n: usize, meter: &Meter) -> Result<Vec<Value>, Stop> {
    let no_divisor = Stop::Undefined("g(z^n) does not divide the symbol for all values");
    let g: Vec<Value> = g.iter().cloned().map(Value::from).collect();
    let degree = n * (g.len() - 1);
    let Some(count) = rest.len().checked_sub(degree) else { return Err(no_divisor) };
    let terms = rest.iter().flat_map(|a| g.iter().map(|c| a.cost(c)));
    meter.spend(terms.fold(0, u64::saturating_add))?;
    let mut product = vec![Value::int(0); count + g.len() - 1];
    for i in (0..count).rev() {
        // The coefficient on z^i of A/g(z^n).
        let quotient = rest[i + degree].over(&g[g.len() - 1])?;
        for (j, c) in g.iter().enumerate() {
            rest[i + n * j] = rest[i + n * j].minus(&quotient.times(c)?)?;
            product[i + j] = product[i + j].plus(1, &quotient.times(c)?)?;
        }
    }
    if rest.iter().any(|x| !x.is_zero()) { Err(no_divisor) } else { Ok(product) }
}
