//! One valence: C¹ proved, refuted, or open.

use super::ball::Ball;
use super::exponent::{Exponent, exponent};
use super::family::Family;
use super::inner::Inner;
use super::interpolating::{self, is_butterfly};
use super::jacobian::{jacobian_at, least, unit};
use super::lines::{RingLine, lines, mapped};
use super::net::Net;
use super::ring::{
    Ring, RingBox, RingPoint, all_boxes, examined, in_half_plane, outer_curve, ring_pieces,
};
use super::rules::{Reason, Rules, rules};
use super::verdict::{Hypothesis, Refutation, Verdict};
use super::winding::winding;
use crate::exact::{Enclosed as _, Integer, Rational, RealCyclotomic, RealExpression};
use crate::scheme::LocalRules;
use crate::spectrum::{Eigenvalue, Spectrum, SpectrumError, surroundings};

/// A real eigenvalue λ that is alone of its modulus after 1, of the blocks k and n − k, or of block 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Second {
    /// k, k < n/2.
    pub block: usize,
    /// λ.
    pub value: RealExpression,
}

/// What is known of the surface at the vertex or on the face.
#[derive(Clone, Debug)]
pub struct Vertex {
    /// The regular part; `None` where none is known.
    pub family: Option<Family>,
    /// Whether the points next to the vertex have rules of their own: then the ring has twelve pieces in each sector.
    pub own: bool,
    /// Whether the rules are those of the regular part at its regular valence, so that the surface is C².
    pub regular: bool,
    /// The spectrum, of the wider ring where the regular part is known.
    pub spectrum: Spectrum,
    /// The eigenvalue whose eigenvectors decide.
    pub second: Option<Second>,
    /// The hypothesis on these eigenvalues that fails, if one does. The verdict may say more.
    pub hypothesis: Option<Hypothesis>,
    /// Whether the surface is C¹.
    pub verdict: Verdict,
    /// How smooth its first derivatives are, where it is C¹.
    pub exponent: Option<Exponent>,
    /// The net of an eigenvector of λ, of block k or 0.
    net: Option<Net<Ball>>,
}

impl Vertex {
    /// The rules of a scheme at a valence, which may stand in the scheme itself.
    ///
    /// # Errors
    /// When the scheme names no ring, or its spectrum is out of reach.
    ///
    /// # Panics
    /// Never.
    ///
    /// ```
    /// use subcert::characteristic::{Verdict, Vertex};
    ///
    /// let vertex = Vertex::of("doo-sabin", Some(5))?;
    /// assert!(matches!(vertex.verdict, Verdict::Proved { bisections: 0, .. }));
    /// # Ok::<(), subcert::spectrum::SpectrumError>(())
    /// ```
    pub fn of(scheme: &str, valence: Option<usize>) -> Result<Vertex, SpectrumError> {
        let known = surroundings(scheme, valence)?;
        let mut rules = rules(known.ring)?;
        rules.wider = rules.wider.or(known.wider);
        Vertex::judged(rules)
    }

    /// The rules of a ring.
    ///
    /// # Errors
    /// When its spectrum is out of reach.
    ///
    /// # Panics
    /// Never.
    pub fn of_ring(ring: LocalRules) -> Result<Vertex, SpectrumError> {
        Vertex::judged(rules(ring)?)
    }

    fn judged(rules: Rules) -> Result<Vertex, SpectrumError> {
        let Rules { family, reason, own, regular, ring, wider } = rules;
        let spectrum = Spectrum::known(&ring, wider.as_ref())?;
        let (found, mut net) = (second(&spectrum), None);
        let verdict = match (family, reason, &found) {
            (Some(family), None, Ok(second)) => {
                let inner = Inner::new(family, &ring, spectrum.order);
                let value = Ball::of(&second.value);
                let cosine = inner.cosine(second.block);
                let vector = match second.block {
                    0 => inner.still(&value),
                    k => inner.turning(k, &value),
                };
                net = vector.map(|vector| {
                    let start = if own { 2 } else { 1 };
                    Net { start, ..family.net(&cosine, &value, &vector) }
                });
                match &net {
                    None if second.block > 0 => Verdict::Open(Reason::Eigenvector),
                    None => Verdict::Fails(Hypothesis::Blocks),
                    Some(net) if second.block == 0 => of_block_0(net, &value, second),
                    Some(net) => of_block(net, &value, second.block, spectrum.order),
                }
            }
            (Some(_), None, Err(hypothesis)) => match diverging(&spectrum) {
                Some(eigenvalue) => Verdict::Refuted(Refutation::Diverges { eigenvalue }),
                None => Verdict::Fails(*hypothesis),
            },
            (None, _, _) if is_butterfly(&ring, spectrum.order) => of_butterfly(&spectrum, &found),
            (_, reason, _) => Verdict::Open(reason.unwrap_or(Reason::RegularPart)),
        };
        let hypothesis = match &found {
            Err(hypothesis) => Some(*hypothesis),
            Ok(second) if second.block == 1 && second.value.sign() > 0 => None,
            Ok(_) => Some(Hypothesis::First),
        };
        let proved = matches!(verdict, Verdict::Proved { .. });
        let exponent = if proved { exponent(&spectrum) } else { None };
        Ok(Vertex {
            family,
            own,
            regular,
            spectrum,
            second: found.ok(),
            hypothesis,
            verdict,
            exponent,
            net,
        })
    }

