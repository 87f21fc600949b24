//! Numbers as literals of a type.

use crate::exact::Enclosed;
use crate::float::{nearest, nearest_f32};

/// The type of the numbers of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RealType {
    /// binary32 of IEEE 754.
    F32,
    /// binary64 of IEEE 754.
    F64,
}

/// The number of a type nearest to an exact value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Real {
    /// Of binary32.
    F32(f32),
    /// Of binary64.
    F64(f64),
}

impl Real {
    pub(super) fn nearest(value: &impl Enclosed, real: RealType) -> Real {
        match real {
            RealType::F32 => Real::F32(nearest_f32(value)),
            RealType::F64 => Real::F64(nearest(value)),
        }
    }

    /// The shortest decimal that is read as this number by a reader of its type.
    pub(super) fn shortest(self) -> String {
        match self {
            Real::F32(value) => format!("{value:?}"),
            Real::F64(value) => format!("{value:?}"),
        }
    }

    /// The shortest decimal that is read as this very number by a reader of f64.
    pub(super) fn as_f64(self) -> String {
        match self {
            Real::F32(value) => format!("{:?}", f64::from(value)),
            Real::F64(value) => format!("{value:?}"),
        }
    }
}
