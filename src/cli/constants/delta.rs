//! δ, and rows of tables of constants.

use crate::cli::console::quantity::Number;
use serde::Serialize;
use subcert::bound::DeltaCondition;
use subcert::report::json::Exact;

/// δ.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Delta {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub(crate) value: Number,
    /// Whether it is less than 1.
    pub(crate) holds: bool,
}

impl Delta {
    pub(crate) fn of(condition: &DeltaCondition) -> Delta {
        Delta { holds: condition.holds(), value: (&condition.delta).into() }
    }

    pub(crate) fn words(&self) -> String {
        let holds = if self.holds { "< 1: one level contracts" } else { "not < 1" };
        format!("{}, {holds}", self.value.words())
    }
}

/// A row of a table of numbers: these texts, and the number.
pub(crate) fn number_row(of: &[&str], value: &Number) -> Vec<String> {
    let Exact { exact, decimal } = Exact::of(value);
    of.iter().map(|&text| text.to_owned()).chain([exact, decimal]).collect()
}
