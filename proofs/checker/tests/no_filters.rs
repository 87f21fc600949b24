//! Where no filter stands: other functions, other claims, and tables of schemes that give none.

use crate::filters::{SCHEMES, outcome};
use crate::masks::relation_of;
use subcert_check::{Outcome, check};

/// All other functions, and all other claims.
#[test]
fn other_functions() {
    for function in [
        "width(high)",
        "mask(high, 0, 0)",
        "difference(high, 0, 0)",
        "contraction(high)",
        "contraction(high, 2, order = forward)",
        "norm(high)",
        "tensor(high)",
        "tensor(high, suprema = joint)",
        "displacement(high)",
        "displacement(high, offset = best)",
        "surface_displacement(high, 1, 1, 1)",
        "convolution(high, 1, 0, 0)",
        "support(high)",
        "support_start(high)",
        "support_end(high)",
        "interpolating(high)",
        "sum_rules(high)",
        "generation(high)",
        "reproduction(high)",
        "approximation_order(high)",
        "approximation_order(high, data = adapted)",
        "moment(high, 0)",
        "limit_value(high, 0)",
        "integral(high, 0, 1)",
        "inner_product(high, 0)",
        "inner_product(low, 0, with = high)",
        "inner_product(high, 0, with = low)",
        "riesz_lower(high)",
        "riesz_upper(high)",
        "overshoot(high)",
        "gibbs(high)",
        "smoothness(high)",
        "hoelder(high)",
        "sobolev(high)",
        "positive(high)",
        "monotone(high)",
        "convex(high)",
        "independent(high)",
        "eigenvalue(high, 1)",
        "keeps_ratios(high, 0, 2)",
        "subdominant(high, 4)",
        "contraction(alias)",
        "sum_rules(half)",
        "norm(shift)",
    ] {
        for states in [format!("{function} >= -1000"), format!("{function}*0 = 0")] {
            let found = outcome("", &states, "holds 1");
            assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
        }
        let found = outcome("for = '0 < v < 1'\n", &format!("v > 0*{function}"), "holds reals");
        assert!(matches!(found, Outcome::Incomplete(Some(_))), "{function}: {found:?}");
    }
    // A symbol stands in symbols only.
    for (fields, states) in [
        ("scheme = 'high x high'\n", "1 = 1"),
        ("scheme = 'low x high'\n", "1 = 1"),
        ("scheme = 'high x low'\n", "arity() = 2"),
        ("", "symbol(high) = 1"),
        ("scheme = 'high'\n", "contraction() >= 0"),
        ("scheme = 'high:w=1'\n", "1 = 1"),
        ("", "modulus(pure, 1/2, w = 0) = 0"),
        ("", "vanishing_moments(scheme = pure, w = 0) = 0"),
        ("scheme = 'pure:w=0'\n", "1 = 1"),
    ] {
        let found = outcome(fields, states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{fields} {states}: {found:?}");
    }
}

#[test]
fn definitions() {
    for (table, right) in [
        ("filter = true\nsymbol = '1 - z'", true),
        ("filter = true\nsymbol = '1 - z'\narity = '4'", true),
        ("filter = true\nsymbol = 'sum(k = 0..63, k*z^k)'\narity = '64'", true),
        ("filter = false\nsymbol = '1 + z'", true),
        ("symbol = '1 - z'", false),
        ("filter = false\nsymbol = '1 - z'", false),
        ("filter = true\nsymbol = '0'", false),
        ("filter = true\nsymbol = 'z - z'", false),
        ("filter = true\nsymbol = '1 - z'\narity = '1'", false),
        ("filter = true\nsymbol = '1 - z'\narity = '0'", false),
        ("filter = true\nsymbol = '1 - z'\narity = '5/2'", false),
        ("filter = true\nsymbol = '1 - z'\noffset = '0'", false),
        ("filter = true\nsymbol = '1 - z'\nwidth = '2'", false),
        ("filter = true\nsymbol = '1 - z'\nmask = '[1, 1]'", false),
        ("filter = true\nmask = '[1, 1]'", false),
        ("filter = true\nmask = [['1'], ['1']]", false),
        ("filter = true\narity = '2'\nwidth = '1'\nentry = '1'", false),
        ("filter = true\nsymbol = '1 - z'\nentry = '1'", false),
        ("filter = true\nuse = 'hat'", false),
        ("filter = true\nuse = 'hat'\nsymbol = '1 - z'", false),
        ("filter = true\nsymbol = '1 - z'\norbits = { a = '3' }", false),
        ("filter = true\norbits = { a = '3' }\nedges = [['a[i]', 'a[i+1]']]", false),
        ("filter = true\nsymbol = '1/(1 - z)'", false),
        ("filter = true\nsymbol = 'z^0.5'", false),
        ("filter = true\nsymbol = 'symbol(later)'", false),
        ("filter = true", false),
    ] {
        let schemes = format!(
            "{SCHEMES}\n[[scheme]]\nname = 'new'\n{table}\n[[scheme]]\nname = 'later'\nsymbol = '1 + z'\n"
        );
        for states in ["arity(new) in {2, 4, 64}", "modulus(new, 1/7) > 0", "same(new, with = new)"]
        {
            let found = relation_of(
                &schemes,
                &format!("states = '{states}'"),
                &format!("states {states}\n holds 1"),
            );
            assert_eq!(found == Outcome::Valid, right, "{table}: {found:?}");
        }
    }
    // Fields of other types.
    for flag in ["'true'", "1", "['true']", "{ a = 'b' }"] {
        let claims = format!("key = 'k'\n[[scheme]]\nname = 's'\nsymbol = '1'\nfilter = {flag}\n");
        assert!(check(&claims, &[]).is_err(), "{flag}");
    }
}

/// Claims of other kinds, which are right with the scheme `hat` in place of the filter `half`.
#[test]
fn other_claims() {
    for (claim, block) in [
        (
            "[[table]]\nid = 'c'\nscheme = 'hat'\nvalue = 'arity()'\ncolumns = { name = 'c', values = ['1'] }\ncells = [['2']]",
            "table c\n  scheme hat\n  value arity()\n  cell 1 1 \"2\" 2 confirmed",
        ),
        (
            "[[table]]\nid = 'c'\nvalue = 'modulus(hat, 0)'\ncolumns = { name = 'c', values = ['1'] }\ncells = [['2']]",
            "table c\n  value modulus(hat, 0)\n  cell 1 1 \"2\" 2 confirmed",
        ),
        (
            "[[function]]\nid = 'c'\nvariable = 'v'\nscheme = 'hat'\nleft = 'v'\nright = 'v'",
            "function c\n  variable v\n  scheme hat\n  left v\n  right v\n  breaks\n  signs 0\n  holds",
        ),
        (
            "[[function]]\nid = 'c'\nvariable = 'v'\nleft = 'v*coefficient(hat, 0)'\nright = 'v*coefficient(hat, 0)'",
            "function c\n  variable v\n  left v*coefficient(hat, 0)\n  right v*coefficient(hat, 0)\n  breaks\n  signs 0\n  holds",
        ),
        (
            "[[range]]\nid = 'c'\nvariable = 'v'\nscheme = 'hat'\nvalue = 'v'\nbelow = '1'\nto = '1'",
            "range c\n  variable v\n  scheme hat\n  value v\n  below 1\n  breaks 1\n  signs - 0 +\n  end to \"1\" 1 equal\n  exact",
        ),
        (
            "[[range]]\nid = 'c'\nvariable = 'v'\nvalue = 'v*arity(hat)'\nbelow = '2'\nto = '1'",
            "range c\n  variable v\n  value v*arity(hat)\n  below 2\n  breaks 1\n  signs - 0 +\n  end to \"1\" 1 equal\n  exact",
        ),
        (
            "[[smoothness]]\nid = 'c'\nscheme = 'hat'\ncontinuous = '0'",
            "smoothness c\n  scheme hat\n  states-continuous 0\n  order 2\n  at-most 2\n  unit 1\n  image\n  image\n  continuous 0\n  end\n  confirmed",
        ),
        (
            "[[exponent]]\nid = 'c'\nscheme = 'hat'\nat_least = '1'",
            "exponent c\n  scheme hat\n  at-least 1\n  order 2\n  at-most 2\n  unit 1\n  image\n  image\n  continuous 0\n  end\n  confirmed",
        ),
        (
            "[[relation]]\nid = 'c'\nstates = '1 = 1'",
            "relation c\n  constant hat contraction adjoint 1 0 1/2\n  powers\n  states 1 = 1\n  holds 1",
        ),
        (
            "[[relation]]\nid = 'c'\nstates = '1 = 1'",
            "relation c\n  limits hat\n  order 2\n  at-most 2\n  unit 1\n  image\n  image\n  continuous 0\n  end\n  states 1 = 1\n  holds 1",
        ),
    ] {
        for (name, right) in [("hat", true), ("half", false), ("high", false)] {
            let claims = format!("key = 'k'\n{SCHEMES}\n{claim}\n");
            let cut = claims.len() - claim.len() - 1;
            let claims = format!("{}{}", &claims[..cut], claims[cut..].replace("hat", name));
            let certificate =
                format!("subcert-certificate 4\npaper k\n{}\nend 1\n", block.replace("hat", name));
            let report = check(&claims, &[&certificate]).expect("a claim file");
            let found = &report.claims[0].2;
            if right {
                assert_eq!(*found, Outcome::Valid, "{claim}");
            } else {
                assert!(matches!(found, Outcome::Invalid(..)), "{name} {claim}: {found:?}");
            }
        }
    }
}
