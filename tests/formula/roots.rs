//! Square roots, and roots of polynomials.

use subcert::exact::{AlgebraicNumber, Rational, RealCyclotomic, Scalar as _};
use subcert::formula::{Parameters, Value, evaluate, parse};

fn value<V: Value>(text: &str) -> Result<V, String> {
    let formula = parse(text).map_err(|error| error.to_string())?;
    evaluate(&formula, &Parameters::default()).map_err(|error| error.to_string())
}

#[test]
fn identities_of_roots() {
    for (left, right) in [
        ("sqrt(3)^2", "3"),
        ("sqrt(2)*sqrt(3)", "sqrt(6)"),
        ("sqrt(3 + 2*sqrt(2))", "1 + sqrt(2)"),
        ("1/(sqrt(3) - sqrt(2))", "sqrt(3) + sqrt(2)"),
        ("sqrt(5 + 2*sqrt(10))^2", "5 + 2*sqrt(10)"),
        ("root([-2, 0, 0, 1], 1)^3", "2"),
        ("root([-1, 1, 1], 2)", "(sqrt(5) - 1)/2"),
        ("root([6, 0, -5, 0, 1], 3)", "sqrt(2)"),
        // The coefficients may be roots themselves.
        ("root([-sqrt(2), 0, 1], 2)^4", "2"),
        ("max(sqrt(2), 7/5)", "sqrt(2)"),
        ("floor(10*sqrt(2))", "14"),
        ("abs(1 - sqrt(2))", "sqrt(2) - 1"),
        ("kronecker(sqrt(8), 2*sqrt(2))", "1"),
        ("sqrt(0)", "0"),
        ("sum(k = 1..4, sqrt(k^2))", "10"),
    ] {
        let difference = value::<AlgebraicNumber>(&format!("{left} - ({right})")).expect(left);
        assert_eq!(difference.sign(), 0, "{left} = {right}");
    }
}

#[test]
fn rational_roots_are_rational() {
    assert_eq!(value::<Rational>("sqrt(9/4)"), Ok(Rational::new(3, 2)));
    assert_eq!(value::<Rational>("root([6, -5, 1], 2)"), Ok(Rational::from(3)));
    // Square roots of rational numbers are sums of cosines.
    assert_eq!(value::<RealCyclotomic>("sqrt(9)"), Ok(RealCyclotomic::from(3)));
    assert_eq!(
        value::<RealCyclotomic>("sqrt(6)*sqrt(10) - 2*sqrt(15)"),
        Ok(RealCyclotomic::from(0))
    );
    let error = value::<RealCyclotomic>("sqrt(1 + sqrt(2))").expect_err("a nested root");
    assert!(error.contains("[[relation]]"), "{error}");
}

#[test]
fn what_formulas_print_they_read() {
    for text in ["root([-3, 0, 1], 2)", "sqrt(3)/4", "root([1 - w, -x^2, sqrt(2)], k + 1)"] {
        assert_eq!(parse(text).expect(text).to_string(), text);
    }
}

#[test]
fn errors_say_what_is_wrong() {
    for (text, message) in [
        ("sqrt(-1)", "the square root of the negative number -1"),
        ("sqrt(1 - sqrt(2))", "the square root of the negative number"),
        ("root([1, 0, 1], 1)", "the polynomial has 0 real roots"),
        (
            "root([-2, 0, 1], 3)",
            "the polynomial has 2 real roots, so that there is no root number 3",
        ),
        ("root([-2, 0, 1], 0)", "no root number 0"),
        ("root([-2, 0, 1], 1/2)", "the number of a root must be an integer, and is 1/2"),
        ("root([0, 0], 1)", "all coefficients of the polynomial are 0"),
        ("root([1], 1)", "the polynomial has 0 real roots"),
        ("root(2, 1)", "expected a list of coefficients"),
        ("root([-2, 0, 1])", "expected `,` and the number of the root"),
        ("root([-2, 0, 1], 1, 2)", "expected `,` or `)`"),
        ("sqrt()", "`sqrt` takes one argument"),
        ("sqrt(2)^1000", "at most 64"),
        (
            "root([-2, 0, 0, 0, 0, 1], 1) + root([-3, 0, 0, 0, 0, 1], 1)",
            "a field of degree above 24",
        ),
    ] {
        let error = value::<AlgebraicNumber>(text).expect_err(text);
        assert!(error.contains(message), "{text}: {error}");
    }
    // A long list is a polynomial of a high degree.
    let long = format!("root([{}1], 1)", "-1, ".repeat(80));
    let error = value::<AlgebraicNumber>(&long).expect_err("degree 80");
    assert!(error.contains("the degree can be at most 64"), "{error}");
    for text in ["sqrt(3)", "1 + root([-2, 0, 0, 1], 1)"] {
        let error = value::<Rational>(text).expect_err(text);
        assert!(
            error.contains("is not rational, as the numbers have to be here; `subcert scheme`"),
            "{error}"
        );
    }
}

#[test]
fn coordinates_are_those_of_the_field() {
    let number = value::<AlgebraicNumber>("(1 + sqrt(3))/4").expect("a number");
    assert_eq!(number.to_string(), "1/4 + 1/4*t");
    assert_eq!(AlgebraicNumber::from_rational(&Rational::new(1, 2)).to_string(), "1/2");
}
