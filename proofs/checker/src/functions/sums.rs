//! The functions whose value is the greatest of some sums: `contraction`, `norm`, `tensor` and
//! `convolution_norm`.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, SUPREMA, TERMS, wrong};
use crate::data::gather;
use crate::formulas::{Expr, Head, Indices, MAX_INTEGER, Scope};
use crate::numbers::Value;
use crate::schemes::{Constant, Library, MAX_LENGTH, Sequence, Sums};
use crate::text::Stop;
use std::rc::Rc;

/// The value of such a function.
pub fn greatest(call: &mut Call<'_>, indices: &mut Indices) -> Result<Value, Stop> {
    let piece = call.scope.piece.as_ref();
    let (lists, joint) = sums(call, indices, true)?;
    if let ([one, other], true) = (&lists[..], joint) {
        let pairs = one.units.iter().zip(&*other.units);
        let units = pairs.map(|(a, b)| a.times(b)).collect::<Result<_, _>>()?;
        return Sums { first: 0, units, scale: one.scale.times(&other.scale)? }.greatest(piece);
    }
    lists.iter().try_fold(Value::int(1), |product, list| product.times(&list.greatest(piece)?))
}

/// The sums of which the value of a constant's formula is the greatest.
pub fn of_constant(library: &Library<'_>, scope: &Scope<'_>, expr: &Expr) -> Result<Sums, Stop> {
    let Expr::Of(head @ Head::Call(function, _), parts) = expr else {
        return wrong("this is no constant");
    };
    let (arguments, options) = scope.asked(head, parts, &Indices::new());
    let arguments = arguments.iter().map(|argument| scope.value(argument));
    let arguments = &arguments.collect::<Result<Vec<Value>, Stop>>()?;
    let mut call = Call::new(library, scope, (function, arguments, &options));
    let (mut lists, _) = sums(&mut call, &mut Vec::new(), false)?;
    match lists.pop() {
        Some(sums) if lists.is_empty() && call.finished().is_ok() => Ok(sums),
        _ => wrong("this is no constant that is attained in one class"),
    }
}

/// The sums of one or two sequences, and whether their suprema are joint. If only the greatest
/// sum is asked for, a line `constant` may have shown it.
fn sums(
    call: &mut Call<'_>,
    indices: &mut Indices,
    greatest: bool,
) -> Result<(Vec<Sums>, bool), Stop> {
    let (library, piece) = (call.library, call.scope.piece.as_ref());
    if let ("convolution_norm", [c, n, length, last]) = (call.function, call.arguments) {
        let how = call.convolution(c, n, 16)?;
        let joint = call.choose("suprema", &SUPREMA)? == 1;
        let last = usize::try_from(last.integer(MAX_INTEGER)?)
            .map_err(|_| Stop::Wrong("the last index is below 0".to_owned()))?;
        if last > MAX_LENGTH {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        let end = last.saturating_add(1);
        let first = end.saturating_sub(how.classes());
        let sums = call.sequences(length, indices)?.into_iter().map(|sequence| {
            let product = library.products.of(how, &sequence, end)?;
            product.sums(library.meter, (first, last), piece)
        });
        return Ok((sums.collect::<Result<_, Stop>>()?, joint));
    }
    let (function, scheme) = (call.function, call.scheme()?);
    let (forward, first) =
        (call.is_forward()?, call.scope.first.checked_rem(scheme.arity()).unwrap_or(0));
    // The norms of powers depend on the numbers of the points only if masks are read forwards.
    let scheme = if forward { scheme.numbered_from(first)? } else { scheme };
    let (a, b) = (&scheme.mask[..], &scheme.difference[..]);
    let one = Value::int(1);
    let c = match call.arguments {
        [] => &one,
        [c] => c,
        _ => return wrong(format!("`{function}` takes one number")),
    };
    let masks = match function {
        "contraction" => &[b][..],
        "norm" => &[a],
        "tensor" => &[b, a],
        _ => return wrong(format!("`{function}` is no constant of this kind")),
    };
    if function == "contraction" && call.choose("terms", &TERMS)? == 1 {
        if *c != one {
            return Err(Stop::Undefined("`terms = total` is defined for c = 1 only"));
        }
        let sums = b.iter().map(|row| gather(piece, row, 1));
        return Ok((vec![Sums::new(sums.collect::<Result<_, _>>()?)], false));
    }
    let joint = function == "tensor" && call.choose("suprema", &SUPREMA)? == 1;
    let level = c.integer(MAX_INTEGER).ok().and_then(|c| u32::try_from(c).ok());
    let sums = masks.iter().map(|&rules| {
        let of = Sequence { rules, forward };
        if let Some(level) = level {
            let (scheme, norm) = (Rc::clone(&scheme), std::ptr::eq(rules, a));
            library.note(|| Constant { scheme, norm, forward, level });
        }
        match level.and_then(|level| library.products.shown(of, level)) {
            Some(value) if !joint && greatest => Ok(Sums::new(vec![value])),
            _ => library.products.classes(of, c, piece),
        }
    });
    Ok((sums.collect::<Result<_, _>>()?, joint))
}
