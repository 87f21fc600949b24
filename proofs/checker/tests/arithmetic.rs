//! Numbers, small and large, against fractions of another library.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use proptest::prelude::*;
use subcert_check::{Outcome, check};

/// A formula with its value.
type Formula = (String, BigRational);

/// Numbers of all sizes, many of them next to the ends of machine integers.
fn number() -> impl Strategy<Value = Formula> {
    let near = |bits: u32| (-3_i128..=3).prop_map(move |off| (1_i128 << bits) + off);
    let integer =
        prop_oneof![-9_i128..=9, near(31), near(32), near(62), near(63), near(64), near(100)];
    let bottom = prop_oneof![1_i128..=9, near(32), near(62), near(63)];
    (integer, any::<bool>(), bottom).prop_map(|(top, negative, bottom)| {
        let top = if negative { -top } else { top };
        let sign = if top < 0 { "-" } else { "" };
        let value = BigRational::new(BigInt::from(top), BigInt::from(bottom));
        (format!("({sign}{}/{bottom})", top.unsigned_abs()), value)
    })
}

fn formula() -> impl Strategy<Value = Formula> {
    number().prop_recursive(4, 16, 2, |inner| {
        (inner.clone(), inner, 0..6).prop_map(|((a, x), (b, y), operator)| match operator {
            0 => (format!("({a} + {b})"), x + y),
            1 => (format!("({a} - {b})"), x - y),
            2 => (format!("({a}*{b})"), x * y),
            3 if !y.is_zero() => (format!("({a}/{b})"), x / y),
            4 => (format!("max({a}, {b})"), x.max(y)),
            _ => (format!("floor({a})"), x.floor()),
        })
    })
}

/// What the checker says of a certificate of an equation.
fn outcome(left: &str, right: &str, verdict: &str) -> Outcome {
    let claims =
        format!("key = \"k\"\n[[equation]]\nid = \"e\"\nleft = '{left}'\nright = '{right}'");
    let block = format!("equation e\n  left {left}\n  right {right}\n  {verdict}");
    of_block(&claims, &block)
}

/// What the checker says of the first claim of a file and a certificate of one block.
fn of_block(claims: &str, block: &str) -> Outcome {
    let kind = if claims.contains("[project]") { "project" } else { "paper" };
    let certificate = format!("subcert-certificate 4\n{kind} k\n{block}\nend 1\n");
    let report = check(claims, &[&certificate]).expect("a claim file");
    report.claims.into_iter().next().expect("a claim").2
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn formulas_have_the_values_of_fractions((left, value) in formula(), unit in number()) {
        let right = format!("{}/{}", value.numer(), value.denom()).replace('-', "0-");
        prop_assert_eq!(outcome(&left, &right, "holds 1"), Outcome::Valid);
        // Anything else is another number.
        prop_assume!(!unit.1.is_zero());
        let other = format!("{right} + {}", unit.0);
        let holds = outcome(&left, &other, "holds 1");
        prop_assert!(matches!(holds, Outcome::Invalid(..)), "{:?}", holds);
        let difference = format!("fails 1\n  case = 0 - {}", unit.0);
        prop_assert_eq!(outcome(&left, &other, &difference), Outcome::Valid);
    }

    // The same with a cosine beside them: cos(2π/5) = (√5 − 1)/4 is a root of 4x² + 2x − 1.
    #[test]
    fn numbers_with_cosines_are_a_field((a, x) in number(), (b, y) in number()) {
        let root = "cos(2*pi/5)";
        // (x + yr)(x + y(−1/2 − r)) = x² − xy/2 − y²/4
        let left = format!("({a} + {b}*{root})*({a} - {b}*(1/2 + {root}))");
        let norm = &x * &x - &x * &y / BigInt::from(2) - &y * &y / BigInt::from(4);
        let right = format!("{}/{}", norm.numer(), norm.denom()).replace('-', "0-");
        prop_assert_eq!(outcome(&left, &right, "holds 1"), Outcome::Valid);
        if !norm.is_zero() {
            let quotient = format!("1/({a} + {b}*{root})*({a} + {b}*{root})");
            prop_assert_eq!(outcome(&quotient, "1", "holds 1"), Outcome::Valid);
        }
    }
}

/// What the checker says of a theorem on Chaikin's scheme with a polygon that begins at an index, and a place 2 more.
fn from_index(first: i64) -> Outcome {
    let claims = "key = \"k\"\n[[theorem]]\nid = \"t\"\nlocus = \"1\"\ntitle = \"t\"\nscheme = \"chaikin\"\n\
        bounds = \"difference\"\nby = \"beta/2\"\nfrom = '0'\n";
    let block = format!(
        "theorem t\n  bounds difference\n  by beta/2\n  scheme chaikin\n  level 0\n  \
         polygon {first} 0 1 2 3\n  at {}\n  sides 1 1/2\n  refuted",
        i128::from(first) + 2
    );
    of_block(claims, &block)
}

