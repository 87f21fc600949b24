//! Numbers in bytes, and listings that give errors in binary files a place.

use crate::diagnostic::SourceText;
use crate::exact::Rational;
use crate::float::exact;
use std::fmt::Write as _;
use std::ops::Range;
use std::sync::Arc;

/// Which byte of a number comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ByteOrder {
    Little,
    Big,
}

/// The types of numbers in PLY files, with their names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

const NAMES: [(&str, Kind); 16] = [
    ("char", Kind::I8),
    ("uchar", Kind::U8),
    ("short", Kind::I16),
    ("ushort", Kind::U16),
    ("int", Kind::I32),
    ("uint", Kind::U32),
    ("float", Kind::F32),
    ("double", Kind::F64),
    ("int8", Kind::I8),
    ("uint8", Kind::U8),
    ("int16", Kind::I16),
    ("uint16", Kind::U16),
    ("int32", Kind::I32),
    ("uint32", Kind::U32),
    ("float32", Kind::F32),
    ("float64", Kind::F64),
];

impl Kind {
    pub(super) fn parse(name: &str) -> Option<Kind> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind)
    }
}

/// Bytes that are read one number after the other.
pub(super) struct Bytes<'a> {
    content: &'a [u8],
    pub(super) at: usize,
    order: ByteOrder,
    /// Whether a number was asked for that is not there.
    pub(super) ended: bool,
}

impl<'a> Bytes<'a> {
    pub(super) fn new(bytes: &'a [u8], at: usize, order: ByteOrder) -> Bytes<'a> {
        Bytes { content: bytes, at, order, ended: false }
    }

    pub(super) fn left(&self) -> usize {
        self.content.len().saturating_sub(self.at)
    }

    pub(super) fn skip(&mut self, count: usize) {
        self.at = self.at.saturating_add(count);
    }

    /// The next bytes, the lowest first; `None` where the file ends.
    fn next<const N: usize>(&mut self) -> Option<[u8; N]> {
        let rest = self.content.get(self.at..).unwrap_or_default();
        let Some(mut bytes) = rest.first_chunk::<N>().copied() else {
            self.ended = true;
            return None;
        };
        self.at += N;
        if self.order == ByteOrder::Big {
            bytes.reverse();
        }
        Some(bytes)
    }

    pub(super) fn f32(&mut self) -> Option<Rational> {
        exact(f64::from(f32::from_le_bytes(self.next()?)))
    }

    /// A number of any type; `None` where the file ends, or where it is infinite or none.
    pub(super) fn number(&mut self, kind: Kind) -> Option<Rational> {
        match kind {
            Kind::I8 => self.next().map(|b| Rational::from(i64::from(i8::from_le_bytes(b)))),
            Kind::U8 => self.next().map(|b| Rational::from(i64::from(u8::from_le_bytes(b)))),
            Kind::I16 => self.next().map(|b| Rational::from(i64::from(i16::from_le_bytes(b)))),
            Kind::U16 => self.next().map(|b| Rational::from(i64::from(u16::from_le_bytes(b)))),
            Kind::I32 => self.next().map(|b| Rational::from(i64::from(i32::from_le_bytes(b)))),
            Kind::U32 => self.next().map(|b| Rational::from(i64::from(u32::from_le_bytes(b)))),
            Kind::F32 => self.f32(),
            Kind::F64 => exact(f64::from_le_bytes(self.next()?)),
        }
    }

    /// A count or an index; `None` where the file ends, or where it is negative or no whole number.
    pub(super) fn natural(&mut self, kind: Kind) -> Option<usize> {
        natural(&self.number(kind)?)
    }
}

/// A count or an index; `None` where it is negative or no whole number.
pub(super) fn natural(number: &Rational) -> Option<usize> {
    let whole = number.is_integer().then(|| number.numerator().to_i64()).flatten();
    whole.and_then(|number| usize::try_from(number).ok())
}

/// What stands for the text of a binary file in errors: a line for each thing in it.
#[derive(Default)]
pub(super) struct Listing(String);

impl Listing {
    /// Adds a line.
    pub(super) fn line(&mut self, text: &str) -> Range<usize> {
        let start = self.0.len();
        writeln!(self.0, "{text}").expect("memory");
        start..start + text.len()
    }

    pub(super) fn source(self, name: &str) -> Arc<SourceText> {
        SourceText::new(name, self.0)
    }
}
