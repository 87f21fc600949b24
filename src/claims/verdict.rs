//! The verdicts on claims: the word for each, its mark and its standing. Everything else matches on these values.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::AddAssign;

/// What a verdict says of a claim as printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// It is shown to hold.
    Holds,
    /// It does not hold as it stands, but it is known how it came about.
    Near,
    /// It does not hold.
    Fails,
    /// Neither is shown.
    Open,
}

macro_rules! verdicts {
    ($($(#[$doc:meta])* $verdict:ident $name:literal $mark:literal $standing:ident,)*) => {
        /// The word for a verdict.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Word { $($(#[$doc])* $verdict,)* }

        impl Word {
            /// All of them, in the order in which they are counted.
            pub const ALL: &[Word] = &[$(Word::$verdict),*];

            /// The word as it stands in reports, in JSON and in certificates.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Word::$verdict => $name,)* }
            }

            /// Its mark, one character.
            #[must_use]
            pub const fn mark(self) -> &'static str {
                match self { $(Word::$verdict => $mark,)* }
            }

            /// What it says of a claim as printed.
            #[must_use]
            pub fn standing(self) -> Standing {
                match self { $(Word::$verdict => Standing::$standing,)* }
            }
        }
    };
}

verdicts! {
    /// The correctly rounded value of the printed definition, or a claim that is proved.
    Confirmed "confirmed" "✓" Holds,
    /// The value at parameters that the paper does not state and that were recovered.
    Reproduced "reproduced" "=" Near,
    /// The value, rounded differently in the last place.
    Rounding "rounding" "≈" Near,
    /// One slip of the pen away from the value.
    Misprint "misprint" "±" Near,
    /// The value of another reading than the printed one.
    OtherReading "other-reading" "⇄" Near,
    /// None of these, or a claim that is false.
    Refuted "refuted" "✗" Fails,
    /// Something that it needs is absent, or beyond a cap.
    NotCheckable "not-checkable" "?" Open,
    /// Both sides are equal.
    Holds "holds" "✓" Holds,
    /// They are not.
    Fails "fails" "✗" Fails,
    /// The printed range is the exact set.
    Exact "exact" "✓" Holds,
    /// It is not.
    Inexact "inexact" "✗" Fails,
    /// A theorem is true.
    Proved "proved" "✓" Holds,
    /// It is not decided.
    Open "open" "?" Open,
    /// A printed bound or depth keeps its promise.
    Kept "kept" "✓" Holds,
    /// It does not.
    Broken "broken" "✗" Fails,
    /// A shipped number is the nearest of its type.
    Nearest "nearest" "✓" Holds,
    /// It is rounded or cut to the digits that are written.
    Cut "cut" "≈" Near,
    /// It is units in the last place away from the nearest one.
    Ulps "ulps" "≈" Near,
    /// A table that a program ships is another one than it is said to be.
    Otherwise "otherwise" "⇄" Near,
}

impl Word {
    /// The verdicts of numbers in tables, best first.
    pub const OF_CELLS: [Word; 7] = [
        Word::Confirmed,
        Word::Reproduced,
        Word::Rounding,
        Word::Misprint,
        Word::OtherReading,
        Word::Refuted,
        Word::NotCheckable,
    ];
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl From<Word> for String {
    fn from(word: Word) -> String {
        word.name().to_owned()
    }
}

/// How often each verdict occurs, in the order of [`Word::ALL`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally(BTreeMap<Word, usize>);

impl Tally {
    /// How often this one occurs.
    #[must_use]
    pub fn of(&self, word: Word) -> usize {
        self.0.get(&word).copied().unwrap_or(0)
    }

    /// How many verdicts there are.
    #[must_use]
    pub fn total(&self) -> usize {
        self.0.values().sum()
    }

    /// The verdicts that occur, with their counts.
    pub fn iter(&self) -> impl Iterator<Item = (Word, usize)> {
        self.0.iter().map(|(word, count)| (*word, *count))
    }
}

impl FromIterator<Word> for Tally {
    fn from_iter<I: IntoIterator<Item = Word>>(words: I) -> Tally {
        let mut tally = Tally::default();
        words.into_iter().for_each(|word| *tally.0.entry(word).or_default() += 1);
        tally
    }
}

impl AddAssign<&Tally> for Tally {
    fn add_assign(&mut self, other: &Tally) {
        other.iter().for_each(|(word, count)| *self.0.entry(word).or_default() += count);
    }
}
