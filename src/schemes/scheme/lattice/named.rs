//! SCHEME as a mask on Z^d.

use super::mask::LatticeMask;
use crate::cap::Cap;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::Parameters;
use crate::scheme::error::SchemeError;
use crate::scheme::mask::Mask;
use crate::scheme::parse::Named;
use crate::scheme::rules::MAX_ARITY;

impl Named<'_> {
    /// The mask on Z^d, or the tensor product of two or three masks of curves.
    pub(in crate::scheme) fn lattice(&self) -> Result<LatticeMask, SchemeError> {
        let none = Parameters::default();
        if let [part] = self.reference.parts() {
            return self.factor_of(part, &none, None)?.lattice();
        }
        let masks = self.masks()?;
        let arities = masks.iter().map(Mask::arity).product::<usize>();
        if arities > MAX_ARITY {
            return Err(SchemeError::File(Box::new(
                Diagnostic::new(
                    &SourceText::new("SCHEME", self.text),
                    0..self.text.len(),
                    format!("a product with {arities} rules; there are at most {MAX_ARITY}"),
                )
                .with_cap(Some(Cap::new("the number of rules", MAX_ARITY as u64))),
            )));
        }
        LatticeMask::product(&masks.iter().collect::<Vec<&Mask>>()).map_err(|error| {
            let source = SourceText::new("SCHEME", self.text);
            let diagnostic = Diagnostic::new(&source, 0..self.text.len(), error.to_string());
            SchemeError::File(Box::new(diagnostic.with_cap(error.cap())))
        })
    }
}