// The first index i64::MIN has no absolute value in an i64.
/// Numbers may be written with as many digits as values may have.
#[test]
fn long_numbers_are_read() {
    let power = num_bigint::BigInt::from(2).pow(100_000).to_string();
    let table = |verdict: &str| {
        let claims = "key = \"k\"\n[[table]]\nid = \"t\"\nvalue = '2^100000'\n\
                      columns = { name = \"x\", values = ['1'] }\ncells = [['1']]";
        let block = format!("table t\n  value 2^100000\n  cell 1 1 \"1\" {verdict}");
        of_block(claims, &block)
    };
    let family = format!("{power} refuted\n  family 0\n  values 1 1 {power}\n  member : 0 0 0 : 1");
    assert_eq!(table(&family), Outcome::Valid);
    let wrong = family.replace(&power, &format!("{power}1"));
    assert!(matches!(table(&wrong), Outcome::Invalid(..)));
}

#[test]
fn an_index_at_the_ends_of_machine_integers_refutes_nothing() {
    for first in [i64::MIN, i64::MIN + 1, i64::MAX, -1_000_001, 1_000_001] {
        let said = from_index(first);
        assert!(matches!(said, Outcome::Invalid(..)), "{first}: {said:?}");
    }
    for first in [-1_000_000, -1, 0, 1_000_000] {
        assert_eq!(from_index(first), Outcome::Valid, "{first}");
    }
}

// x^(64^6) has an exponent beyond 32 bits: times x it is another one.
#[test]
fn powers_of_symbols_beyond_machine_integers_are_not_equal() {
    let power = "((((((x^64)^64)^64)^64)^64)^64)";
    let claims = format!(
        "key = \"k\"\n[[equation]]\nid = \"e\"\nsymbols = [\"x\"]\nleft = '{power}'\nright = '{power}*x'"
    );
    let block = format!("equation e\n  left {power}\n  right {power}*x\n  holds 1");
    let said = of_block(&claims, &block);
    assert!(matches!(said, Outcome::Incomplete(..)), "{said:?}");
}

// True equations with numbers at the caps of integers, and beyond them.
#[test]
fn integers_beyond_a_cap_are_left_open() {
    assert_eq!(outcome("binomial(3, 0 - 10000)", "0", "holds 1"), Outcome::Valid);
    assert_eq!(outcome("mod(7, 2^64)", "7", "holds 1"), Outcome::Valid);
    let ends = ["10001", "2^63", "2^64", "2^127", "2^128"];
    for end in ends {
        for formula in ["binomial(3, 0 - END)", "sum(i = END*100..0, i)", "0^(END*100)"] {
            let left = formula.replace("END", end);
            let said = outcome(&left, "0", "holds 1");
            assert!(matches!(said, Outcome::Incomplete(Some(_))), "{left}: {said:?}");
        }
    }
    let wrong = outcome("binomial(3, 1/2)", "0", "holds 1");
    assert!(matches!(wrong, Outcome::Invalid(..)), "{wrong:?}");
}

#[test]
fn products_and_factorials() {
    for (left, right) in [
        ("product(i = 1..5, i)", "120"),
        ("product(i = 3..2, i)", "1"),
        ("product(i = 2..10, 1 - 1/i^2)", "11/20"),
        ("product(i = 1..6, 2*sin(i))", ""),
        ("product(i = 1..6, 2*cos(pi/2 - i*pi/7))", "7"),
        ("product(i = 1..2, sum(j = 1..i, product(k = j..i, k + j)))", "2*(6 + 4)"),
        ("factorial(0)", "1"),
        ("factorial(1)", "1"),
        ("factorial(20)/factorial(18)", "380"),
        ("factorial(1000)", "1000*factorial(999)"),
        ("factorial(30)", "product(n = 1..30, n)"),
        ("factorial(7)/(factorial(3)*factorial(4))", "binomial(7, 3)"),
    ] {
        let valid = outcome(left, right, "holds 1") == Outcome::Valid;
        assert_eq!(valid, !right.is_empty(), "{left}");
        assert_ne!(outcome(left, &format!("1 + {right}"), "holds 1"), Outcome::Valid, "{left}");
    }
    for left in ["factorial(1001)", "product(i = 1..10^7, 1)", "product(i = 1..10^6, i)"] {
        let said = outcome(left, "1", "holds 1");
        assert!(matches!(said, Outcome::Incomplete(Some(_))), "{left}: {said:?}");
    }
    let wrong = ["factorial(-1)", "factorial(1/2)", "factorial(1, 2)", "product(2)", "product(i)"];
    for left in wrong {
        let said = outcome(left, "1", "holds 1");
        assert!(matches!(said, Outcome::Invalid(..)), "{left}: {said:?}");
    }
}

