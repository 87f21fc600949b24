//! The functions by their names.

#![warn(clippy::arithmetic_side_effects)]

use super::call::{Call, TERMS, entry, number, within, wrong};
use super::depth::depth;
use super::roots::{root, square_root};
use super::sums::greatest;
use super::{
    exponent, families, lattice, limits, masks, modulus, peaks, ratios, shape, vertices, zeros,
};
use crate::data::{best_offset, moved, surface};
use crate::formulas::{Asked, Functions, Indices, MAX_INTEGER, Scope};
use crate::numbers::{Meter, Number, Q, Value, capped};
use crate::schemes::{Library, MAX_OFFSET, Product};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::ToPrimitive as _;

/// The greatest integer whose factorial is taken.
const MAX_FACTORIAL: i64 = 1_000;

impl Functions for Library<'_> {
    fn call(&self, scope: &Scope<'_>, of: Asked<'_>, indices: &mut Indices) -> Result<Value, Stop> {
        let mut call = Call::new(self, scope, of);
        let value = value(&mut call, indices)?;
        call.finished().map(|()| value)
    }

    fn meter(&self) -> &Meter {
        self.meter
    }

    fn has_scheme(&self, name: &str) -> bool {
        self.has(name)
    }
}

fn value(call: &mut Call<'_>, indices: &mut Indices) -> Result<Value, Stop> {
    let (library, scope, function) = (call.library, call.scope, call.function);
    let piece = scope.piece.as_ref();
    if let Some(value) = lattice::of(call)? {
        return Ok(value);
    }
    if let Some(value) = families::of(call)? {
        return Ok(value);
    }
    match (function, call.arguments) {
        ("cos", [angle]) => match angle.multiple_of("pi") {
            Some(multiple) => {
                let turns = multiple / Q::from_integer(2.into());
                // The fields end at a denominator of 1000.
                let n = turns.denom().to_u64().map_or(1_000, |n| n.min(1_000));
                library.meter.spend(n.saturating_mul(n) / 16)?;
                Ok(Number::cosine(&turns)?.into())
            }
            None => wrong("`cos` takes one rational multiple of pi"),
        },
        ("abs", [x]) => x.abs(piece),
        ("max" | "min", [first, rest @ ..]) => {
            rest.iter().try_fold(first.clone(), |best, x| scope.join(function, &best, x))
        }
        ("floor", [x]) => floor(x),
        ("ceil", [x]) => floor(&x.negated()?)?.negated(),
        ("mod", [x, m]) => {
            scope.spend(x.cost_of_quotient(m))?;
            x.minus(&m.times(&floor(&x.over(m)?)?)?)
        }
        ("sqrt", [x]) => match x.rational() {
            Some(x) => Ok(square_root(library.meter, &x)?.into()),
            None => Err(Stop::OtherRoot),
        },
        ("root", [coefficients @ .., number]) => {
            root(library.meter, coefficients, number.integer(MAX_INTEGER)?)
        }
        ("kronecker", [a, b]) => {
            let difference = a.minus(b)?;
            Ok(Value::int(difference.number()?.is_zero().into()))
        }
        ("factorial", [n]) => factorial(scope, within(n, 0, MAX_FACTORIAL)?),
        ("binomial", [top, bottom]) => binomial(scope, top, bottom.integer(10_000)?),
        ("levels", [ratio, x, block @ ..]) if block.len() < 2 => {
            let rounding = call.choose("rounded", &["up", "nearest", "down"])?;
            let levels = Value::int(depth(library.meter, ratio, x, rounding)?);
            match block {
                [c] if call.choose("exponent", &["level", "block"])? == 1 => levels.times(c),
                _ => Ok(levels),
            }
        }
        ("arity", []) => Ok(number(call.scheme()?.arity())),
        ("width", []) => Ok(number(call.scheme()?.width())),
        ("mask", [rule, column]) => entry(&call.scheme()?.mask, rule, column),
        ("difference", [rule, column]) => entry(&call.scheme()?.difference, rule, column),
        ("contraction" | "norm" | "tensor" | "convolution_norm", _) => greatest(call, indices),
        ("convolution", [c, l, f]) => {
            let scheme = call.scheme()?;
            let sequence = call.sequence(&scheme.difference)?;
            let how = call.convolution(c, &number(scheme.arity()), 4)?;
            let product = library.products.of_mask(how, sequence)?;
            coefficient(&product, l, f.integer(MAX_INTEGER)?)
        }
        ("convolved", [c, n, length, l, f]) => {
            let how = call.convolution(c, n, 3)?;
            let (sequences, f) = (call.sequences(length, indices)?, f.integer(MAX_INTEGER)?);
            // There are no coefficients of a negative f.
            let length = usize::try_from(f).map_or(0, |f| f.saturating_add(1));
            let product = library.products.of(how, &sequences[0], length)?;
            coefficient(&product, l, f)
        }
        ("displacement", []) => {
            let (scheme, terms) = (call.scheme()?, call.choose("terms", &TERMS)?);
            let word = call.word("offset", "own");
            let o = match word.parse::<BigInt>() {
                _ if word == "own" => scheme.offset,
                _ if word == "best" && piece.is_none() => best_offset(library.meter, &scheme)?,
                Ok(o) => capped(&o, MAX_OFFSET).ok_or(Stop::Capped("the size of an offset"))?,
                Err(_) => return wrong(format!("`{word}` is no offset")),
            };
            Value::greatest(&moved(library.meter, piece, (&scheme, o), terms)?, piece)
        }
        ("surface_displacement", [x1, x2, x3]) => {
            let (scheme, terms) = (call.scheme()?, call.choose("terms", &TERMS)?);
            let sums = surface(library.meter, piece, &scheme, [x1, x2, x3], terms)?;
            sums[1..].iter().try_fold(sums[0].clone(), |best, sum| best.max(sum, piece))
        }
        ("positive" | "monotone" | "convex", []) => shape::of(call),
        (_, arguments) => {
            let of_masks = [masks::of, zeros::of, ratios::of, modulus::of];
            let others = [limits::of, exponent::of, peaks::of, vertices::of];
            for group in of_masks.into_iter().chain(others) {
                if let Some(value) = group(call)? {
                    return Ok(value);
                }
            }
            wrong(format!("there is no `{function}` of {} arguments", arguments.len()))
        }
    }
}

/// ⌊x⌋.
fn floor(x: &Value) -> Result<Value, Stop> {
    Ok(Q::from_integer(x.floor()?).into())
}

/// E^c_{l,f}.
fn coefficient(product: &Product, l: &Value, f: i64) -> Result<Value, Stop> {
    // The sums of E begin at l = 0.
    let l = within(l, 0, MAX_INTEGER)?;
    usize::try_from(f).map_or(Ok(Value::int(0)), |f| product.at(l, f))
}

/// n!.
fn factorial(scope: &Scope<'_>, n: usize) -> Result<Value, Stop> {
    (1..=n).try_fold(Value::int(1), |product, i| scope.join("product", &product, &number(i)))
}

/// top(top − 1)…(top − bottom + 1)/bottom!, and 0 for bottom < 0.
fn binomial(scope: &Scope<'_>, top: &Value, bottom: i64) -> Result<Value, Stop> {
    (0..bottom).zip(1..).try_fold(Value::int((bottom >= 0).into()), |product, (i, next)| {
        // A product of fractions needs their common divisors.
        scope.spend(product.cost(&product))?;
        product.times(&top.minus(&Value::int(i))?)?.over(&Value::int(next))
    })
}
