//! The roots of a polynomial over Q(2cos(2π/n)).

use super::extension::Extension;
use super::polynomial::{Polynomial, monic, quotient, rational_part};
use crate::exact::{Rational, Real as _, RealCyclotomic, RealExpression, Scalar};

/// A real root, or a pair of complex roots.
#[derive(Clone, Debug)]
pub(super) struct Root {
    /// The real part.
    pub(super) real: RealExpression,
    /// The positive imaginary part of a pair.
    pub(super) imaginary: Option<RealExpression>,
    pub(super) modulus: RealExpression,
    pub(super) multiplicity: usize,
    /// The field that a real root generates.
    pub(super) extension: Option<Extension>,
}

/// The degree of an irreducible factor, or of one that is not known to be reducible, with complex roots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complex(pub(super) usize);

/// All roots of a monic polynomial of degree 1 or more.
pub(super) fn roots(mut polynomial: Polynomial) -> Result<Vec<Root>, Complex> {
    let mut found = Vec::new();
    let rational = rational_part(&polynomial);
    if rational.degree().is_some_and(|degree| degree > 0) {
        let degree = rational.degree().unwrap_or(0);
        for factor in rational.irreducible_factors().ok_or(Complex(degree))? {
            let factor = monic(&factor);
            let mut multiplicity = 0;
            while let Some(rest) = quotient(&polynomial, &factor) {
                polynomial = rest;
                multiplicity += 1;
            }
            found.extend(simple(&factor, multiplicity)?);
        }
    }
    if polynomial.len() > 1 {
        found.extend(simple(&polynomial, 1)?);
    }
    Ok(found)
}

/// The roots of a polynomial whose roots are simple, unless its degree is 2.
fn simple(polynomial: &Polynomial, multiplicity: usize) -> Result<Vec<Root>, Complex> {
    let degree = polynomial.len() - 1;
    match degree {
        1 => Ok(vec![real(Extension::number(-&polynomial[0]), multiplicity)]),
        2 => Ok(quadratic(polynomial, multiplicity)),
        _ => {
            let root = |index: usize| RealExpression::root(polynomial, index).ok();
            let found: Vec<RealExpression> = (1..=degree).map_while(root).collect();
            if let (3, [root]) = (degree, &found[..]) {
                let [constant, _, square, _] = &polynomial[..] else { return Err(Complex(degree)) };
                let pair = pair(constant, square, root, multiplicity).ok_or(Complex(degree))?;
                let extension = Extension::general(polynomial.clone(), root.clone());
                return Ok(vec![real(extension, multiplicity), pair]);
            }
            if found.len() < degree {
                return Err(Complex(degree));
            }
            let extension = |root| Extension::general(polynomial.clone(), root);
            Ok(found.into_iter().map(|root| real(extension(root), multiplicity)).collect())
        }
    }
}

/// The complex roots of x³ + bx² + … + d with one real root r: their sum is −b − r, and their product is −d/r.
fn pair(
    constant: &RealCyclotomic,
    square: &RealCyclotomic,
    root: &RealExpression,
    multiplicity: usize,
) -> Option<Root> {
    let minus = |x: &RealCyclotomic| RealExpression::from(-x);
    if root.sign() == 0 {
        return None;
    }
    let real = minus(square).minus(root).times(&RealExpression::from(Rational::new(1, 2)));
    let product = minus(constant).over(root);
    let imaginary = product.minus(&real.times(&real)).sqrt().ok()?;
    let modulus = product.sqrt().ok()?;
    Some(Root { real, imaginary: Some(imaginary), modulus, multiplicity, extension: None })
}

fn real(extension: Extension, multiplicity: usize) -> Root {
    let value = extension.root();
    let modulus =
        if value.sign() < 0 { RealExpression::zero().minus(&value) } else { value.clone() };
    Root { real: value, imaginary: None, modulus, multiplicity, extension: Some(extension) }
}

/// The roots h ± √(h² − c) of x² − 2hx + c.
fn quadratic(polynomial: &Polynomial, multiplicity: usize) -> Vec<Root> {
    let constant = &polynomial[0];
    let half = polynomial[1].times(&RealCyclotomic::from(Rational::new(-1, 2)));
    let radicand = half.times(&half).minus(constant);
    if radicand.sign() == 0 {
        return vec![real(Extension::number(half), 2 * multiplicity)];
    }
    if radicand.sign() > 0 {
        let (scale, rest) = RealExpression::root_parts(&radicand);
        let both = [scale.clone(), -&scale];
        let one = |scale: Rational| real(Extension::quadratic(&half, scale, &rest), multiplicity);
        return both.into_iter().map(one).collect();
    }
    let root = |x: RealCyclotomic| RealExpression::from(x).sqrt().expect("a positive number");
    let (imaginary, modulus) = (root(-&radicand), root(constant.clone()));
    let real = RealExpression::from(half);
    vec![Root { real, imaginary: Some(imaginary), modulus, multiplicity, extension: None }]
}
