//! The signs of numbers, and of polynomials on a piece of a line.

use super::decimal::Q;
use super::meter::Meter;
use super::polynomial::{divide, steps_of_gcd, trimmed};
use super::root::{Root, sign_between};
use super::value::Value;
use crate::text::Stop;
use num_traits::Zero as _;
use std::cell::RefCell;
use std::cmp::Ordering;

/// The most cuts of a piece.
pub const MAX_CUTS: usize = 1_000;

/// The ends of a piece; `None` is infinite.
pub type Ends = [Option<Root>; 2];

/// An open interval of a symbol, or one number if both ends are the same.
///
/// A polynomial with a root in the interval has no sign there. If its sign is asked for, the piece
/// is cut at the root and becomes the part above. The signs that were found before hold there too.
pub struct Piece<'m> {
    symbol: String,
    meter: &'m Meter,
    ends: RefCell<Ends>,
    cuts: RefCell<Vec<Root>>,
    of_masks: bool,
}

impl<'m> Piece<'m> {
    /// A piece that is not cut. The meter counts the steps of signs.
    pub fn new(symbol: &str, ends: Ends, meter: &'m Meter) -> Piece<'m> {
        let (symbol, cuts) = (symbol.to_owned(), RefCell::default());
        Piece { symbol, meter, ends: RefCell::new(ends), cuts, of_masks: false }
    }

    /// The same piece, on which functions of masks take masks with the symbol.
    pub fn of_masks(self) -> Piece<'m> {
        Piece { of_masks: true, ..self }
    }

    /// Whether they do.
    pub fn is_of_masks(&self) -> bool {
        self.of_masks
    }

    /// Whether it is one number.
    pub fn is_one(&self) -> bool {
        let [low, high] = &*self.ends.borrow();
        low.is_some() && low == high
    }

    /// This number, if it is one.
    pub fn one(&self) -> Option<Root> {
        let [low, high] = &*self.ends.borrow();
        low.as_ref().filter(|_| low == high).cloned()
    }

    /// The symbol.
    pub fn symbol(&self) -> &str {
        &self.symbol
    }

    /// The cuts, from below.
    pub fn cuts(&self) -> Vec<Root> {
        self.cuts.borrow().clone()
    }

    /// The sign of a polynomial. The piece is cut until there is one.
    fn sign_of(&self, p: &[Q]) -> Result<i8, Stop> {
        loop {
            let [low, high] = &mut *self.ends.borrow_mut();
            let root = match (&low, &high) {
                (Some(low), Some(high)) if low == high => return low.sign_of(p, self.meter),
                (low, high) => match sign_between(p, low.as_ref(), high.as_ref(), self.meter)? {
                    Ok(sign) => return Ok(sign),
                    Err(root) => *root,
                },
            };
            let mut cuts = self.cuts.borrow_mut();
            if cuts.len() == MAX_CUTS {
                return Err(Stop::Capped("the number of pieces"));
            }
            cuts.push(root.clone());
            *low = Some(root);
        }
    }
}

impl Value {
    /// The sign of a number, or of a polynomial on a piece.
    pub fn sign(&self, piece: Option<&Piece<'_>>) -> Result<i8, Stop> {
        match (self.number(), piece) {
            (Err(_), Some(piece)) => {
                let polynomial = self.univariate(&piece.symbol);
                let no_polynomial = || Stop::Wrong("this is no polynomial in one symbol".into());
                piece.sign_of(&polynomial.ok_or_else(no_polynomial)?)
            }
            (number, _) => number?.sign(),
        }
    }

    /// Whether it is 0: a number, a polynomial on a piece, or without a piece a polynomial.
    pub fn is_zero_on(&self, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
        match (self.number(), piece) {
            (Err(_), Some(_)) => Ok(self.sign(piece)? == 0),
            _ => Ok(self.is_zero()),
        }
    }

    /// Whether it is known to be 0 without a cut: on an interval only the polynomial 0 is.
    pub fn is_known_zero(&self, piece: Option<&Piece<'_>>) -> Result<bool, Stop> {
        match piece.filter(|piece| piece.is_one()) {
            None => Ok(self.is_zero()),
            one => self.is_zero_on(one),
        }
    }

    /// self/divisor, for a number that is not 0, or a polynomial in the symbol of the piece that divides this one.
    pub fn share_of(
        &self,
        divisor: &Value,
        piece: Option<&Piece<'_>>,
        meter: &Meter,
    ) -> Result<Value, Stop> {
        let (Err(_), Some(piece)) = (divisor.number(), piece) else {
            meter.spend(self.steps(divisor).saturating_add(self.cost_of_quotient(divisor)))?;
            return self.over(divisor);
        };
        let no_share = || Stop::Wrong("a polynomial does not divide another".into());
        let of = |value: &Value| value.univariate(&piece.symbol).ok_or_else(no_share);
        let (divisor, whole) = (of(divisor)?, of(self)?);
        meter.spend(steps_of_gcd(&whole, &divisor))?;
        let (share, rest) = divide(whole, &trimmed(divisor));
        if rest.iter().any(|c| !c.is_zero()) {
            return Err(no_share());
        }
        Ok(Value::polynomial(&piece.symbol, share))
    }

    /// |self|.
    pub fn abs(&self, piece: Option<&Piece<'_>>) -> Result<Value, Stop> {
        if self.sign(piece)? < 0 { self.negated() } else { Ok(self.clone()) }
    }

    /// The greater of the two.
    pub fn max(&self, other: &Value, piece: Option<&Piece<'_>>) -> Result<Value, Stop> {
        let less = self.compare_on(other, piece)?.is_lt();
        Ok(if less { other.clone() } else { self.clone() })
    }

    /// The greatest of these, and of 0.
    pub fn greatest(values: &[Value], piece: Option<&Piece<'_>>) -> Result<Value, Stop> {
        values.iter().try_fold(Value::int(0), |best, value| best.max(value, piece))
    }

    /// How two numbers compare.
    pub fn compare(&self, other: &Value) -> Result<Ordering, Stop> {
        self.compare_on(other, None)
    }

    /// How two numbers compare, or two polynomials on a piece.
    pub fn compare_on(&self, other: &Value, piece: Option<&Piece<'_>>) -> Result<Ordering, Stop> {
        match (self.number(), other.number()) {
            (Ok(one), Ok(other)) => one.compare(other),
            _ => Ok(self.minus(other)?.sign(piece)?.cmp(&0)),
        }
    }
}
