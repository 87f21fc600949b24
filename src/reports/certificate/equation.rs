//! Equations: whether their sides are equal, and the difference of the sides where they are not.

use super::block::{Block, Certified, closed};
use crate::audit::{EquationFinding, EquationVerdict, Failure};
use crate::claim::{EquationBody, Identity, Left, Paper};

impl Certified for EquationFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let mut block = Block::new("equation", &self.equation.id);
        match &self.equation.body {
            EquationBody::NotCheckable(absent) => block.restate("absent", absent),
            EquationBody::Identity(identity) => restate(&mut block, identity),
        }
        match &self.verdict {
            EquationVerdict::Holds { cases } => block.line(format!("holds {cases}")),
            EquationVerdict::Fails { cases, failures, .. } => {
                block.line(format!("fails {cases}"));
                for failure in failures {
                    block.line(case(failure));
                }
            }
            EquationVerdict::NotCheckable => {}
            EquationVerdict::BeyondCap(cap) => block.give_up(cap.to_string()),
        }
        block
    }
}

fn restate(block: &mut Block, identity: &Identity) {
    match &identity.left {
        Left::One(formula) => block.restate("left", &formula.text),
        Left::Each(formulas) => {
            for formula in formulas {
                block.restate("left", &formula.text);
            }
        }
    }
    block.restate("right", &identity.right.text);
}

/// `case 3 1/2 = p[0]-p[1]`.
fn case(failure: &Failure) -> String {
    let mut line = "case".to_owned();
    for value in &failure.indices {
        line.extend([" ", &value.to_string()]);
    }
    format!("{line} = {}", closed(&failure.difference()))
}
