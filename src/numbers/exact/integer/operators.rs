//! Operators, order and conversions of [`Integer`].

use super::Form::{Large, Word};
use super::{Int, Integer};
use crate::exact::backend;
use crate::exact::ops::{binary_operator, computed_operator, ring_basics};
use crate::stop::check;
use std::cmp::Ordering;
use std::ops::Neg;

/// Implements a ring operator on two references, and in place. What words give at once stands in
/// functions that are inlined, also in other crates.
macro_rules! operation {
    ($compute:ident, $in_place:ident, $slow:ident, $slow_in_place:ident, $checked:ident,
     $trait:ident::$method:ident, $assign:ident::$assign_method:ident) => {
        #[inline]
        fn $compute(a: &Integer, b: &Integer) -> Integer {
            if let (Word(x), Word(y)) = (&a.0, &b.0)
                && let Some(value) = x.$checked(*y)
            {
                return Integer(Word(value));
            }
            $slow(a, b)
        }

        fn $slow(a: &Integer, b: &Integer) -> Integer {
            check();
            Integer::normal(match (&a.0, &b.0) {
                (Word(x), Word(y)) => std::ops::$trait::$method(Int::from(*x), *y),
                (Word(x), Large(y)) => Int::from(std::ops::$trait::$method(*x, y)),
                (Large(x), Word(y)) => Int::from(std::ops::$trait::$method(x, *y)),
                (Large(x), Large(y)) => Int::from(std::ops::$trait::$method(x, y)),
            })
        }

        #[inline]
        fn $in_place(a: &mut Integer, b: &Integer) {
            if let (Word(x), Word(y)) = (&mut a.0, &b.0)
                && let Some(value) = x.$checked(*y)
            {
                *x = value;
            } else {
                $slow_in_place(a, b);
            }
        }

        fn $slow_in_place(a: &mut Integer, b: &Integer) {
            check();
            match (&mut a.0, &b.0) {
                (Large(x), Word(y)) => std::ops::$assign::$assign_method(x, *y),
                (Large(x), Large(y)) => std::ops::$assign::$assign_method(x, y),
                _ => return *a = $slow(a, b),
            }
            a.normalise();
        }

        binary_operator!(Integer, $trait::$method, $assign::$assign_method, $compute, $in_place);
    };
}
operation!(
    add,
    add_in_place,
    slow_add,
    slow_add_in_place,
    checked_add,
    Add::add,
    AddAssign::add_assign
);
operation!(
    sub,
    sub_in_place,
    slow_sub,
    slow_sub_in_place,
    checked_sub,
    Sub::sub,
    SubAssign::sub_assign
);
operation!(
    mul,
    mul_in_place,
    slow_mul,
    slow_mul_in_place,
    checked_mul,
    Mul::mul,
    MulAssign::mul_assign
);
computed_operator!(Integer, div, div_in_place, Div::div, DivAssign::div_assign);
computed_operator!(Integer, rem, rem_in_place, Rem::rem, RemAssign::rem_assign);
ring_basics!(Integer);

/// a/b without its fractional part, as machine integers divide.
fn div(a: &Integer, b: &Integer) -> Integer {
    if let (Word(x), Word(y)) = (&a.0, &b.0)
        && let Some(quotient) = x.checked_div(*y)
    {
        return Integer(Word(quotient));
    }
    let magnitude = a.abs().div_floor(&b.abs());
    if (a.sign() < 0) == (b.sign() < 0) { magnitude } else { -magnitude }
}

fn rem(a: &Integer, b: &Integer) -> Integer {
    a - div(a, b) * b
}

impl Neg for &Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        match &self.0 {
            Word(value) => value
                .checked_neg()
                .map_or_else(|| Integer(Large(-Int::from(*value))), |value| Integer(Word(value))),
            Large(value) => Integer::normal(backend::neg(value)),
        }
    }
}

impl Ord for Integer {
    fn cmp(&self, other: &Integer) -> Ordering {
        match (&self.0, &other.0) {
            (Word(x), Word(y)) => x.cmp(y),
            (Large(x), Large(y)) => x.cmp(y),
            (Large(_), Word(_)) => self.sign().cmp(&0),
            (Word(_), Large(_)) => 0.cmp(&other.sign()),
        }
    }
}

macro_rules! from_machine {
    ($($type:ty),*) => {$(
        impl From<$type> for Integer {
            fn from(value: $type) -> Integer {
                Integer(i64::try_from(value).map_or_else(|_| Large(Int::from(value)), Word))
            }
        }
    )*};
}
from_machine!(u64, i128, u128, isize, usize);

macro_rules! from_word {
    ($($type:ty),*) => {$(
        impl From<$type> for Integer {
            fn from(value: $type) -> Integer {
                Integer(Word(value.into()))
            }
        }
    )*};
}
from_word!(i8, u8, i16, u16, i32, u32, i64);
