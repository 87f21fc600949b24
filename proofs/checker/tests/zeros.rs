//! `hurwitz`, for products with known zeros, and functions of masks with real values of a parameter.

use crate::masks::{relation_of, values};
use std::fmt::Write as _;
use subcert_check::Outcome;

/// Numbers that look random.
pub struct Numbers(pub u64);

impl Numbers {
    /// One from −most to most.
    pub fn around(&mut self, most: i64) -> i64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(self.0 >> 33).unwrap_or(0) % (2 * most + 1) - most
    }
}

pub fn float(x: i64) -> f64 {
    f64::from(i32::try_from(x).unwrap_or(0))
}

#[test]
fn zeros_in_the_left_half() {
    values(&[
        ("hurwitz(two)", "1"),
        ("hurwitz(cubic)", "1"),
        ("hurwitz(haar)", "1"),
        ("hurwitz(bell)", "1"),
        ("hurwitz(ternary)", "1"),
        ("hurwitz(golden)", "1"),
        ("hurwitz(mirrored)", "0"),
        ("hurwitz(four)", "0"),
        ("hurwitz(daubechies)", "0"),
        ("hurwitz(rough)", "0"),
        // Zeros at ±i, and at e^{±iπ/3}.
        ("hurwitz(averaged)", "0"),
        ("hurwitz(stretched)", "0"),
        // The rules of a scheme have sums other than 0.
        ("vanishing_moments(four)", "0"),
        ("vanishing_moments(daubechies)", "0"),
    ]);
}

/// Products of factors whose zeros are known; σ = 1 + z is one, and the sum is 2.
#[test]
fn products_with_known_zeros() {
    let (mut numbers, mut seen) = (Numbers(3), [0; 2]);
    for _ in 0..60 {
        let (mut text, mut total, mut is) = (String::from("(1 + z)"), 1, true);
        for _ in 0..=numbers.around(2).abs() {
            let (p, q) = (numbers.around(4), 1 + numbers.around(3).abs());
            if numbers.around(1) == 0 {
                // The zero is −q/p', where p' is not negative but in one of five cases.
                let p = if p < -2 { p } else { p.abs().max(1) };
                if p + q == 0 {
                    continue;
                }
                let _ = write!(text, "*({p}*z + {q})");
                total *= p + q;
                is &= p > 0;
            } else {
                let p = if p < -2 { p } else { p.abs() };
                if 1 + p + q == 0 {
                    continue;
                }
                let _ = write!(text, "*(z^2 + ({p})*z + {q})");
                total *= 1 + p + q;
                is &= p > 0;
            }
        }
        let shift = numbers.around(5);
        let scheme = format!("[[scheme]]\nname = 's'\nsymbol = 'z^({shift})*{text}/({total})'\n");
        let states = format!("hurwitz(s) = {}", i64::from(is));
        let found = relation_of(
            &scheme,
            &format!("states = '{states}'"),
            &format!("states {states}\n holds 1"),
        );
        assert_eq!(found, Outcome::Valid, "{text}");
        seen[usize::from(is)] += 1;
    }
    assert!(seen[0] > 10 && seen[1] > 10, "{seen:?}");
}

const FAMILY: &str = "
[[scheme]]
name = 'raised'
symbol = '(w/z + 1 + (1 - w)*z)*(1 + z)/2'
parameters.w = {}
[[scheme]]
name = 'cubic'
symbol = '(1 + z)*(z^3 + w*z^2 + (6 - w)*z + 1)/8'
parameters.w = {}
[[scheme]]
name = 'quartic'
symbol = '(1 + z)*(z^4 + 2*z^3 + w*z^2 + (5 - w)*z + 1)/9'
parameters.w = {}
[[scheme]]
name = 'fp'
symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'
parameters.w = {}
";

/// A scheme, the values of the index, whether no others are right, what is stated, and the lines.
type Claim = (&'static str, &'static str, bool, &'static str, &'static str);

const CUT: &str = "corner-cutting:w=v";
const FIFTH: &str = "corner-cutting:w=1/5";

