//! The traits of num-traits. Those from and to numbers of the machine stand in `machine`.

use super::printed::read::{integer_in, rational_in};
use super::{Integer, NumberError, Rational};
use num_traits::{Num, One, Signed, Zero};

macro_rules! number {
    ($type:ident, $read:ident) => {
        impl Zero for $type {
            fn zero() -> $type {
                $type::zero()
            }
            fn is_zero(&self) -> bool {
                $type::is_zero(self)
            }
        }

        impl One for $type {
            fn one() -> $type {
                $type::one()
            }
        }

        impl Num for $type {
            type FromStrRadixErr = NumberError;
            /// Digits in a base from 2 to 36, with - before them if the number is negative; for a rational also p/q,
            /// in no base a point or an exponent. Other bases are an error.
            fn from_str_radix(text: &str, radix: u32) -> Result<$type, NumberError> {
                $read(text, radix)
            }
        }

        impl Signed for $type {
            fn abs(&self) -> $type {
                $type::abs(self)
            }
            /// self − other, or 0 where that is negative.
            fn abs_sub(&self, other: &$type) -> $type {
                if self <= other { $type::zero() } else { self - other }
            }
            fn signum(&self) -> $type {
                $type::from(self.sign())
            }
            fn is_positive(&self) -> bool {
                self.sign() > 0
            }
            fn is_negative(&self) -> bool {
                self.sign() < 0
            }
        }
    };
}
number!(Integer, integer_in);
number!(Rational, rational_in);
