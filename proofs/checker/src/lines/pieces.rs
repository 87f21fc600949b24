//! Signs on the pieces of a line, for the rules `function` and `range`.

use crate::claims::Paper;
use crate::formulas::Scope;
use crate::numbers::{Ends, MAX_CUTS, Piece, Root, Value};
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, compare, require};

/// The most breaks.
const MAX_BREAKS: usize = 1_000;

/// The breaks of a parameter, and the signs at the breaks and on the pieces between them.
pub struct Pieces {
    /// The breaks, increasing.
    pub breaks: Vec<Root>,
    /// The signs on the first piece, at the first break, on the second piece, and so on.
    pub signs: Vec<i8>,
}

/// A value that depends on the parameter.
pub type Formula<'f> = dyn Fn(&Scope<'_>) -> Result<Value, Stop> + 'f;

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
        block.may_restate("scheme", claim.text("scheme"))?;
        Ok(Free { paper, claim, variable: claim.text("variable").unwrap_or_default() })
    }

    /// The scope of a piece, or of one value of the parameter if both ends are the same.
    pub fn scope(&self, ends: Ends) -> Result<Scope<'a>, Stop> {
        let mut scope = self.paper.stated();
        let [low, high] = &ends;
        let number = low.as_ref().filter(|_| low == high).and_then(Root::rational);
        let value = number.map_or(Value::symbol(self.variable), |value| value.clone().into());
        scope.values.insert(self.variable.to_owned(), value);
        scope.piece = Some(Piece::new(self.variable, ends, self.paper.library.meter));
        if let Some(reference) = self.claim.text("scheme") {
            scope.scheme = self.paper.library.resolve(reference, &scope)?.first().cloned();
            if scope.piece.as_ref().is_some_and(|piece| !piece.cuts().is_empty()) {
                return Err(Stop::Undefined("a parameter of the scheme has no sign on the piece"));
            }
        }
        Ok(scope)
    }

    /// Reads the lines `breaks` and `signs`, and compares them with the signs of a value.
    pub fn pieces(&self, block: &mut Block<'_>, value: &Formula<'_>) -> Checked<Pieces> {
        let meter = self.paper.library.meter;
        let said = block.after("breaks")?.split_whitespace();
        let breaks = said.map(|word| Root::read(word, meter)).collect::<Result<Vec<_>, Stop>>()?;
        let breaks: Option<Vec<Root>> = breaks.into_iter().collect();
        let breaks = breaks.ok_or(Reason::Malformed("numbers"))?;
        require(breaks.len() <= MAX_BREAKS, Reason::Breaks)?;
        for pair in breaks.windows(2) {
            require(pair[0].compare(&pair[1], meter)?.is_lt(), Reason::Breaks)?;
        }
        let said = block.after("signs")?;
        let mut signs = Vec::new();
        for i in 0..=breaks.len() {
            let low = i.checked_sub(1).map(|i| breaks[i].clone());
            let sign = self.on_piece([low, breaks.get(i).cloned()], value)?;
            let several = || {
                Reason::Signs(Text(said.to_string()), Text(format!("{} several", words(&signs))))
            };
            signs.push(sign.ok_or_else(several)?);
            if let Some(at) = breaks.get(i) {
                signs.push(self.at(at, value)?);
            }
        }
        let same = words(&signs).split_whitespace().eq(said.split_whitespace());
        compare(same, said, &words(&signs), Reason::Signs)?;
        Ok(Pieces { breaks, signs })
    }

    fn at(&self, at: &Root, value: &Formula<'_>) -> Result<i8, Stop> {
        let scope = self.scope([Some(at.clone()), Some(at.clone())])?;
        value(&scope)?.sign(scope.piece.as_ref())
    }

    /// The sign on all parts of a piece and at its cuts; `None` if there are several signs.
    fn on_piece(&self, ends: Ends, value: &Formula<'_>) -> Result<Option<i8>, Stop> {
        on_parts(ends, |ends| {
            let scope = self.scope(ends)?;
            let sign = value(&scope).and_then(|value| value.sign(scope.piece.as_ref()));
            Ok((sign, scope.piece.map_or(Vec::new(), |piece| piece.cuts())))
        })
    }
}

/// What is found on all parts of a piece and at its cuts; `None` if it is not the same everywhere. What is found on a piece comes
/// with its cuts: it is about the part above them.
pub fn on_parts<T: PartialEq>(
    ends: Ends,
    find: impl Fn(Ends) -> Result<(Result<T, Stop>, Vec<Root>), Stop>,
) -> Result<Option<T>, Stop> {
    let (mut rest, mut known, mut looks) = (vec![ends], None, 0);
    while let Some([low, high]) = rest.pop() {
        let (above, cuts) = find([low.clone(), high])?;
        // The parts below the cuts are left.
        let lower = [low].into_iter().chain(cuts.iter().cloned().map(Some));
        rest.extend(lower.zip(&cuts).map(|(low, cut)| [low, Some(cut.clone())]));
        let at = |cut: &Root| find([Some(cut.clone()), Some(cut.clone())])?.0;
        for found in cuts.iter().map(at).chain([above]) {
            if looks == MAX_CUTS {
                return Err(Stop::Capped("the number of pieces"));
            }
            looks += 1;
            let found = found?;
            if known.as_ref().is_some_and(|known| *known != found) {
                return Ok(None);
            }
            known = Some(found);
        }
    }
    Ok(known)
}

/// Signs as a certificate writes them.
fn words(signs: &[i8]) -> String {
    let word = |sign: &i8| match sign {
        -1 => "-",
        0 => "0",
        _ => "+",
    };
    signs.iter().map(word).collect::<Vec<&str>>().join(" ")
}
