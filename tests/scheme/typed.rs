//! Masks that are typed in place of a name.

use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::scheme::{Mask, open_parameters, parse_algebraic, parse_parametric, parse_scheme};

fn mask(text: &str) -> Mask {
    parse_scheme(text).expect("a mask").masks()[0].clone()
}

/// What becomes of the point 1 among zeros: x'_m by m, from the rules.
fn refined(mask: &Mask) -> impl Iterator<Item = (i64, Rational)> {
    let (arity, offset) = (i64::try_from(mask.arity()).expect("small"), mask.offset());
    let rows = mask.rules().rows().to_vec();
    let each = move |(alpha, row): (usize, Vec<Rational>)| {
        let place = move |j: usize| -(i64::try_from(j).expect("small") + offset) * arity;
        let alpha = i64::try_from(alpha).expect("small");
        row.into_iter().enumerate().map(move |(j, c)| (place(j) + alpha, c))
    };
    rows.into_iter().enumerate().flat_map(each)
}

proptest! {
    /// x'_m = a_{m + h} where the point 1 is x_0.
    #[test]
    fn coefficients_stand_where_the_definition_has_them(
        arity in 2_usize..6,
        mut coefficients in prop::collection::vec(-9_i64..10, 6..20),
    ) {
        // The last of each residue makes the sum 7.
        for alpha in 0..arity {
            let of = |k: &usize| k % arity == alpha;
            let last = (0..coefficients.len()).rfind(of).expect("one");
            let others: i64 = (0..last).filter(of).map(|k| coefficients[k]).sum();
            coefficients[last] = 7 - others;
        }
        let mask = mask(&format!("{coefficients:?}/7"));
        prop_assert_eq!(mask.arity(), arity);
        let half = i64::try_from((coefficients.len() - 1) / 2).expect("small");
        let mut met = 0;
        for (m, value) in refined(&mask) {
            let place = usize::try_from(m + half).ok();
            let expected = place.and_then(|k| coefficients.get(k));
            met += usize::from(expected.is_some());
            prop_assert_eq!(value, Rational::new(expected.copied().unwrap_or(0), 7), "m = {}", m);
        }
        prop_assert_eq!(met, coefficients.len());
    }
}

#[test]
fn names_are_parameters() {
    let typed = "[-w, 0, 1/2 + w, 1, 1/2 + w, 0, -w]";
    assert_eq!(mask(&format!("{typed}:w=1/16")), mask("four-point:w=1/16"));
    assert_eq!(parse_parametric(typed, "w").unwrap(), parse_parametric("four-point", "w").unwrap());
    assert_eq!(open_parameters(typed).unwrap(), ["w"]);
    let product = parse_scheme("[1, 2, 1]/2 x [1, 2, 3, 2, 1]/3").expect("a product");
    assert_eq!(product.masks().iter().map(|mask| mask.arity()).collect::<Vec<_>>(), [2, 3]);
    // Coefficients of the mask of Daubechies with two vanishing moments.
    let irrational = "[1 + sqrt(3), 3 + sqrt(3), 3 - sqrt(3), 1 - sqrt(3)]/4";
    assert_eq!(parse_algebraic(irrational).expect("a mask").arity(), 2);
    let signs = "[1 + √3, 3 + √(3), 3 - √3, 1 - √3]/4";
    assert_eq!(
        parse_algebraic(signs).expect("a mask"),
        parse_algebraic(irrational).expect("a mask")
    );
}

/// Cubic B-splines, as people type and copy them.
#[test]
fn one_mask_in_many_forms() {
    let cubic = mask("[1, 4, 6, 4, 1]/8");
    for text in [
        "[1,4,6,4,1] /8",
        " [1,4,6,4,1] / 8 ",
        "1/8*[1,4,6,4,1]",
        "1/8 [1,4,6,4,1]",
        "1/8[1,4,6,4,1]",
        "2 * [1,4,6,4,1] / 16",
        "{1,4,6,4,1}/8",
        "1 /8 · {1,4,6,4,1}",
        "(1,4,6,4,1)/8",
        "(1/2 + 1/2) × (1,4,6,4,1)⁄8",
        "[1 4 6 4 1]/8",
        "[1; 4; 6; 4; 1]/8",
        "−1/8*[-1 −4 –6 -4 -1]",
        "[.125, .5, .75, .5, .125]",
        "[⅛, ½, ¾, +½, 1./8,]",
        "[0.125 0.5 0.75 0.5 0.125]",
        "root([-64, 0, 0, 1], 1)/32 [1, 4, 6, 4, 1]",
        "[1 - w, 4, 6, 4, 1 + w]/8:w=0",
        "√64/64*[1, 4, 6, 4, 1]",
        "[a, b, 3/4, b, a]:a=1/8,b=4*a",
    ] {
        assert_eq!(mask(text), cubic, "{text}");
    }
    assert_eq!(mask("[1; 1]"), mask("[1, 1]"));
}

