//! The number type.

use super::error::{CosineError, MAX_CONDUCTOR, angle};
use super::field::Field;
use crate::exact::{Integer, Rational};
use crate::stop::check;
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// A real number of some field Q(2cos(2π/n)): a rational number, or a sum of
/// rational multiples of cosines of rational multiples of π.
///
/// Arithmetic and comparison are exact, as for real numbers. A rational number is always
/// stored as a [`Rational`]. An irrational number is stored as integers a_k over one
/// denominator q: it is (a_0 + Σ_{1≤k<m} a_k·2cos(2πk/n))/q with m = φ(n)/2. This is a
/// polynomial in 2cos(2π/n) modulo the minimal polynomial, written in a basis that keeps
/// the coefficients small.
///
/// An operation on numbers of conductors m and n is done in the field of conductor
/// lcm(m, n). It panics when lcm(m, n) is beyond [`MAX_CONDUCTOR`]; see
/// [`common_conductor`](super::common_conductor).
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic, Scalar, format::fixed};
///
/// // 4cos²36° − 2cos36° = 1, and 2cos36° is the golden ratio.
/// let golden = RealCyclotomic::cosine(&Rational::new(1, 10))?.times(&RealCyclotomic::from(2));
/// assert_eq!(golden.times(&golden).minus(&golden), RealCyclotomic::from(1));
/// assert_eq!(fixed(&golden, 10), "1.6180339887");
/// assert_eq!(golden.minimal_polynomial().to_string(), "x^2 - x - 1");
/// assert!(golden > RealCyclotomic::from(Rational::new(1618, 1000)));
/// # Ok::<(), subcert::exact::CosineError>(())
/// ```
#[derive(Clone)]
pub struct RealCyclotomic(pub(super) Form);

#[derive(Clone)]
pub(super) enum Form {
    Rational(Rational),
    Irrational(Element),
}

/// Σ_k a_k C_k / q in a field, in lowest terms with q > 0; some a_k ≠ 0 with k > 0.
#[derive(Clone)]
pub(super) struct Element {
    pub(super) field: Arc<Field>,
    pub(super) numerators: Vec<Integer>,
    pub(super) denominator: Integer,
}

/// How a number is stored: its conductor, its numerators and its denominator. Equal forms are equal
/// numbers; a number of several fields has a form in each.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct StoredForm(usize, Vec<Integer>, Integer);

impl<T: Into<Rational>> From<T> for RealCyclotomic {
    fn from(value: T) -> RealCyclotomic {
        RealCyclotomic(Form::Rational(value.into()))
    }
}

/// Clones, so that `impl Into` accepts references.
impl From<&RealCyclotomic> for RealCyclotomic {
    fn from(value: &RealCyclotomic) -> RealCyclotomic {
        value.clone()
    }
}

impl RealCyclotomic {
    /// cos(2π·`turn`), for any rational number of turns.
    ///
    /// # Errors
    /// When the denominator of `turn` (halved, if it is 2 mod 4) is beyond
    /// [`MAX_CONDUCTOR`].
    ///
    /// # Panics
    /// Never.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealCyclotomic};
    ///
    /// let cosine = |p, q| RealCyclotomic::cosine(&Rational::new(p, q));
    /// assert_eq!(cosine(7, 6)?, RealCyclotomic::from(Rational::new(1, 2)));
    /// assert_eq!(cosine(1, 7)?, cosine(-8, 7)?);
    /// assert_eq!(cosine(1, 10)?.conductor(), 5);
    /// assert!(cosine(1, 1_000_003).is_err());
    /// # Ok::<(), subcert::exact::CosineError>(())
    /// ```
    pub fn cosine(turn: &Rational) -> Result<RealCyclotomic, CosineError> {
        let (k, n) = (turn.numerator(), turn.denominator());
        // For odd h, cos(2πk/2h) = −cos(2π((k+h)/2)/h).
        let (k, n, sign) = if n.residue(4) == 2 {
            let half = n.shifted_right(1);
            ((k + &half).shifted_right(1), half, -1)
        } else {
            (k, n, 1)
        };
        if n > Integer::from(MAX_CONDUCTOR) {
            return Err(CosineError::Conductor { conductor: n.to_string() });
        }
        let n = u32::try_from(n.to_i64().expect("below the cap")).expect("positive");
        let rational = |p: i64, q: i64| Ok(RealCyclotomic::from(Rational::new(p * sign, q)));
        match n {
            1 => rational(1, 1),
            3 => rational(-1, 2),
            4 => rational(0, 1),
            _ => {
                let field = Field::of(n as usize);
                let mut sum = field.room();
                sum[field.fold(k.residue(n) as usize)] = Integer::from(sign);
                let numerators = field.reduce(sum);
                Ok(RealCyclotomic::normal(field, numerators, Integer::from(2)))
            }
        }
    }

    /// How this number is stored, as a key of tables.
    #[must_use]
    pub fn stored(&self) -> StoredForm {
        match &self.0 {
            Form::Rational(value) => StoredForm(1, vec![value.numerator()], value.denominator()),
            Form::Irrational(element) => {
                let conductor = element.field.conductor();
                StoredForm(conductor, element.numerators.clone(), element.denominator.clone())
            }
        }
    }

