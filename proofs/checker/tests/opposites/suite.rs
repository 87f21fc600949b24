//! Pairs of claims, and certificates of each that are made of the valid ones of both.

use super::mutator::{Random, mutant};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};
use subcert_check::{Outcome, Report, check};

/// The longest time that a few hundred blocks take.
const LONGEST: Duration = Duration::from_secs(15);

/// What is false of the lines of a block that was accepted.
pub type Falsehood = Box<dyn Fn(&[String]) -> Option<String>>;

/// A claim of a file.
pub struct Claim {
    /// `smoothness ID`.
    pub head: String,
    /// The lines that repeat texts of the claim file.
    pub restated: Vec<String>,
    /// What follows them in certificates that are valid, or nearly so.
    pub seeds: Vec<Vec<String>>,
    /// Last lines that say what is false.
    pub lies: Vec<String>,
    /// What stands in certificates of the opposite where this claim has something else.
    pub replaced: [String; 2],
    /// What is false of an accepted block.
    pub falsehood: Falsehood,
}

impl Claim {
    fn id(&self) -> &str {
        self.head.split_once(' ').map_or("", |(_, id)| id)
    }
}

/// A claim and its opposite. Both are never true; with `complementary`, one is.
pub struct Pair {
    /// The two claims.
    pub claims: [Claim; 2],
    /// Whether both cannot be true.
    pub exclusive: bool,
    /// Whether both cannot be false.
    pub complementary: bool,
}

/// A claim file, and pairs of its claims.
pub struct Suite {
    /// The second line of certificates, such as `paper rules`.
    pub about: &'static str,
    /// The claim file.
    pub claims: String,
    /// The pairs.
    pub pairs: Vec<Pair>,
}

/// What a run found.
#[derive(Default, Debug)]
pub struct Found {
    /// The pairs that were tried.
    pub tried: usize,
    /// The claims that one of their own seeds proves.
    pub proved: usize,
    /// The blocks that were accepted.
    pub accepted: usize,
    /// What is wrong.
    pub wrong: Vec<String>,
}

/// Whether the last line of a block says that its claim is true or false.
fn verdict(block: &[String]) -> Option<bool> {
    match block.last()?.split_whitespace().next()? {
        "confirmed" | "holds" | "exact" | "proved" => Some(true),
        "refuted" | "fails" | "inexact" | "case" => Some(false),
        _ => None,
    }
}

impl Suite {
    fn certificate(&self, claim: &Claim, body: &[String]) -> (String, Vec<String>) {
        let lines: Vec<String> = claim.restated.iter().chain(body).cloned().collect();
        let head = &claim.head;
        (
            format!(
                "subcert-certificate 4\n{}\n{head}\n  {}\nend 1\n",
                self.about,
                lines.join("\n  ")
            ),
            lines,
        )
    }

    /// The seeds of each pair's claims that are valid.
    fn valid(&self) -> Vec<[Vec<Vec<String>>; 2]> {
        let valid = |claim: &Claim| {
            let is_valid = |seed: &&Vec<String>| {
                let (text, _) = self.certificate(claim, seed);
                is_accepted(&check(&self.claims, &[&text]).expect("a claim file"), claim)
            };
            claim.seeds.iter().filter(is_valid).cloned().collect()
        };
        self.pairs.iter().map(|pair| pair.claims.each_ref().map(valid)).collect()
    }

