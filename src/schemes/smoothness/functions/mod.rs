//! Values, integrals, inner products and exponents of the basic limit function.

mod basic;
mod integrals;
mod keeping;
mod riesz;
mod sobolev;
mod values;

pub use basic::{BasicError, BasicValues};
pub use integrals::{
    InnerProductError, InnerProducts, basic, derivative_symbol, integral_symbol, moments,
};
pub use keeping::is_shape_kept;
pub use riesz::riesz_bounds;
pub use sobolev::sobolev_exponent;
pub use values::{LimitValues, is_contractive};
