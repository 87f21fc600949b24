//! Square roots, and roots of polynomials.

use super::error::{MAX_ROOT_DEGREE, RootError};
use super::isolated::{Isolated, RootKind};
use super::node::{Field, Generator, Operation, RealExpression};
use super::size::Size;
use crate::exact::polynomials::dense::trimmed;
use crate::exact::real::square::square_part;
use crate::exact::{Integer, Rational, Real, RealCyclotomic, Scalar, format::short};
use std::sync::Arc;

impl RealExpression {
    /// √self.
    ///
    /// # Errors
    /// When this is negative.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealExpression};
    ///
    /// let root = RealExpression::from(Rational::new(12, 25)).sqrt()?;
    /// assert_eq!(root.to_string(), "2/5*sqrt(3)");
    /// assert!(RealExpression::from(Rational::from(-2)).sqrt().is_err());
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    pub fn sqrt(&self) -> Result<RealExpression, RootError> {
        match self.sign() {
            0 => return Ok(RealExpression::from(Rational::zero())),
            1 => {}
            _ => {
                let (value, decimal) = (self.to_string(), short(self, 6));
                return Err(RootError::Negative { value, decimal });
            }
        }
        let Some(value) = self.as_number() else { return Ok(self.root_of_positive()) };
        let (factor, rest) = RealExpression::root_parts(value);
        if rest == RealCyclotomic::from(1) {
            return Ok(RealExpression::from(factor));
        }
        let root = RealExpression::from(rest).root_of_positive();
        Ok(RealExpression::from(factor).times(&root))
    }

    /// A rational s and y with √x = s√y, for x > 0: √(c·z) = s√(t·z) for the content c = s²t of x = c·z.
    /// y = 1 for the square of a rational.
    #[must_use]
    pub fn root_parts(value: &RealCyclotomic) -> (Rational, RealCyclotomic) {
        let content = value.content();
        let (s, t) = square_part(&content);
        let rest = value.over(&content.into()).times(&RealCyclotomic::from(Rational::from(t)));
        (s, rest)
    }

    /// √self as a new number.
    fn root_of_positive(&self) -> RealExpression {
        let mut field = self.0.field.clone();
        let generator = Arc::new(Generator::Square(self.clone()));
        field.adjoin(&generator);
        RealExpression::node(Operation::Root(generator), self.0.size.square_root(), field)
    }

    /// The real root number `index` of Σ c_k x^k, for coefficients c_0, c_1, … The distinct real roots
    /// are numbered in ascending order, from 1.
    ///
    /// # Errors
    /// When the polynomial is a constant, its degree is above [`MAX_ROOT_DEGREE`], or it has no such root.
    ///
    /// # Panics
    /// When the coefficients have no [`common_conductor`](crate::exact::common_conductor).
    ///
    /// ```
    /// use subcert::exact::{RealCyclotomic, RealExpression, format::fixed};
    ///
    /// // x³ − 3x + 1 has the roots 2cos 160°, 2cos 80° and 2cos 40°.
    /// let polynomial = [1, -3, 0, 1].map(RealCyclotomic::from);
    /// let root = RealExpression::root(&polynomial, 2)?;
    /// assert_eq!(fixed(&root, 8), "0.34729636");
    /// assert_eq!(root.to_string(), "root([1, -3, 0, 1], 2)");
    /// assert!(RealExpression::root(&polynomial, 4).is_err());
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    pub fn root(
        coefficients: &[RealCyclotomic],
        index: usize,
    ) -> Result<RealExpression, RootError> {
        let given = trimmed(coefficients.to_vec());
        let degree = given.len().saturating_sub(1);
        if degree == 0 {
            return Err(RootError::Constant);
        }
        if degree > MAX_ROOT_DEGREE {
            return Err(RootError::Degree(degree));
        }
        if degree == 1 && index == 1 {
            return Ok(RealExpression::from(-&given[0].over(&given[1])));
        }
        let root = match Isolated::find(given, index) {
            RootKind::Missing(count) => return Err(RootError::Index { index, count }),
            RootKind::Rational(value) => return Ok(RealExpression::from(value)),
            RootKind::Irrational(root) => root,
        };
        let bounds = integral_bounds(&root.given);
        let conductor = root.given.iter().fold(1, |n, c| num_integer::lcm(n, c.conductor()));
        let mut field = Field::cyclotomic(u64::from(conductor));
        let generator = Arc::new(Generator::Isolated(root));
        field.adjoin(&generator);
        Ok(RealExpression::node(Operation::Root(generator), Size::root(&bounds), field))
    }
}

impl RealExpression {
    /// The distinct real roots of Σ c_k x^k in ascending order; none of a constant.
    ///
    /// # Errors
    /// When the degree is above [`MAX_ROOT_DEGREE`].
    ///
    /// # Panics
    /// When the coefficients have no [`common_conductor`](crate::exact::common_conductor).
    ///
    /// ```
    /// use subcert::exact::{Rational, RealCyclotomic, RealExpression};
    ///
    /// let of = |all: &[i64]| all.iter().copied().map(RealCyclotomic::from).collect::<Vec<_>>();
    /// let found = RealExpression::roots(&of(&[2, -3, 1]))?;
    /// assert_eq!(found, [1, 2].map(|n| RealExpression::from(Rational::from(n))));
    /// // No answer is not the answer that there are no roots.
    /// assert!(RealExpression::roots(&of(&[1; 18])).is_err());
    /// # Ok::<(), subcert::exact::RootError>(())
    /// ```
    pub fn roots(coefficients: &[RealCyclotomic]) -> Result<Vec<RealExpression>, RootError> {
        let mut found = Vec::new();
        loop {
            match RealExpression::root(coefficients, found.len() + 1) {
                Ok(root) => found.push(root),
                Err(RootError::Constant | RootError::Index { .. }) => return Ok(found),
                Err(error) => return Err(error),
            }
        }
    }
}

/// Bounds of the conjugates of q c_0, …, q c_d, for a common denominator q.
fn integral_bounds(coefficients: &[RealCyclotomic]) -> Vec<Integer> {
    let bounds: Vec<(Integer, Integer)> =
        coefficients.iter().map(RealCyclotomic::conjugate_bound).collect();
    let common = bounds.iter().fold(Integer::one(), |common, (_, q)| common.lcm(q));
    bounds.iter().map(|(bound, q)| bound * common.div_floor(q)).collect()
}
