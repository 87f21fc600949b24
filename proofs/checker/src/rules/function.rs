//! Rule `function`: two sides as functions of a parameter.

use super::pieces::{Free, Place, verdict};
use crate::certificate::Block;
use crate::decimal::read_rational;
use crate::paper::{Paper, formula_of, restates};
use crate::reject::{Checked, Reason};
use crate::toml::Toml;

/// Checks a function.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let free = Free::read(paper, claim, block)?;
    let mut sides = Vec::new();
    for side in ["left", "right"] {
        let (line, said) = block.take(side)?;
        restates(line, side, said, claim.text(side))?;
        let formula = formula_of(claim, side);
        sides.push(formula.map_err(|stop| line.reject(Reason::Stopped(stop)))?);
    }
    let pieces =
        free.pieces(block, |scope| scope.value(&sides[0])?.plus(-1, &scope.value(&sides[1])?))?;
    let (line, word, said) = verdict(block)?;
    let equal = pieces.signs.iter().all(|sign| *sign == 0);
    if (word == "holds") != equal || !["holds", "fails"].contains(&word) {
        return Err(line.reject(Reason::Verdict));
    }
    let words: Vec<&str> = said.split_whitespace().collect();
    match words[..] {
        [] if equal => Ok(()),
        [at, left, right] if !equal => {
            let at = read_rational(at).ok_or(line.reject(Reason::Malformed("a number")))?;
            let stopped = |stop| line.reject(Reason::Stopped(stop));
            let scope = free.scope(&Place::At(&at)).map_err(stopped)?;
            let said = [paper.closed(line, left)?, paper.closed(line, right)?];
            for (side, said) in sides.iter().zip(&said) {
                let value = scope.value(side).map_err(stopped)?;
                if !value.plus(-1, said).map_err(stopped)?.is_zero() {
                    return Err(line.reject(Reason::Value));
                }
            }
            let differ = !said[0].plus(-1, &said[1]).map_err(stopped)?.is_zero();
            if differ { Ok(()) } else { Err(line.reject(Reason::NoDifference)) }
        }
        _ => Err(line.reject(Reason::Malformed("holds, or fails NUMBER VALUE VALUE"))),
    }
}
