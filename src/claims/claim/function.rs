//! Claims about a free parameter: closed forms and ranges.

use super::domain::Domain;
use super::table::{LocatedReference, Printed};
use crate::formula::LocatedFormula;

/// left = right, as functions of one free parameter, for its values in an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionClaim {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `Corollary 2.1`.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// The free parameter's name in formulas.
    pub variable: String,
    /// The scheme its functions are about; its parameters may depend on the free one.
    pub scheme: Option<LocatedReference>,
    /// The printed closed form.
    pub left: LocatedFormula,
    /// The formula that it is said to equal.
    pub right: LocatedFormula,
    /// The values of the parameter for which it is said to.
    pub domain: Domain,
    /// A note for the reader.
    pub note: Option<String>,
}

/// The range of a free parameter in which a value is below a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeClaim {
    /// Its id within the paper.
    pub id: String,
    /// Where it stands: `Remark 2.2`.
    pub locus: String,
    /// Its statement, in words.
    pub title: String,
    /// The free parameter's name in formulas.
    pub variable: String,
    /// The scheme its functions are about; its parameters may depend on the free one.
    pub scheme: Option<LocatedReference>,
    /// The value that is limited.
    pub value: LocatedFormula,
    /// Its limit.
    pub limit: Limit,
    /// The lower end as printed; `None` when the range has none.
    pub from: Option<Printed>,
    /// The upper end as printed; `None` when the range has none.
    pub to: Option<Printed>,
    /// Whether the printed ends belong to the range. Where the paper does not say it (`None`), an
    /// end that equals the exact one belongs to the range if the exact one does, and any other end
    /// belongs to it.
    pub closed: Option<bool>,
    /// A note for the reader.
    pub note: Option<String>,
}

/// A limit of a value, a formula without parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum Limit {
    /// value < limit.
    Below(LocatedFormula),
    /// value ≤ limit.
    AtMost(LocatedFormula),
}

impl Limit {
    /// The formula.
    #[must_use]
    pub fn formula(&self) -> &LocatedFormula {
        match self {
            Limit::Below(formula) | Limit::AtMost(formula) => formula,
        }
    }

    /// `<` or `<=`.
    #[must_use]
    pub fn relation(&self) -> &'static str {
        match self {
            Limit::Below(_) => "<",
            Limit::AtMost(_) => "<=",
        }
    }
}
