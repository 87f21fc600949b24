//! The lines of a certificate of a joint spectral radius.

use super::blocks::Blocks;
use super::field::Field;
use crate::numbers::{Q, read_rational};
use crate::text::{At, Line, RadiusChecked as Checked, RadiusReason, Stop, alone, require};
use num_traits::{Signed, Zero};
use std::rc::Rc;

/// The first line.
const VERSION: &str = "subcert-radius 1";

/// The greatest degree of the polynomial of a field.
const MAX_DEGREE: usize = 64;

/// The most bytes of a certificate.
const MAX_BYTES: usize = 6 << 20;

/// The lines in their order, and whether there may be several of a kind.
const LINES: [(&str, bool); 16] = [
    ("field", false),
    ("between", false),
    ("rule", true),
    ("order", false),
    ("matrix", true),
    ("basis", false),
    ("inverse", false),
    ("blocks", false),
    ("product", false),
    ("eigenvalue", false),
    ("at-most", false),
    ("unit", false),
    ("row", true),
    ("image", true),
    ("continuous", false),
    ("not-continuous", false),
];

/// Whether a line that begins with this word bounds the radius of given matrices.
pub fn is_bound(word: &str) -> bool {
    let place = |word: &str| LINES.iter().position(|(known, _)| *known == word);
    place("basis") <= place(word) && place(word) < place("continuous")
}

/// Which eigenvalue of a product reaches a bound.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Leading {
    Positive,
    Negative,
    /// One of any argument, with its modulus.
    Modulus,
}

/// Whether a line that begins with this word says in which basis matrices are block triangular.
pub fn is_basis(word: &str) -> bool {
    ["basis", "inverse", "blocks"].contains(&word)
}

/// An eigenvalue of a product. The radius to the number of factors is at least the bound.
pub struct Lower {
    pub line: usize,
    pub product: Vec<usize>,
    pub bound: Q,
    pub kind: Leading,
}

/// A number and the line where it stands.
pub type Said = (usize, usize);

/// The coordinates of a number in the basis 1, α, α², …
pub type Coordinates = Vec<Q>;

/// What a certificate says.
pub struct Certificate {
    /// The polynomial of α.
    polynomial: Vec<Q>,
    /// The field of the entries, if they are irrational.
    pub field: Option<Rc<Field>>,
    /// The rules of a mask.
    pub rules: Vec<(usize, Vec<Coordinates>)>,
    /// The order of the differences.
    pub order: Option<Said>,
    /// The matrices, where there is no mask.
    pub given: Vec<(usize, Vec<Vec<Coordinates>>)>,
    /// A basis in which they are block triangular.
    pub blocks: Blocks,
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
    /// The place in [`LINES`] from which the next line has to come.
    next: usize,
}

fn numbers(text: &str) -> Checked<Vec<Q>> {
    let number = |word| Ok(read_rational(word).ok_or(RadiusReason::Malformed("numbers"))?);
    text.split_whitespace().map(number).collect()
}

fn square(text: &str) -> Checked<Vec<Vec<Q>>> {
    text.split('|').map(numbers).collect()
}

fn count(text: &str) -> Checked<usize> {
    Ok(text.parse().map_err(|_| RadiusReason::Malformed("a count"))?)
}

fn positive(text: &str) -> Checked<Q> {
    let number = read_rational(text).filter(Q::is_positive);
    Ok(number.ok_or(RadiusReason::Malformed("a positive number"))?)
}

impl Certificate {
    /// Reads a certificate.
    pub fn read(text: &str) -> Checked<Certificate> {
        if text.len() > MAX_BYTES {
            return Err(Stop::Capped("6 MiB of a certificate of a radius").into()).at(1);
        }
        let version = text.lines().next().is_none_or(|line| line.trim() == VERSION);
        require(version, RadiusReason::Version).at(1)?;
        let mut read = Certificate::of(Vec::new());
        let (mut ended, mut place) = (false, 1);
        for Line { number, text } in alone(text) {
            require(!ended, RadiusReason::AfterEnd).at(number)?;
            (place, ended) = (number, text == "end");
            if !ended {
                read.take(number, text).at(number)?;
            }
        }
        read.finished(ended, place)
    }

