//! Bounds of `smoothness` and `hoelder` on a piece, for masks with its symbol. THEOREMS.md, 109, 110 and 118.

#![warn(clippy::arithmetic_side_effects)]

use super::independent_on::has_independent_shifts_on;
use super::known;
use crate::data::contracts;
use crate::formulas::{Expr, Head, Indices, Scope};
use crate::functions::call::{Call, number};
use crate::functions::masks::{Mask, quotient};
use crate::functions::real::Real;
use crate::functions::steps::times;
use crate::numbers::{Piece, Value};
use crate::schemes::{Library, Scheme, Sequence};
use crate::text::Stop;
use std::cell::OnceCell;
use std::rc::Rc;

/// The most residue classes for T_c < 1.
const MAX_CLASSES: usize = 16;

/// What is known of a number on a piece.
pub enum Bounded<'b> {
    /// It is between these two, which may be equal.
    Between([Value; 2]),
    /// It is the value of a call, whose bounds are found when they are asked for.
    Call(Box<Bounds<'b>>),
}

/// A call of one of the two functions, with a mask that depends on the symbol of the piece.
pub struct Bounds<'b> {
    library: &'b Library<'b>,
    piece: &'b Piece<'b>,
    /// Whether it is one of `hoelder`.
    exponent: bool,
    scheme: Rc<Scheme>,
    mask: Mask,
    /// What has been found: the number of sum rules, whether the upper bound is one, and whether T_c < 1 for the mask.
    rules: OnceCell<usize>,
    limited: OnceCell<bool>,
    converges: OnceCell<bool>,
}

/// The name of the function, if a formula is nothing but a call of one of the two.
fn function(expr: &Expr) -> Option<&str> {
    let Expr::Of(Head::Call(function, _), _) = expr else { return None };
    Some(&function[..]).filter(|function| matches!(*function, "smoothness" | "hoelder"))
}

/// Whether a formula is nothing but a call of one of the two functions.
pub fn is_call(expr: &Expr) -> bool {
    function(expr).is_some()
}

/// What is known of a formula on a piece: of a call by its bounds, of other formulas by their values.
pub fn bounded<'b>(
    library: &'b Library<'b>,
    scope: &'b Scope<'b>,
    piece: &'b Piece<'b>,
    expr: &Expr,
) -> Result<Bounded<'b>, Stop> {
    let value = || scope.value(expr).map(|value| Bounded::Between([value.clone(), value]));
    let (Expr::Of(head, parts), Some(function)) = (expr, function(expr)) else { return value() };
    let (parts, options) = scope.asked(head, parts, &Indices::new());
    if !parts.is_empty() {
        return value();
    }
    scope.spend(1)?;
    let mut call = Call::new(library, scope, (function, &[], &options));
    let (scheme, depends) = call.scheme_on()?;
    call.finished()?;
    let exponent = function == "hoelder";
    if !depends {
        let known = if exponent { known::hoelder } else { known::smoothness };
        return Ok(Bounded::Between(match known(library, &scheme)? {
            Real::Exact(value) => [value.clone(), value],
            Real::Between(ends) => ends.map(Value::from),
            _ => return Err(Stop::Undecided("the bounds of a value of smoothness")),
        }));
    }
    let mask = Mask::on(library.meter, &scheme, Some(piece))?;
    let (rules, limited, converges) = Default::default();
    let bounds = Bounds { library, piece, exponent, scheme, mask, rules, limited, converges };
    Ok(Bounded::Call(Box::new(bounds)))
}

/// What `find` finds, once.
fn once<T: Copy>(known: &OnceCell<T>, find: impl FnOnce() -> Result<T, Stop>) -> Result<T, Stop> {
    match known.get() {
        Some(known) => Ok(*known),
        None => find().map(|found| *known.get_or_init(|| found)),
    }
}

impl Bounds<'_> {
    /// The upper bound, if it is one: S for an exponent, and otherwise S − 1.
    pub fn most(&self) -> Result<Value, Stop> {
        let (meter, piece) = (self.library.meter, Some(self.piece));
        let rules = once(&self.rules, || self.mask.sum_rules(meter, piece))?;
        number(rules).minus(&Value::int((!self.exponent).into()))
    }

    /// Whether the upper bound is one.
    pub fn is_limited(&self) -> Result<bool, Stop> {
        once(&self.limited, || {
            if self.exponent && !self.converges()? {
                return Ok(false);
            }
            Ok(self.has_unit()? || has_independent_shifts_on(self.library, &self.mask, self.piece)?)
        })
    }

    /// Whether a rule has one coefficient that is not 0 on the piece. As the rule sums to 1, it is 1: then φ is 1 at one of the
    /// points k/(n − 1) + i and 0 at the others.
    fn has_unit(&self) -> Result<bool, Stop> {
        for rule in &self.scheme.mask {
            let mut others = 0_usize;
            for a in rule {
                let zero = a.is_known_zero(Some(self.piece))?;
                others = others.saturating_add(usize::from(!zero));
            }
            if others == 1 {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether a lower bound is one of the numbers that fit.
    pub fn reaches(&self, fits: impl Fn(&Value) -> Result<bool, Stop>) -> Result<bool, Stop> {
        if !self.exponent && fits(&Value::int(-1))? {
            return Ok(true);
        }
        let (meter, n) = (self.library.meter, self.mask.arity);
        // n^m a/σ^m.
        let (mut derived, mut m) = (self.mask.values.clone(), 0_usize);
        while let Some(next) = quotient(meter, &derived, n, Some(self.piece))? {
            let shows = fits(&number(m))?
                && (!self.exponent || self.converges()?)
                && self.contracts(&next)?;
            if shows {
                return Ok(true);
            }
            let scaled = next.iter().map(|b| times(meter, b, &number(n)));
            derived = scaled.collect::<Result<Vec<Value>, Stop>>()?;
            m = m.saturating_add(1);
        }
        Ok(false)
    }

    /// Whether T_c < 1 for the mask itself.
    fn converges(&self) -> Result<bool, Stop> {
        once(&self.converges, || {
            let (meter, n) = (self.library.meter, self.mask.arity);
            let difference = quotient(meter, &self.mask.values, n, Some(self.piece))?;
            difference.map_or(Ok(false), |difference| self.contracts(&difference))
        })
    }

    /// Whether some class sums of b are below 1: those of b(z)b(z^n)⋯b(z^{n^{c−1}}).
    fn contracts(&self, b: &[Value]) -> Result<bool, Stop> {
        let n = self.mask.arity;
        let width = b.len().div_ceil(n);
        let rule = |beta: usize| {
            let entries = b.iter().skip(beta).step_by(n).cloned();
            entries.chain(std::iter::repeat(Value::int(0))).take(width).collect()
        };
        let rules: Vec<Vec<Value>> = (0..n).map(rule).collect();
        let of = Sequence { rules: &rules, forward: true };
        contracts(self.library, of, MAX_CLASSES, Some(self.piece))
    }
}
