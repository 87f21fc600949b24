//! Nodes, time and memory of the searches for T_c, Λ_c and the joint suprema, against c.
//!
//! `cargo run --release --example search` for the schemes of the papers, or with scheme names
//! and numbers c, and the word `forward` for masks that are read forwards. `schemes` lists the names.

use std::time::Instant;
use subcert::bound::{JointSearch, Order, PowerSearch, Searched};
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
    if std::env::args().skip(1).eq(["schemes"]) {
        println!("{}", SCHEMES.join("\n"));
        return Ok(());
    }
    let (forward, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|word| word == "forward");
    let order = if forward.is_empty() { Order::Adjoint } else { Order::Forward };
    let (levels, mut names): (Vec<String>, Vec<String>) =
        words.into_iter().partition(|word| word.parse::<u32>().is_ok());
    let mut levels: Vec<u32> = levels.iter().filter_map(|c| c.parse().ok()).collect();
    if levels.is_empty() {
        levels = vec![8, 16, 20, 32, 64, 128, 256];
    }
    if names.is_empty() {
        names = SCHEMES.map(str::to_owned).to_vec();
    }
    println!(
        "{:34} {:>4} {:>10} {:>10} {:>10} {:>10} {:>12} {:>10}",
        "", "c", "T: nodes", "ms", "Λ: nodes", "ms", "joint: nodes", "ms"
    );
    for name in names {
        let scheme = parse_scheme(&name)?;
        let mask = scheme.masks()[0];
        for &c in &levels {
            print!("{name:34} {c:>4}");
            let difference = mask.difference();
            timed(10, || PowerSearch::new(&difference, order).search(c));
            timed(10, || PowerSearch::new(mask.rules(), order).search(c));
            timed(12, || JointSearch::new(&difference, mask.rules(), order).search(c));
            println!();
        }
    }
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        let peak = status.lines().find(|line| line.starts_with("VmHWM"));
        println!("{}", peak.unwrap_or_default());
    }
    Ok(())
}

/// Prints the nodes and the time of a search.
fn timed(width: usize, search: impl FnOnce() -> Option<Searched>) {
    let start = Instant::now();
    let found = search();
    let time = start.elapsed().as_secs_f64() * 1e3;
    let nodes = found.map_or("–".to_owned(), |found| found.nodes.to_string());
    print!(" {nodes:>width$} {time:>10.1}");
}
