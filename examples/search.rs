//! Nodes, time and memory of the searches for T_c, Λ_c and the joint suprema, against c.
//!
//! `cargo run --release --example search` for the schemes of the papers, or with scheme names
//! and a number c.

use std::time::Instant;
use subcert::bound::{Order, PowerSearch, joint_norm};
use subcert::scheme::parse_scheme;

const SCHEMES: [&str; 6] = [
    "four-point",
    "six-point:w=3/256",
    "ternary-four-point:mu=1/11",
    "ternary-four-point-approximating",
    "quaternary-four-point:mu=0",
    "quinary-three-point",
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (levels, mut names): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|word| word.parse::<u32>().is_ok());
    let mut levels: Vec<u32> = levels.iter().filter_map(|c| c.parse().ok()).collect();
    if levels.is_empty() {
        levels = vec![8, 16, 20, 32, 64, 128, 256];
    }
    if names.is_empty() {
        names = SCHEMES.map(str::to_owned).to_vec();
    }
    println!(
        "{:34} {:>4} {:>12} {:>10} {:>12} {:>10} {:>10}",
        "", "c", "T: nodes", "ms", "Λ: nodes", "ms", "joint: ms"
    );
    for name in names {
        let scheme = parse_scheme(&name)?;
        let mask = scheme.masks()[0];
        for &c in &levels {
            print!("{name:34} {c:>4}");
            let difference = mask.difference();
            for rules in [&difference, mask.rules()] {
                let start = Instant::now();
                let found = PowerSearch::new(rules, Order::Adjoint).search(c);
                let time = start.elapsed().as_secs_f64() * 1e3;
                let nodes = found.map_or("–".to_owned(), |found| found.nodes.to_string());
                print!(" {nodes:>12} {time:>10.1}");
            }
            let start = Instant::now();
            let joint = joint_norm(&difference, mask.rules(), c, Order::Adjoint);
            let time = format!("{:.1}", start.elapsed().as_secs_f64() * 1e3);
            println!(" {:>10}", joint.map_or("–".to_owned(), |_| time));
        }
    }
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        let peak = status.lines().find(|line| line.starts_with("VmHWM"));
        println!("{}", peak.unwrap_or_default());
    }
    Ok(())
}
