//! The lines of a certificate of a depth.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Q, bits, capped as within, read_rational};
use crate::text::{
    At, DepthChecked as Checked, DepthReason, DepthRejection, Line, Stop, alone, require,
};
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

fn malformed<T>(what: &'static str) -> Checked<T> {
    Err(DepthReason::Malformed(what).into())
}

fn capped(what: &'static str) -> DepthReason {
    DepthReason::Stopped(Stop::Capped(what))
}

fn numbers(words: &[&str]) -> Checked<Vec<Q>> {
    let number = |word: &&str| match read_rational(word) {
        None => malformed("numbers"),
        Some(number) if bits(&number) > MAX_BITS => {
            Err(capped("2,048 binary digits of a number").into())
        }
        Some(number) => Ok(number),
    };
    words.iter().map(number).collect()
}

fn level(word: &str) -> Checked<u32> {
    match word.parse() {
        Ok(level) if level <= MAX_LEVEL => Ok(level),
        Ok(_) => Err(capped("levels up to 24").into()),
        Err(_) => malformed("a level"),
    }
}

impl Certificate {
    /// Reads a certificate.
    pub fn read(text: &str) -> Checked<Certificate> {
        let mut read = Certificate {
            tolerance: Q::zero(),
            directions: Vec::new(),
            points: Vec::new(),
            enough: None,
            too_few: Vec::new(),
            end: 0,
        };
        require(text.len() <= MAX_BYTES, capped("4 MiB of text")).at(1)?;
        let version = text.lines().next().is_none_or(|line| line.trim() == VERSION);
        require(version, DepthReason::Version).at(1)?;
        // The place of the kind of a line in their order.
        let mut place = 0;
        for Line { number, text } in alone(text) {
            require(read.end == 0, DepthReason::AfterEnd).at(number)?;
            let words: Vec<&str> = text.split_whitespace().collect();
            read.take(number, &words, &mut place).at(number)?;
        }
        if read.end == 0 {
            let (line, reason) = (text.lines().count(), DepthReason::Truncated);
            return Err(DepthRejection { line, reason });
        }
        read.check_shape().at(read.end).map(|()| read)
    }

    fn take(&mut self, line: usize, words: &[&str], place: &mut usize) -> Checked<()> {
        let kinds = ["tolerance", "direction", "rule", "point", "enough", "too-few", "end"];
        let kind = kinds.iter().position(|kind| *kind == words[0]);
        let kind = kind.ok_or(DepthReason::Malformed("a line of a known kind"))?;
        // A second direction comes after the rules of the first.
        let again = kind == 1 && *place == 2 && self.directions.len() == 1;
        let several = [2, 3, 5].contains(&kind) && kind == *place;
        let first = kind == 0 && *place == 0 && self.tolerance.is_zero();
        require(again || several || first || kind > *place, DepthReason::Order)?;
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
                Some(_) => return Err(capped("64 rules of 64 numbers").into()),
                None => return malformed("rule NUMBER…, after a direction"),
            },
            3 => {
                let fits = self.points.len() < MAX_POINTS && rest.len() <= MAX_DIMENSIONS;
                require(fits, capped("100,000 points of 8 coordinates"))?;
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

    fn check_shape(&self) -> Checked<()> {
        let shape = |holds, what| require(holds, DepthReason::Malformed(what));
        let some = self.tolerance.is_positive() && !self.directions.is_empty();
        shape(some, "a tolerance, one direction or two, and points")?;
        for Given { rules, .. } in &self.directions {
            let width = rules.first().map_or(0, Vec::len);
            let even = rules.len() >= 2 && width > 0 && rules.iter().all(|it| it.len() == width);
            shape(even, "two rules or more of one length for each direction")?;
        }
        let count = self.directions.iter().try_fold(1_usize, |all, it| all.checked_mul(it.count));
        let all = !self.points.is_empty() && count == Some(self.points.len());
        shape(all, "as many points as the directions have")?;
        let dimensions = self.points[0].len();
        let even = dimensions > 0 && self.points.iter().all(|point| point.len() == dimensions);
        shape(even, "points with as many coordinates each")?;
        let places = self.too_few.iter().all(|far| far.at.len() == self.directions.len());
        shape(places, "one parameter for each direction")?;
        require(self.enough.is_some() || !self.too_few.is_empty(), DepthReason::Empty)
    }
}

fn direction(line: usize, words: &[&str]) -> Checked<Given> {
    let shape = "direction OFFSET COUNT closed, or direction OFFSET COUNT FROM TO";
    let [offset, count, rest @ ..] = words else { return malformed(shape) };
    let offset = offset.parse().ok().and_then(|offset: i64| within(offset, 1_000));
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
