//! T_1, …, T_5 of Doo–Sabin faces.

use divan::Bencher;
use subcert::bound::RingConstants;
use subcert::scheme::parse_ring;

fn main() {
    divan::main();
}

#[divan::bench(args = [3, 5, 12, 37, 100], sample_count = 5)]
fn doo_sabin(bencher: Bencher, n: u32) {
    let ring = parse_ring(&format!("doo-sabin:n={n}")).expect("a catalogue entry");
    bencher.bench(|| RingConstants::new(&ring, 5));
}
