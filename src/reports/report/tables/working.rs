//! The values from which a cell is computed.

use crate::audit::{PaperAudit, TableFinding, Working};
use crate::exact::{RealCyclotomic, format::short};
use crate::report::words::numbers::{DIGITS, exact};

/// How many characters a fraction may have; a longer one is shown as its decimal.
const MAX_FRACTION: usize = 60;

/// The scheme, the parameters, and each definition with its value. `scheme` is the label and the
/// text of the printed scheme.
pub(crate) fn facts(
    audit: &PaperAudit<'_>,
    finding: &TableFinding<'_>,
    scheme: Option<(String, String)>,
    working: &Working,
) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    if let Some((name, printed)) = scheme {
        let here: Vec<String> = working.scheme.iter().map(ToString::to_string).collect();
        let here = here.join(" x ");
        let same = here.is_empty() || here == printed;
        facts.push((name, if same { printed } else { format!("{printed}, here {here}") }));
    }
    let formula = &finding.table.value;
    facts.push(("said to equal".to_owned(), formula.text.clone()));
    let parameters = working.parameters.iter();
    let parameters = parameters.map(|(name, value)| format!("{name} = {value}"));
    let parameters: Vec<String> = parameters.collect();
    if !parameters.is_empty() {
        facts.push(("at".to_owned(), parameters.join(", ")));
    }
    for (name, formula) in audit.paper.definitions_in(formula) {
        let value = working.definitions.iter().find(|(defined, _)| defined == name);
        let value = value.map(|(_, value)| format!("\n= {}", valued(value)));
        let text = format!("{}{}", formula.text, value.unwrap_or_default());
        facts.push((format!("where {name}"), text));
    }
    facts
}

/// `371/500 = 0.742`; of a long fraction, its decimal.
fn valued(value: &RealCyclotomic) -> String {
    let text = value.to_string();
    if text.len() > MAX_FRACTION { short(value, DIGITS) } else { exact(value) }
}
