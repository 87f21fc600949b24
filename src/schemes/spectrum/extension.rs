//! The field that a real root generates over Q(2cos(2π/n)).

use super::polynomial::Polynomial;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar, divided, only_solution};

/// K(λ) for a real root λ of a monic polynomial f of degree e over K = Q(2cos(2π/n)). Its elements are
/// Σ_{t<e} a_t λ^t with a_t in K.
#[derive(Clone, Debug)]
pub(super) struct Extension {
    polynomial: Polynomial,
    form: Form,
}

/// How λ is written.
#[derive(Clone, Debug)]
enum Form {
    Number(RealCyclotomic),
    /// half + scale·√radicand.
    Quadratic {
        half: RealCyclotomic,
        scale: Rational,
        surd: RealExpression,
    },
    General(RealExpression),
}

impl Extension {
    /// K itself, with λ in K.
    pub(super) fn number(value: RealCyclotomic) -> Extension {
        let polynomial = vec![-&value, RealCyclotomic::from(1)];
        Extension { polynomial, form: Form::Number(value) }
    }

    /// λ = half + scale·√radicand; λ is in K for radicand 1.
    pub(super) fn quadratic(
        half: &RealCyclotomic,
        scale: Rational,
        radicand: &RealCyclotomic,
    ) -> Extension {
        let one = RealCyclotomic::from(1);
        let shift = RealCyclotomic::from(scale.clone());
        if *radicand == one {
            return Extension::number(half.plus(&shift));
        }
        let constant = half.times(half).minus(&shift.times(&shift).times(radicand));
        let polynomial = vec![constant, -&half.plus(half), one];
        let surd = RealExpression::from(radicand.clone()).sqrt().expect("a positive radicand");
        Extension { polynomial, form: Form::Quadratic { half: half.clone(), scale, surd } }
    }

    /// Any root of a polynomial.
    pub(super) fn general(polynomial: Polynomial, root: RealExpression) -> Extension {
        Extension { polynomial, form: Form::General(root) }
    }

    /// The monic polynomial f.
    pub(super) fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// e.
    pub(super) fn degree(&self) -> usize {
        self.polynomial.len() - 1
    }

    /// λ.
    pub(super) fn root(&self) -> RealExpression {
        match &self.form {
            Form::Number(value) => RealExpression::from(value.clone()),
            Form::Quadratic { .. } => {
                self.express(&[RealCyclotomic::zero(), RealCyclotomic::from(1)])
            }
            Form::General(root) => root.clone(),
        }
    }

    /// The element with these coefficients a_t, as an expression.
    pub(super) fn express(&self, element: &[RealCyclotomic]) -> RealExpression {
        let number = |value: &RealCyclotomic| RealExpression::from(value.clone());
        match &self.form {
            Form::Number(_) => number(&element[0]),
            Form::Quadratic { half, scale, surd } => {
                let plain = element[0].plus(&element[1].times(half));
                let factor = element[1].times(&RealCyclotomic::from(scale.clone()));
                number(&plain).plus(&number(&factor).times(surd))
            }
            Form::General(root) => {
                let terms = element.iter().rev();
                terms.fold(RealExpression::zero(), |sum, c| sum.times(root).plus(&number(c)))
            }
        }
    }

    /// Σ_i a_i λ^i for any number of coefficients, brought to e of them.
    pub(super) fn reduced(&self, coefficients: &[RealCyclotomic]) -> Vec<RealCyclotomic> {
        let mut rest = divided(coefficients, &self.polynomial).1;
        rest.resize(self.degree(), RealCyclotomic::zero());
        rest
    }

    /// The product of two elements.
    pub(super) fn product(
        &self,
        a: &[RealCyclotomic],
        b: &[RealCyclotomic],
    ) -> Vec<RealCyclotomic> {
        let mut product = vec![RealCyclotomic::zero(); a.len() + b.len() - 1];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                product[i + j].accumulate(&x.times(y));
            }
        }
        self.reduced(&product)
    }

    /// An element with the product 1 with this one; `None` where f is reducible and there is none, or
    /// this is 0.
    pub(super) fn inverse(&self, element: &[RealCyclotomic]) -> Option<Vec<RealCyclotomic>> {
        let degree = self.degree();
        // Column t holds the coefficients of element·λ^t.
        let columns: Vec<Vec<RealCyclotomic>> = (0..degree)
            .map(|t| {
                let shifted = vec![RealCyclotomic::zero(); t];
                self.reduced(&[&shifted[..], element].concat())
            })
            .collect();
        let row = |i: usize| {
            let unit = RealCyclotomic::from(i64::from(i == 0));
            columns.iter().map(|column| column[i].clone()).chain([unit]).collect()
        };
        only_solution((0..degree).map(row).collect())
    }
}
