//! The rule `function`: two sides as functions of a parameter.

use super::kind::{Kind, Proof};
use crate::claims::Paper;
use crate::formulas::formula_of;
use crate::lines::domain::{Domain, Ends};
use crate::lines::pieces::Free;
use crate::numbers::{Root, read_rational};
use crate::text::{Block, Checked, Reason, Text, Toml, Verdict, agree, compare, require};

/// Claims of this kind.
pub const KIND: Kind = Kind {
    name: "function",
    fields: "function: claim variable=text left=text right=text from=number to=number closed=flag",
    names: |claim| claim.text("variable").into_iter().collect(),
    check: |paper, claim, block| check(paper, claim, block).map(|()| Proof::Other),
};

/// Checks a function.
fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let free = Free::read(paper, claim, block)?;
    block.restates("left", claim.text("left"))?;
    block.restates("right", claim.text("right"))?;
    let sides = [formula_of(claim, "left")?, formula_of(claim, "right")?];
    let pieces =
        free.pieces(block, &|scope| scope.value(&sides[0])?.minus(&scope.value(&sides[1])?))?;
    let (word, said) = block.any()?;
    let domain = Domain::read(paper, claim)?;
    let equal = domain.all(Ends::Least, &pieces, |sign| sign == 0, paper.library.meter)?;
    let verdict = if equal { Verdict::Holds } else { Verdict::Fails };
    agree(word, verdict.name(), Reason::Verdict)?;
    match said.split_whitespace().collect::<Vec<&str>>()[..] {
        [] if equal => Ok(()),
        [at, left, right] if !equal => {
            let at = read_rational(at).ok_or(Reason::Malformed("a number"))?;
            let [inside, _] = domain.sides(&at)?;
            require(inside, Reason::NotStated(Text(at.to_string())))?;
            let at = Some(Root::from(at));
            let scope = free.scope([at.clone(), at])?;
            let said = [paper.number(left)?, paper.number(right)?];
            for (side, said) in sides.iter().zip(&said) {
                let value = scope.value(side)?;
                compare(value.equals(said)?, said, &value, Reason::Value)?;
            }
            require(!said[0].equals(&said[1])?, Reason::NoDifference)
        }
        _ => Err(Reason::Malformed("holds, or fails NUMBER VALUE VALUE").into()),
    }
}
