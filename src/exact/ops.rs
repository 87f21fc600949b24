//! The operators of [`Integer`](super::Integer) and
//! [`Rational`](super::Rational), by value and by reference.

/// Implements one binary operator in its four forms, and its assigning form.
macro_rules! binary_operator {
    ($type:ident, $inner:ty, $trait:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl std::ops::$trait<&$type> for &$type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $type(<$inner>::from(std::ops::$trait::$method(&self.0, &other.0)))
            }
        }
        impl std::ops::$trait<$type> for $type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $type(std::ops::$trait::$method(self.0, other.0))
            }
        }
        impl std::ops::$trait<&$type> for $type {
            type Output = $type;
            fn $method(self, other: &$type) -> $type {
                $type(std::ops::$trait::$method(self.0, &other.0))
            }
        }
        impl std::ops::$trait<$type> for &$type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                std::ops::$trait::$method(self, &other)
            }
        }
        impl std::ops::$assign<&$type> for $type {
            fn $assign_method(&mut self, other: &$type) {
                std::ops::$assign::$assign_method(&mut self.0, &other.0);
            }
        }
    };
}

/// Implements negation, sums, formatting of `Debug` as of `Display`, and the
/// conversions from machine integers.
macro_rules! ring_basics {
    ($type:ident, $inner:ty) => {
        impl std::ops::Neg for $type {
            type Output = $type;
            fn neg(self) -> $type {
                $type(-self.0)
            }
        }
        impl std::ops::Neg for &$type {
            type Output = $type;
            fn neg(self) -> $type {
                $type(<$inner>::from(-&self.0))
            }
        }
        impl std::iter::Sum for $type {
            fn sum<I: Iterator<Item = $type>>(terms: I) -> $type {
                terms.fold($type::zero(), |sum, term| sum + term)
            }
        }
        impl<'a> std::iter::Sum<&'a $type> for $type {
            fn sum<I: Iterator<Item = &'a $type>>(terms: I) -> $type {
                terms.fold($type::zero(), |sum, term| sum + term)
            }
        }
        impl std::fmt::Debug for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(self, f)
            }
        }
    };
}

pub(super) use binary_operator;
pub(super) use ring_basics;
