//! The roots of a polynomial over Q(2cos(2π/n)).

use super::extension::Extension;
use super::moduli::{Pairs, pairs};
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

/// The roots of a monic polynomial of degree 1 or more: those that are computed, and how large the others are, for each factor that
/// has others.
pub(super) fn roots(mut polynomial: Polynomial) -> Result<(Vec<Root>, Vec<Pairs>), Complex> {
    let (mut found, mut others) = (Vec::new(), Vec::new());
    let mut add = |(roots, pairs): (Vec<Root>, Option<Pairs>)| {
        found.extend(roots);
        others.extend(pairs);
    };
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
            add(simple(&factor, multiplicity)?);
        }
    }
    if polynomial.len() > 1 {
        add(simple(&polynomial, 1)?);
    }
    Ok((found, others))
}

/// The roots of a polynomial whose roots are simple, unless its degree is 2.
fn simple(
    polynomial: &Polynomial,
    multiplicity: usize,
) -> Result<(Vec<Root>, Option<Pairs>), Complex> {
    let degree = polynomial.len() - 1;
    let all = match degree {
        1 => vec![real(Extension::number(-&polynomial[0]), multiplicity)],
        2 => quadratic(polynomial, multiplicity),
        _ => {
            let found = RealExpression::roots(polynomial).map_err(|_| Complex(degree))?;
            if let (3, [root]) = (degree, &found[..]) {
                let [constant, _, square, _] = &polynomial[..] else { return Err(Complex(degree)) };
                let pair = pair(constant, square, root, multiplicity).ok_or(Complex(degree))?;
                let extension = Extension::general(polynomial.clone(), root.clone());
                return Ok((vec![real(extension, multiplicity), pair], None));
            }
            let pairs = if found.len() < degree {
                let mut pairs = pairs(polynomial, &found).ok_or(Complex(degree))?;
                pairs.count *= multiplicity;
                Some(pairs)
            } else {
                None
            };
            let extension = |root| Extension::general(polynomial.clone(), root);
            let real = found.into_iter().map(|root| real(extension(root), multiplicity));
            return Ok((real.collect(), pairs));
        }
    };
    Ok((all, None))
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
