//! Why something about a claim is not known.

use crate::bound::{ClassCap, DepthError, LocalWork};
use crate::cap::Cap;
use crate::characteristic::VertexRangeError;
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::FormulaErrorKind;
use crate::lattice::LatticeRangeError;
use crate::limit::{LimitError, LocalLimitError, SurfaceError};
use crate::smoothness::{SmoothRangeError, SmoothnessError};
use crate::spectrum::SpectrumError;
use std::fmt;

macro_rules! reasons {
    (
        errors { $($(#[$doc:meta])* $error:ident($of:ty),)* }
        facts { $($(#[$fact_doc:meta])* $fact:ident$(($($value:ident: $kind:ty),*))? $text:literal,)* }
    ) => {
        /// Why something about a claim is not known.
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Reason {
            $($(#[$doc])* $error($of),)*
            $($(#[$fact_doc])* $fact$(($($kind),*))?,)*
        }

        impl fmt::Display for Reason {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Reason::$error(error) => error.fmt(f),)*
                    $(Reason::$fact$(($($value),*))? => write!(f, $text),)*
                }
            }
        }

        $(impl From<$of> for Reason {
            fn from(error: $of) -> Reason {
                Reason::$error(error)
            }
        })*
    };
}

reasons! {
    errors {
        /// A value is beyond a cap.
        Cap(Cap),
        /// A formula has no value.
        Formula(FormulaErrorKind),
        /// A curve or a net has no limit or no distance from it.
        Limit(LimitError),
        /// A surface has none.
        Surface(SurfaceError),
        /// A ring has none.
        LocalLimit(LocalLimitError),
        /// A constant has too many residue classes.
        Classes(ClassCap),
        /// A constant of a ring takes too much work.
        LocalWork(LocalWork),
        /// There is no depth.
        Depth(DepthError),
        /// The smoothness of limits is not computed.
        Smoothness(SmoothnessError),
        /// The values for which limits are smooth are not computed.
        SmoothRange(SmoothRangeError),
        /// The same of masks on Z^d.
        LatticeRange(LatticeRangeError),
        /// There is no spectrum at a vertex or on a face.
        Spectrum(SpectrumError),
        /// The values for which surfaces are smooth there are not computed.
        VertexRange(VertexRangeError),
    }
    facts {
        /// A parameter without a value.
        Unstated(name: String) "the paper does not state {name}",
        /// A formula of a theorem divides by zero.
        DividesByZero "it divides by zero",
        /// A promise without a scheme.
        NoScheme "no scheme is given",
        /// Distances of a mask on Z^d are asked for.
        Lattice "the distances of masks on Z^d are not computed",
        /// Distances of a ring are asked of another scheme.
        NoRing "this is no ring",
        /// A ring has no sound bound of a level.
        RingBound "for a ring the distances themselves are computed",
        /// A value of a promise is irrational.
        Irrational(value: RealCyclotomic) "sound values are computed at rational numbers, not at {value}",
        /// A level of a promise that is not looked at.
        LevelOf(level: i64, most: u32) "a level is from 0 to {most}, and this is {level}",
        /// There is no sound bound.
        NoContraction "no constant of the scheme is below 1",
        /// A printed depth is no natural number.
        NoLevel "what is said to be a level is none",
        /// A spread that is not positive.
        Spread(spread: Rational) "the spread {spread} is not positive",
        /// A comparison of distances met its caps.
        Search "the caps of the search do not decide it",
        /// Later levels are not shown.
        Later(level: u32) "not shown at all levels from {level} on",
        /// A bound of a curve or a net is irrational.
        IrrationalBound(bound: RealCyclotomic) "the bound of a curve or a net is rational, not {bound}",
        /// A bound and a distance are in no common field.
        NoField(bound: RealCyclotomic) "no field holds the bound {bound} and the distances",
        /// Rings of a table are too large together.
        Rings(most: usize) "the rings of this table have more points than the cap: the squares of their numbers sum to {most} at most",
        /// A constant of a curve is not asked for.
        Constant(levels: u32) "T_{levels} is over too many residue classes",
        /// Constants of a surface are not asked for.
        Constants(levels: u32) "the constants of {levels} levels are over too many residue classes",
        /// A ring has no constant of a level.
        NoConstant "no constant of this level",
        /// A step without an interpolant.
        NoInterpolant "there is no interpolant",
        /// An interpolant that keeps nothing.
        NothingKept "the interpolant keeps no point",
        /// Points have no natural parameters.
        NoNaturalParameters "the scheme does not take lines to lines, so that its points have no natural parameters",
        /// No exact limits of a kind of scheme.
        NoLimits "the program has no exact limits of this kind of scheme",
        /// A theorem states no bound.
        NoBound "it states no bound",
        /// A bound is negative.
        NegativeBound(level: u32) "the bound is negative at level {level}, which nothing is",
        /// A depth is negative.
        NegativeDepth "the depth is negative, which nothing is",
        /// A level is not decided.
        Undecided(level: u32) "not exceeded, but not decided at level {level}",
        /// No distance was computed.
        NoDistance "it has no distance",
        /// A search ended without a result.
        Unsaid "",
        /// No sound bound shows a level.
        NoSoundBound(level: u32) "no sound bound is as small as the bound at level {level}",
        /// The hypothesis of a theorem does not hold.
        Hypothesis "its hypothesis fails",
    }
}
