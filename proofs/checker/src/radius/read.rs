//! The lines of a certificate of a joint spectral radius.

use super::matrices::Matrix;
use crate::decimal::{Q, int, read_rational};
use crate::polynomial::divide;
use crate::reject::{RadiusReason, RadiusRejection};
use num_traits::{One, Signed, Zero};

/// The first line.
const VERSION: &str = "subcert-radius 1";

/// The most rows of a matrix, and the most matrices.
const MAX_SIZE: usize = 64;

/// The most bytes of a certificate.
const MAX_BYTES: usize = 64 << 20;

/// An eigenvalue of a product.
pub struct Lower {
    pub line: usize,
    pub product: Vec<usize>,
    pub bound: Q,
    pub negative: bool,
    pub conjugate: bool,
}

impl Lower {
    /// The radius to this power is at least the bound.
    pub fn degree(&self) -> usize {
        self.product.len() * if self.conjugate { 2 } else { 1 }
    }
}

/// A number and the line where it stands.
pub type Said = (usize, usize);

/// What a certificate says.
pub struct Certificate {
    /// The rules of a mask.
    pub rules: Vec<(usize, Vec<Q>)>,
    /// The order of the differences.
    pub order: Option<Said>,
    /// The matrices, where there is no mask.
    given: Vec<(usize, Matrix)>,
    pub lower: Option<Lower>,
    pub bound: Q,
    pub unit: Q,
    pub rows: Vec<(usize, Vec<Q>)>,
    /// For each row and matrix the places of rows, and the coefficients.
    pub images: Vec<(usize, Vec<(usize, Q)>)>,
    pub continuous: Option<Said>,
    pub not_continuous: Option<Said>,
    /// The last line.
    pub end: usize,
}

type Read<T> = Result<T, RadiusReason>;

fn numbers(text: &str) -> Read<Vec<Q>> {
    let number = |word| read_rational(word).ok_or(RadiusReason::Malformed("numbers"));
    text.split_whitespace().map(number).collect()
}

fn count(text: &str) -> Read<usize> {
    text.parse().map_err(|_| RadiusReason::Malformed("a count"))
}

fn positive(text: &str) -> Read<Q> {
    let number = read_rational(text).filter(Q::is_positive);
    number.ok_or(RadiusReason::Malformed("a positive number"))
}

impl Certificate {
    /// Reads a certificate.
    pub fn read(text: &str) -> Result<Certificate, RadiusRejection> {
        let mut read = Certificate::of(Vec::new());
        let mut ended = text.len() > MAX_BYTES;
        let mut place = 1;
        for (line, raw) in (1..).zip(text.lines()) {
            let words = raw.trim();
            let reject = |reason| RadiusRejection { line, reason };
            if line == 1 && words != VERSION {
                return Err(reject(RadiusReason::Version));
            }
            if line == 1 || words.is_empty() || words.starts_with('#') {
                continue;
            }
            if ended {
                return Err(reject(RadiusReason::AfterEnd));
            }
            place = line;
            ended = words == "end";
            if !ended {
                read.take(line, words).map_err(reject)?;
            }
        }
        read.finished(ended, place)
    }

    /// Reads the numbered lines of a certificate about these rules, without rules, matrices and `end`,
    /// which is the line `end`.
    pub fn embedded(
        rules: Vec<(usize, Vec<Q>)>,
        lines: &[(usize, &str)],
        end: usize,
    ) -> Result<Certificate, RadiusRejection> {
        let mut read = Certificate::of(rules);
        for &(line, words) in lines {
            let own = words.starts_with("rule") || words.starts_with("matrix");
            let reason = RadiusReason::Malformed("no rules, which are those of the claim");
            let taken = if own { Err(reason) } else { read.take(line, words) };
            taken.map_err(|reason| RadiusRejection { line, reason })?;
        }
        let read = read.finished(true, end)?;
        let reason = RadiusReason::Malformed("the order of the sum rules");
        let order = read.order.is_some();
        if order { Ok(read) } else { Err(RadiusRejection { line: end, reason }) }
    }

    /// A certificate that says nothing about these rules.
    fn of(rules: Vec<(usize, Vec<Q>)>) -> Certificate {
        Certificate {
            rules,
            order: None,
            given: Vec::new(),
            lower: None,
            bound: Q::zero(),
            unit: Q::zero(),
            rows: Vec::new(),
            images: Vec::new(),
            continuous: None,
            not_continuous: None,
            end: 0,
        }
    }

    fn finished(mut self, ended: bool, place: usize) -> Result<Certificate, RadiusRejection> {
        self.end = place;
        let whole = ended && self.bound.is_positive() && self.unit.is_positive();
        let reason = RadiusReason::Truncated;
        if whole { Ok(self) } else { Err(RadiusRejection { line: place, reason }) }
    }

