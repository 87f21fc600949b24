//! Functions of rings, and eigenvalues of masks.

#![warn(clippy::arithmetic_side_effects)]

mod places;
mod polynomials;
mod roots;
mod sectors;
mod tangents;

use super::call::{Call, index, wrong};
use super::masks::{Mask, signed};
use super::real::Real;
use super::steps::Values;
use crate::formulas::MAX_INTEGER;
use crate::numbers::{Meter, Value, characteristic};
use crate::text::Stop;
use places::{Factor, Place, decide};
use polynomials::Polynomial;
use roots::{Root, Roots};
use sectors::{Sectors, of_each, over_square};
use std::cmp::Ordering;
use std::rc::Rc;
use tangents::Tangents;

/// The greatest valence.
const MAX_VALENCE: i64 = 100;

/// The greatest number of a point of which a weight is asked.
const MAX_POINT: i64 = 100;

/// The most rows of the matrix of a mask.
const MAX_ROWS: usize = 64;

/// The parts of `curvature`.
const PARTS: [&str; 3] = ["both", "elliptic", "hyperbolic"];

/// The value of such a function, if it is known; `None` if the call is none of them.
pub fn of(call: &mut Call<'_>) -> Result<Option<Value>, Stop> {
    real(call)?.map(Real::value).transpose()
}

/// The same as a real number.
pub fn real(call: &mut Call<'_>) -> Result<Option<Real>, Stop> {
    let meter = call.library.meter;
    Ok(Some(match (call.function, call.arguments) {
        ("eigenvalue", [j]) => {
            let mask = Mask::of_numbers(meter, &*call.scheme()?)?;
            nth(&Roots::new(meter, &of_mask(meter, &mask)?)?, j)?
        }
        ("eigenvalue", [valence, k, j]) => {
            let (sectors, n) = sectors(call, valence)?;
            let k = index(k, 0, n.saturating_sub(1))?;
            let p = if k == 0 { sectors.still()? } else { sectors.turning()?.block(k)? };
            nth(&Roots::new(meter, &p)?, j)?
        }
        ("subdominant", [valence]) => {
            let spectrum = Spectrum::new(meter, &sectors(call, valence)?.0)?;
            spectrum.is_dominated(meter)?;
            spectrum.lambda.place.real()?
        }
        ("curvature", [valence]) => {
            let part = call.choose("part", &PARTS)?;
            let spectrum = Spectrum::new(meter, &sectors(call, valence)?.0)?;
            spectrum.is_dominated(meter)?;
            spectrum.curvature(meter, part)?
        }
        ("limit_weight", [valence]) => {
            let (sectors, _) = sectors(call, valence)?;
            converges(meter, &sectors)?;
            let (place, weights) = (orbit(call, &sectors)?, sectors.limit()?);
            let (Some(weight), Some((_, count))) = (weights.get(place), sectors.orbits.get(place))
            else {
                return wrong("the ring has no such orbit");
            };
            Real::Exact(of_each(meter, weight, *count)?)
        }
        ("tangent_weight", [valence, j]) => {
            let (sectors, _) = sectors(call, valence)?;
            let j = index(j, 0, MAX_POINT)?;
            let place = orbit(call, &sectors)?;
            let second = call.choose("tangent", &["first", "second"])? == 1;
            let spectrum = Spectrum::new(meter, &sectors)?;
            spectrum.is_dominated(meter)?;
            let tangents = Tangents::new(meter, &sectors, &spectrum.lambda.place)?;
            let turns = |(_, count): &&(String, usize)| *count > 1;
            match sectors.orbits.get(place).filter(turns) {
                Some(_) => {
                    let before = sectors.orbits.iter().take(place).filter(turns).count();
                    tangents.weight(before, j, second)?
                }
                None => Real::Exact(Value::int(0)),
            }
        }
        _ => return Ok(None),
    }))
}

/// The place of the orbit that a call names, or 0.
fn orbit(call: &mut Call<'_>, sectors: &Sectors<'_>) -> Result<usize, Stop> {
    let first = sectors.orbits.first().map_or("", |(name, _)| name);
    let name = call.word("orbit", first);
    let place = sectors.orbits.iter().position(|(orbit, _)| *orbit == name);
    place.ok_or_else(|| Stop::Wrong(format!("the ring has no orbit `{name}`")))
}

/// The ring of a call at a valence, and this.
fn sectors<'c>(call: &mut Call<'c>, valence: &Value) -> Result<(Sectors<'c>, i64), Stop> {
    let count = index(valence, 3, MAX_VALENCE)?;
    let n = signed(count)?;
    let ring = call.ring(n)?;
    Ok((Sectors::new(call.library.meter, &ring, count)?, n))
}

/// The j-th greatest real root.
fn nth(roots: &Roots, j: &Value) -> Result<Real, Stop> {
    let root = roots.nth(index(j, 1, MAX_INTEGER)?);
    root.ok_or_else(|| Stop::Wrong("there are not so many real roots".into()))?.place.real()
}

/// The characteristic polynomial of (a_{nk−l}), l_0 < k(n − 1), l(n − 1) < K.
fn of_mask(meter: &Meter, mask: &Mask) -> Result<Polynomial, Stop> {
    let size = Stop::Capped("the size of a matrix");
    let (n, last) = (signed(mask.arity)?, mask.last()?);
    let below = n.saturating_sub(1).max(1);
    let least = mask.first.div_euclid(below).saturating_add(1);
    // The greatest integer below K/(n − 1).
    let most = last.saturating_sub(1).div_euclid(below);
    if most.saturating_sub(least) >= signed(MAX_ROWS)? {
        return Err(size);
    }
    let mut matrix: Vec<Vec<Value>> = Vec::new();
    for k in least..=most {
        let entry = |l: i64| {
            let place = n.checked_mul(k).and_then(|place| place.checked_sub(l));
            let a = place.and_then(|place| mask.at(place)).cloned();
            a.unwrap_or_else(|| Value::int(0))
        };
        matrix.push((least..=most).map(entry).collect());
    }
    characteristic(&Values(meter), &matrix)
}

