//! Numbers as text, in programs and in files.

use super::printed::error::{MAX_DIGITS, NumberError};
use super::printed::read::{integer_in, parse_rational};
use super::{Integer, Rational};
use serde::de::{self, Deserialize, Deserializer};
use serde::ser::{self, Serialize, Serializer};
use std::fmt;
use std::str::FromStr;

/// Strict reading of the digits, with - before them if the integer is negative.
impl FromStr for Integer {
    type Err = NumberError;
    fn from_str(text: &str) -> Result<Integer, NumberError> {
        integer_in(text, 10)
    }
}

/// As [`parse_rational`].
impl FromStr for Rational {
    type Err = NumberError;
    fn from_str(text: &str) -> Result<Rational, NumberError> {
        parse_rational(text)
    }
}

macro_rules! text_in_files {
    ($type:ident, $expected:literal) => {
        /// As text. A number of more than [`MAX_DIGITS`] characters is refused, since no file with it would be read.
        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let text = self.to_string();
                if text.len() > MAX_DIGITS {
                    return Err(ser::Error::custom(NumberError::TooLong { digits: text.len() }));
                }
                serializer.serialize_str(&text)
            }
        }

        /// From text only: a number of the file format may have been rounded.
        impl<'de> Deserialize<'de> for $type {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<$type, D::Error> {
                struct Text;
                impl de::Visitor<'_> for Text {
                    type Value = $type;
                    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                        f.write_str($expected)
                    }
                    fn visit_str<E: de::Error>(self, text: &str) -> Result<$type, E> {
                        text.parse().map_err(E::custom)
                    }
                }
                deserializer.deserialize_str(Text)
            }
        }
    };
}
text_in_files!(Integer, "an integer in quotes, such as \"-35\"");
text_in_files!(Rational, "a number in quotes, such as \"-35/1296\" or \"0.0266\"");
