//! The facts of schemes, as the JSON that `subcert scheme` writes.

use crate::error::plain;
use crate::run::aside;
use pyo3::prelude::*;
use subcert::facts::{FamilyFacts, SchemeFacts};
use subcert::report::json::{Facts, FactsForm};

/// All facts of a scheme, and where in the parameter of its family the limits are C^m.
#[pyfunction]
pub fn facts_json(py: Python<'_>, scheme: String) -> PyResult<String> {
    aside(
        py,
        || (),
        move || {
            let found = FactsForm::of(&scheme, &SchemeFacts::of(&scheme).map_err(plain)?);
            let family = FamilyFacts::of(&scheme);
            serde_json::to_string(&Facts::of(&found, family.as_ref())).map_err(plain)
        },
    )
}
