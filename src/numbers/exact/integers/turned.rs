//! Numbers a + bω with ω = e^{iφ}.

use crate::exact::{IntegerFunction, Rational, Scalar};

/// a + bω for ω = e^{iφ}, where a, b and 2cos φ are functions of an integer.
#[derive(Clone, Debug, PartialEq)]
pub struct Turned {
    parts: [IntegerFunction; 2],
    /// 2cos φ; `None` where b = 0.
    double: Option<IntegerFunction>,
}

impl From<IntegerFunction> for Turned {
    fn from(real: IntegerFunction) -> Turned {
        Turned { parts: [real, IntegerFunction::zero()], double: None }
    }
}

impl Turned {
    /// ω^d, for the angle with this 2cos φ.
    #[must_use]
    pub fn power(double: &IntegerFunction, d: i64) -> Turned {
        let parts = match d {
            0.. => [0.into(), 1.into()],
            _ => [double.clone(), (-1).into()],
        };
        let unit = Turned { parts, double: Some(double.clone()) };
        (0..d.abs()).fold(Turned::from(IntegerFunction::from(1)), |power, _| power.times(&unit))
    }

    /// This if it is real, as far as that is known.
    #[must_use]
    pub fn real(&self) -> Option<&IntegerFunction> {
        let [real, turning] = &self.parts;
        turning.sign()?.is_eq().then_some(real)
    }

    /// The real part a + b·cos φ.
    #[must_use]
    pub fn real_part(&self) -> IntegerFunction {
        let [real, turning] = &self.parts;
        let half = IntegerFunction::from_rational(&Rational::new(1, 2));
        match &self.double {
            Some(double) => real.plus(&turning.times(double).times(&half)),
            None => real.clone(),
        }
    }
}

impl Scalar for Turned {
    fn from_rational(value: &Rational) -> Turned {
        Turned::from(IntegerFunction::from_rational(value))
    }

    fn plus(&self, other: &Turned) -> Turned {
        let double = self.double.as_ref().or(other.double.as_ref()).cloned();
        let ([a, b], [c, d]) = (&self.parts, &other.parts);
        Turned { parts: [a.plus(c), b.plus(d)], double }
    }

    fn minus(&self, other: &Turned) -> Turned {
        self.plus(&other.times(&Turned::from_rational(&Rational::from(-1))))
    }

    /// With ω² = 2cos φ·ω − 1.
    fn times(&self, other: &Turned) -> Turned {
        let double = self.double.as_ref().or(other.double.as_ref()).cloned();
        let ([a, b], [c, d]) = (&self.parts, &other.parts);
        let square = b.times(d);
        let mut turning = a.times(d).plus(&b.times(c));
        if let Some(double) = &double {
            turning.accumulate(&square.times(double));
        }
        Turned { parts: [a.times(c).minus(&square), turning], double }
    }
}
