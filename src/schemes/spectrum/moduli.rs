//! How large complex roots are that are not computed.

use super::polynomial::Polynomial;
use crate::exact::{Enclosed as _, Enclosure, Integer, Rational, RealExpression, square_free};

/// Complex eigenvalues that are not computed: conjugate pairs, of which it is known how large they are.
#[derive(Clone, Debug, PartialEq)]
pub struct ComplexEigenvalues {
    /// The Fourier blocks that have them, in ascending order, each as often as it has one. With multiplicities there are as many
    /// as these.
    pub blocks: Vec<usize>,
    /// The greatest of their absolute values is at least the first number, and at most the second.
    pub greatest: [Rational; 2],
}

/// The complex roots of a polynomial.
#[derive(Clone, Debug)]
pub(super) struct Pairs {
    /// How many there are.
    pub(super) count: usize,
    pub(super) greatest: [Rational; 2],
}

/// The level of the enclosures of coefficients: 512 binary digits.
const LEVEL: u32 = 3;

/// How many significant binary digits are kept.
const DIGITS: u64 = 512;

/// How often the roots are squared.
const STEPS: u32 = 12;

/// The complex roots of a monic polynomial, whose real roots are these; `None` where it has multiple roots, or no bound is found.
///
/// The real roots are divided off, with enclosures of all coefficients. Graeffe's step, q(x²) = ± p(x)p(−x), squares the
/// roots. After k steps, Σ c_i x^i of degree m has the roots z^(2^k), and
///
/// max_i (|c_{m−i}|/2^m)^(1/i) ≤ max |z|^(2^k) ≤ 2 max_i |c_{m−i}|^(1/i):
///
/// the left side, since c_{m−i} is a sum of at most 2^m products of i roots, and the right side is the bound of Fujiwara.
pub(super) fn pairs(polynomial: &Polynomial, real: &[RealExpression]) -> Option<Pairs> {
    if square_free(polynomial).len() != polynomial.len() {
        return None;
    }
    let mut c: Vec<Enclosure> = polynomial.iter().map(|x| x.enclosure(LEVEL)).collect();
    for root in real {
        c = divided_off(&c, &root.enclosure(LEVEL));
    }
    let count = c.len() - 1;
    for _ in 0..STEPS {
        c = squared(&c);
    }
    let [mut low, mut high] = [None, None];
    let bits = |x: &Integer| i64::try_from(x.bits()).ok();
    let size = i64::try_from(count).ok()?;
    for (i, x) in (1..).zip(c.iter().rev().skip(1)) {
        // |p/q| is below 2^(b + 1), and above 2^(b − 1), for the difference b of the numbers of digits.
        let digits = |x: &Rational| Some(bits(&x.numerator())? - bits(&x.denominator())?);
        let [a, b] = [x.lower(), x.upper()].map(|x| if x.sign() < 0 { -x } else { x.clone() });
        let (least, most) = if a < b { (a, b) } else { (b, a) };
        if !most.is_zero() {
            high = high.max(Some((digits(&most)? + 1).div_euclid(i) + 2));
        }
        if x.sign().is_some_and(|sign| sign != 0) {
            low = low.max(Some((digits(&least)? - 1 - size).div_euclid(i)));
        }
    }
    Some(Pairs { count, greatest: [root_of_power(low?, false)?, root_of_power(high?, true)?] })
}

/// The quotient by x − r.
fn divided_off(c: &[Enclosure], r: &Enclosure) -> Vec<Enclosure> {
    let mut quotient: Vec<Enclosure> = Vec::with_capacity(c.len());
    for x in c[1..].iter().rev() {
        let next = quotient.last().map_or_else(|| x.clone(), |last| x + &(r * last));
        quotient.push(rounded(&next));
    }
    quotient.reverse();
    quotient
}

/// The monic polynomial of the squares of the roots.
fn squared(c: &[Enclosure]) -> Vec<Enclosure> {
    let degree = c.len() - 1;
    let coefficient = |j: usize| {
        let first = (2 * j).saturating_sub(degree);
        let terms = (first..=degree.min(2 * j)).map(|i| {
            let product = &c[i] * &c[2 * j - i];
            if (i + degree).is_multiple_of(2) { product } else { -&product }
        });
        let zero = Enclosure::exact(Rational::zero());
        rounded(&terms.fold(zero, |sum, term| &sum + &term))
    };
    (0..=degree).map(coefficient).collect()
}

/// The interval with ends of few digits, rounded outwards.
fn rounded(x: &Enclosure) -> Enclosure {
    Enclosure::new(shortened(x.lower(), false), shortened(x.upper(), true))
}

/// A number of few significant digits, not below this or not above it.
fn shortened(x: &Rational, up: bool) -> Rational {
    let (p, q) = (x.numerator().bits(), x.denominator().bits());
    if x.is_zero() || p.max(q) <= DIGITS {
        return x.clone();
    }
    let round = |x: &Rational| Rational::from(if up { x.ceil() } else { x.floor() });
    let power = |places: u64| {
        Rational::from(Integer::one().shifted_left(u32::try_from(places).unwrap_or(u32::MAX)))
    };
    let places = (q + DIGITS).saturating_sub(p);
    if q + DIGITS >= p {
        round(&(x * &power(places))) / power(places)
    } else {
        let scale = power(p - q - DIGITS);
        round(&(x / &scale)) * scale
    }
}

/// A decimal of six places that is at least 2^(exponent/2^k), or at most that, for k = [`STEPS`], and near to it.
fn root_of_power(exponent: i64, up: bool) -> Option<Rational> {
    // Only a proposal: what is taken is squared k times.
    #[expect(clippy::cast_precision_loss, reason = "a proposal")]
    let near = (exponent as f64 / f64::from(1_u32 << STEPS)).exp2();
    let unit = Rational::power_of_ten(-6);
    let near = crate::float::exact(near)? / unit.clone();
    let wanted = power_of_two(exponent)?;
    (-1..4).find_map(|step| {
        let steps = Rational::from(if up { step } else { -step });
        let candidate = (Rational::from(near.floor()) + steps) * unit.clone();
        let mut power = candidate.clone();
        for _ in 0..STEPS {
            power = shortened(&(&power * &power), !up);
        }
        let right = if up { power >= wanted } else { power <= wanted };
        (right && candidate.sign() >= 0).then_some(candidate)
    })
}

fn power_of_two(exponent: i64) -> Option<Rational> {
    let places = u32::try_from(exponent.unsigned_abs()).ok()?;
    let power = Integer::one().shifted_left(places);
    Some(if exponent < 0 { Rational::new(Integer::one(), power) } else { Rational::from(power) })
}
