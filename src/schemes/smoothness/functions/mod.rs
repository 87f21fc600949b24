//! Values, integrals, inner products and exponents of the basic limit function.

mod basic;
mod extremes;
mod integrals;
mod keeping;
mod ratios;
mod riesz;
mod sobolev;
mod values;
mod zeros;

pub use basic::{BasicError, BasicValues};
pub use extremes::{modulus, modulus_extremes};
pub use integrals::{
    InnerProductError, InnerProducts, basic, derivative_symbol, integral_symbol, moments,
};
pub use keeping::is_shape_kept;
pub use ratios::keeps_ratios;
pub use riesz::riesz_bounds;
pub use sobolev::sobolev_exponent;
pub use values::{LimitValues, is_contractive};
pub use zeros::{is_hurwitz, vanishing_moments};
