//! What the rules `function` and `range` have in common: signs on pieces of a line.

use crate::certificate::{Block, Line};
use crate::decimal::{Q, read_rational};
use crate::evaluate::Scope;
use crate::paper::{Paper, restates};
use crate::reject::{Checked, Reason};
use crate::toml::Toml;
use crate::value::{Piece, Stop, Value};

/// The most breaks.
const MAX_BREAKS: usize = 1_000;

/// The most pieces that one of a certificate is cut into.
const MAX_PIECES: usize = 1_000;

/// The breaks of a parameter, and signs on the pieces between and at the breaks.
pub struct Pieces {
    /// The breaks, increasing.
    pub breaks: Vec<Q>,
    /// The signs: of the first piece, at the first break, of the second piece, ….
    pub signs: Vec<i8>,
}

/// Where a formula is looked at.
pub enum Place<'p> {
    /// On a piece, with polynomials in the parameter.
    Piece(Option<&'p Q>, Option<&'p Q>),
    /// At a value of the parameter.
    At(&'p Q),
}

/// A claim about a free parameter.
pub struct Free<'a> {
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    variable: &'a str,
}

impl<'a> Free<'a> {
    /// Reads the lines `variable` and `scheme`.
    pub fn read(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<Free<'a>> {
        let (line, said) = block.take("variable")?;
        restates(line, "variable", said, claim.text("variable"))?;
        if claim.text("scheme").is_some() {
            let (line, said) = block.take("scheme")?;
            restates(line, "scheme", said, claim.text("scheme"))?;
        }
        Ok(Free { paper, claim, variable: claim.text("variable").unwrap_or_default() })
    }

    /// The scope of a place.
    pub fn scope(&self, place: &Place<'_>) -> Result<Scope<'a>, Stop> {
        let mut scope = self.paper.scope();
        scope.values.clone_from(&self.paper.given);
        let value = match place {
            Place::At(value) => Value::from((*value).clone()),
            Place::Piece(low, high) => {
                let (low, high) = (low.cloned(), high.cloned());
                scope.piece = Some(Piece { symbol: self.variable.into(), low, high });
                Value::symbol(self.variable)
            }
        };
        scope.values.insert(self.variable.to_owned(), value);
        if let Some(reference) = self.claim.text("scheme") {
            scope.scheme = self.paper.library.resolve(reference, &scope)?.first().cloned();
        }
        Ok(scope)
    }

    /// Reads the lines `breaks` and `signs`, and compares them with the signs of a value.
    pub fn pieces(
        &self,
        block: &mut Block<'_>,
        value: impl Fn(&Scope<'_>) -> Result<Value, Stop>,
    ) -> Checked<Pieces> {
        let (line, said) = block.take("breaks")?;
        let breaks: Option<Vec<Q>> = said.split_whitespace().map(read_rational).collect();
        let breaks = breaks.ok_or(line.reject(Reason::Malformed("numbers")))?;
        if breaks.len() > MAX_BREAKS || breaks.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(line.reject(Reason::Breaks));
        }
        let (line, said) = block.take("signs")?;
        let stopped = |stop| line.reject(Reason::Stopped(stop));
        let mut signs = Vec::new();
        for i in 0..=breaks.len() {
            let low = i.checked_sub(1).and_then(|i| breaks.get(i));
            signs.push(self.on_piece(low, breaks.get(i), &value).map_err(stopped)?);
            if let Some(at) = breaks.get(i) {
                signs.push(Some(self.at(at, &value).map_err(stopped)?));
            }
        }
        let signs: Option<Vec<i8>> = signs.into_iter().collect();
        let signs = signs.ok_or(line.reject(Reason::Signs))?;
        let word = |sign: &i8| match sign {
            -1 => "-",
            0 => "0",
            _ => "+",
        };
        let words = signs.iter().map(word);
        if !words.eq(said.split_whitespace()) {
            return Err(line.reject(Reason::Signs));
        }
        Ok(Pieces { breaks, signs })
    }
}

impl Free<'_> {
    fn at(&self, at: &Q, value: impl Fn(&Scope<'_>) -> Result<Value, Stop>) -> Result<i8, Stop> {
        value(&self.scope(&Place::At(at))?)?.sign(None)
    }

    /// The sign on a piece, which is cut where formulas have another form; `None` if there
    /// is not only one.
    fn on_piece(
        &self,
        low: Option<&Q>,
        high: Option<&Q>,
        value: &impl Fn(&Scope<'_>) -> Result<Value, Stop>,
    ) -> Result<Option<i8>, Stop> {
        // The pieces that are still to be looked at.
        let mut pieces = vec![(low.cloned(), high.cloned())];
        let mut sign = None;
        for _ in 0..MAX_PIECES {
            let Some((low, high)) = pieces.pop() else { return Ok(sign) };
            let scope = self.scope(&Place::Piece(low.as_ref(), high.as_ref()))?;
            let found = match value(&scope).and_then(|value| value.sign(scope.piece.as_ref())) {
                Err(Stop::Split(at)) => {
                    pieces.extend([(low, Some(at.clone())), (Some(at.clone()), high)]);
                    self.at(&at, value)?
                }
                found => found?,
            };
            if sign.is_some_and(|sign| sign != found) {
                return Ok(None);
            }
            sign = Some(found);
        }
        Err(Stop::Capped("the number of pieces"))
    }
}

/// The last line of a block, which says the verdict.
pub fn verdict<'l>(block: &mut Block<'l>) -> Checked<(Line<'l>, &'l str, &'l str)> {
    let line = block.peek().ok_or(block.head.reject(Reason::Malformed("a verdict")))?;
    let (verdict, rest) = line.word();
    block.optional(verdict);
    Ok((line, verdict, rest))
}
