//! Masks that are given by their symbols.

use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::scheme::{
    Mask, find_definition, open_parameters, parse_algebraic, parse_parametric, parse_scheme,
    read_scheme,
};
use subcert::smoothness::Symbol;

fn mask(text: &str) -> Mask {
    parse_scheme(text).unwrap_or_else(|error| panic!("{text}: {error}")).masks()[0].clone()
}

/// The coefficients by the powers of z, by the definition: new point ni + α from old point i + o + j.
fn coefficients(mask: &Mask) -> BTreeMap<i64, Rational> {
    let small = |number: usize| i64::try_from(number).expect("small");
    let mut found = BTreeMap::new();
    for (alpha, row) in mask.rules().rows().iter().enumerate() {
        for (j, c) in row.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            let power = small(alpha) - small(mask.arity()) * (mask.offset() + small(j));
            found.insert(power, c.clone());
        }
    }
    found
}

fn convolved(left: &[i64], right: &[i64]) -> Vec<i64> {
    let mut product = vec![0; left.len() + right.len() - 1];
    for (i, a) in left.iter().enumerate() {
        for (j, b) in right.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// `(1 - 2*z + 3*z^2)`.
fn written(factor: &[i64]) -> String {
    let terms: Vec<String> =
        factor.iter().enumerate().map(|(power, c)| format!("{c}*z^{power}")).collect();
    format!("({})", terms.join(" + "))
}

proptest! {
    /// A product of polynomials has the coefficients of their convolution, at their powers of z; a factor may also be given as
    /// a quotient.
    #[test]
    fn products_are_convolutions(
        arity in 2_usize..5,
        factors in prop::collection::vec(prop::collection::vec(-4_i64..5, 1..4), 1..4),
        divisor in prop::collection::vec(-4_i64..5, 2..4),
        shift in -9_i64..10,
    ) {
        let sum = |factor: &Vec<i64>| factor.iter().sum::<i64>();
        // The factor 1 + z + … + z^(n−1) gives all rules the same sum.
        let ones = vec![1; arity];
        let total: i64 = factors.iter().map(sum).product();
        prop_assume!(total != 0 && divisor.iter().any(|c| *c != 0));
        let expected = factors.iter().fold(ones.clone(), |product, factor| convolved(&product, factor));
        let texts: Vec<String> = factors.iter().map(|factor| written(factor)).collect();
        let powers = format!("(1 - z^{arity})/(1 - z)");
        let [d, text] = [written(&divisor), format!("z^{shift}*{}/({total})*{powers}", texts.join("*"))];
        for text in [text.clone(), format!("{d}*{text}/{d}"), format!("{text}*{d}^2/{d}/{d}")] {
            let found = mask(&text);
            prop_assert_eq!(found.arity(), arity, "{}", &text);
            let found = coefficients(&found);
            let at = |place: usize| shift + i64::try_from(place).expect("small");
            let expected: BTreeMap<i64, Rational> = expected
                .iter()
                .enumerate()
                .filter(|(_, c)| **c != 0)
                .map(|(place, c)| (at(place), Rational::new(*c, total)))
                .collect();
            prop_assert_eq!(found, expected, "{}", text);
        }
    }
}

/// Masks as books print them: by their symbols, and as lists.
#[test]
fn schemes_of_the_literature() {
    // Deslauriers and Dubuc 1989: the four-point scheme, with its centre at 0.
    let four = mask("(-1)*z^-3*(1+z)^4*(1-4*z+z^2)/16");
    let printed = [-1, 0, 9, 16, 9, 0, -1].map(|c| Rational::new(c, 16));
    for (power, c) in (-3..=3).zip(printed) {
        let zero = Rational::zero();
        assert_eq!(coefficients(&four).get(&power).unwrap_or(&zero), &c, "z^{power}");
    }
    assert_eq!(four, mask("four-point:w=1/16"));
    assert_eq!(Symbol::of(&four).powers(), (-3, 3));
    // Dyn, Levin and Gregory 1987: the same with the tension w.
    let tension = "(1+z)^2/z/2*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)";
    assert_eq!(
        parse_parametric(tension, "w").expect("a mask"),
        parse_parametric("four-point", "w").expect("a mask")
    );
    assert_eq!(open_parameters(tension).expect("a mask"), ["w"]);
    assert_eq!(mask(&format!("{tension}:w=1/16")), four);
    // B-splines of degree 3, binary and ternary, and the product of both.
    assert_eq!(mask("z^-2*(1+z)^4/8"), mask("[1, 4, 6, 4, 1]/8"));
    assert_eq!(mask("((1+z+z^2)/z)^4/27"), mask("[1, 4, 10, 16, 19, 16, 10, 4, 1]/27"));
    let product = parse_scheme("(1+z)^4/(8·z^2) x (1−z^3)^2/(1−z)^2/3").expect("a product");
    assert_eq!(product.masks().iter().map(|mask| mask.arity()).collect::<Vec<_>>(), [2, 3]);
    // A sum over an index, and a power that is a parameter.
    let spline = "2*z^(-2)*sum(k = 0..d, binomial(d, k)*z^k)/2^d:d=4";
    assert_eq!(mask(spline), mask("[1, 4, 6, 4, 1]/8"));
    // Daubechies 1988, with two vanishing moments.
    assert_eq!(
        parse_algebraic("z^-1*(1 + z)^2*(1 + √3 + (1 - √3)*z)/4").expect("a mask"),
        parse_algebraic("[1 + √3, 3 + √3, 3 - √3, 1 - √3]/4").expect("a mask")
    );
    // Coefficients of several square roots, whose field has degree 4.
    let two = parse_algebraic("(1 + z)*(1 + √2*z + z^2)/(2 + √2)*(1 + √3*z)/(1 + √3)");
    assert_eq!(two.expect("a mask").arity(), 2);
    // A scheme that reproduces cosines.
    let cosines = find_definition("z^-1*(1 + z)*(1 + 2*cos(2*pi/5)*z + z^2)/(2 + 2*cos(2*pi/5))");
    let none = BTreeMap::<String, RealCyclotomic>::new();
    let rules = cosines.expect("a scheme").mask(&none).expect("a mask");
    assert_eq!((rules.offset(), rules.rules().rows()[0].len()), (-1, 3));
}

#[test]
fn what_is_no_symbol_of_a_mask_is_refused() {
    for (text, reason) in [
        ("(1+z)^4/16", "add up to 1; write 2*(1+z)^4/16 for the arity 2"),
        ("1 + 2*z + z^2", "write 1/2*(1 + 2*z + z^2) for the arity 2"),
        ("(1+z)^2/√8*(1+z)", "write sqrt(1/2)*(1+z)^2/√8*(1+z) for the arity 2"),
        ("(1+z)*(1+w*z)", "add up to 2 + 2*w"),
        ("1/2 + z + z^3/2", "rule 0 sums to 1/2"),
        ("(1+z)^1000000000", "at most 64"),
        ("((z^64)^64)^64", "the power of z is too large; at most 16384"),
        ("((1+z)^64)^64", "the number of bits is too large"),
        ("(1+z)*(1+(z^32)^30)/2", "rules of 481 coefficients; there must be from 1 to 256"),
        ("(1-z^4)/(1-2*z)", "leaves a remainder"),
        ("(1+z)/(1+z)^2*4", "leaves a remainder"),
        ("(1+z)/(z-z)", "division by zero"),
        ("(1+z)^4/(w+w*z)*w", "has to be a number that is not 0"),
        ("2z + 1", "expected an operator; a product is written with `*`"),
        ("(1+z)(1+z)/2", "expected an operator; a product is written with `*`"),
        ("0*z", "this symbol is 0"),
        ("abs(1+z)", "no value"),
        ("√(z + z)", "has the variable z"),
        ("2^z", "must be an integer"),
        ("cos(z*pi)", "rational multiple"),
        ("sum(z = 0..1, z^2)*z", "no index"),
        ("(1+z)^3/4:z=1", "no parameter `z`"),
        ("(1+z)^3/4:w=1", "no parameter `w`"),
        ("(1+z^", "expected a number"),
    ] {
        let found = match text {
            open if open.contains("w*") => parse_parametric(open, "w").map(|_| ()),
            irrational if irrational.contains('√') => parse_algebraic(irrational).map(|_| ()),
            rational => parse_scheme(rational).map(|_| ()),
        };
        let error = found.expect_err(text).to_string();
        assert!(error.contains(reason), "{text}: {error}");
    }
}

/// A file has a symbol under its own key, with parameters, names for its factors, and an arity.
#[test]
fn symbols_in_files() {
    let read = |text: &str| read_scheme(&SourceText::new("mine.toml", text));
    let of = |text: &str| {
        let definition = read(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        definition.mask(&BTreeMap::<String, Rational>::new()).map_err(|error| error.to_string())
    };
    let tension = "name = 'mine'\nparameters.w = { default = '1/16' }\narity = '2'\n\
        symbol = 's^2*2/z*(1 - 2*w*rest/z^2)'\n[let]\ns = '(1 + z)/2'\nrest = '(1 - z)^2*(1 + z^2)'\n";
    assert_eq!(of(tension), Ok(mask("four-point:w=1/16")));
    assert!(!read(tension).expect("a scheme").leaves_offset_out());
    // The arity of a family is a formula.
    let family = "name = 'family'\nparameters.n = { default = '3' }\narity = 'n'\n\
        symbol = 'sum(j = 0..n-1, z^j)^2/n/z^(n-1)'\n";
    assert_eq!(of(family), Ok(mask("[1, 2, 3, 2, 1]/3")));
    for (old, new, part) in [
        ("arity = '2'", "offset = '-1'", "a symbol has its offset"),
        ("arity = '2'", "arity = '3'", "sums to"),
        ("arity = '2'", "arity = '1'", "the arity is 1"),
        ("arity = '2'", "mask = '[1, 1]'", "needs either"),
        ("arity = '2'", "width = '2'", "needs either"),
        ("parameters.w", "parameters.z", "the variable of the symbol"),
        ("[let]", "[let]\nz = '1'", "the variable of the symbol"),
        ("s^2*2/z", "s^2/z", "write 2*s^2/z"),
        ("s^2*2/z", "t^2*2/z", "unknown name `t`"),
        ("s^2*2/z", "s^2*2/z/rest", "leaves a remainder"),
        ("'(1 + z)/2'", "'1/(1 + z)'", "leaves a remainder"),
        ("symbol = 's^2*2/z*(1 - 2*w*rest/z^2)'", "mask = '(1 + z)^3/4'", "needs either"),
        (
            "arity = '2'\nsymbol = 's^2*2/z*(1 - 2*w*rest/z^2)'",
            "mask = '(1 + z)^3/4'",
            "not a list",
        ),
    ] {
        let text = tension.replace(old, new);
        assert_ne!(text, tension, "{old}");
        let error = read(&text).map_err(|error| error.to_string()).and_then(|_| of(&text));
        let error = error.expect_err(&text);
        assert!(error.contains(part), "{new}: {error}");
    }
}

/// What is no scheme here is called by its name.
#[test]
fn other_kinds_of_schemes_are_recognised() {
    for (fields, part) in [
        ("symbol = '(1+z1)*(1+z2)*(1+z1*z2)/2'", "is written in x, y and z"),
        ("symbol = '[[1,z],[0,1]]'", "Hermite and vector schemes"),
        ("mask = [[['1/2', '-1/8'], ['1', '0']], [['1', '0'], ['0', '1']]]", "Hermite schemes"),
    ] {
        let text = format!("name = 's'\n{fields}\n");
        let error = read_scheme(&SourceText::new("s.toml", text)).expect_err(fields);
        assert!(error.to_string().contains(part), "{fields}: {error}");
    }
    // A name that has a value is no variable.
    let text = "name = 's'\nsymbol = '(1+z)*(x + z)/(1 + x)'\nlet.x = '1/2'\n";
    read_scheme(&SourceText::new("s.toml", text.to_owned())).expect("one variable");
}
