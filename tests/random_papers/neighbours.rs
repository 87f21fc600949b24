//! What is said of a claim does not depend on the claims around it.

use crate::random_papers::draft::{Claim, Draft};
use crate::random_papers::failure::{Checked, Failure};
use crate::random_papers::program::{Block, blocks, written};

/// Claims that are judged together: tables that leave parameters open may give them away to others.
fn groups(draft: &Draft) -> Vec<Vec<&Claim>> {
    let (tables, others): (Vec<&Claim>, Vec<&Claim>) =
        draft.claims.iter().partition(|claim| claim.kind == "table");
    let mut groups: Vec<Vec<&Claim>> = others.into_iter().map(|claim| vec![claim]).collect();
    groups.extend((!tables.is_empty()).then_some(tables));
    groups
}

pub fn independent(draft: &Draft) -> Checked {
    let groups = groups(draft);
    let text = draft.text();
    let together = written(&text);
    let turned = written(&draft.with(groups.iter().rev().flatten().copied()));
    if together.is_some() != turned.is_some() {
        return Err(Failure::new("whether a file is judged depends on the order", &text, ""));
    }
    let (Some(together), Some(turned)) = (together, turned) else { return Ok(()) };
    let (together, turned) = (blocks(&together), blocks(&turned));
    for group in groups {
        let alone = written(&draft.with(group.iter().copied()));
        let alone = alone.map(|alone| blocks(&alone)).unwrap_or_default();
        for claim in group {
            let of = |blocks: &[Block]| blocks.iter().find(|block| block.id == claim.id).cloned();
            let found = of(&alone);
            for (how, other) in [("with others", of(&together)), ("in another order", of(&turned))]
            {
                if found != other {
                    let what = format!("a {} is judged otherwise {how}", claim.kind);
                    return Err(Failure::new(what, &text, format!("{found:#?}\n{other:#?}")));
                }
            }
        }
    }
    Ok(())
}
