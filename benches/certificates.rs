//! Certificates of the embedded papers: what writing them costs, and what checking them does.

use divan::Bencher;
use std::time::{Duration, Instant};
use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::{Paper, embedded_papers};

/// How often both are run, in turn.
const RUNS: usize = 7;

fn main() {
    let papers = papers();
    let (mut writer, mut checker, mut valid) = (Duration::MAX, Duration::MAX, 0);
    for _ in 0..RUNS {
        let (written, writing) = timed(|| write(&papers));
        let (found, checking) = timed(|| check(&papers, &written));
        (writer, checker, valid) = (writer.min(writing), checker.min(checking), found);
    }
    let share = checker.as_secs_f64() / writer.as_secs_f64();
    println!(
        "{valid} claims: written in {writer:.2?}, checked in {checker:.2?}, {share:.2} times that"
    );
    divan::main();
}

fn timed<T>(run: impl FnOnce() -> T) -> (T, Duration) {
    let start = Instant::now();
    (run(), start.elapsed())
}

fn papers() -> Vec<Paper> {
    embedded_papers().expect("the embedded claim files")
}

/// The certificates of all papers, from their audits.
fn write(papers: &[Paper]) -> Vec<String> {
    let text = |paper| certificate(&audit(paper).expect("no wrong formula")).text;
    papers.iter().map(text).collect()
}

/// How many claims they prove.
fn check(papers: &[Paper], certificates: &[String]) -> usize {
    let valid = |(paper, certificate): (&Paper, &String)| {
        let report = subcert_check::check(&paper.source.text, &[certificate]);
        let claims = report.expect("a claim file").claims;
        claims.iter().filter(|(.., outcome)| *outcome == subcert_check::Outcome::Valid).count()
    };
    papers.iter().zip(certificates).map(valid).sum()
}

#[divan::bench(sample_count = 3)]
fn writer(bencher: Bencher) {
    let papers = papers();
    bencher.bench(|| write(&papers));
}

#[divan::bench(sample_count = 10)]
fn checker(bencher: Bencher) {
    let papers = papers();
    let written = write(&papers);
    bencher.bench(|| check(&papers, &written));
}