    fn take(&mut self, line: usize, words: &str) -> Read<()> {
        let (word, rest) = words.split_once(' ').unwrap_or((words, ""));
        match word {
            "rule" => self.rules.push((line, numbers(rest)?)),
            "order" => self.order = Some((line, count(rest)?)),
            "matrix" => {
                let matrix = rest.split('|').map(numbers).collect::<Read<Matrix>>()?;
                self.given.push((line, matrix));
            }
            "product" => {
                let product = rest.split_whitespace().map(count).collect::<Read<Vec<usize>>>()?;
                let bound = Q::zero();
                let lower = Lower { line, product, bound, negative: false, conjugate: false };
                self.lower = Some(lower);
            }
            "eigenvalue" => {
                let lower = self.lower.as_mut().ok_or(RadiusReason::Malformed("a product"))?;
                let (kind, bound) = rest.split_once(' ').unwrap_or((rest, ""));
                (lower.negative, lower.conjugate) = match kind {
                    "positive" => (false, false),
                    "negative" => (true, false),
                    "conjugate" => (false, true),
                    _ => return Err(RadiusReason::Malformed("positive, negative or conjugate")),
                };
                (lower.line, lower.bound) = (line, positive(bound)?);
            }
            "at-most" => self.bound = positive(rest)?,
            "unit" => self.unit = positive(rest)?,
            "row" => self.rows.push((line, numbers(rest)?)),
            "image" => {
                let term = |term: &str| {
                    let (place, factor) = term.split_once(':').unwrap_or((term, ""));
                    let factor =
                        read_rational(factor).ok_or(RadiusReason::Malformed("a factor"))?;
                    Ok((count(place)?, factor))
                };
                let terms = rest.split_whitespace().map(term).collect::<Read<Vec<_>>>()?;
                self.images.push((line, terms));
            }
            "continuous" => self.continuous = Some((line, count(rest)?)),
            "not-continuous" => self.not_continuous = Some((line, count(rest)?)),
            _ => return Err(RadiusReason::Malformed("a line of this format")),
        }
        Ok(())
    }

    /// The coefficients a_0, a_1, … of the symbol of the mask, from the lowest power.
    pub fn symbol(&self) -> Vec<Q> {
        let width = self.rules.first().map_or(0, |(_, rule)| rule.len());
        let places = (0..width).rev().flat_map(|j| self.rules.iter().map(move |rule| (j, rule)));
        places.map(|(j, (_, rule))| rule[j].clone()).collect()
    }

    /// The matrices that the certificate is about.
    pub fn matrices(&self) -> Result<Vec<Matrix>, RadiusRejection> {
        let Some((line, order)) = self.order else {
            let size = self.given.first().map_or(0, |(_, matrix)| matrix.len());
            let square = |matrix: &Matrix| {
                matrix.len() == size && matrix.iter().all(|row| row.len() == size)
            };
            let wrong = self.given.iter().find(|(_, matrix)| !square(matrix));
            let beyond = size == 0 || size > MAX_SIZE || self.given.len() > MAX_SIZE;
            let reason = RadiusReason::Size;
            return match wrong {
                Some((line, _)) => Err(RadiusRejection { line: *line, reason }),
                None if beyond => Err(RadiusRejection { line: self.end, reason }),
                None => Ok(self.given.iter().map(|(_, matrix)| matrix.clone()).collect()),
            };
        };
        let n = self.rules.len();
        let width = self.rules.first().map_or(0, |(_, rule)| rule.len());
        for (line, rule) in &self.rules {
            let affine = rule.iter().fold(Q::zero(), |sum, x| sum + x) == Q::one();
            if rule.len() != width || !affine {
                return Err(RadiusRejection { line: *line, reason: RadiusReason::Rule });
            }
        }
        if !(2..=MAX_SIZE).contains(&n) || width * n > 4 * MAX_SIZE || order > width * n {
            return Err(RadiusRejection { line, reason: RadiusReason::Size });
        }
        let sigma = vec![Q::one(); n];
        let mut rest = self.symbol();
        for _ in 0..order {
            let (quotient, remainder) = divide(rest, &sigma);
            if remainder.iter().any(|x| !x.is_zero()) {
                return Err(RadiusRejection { line, reason: RadiusReason::SumRules });
            }
            rest = quotient.into_iter().map(|x| x * int(i64::try_from(n).unwrap_or(0))).collect();
        }
        Ok(windows(&rest, n))
    }
}

/// The matrices of a scheme with this symbol and n rules on windows: b_{L−n+1+e+i−nj}.
fn windows(symbol: &[Q], n: usize) -> Vec<Matrix> {
    let start = symbol.iter().position(|b| !b.is_zero()).unwrap_or(0);
    let last = symbol.iter().rposition(|b| !b.is_zero()).unwrap_or(0);
    let b = &symbol[start..=last];
    let degree = b.len() - 1;
    let width = if degree == 0 { 1 } else { (degree - 1).div_ceil(n - 1) + 1 };
    let entry = |e: usize, i: usize, j: usize| {
        let place = (degree + 1 + e + i).checked_sub(n * (j + 1));
        place.and_then(|place| b.get(place)).cloned().unwrap_or_else(Q::zero)
    };
    let row = |e, i| (0..width).map(|j| entry(e, i, j)).collect();
    (0..n).map(|e| (0..width).map(|i| row(e, i)).collect()).collect()
}
