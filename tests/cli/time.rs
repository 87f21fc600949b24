//! Commands that are given too little time.

use super::{TemporaryFile, assert_parts, refused, written};
use serde_json::Value;
use std::time::{Duration, Instant};

/// Far more than any of these takes, also where all cores are busy, and far less than without an end.
const MOST: Duration = Duration::from_secs(120);

#[test]
fn a_command_that_is_given_up_says_what_takes_less_time() {
    let cases: [(&[&str], &str); 2] = [
        (&["depth", "dubuc-deslauriers:m=20", "--tolerance", "1/100", "-c", "24"], "a smaller -c"),
        (&["spectrum", "loop", "--valence", "499"], "smaller valences"),
    ];
    for (command, less) in cases {
        let begin = Instant::now();
        let timed = command.iter().copied().chain(["--seconds", "1"]);
        let given_up = format!("`subcert {}` was given up after 1 second (--seconds N", command[0]);
        assert_parts(&refused(timed), &[&given_up, less]);
        assert!(begin.elapsed() < MOST, "{command:?}");
    }
}

/// Fractions without a pattern.
fn fractions(rows: usize) -> String {
    let mut state = 1_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(state >> 2).expect("62 digits")
    };
    let mut number = |_: usize| format!("{}/{}", next() - (1 << 61), 1 + next());
    let mut row = |_: usize| (0..rows).map(&mut number).collect::<Vec<String>>().join(" ");
    let mut matrix = |_: usize| (0..rows).map(&mut row).collect::<Vec<String>>().join("\n");
    (0..2).map(&mut matrix).collect::<Vec<String>>().join("\n\n")
}

#[test]
fn bounds_that_were_found_are_printed() {
    let (begin, file) = (Instant::now(), TemporaryFile::new("fractions.txt", &fractions(12)));
    let certificate = TemporaryFile::new("fractions.cert", "");
    let command = [
        "jsr",
        file.path(),
        "--seconds",
        "1",
        "--format",
        "json",
        "--certificate",
        certificate.path(),
    ];
    let json: Value = serde_json::from_str(&written(command)).expect("JSON");
    assert!(begin.elapsed() < MOST);
    assert_parts(json["ended"].as_str().expect("a reason"), &["stopped after 1 second"]);
    assert_eq!(json["exact"], false);
    let proof = std::fs::read_to_string(certificate.path()).expect("a certificate");
    assert!(subcert_check::check_radius(&proof).is_ok());
}
