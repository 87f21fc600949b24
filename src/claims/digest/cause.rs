//! Why cells have their outcome.

use crate::exact::Rational;
use crate::finding::{AsRead, Assumed, Difference, Direction, Missing};
use std::fmt;

/// Why cells have their outcome.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Cause {
    /// They are rounded differently.
    Rounded(Direction),
    /// They are read differently.
    Read(HowRead),
    /// They are a slip away from the value as printed, or as read differently.
    Slip(Option<HowRead>),
    /// The definition has no value: why.
    Undefined(String),
    /// Something is absent.
    Missing(Missing),
    /// They are reproduced at these values, as printed or as read differently.
    Recovered(Assumed, Option<HowRead>),
}

/// How cells are read.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct HowRead {
    /// The differences from the printed text.
    pub differences: Vec<Difference>,
    /// Values of solved parameters that no difference names.
    pub values: Vec<(String, Rational)>,
    /// The rounding of these cells, where it is not that of the reading.
    pub rounded: Option<Direction>,
}

impl Cause {
    pub(super) fn read(read: &AsRead) -> Cause {
        Cause::Read(HowRead::of(read))
    }

    pub(super) fn slip(read: Option<&AsRead>) -> Cause {
        Cause::Slip(read.map(HowRead::of))
    }

    pub(super) fn recovered(values: &Assumed, read: Option<&AsRead>) -> Cause {
        Cause::Recovered(values.clone(), read.map(HowRead::of))
    }
}

impl HowRead {
    fn of(read: &AsRead) -> HowRead {
        let said = |name: &str| read.differences.iter().any(|other| other.about() == name);
        let unsaid = read.solved.iter().filter(|solved| !said(&solved.name));
        HowRead {
            differences: read.differences.clone(),
            values: unsaid.map(|solved| (solved.name.clone(), solved.simplest.clone())).collect(),
            rounded: read.rounded,
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Cause::Rounded(direction) => direction.fmt(f),
            Cause::Read(read) => read.fmt(f),
            Cause::Slip(None) => f.write_str("one slip away from the value of the definition"),
            Cause::Slip(Some(read)) => write!(f, "one slip away from the value as read: {read}"),
            Cause::Undefined(why) => f.write_str(why),
            Cause::Missing(missing) => missing.fmt(f),
            Cause::Recovered(values, read) => {
                let values = values.iter().map(|(name, value)| format!("{name} = {value}"));
                write!(f, "with {}", values.collect::<Vec<String>>().join(", "))?;
                read.as_ref().map_or(Ok(()), |read| write!(f, "; {read}"))
            }
        }
    }
}

impl fmt::Display for HowRead {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let differences = self.differences.iter().map(Difference::to_string);
        let values = self.values.iter().map(|(name, value)| format!("{name} = {value}"));
        let rounded = self.rounded.map(|direction| direction.to_string());
        let parts: Vec<String> = differences.chain(values).chain(rounded).collect();
        f.write_str(&parts.join("; "))
    }
}
