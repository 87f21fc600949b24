//! Certificates of joint spectral radii, and what the checker says of altered ones.

use super::radius::set;
use subcert::certificate::{radius_certificate, smoothness_certificate};
use subcert::joint::joint_radius;
use subcert::scheme::parse_scheme;
use subcert::smoothness::Smoothness;
use subcert_check::check_radius;

fn of_scheme(name: &str) -> String {
    let scheme = parse_scheme(name).expect("a scheme");
    let mask = scheme.masks()[0];
    let smoothness = Smoothness::of(mask).expect("short rules");
    smoothness_certificate(mask, &smoothness).expect("a radius that is not 0")
}

#[test]
fn the_checker_accepts_what_is_proven() {
    for (name, continuous, fails) in [
        ("chaikin", Some(1), Some(2)),
        ("four-point:w=1/16", Some(1), Some(2)),
        ("four-point:w=1/15", Some(1), Some(2)),
        ("four-point:w=1/4", Some(0), Some(1)),
        ("six-point:w=3/256", Some(2), Some(3)),
        ("ternary-four-point:mu=1/11", Some(2), Some(3)),
        ("ternary-four-point:mu=1/9", Some(1), Some(2)),
        ("ternary-four-point-approximating", Some(2), Some(3)),
        ("four-point:w=-1", None, Some(0)),
    ] {
        let radius = check_radius(&of_scheme(name));
        let radius = radius.unwrap_or_else(|rejection| panic!("{name}: {rejection:?}"));
        assert_eq!((radius.continuous, radius.not_continuous), (continuous, fails), "{name}");
    }
    let pair = set(&[&[&[-1, -1], &[-4, 0]], &[&[3, 3], &[-2, 1]]]);
    let text = radius_certificate(&pair, &joint_radius(&pair)).expect("it is not 0");
    let radius = check_radius(&text).expect("a valid certificate");
    assert_eq!(radius.at_least.expect("a product").1, 2);
}

#[test]
fn the_checker_accepts_no_false_number() {
    for name in ["four-point:w=1/16", "ternary-four-point:mu=1/11", "six-point:w=1/100"] {
        let text = of_scheme(name);
        let altered = |word: &str, rest: &str| {
            let line = text.lines().find(|line| line.starts_with(word)).expect("a line");
            text.replacen(line, &format!("{word} {rest}"), 1)
        };
        let honest = check_radius(&text).expect("a valid certificate");
        let (continuous, fails) = (honest.continuous.unwrap(), honest.not_continuous.unwrap());
        // Of unit rows alone, any multiple is as good.
        let unit = text.contains("\nrow").then(|| altered("unit", "1/1000000000"));
        let more = [
            altered("at-most", "1"),
            altered("eigenvalue", "positive 1000"),
            altered("continuous", &(continuous + 1).to_string()),
            altered("not-continuous", &(fails - 1).to_string()),
            altered("order", &(text.matches("rule").count() * 9).to_string()),
        ];
        for wrong in more.into_iter().chain(unit) {
            assert!(check_radius(&wrong).is_err(), "{name}:\n{}", &wrong[..wrong.len().min(400)]);
        }
    }
}
