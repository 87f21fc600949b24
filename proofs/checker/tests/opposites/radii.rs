//! Certificates of joint spectral radii, changed at random: whatever is accepted is true, as products of few
//! factors show in floating point.

use super::floats::{multiply, radius_from_below};
use super::masks::{Mask, Q, diagonal, float, int, norm, random_mask, trivial_hull};
use super::mutator::{Random, mutant};
use num_traits::Signed;
use subcert_check::{Radius, check_radius};

/// The errors of floating-point numbers.
const MARGIN: f64 = 1e-6;

/// Valid certificates, some of irrational matrices, and such of random masks and matrices that may be wrong.
pub fn seeds(random: &mut Random) -> Vec<Vec<String>> {
    let committed = [
        include_str!("../radius/accepted/modulus.cert"),
        include_str!("../radius/accepted/dependent.cert"),
        include_str!("../radius/accepted/divergent.cert"),
        include_str!("../radius/accepted/field-boundary.cert"),
        include_str!("../radius/accepted/field.cert"),
        include_str!("../radius/accepted/fourpoint.cert"),
        include_str!("../radius/accepted/negative.cert"),
        include_str!("../radius/accepted/remainder.cert"),
    ];
    let lines = |text: &&str| text.lines().skip(1).map(str::to_owned).collect();
    let mut seeds: Vec<Vec<String>> = committed.iter().map(lines).collect();
    for _ in 0..25 {
        let mask = random_mask(random, 5);
        for order in 0..=mask.order {
            let mut lines = rules(&mask);
            lines.extend(mask.radius(random, order));
            seeds.push(lines);
        }
        seeds.push(matrices(random));
    }
    seeds
}

/// `rule …` for each rule.
fn rules(mask: &Mask) -> Vec<String> {
    let width = mask.symbol.len().div_ceil(mask.n);
    let entry = |alpha: usize, j: usize| {
        mask.symbol.get(mask.n * (width - 1 - j) + alpha).cloned().unwrap_or_default().to_string()
    };
    let rule = |alpha| (0..width).map(|j| entry(alpha, j)).collect::<Vec<_>>().join(" ");
    (0..mask.n).map(|alpha| format!("rule {}", rule(alpha))).collect()
}

/// A certificate about random matrices.
fn matrices(random: &mut Random) -> Vec<String> {
    let (size, count) = (1 + random.below(3), 1 + random.below(2));
    let mut entry = || Q::new(random.within(-4, 4).into(), random.within(1, 2).into());
    let matrices: Vec<Vec<Vec<Q>>> = (0..count)
        .map(|_| (0..size).map(|_| (0..size).map(|_| entry()).collect()).collect())
        .collect();
    let row = |row: &Vec<Q>| row.iter().map(Q::to_string).collect::<Vec<_>>().join(" ");
    let words = |m: &Vec<Vec<Q>>| m.iter().map(row).collect::<Vec<_>>().join(" | ");
    let mut lines: Vec<String> = matrices.iter().map(|m| format!("matrix {}", words(m))).collect();
    let factors: Vec<usize> = (0..=random.below(3)).map(|_| random.below(count)).collect();
    let q = diagonal(&matrices, &factors, random);
    let kind = if q.is_negative() { "negative" } else { "positive" };
    let factors: Vec<String> = factors.iter().map(usize::to_string).collect();
    lines.push(format!("product {}", factors.join(" ")));
    lines.push(format!("eigenvalue {kind} {}", q.abs()));
    let norm = norm(&matrices);
    lines.extend(trivial_hull(if norm.is_positive() { &norm } else { &q }, size * count));
    lines.push("end".to_owned());
    lines
}

/// What a certificate is about, read in the simplest way.
#[derive(Default)]
struct About {
    polynomial: Vec<f64>,
    root: Option<f64>,
    rules: Vec<Vec<f64>>,
    matrices: Vec<Vec<Vec<f64>>>,
    order: Option<usize>,
    /// All entries are rational.
    mask: Vec<Vec<Q>>,
}

impl About {
    fn read(text: &[String]) -> Option<About> {
        let mut about = About::default();
        for line in text {
            let line = line.trim();
            let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
            match word {
                "field" => about.polynomial = numbers(rest)?,
                "between" => {
                    let ends = numbers(rest)?;
                    about.root = Some(root(&about.polynomial, ends[0], ends[1]));
                }
                "rule" => {
                    about.rules.push(about.entries(rest)?);
                    let exact: Option<Vec<Q>> = rest.split_whitespace().map(exact).collect();
                    about.mask.extend(exact);
                }
                "matrix" => {
                    let rows = rest.split('|').map(|row| about.entries(row));
                    about.matrices.push(rows.collect::<Option<_>>()?);
                }
                "order" => about.order = rest.trim().parse().ok(),
                "end" => break,
                _ => {}
            }
        }
        Some(about)
    }

    fn entries(&self, text: &str) -> Option<Vec<f64>> {
        let entry = |word: &str| {
            let coordinates = numbers(&word.replace(',', " "))?;
            let root = self.root.unwrap_or(0.0);
            Some(coordinates.iter().rev().fold(0.0, |sum, c| sum * root + c))
        };
        text.split_whitespace().map(entry).collect()
    }

