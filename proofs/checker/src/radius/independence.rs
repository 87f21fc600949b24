//! Whether the shifts of the limit function of a mask are linearly independent. THEOREMS.md, 108 and 121.

use super::element::Element;
use crate::numbers::{Meter, count};
use crate::text::Stop;

/// Whether no z ≠ 0 is a common zero of the n parts of the symbol, and there is no z ≠ 1 such that A(wω) = 0 for all w =
/// z, z^n, z^{n²}, …, and all ω ≠ 1 with ω^n = 1.
pub fn is_independent(symbol: &[Element], n: usize, meter: &Meter) -> Result<bool, Stop> {
    let start = symbol.iter().position(|a| a.sign() != 0).unwrap_or(0);
    let symbol = &symbol[start..];
    let mut common = Vec::new();
    for e in 0..n {
        let part: Vec<Element> = symbol.iter().skip(e).step_by(n).cloned().collect();
        common = gcd(&common, &part, meter)?;
    }
    Ok(common.len() == 1 && closed(symbol, n, meter)?.len() == 1)
}

/// The square-free polynomial of these z.
///
/// A(wω) = Σ ω^e·w^eA_e(w^n) with the parts A_e. This is 0 for all these ω if and only if all w^eA_e(w^n) agree.
fn closed(symbol: &[Element], n: usize, meter: &Meter) -> Result<Vec<Element>, Stop> {
    let difference = |e: usize| -> Vec<Element> {
        let term = |(i, a): (usize, &Element)| match i % n {
            class if class == e => a.clone(),
            class if class == e + 1 => Element::whole(0).minus(a),
            _ => Element::whole(0),
        };
        symbol.iter().enumerate().map(term).collect()
    };
    let mut common = Vec::new();
    for e in 0..n - 1 {
        common = gcd(&common, &difference(e), meter)?;
    }
    if common.is_empty() {
        return Ok(common);
    }
    let derivative: Vec<Element> = (1..common.len()).map(|i| common[i].scaled(&count(i))).collect();
    let mut closed = divided(&common, &gcd(&common, &derivative, meter)?, meter)?.0;
    let one = [Element::whole(0).minus(&Element::whole(1)), Element::whole(1)];
    let (without, rest) = divided(&closed, &one, meter)?;
    if rest.is_empty() {
        closed = without;
    }
    loop {
        let mut stretched = vec![Element::whole(0); closed.len().saturating_sub(1) * n + 1];
        for (i, c) in closed.iter().enumerate() {
            stretched[i * n] = c.clone();
        }
        let next = gcd(&closed, &stretched, meter)?;
        if next.len() == closed.len() {
            return Ok(next);
        }
        closed = next;
    }
}

fn trimmed(mut p: Vec<Element>) -> Vec<Element> {
    while p.last().is_some_and(|c| c.sign() == 0) {
        p.pop();
    }
    p
}

/// A quotient and a remainder.
type Divided = (Vec<Element>, Vec<Element>);

/// The quotient and the remainder by a polynomial whose last coefficient is not 0.
fn divided(p: &[Element], q: &[Element], meter: &Meter) -> Result<Divided, Stop> {
    // None is left where a sign was not found, and then nothing counts.
    let Some(degree) = q.len().checked_sub(1) else { return Ok(Divided::default()) };
    let inverse = q[degree].inverse();
    let mut rest = p.to_vec();
    let mut quotient = vec![Element::whole(0); rest.len().saturating_sub(degree)];
    for i in (0..quotient.len()).rev() {
        quotient[i] = rest[i + degree].metered_times(&inverse, meter)?;
        let less = quotient[i].negated();
        for (j, c) in q.iter().enumerate() {
            rest[i + j].add_product(&less, c, meter)?;
        }
    }
    rest.truncate(degree);
    Ok((quotient, trimmed(rest)))
}

/// The monic greatest common divisor.
fn gcd(p: &[Element], q: &[Element], meter: &Meter) -> Result<Vec<Element>, Stop> {
    let monic = |p: Vec<Element>| -> Result<Vec<Element>, Stop> {
        let p = trimmed(p);
        let Some(inverse) = p.last().map(Element::inverse) else { return Ok(Vec::new()) };
        p.iter().map(|c| c.metered_times(&inverse, meter)).collect()
    };
    let (mut one, mut other) = (monic(p.to_vec())?, monic(q.to_vec())?);
    while !other.is_empty() {
        let rest = monic(divided(&one, &other, meter)?.1)?;
        (one, other) = (other, rest);
    }
    Ok(one)
}
