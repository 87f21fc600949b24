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
        impl std::ops::$assign<$type> for $type {
            #[inline]
            fn $assign_method(&mut self, other: $type) {
                $in_place(self, &other);
            }
        }
    };
}

/// Implements an operator by `$compute`, and its assigning form by `$in_place`, which calls
/// `$compute`.
macro_rules! computed_operator {
    ($type:ident, $compute:ident, $in_place:ident, $trait:ident::$method:ident,
     $assign:ident::$assign_method:ident) => {
        fn $in_place(a: &mut $type, b: &$type) {
            *a = $compute(a, b);
        }

        binary_operator!($type, $trait::$method, $assign::$assign_method, $compute, $in_place);
    };
}

/// Implements negation by value, `Sum`, `Product`, `Debug` by `Display`, and `PartialOrd` by `Ord`.
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
        impl std::iter::Product for $type {
            fn product<I: Iterator<Item = $type>>(factors: I) -> $type {
                factors.fold($type::one(), |product, factor| product * factor)
            }
        }
        impl<'a> std::iter::Product<&'a $type> for $type {
            fn product<I: Iterator<Item = &'a $type>>(factors: I) -> $type {
                factors.fold($type::one(), |product, factor| product * factor)
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
pub(super) use computed_operator;
pub(super) use ring_basics;