    /// The number with these numerators over `denominator` > 0, brought to lowest terms.
    pub(super) fn normal(
        field: Arc<Field>,
        mut numerators: Vec<Integer>,
        mut denominator: Integer,
    ) -> RealCyclotomic {
        check();
        if numerators[1..].iter().all(Integer::is_zero) {
            return RealCyclotomic::from(Rational::new(numerators.swap_remove(0), denominator));
        }
        let mut gcd = denominator.clone();
        for numerator in numerators.iter().filter(|numerator| !numerator.is_zero()) {
            if gcd == Integer::one() {
                break;
            }
            gcd = gcd.gcd(numerator);
        }
        if gcd != Integer::one() {
            denominator = denominator.div_floor(&gcd);
            for numerator in &mut numerators {
                *numerator = numerator.div_floor(&gcd);
            }
        }
        RealCyclotomic(Form::Irrational(Element { field, numerators, denominator }))
    }

    /// This, if it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.0 {
            Form::Rational(value) => Some(value),
            Form::Irrational(_) => None,
        }
    }

    /// The conductor n of the field Q(2cos(2π/n)) in which this number is stored; never 2
    /// mod 4, and 1 for a rational number. The number may also lie in a smaller field.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn conductor(&self) -> u32 {
        match &self.0 {
            Form::Rational(_) => 1,
            Form::Irrational(element) => {
                u32::try_from(element.field.conductor()).expect("at most MAX_CONDUCTOR")
            }
        }
    }

    /// The number of coefficients that are not 0: a measure of the cost of a product.
    #[must_use]
    pub fn term_count(&self) -> usize {
        match &self.0 {
            Form::Rational(_) => 1,
            Form::Irrational(element) => element.terms().count(),
        }
    }

    /// The number of binary digits of the m coefficients and of their denominator
    /// together, where each coefficient counts at least 4: a measure of the cost of a
    /// sum.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Form::Rational(value) => value.bits(),
            Form::Irrational(element) => {
                let numerators = element.numerators.iter().map(|a| a.bits().max(4));
                numerators.sum::<u64>() + element.denominator.bits()
            }
        }
    }

    /// The estimated time of one product, in units of 10 ns, when a row is multiplied
    /// `levels` times by a matrix of such numbers: t²(1 + levels·b/16), where t is the number
    /// of terms and b the number of bits of the longest term and the denominator together.
    pub(crate) fn row_product_size(&self, levels: u32) -> u64 {
        let (terms, bits) = match &self.0 {
            Form::Rational(value) => (1, value.bits()),
            Form::Irrational(element) => {
                let terms = element.field.sparse(&element.numerators);
                let bits = terms.iter().map(|(_, a)| a.bits()).max().unwrap_or(0);
                (terms.len() as u64, bits + element.denominator.bits())
            }
        };
        (terms * terms).saturating_mul(bits.saturating_mul(levels.into()) / 16 + 1)
    }

    /// The image under the automorphism that takes 2cos(2πk/n) to
    /// 2cos(2πk·`multiplier`/n), for n the [conductor](Self::conductor).
    ///
    /// # Panics
    /// When `multiplier` is not prime to the conductor.
    #[must_use]
    pub fn conjugate(&self, multiplier: u32) -> RealCyclotomic {
        let Form::Irrational(element) = &self.0 else { return self.clone() };
        let conductor = self.conductor();
        assert_eq!(
            num_integer::gcd(multiplier, conductor),
            1,
            "a conjugate needs a multiplier prime to {conductor}"
        );
        let numerators = element.field.conjugate(&element.numerators, multiplier as usize);
        RealCyclotomic(Form::Irrational(Element { numerators, ..element.clone() }))
    }
}

impl Element {
    /// The pairs (k, a_k) with a_k ≠ 0.
    pub(super) fn terms(&self) -> impl Iterator<Item = (usize, &Integer)> {
        self.numerators.iter().enumerate().filter(|(_, numerator)| !numerator.is_zero())
    }

    /// The numerators in the basis of `field`, whose conductor is a multiple ns of this
    /// element's conductor n: 2cos(2πk/n) = 2cos(2πks/(ns)).
    pub(super) fn lifted(&self, field: &Field) -> Cow<'_, [Integer]> {
        if field.conductor() == self.field.conductor() {
            return Cow::Borrowed(&self.numerators);
        }
        let scale = field.conductor() / self.field.conductor();
        let mut sum = field.room();
        for (k, numerator) in self.terms() {
            sum[field.fold(k * scale)] = numerator.clone();
        }
        Cow::Owned(field.reduce(sum))
    }
}

impl fmt::Display for RealCyclotomic {
    /// A formula: `3/4 + 1/2*cos(2*pi/5) - cos(4*pi/5)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let element = match &self.0 {
            Form::Rational(value) => return value.fmt(f),
            Form::Irrational(element) => element,
        };
        let mut text = String::new();
        for (k, numerator) in element.terms() {
            text.push_str(match (text.is_empty(), numerator.sign() < 0) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            });
            let factor = if k == 0 { 1 } else { 2 };
            let coefficient =
                Rational::new(numerator.abs() * Integer::from(factor), element.denominator.clone());
            if k == 0 || coefficient != Rational::one() {
                text.push_str(&coefficient.to_string());
            }
            if k > 0 {
                let times = if coefficient == Rational::one() { "" } else { "*" };
                let turn = Rational::new(k, element.field.conductor());
                text.extend([times, "cos(", &angle(&turn), ")"]);
            }
        }
        f.pad(&text)
    }
}

impl fmt::Debug for RealCyclotomic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
