//! The kinds of claims, and claims and findings of any kind.

/// Calls a macro with the list of the kinds, the one place that names them all: the kind, its name, the field of
/// its claims and of their findings, the type of a claim, that of a finding, and the field of the claim in it. The
/// order is that of audits.
#[doc(hidden)]
#[macro_export]
macro_rules! with_kinds {
    ($expand:ident) => {
        $expand! {
            /// A table of numbers.
            Table "table" tables Table TableFinding table,
            /// An equation.
            Equation "equation" equations Equation EquationFinding equation,
            /// A closed form in a free parameter.
            Function "function" functions FunctionClaim FunctionFinding claim,
            /// A range of a free parameter.
            Range "range" ranges RangeClaim RangeFinding claim,
            /// The smoothness of limits.
            Smoothness "smoothness" smoothness SmoothnessClaim SmoothnessFinding claim,
            /// A theorem.
            Theorem "theorem" theorems Theorem TheoremFinding theorem,
        }
    };
}
pub use with_kinds;

macro_rules! claims {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $claim:ident $f:ident $c:ident,)*) => {
        /// A kind of claim.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Kind { $($(#[$doc])* $kind,)* }

        /// A claim of any kind.
        #[derive(Clone, Copy, Debug)]
        pub enum Claim<'p> { $($(#[$doc])* $kind(&'p super::$claim),)* }

        impl Kind {
            /// All of them, in the order of audits.
            pub const ALL: &[Kind] = &[$(Kind::$kind),*];

            /// Its name.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Kind::$kind => $name,)* }
            }
        }

        impl<'p> Claim<'p> {
            /// Its kind.
            #[must_use]
            pub fn kind(self) -> Kind {
                match self { $(Claim::$kind(_) => Kind::$kind,)* }
            }

            /// Its id within the paper.
            #[must_use]
            pub fn id(self) -> &'p str {
                match self { $(Claim::$kind(claim) => &claim.id,)* }
            }

            /// Where it stands.
            #[must_use]
            pub fn locus(self) -> &'p str {
                match self { $(Claim::$kind(claim) => &claim.locus,)* }
            }

            /// Its statement, in words.
            #[must_use]
            pub fn title(self) -> &'p str {
                match self { $(Claim::$kind(claim) => &claim.title,)* }
            }

            /// A note for the reader.
            #[must_use]
            pub fn note(self) -> Option<&'p str> {
                match self { $(Claim::$kind(claim) => claim.note.as_deref(),)* }
            }
        }
    };
}

with_kinds!(claims);
