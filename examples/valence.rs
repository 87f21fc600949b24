//! Time for the constants of valence-dependent schemes, c = 1, …, 5, from the formulas on.
//!
//! `cargo run --release --example valence` for Doo–Sabin faces with n = 3, …, 500; or with a
//! scheme up to its valence, such as `catmull-clark:N=`, and the first and last valence.

use std::time::{Duration, Instant};
use subcert::bound::LocalConstants;
use subcert::scheme::parse_local_rules;

const LEVELS: u32 = 5;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (scheme, first, last) = match &arguments[..] {
        [] => ("doo-sabin:n=", 3, 500),
        [scheme, first, last] => (scheme.as_str(), first.parse()?, last.parse()?),
        _ => return Err("give a scheme, the first valence and the last, or nothing".into()),
    };
    let (start, mut slowest) = (Instant::now(), (Duration::ZERO, first));
    for valence in first..=last {
        let start = Instant::now();
        let constants =
            LocalConstants::new(&parse_local_rules(&format!("{scheme}{valence}"))?, LEVELS)?;
        assert_eq!(constants.levels.len(), LEVELS as usize, "all levels");
        slowest = slowest.max((start.elapsed(), valence));
    }
    println!(
        "{scheme}{first}…{last}: {:.3} s, the slowest {:.3} s for {}",
        start.elapsed().as_secs_f64(),
        slowest.0.as_secs_f64(),
        slowest.1
    );
    Ok(())
}