/// Coefficients that lack a factor, as those of filters of wavelets do: the error says which.
#[test]
fn a_factor_that_is_missing_is_named() {
    for (text, sum, remedy) in [
        ("[1, 4, 6, 4, 1]/16", "add up to 1;", "2*[1, 4, 6, 4, 1]/16"),
        ("[1, 4, 6, 4, 1]", "add up to 16;", "1/8*[1, 4, 6, 4, 1]"),
        (
            "[1 + sqrt(3), 3 + sqrt(3), 3 - sqrt(3), 1 - sqrt(3)]/(4*sqrt(2))",
            "add up to sqrt(2);",
            "sqrt(2)*[1 + sqrt(3), 3 + sqrt(3), 3 - sqrt(3), 1 - sqrt(3)]/(4*sqrt(2))",
        ),
        ("[1, 1, 1, 1]/4", "add up to 1;", "2*[1, 1, 1, 1]/4"),
        ("[1, 1, 1, 1]/4", "add up to 1;", "4*[1, 1, 1, 1]/4"),
        ("1/2 {1, 2, 3, 2, 1}", "add up to 9/2;", "2/3*1/2 {1, 2, 3, 2, 1}"),
    ] {
        let error = parse_algebraic(text).expect_err(text).to_string();
        assert!(error.contains(sum) && error.contains(remedy), "{text}: {error}");
        // The remedy is a mask.
        parse_algebraic(remedy).expect(remedy);
    }
    let error = parse_scheme("[1, 4, 7]/16").expect_err("no mask").to_string();
    assert!(error.contains("add up to 3/4") && !error.contains("*["), "{error}");
}

#[test]
fn what_is_no_mask_is_refused() {
    for (text, reason) in [
        ("[1, 3, 3, 2]/4", "add up to 9/4; write 4/3*"),
        ("[1, 0, 0, 1]/2", "add up to 1; write 2*"),
        ("[1/2, 1, 0, 1/2]", "rule 0"),
        ("[1,, 1]", "a coefficient is missing"),
        ("[1, 3", "the list has no end"),
        ("[1, 1]x", "not a list of coefficients"),
        ("[[1], [1]]", "is a mask on Z^d"),
        ("{{1}, {1}}", "not a list of coefficients"),
        ("[1, 2; 3, 4]", "commas beside semicolons"),
        ("[0,125; 0,5]", "commas beside semicolons"),
        ("[1 - 1 2]", "expected an operator"),
        (
            "[a, b, b, a]",
            "add up to 2*a + 2*b; for the arity 2 write 1 - a for b, or 2/(2*a + 2*b)*[a, b, b, a]",
        ),
        ("[-w, 0, 1/2 + w, 1, 1/2 + w, 0, -w]/2", "add up to 1; write 2*[-w, "),
        ("[w, 1, w]:w=1/3", "add up to 1 + 2*w"),
        ("[1, 2}", "does not close"),
        ("{1, 2", "the list has no end"),
        ("(1, 2", "the list has no end"),
        ("[1, 2, 1]*[1, 1]", "a second list"),
        ("1/2 + [1, 2, 1]", "expected a number"),
        ("1 + 1/2*[1, 2, 1]", "a sum before the list"),
        ("[1, 2, 1]/2 + 0", "a sum behind the list"),
        ("1/[1, 2, 1]", "a number over a list"),
        ("w [1, 2, 1]", "a list behind a name"),
        ("[1, 2, 1] 1/2", "not a list of coefficients"),
        ("*[1, 2, 1]", "expected a number"),
        ("[1, 2, 1]/", "expected a number"),
        ("chaikin(1, 2)", "unknown scheme"),
        ("[sqrt(2), sqrt(3), sqrt(5), sqrt(7), sqrt(11)]", "a field of degree above 24"),
        ("[]", "add up to n"),
        ("[1 +, 1]", "expected a number"),
        ("[1, 1]/(1", "this bracket has no end"),
        ("[w/0, 2]:w=1", "division by zero"),
        ("[w, 2 - w]", "needs its parameter `w`"),
        ("[w, 2 - w]:w=1/2", "rule 0"),
        ("[w, 2 - w]:v=1", "no parameter `v`"),
        ("[sqrt(2), 2 - sqrt(2)]", "not rational"),
        ("[65]", "add up to n"),
        ("[2]", "rule 0"),
    ] {
        let error = parse_scheme(text).expect_err(text).to_string();
        assert!(error.contains(reason), "{text}: {error}");
    }
}