// With the offset −2^63 the program asked for 13 GB.
#[test]
fn offsets_beyond_a_cap_are_left_open() {
    let said = |offset: &str, own: &str| {
        let claims = format!(
            "key = 'k'\n[[table]]\nid = 't'\nscheme = 's'\nvalue = 'displacement({offset})'\n\
             columns = {{ name = 'x', values = ['1'] }}\ncells = [['1']]\n[[scheme]]\nname = 's'\noffset = '{own}'\n\
             mask = [['1', '0'], ['1/2', '1/2']]"
        );
        let block = format!(
            "table t\n  scheme s\n  value displacement({offset})\n  cell 1 1 \"1\" 1 confirmed"
        );
        of_block(&claims, &block)
    };
    for offset in [10_001, -10_001, i64::MIN, i64::MAX] {
        for (option, own) in
            [(format!("offset = {offset}"), "0".to_owned()), (String::new(), offset.to_string())]
        {
            let said = said(&option, &own);
            assert!(matches!(said, Outcome::Incomplete(Some(_))), "{option} {own}: {said:?}");
        }
    }
    assert_eq!(said("offset = 1", "0"), Outcome::Valid);
    assert_eq!(said("", "1"), Outcome::Valid);
}

// The double of 2^63 is 0 in 64 bits, and so less than every valence.
#[test]
fn a_block_beyond_the_valence_is_none() {
    let claims = "key = 'k'\n[[smoothness]]\nid = 's'\nscheme = 'loop'\nvalences = '5'\nnot_continuous = '1'";
    for (k, what) in [
        (1_u64 << 63, "diverges K +"),
        ((1 << 63) + 1, "eigenvalue K 1/2 3/4"),
        (u64::MAX, "diverges K -"),
    ] {
        let block = format!(
            "smoothness s\n  scheme loop\n  states-not-continuous 1\n  valences 5\n  vertex 5\n  part box-spline\n  {}\n  \
             below 1/2\n  outer\n  confirmed",
            what.replace('K', &k.to_string())
        );
        let said = of_block(claims, &block);
        let Outcome::Invalid(_, rejection) = &said else { panic!("{said:?}") };
        assert!(rejection.reason.to_string().contains("n/2"), "{said:?}");
    }
}

// The integer −2^63 passed the cap, since it has no absolute value in an i64.
#[test]
fn integers_of_programs_have_a_cap() {
    for power in ["-10000", "-10001", "0 - 2^63", "2^127"] {
        let claims = format!(
            "key = 'k'\n[project]\nname = 'p'\n[[shipped]]\nid = 't'\nlocus = 'l'\ntitle = 't'\ntype = 'f64'\n\
             language = 'c'\nequals = 'binomial(3, {power})'\ncells = ['0.0']"
        );
        let said =
            of_block(&claims, "shipped t\n  bits 64\n  cell \"0.0\" nearest\n  outcome nearest");
        let open = matches!(said, Outcome::Incomplete(Some(_)));
        assert!(open == (power != "-10000"), "{power}: {said:?}");
    }
}

#[test]
fn products_and_factorials_of_programs() {
    for (formula, cell, valid) in [
        ("factorial(5)/product(i = 1..3, i)", "20.0", true),
        ("product(i = 1..0, i)*factorial(0)", "1.0", true),
        ("product(i = 1..2, sqrt(2)) + factorial(3)", "8.0", true),
        ("factorial(5)/product(i = 1..3, i)", "21.0", false),
        ("factorial(-1)", "1.0", false),
        ("factorial(1001)", "1.0", false),
    ] {
        let claims = format!(
            "key = 'k'\n[project]\nname = 'p'\n[[shipped]]\nid = 't'\nlocus = 'l'\ntitle = 't'\ntype = 'f64'\n\
             language = 'c'\nequals = '{formula}'\ncells = ['{cell}']"
        );
        let block = format!("shipped t\n  bits 64\n  cell \"{cell}\" nearest\n  outcome nearest");
        let said = of_block(&claims, &block);
        assert_eq!(said == Outcome::Valid, valid, "{formula}: {said:?}");
    }
}

/// What the checker says of a lower bound of the Hölder exponent of Chaikin's scheme, which is 2.
fn exponent_at_least(bound: &str) -> Outcome {
    let claims = format!(
        "key = \"k\"\n[[exponent]]\nid = \"e\"\nlocus = \"1\"\nscheme = \"chaikin\"\nat_least = '{bound}'\n"
    );
    let block = format!(
        "exponent e\n  scheme chaikin\n  at-least {bound}\n  order 3\n  product 1\n  \
         eigenvalue positive 2\n  at-most 2\n  unit 1\n  image\n  image\n  continuous 1\n  not-continuous 2\n  end\n  \
         confirmed"
    );
    of_block(&claims, &block)
}

// The powers 2^(2^47·400000) and 2^(2^47·300000) have exponents beyond 64 bits, of which the first is greater.
#[test]
fn powers_beyond_machine_integers_are_compared() {
    assert_eq!(exponent_at_least("1"), Outcome::Valid);
    let (more, less) = ("2^47*log_2(2^400000)", "2^47*log_2(2^300000)");
    let above = exponent_at_least(&format!("1 + {more} - {less}"));
    assert!(matches!(above, Outcome::Invalid(..)), "{above:?}");
    assert_eq!(exponent_at_least(&format!("1 + {less} - {more}")), Outcome::Valid);
}
