//! Masks of curve schemes, with rational or irrational coefficients.

use crate::cli::console::output::Failure;
use subcert::exact::FieldElement;
use subcert::scheme::{
    AnyScheme, LatticeMask, Mask, SchemeError, parse_algebraic, parse_any_scheme, parse_lattice,
};

/// The mask of a scheme for curves, or on Z^d.
pub(crate) enum Curve {
    Rational(Mask),
    Algebraic(Mask<FieldElement>),
    Lattice(Box<LatticeMask>),
}

pub(crate) fn curve(name: &str) -> Result<Curve, Failure> {
    let scheme = match parse_any_scheme(name) {
        Ok(scheme) => scheme,
        // What is wrong with the scheme is wrong in any field.
        Err(error) => {
            return match parse_algebraic(name) {
                Ok(mask) => Ok(Curve::Algebraic(mask)),
                Err(SchemeError::Lattice { .. }) => Err(error.into()),
                Err(error) => Err(error.into()),
            };
        }
    };
    let reason = match scheme {
        AnyScheme::Uniform(scheme) => match Mask::try_from(scheme) {
            Ok(mask) => return Ok(Curve::Rational(mask)),
            Err(_) => return Ok(Curve::Lattice(Box::new(parse_lattice(name)?))),
        },
        AnyScheme::Lattice(mask) => return Ok(Curve::Lattice(Box::new(mask))),
        AnyScheme::LocalRules(_) => {
            "has rules around one vertex or face, and `--certificate` here is for masks; `audit` writes certificates of \
             claims about such rules"
        }
    };
    Err(Failure::Input(format!("`{name}` {reason}")))
}
