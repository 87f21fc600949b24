//! The lines of a certificate of a depth.

use crate::decimal::{Q, bits, read_rational};
use crate::reject::{DepthReason, DepthRejection, Stop};
use num_traits::{Signed, Zero};

/// The first line.
const VERSION: &str = "subcert-depth 1";

/// The most bytes of a certificate.
const MAX_BYTES: usize = 4 << 20;

/// The most binary digits of the numerator and the denominator of a number. Those of doubles are fewer.
const MAX_BITS: u64 = 2_048;

/// The most points.
const MAX_POINTS: usize = 100_000;

/// The most coordinates of a point.
const MAX_DIMENSIONS: usize = 8;

/// The most rules of a direction, and the most coefficients of a rule.
const MAX_RULES: usize = 64;

/// The highest level that a certificate speaks of.
pub const MAX_LEVEL: u32 = 24;

/// One direction as it is given.
pub struct Given {
    pub line: usize,
    pub offset: i64,
    pub count: usize,
    /// The natural parameters between which sets are compared; `None` for a closed direction.
    pub range: Option<[Q; 2]>,
    pub rules: Vec<Vec<Q>>,
}

/// That a level is not enough: a point of one set is far from the other.
pub struct TooFew {
    pub line: usize,
    pub level: u32,
    pub of_limit: bool,
    /// The natural parameters of the point.
    pub at: Vec<Q>,
}

/// What a certificate says.
pub struct Certificate {
    pub tolerance: Q,
    pub directions: Vec<Given>,
    /// Row by row.
    pub points: Vec<Vec<Q>>,
    /// The level that is enough, and its line.
    pub enough: Option<(usize, u32)>,
    pub too_few: Vec<TooFew>,
    /// The line of `end`.
    pub end: usize,
}

type Read<T> = Result<T, DepthReason>;

fn malformed<T>(what: &'static str) -> Read<T> {
    Err(DepthReason::Malformed(what))
}

fn capped<T>(what: &'static str) -> Read<T> {
    Err(DepthReason::Stopped(Stop::Capped(what)))
}

fn numbers(words: &[&str]) -> Read<Vec<Q>> {
    let number = |word: &&str| match read_rational(word) {
        None => malformed("numbers"),
        Some(number) if bits(&number) > MAX_BITS => capped("2,048 binary digits of a number"),
        Some(number) => Ok(number),
    };
    words.iter().map(number).collect()
}

fn level(word: &str) -> Read<u32> {
    match word.parse() {
        Ok(level) if level <= MAX_LEVEL => Ok(level),
        Ok(_) => capped("levels up to 24"),
        Err(_) => malformed("a level"),
    }
}

impl Certificate {
    /// Reads a certificate.
    pub fn read(text: &str) -> Result<Certificate, DepthRejection> {
        let mut read = Certificate {
            tolerance: Q::zero(),
            directions: Vec::new(),
            points: Vec::new(),
            enough: None,
            too_few: Vec::new(),
            end: 0,
        };
        // The places of the kinds of lines in their order.
        let mut place = 0;
        if text.len() > MAX_BYTES {
            let reason = DepthReason::Stopped(Stop::Capped("4 MiB of text"));
            return Err(DepthRejection { line: 1, reason });
        }
        for (line, raw) in (1..).zip(text.lines()) {
            let reject = |reason| DepthRejection { line, reason };
            let words: Vec<&str> = raw.split_whitespace().collect();
            if line == 1 && raw.trim() != VERSION {
                return Err(reject(DepthReason::Version));
            }
            if read.end > 0 && !words.is_empty() && !words[0].starts_with('#') {
                return Err(reject(DepthReason::AfterEnd));
            }
            if line == 1 || words.is_empty() || words[0].starts_with('#') {
                continue;
            }
            read.take(line, &words, &mut place).map_err(reject)?;
        }
        let last = text.lines().count();
        if read.end == 0 {
            return Err(DepthRejection { line: last, reason: DepthReason::Truncated });
        }
        let shape = read.check_shape();
        shape.map_err(|reason| DepthRejection { line: read.end, reason }).map(|()| read)
    }

