//! Square roots, enclosed as narrowly as one likes.

use crate::exact::{Enclosed, Enclosure, Integer, Rational, RealCyclotomic, floor_root};

/// The level at which an enclosure is narrow enough for any f64: 2^−2048 wide.
const NARROW: u32 = 5;

/// √(a + b√d), for numbers a, b and d > 0 with 0 < a + b√d ≤ 1.
pub(super) struct Root {
    /// a.
    pub(super) plain: RealCyclotomic,
    /// b.
    pub(super) rooted: RealCyclotomic,
    /// d.
    pub(super) radicand: RealCyclotomic,
}

impl Enclosed for Root {
    /// If b = 0, a rational root is computed exactly. Any other root might be too near to half-way
    /// between two f64; then the lower end of level 5 decides.
    fn enclosure(&self, level: u32) -> Enclosure {
        let plain = self.rooted.sign() == 0;
        if let Some(root) = self.plain.as_rational().filter(|_| plain).and_then(rational_root) {
            return Enclosure::exact(root);
        }
        // √ of an interval of width w is at most √w wide.
        let mut inner = self.plain.enclosure(level + 1);
        if !plain {
            let root = root_of(&self.radicand.enclosure(level + 2), level + 1);
            inner = &inner + &(&self.rooted.enclosure(level + 1) * &root);
        }
        let outer = root_of(&inner, level);
        if level < NARROW { outer } else { Enclosure::exact(outer.lower().clone()) }
    }
}

/// √x for all x ≥ 0 of an interval, with 64·2^`level` binary digits.
fn root_of(x: &Enclosure, level: u32) -> Enclosure {
    let places = 64_u32 << level.min(NARROW + 2);
    let lower = floor_root(&scaled(x.lower(), 2 * places).floor());
    let upper = floor_root(&scaled(x.upper(), 2 * places).ceil()) + Integer::one();
    let unit = Integer::one().shifted_left(places);
    Enclosure::new(Rational::new(lower, unit.clone()), Rational::new(upper, unit))
}

/// x·2^`places`, or 0 for x < 0.
fn scaled(x: &Rational, places: u32) -> Rational {
    if x.sign() < 0 {
        Rational::zero()
    } else {
        x * Rational::from(Integer::one().shifted_left(places))
    }
}

/// √x, if it is rational.
fn rational_root(x: &Rational) -> Option<Rational> {
    let (p, q) = (floor_root(&x.numerator()), floor_root(&x.denominator()));
    let root = Rational::new(p, q);
    (&root * &root == *x).then_some(root)
}
