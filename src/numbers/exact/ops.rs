//! The operators of [`Integer`](super::Integer) and
//! [`Rational`](super::Rational), by value and by reference.

/// Implements a binary operator for all four combinations of values and references, and
/// its assigning form. `$compute` takes two references; `$in_place` changes its first
/// argument.
macro_rules! binary_operator {
    ($type:ident, $trait:ident::$method:ident, $assign:ident::$assign_method:ident,
     $compute:path, $in_place:path) => {
        impl std::ops::$trait<&$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: &$type) -> $type {
                $compute(self, other)
            }
        }
        impl std::ops::$trait<$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(mut self, other: $type) -> $type {
                $in_place(&mut self, &other);
                self
            }
        }
        impl std::ops::$trait<&$type> for $type {
            type Output = $type;
            #[inline]
            fn $method(mut self, other: &$type) -> $type {
                $in_place(&mut self, other);
                self
            }
        }
        impl std::ops::$trait<$type> for &$type {
            type Output = $type;
            #[inline]
            fn $method(self, other: $type) -> $type {
                $compute(self, &other)
            }
        }
        impl std::ops::$assign<&$type> for $type {
            #[inline]
            fn $assign_method(&mut self, other: &$type) {
                $in_place(self, other);
            }
        }
    };
}

/// Implements negation by value, `Sum`, `Debug` by `Display`, and `PartialOrd` by `Ord`.
macro_rules! ring_basics {
    ($type:ident) => {
        impl std::ops::Neg for $type {
            type Output = $type;
            fn neg(self) -> $type {
                -&self
            }
        }
        impl PartialOrd for $type {
            fn partial_cmp(&self, other: &$type) -> Option<std::cmp::Ordering> {
                Some(self.cmp(other))
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
