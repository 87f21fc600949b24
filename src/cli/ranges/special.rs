//! Values of a parameter at which more holds than at the others.

use crate::cli::console::quantity::proved_continuity;
use subcert::report::json::SpecialForm;
use subcert::report::{Grid, Sheet, number};
use subcert::smoothness::SpecialValues;

/// Writes the special values, if there are some.
pub(crate) fn write_special(sheet: &mut Sheet, values: &[SpecialForm], parameter: &str) {
    if values.is_empty() {
        return;
    }
    sheet.heading(2, "Special values");
    let row = |one: &SpecialForm| {
        let [low, high] = &one.support;
        vec![
            number(&one.place),
            one.sum_rules.to_string(),
            format!("{} to {}", low.exact, high.exact),
            proved_continuity(one.continuity, one.continuity_fails),
        ]
    };
    let header = [parameter, "order of the sum rules", "support", "limits"];
    sheet.grid(Grid::of(header, values.iter().map(row), 3));
    sheet.text(format!(
        "At these {parameter} alone the sum rules are of a higher order, or the support is shorter."
    ));
}

/// At which values sum rules of order `needed` hold, in words.
pub(crate) fn higher(values: &SpecialValues, parameter: &str, needed: usize) -> Option<String> {
    let enough = values.values.iter().filter(|one| one.sum_rules >= needed);
    let texts: Vec<String> = enough
        .map(|one| format!("{parameter} = {} (order {})", number(&one.value), one.sum_rules))
        .collect();
    (!texts.is_empty()).then(|| texts.join(", "))
}