#[rustfmt::skip]
const CLAIMS: &[Claim] = &[
    ("raised:w=v", "0 <= v <= 1", true, "hurwitz()", "holds reals"),
    ("raised:w=v", "0 < v <= 1", true, "hurwitz()", "fails reals\n true 0"),
    ("raised:w=v", "0 <= v <= 2", false, "hurwitz()", "fails reals\n false 3/2"),
    ("raised:w=v", "real v", false, "hurwitz() in {0, 1}", "holds reals"),
    ("cubic:w=v", "3-sqrt(8) < v < 3+sqrt(8)", true, "hurwitz()", "holds reals"),
    ("cubic:w=v", "3-sqrt(8) <= v < 3+sqrt(8)", false, "hurwitz()", "fails reals\n false root:1,-6,1:0:1"),
    ("cubic:w=v", "0 < v < 3+sqrt(8)", false, "hurwitz()", "fails reals\n false 1/6"),
    ("cubic:w=v", "1/5 < v < 3+sqrt(8)", true, "hurwitz()", "fails reals\n true 9/50"),
    // 2w(5 − w) > (5 − w)² + 4: 3w² − 20w + 29 < 0.
    ("quartic:w=v", "(10-sqrt(13))/3 < v < (10+sqrt(13))/3", true, "hurwitz()", "holds reals"),
    ("quartic:w=v", "2 < v < (10+sqrt(13))/3", false, "hurwitz()", "fails reals\n false 21/10"),
    (CUT, "1/5 <= v <= 2/7", true, "keeps_ratios(1, 2)", "holds reals"),
    (CUT, "1/5 < v <= 2/7", true, "keeps_ratios(1, 2)", "fails reals\n true 1/5"),
    (CUT, "1/5 <= v < 2/7", true, "keeps_ratios(1, 2)", "fails reals\n true 2/7"),
    (CUT, "1/6 <= v <= 2/7", false, "keeps_ratios(1, 2)", "fails reals\n false 19/100"),
    (CUT, "v = 1/4", true, "keeps_ratios(1, 1)", "holds reals"),
    ("", "1 <= v", false, "keeps_ratios(chaikin, 1, v)", "holds reals"),
    (FIFTH, "v >= 2", false, "keeps_ratios(1, v)", "holds reals"),
    (FIFTH, "1 <= v < 2", false, "not keeps_ratios(1, v)", "holds reals"),
    (FIFTH, "v >= sqrt(2)", false, "keeps_ratios(1, v^2)", "holds reals"),
    (FIFTH, "1 <= v <= sqrt(2)", false, "not keeps_ratios(1, v^2)", "fails reals\n false root:-2,0,1:1:2"),
    (CUT, "0 < v < 1/3", false, "keeps_ratios(1, 1/5)", ""),
    ("fp:w=v", "real v", false, "vanishing_moments() = 0", "holds reals"),
    ("fp:w=v", "real v", false, "hurwitz() <= 1", "holds reals"),
    ("fp:w=v", "v = 0", true, "hurwitz()", "holds reals"),
    ("fp:w=v", "real v", false, "keeps_ratios(3, 2)", ""),
    ("fp:w=v", "real v", false, "modulus(1/4) = 1", ""),
    ("fp:w=v", "real v", false, "modulus_upper() >= 2", ""),
    (FIFTH, "v >= 0", false, "keeps_ratios(1, v) >= 0", ""),
];

#[test]
fn families() {
    for (scheme, of, only, states, right) in CLAIMS {
        let scheme =
            if scheme.is_empty() { String::new() } else { format!("scheme = '{scheme}'\n") };
        let only = if *only { "only = true\n" } else { "" };
        let fields = format!("{scheme}states = '{states}'\nfor = '{of}'\n{only}");
        let found =
            |lines: &str| relation_of(FAMILY, &fields, &format!("states {states}\n {lines}"));
        // Without a line, the claim is open whatever the certificate says.
        if !right.is_empty() {
            assert_eq!(found(right), Outcome::Valid, "{of}: {states}");
        }
        let mut forged = vec![
            "holds reals",
            "fails reals",
            "holds 1",
            "fails reals\n false 1",
            "fails reals\n true 1",
        ];
        forged.extend([
            "fails reals\n false 1/4",
            "fails reals\n true 1/4",
            "fails reals\n false 1/5",
        ]);
        forged.extend([
            "fails reals\n true 17/100",
            "fails reals\n false 1/2",
            "fails reals\n true 1/2",
        ]);
        let witness = right.starts_with("fails");
        for lines in forged.into_iter().filter(|lines| lines != right) {
            // A false claim may have other numbers that show it.
            let other = witness && lines.starts_with("fails reals\n");
            assert!(other || found(lines) != Outcome::Valid, "{of}: {states}: {lines}");
        }
    }
}
