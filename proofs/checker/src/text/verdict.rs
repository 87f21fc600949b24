//! The verdicts that certificates say, each with its name there.

use std::fmt;

/// Declares verdicts, each with its name in certificates.
macro_rules! verdicts {
    ($(#[$doc:meta])* $type:ident: $($value:ident $name:literal)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $type { $(#[doc = concat!("`", $name, "`")] $value),* }

        impl $type {
            /// The verdict of this name.
            pub fn named(name: &str) -> Option<$type> {
                [$($type::$value),*].into_iter().find(|verdict| verdict.name() == name)
            }

            /// The name.
            pub fn name(self) -> &'static str {
                match self { $($type::$value => $name),* }
            }
        }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }
    };
}

verdicts! {
    /// The verdict of a claim of a paper, or of a cell of a table.
    Verdict:
    Confirmed "confirmed"
    Holds "holds"
    Exact "exact"
    Proved "proved"
    Reproduced "reproduced"
    Rounding "rounding"
    Misprint "misprint"
    OtherReading "other-reading"
    Inexact "inexact"
    Fails "fails"
    Tried "tried"
    Refuted "refuted"
    Differs "differs"
    Unknown "unknown"
}

verdicts! {
    /// Whether the promise of a table about a cell is kept.
    Promise:
    Kept "kept"
    Broken "broken"
    Undecided "undecided"
}

verdicts! {
    /// The outcome for the constants of a program, which is that of the worst number. They are in order.
    Outcome:
    Nearest "nearest"
    Cut "cut"
    Ulps "ulps"
    Open "open"
    Misprint "misprint"
    Refuted "refuted"
    Otherwise "otherwise"
}

impl Verdict {
    /// Whether a claim with this verdict holds as it stands.
    pub fn holds(self) -> bool {
        matches!(self, Verdict::Confirmed | Verdict::Holds | Verdict::Exact)
    }
}
