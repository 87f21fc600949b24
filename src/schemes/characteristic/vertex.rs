//! One valence: C¹ proved, refuted, or open.

use super::ball::Ball;
use super::exponent::{Exponent, exponent};
use super::family::Family;
use super::net::{Lattice, Net};
use super::ring::{Ring, RingPoint, examined, jacobian, outer_curve, ring_pieces};
use super::rules::{Reason, Rules, rules};
use crate::exact::{Enclosure, Rational, RealCyclotomic, RealExpression, Scalar as _};
use crate::spectrum::{Eigenvalue, Spectrum, SpectrumError};

/// Whether the limit surface is C¹ at the vertex or on the face, in Reif's sense: for generic data, with the
/// regular part's smoothness elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// C¹.
    Proved {
        /// The most bisections of a piece.
        bisections: usize,
        /// A lower bound of J where the point (1, 0) of the net has the length 1.
        least: Rational,
        /// A point next to which J is about that small.
        near: RingPoint,
    },
    /// Not C¹.
    Refuted(Refutation),
    /// A hypothesis fails, and nothing is refuted.
    Fails(Hypothesis),
    /// Not decided.
    Open(Reason),
}

/// Why a surface is not C¹.
#[derive(Clone, Debug, PartialEq)]
pub enum Refutation {
    /// The Jacobian has both signs, at these points.
    Folds {
        /// The points, the positive one first.
        points: [RingPoint; 2],
        /// J there, where the point (1, 0) of the net has the length 1.
        values: [Enclosure; 2],
    },
    /// A simple eigenvalue of block 0 is alone above all but 1, and its eigenfunction has one sign.
    Block0 {
        /// The eigenvalue.
        value: RealExpression,
    },
}

/// A hypothesis of the theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hypothesis {
    /// 1 is simple, and all others are below it in absolute value.
    SimpleOne,
    /// The eigenvalues next to 1 are alone of their modulus.
    Alone,
    /// λ is real.
    Real,
    /// λ is positive.
    Positive,
    /// λ is of block 1 and of block n − 1, once each.
    Blocks,
    /// λ is above the eigenvalue 1/4 of the points around it.
    AboveOuter,
}

/// What is known of the surface at the vertex or on the face.
#[derive(Clone, Debug)]
pub struct Vertex {
    /// The regular part; `None` where none is known.
    pub family: Option<Family>,
    /// The spectrum, of the wider ring where the regular part is known.
    pub spectrum: Spectrum,
    /// Whether the surface is C¹.
    pub verdict: Verdict,
    /// How smooth its first derivatives are, where it is C¹.
    pub exponent: Option<Exponent>,
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
        let Rules { family, reason, rings } = rules(scheme, valence)?;
        let spectrum = rings.spectrum()?;
        let verdict = match (family, reason) {
            (Some(family), None) => judged(family, &spectrum),
            (_, reason) => Verdict::Open(reason.unwrap_or(Reason::RegularPart)),
        };
        let proved = matches!(verdict, Verdict::Proved { .. });
        let exponent = if proved { exponent(&spectrum) } else { None };
        Ok(Vertex { family, spectrum, verdict, exponent })
    }
}

fn judged(family: Family, spectrum: &Spectrum) -> Verdict {
    let Some(value) = &spectrum.conditions.subdominant else {
        return out_of_order(family, spectrum);
    };
    let value = Ball::of(value);
    if value.minus(&Ball::from_rational(&Rational::new(1, 4))).sign() != Some(1)
        && family != Family::BoxSpline
    {
        return Verdict::Fails(Hypothesis::AboveOuter);
    }
    let turn = Rational::new(1, spectrum.order);
    let cosine = RealCyclotomic::cosine(&turn).expect("no more points than a ring may have");
    let cosine = Ball::of(&cosine);
    match examined(family, &cosine, &value, &Ball::sign) {
        Ring::Regular { bisections } => {
            let net = family.eigenvector(&cosine, &value);
            let (least, near) = least(&net, &value);
            Verdict::Proved { bisections, least, near }
        }
        Ring::Folded { points } => {
            let net = family.eigenvector(&cosine, &value);
            let values = points.each_ref().map(|point| jacobian_at(&net, &value, point));
            Verdict::Refuted(Refutation::Folds { points, values })
        }
        Ring::Undecided => Verdict::Open(Reason::Sign),
        Ring::NoHalfPlane => Verdict::Open(Reason::HalfPlane),
    }
}

