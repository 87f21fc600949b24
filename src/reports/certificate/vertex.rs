//! Surfaces at a vertex or on a face: the eigenvalue, and the signs of the Jacobian.

use super::block::Block;
use crate::audit::{RangeAtValence, SmoothnessVerdict, Vertices, Word};
use crate::characteristic::{Refutation, Second, Verdict, Vertex};
use crate::claim::SmoothRangeStatement;
use crate::exact::{Enclosed as _, Integer, Rational, RealExpression};
use crate::spectrum::Eigenvalue;

/// The binary places of the ends of an eigenvalue.
const PLACES: u32 = 96;

/// The decimal places of bounds of coefficients.
const DIGITS: u32 = 15;

/// The lines about the valences of a claim, with the orders that it states.
pub(super) fn lines(
    block: &mut Block,
    found: &Vertices,
    orders: [Option<usize>; 2],
    verdict: SmoothnessVerdict,
) {
    if found.all.is_some() {
        block.line("proved-by THEOREMS 135");
        block.line(Word::Confirmed);
        return;
    }
    let [continuous, not_continuous] = orders;
    let refutes = |vertex: &Vertex| {
        continuous.is_some_and(|m| vertex.is_continuous(m) == Some(false))
            || not_continuous.is_some_and(|m| vertex.is_continuous(m) == Some(true))
    };
    let refuted = verdict == SmoothnessVerdict::Refuted;
    let shown: Vec<&Vertex> = if refuted {
        found.vertices.iter().find(|vertex| refutes(vertex)).into_iter().collect()
    } else {
        found.vertices.iter().collect()
    };
    for vertex in shown {
        let smooth = matches!(vertex.verdict, Verdict::Proved { .. });
        if let (true, true, Some(2), None, Some(family)) =
            (smooth, vertex.regular, continuous, not_continuous, vertex.family)
        {
            block.line(format!("vertex {}", vertex.spectrum.order));
            block.line(format!("part {}", family.name()));
            block.line("regular");
            continue;
        }
        let beyond = |m: &Option<usize>| m.is_some_and(|m| m > 1);
        if smooth && (beyond(&continuous) || beyond(&not_continuous)) {
            block.give_up("what follows from the curvature is not certified");
        }
        block.line(format!("vertex {}", vertex.spectrum.order));
        if let Err(why) = of_vertex(block, vertex) {
            block.give_up(why);
        }
    }
    block.line(if refuted { Word::Refuted } else { Word::Confirmed });
}

/// The lines about a range that a value refutes.
pub(super) fn range_lines(
    block: &mut Block,
    said: &SmoothRangeStatement,
    scheme: &str,
    found: &[RangeAtValence],
    verdict: SmoothnessVerdict,
) {
    block.line(format!("variable {}", said.variable));
    block.restate("scheme", scheme);
    block.line(format!("smoothness {}", said.m));
    if let Some(valences) = &said.valences {
        block.restate("valences", &valences.text);
    }
    let witness = found.iter().find_map(|one| one.witness.as_ref());
    match (verdict, witness) {
        (SmoothnessVerdict::Refuted, Some(witness)) => {
            block.line(format!("at {}", witness.at));
            block.line(format!("vertex {}", witness.vertex.spectrum.order));
            if let Err(why) = of_vertex(block, &witness.vertex) {
                block.give_up(why);
            }
            block.line(Word::Refuted);
        }
        (SmoothnessVerdict::Refuted, None) => {
            block.give_up("there is no rational value that refutes it");
        }
        _ => block.give_up("that surfaces are C^1 for all values of a range is not certified"),
    }
}

/// The lines about one valence.
fn of_vertex(block: &mut Block, vertex: &Vertex) -> Result<(), &'static str> {
    if let (Some(family), Verdict::Refuted(Refutation::Diverges { .. })) =
        (vertex.family, &vertex.verdict)
    {
        let (k, sign) = beyond(vertex).ok_or(
            "eigenvalues of absolute value 1, and an even number of them beyond 1 or −1 in a block, are not certified",
        )?;
        block.line(format!("part {}", family.name()));
        block.line(format!("diverges {k} {sign}"));
        return Ok(());
    }
    let (Some(family), Some(second)) = (vertex.family, &vertex.second) else {
        return Err("nothing is known of the ring");
    };
    let below = vertex.between().ok_or("the eigenvalues are too near to each other")?;
    let [low, high] = ends(second);
    block.line(format!("part {}", family.name()));
    block.line(format!("eigenvalue {} {low} {high}", second.block));
    block.line(format!("below {below}"));
    match &vertex.verdict {
        Verdict::Refuted(Refutation::Block0 { .. }) => block.line("outer"),
        Verdict::Refuted(Refutation::Folds { points, .. }) => {
            for (word, point) in ["positive", "negative"].iter().zip(points) {
                block.line(format!("{word} {} {}", point.at[0], point.at[1]));
            }
        }
        verdict => {
            let boxes = vertex.boxes();
            let Some(first) = boxes.first() else { return Err("the Jacobian has no sign") };
            let positive = first.positive;
            let curve = matches!(verdict, Verdict::Proved { .. }) && !vertex.in_half_plane()
                || matches!(verdict, Verdict::Refuted(Refutation::Winds { .. }))
                    && positive
                    && second.block == 1;
            if curve {
                return Err(
                    "winding numbers are not certified where no half-plane has the outer curve",
                );
            }
            block.line(if positive { "jacobian +" } else { "jacobian -" });
            let unit = Rational::from(Integer::power_of_ten(DIGITS));
            for part in boxes {
                // A unit less, for the enclosures of the checker.
                let least = Rational::from((&part.least * &unit).floor()) - Rational::one();
                if least.sign() <= 0 {
                    return Err("the coefficients are too small");
                }
                let path = if part.path.is_empty() { "-" } else { &part.path };
                block.line(format!("box {} {path} {}", part.piece, least / &unit));
            }
        }
    }
    Ok(())
}

/// A block with an odd number of real eigenvalues above 1, or below −1, and none there: its characteristic polynomial shows
/// it by its sign.
fn beyond(vertex: &Vertex) -> Option<(usize, char)> {
    let one = RealExpression::from(Rational::one());
    let real = || vertex.spectrum.eigenvalues.iter().filter(|found| found.imaginary.is_none());
    let count = |k: usize, hit: &dyn Fn(&Eigenvalue) -> bool| -> usize {
        let times = |found: &Eigenvalue| found.blocks.iter().filter(|block| **block == k).count();
        real().filter(|found| hit(found)).map(times).sum()
    };
    for k in 0..=vertex.spectrum.order / 2 {
        for (sign, side) in [('+', 1), ('-', -1)] {
            let apart = count(k, &|found| found.modulus > one && found.real.sign() == side);
            let at = count(k, &|found| found.modulus == one && found.real.sign() == side);
            let trivial = usize::from(k == 0 && side == 1);
            if apart % 2 == 1 && at == trivial {
                return Some((k, sign));
            }
        }
    }
    None
}

/// Numbers below and above the eigenvalue.
fn ends(second: &Second) -> [Rational; 2] {
    let enclosure = second.value.enclosure(2);
    let scale = Rational::from(Integer::one().shifted_left(PLACES));
    let low = (enclosure.lower() * &scale).floor();
    let high = (enclosure.upper() * &scale).ceil();
    let one = Rational::one();
    [(Rational::from(low) - &one) / &scale, (Rational::from(high) + &one) / &scale]
}
