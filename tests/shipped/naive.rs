//! Verdicts against a second way to find them: the standard library's parser, and whole numbers.

use super::{found, project, table};
use proptest::prelude::*;
use subcert::shipped::Verdict;

/// A fraction a/b as decimal with 40 digits after the point.
fn expansion(a: i128, b: i128) -> String {
    let (sign, a) = (if a < 0 { "-" } else { "" }, a.abs());
    let mut digits = format!("{sign}{}.", a / b);
    let mut rest = a % b;
    for _ in 0..40 {
        rest *= 10;
        digits.push_str(&(rest / b).to_string());
        rest %= b;
    }
    digits
}

/// The verdict of m/10^p, which is typed for a/b; `None` where it is a misprint or refuted.
fn naive(a: i128, b: i128, m: i128, p: u32, single: bool) -> Option<Verdict> {
    let literal = decimal(m, p);
    let exact = expansion(a, b);
    let steps = if single {
        let place = |text: &str| i64::from(text.parse::<f32>().expect("a number").abs().to_bits());
        place(&literal) - place(&exact)
    } else {
        let place =
            |text: &str| text.parse::<f64>().expect("a number").abs().to_bits().cast_signed();
        place(&literal) - place(&exact)
    };
    let same_sign = (m < 0) == (a < 0);
    if steps == 0 && same_sign {
        return Some(Verdict::Nearest);
    }
    let digits = m.abs().to_string().len();
    let scale = 10_i128.pow(p);
    if digits >= 2 && 2 * (m * b - a * scale).abs() <= b {
        return Some(Verdict::Rounded(digits));
    }
    if digits >= 3 && same_sign && a.abs() * scale / b == m.abs() {
        return Some(Verdict::Cut(digits));
    }
    let steps = steps.unsigned_abs();
    (same_sign && steps <= 100).then_some(Verdict::Ulps(steps))
}

/// m/10^p with p digits after the point.
fn decimal(m: i128, p: u32) -> String {
    let digits = format!("{:0width$}", m.abs(), width = p as usize + 1);
    let (whole, part) = digits.split_at(digits.len() - p as usize);
    format!("{}{whole}.{part}", if m < 0 { "-" } else { "" })
}

proptest! {
    #[test]
    fn verdicts_are_as_found_naively(
        a in -5_000_i128..5_000, b in 1_i128..700, p in 1_u32..18, off in prop_oneof![-2_i128..3, -300_i128..300],
        single: bool,
    ) {
        // Numbers near the right one, so that all verdicts occur.
        let m = a * 10_i128.pow(p) / b + off;
        prop_assume!(a != 0 && m != 0);
        let literal = decimal(m, p);
        let (kind, suffix) = if single { ("f32", "f") } else { ("f64", "") };
        let project = project(&table(kind, "", &format!("{a}/{b}"), &[&format!("{literal}{suffix}")]));
        let verdict = found(&project).cells[0].verdict;
        match naive(a, b, m, p, single) {
            Some(expected) => prop_assert_eq!(verdict, expected, "{}/{} as {}", a, b, literal),
            None => prop_assert!(matches!(verdict, Verdict::Misprint(_) | Verdict::Refuted(_)), "{:?}", verdict),
        }
    }

    /// A table that is rounded correctly by the standard library is right, and the text that is offered for it too.
    #[test]
    fn nearest_numbers_are_right(a in -5_000_i128..5_000, b in 1_i128..700, single: bool) {
        let exact = expansion(a, b);
        let (kind, text) = if single {
            ("f32", format!("{:e}f", exact.parse::<f32>().expect("a number")))
        } else {
            ("f64", format!("{:e}", exact.parse::<f64>().expect("a number")))
        };
        let project = project(&table(kind, "", &format!("{a}/{b}"), &[&text]));
        let finding = found(&project);
        prop_assert!(finding.is_right(), "{}/{} as {}: {:?}", a, b, text, finding.cells[0].verdict);
        let offered = subcert::shipped::nearest_text(finding.cells[0].exact.as_ref().unwrap(), project.shipped[0].kind);
        let offered = offered.expect("a number");
        let bits = |text: &str| text.parse::<f64>().expect("a number").to_bits();
        prop_assert_eq!(bits(&offered), bits(text.trim_end_matches('f')));
    }
}
