//! Certificates that someone might make of valid ones: lines and numbers changed, left out, repeated and
//! exchanged, and parts of one certificate in another.

use crate::altered::WORDS;

/// Where the random numbers begin, if the environment does not say.
const SEED: u64 = 0x0dd5_0b1e_c7ed_5eed;

/// Random numbers. The variable `OPPOSITES_SEED` says where they begin.
pub struct Random(u64);

impl Random {
    /// Numbers for the test of this name.
    pub fn new(test: &str) -> Random {
        let seed = std::env::var("OPPOSITES_SEED").ok().and_then(|seed| seed.parse().ok());
        let begin: u64 = seed.unwrap_or(SEED);
        Random(
            test.bytes().fold(begin | 1, |state, b| state.wrapping_mul(31).wrapping_add(b.into())),
        )
    }

    /// A number less than this.
    pub fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) % count.max(1) as u64).unwrap_or(0)
    }

    /// A whole number from `low` to `high`.
    pub fn within(&mut self, low: i64, high: i64) -> i64 {
        low + i64::try_from(self.below(usize::try_from(high - low + 1).unwrap_or(1))).unwrap_or(0)
    }

    /// Whether something happens that does so once in `times`.
    pub fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == 0
    }

    /// One of these.
    pub fn one<'t, T>(&mut self, of: &'t [T]) -> &'t T {
        &of[self.below(of.len())]
    }
}

/// The lines of a certificate after one to three changes. `other` is another certificate.
pub fn mutant(random: &mut Random, own: &[String], other: &[String]) -> Vec<String> {
    let mut lines = own.to_vec();
    for _ in 0..=random.below(3) {
        change(random, &mut lines, other);
    }
    lines
}

fn change(random: &mut Random, lines: &mut Vec<String>, other: &[String]) {
    if lines.is_empty() {
        lines.extend_from_slice(other);
        return;
    }
    let at = random.below(lines.len());
    match random.below(15) {
        0 => _ = lines.remove(at),
        1 => lines.insert(at, lines[at].clone()),
        2 => {
            let with = random.below(lines.len());
            lines.swap(at, with);
        }
        3 => lines[at] = lines[at].split_whitespace().take(1).collect(),
        4 => {
            let to = at + random.below(lines.len() - at);
            lines.drain(at..to);
        }
        5 if !other.is_empty() => {
            let from = random.below(other.len());
            lines.truncate(at);
            lines.extend_from_slice(&other[from..]);
        }
        6 if !other.is_empty() => lines.insert(at, random.one(other).clone()),
        7 => lines.splice(at..at, other.iter().cloned()).for_each(drop),
        8 => {
            // The other certificate's line of this kind.
            let word = lines[at].split(' ').next().unwrap_or_default().to_owned();
            let same: Vec<&String> =
                other.iter().filter(|line| line.split(' ').next() == Some(&word)).collect();
            if !same.is_empty() {
                lines[at].clone_from(same[random.below(same.len())]);
            }
        }
        9 | 10 => lines[at] = words(random, &lines[at]),
        _ => lines[at] = numbers(random, &lines[at]),
    }
}

/// A line with a word changed, left out or repeated.
fn words(random: &mut Random, line: &str) -> String {
    let mut words: Vec<&str> = line.split_whitespace().collect();
    let at = random.below(words.len());
    let known: Vec<_> =
        WORDS.iter().filter(|group| words.get(at).is_some_and(|w| group.contains(w))).collect();
    match random.below(4) {
        _ if words.is_empty() => {}
        0 => _ = words.remove(at),
        1 => words.insert(at, words[at]),
        _ if !known.is_empty() => {
            let group = known[random.below(known.len())];
            words[at] = group[random.below(group.len())];
        }
        _ => {
            let with = random.below(words.len());
            words.swap(at, with);
        }
    }
    words.join(" ")
}

/// A line with one of its numbers changed.
fn numbers(random: &mut Random, line: &str) -> String {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '/' | '-');
    let mut places = Vec::new();
    let mut rest = 0;
    while let Some(from) = line[rest..].find(is_part).map(|from| rest + from) {
        let to = line[from..].find(|c| !is_part(c)).map_or(line.len(), |to| from + to);
        places.push((from, to));
        rest = to;
    }
    if places.is_empty() {
        return words(random, line);
    }
    let (from, to) = *random.one(&places);
    format!("{}{}{}", &line[..from], number(random, &line[from..to]), &line[to..])
}

/// Another number.
fn number(random: &mut Random, text: &str) -> String {
    let whole: Option<i64> = text.parse().ok();
    let huge = format!("1{}", "0".repeat(40));
    let (top, bottom) = text.split_once('/').unwrap_or((text, "1"));
    match (random.below(16), whole) {
        (0, _) => "0".to_owned(),
        (1, _) => "-1".to_owned(),
        (2, _) => "1".to_owned(),
        (3, _) => "2".to_owned(),
        (4, _) => huge,
        (5, _) => "1/0".to_owned(),
        (6, _) => "2/4".to_owned(),
        (7, _) => text.strip_prefix('-').map_or(format!("-{text}"), str::to_owned),
        (8, _) => format!("{top}/{bottom}0"),
        (9, _) => format!("{bottom}/{}", top.trim_start_matches('-')),
        (10, _) => format!("1/{huge}"),
        (11, _) => text.replacen(|c: char| c.is_ascii_digit(), &random.below(10).to_string(), 1),
        (12 | 13, Some(n)) => (n.saturating_add(1)).to_string(),
        (14, Some(n)) => (n.saturating_sub(1)).to_string(),
        (15, Some(n)) => (n / 2).to_string(),
        _ => {
            let digits: Vec<usize> =
                text.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(i, _)| i).collect();
            if digits.is_empty() {
                return text.to_owned();
            }
            let at = *random.one(&digits);
            format!("{}{}{}", &text[..at], random.below(10), &text[at + 1..])
        }
    }
}