    /// Whether the surface of generic data is C^m there; `None` where that is not decided. C² fails where it is not C¹,
    /// or the curvature is unbounded; it holds where the rules are regular (`proofs/THEOREMS.md`, 143).
    #[must_use]
    pub fn is_continuous(&self, m: usize) -> Option<bool> {
        let unbounded =
            || self.exponent.as_ref().is_some_and(|found| found.curvature.is_unbounded());
        match (&self.verdict, m) {
            (Verdict::Proved { .. }, 0 | 1) => Some(true),
            (Verdict::Proved { .. }, 2) if self.regular => Some(true),
            (Verdict::Proved { .. }, _) if unbounded() => Some(false),
            (Verdict::Refuted(_), 1..) => Some(false),
            _ => None,
        }
    }

    /// The parts into which the pieces of sector 0 are divided so that J has only positive or only negative
    /// coefficients on each, in the scale of [`Verdict::Proved`]; empty where J has both signs, or there is no ring.
    #[must_use]
    pub fn boxes(&self) -> Vec<RingBox> {
        let (Some(net), Some(second)) = (&self.net, &self.second) else { return Vec::new() };
        let mut boxes = all_boxes(&ring_pieces(net, &Ball::of(&second.value)));
        let unit = unit(net).upper().clone();
        for part in &mut boxes {
            part.least = &part.least / &unit;
        }
        boxes
    }

    /// Lines of constant parameters on sector 0 of the ring; none without a ring in the plane.
    #[must_use]
    pub fn lines(&self) -> Vec<RingLine> {
        match (&self.net, &self.second) {
            (Some(net), Some(second)) => lines(&ring_pieces(net, &Ball::of(&second.value))),
            _ => Vec::new(),
        }
    }

    /// Where a point of sector 0 of the ring is mapped to: p and q.
    #[must_use]
    pub fn image(&self, point: &RingPoint) -> Option<[Rational; 2]> {
        let (net, second) = (self.net.as_ref()?, self.second.as_ref()?);
        mapped(&ring_pieces(net, &Ball::of(&second.value)), point)
    }

    /// Whether the outer curve of a sector is in the half-plane p + q > 0, or p + cq > 0 on a face, or in its opposite.
    #[must_use]
    pub fn in_half_plane(&self) -> bool {
        let (Some(net), Some(second)) = (&self.net, &self.second) else { return false };
        in_half_plane(net, &ring_pieces(net, &Ball::of(&second.value)), &Ball::sign)
    }

    /// A number of few digits above the moduli of all eigenvalues after λ, and below that of λ; `None` without λ, or
    /// where they are too near to each other.
    #[must_use]
    pub fn between(&self) -> Option<Rational> {
        self.second.as_ref()?;
        let size = &self.spectrum.eigenvalues.get(1)?.modulus;
        let next = self.spectrum.eigenvalues.iter().find(|one| one.modulus < *size);
        let high = size.enclosure(2).lower().clone();
        let low =
            next.map_or_else(Rational::zero, |next| next.modulus.enclosure(2).upper().clone());
        let others = self.spectrum.complex.iter().map(|one| one.greatest[1].clone());
        let low = others.fold(low, Rational::max);
        let middle = (&low + &high) / Rational::from(2);
        let rounded = |places: u32| {
            let scale = Rational::from(Integer::one().shifted_left(places));
            Rational::from((&middle * &scale).floor()) / scale
        };
        (3..96).map(rounded).find(|x| low < *x && *x < high)
    }
}

/// The eigenvalue after 1, if it is as a characteristic map needs it; otherwise the hypothesis that fails.
fn second(spectrum: &Spectrum) -> Result<Second, Hypothesis> {
    let (true, [_, second, rest @ ..]) =
        (spectrum.conditions.simple_one, &spectrum.eigenvalues[..])
    else {
        return Err(Hypothesis::SimpleOne);
    };
    if second.real.sign() == 0 && second.imaginary.is_none() {
        return Err(Hypothesis::Blocks);
    }
    if rest.first().is_some_and(|next| next.modulus == second.modulus) {
        return Err(Hypothesis::Alone);
    }
    if second.imaginary.is_some() {
        return Err(Hypothesis::Real);
    }
    let block = match second.blocks[..] {
        [0] => 0,
        [k, other] if k > 0 && k < other && k + other == spectrum.order => k,
        [k, next, ..] if k == next => return Err(Hypothesis::Simple),
        // The same eigenvalue in other blocks.
        [_, _, _, ..] => return Err(Hypothesis::Alone),
        _ => return Err(Hypothesis::Blocks),
    };
    Ok(Second { block, value: second.real.clone() })
}