/// The square of the length of the first point.
fn unit(net: &Net<Ball>) -> Enclosure {
    let first = if net.lattice == Lattice::Dual { (0, 0) } else { (1, 0) };
    let length = &net.points[&first][0];
    length.times(length).enclosure().clone()
}

/// A lower bound of J, and the corner of a part with the least coefficient.
fn least(net: &Net<Ball>, value: &Ball) -> (Rational, RingPoint) {
    let mut best: Option<(Rational, RingPoint)> = None;
    for piece in ring_pieces(net, value) {
        let form = jacobian(&piece);
        let (d, e) = form.degrees;
        for (i, row) in form.rows.iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                let low = x.enclosure().lower();
                if best.as_ref().is_none_or(|(least, _)| low < least) {
                    let side = i64::from(piece.direction);
                    let along = |corner: i32, i: usize, d: usize| {
                        Rational::from(i64::from(corner))
                            + Rational::from(side) * Rational::new(i, d)
                    };
                    let at = [along(piece.corner.0, i, d), along(piece.corner.1, j, e)];
                    best = Some((low.clone(), RingPoint { at }));
                }
            }
        }
    }
    let (least, near) = best.expect("three pieces");
    (least / unit(net).upper().clone(), near)
}

/// J at a point of the ring.
fn jacobian_at(net: &Net<Ball>, value: &Ball, point: &RingPoint) -> Enclosure {
    let ball = |x: &Rational| Ball::from_rational(x);
    let one = ball(&Rational::one());
    for piece in ring_pieces(net, value) {
        let side = Rational::from(i64::from(piece.direction));
        let along = |corner: i32, x: &Rational| (x - &Rational::from(i64::from(corner))) * &side;
        let [u, v] = [along(piece.corner.0, &point.at[0]), along(piece.corner.1, &point.at[1])];
        let form = jacobian(&piece);
        let inside = |x: &Rational| x.sign() >= 0 && *x <= Rational::one();
        if !inside(&u) || !inside(&v) || (form.triangle && &u + &v > Rational::one()) {
            continue;
        }
        let w = if form.triangle { Rational::one() - &u - &v } else { Rational::zero() };
        let found = form.value(&[&ball(&u), &ball(&v), &ball(&w), &one]);
        let unit = unit(net);
        let over = |x: &Rational, by: &Rational| x / by;
        let ends = [found.enclosure().lower(), found.enclosure().upper()];
        let quotients = ends.map(|x| [over(x, unit.lower()), over(x, unit.upper())]).concat();
        let low = quotients.iter().min().expect("four numbers").clone();
        let high = quotients.iter().max().expect("four numbers").clone();
        return Enclosure::new(low, high);
    }
    unreachable!("a point of the ring")
}

/// What follows from eigenvalues that are not in the right order.
fn out_of_order(family: Family, spectrum: &Spectrum) -> Verdict {
    let [_, second, rest @ ..] = &spectrum.eigenvalues[..] else {
        return Verdict::Fails(Hypothesis::SimpleOne);
    };
    if !spectrum.conditions.simple_one {
        return Verdict::Fails(Hypothesis::SimpleOne);
    }
    if rest.first().is_some_and(|next| next.modulus == second.modulus) {
        return Verdict::Fails(Hypothesis::Alone);
    }
    if second.imaginary.is_some() {
        return Verdict::Fails(Hypothesis::Real);
    }
    if second.blocks == [0] && one_sign(family, second) {
        return Verdict::Refuted(Refutation::Block0 { value: second.real.clone() });
    }
    if second.real.sign() < 0 {
        return Verdict::Fails(Hypothesis::Positive);
    }
    Verdict::Fails(Hypothesis::Blocks)
}

/// Whether the eigenfunction of a simple eigenvalue of block 0 has one sign on the outer curve of the ring.
fn one_sign(family: Family, eigenvalue: &Eigenvalue) -> bool {
    let value = Ball::of(&eigenvalue.real);
    let Some(net) = family.still_eigenvector(&value) else { return false };
    let curve = outer_curve(&net, &ring_pieces(&net, &value));
    [1, -1].iter().any(|side| curve.iter().all(|x| x.sign() == Some(*side)))
}
