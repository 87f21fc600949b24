//! The two sides of a bound that control data violate.

use crate::paper::Paper;
use crate::reject::{Checked, Reason, require};
use crate::value::Value;

/// Makes sure that these are the two sides, and that the first one is larger.
pub fn violated(paper: &Paper<'_>, said: &str, left: &Value, right: &Value) -> Checked<()> {
    let [one, other] = said.split_whitespace().collect::<Vec<&str>>()[..] else {
        return Err(Reason::Malformed("two sides").into());
    };
    require(paper.number(one)?.equals(left)?, Reason::Value)?;
    require(paper.number(other)?.equals(right)?, Reason::Value)?;
    require(left.compare(right)?.is_gt(), Reason::NotViolated)
}