    /// Gives each claim so many certificates.
    pub fn run(&self, random: &mut Random, rounds: usize) -> Found {
        let valid = self.valid();
        let proved = valid.iter().flatten().filter(|valid| !valid.is_empty()).count();
        let mut found = Found { proved, ..Found::default() };
        let mut seen = vec![[[false; 2]; 2]; self.pairs.len()];
        for round in 0..rounds {
            let mut blocks = Vec::new();
            for (place, pair) in self.pairs.iter().enumerate() {
                for (side, claim) in pair.claims.iter().enumerate() {
                    let body = self.body(random, (pair, &valid[place]), side, round);
                    blocks.push((place, side, claim, self.certificate(claim, &body)));
                }
            }
            found.tried += self.pairs.len();
            let texts: Vec<&str> = blocks.iter().map(|(.., (text, _))| &text[..]).collect();
            let begin = Instant::now();
            let report = catch_unwind(AssertUnwindSafe(|| check(&self.claims, &texts)));
            let took = begin.elapsed();
            let Ok(report) = report else {
                found.wrong.extend(self.panics(&texts));
                break;
            };
            if took > LONGEST {
                found.wrong.extend(self.slow(&texts));
                break;
            }
            let report = report.expect("a claim file");
            for (place, side, claim, (text, lines)) in &blocks {
                if !is_accepted(&report, claim) {
                    continue;
                }
                found.accepted += 1;
                if let Some(why) = (claim.falsehood)(lines) {
                    found.wrong.push(format!("accepted, but {why}:\n{text}"));
                }
                if let Some(is_true) = verdict(lines) {
                    let seen = &mut seen[*place];
                    seen[*side][usize::from(is_true)] = true;
                    let pair = &self.pairs[*place];
                    let both = |truth: usize| seen[0][truth] && seen[1][truth];
                    let contradicts = seen.iter().any(|seen| seen[0] && seen[1])
                        || pair.exclusive && both(1)
                        || pair.complementary && both(0);
                    if contradicts {
                        found
                            .wrong
                            .push(format!("this contradicts what was accepted before:\n{text}"));
                        *seen = [[false; 2]; 2];
                    }
                }
            }
            if found.wrong.len() > 20 {
                break;
            }
        }
        found
    }

    /// What follows the repeated lines: a seed of the claim or of its opposite, with changes. Every other
    /// one is valid for one of them.
    fn body(
        &self,
        random: &mut Random,
        (pair, valid): (&Pair, &[Vec<Vec<String>>; 2]),
        side: usize,
        round: usize,
    ) -> Vec<String> {
        let other = &pair.claims[1 - side].seeds;
        let elsewhere = &random.one(&self.pairs).claims[random.below(2)].seeds;
        let mut all =
            [&pair.claims[side].seeds, other, other, elsewhere].map(|seeds| random.one_of(seeds));
        for (own, valid) in all.iter_mut().zip([&valid[side], &valid[1 - side]]) {
            if !valid.is_empty() && random.once_in(2) {
                own.clone_from(random.one(valid));
            }
        }
        // The first rounds try the seeds as they are.
        let from = all[random.below(2)].clone();
        let mut body = from.clone();
        if round > 1 && !random.once_in(8) {
            let other = random.below(4);
            body = mutant(random, &from, &all[other]);
        }
        let [theirs, own] = &pair.claims[side].replaced;
        if !theirs.is_empty() {
            for line in &mut body {
                *line = line.replace(&theirs[..], own);
            }
        }
        let lies = &pair.claims[side].lies;
        if !lies.is_empty() && !body.is_empty() && !random.once_in(3) {
            let last = body.len() - 1;
            body[last].clone_from(random.one(lies));
        }
        body
    }

    fn panics(&self, texts: &[&str]) -> Vec<String> {
        let panics =
            |text: &&&str| catch_unwind(AssertUnwindSafe(|| check(&self.claims, &[text]))).is_err();
        let found = texts.iter().filter(panics).map(|text| format!("a panic:\n{text}"));
        found.chain(["the checker panics".to_owned()]).collect()
    }

    fn slow(&self, texts: &[&str]) -> Vec<String> {
        let time = |text: &&str| {
            let begin = Instant::now();
            let _ = check(&self.claims, &[text]);
            begin.elapsed()
        };
        let slowest = texts.iter().map(|text| (time(text), text)).max();
        slowest.map(|(time, text)| format!("{time:?} for:\n{text}")).into_iter().collect()
    }
}

impl Random {
    /// One of these, or nothing.
    fn one_of(&mut self, seeds: &[Vec<String>]) -> Vec<String> {
        if seeds.is_empty() { Vec::new() } else { self.one(seeds).clone() }
    }
}

fn is_accepted(report: &Report, claim: &Claim) -> bool {
    let accepts = |outcome: &Outcome| matches!(outcome, Outcome::Valid | Outcome::Cited(_));
    report.claims.iter().any(|(_, id, outcome)| id == claim.id() && accepts(outcome))
}
