//! T_1, …, T_5 of Doo–Sabin faces.

use divan::Bencher;
use subcert::bound::LocalConstants;
use subcert::scheme::parse_local_rules;

fn main() {
    divan::main();
}

const VALENCES: [u32; 8] = [3, 5, 12, 37, 100, 455, 499, 500];

/// The weights, from their formula.
#[divan::bench(args = VALENCES, sample_count = 5)]
fn weights(n: u32) {
    divan::black_box(parse_local_rules(&format!("doo-sabin:n={n}")).expect("a catalogue entry"));
}

#[divan::bench(args = VALENCES, sample_count = 5)]
fn doo_sabin(bencher: Bencher, n: u32) {
    let ring = parse_local_rules(&format!("doo-sabin:n={n}")).expect("a catalogue entry");
    bencher.bench(|| LocalConstants::new(&ring, 5));
}
