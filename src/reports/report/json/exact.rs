//! Exact values, and values with names.

use crate::exact::{Enclosed, format::short};
use serde::{Serialize, Serializer};
use std::fmt::Display;

/// How many significant digits a decimal beside an exact value has.
const DECIMAL_DIGITS: u32 = 17;

/// An exact value with its decimal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Exact {
    /// The value: `p/q`, or an expression for an irrational number.
    pub exact: String,
    /// The value as a correctly rounded decimal of 17 significant digits.
    pub decimal: String,
}

impl Exact {
    /// The JSON form of a value.
    #[must_use]
    pub fn of(value: &(impl Enclosed + Display)) -> Exact {
        Exact { exact: value.to_string(), decimal: decimal(value) }
    }
}

/// The decimal that stands beside an exact value.
pub(crate) fn decimal(value: &impl Enclosed) -> String {
    short(value, DECIMAL_DIGITS)
}

/// An object: values with their names, in this order.
#[derive(Clone, Debug)]
pub struct Named<T>(pub Vec<(String, T)>);

#[cfg(feature = "schema")]
impl<T: schemars::JsonSchema> schemars::JsonSchema for Named<T> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("Named_{}", T::schema_name()).into()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        std::collections::BTreeMap::<String, T>::json_schema(generator)
    }
}

impl<T: Serialize> Serialize for Named<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}
