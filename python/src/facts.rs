//! The facts of schemes, as the JSON that `subcert scheme` writes, and their pictures.

use crate::error::{of_scheme, plain};
use crate::run::aside;
use pyo3::prelude::*;
use subcert::facts::{Drawing, FamilyFacts, SchemeFacts};
use subcert::report::html::Plot;
use subcert::report::json::{Facts, FactsForm};

/// All facts of a scheme, and where in the parameter of its family the limits are C^m.
#[pyfunction]
pub fn facts_json(py: Python<'_>, scheme: String) -> PyResult<String> {
    aside(py, move || {
        let facts = SchemeFacts::of(&scheme).map_err(|error| of_scheme(&error))?;
        written(&FactsForm::of(&scheme, &facts), FamilyFacts::of(&scheme).as_ref())
    })
}

pub(crate) fn written(facts: &FactsForm, family: Option<&FamilyFacts>) -> PyResult<String> {
    serde_json::to_string(&Facts::of(facts, family)).map_err(plain)
}

/// How many boxes of a map of two parameters are looked at for each order of smoothness.
const BOXES: usize = 1_000;

/// The pictures of a scheme as one SVG file.
#[pyfunction]
pub fn plot_svg(py: Python<'_>, scheme: String) -> PyResult<String> {
    aside(py, move || {
        let region = [[-1, 1].map(Into::into), [-1, 1].map(Into::into)];
        let drawing = Drawing::of(&scheme, &region, BOXES).map_err(|error| of_scheme(&error))?;
        Ok(Plot::of(&scheme, &drawing).to_svg())
    })
}
