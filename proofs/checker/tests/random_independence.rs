//! Independence of shifts on intervals of a parameter, against that for single numbers.

use crate::masks::relation_of;
use std::fmt::Write as _;
use subcert_check::Outcome;

/// Numbers that look random.
struct Numbers(u64);

impl Numbers {
    /// One from −most to most.
    fn up_to(&mut self, most: i64) -> i64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let next = i64::try_from(self.0 >> 33).unwrap_or(0);
        next.rem_euclid(2 * most + 1) - most
    }

    /// A polynomial of z with integers as coefficients.
    fn polynomial(&mut self, length: i64) -> String {
        let mut text = String::from("0");
        for power in 0..length {
            let _ = write!(text, " + ({})*z^{power}", self.up_to(2));
        }
        text
    }
}

/// Polynomials that are n at 1 times σ(z), and leave dependent shifts.
const DEPENDENT: [(usize, &str); 9] = [
    (2, "(1 + z^2)/2"),
    (2, "(1 - z + z^2)"),
    (2, "(1 + z^2)*(1 - z + z^2)/2"),
    (2, "(1 + z^6)/(1 + z^2)"),
    (2, "(1 - z + z^2 - z^3 + z^4)"),
    (2, "(1 - z + z^2 - z^3 + z^4 - z^5 + z^6)"),
    (3, "(1 - z + z^2)"),
    (3, "(1 - z^2 + z^4)"),
    (3, "(1 + z^3)/2*(1 + z + z^2)/3"),
];

#[test]
fn intervals_agree_with_numbers() {
    let mut numbers = Numbers(5);
    let mut counts = [0; 3];
    for round in 0..54_usize {
        let (n, dependent) = DEPENDENT[round % DEPENDENT.len()];
        let sigma = if n == 2 { "(1 + z)" } else { "(1 + z + z^2)" };
        let changed = numbers.polynomial(2 + i64::try_from(round % 3).unwrap_or(0));
        let by = ["w", "w^2 - 2", "w*(w + 1)"][round % 3];
        let schemes = format!(
            "[[scheme]]\nname = 's'\nparameters.w = {{}}\narity = '{n}'\n\
             symbol = '{sigma}*({dependent} + ({by})*(1 - z)*({changed}))'\n"
        );
        let holds = |fields: &str, states: &str, verdict: &str| {
            let lines = format!("states {states}\n {verdict}");
            let outcome = relation_of(&schemes, &format!("states = '{states}'\n{fields}"), &lines);
            assert!(
                !matches!(&outcome, Outcome::Incomplete(_)),
                "{round}: {schemes}{fields}{states}: {outcome:?}"
            );
            outcome == Outcome::Valid
        };
        let is = |at: &str| {
            let fields = format!("scheme = 's:w={at}'\n");
            let is = holds(&fields, "independent()", "holds 1");
            assert_ne!(is, holds(&fields, "not independent()", "holds 1"), "{schemes}{at}");
            is
        };
        let intervals = [
            ("-1 < v < 1", vec!["-1/2", "-1/3", "0", "1/7", "1/2"]),
            ("-1/2 <= v < -1/4", vec!["-1/2", "-3/8", "-1/3"]),
            ("0 < v < 1", vec!["1/9", "1/4", "1/3", "1/2", "2/3"]),
            ("1.4 < v < 1.5", vec!["17/12", "41/29", "29/20"]),
            ("1.4 < v < sqrt(2)", vec!["141/100", "7071/5000"]),
        ];
        for (of, at) in intervals {
            let fields = format!("for = '{of}'\n");
            let states = ["independent(s, w = v)", "not independent(s, w = v)"];
            let [all, none] = states.map(|states| holds(&fields, states, "holds reals"));
            assert!(!(all && none));
            let found: Vec<bool> = at.iter().map(|at| is(at)).collect();
            assert!(!all || !found.contains(&false), "{round}: {schemes}{of}: {found:?}");
            assert!(!none || !found.contains(&true), "{round}: {schemes}{of}: {found:?}");
            counts[if all {
                0
            } else if none {
                1
            } else {
                2
            }] += 1;
        }
        if by == "w^2 - 2" {
            // The number itself, by the field of √2.
            let fields = "for = 'sqrt(2) <= v <= sqrt(2)'\n";
            assert!(holds(fields, "not independent(s, w = v)", "holds reals"), "{schemes}");
            assert!(!holds("for = '1 < v < 2'\n", "independent(s, w = v)", "holds reals"));
        }
    }
    println!("{counts:?}");
    assert!(counts[0] > 50 && counts[2] > 20, "{counts:?}");
}

/// Half of the roots of unity of the order 17, for w² = 17; and for n = 3 parts with a common zero for all w.
const OTHERS: &str = "
[[scheme]]
name = 'half'
symbol = '(1 + z)*(1 + z^8 - (1 - w)/2*(z + z^7) + (5 - w)/2*(z^2 + z^6) - (7 - w)/2*(z^3 + z^5) + (2 - w)*z^4)'
parameters.w = {}
[[scheme]]
name = 'apart'
symbol = '(1 + z + z^2)*(1 + z^3)/2*(w + (1 - w)*z)'
parameters.w = {}
[[scheme]]
name = 'third'
symbol = '(1 + z + z^2)*(1 + w*(z^3 - 1))*(1 - w + w*z^6)'
parameters.w = {}
";

#[test]
fn other_roots() {
    let holds = |of: &str, only: bool, states: &str, verdict: &str| {
        let only = if only { "only = true\n" } else { "" };
        let fields = format!("states = '{states}'\nfor = '{of}'\n{only}");
        let found = relation_of(OTHERS, &fields, &format!("states {states}\n {verdict}"));
        assert!(!matches!(found, Outcome::Incomplete(_)), "{fields}: {found:?}");
        found == Outcome::Valid
    };
    let independent = "independent(half, w = v)";
    for (at, is) in [("root:-17,0,1:4:5", true), ("root:-17,0,1:-5:-4", true), ("9/2", false)] {
        assert_eq!(holds("real v", false, independent, &format!("fails reals\n false {at}")), is);
    }
    assert!(!holds("4 < v < 5", false, independent, "holds reals"));
    assert!(!holds("4 < v <= sqrt(17)", false, independent, "holds reals"));
    assert!(holds("4.1 < v < sqrt(17)", false, independent, "holds reals"));
    assert!(holds("sqrt(17) < v < 4.2", false, independent, "holds reals"));
    assert!(holds("real v", false, "not independent(apart, w = v)", "holds reals"));
    assert!(!holds("real v", false, "independent(apart, w = v)", "holds reals"));
    // The parts are (1 + w(z − 1))(1 − w + wz²), all three.
    assert!(!holds("real v", false, "independent(third, w = v)", "holds reals"));
    assert!(holds("v = 0, 1", true, "independent(third, w = v)", "holds reals"));
}
