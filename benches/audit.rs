//! The whole audit of the embedded papers, and its parts.

use divan::Bencher;
use subcert::audit::audit;
use subcert::claim::{Paper, embedded_papers};

fn main() {
    divan::main();
}

fn papers() -> Vec<Paper> {
    embedded_papers().expect("the embedded claim files")
}

#[divan::bench]
fn read_the_claim_files() -> Vec<Paper> {
    papers()
}

#[divan::bench]
fn judge_every_claim(bencher: Bencher) {
    let papers = papers();
    bencher.bench(|| papers.iter().map(|paper| audit(paper).is_ok()).filter(|ok| *ok).count());
}

#[divan::bench]
fn whole() -> usize {
    let papers = papers();
    papers.iter().map(|paper| audit(paper).expect("no wrong formula").tables.len()).sum()
}
