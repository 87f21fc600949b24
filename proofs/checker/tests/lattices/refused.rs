//! What is no mask on Z^d, and what is not said of one.

use super::{SCHEMES, outcome};
use crate::masks::relation_of;
use std::fmt::Write as _;
use subcert_check::{Outcome, check};

/// The error of a claim file with this scheme, or the outcome of a claim about it.
fn refused(scheme: &str) -> String {
    let own = format!("{SCHEMES}[[scheme]]\nname = 'own'\n{scheme}\n");
    let claims = format!(
        "key = 'k'\n{own}\n[[relation]]\nid = 'r'\nscheme = 'own'\nstates = 'arity() = arity()'\n"
    );
    let lines = "relation r\n states arity() = arity()\n holds 1\n";
    let certificate = format!("subcert-certificate 4\npaper k\n{lines}end 1\n");
    match check(&claims, &[&certificate]) {
        Err(why) => why,
        Ok(report) => match &report.claims[0].2 {
            Outcome::Invalid(_, rejection) | Outcome::Incomplete(Some(rejection)) => {
                rejection.reason.to_string()
            }
            other => format!("{other:?}"),
        },
    }
}

/// Checks that schemes are refused for these reasons.
fn all_refused(list: &[(&str, &str)]) {
    let mut wrong = String::new();
    for (scheme, why) in list {
        let found = refused(scheme);
        if !found.contains(why) {
            let _ = writeln!(wrong, "{scheme}: {found}");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn schemes() {
    let three = "symbol = '(1+x)*(1+y)*(1+x*y)/2'\n";
    assert_eq!(refused(three), "Valid");
    let with = |field: &str| format!("{three}{field}");
    let fields = [
        ("offset = '1'", "no field `offset`"),
        ("arity = '4'", "no field `arity`"),
        ("filter = true", "no field `filter`"),
        ("origin = [0, 0]", "no field `origin`"),
        ("use = 'three'", "no field `use`"),
        ("mask = '[[1]]'", "one of the fields"),
        ("box = [[1, 0]]", "one of the fields"),
        ("parameters.x = {}", "no mask on Z^d"),
        ("let = { y = '1' }", "no mask on Z^d"),
        ("dilation = [[2, 0], [0, true]]", "not of its type"),
        ("dilation = '2'", "not of its type"),
        ("dilation = [[2, 0, 0], [0, 2, 0]]", "not as many as the dimensions"),
        ("dilation = [[2, 0], [0, '2.0']]", "not as many as the dimensions"),
        ("dilation = [[2, 0], [0, '+2']]", "not as many as the dimensions"),
        ("dilation = [[2, 0], [0, '']]", "not as many as the dimensions"),
        ("dilation = [[2]]", "2 or 3 dimensions"),
        ("dilation = []", "2 or 3 dimensions"),
        ("dilation = [[2, 0], [0, 1]]", "no modulus above 1"),
        ("dilation = [[1, 1], [1, 1]]", "no modulus above 1"),
        ("dilation = [[3, 1], [5, 1]]", "no modulus above 1"),
        ("dilation = [[8, 0], [0, 9]]", "from 2 to 64"),
        ("dilation = [[65, 0], [0, 2]]", "from -64 to 64"),
        ("dilation = [[9223372036854775808, 0], [0, 2]]", "from -64 to 64"),
        ("dilation = [[3, 0], [0, 3]]", "sum to 1"),
        ("edges = []", "from 1 to 64 vectors"),
        ("edges = [[0, 0], [1, 0], [0, 1]]", "none of them 0"),
        ("edges = [[1, 0]]", "not all of Z^d"),
        ("edges = [[2, 0], [0, 1], [4, 1]]", "not all of Z^d"),
        ("edges = [[1, 0], [0, 1025], [0, 1]]", "from -1024 to 1024"),
        ("edges = [[1, 0, 0], [0, 1, 0]]", "not as many as the dimensions"),
        ("edges = [['a', 'b']]", "not as many as the dimensions"),
    ];
    let fields = fields.map(|(field, why)| (with(field), why));
    let fields: Vec<(&str, &str)> = fields.iter().map(|(field, why)| (&field[..], *why)).collect();
    // A parameter `x` is no variable, and has two meanings if `y` is one.
    let (two, others): (Vec<_>, Vec<_>) =
        fields.into_iter().partition(|(_, why)| *why == "no mask on Z^d");
    for (scheme, _) in two {
        assert!(refused(scheme).contains("two meanings"), "{scheme}: {}", refused(scheme));
    }
    all_refused(&others);
}

#[test]
fn masks() {
    all_refused(&[
        ("symbol = '(1+x)*(1+y)/2'", "sum to 1"),
        ("symbol = 'x - x'", "sum to 1"),
        ("symbol = '(1+x)*(1+y)*(1+z)/(1+x*y)'", "a remainder"),
        ("symbol = '1/(1-x*y)'", "a remainder"),
        ("symbol = 'x/y*(1+x)^3/(1 - y)'", "a remainder"),
        ("symbol = 'x^y'", "`y` is unknown"),
        ("symbol = 'sum(x = 0..1, y^x)*(1+y)'", "a variable is an index"),
        ("symbol = 'abs(x) + y'", "no meaning"),
        ("symbol = 'x^16385 + y'", "beyond a cap"),
        ("symbol = '(1+x)^65 + y'", "beyond a cap"),
        ("symbol = 'x^1026*(1+x)*(1+y)'", "beyond a cap"),
        ("symbol = '(1+x^(1/2))*(1+y)'", "an integer is needed"),
        ("symbol = 'symbol(three)'", "few functions"),
        ("symbol = 'symbol(three)*z'", "few functions"),
        ("symbol = 'symbol(three, x)*y'", "`symbol` takes"),
        ("symbol = 'symbol(hat)*(1+y)*x'", "`symbol` takes"),
        ("symbol = 'symbol(hat, 2)*(1+y)*x'", "`symbol` takes"),
        ("symbol = 'symbol(hat, x + y)'", "`symbol` takes"),
        ("symbol = 'symbol(cube)'\ndilation = [[2, 0], [0, 2]]", "another one"),
        ("symbol = 'symbol(own)*x'", "does not stand before it"),
        ("symbol = '(1+x)*(1+z)'\ndilation = [[2, 0], [0, 2]]", "`z` is unknown"),
        ("mask = '[[1, 1], [1]]'", "not equally long"),
        ("mask = '[[1, 1], 1]'", "a list is missing"),
        ("mask = '[[1, 1], [1, [1]]]'", "wrong"),
        ("mask = '[[1, 1], [1, 1]] + 1'", "no factors"),
        ("mask = '[[1, 1], [1, 1]]^2'", "no factors"),
        ("mask = '0 + 1*[[1, 1], [1, 1]]'", "no factor"),
        ("mask = '1 [[1, 1], [1, 1]]'", "a sign * is missing"),
        ("mask = '[[1; 1], [1; 1]]'", "wrong"),
        ("mask = '[[1, 1, ], [1, 1, ]]'", "wrong"),
        ("mask = '[[1, 1], [1, 1]]*[[1, 1]]'", "no list in it"),
        ("mask = '[[[[1, 1]]]]'", "2 or 3 dimensions"),
        ("mask = '[[1, 1], [1, 1]]'\norigin = [0]", "not as many as the dimensions"),
        ("mask = '[[1, 1], [1, 1]]'\norigin = [0, 2000]", "beyond a cap"),
        ("mask = '[[1, 1], [1, 1]]'\norigin = [0, 99999999999999999999]", "beyond a cap"),
        ("mask = '[[1, 1], [1, 1]]'\ndilation = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]", "as deep as"),
        ("mask = [['1', '1'], ['1']]\norigin = [0, 0]", "lengths"),
        ("mask = [['1', '1'], ['1', '2']]\norigin = [0, 0]", "sum to 1"),
        ("mask = []\norigin = [0, 0]", "lengths"),
        ("mask = [['1']]\ndilation = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]", "in one text"),
        ("box = []", "2 or 3 dimensions"),
        ("box = [[1, 0], [0, 0]]", "none of them 0"),
        ("box = [[1, 0], [2, 0]]", "sum to 1"),
        ("box = [[1, 0], [0, 1, 0]]", "not as many as the dimensions"),
        ("box = [[1, 0], [0, 1]]\ndilation = [[1, 1], [1, -1]]", "no direction to a multiple"),
        ("box = [[5000000, 0], [0, 1]]", "beyond a cap"),
        ("dilation = [[2, 0], [0, 2]]", "one of the fields"),
        ("dilation = [[2, 0], [0, 2]]\nuse = 'three'", "no field `use`"),
    ]);
}

#[test]
fn other_functions() {
    for states in [
        "width(three) = 2",
        "mask(three, 0, 0) = 1/2",
        "difference(three, 0, 0) = 1/2",
        "tensor(three) = 1/2",
        "support(three) = 2",
        "smoothness(three) = 0",
        "hoelder(three) = 1",
        "sobolev(three) > 1",
        "limit_value(three, 0) = 0",
        "symbol_at(three, 1) = 4",
        "orthogonal(three)",
        "moment(three, 1) = 0",
        "modulus_upper(three) = 4",
        "positive(three)",
        "independent(three)",
        "displacement(three) = 1",
        "vanishing_moments(three) = 0",
        "hurwitz(three)",
        "eigenvalue(three, 1) = 1",
        "keeps_ratios(three, 0, 1)",
        "convolution(three, 1, 0, 0) = 0",
        "subdominant(three, 6) = 1/2",
        "contraction(three, order = forward) = 1/2",
        "contraction(three, terms = total) = 1/2",
        "contraction(three, 1, 2) = 1/2",
        "contraction(three, -1) = 1",
        "contraction(three, 1/2) = 1",
        "contraction(three, 13) = 1/8192",
        "norm(three, 1000000) = 1",
        "norm(three, order = adjoint) = 1",
        "reproduction(three, parameters = natural) = 1",
        "approximation_order(three, data = other) = 2",
        "coefficient(three, 0) = 1/2",
        "coefficient(three, 0, 0, 0) = 1/2",
        "coefficient(three, 1/2, 0) = 0",
        "arity(three, 1) = 4",
        "same(three) = 1",
        "same(three, with = nothing) = 0",
        "same(hat, with = three) = 0",
        "biorthogonal(hat, with = three) = 0",
        "arity(hat, 1) = 2",
    ] {
        for lines in ["holds 1", "fails 1"] {
            assert_ne!(outcome("", &[states], lines), Outcome::Valid, "{states}");
            let own = states.replace("three, ", "").replace("three", "");
            if !own.contains("hat") {
                let found = outcome("scheme = 'three'", &[&own], lines);
                assert_ne!(found, Outcome::Valid, "{own}");
            }
        }
    }
}

/// Another claim has no such scheme, and no mask of curves has such a symbol in it.
#[test]
fn other_places() {
    for scheme in ["three x hat", "hat x three", "three x three", "three:w=1", "nothing"] {
        let found = outcome(&format!("scheme = '{scheme}'"), &["1 = 1"], "holds 1");
        assert_ne!(found, Outcome::Valid, "{scheme}");
    }
    let claims = |claim: &str| format!("key = 'k'\n{SCHEMES}\n{claim}");
    for (claim, lines) in [
        (
            "[[table]]\nid = 't'\nscheme = 'three'\nvalue = 'c'\ncolumns = { name = 'c', values = ['1'] }\n\
             cells = [['1']]\n",
            "table t\n  scheme three\n  value c\n  cell 1 1 \"1\" 1 confirmed\n",
        ),
        (
            "[[table]]\nid = 't'\nscheme = 'hat'\nvalue = 'smoothness(three)*c'\n\
             columns = { name = 'c', values = ['0'] }\ncells = [['0']]\n",
            "table t\n  scheme hat\n  value smoothness(three)*c\n  cell 1 1 \"0\" 0 confirmed\n",
        ),
    ] {
        let certificate = format!("subcert-certificate 4\npaper k\n{lines}end 1\n");
        let report = check(&claims(claim), &[&certificate]).expect("a claim file");
        assert_ne!(report.claims[0].2, Outcome::Valid, "{claim}");
    }
    let claim = "[[table]]\nid = 't'\nvalue = 'contraction(three, c)'\n\
                 columns = { name = 'c', values = ['1', '2'] }\ncells = [['0.5', '0.25']]\n";
    let lines = "table t\n  value contraction(three, c)\n  cell 1 1 \"0.5\" 1/2 confirmed\n  \
                 cell 1 2 \"0.25\" 1/4 confirmed\n";
    let certificate = format!("subcert-certificate 4\npaper k\n{lines}end 1\n");
    let report = check(&claims(claim), &[&certificate]).expect("a claim file");
    assert_eq!(report.claims[0].2, Outcome::Valid);
}

/// Symbols of curves with names `x` and `y` that are parameters stay what they are.
#[test]
fn curves() {
    for (scheme, states, holds) in [
        ("symbol = '1 + x*z + (1 - x)*z^3'\nparameters.x = {}", "arity(own, x = 1/2) = 2", true),
        ("symbol = 'y*(1 + z)^2/2'\nlet = { y = '1/z' }", "support(own) = 2", true),
        ("mask = '[1, 2, 1]/2'", "support(own) = 2", true),
        ("mask = [['1', '0'], ['1/2', '1/2']]", "arity(own) = 2", true),
        ("symbol = 'symbol(hat, x)'", "arity(own) = 2", false),
    ] {
        let own = format!("{SCHEMES}[[scheme]]\nname = 'own'\n{scheme}\n");
        let lines = format!("states {states}\n holds 1");
        let found = relation_of(&own, &format!("states = '{states}'"), &lines);
        assert_eq!(found == Outcome::Valid, holds, "{scheme}: {found:?}");
    }
}