    fn take(&mut self, line: usize, words: &[&str], place: &mut usize) -> Read<()> {
        let kinds = ["tolerance", "direction", "rule", "point", "enough", "too-few", "end"];
        let kind = kinds.iter().position(|kind| *kind == words[0]);
        let kind = kind.ok_or(DepthReason::Malformed("a line of a known kind"))?;
        // A second direction comes after the rules of the first.
        let again = kind == 1 && *place == 2 && self.directions.len() == 1;
        let several = [2, 3, 5].contains(&kind) && kind == *place;
        if !again
            && !several
            && (kind < *place || kind == *place && (kind > 0 || !self.tolerance.is_zero()))
        {
            return Err(DepthReason::Order);
        }
        *place = kind;
        let rest = &words[1..];
        match kind {
            0 => match &numbers(rest)?[..] {
                [tolerance] if tolerance.is_positive() => self.tolerance = tolerance.clone(),
                _ => return malformed("tolerance NUMBER, positive"),
            },
            1 => self.directions.push(direction(line, rest)?),
            2 => match self.directions.last_mut() {
                Some(direction) if direction.rules.len() < MAX_RULES && rest.len() <= MAX_RULES => {
                    direction.rules.push(numbers(rest)?);
                }
                Some(_) => return capped("64 rules of 64 numbers"),
                None => return malformed("rule NUMBER…, after a direction"),
            },
            3 => {
                if self.points.len() == MAX_POINTS || rest.len() > MAX_DIMENSIONS {
                    return capped("100,000 points of 8 coordinates");
                }
                self.points.push(numbers(rest)?);
            }
            4 => match rest {
                [word] => self.enough = Some((line, level(word)?)),
                _ => return malformed("enough LEVEL"),
            },
            5 => {
                let (word, set, at) = match rest {
                    [word, set, at @ ..] if ["limit", "polygon"].contains(set) => (word, *set, at),
                    _ => return malformed("too-few LEVEL limit|polygon PARAMETER…"),
                };
                let (level, at) = (level(word)?, numbers(at)?);
                self.too_few.push(TooFew { line, level, of_limit: set == "limit", at });
            }
            _ if rest.is_empty() => self.end = line,
            _ => return malformed("end"),
        }
        Ok(())
    }

    fn check_shape(&self) -> Read<()> {
        if !self.tolerance.is_positive() || self.directions.is_empty() {
            return malformed("a tolerance, one direction or two, and points");
        }
        for Given { rules, .. } in &self.directions {
            let width = rules.first().map_or(0, Vec::len);
            if rules.len() < 2 || width == 0 || rules.iter().any(|rule| rule.len() != width) {
                return malformed("two rules or more of one length for each direction");
            }
        }
        let count = self.directions.iter().try_fold(1_usize, |all, it| all.checked_mul(it.count));
        if self.points.is_empty() || count != Some(self.points.len()) {
            return malformed("as many points as the directions have");
        }
        let dimensions = self.points[0].len();
        if dimensions == 0 || self.points.iter().any(|point| point.len() != dimensions) {
            return malformed("points with as many coordinates each");
        }
        if self.too_few.iter().any(|far| far.at.len() != self.directions.len()) {
            return malformed("one parameter for each direction");
        }
        if self.enough.is_none() && self.too_few.is_empty() {
            return Err(DepthReason::Empty);
        }
        Ok(())
    }
}

fn direction(line: usize, words: &[&str]) -> Read<Given> {
    let shape = "direction OFFSET COUNT closed, or direction OFFSET COUNT FROM TO";
    let [offset, count, rest @ ..] = words else { return malformed(shape) };
    let offset = offset.parse().ok().filter(|offset: &i64| offset.abs() <= 1_000);
    let count = count.parse().ok().filter(|count| (1..=MAX_POINTS).contains(count));
    let (Some(offset), Some(count)) = (offset, count) else { return malformed(shape) };
    let range = match rest {
        ["closed"] => None,
        [_, _] => match &numbers(rest)?[..] {
            [from, to] if from < to => Some([from.clone(), to.clone()]),
            _ => return malformed("a range whose second end is greater"),
        },
        _ => return malformed(shape),
    };
    Ok(Given { line, offset, count, range, rules: Vec::new() })
}