/// The roots of M_0 without 1, those of M_1 without λ, and those of the M_k, k ≤ N/2.
struct Spectrum {
    lambda: Root,
    valence: usize,
    others: Vec<Roots>,
}

impl Spectrum {
    /// The roots of all blocks, if 1 and λ, 0 < λ < 1, are simple ones.
    fn new(meter: &Meter, sectors: &Sectors<'_>) -> Result<Spectrum, Stop> {
        let mut others = without_one(meter, sectors)?;
        let [_, first, ..] = &mut others[..] else { return wrong("the ring has no blocks") };
        if first.real.is_empty() {
            return wrong("block 1 has no real root");
        }
        let lambda = first.real.remove(0);
        let one = Place::Exact(Value::int(1));
        if lambda.multiplicity > 1
            || lambda.place.sign(meter)? <= 0
            || lambda.place.compare(meter, &one)? != Ordering::Less
        {
            return Err(Stop::Undefined("λ is not a simple root of block 1 between 0 and 1"));
        }
        Ok(Spectrum { lambda, valence: sectors.valence, others })
    }

    /// Checks that all other roots are less than λ in absolute value.
    fn is_dominated(&self, meter: &Meter) -> Result<(), Stop> {
        for root in self.others.iter().flat_map(|roots| &roots.real) {
            let size = root.place.absolute(meter)?;
            if size.compare(meter, &self.lambda.place)? != Ordering::Less {
                return Err(Stop::Undefined("another root is not less than λ"));
            }
        }
        are_below(meter, self.others.iter().flat_map(|roots| &roots.complex), &self.lambda.place)
    }

    /// The greatest absolute value of other roots over λ².
    fn curvature(&self, meter: &Meter, part: usize) -> Result<Real, Stop> {
        let counted = match (part, &self.others[..]) {
            (1, [still, ..]) => std::slice::from_ref(still),
            // The roots of M_2 are those of M_1 for N = 3.
            (2, [_, first]) if self.valence == 3 => std::slice::from_ref(first),
            (2, [_, _, second, ..]) => std::slice::from_ref(second),
            (_, all) => all,
        };
        let mut greatest: Option<Place> = None;
        for root in counted.iter().flat_map(|roots| &roots.real) {
            let size = root.place.absolute(meter)?;
            let greater = match &greatest {
                Some(known) => size.compare(meter, known)? == Ordering::Greater,
                None => true,
            };
            if greater {
                greatest = Some(size);
            }
        }
        let complex = || counted.iter().flat_map(|roots| &roots.complex);
        let Some(greatest) = greatest else {
            let some = complex().next().is_some();
            let capped = Stop::Capped("a curvature by roots that are not real");
            return if some { Err(capped) } else { wrong("the blocks have no other roots") };
        };
        are_below(meter, complex(), &greatest)?;
        if let (Place::Exact(mu), Place::Exact(lambda)) = (&greatest, &self.lambda.place) {
            return Ok(Real::Exact(over_square(meter, mu, lambda)?));
        }
        let lambda = || self.lambda.place.real().map(Box::new);
        let once = Real::Ratio(Box::new(greatest.real()?), lambda()?);
        Ok(Real::Ratio(Box::new(once), lambda()?))
    }
}

/// The roots of M_0 without 1, which is a simple one, and those of the M_k, k ≤ N/2.
fn without_one(meter: &Meter, sectors: &Sectors<'_>) -> Result<Vec<Roots>, Stop> {
    let turning = sectors.turning()?;
    let mut still = Roots::new(meter, &sectors.still()?)?;
    let one = Value::int(1);
    let is_one = |root: &Root| matches!(&root.place, Place::Exact(x) if *x == one);
    let place = still.real.iter().position(is_one);
    let one = place.map(|place| still.real.remove(place));
    if one.is_none_or(|one| one.multiplicity > 1) {
        return Err(Stop::Undefined("1 is not a simple root of block 0"));
    }
    let mut found = vec![still];
    for k in 1..=sectors.valence.div_euclid(2) {
        found.push(Roots::new(meter, &turning.block(k)?)?);
    }
    Ok(found)
}

/// Checks that all roots but a simple 1 are less than 1 in absolute value.
fn converges(meter: &Meter, sectors: &Sectors<'_>) -> Result<(), Stop> {
    let (others, one) = (without_one(meter, sectors)?, Place::Exact(Value::int(1)));
    for root in others.iter().flat_map(|roots| &roots.real) {
        if root.place.absolute(meter)?.compare(meter, &one)? != Ordering::Less {
            return Err(Stop::Undefined("another root is not less than 1"));
        }
    }
    are_below(meter, others.iter().flat_map(|roots| &roots.complex), &one)
}

/// Checks that the roots of factors that are not real are less in absolute value than a positive number.
fn are_below<'f>(
    meter: &Meter,
    mut factors: impl Iterator<Item = &'f Rc<Factor>>,
    limit: &Place,
) -> Result<(), Stop> {
    factors.try_for_each(|factor| {
        decide(|bits| {
            let (low, _) = limit.enclosed(meter, bits)?.ends();
            Ok(factor.is_within(meter, &low, bits)?.then_some(()))
        })
    })
}