    /// What of this radius is false.
    fn falsehood(&self, radius: &Radius) -> Option<String> {
        let of_mask =
            self.order.is_some() && self.mask.len() == self.rules.len() && !self.rules.is_empty();
        let matrices = if let (true, Some(order)) = (of_mask, self.order) {
            let mask = mask(&self.mask);
            let [low, high] = mask.exponent;
            if radius.continuous.is_some_and(|m| high < m as f64 - MARGIN) {
                return Some(format!("the exponent is at most {high}"));
            }
            if radius.not_continuous.is_some_and(|m| low > m as f64 + MARGIN) {
                return Some(format!("the exponent is at least {low}"));
            }
            let float =
                |m: &Vec<Vec<Q>>| m.iter().map(|row| row.iter().map(float).collect()).collect();
            mask.matrices(order).iter().map(float).collect()
        } else if self.order.is_some() {
            // A mask with irrational entries: its two bounds have to agree.
            return contradiction(radius);
        } else {
            self.matrices.clone()
        };
        let most = float(&radius.at_most);
        if radius_from_below(&matrices, 4) > most * (1.0 + MARGIN) {
            return Some(format!("the radius is more than {most}"));
        }
        if let Some((q, degree)) = &radius.at_least {
            let least =
                if *degree == 0 { f64::INFINITY } else { float(q).powf(1.0 / *degree as f64) };
            if radius_from_above(&matrices) < least * (1.0 - MARGIN) {
                return Some(format!("the radius is less than {least}"));
            }
        }
        contradiction(radius)
    }
}

/// Whether two statements of one certificate contradict each other.
fn contradiction(radius: &Radius) -> Option<String> {
    let smooth = radius.continuous.zip(radius.not_continuous);
    if smooth.is_some_and(|(m, other)| other <= m) {
        return Some("the limits are smooth, and they are not".to_owned());
    }
    let (q, degree) = radius.at_least.as_ref()?;
    let power = (0..*degree).fold(int(1), |power, _| power * &radius.at_most);
    (*q > power).then(|| "the lower bound is above the upper one".to_owned())
}

/// A bound from above: norms of products.
fn radius_from_above(matrices: &[Vec<Vec<f64>>]) -> f64 {
    let mut best = f64::INFINITY;
    let mut products = matrices.to_vec();
    let longest: usize = if matrices.len() == 1 { 30 } else { 8 };
    for l in 1..=longest {
        let sum = |row: &Vec<f64>| row.iter().copied().map(f64::abs).sum::<f64>();
        let norm = products.iter().flatten().map(sum).fold(0.0, f64::max);
        best = best.min(norm.powf(1.0 / l as f64));
        if l == longest || products.len() * matrices.len() > 600 {
            break;
        }
        products =
            products.iter().flat_map(|p| matrices.iter().map(move |m| multiply(p, m))).collect();
    }
    best
}

/// The mask of rules.
fn mask(rules: &[Vec<Q>]) -> Mask {
    let width = rules[0].len();
    let columns = (0..width).rev();
    Mask::new(
        rules.len(),
        columns.flat_map(|j| rules.iter().map(move |rule| rule[j].clone())).collect(),
    )
}

fn exact(word: &str) -> Option<Q> {
    let (top, bottom) = word.split_once('/').unwrap_or((word, "1"));
    if let Some((whole, digits)) = top.split_once('.') {
        let scale = (0..digits.len()).fold(int(1), |scale, _| scale * int(10));
        return Some(Q::from_integer(format!("{whole}{digits}").parse().ok()?) / scale);
    }
    Some(Q::new(top.parse().ok()?, bottom.parse().ok()?))
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split_whitespace().map(|word| exact(word).map(|x| float(&x))).collect()
}

/// The root of a polynomial between two numbers.
fn root(polynomial: &[f64], mut low: f64, mut high: f64) -> f64 {
    let at = |x: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if (at(middle) > 0.0) == (at(low) > 0.0) { low = middle } else { high = middle }
    }
    low
}

/// Changes certificates so many times; gives how many were accepted, and what is wrong.
pub fn run(random: &mut Random, times: usize) -> (usize, Vec<String>) {
    let seeds = seeds(random);
    let (mut accepted, mut wrong) = (0, Vec::new());
    for time in 0..times {
        let (from, other) = (random.one(&seeds).clone(), random.one(&seeds).clone());
        let lines =
            if time < seeds.len() { seeds[time].clone() } else { mutant(random, &from, &other) };
        let text = format!("subcert-radius 1\n{}\n", lines.join("\n"));
        let begin = std::time::Instant::now();
        if let Ok(radius) = check_radius(&text) {
            accepted += 1;
            let about = About::read(&lines).expect("what was accepted can be read");
            if let Some(why) = about.falsehood(&radius) {
                wrong.push(format!("accepted as {radius}, but {why}:\n{text}"));
            }
        }
        if begin.elapsed().as_secs() > 5 {
            wrong.push(format!("{:?} for:\n{text}", begin.elapsed()));
        }
    }
    (accepted, wrong)
}
