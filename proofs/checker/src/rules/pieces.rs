//! What the rules `function` and `range` have in common: signs on pieces of a line.

use crate::certificate::Block;
use crate::evaluate::Scope;
use crate::paper::Paper;
use crate::reject::{Checked, Reason, Stop, require};
use crate::root::Root;
use crate::toml::Toml;
use crate::value::{Piece, Value};

/// The most breaks.
const MAX_BREAKS: usize = 1_000;

/// The most pieces that one of a certificate is cut into.
const MAX_PIECES: usize = 1_000;

/// The breaks of a parameter, and signs on the pieces between and at the breaks.
pub struct Pieces {
    /// The breaks, increasing.
    pub breaks: Vec<Root>,
    /// The signs: of the first piece, at the first break, of the second piece, ….
    pub signs: Vec<i8>,
}

/// Where a formula is looked at.
pub enum Place<'p> {
    /// On a piece, with polynomials in the parameter.
    Piece(Option<&'p Root>, Option<&'p Root>),
    /// At a value of the parameter.
    At(&'p Root),
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
        block.restates("variable", claim.text("variable"))?;
        if claim.text("scheme").is_some() {
            block.restates("scheme", claim.text("scheme"))?;
        }
        Ok(Free { paper, claim, variable: claim.text("variable").unwrap_or_default() })
    }

    /// The scope of a place.
    pub fn scope(&self, place: &Place<'_>) -> Result<Scope<'a>, Stop> {
        let mut scope = self.paper.scope();
        scope.values.clone_from(&self.paper.given);
        let (low, high) = match place {
            Place::Piece(low, high) => (low.cloned(), high.cloned()),
            Place::At(root) => (Some((*root).clone()), Some((*root).clone())),
        };
        let number = low.as_ref().filter(|_| low == high).and_then(Root::rational);
        let value = number.map_or(Value::symbol(self.variable), |value| value.clone().into());
        scope.values.insert(self.variable.to_owned(), value);
        scope.piece = Some(Piece { symbol: self.variable.into(), low, high });
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
        let breaks = block.after("breaks")?.split_whitespace().map(Root::read);
        let breaks: Vec<Root> =
            breaks.collect::<Option<_>>().ok_or(Reason::Malformed("numbers"))?;
        require(breaks.len() <= MAX_BREAKS, Reason::Breaks)?;
        for pair in breaks.windows(2) {
            require(pair[0].compare(&pair[1])?.is_lt(), Reason::Breaks)?;
        }
        let said = block.after("signs")?;
        let mut signs = Vec::new();
        for i in 0..=breaks.len() {
            let low = i.checked_sub(1).map(|i| &breaks[i]);
            signs.push(self.on_piece(low, breaks.get(i), &value)?.ok_or(Reason::Signs)?);
            if let Some(at) = breaks.get(i) {
                signs.push(self.at(at, &value)?);
            }
        }
        let words = signs.iter().map(|sign| match sign {
            -1 => "-",
            0 => "0",
            _ => "+",
        });
        require(words.eq(said.split_whitespace()), Reason::Signs)?;
        Ok(Pieces { breaks, signs })
    }

    fn at(&self, at: &Root, value: impl Fn(&Scope<'_>) -> Result<Value, Stop>) -> Result<i8, Stop> {
        let scope = self.scope(&Place::At(at))?;
        value(&scope)?.sign(scope.piece.as_ref())
    }

    /// The sign on a piece, which is cut where formulas have another form; `None` if there
    /// is not only one.
    fn on_piece(
        &self,
        low: Option<&Root>,
        high: Option<&Root>,
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
                    pieces.extend([(low, Some((*at).clone())), (Some((*at).clone()), high)]);
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