/// The greatest eigenvalue that is not below 1 in absolute value, other than one simple 1.
fn diverging(spectrum: &Spectrum) -> Option<Eigenvalue> {
    let one = RealExpression::from(Rational::one());
    let only = |found: &Eigenvalue| {
        found.imaginary.is_none() && found.real == one && found.multiplicity == 1
    };
    let beyond = |found: &&Eigenvalue| found.modulus >= one && !only(found);
    spectrum.eigenvalues.iter().find(beyond).cloned()
}

/// What an eigenvector of block k, 0 < k < n/2, shows.
fn of_block(net: &Net<Ball>, value: &Ball, k: usize, n: usize) -> Verdict {
    let pieces = ring_pieces(net, value);
    let (sign, bisections) = match examined(&pieces, &Ball::sign) {
        Ring::Folded { points } => {
            let values = points.each_ref().map(|point| jacobian_at(net, value, point));
            return Verdict::Refuted(Refutation::Folds { points, values });
        }
        Ring::Undecided => return Verdict::Open(Reason::Sign),
        Ring::OneSign { sign, bisections } => (sign, bisections),
    };
    if value.sign() == Some(-1) {
        return Verdict::Refuted(Refutation::Negative);
    }
    let number = if k == 1 && in_half_plane(net, &pieces, &Ball::sign) {
        Some(1)
    } else {
        winding(net, &pieces, k, n)
    };
    if k > 1 || sign == -1 {
        // It is k modulo n, and negative for a negative J.
        return Verdict::Refuted(Refutation::Winds { number });
    }
    match number {
        Some(1) => {
            let (least, near) = least(net, value);
            Verdict::Proved { bisections, least, near }
        }
        Some(_) => Verdict::Refuted(Refutation::Winds { number }),
        None => Verdict::Open(Reason::HalfPlane),
    }
}

/// What is known of the butterfly scheme: it is refuted where the eigenvectors of another block than 1 outweigh the others.
fn of_butterfly(spectrum: &Spectrum, found: &Result<Second, Hypothesis>) -> Verdict {
    let open = Verdict::Open(Reason::RegularPart);
    let (block, value, size) = match (found, still_chain(spectrum)) {
        (Ok(second), _) if second.block >= 2 => (second.block, &second.value, 1),
        (_, Some((value, size))) => (0, value, size),
        _ => return open,
    };
    // The points that are not in the ring have eigenvalues of absolute value 1/16 at most.
    if value.cmp(&RealExpression::from(Rational::new(1, 8))).is_le() {
        return open;
    }
    let Ok(cosine) = RealCyclotomic::cosine(&Rational::new(block, spectrum.order)) else {
        return open;
    };
    let ball = Ball::of(value);
    let net = interpolating::eigenvector(&cosine, &ball);
    match interpolating::is_apart(net, &ball, block == 0) {
        false => open,
        true if block == 0 => Verdict::Refuted(Refutation::Block0 { value: value.clone(), size }),
        true => Verdict::Refuted(Refutation::Winds { number: None }),
    }
}

/// The only eigenvalue of the greatest modulus after 1, if block 0 has one Jordan block for it that is greater than those
/// of all other blocks.
fn still_chain(spectrum: &Spectrum) -> Option<(&RealExpression, usize)> {
    let conditions = &spectrum.conditions;
    let second = spectrum.eigenvalues.get(1).filter(|_| conditions.simple_one)?;
    let alone = spectrum.eigenvalues.get(2).is_none_or(|next| next.modulus != second.modulus);
    if !alone || second.imaginary.is_some() || second.real.sign() <= 0 {
        return None;
    }
    let size = conditions.longest(|k| k == 0, &second.modulus)?;
    let others = conditions.longest(|k| k != 0, &second.modulus)?;
    let own = second.blocks.iter().filter(|k| **k == 0).count();
    let outweighs = others < size || second.blocks.iter().all(|k| *k == 0);
    (own == size && outweighs).then_some((&second.real, size))
}

/// What an eigenvector of block 0 shows.
fn of_block_0(net: &Net<Ball>, value: &Ball, second: &Second) -> Verdict {
    let curve = outer_curve(net, &ring_pieces(net, value));
    if [1, -1].iter().any(|side| curve.iter().all(|x| x.sign() == Some(*side))) {
        return Verdict::Refuted(Refutation::Block0 { value: second.value.clone(), size: 1 });
    }
    Verdict::Fails(Hypothesis::Blocks)
}
