//! Powers of the variables of symbols.

use std::fmt;

/// The name of the variable in the text of a symbol.
pub const SYMBOL_VARIABLE: &str = "z";

/// The names of the variables of a symbol of several variables, in order.
pub const LATTICE_VARIABLES: [&str; 3] = ["x", "y", "z"];

/// A power of the variables: one integer for z, or three for x, y and z.
///
/// Its order is that of sums: from a ≤ b follows a + c ≤ b + c.
pub trait Power: Copy + Ord + fmt::Debug {
    /// The power of 1.
    const ZERO: Self;

    /// The exponent of each variable, with its name.
    fn exponents(&self) -> impl Iterator<Item = (&'static str, i64)>;

    /// With each exponent mapped, together with that of another power.
    #[must_use]
    fn with(self, other: Self, f: impl FnMut(i64, i64) -> i64) -> Self;

    /// The power of a product.
    #[must_use]
    fn plus(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }

    /// The power of a quotient.
    #[must_use]
    fn minus(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl Power for i64 {
    const ZERO: i64 = 0;
    fn exponents(&self) -> impl Iterator<Item = (&'static str, i64)> {
        std::iter::once((SYMBOL_VARIABLE, *self))
    }
    fn with(self, other: i64, mut f: impl FnMut(i64, i64) -> i64) -> i64 {
        f(self, other)
    }
}

impl Power for [i64; 3] {
    const ZERO: [i64; 3] = [0; 3];
    fn exponents(&self) -> impl Iterator<Item = (&'static str, i64)> {
        LATTICE_VARIABLES.into_iter().zip(*self)
    }
    fn with(self, other: [i64; 3], mut f: impl FnMut(i64, i64) -> i64) -> [i64; 3] {
        std::array::from_fn(|i| f(self[i], other[i]))
    }
}
