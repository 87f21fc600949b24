//! Certificates of depths: what is beyond a cap is incomplete, and takes little time to refuse.

use std::time::{Duration, Instant};
use subcert_check::check_depth;

const CHAIKIN: &str = "rule 3/4 1/4\nrule 1/4 3/4";

const SQUARE: &str = "point 0 0\npoint 2 0\npoint 2 2\npoint 0 2";

fn certificate(tolerance: &str, rules: &str, points: &str, says: &str) -> String {
    let count = points.lines().count();
    format!(
        "subcert-depth 1\ntolerance {tolerance}\ndirection 0 {count} closed\n{rules}\n{points}\n{says}\nend\n"
    )
}

/// Asserts that a certificate is beyond this cap.
fn assert_capped(text: &str, cap: &str) {
    let start = Instant::now();
    let rejection = check_depth(text).expect_err(cap);
    let said = rejection.reason.to_string();
    assert!(said.ends_with(&format!("beyond a cap of the checker: {cap}")), "{said}");
    assert!(rejection.given_up(), "{said}");
    assert!(start.elapsed() < Duration::from_secs(60), "{cap}: {:?}", start.elapsed());
}

#[test]
fn a_square_is_certified() {
    assert!(check_depth(&certificate("1/2", CHAIKIN, SQUARE, "enough 0")).is_ok());
}

#[test]
fn what_is_beyond_a_cap_is_incomplete() {
    let capped = |tolerance: &str, rules: &str, points: &str, says: &str, cap: &str| {
        assert_capped(&certificate(tolerance, rules, points, says), cap);
    };
    let digits = "2,048 binary digits of a number";
    capped("1e-999", CHAIKIN, SQUARE, "enough 0", digits);
    capped("1/2", CHAIKIN, &SQUARE.replace("2 2", "1/3 1e-700"), "enough 0", digits);
    capped(
        "1/2",
        CHAIKIN,
        &SQUARE.replace("2 2", &format!("2 {}", "9".repeat(700))),
        "enough 0",
        digits,
    );
    capped("1/2", CHAIKIN, SQUARE, &format!("too-few 0 limit 1/{}", "7".repeat(700)), digits);
    let size = "the size of coefficients";
    let denominators = "rule 1/1000003 1000002/1000003\nrule 1/1000033 1000032/1000033";
    capped(
        "1/2",
        &format!("{denominators}\nrule 1/1000037 1000036/1000037"),
        SQUARE,
        "enough 0",
        size,
    );
    capped("1/2", "rule 1099511627777 -1099511627776\nrule 0 1", SQUARE, "enough 0", size);
    capped("1/2", CHAIKIN, SQUARE, "enough 25", "levels up to 24");
    let zeros = " 0".repeat(65);
    capped("1/2", &format!("rule{zeros}"), SQUARE, "enough 0", "64 rules of 64 numbers");
    let many = "100,000 points of 8 coordinates";
    capped("1/2", CHAIKIN, &SQUARE.replace("2 2", &zeros), "enough 0", many);
    let comment = format!("# {}", "x".repeat(4 << 20));
    capped("1/2", CHAIKIN, SQUARE, &format!("{comment}\nenough 0"), "4 MiB of text");
}

/// Large weights of few points take lines to lines with a shift of 2^31: a functional from the points of one level to
/// those of the other would have as many coefficients.
#[test]
fn points_far_from_their_parameters_are_beyond_a_cap() {
    let weight = 1_i64 << 30;
    let rules =
        format!("rule {} {weight}\nrule {}/2 {}/2", 1 - weight, 1 - 2 * weight, 1 + 2 * weight);
    assert_capped(&certificate("1", &rules, SQUARE, "enough 0"), "the size of a window");
}

/// Powers of an operator over wide rules, which never fall, are products of long fractions.
#[test]
fn powers_of_wide_rules_are_beyond_a_cap() {
    let rule = |alpha: i64| {
        // Between points 0 and 1 at α/64, and a fourth difference of other weights in each rule, which lines do not see.
        let mut weights = vec![0; 40];
        (weights[20], weights[21]) = (64 - alpha, alpha);
        for (i, part) in (0..35).zip([1_i64, -4, 6, -4, 1].repeat(7)) {
            weights[2 + i] += part * (7 + alpha % 5);
        }
        let weights: Vec<String> = weights.iter().map(|x| format!("{x}/64")).collect();
        format!("rule {}", weights.join(" "))
    };
    let rules: Vec<String> = (0..64).map(rule).collect();
    let text = certificate("1", &rules.join("\n"), SQUARE, "enough 0");
    assert_capped(&text.replace("direction 0", "direction -20"), "the steps of a claim");
}
