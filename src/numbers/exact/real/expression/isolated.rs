//! A real root of a polynomial with cyclotomic coefficients.

use super::rounded::{outward, power_of_half};
use crate::exact::polynomials::dense::{derivative, divided, value_at};
use crate::exact::polynomials::sturm::changes;
use crate::exact::{Enclosed, Enclosure, Integer, Rational, Real, RealCyclotomic};

/// A polynomial Σ c_k x^k with numbers c_k of one field, from the constant term upwards, without leading
/// zeros.
pub(super) type Coefficients = Vec<RealCyclotomic>;

/// An interval as narrow as 2^−`BISECTED` is made by bisection.
const BISECTED: u32 = 128;

/// The binary digits of Newton's method beyond those of its result.
const GUARD: u64 = 32;

/// The root number `index` of a polynomial, which is the only root of a square-free polynomial in
/// (lower, upper).
#[derive(Clone, Debug)]
pub(super) struct Isolated {
    /// The polynomial as given, without leading zeros.
    pub(super) given: Coefficients,
    /// The place of the root among the distinct real roots in ascending order, from 1.
    pub(super) index: usize,
    square_free: Coefficients,
    lower: Rational,
    upper: Rational,
    /// The sign of the polynomial at `lower`.
    sign: i8,
}

/// What is found at a place among the roots.
pub(super) enum RootKind {
    Rational(Rational),
    Irrational(Isolated),
    /// There are only this many real roots.
    Missing(usize),
}

impl Isolated {
    /// The root number `index`, counted from 1, of a polynomial of degree at least 1.
    pub(super) fn find(given: Coefficients, index: usize) -> RootKind {
        let sturm = Sturm::new(&given);
        let bound = cauchy(&sturm.members[0]);
        let (mut lower, mut upper) = (-&bound, bound);
        let count = sturm.count(&lower, &upper);
        if !(1..=count).contains(&index) {
            return RootKind::Missing(count);
        }
        // Of the roots in (lower, upper], the wanted one is the one number `place`.
        let (mut place, mut count) = (index, count);
        let square_free = &sturm.members[0];
        loop {
            if count == 1 {
                if sign_at(square_free, &upper) == 0 {
                    return RootKind::Rational(upper);
                }
                let sign = sign_at(square_free, &lower);
                if sign != 0 {
                    let square_free = square_free.clone();
                    return RootKind::Irrational(Isolated {
                        given,
                        index,
                        square_free,
                        lower,
                        upper,
                        sign,
                    });
                }
            }
            let middle = (&lower + &upper) / Rational::from(2);
            let below = sturm.count(&lower, &middle);
            if place <= below {
                (upper, count) = (middle, below);
            } else {
                (lower, place, count) = (middle, place - below, count - below);
            }
        }
    }

    /// An interval no wider than 2^−`places`: by bisection, and where it is narrow, by Newton's method.
    pub(super) fn enclosure(&self, places: u32) -> Enclosure {
        let mut near = Enclosure::new(self.lower.clone(), self.upper.clone());
        let width = power_of_half(u64::from(places));
        let narrow = power_of_half(u64::from(places.min(BISECTED)));
        while near.width() > width {
            let newton = (near.width() <= narrow).then(|| self.newton(&near)).flatten();
            near = match newton {
                Some(next) => next,
                None => match self.halved(&near) {
                    exact if exact.width().is_zero() => return exact,
                    half => half,
                },
            };
        }
        near
    }

    fn halved(&self, near: &Enclosure) -> Enclosure {
        let (lower, upper) = (near.lower().clone(), near.upper().clone());
        let middle = (&lower + &upper) / Rational::from(2);
        match sign_at(&self.square_free, &middle) {
            0 => Enclosure::exact(middle),
            sign if sign == self.sign => Enclosure::new(middle, upper),
            _ => Enclosure::new(lower, middle),
        }
    }

    /// The part of an interval X with this root that is in m − f(m)/f′(X), where m is the middle of X: by the mean value
    /// theorem, the root is there. `None` where it is more than half of X.
    fn newton(&self, near: &Enclosure) -> Option<Enclosure> {
        let width = near.width();
        let bits = (width.denominator().bits() - width.numerator().bits() + 1) * 2 + GUARD;
        let places = u32::try_from(bits).ok()?;
        let level = (places / 64).next_power_of_two().ilog2() + 1;
        let value = |polynomial: &Coefficients, at: &Enclosure| {
            polynomial.iter().rev().fold(Enclosure::exact(Rational::zero()), |value, c| {
                outward(&(&(&value * at) + &c.enclosure(level)), places)
            })
        };
        let middle = Enclosure::exact(near.middle());
        let slope = value(&derivative(&self.square_free), near);
        slope.sign().filter(|sign| *sign != 0)?;
        let inverse = Enclosure::new(slope.upper().recip(), slope.lower().recip());
        let next = &middle - &(&value(&self.square_free, &middle) * &inverse);
        let next = outward(&next, places);
        let lower = next.lower().max(near.lower()).clone();
        let next = Enclosure::new(lower, next.upper().min(near.upper()).clone());
        (next.width() * Rational::from(2) <= width).then_some(next)
    }
}

/// A Sturm sequence; see [`SturmSequence`](crate::exact::SturmSequence).
struct Sturm {
    members: Vec<Coefficients>,
}

impl Sturm {
    /// That of the square-free part of a polynomial: every member of the sequence of f is a multiple of
    /// its last one, the greatest common divisor of f and f′.
    fn new(polynomial: &Coefficients) -> Sturm {
        let mut members = vec![polynomial.clone(), derivative(polynomial)];
        while let [.., a, b] = &members[..]
            && let (_, rest) = divided(a, b)
            && !rest.is_empty()
        {
            members.push(rest.iter().map(|c| -c).collect());
        }
        let last = members.last().expect("two members at least").clone();
        if last.len() > 1 {
            members = members.iter().map(|member| divided(member, &last).0).collect();
        }
        Sturm { members }
    }

    /// The number of roots in (lower, upper].
    fn count(&self, lower: &Rational, upper: &Rational) -> usize {
        self.changes(lower) - self.changes(upper)
    }

    /// The number of sign changes just to the right of a point.
    fn changes(&self, at: &Rational) -> usize {
        changes(self.members.iter().map(|member| sign_at(member, at)))
    }
}

/// The sign of the value at a rational number.
fn sign_at(polynomial: &Coefficients, at: &Rational) -> i8 {
    value_at(polynomial, &RealCyclotomic::from(at.clone())).sign()
}

/// A power of two above all roots in absolute value: Cauchy's bound 1 + max |c_k/c_d|.
fn cauchy(polynomial: &Coefficients) -> Rational {
    let (leading, lower) = polynomial.split_last().expect("a polynomial other than 0");
    let size = |c: &RealCyclotomic| c.over(leading).magnitude().enclosure(0).upper().clone();
    let largest = lower.iter().map(size).max().unwrap_or_else(Rational::zero);
    let bits = u32::try_from(largest.ceil().bits()).expect("a number that fits in memory");
    Rational::from(Integer::one().shifted_left(bits + 1))
}
