//! Choices: the respects in which a reading may differ from the printed text.

/// One respect in which a printed definition can be understood in several ways.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Choice {
    /// Its name in certificates.
    pub key: &'static str,
    /// Its name in reports.
    pub name: &'static str,
    /// The effect of the choice.
    pub effect: Effect,
    /// The ways, in no order. The claim's formula says which of them is printed.
    pub ways: &'static [Way],
    /// Where such readings have been met.
    pub source: &'static str,
}

/// The effect of a choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// An option of some functions of the claim language.
    Option {
        /// The option.
        option: &'static str,
        /// The functions.
        functions: &'static [&'static str],
    },
    /// How an exact value was rounded to the printed decimal. The printed text counts as `nearest`.
    Decimal,
    /// Which tolerance a printed header stands for. The header as printed counts as `exact`.
    Header,
}

/// One way of a choice.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Way {
    /// The word for it in the claim language.
    pub word: &'static str,
    /// Its meaning, in reports.
    pub says: &'static str,
}