    /// Reads the lines of a certificate about these rules, without rules, matrices and `end`, which is
    /// the line `end`.
    pub fn embedded(
        rules: Vec<(usize, Vec<Coordinates>)>,
        lines: &[Line<'_>],
        end: usize,
    ) -> Checked<Certificate> {
        let mut read = Certificate::of(rules);
        for line in lines {
            let given = ["rule", "matrix", "field", "between"];
            let own = given.iter().any(|word| line.text.starts_with(word));
            let rules = RadiusReason::Malformed("no rules, which are those of the claim");
            require(!own, rules).and_then(|()| read.take(line.number, line.text)).at(line.number)?;
        }
        let read = read.finished(true, end)?;
        let order = RadiusReason::Malformed("the order of the sum rules");
        require(read.order.is_some(), order).at(end).map(|()| read)
    }

    /// Reads the lines that bound the radius of matrices which are known. The last one is `end`.
    pub fn bounds(lines: &[Line<'_>], end: usize) -> Checked<Certificate> {
        let mut read = Certificate::of(Vec::new());
        for line in lines {
            let own = is_bound(line.text.split(' ').next().unwrap_or_default());
            let other = RadiusReason::Malformed("bounds alone");
            require(own, other).and_then(|()| read.take(line.number, line.text)).at(line.number)?;
        }
        read.finished(true, end)
    }

    /// Reads the lines of a basis alone.
    pub fn basis(lines: &[Line<'_>]) -> Checked<Blocks> {
        let mut read = Certificate::of(Vec::new());
        for line in lines {
            read.take(line.number, line.text).at(line.number)?;
        }
        Ok(read.blocks)
    }

    /// A certificate that says nothing about these rules.
    fn of(rules: Vec<(usize, Vec<Coordinates>)>) -> Certificate {
        Certificate {
            polynomial: Vec::new(),
            field: None,
            rules,
            order: None,
            given: Vec::new(),
            blocks: Blocks::default(),
            lower: None,
            bound: Q::zero(),
            unit: Q::zero(),
            rows: Vec::new(),
            images: Vec::new(),
            continuous: None,
            not_continuous: None,
            end: 0,
            next: 0,
        }
    }

    fn finished(mut self, ended: bool, place: usize) -> Checked<Certificate> {
        self.end = place;
        let whole = ended && self.bound.is_positive() && self.unit.is_positive();
        require(whole, RadiusReason::Truncated).at(place).map(|()| self)
    }

    /// Numbers by their coordinates, of which a fraction has one.
    fn entries(&self, text: &str) -> Checked<Vec<Coordinates>> {
        let most = self.field.as_ref().map_or(1, |field| field.degree());
        let entry = |word: &str| {
            let coordinates: Option<Vec<Q>> = word.split(',').map(read_rational).collect();
            let coordinates = coordinates.filter(|c| c.len() <= most);
            Ok(coordinates.ok_or(RadiusReason::Malformed("coordinates"))?)
        };
        text.split_whitespace().map(entry).collect()
    }

    fn take(&mut self, line: usize, words: &str) -> Checked<()> {
        let (word, rest) = words.split_once(' ').unwrap_or((words, ""));
        let known = LINES.iter().position(|(known, _)| *known == word);
        let place = known.ok_or(RadiusReason::Malformed("a line of this format"))?;
        require(place >= self.next, RadiusReason::Order)?;
        self.next = if LINES[place].1 { place } else { place + 1 };
        match word {
            "field" => self.polynomial = numbers(rest)?,
            "between" => {
                let [low, high] = &numbers(rest)?[..] else {
                    return Err(RadiusReason::Malformed("two numbers").into());
                };
                let polynomial = std::mem::take(&mut self.polynomial);
                let small = polynomial.len() <= MAX_DEGREE + 1;
                let field = small.then(|| Field::new(polynomial, low.clone(), high.clone()));
                self.field = Some(Rc::new(field.flatten().ok_or(RadiusReason::Field)?));
            }
            "rule" => self.rules.push((line, self.entries(rest)?)),
            "order" => self.order = Some((line, count(rest)?)),
            "matrix" => {
                let rows = rest.split('|').map(|row| self.entries(row));
                let matrix = rows.collect::<Checked<Vec<Vec<Coordinates>>>>()?;
                self.given.push((line, matrix));
            }
            "basis" => self.blocks.basis = Some((line, square(rest)?)),
            "inverse" => self.blocks.inverse = Some((line, square(rest)?)),
            "blocks" => {
                let sizes = rest.split_whitespace().map(count).collect::<Checked<Vec<usize>>>()?;
                self.blocks.sizes = Some((line, sizes));
            }
            "product" => {
                let product =
                    rest.split_whitespace().map(count).collect::<Checked<Vec<usize>>>()?;
                require(!product.is_empty(), RadiusReason::Malformed("one factor at least"))?;
                let (bound, kind) = (Q::zero(), Leading::Positive);
                self.lower = Some(Lower { line, product, bound, kind });
            }
            "eigenvalue" => {
                let lower = self.lower.as_mut().ok_or(RadiusReason::Malformed("a product"))?;
                let (kind, bound) = rest.split_once(' ').unwrap_or((rest, ""));
                lower.kind = match kind {
                    "positive" => Leading::Positive,
                    "negative" => Leading::Negative,
                    "modulus" => Leading::Modulus,
                    _ => {
                        let kinds = RadiusReason::Malformed("positive, negative or modulus");
                        return Err(kinds.into());
                    }
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
                let terms = rest.split_whitespace().map(term).collect::<Checked<Vec<_>>>()?;
                self.images.push((line, terms));
            }
            "continuous" => self.continuous = Some((line, count(rest)?)),
            _ => self.not_continuous = Some((line, count(rest)?)),
        }
        Ok(())
    }
}
