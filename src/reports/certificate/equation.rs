//! Equations and other relations: whether they hold, and the difference of the sides where they do not.

use super::block::{Block, Certified, closed};
use crate::audit::{EquationFinding, EquationVerdict, Failure};
use crate::claim::{EquationBody, Identity, Paper};

impl Certified for EquationFinding<'_> {
    fn block(&self, _: &Paper) -> Block {
        let mut block = Block::new(self.equation.kind(), &self.equation.id);
        match &self.equation.body {
            EquationBody::NotCheckable(absent) => block.restate("absent", absent),
            EquationBody::Identity(identity) => restate(&mut block, identity),
        }
        match &self.verdict {
            EquationVerdict::Holds { cases } => block.line(format!("holds {cases}")),
            EquationVerdict::Proved => block.line("holds all"),
            EquationVerdict::Tried { cases } => block.line(format!("tried {cases}")),
            EquationVerdict::Fails { cases, failures, .. } => {
                block.line(match &self.equation.body {
                    EquationBody::Identity(identity) if identity.is_for_all() => {
                        "fails all".to_owned()
                    }
                    _ => format!("fails {cases}"),
                });
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
    if let Some(states) = &identity.states {
        return block.restate("states", states);
    }
    let equation = identity.first();
    for left in equation.left.formulas() {
        block.restate("left", &left.text);
    }
    block.restate("right", &equation.right().text);
}

/// `case 3 1/2 = p[0]-p[1]`.
fn case(failure: &Failure) -> String {
    let mut line = "case".to_owned();
    for value in &failure.indices {
        line.extend([" ", &value.to_string()]);
    }
    format!("{line} = {}", closed(&failure.difference()))
}
