//! Polygons of two parameters in which all limits are C^m, by a contraction.

use crate::exact::{BivariatePolynomial, Rational, Scalar as _};
use crate::scheme::Rules;
use crate::smoothness::parametric::{ParametricSymbol, Reduced};
use crate::smoothness::range_error::SmoothRangeError;
use crate::smoothness::symbol::with_level;

/// A point of the plane.
pub type Point = [Rational; 2];

/// The most triangles that are looked at for one number of levels.
const MAX_TRIANGLES: usize = 2_000;

/// The most lines on which coefficients vanish.
const MAX_LINES: usize = 32;

/// The most cuts on the way to one triangle.
const MAX_CUTS: usize = 24;

/// The most coefficients of the product of levels, times those of a Bernstein form.
const MAX_WORK: usize = 20_000;

/// What proves that all limits are C^m in a polygon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RegionProof {
    /// The number of levels in which the differences contract.
    pub levels: u32,
    /// The polynomials g with which A was replaced by A(z)·g(z)/g(z^n), one after the other.
    pub reduction: Vec<Vec<Rational>>,
}

/// A proof that all limits are C^m at all points of a region, or points where this may fail.
///
/// The `corners` of a convex polygon stand counterclockwise, and the region consists of the points of the polygon for which
/// `contains` is true: all points inside, and of each side all inner points or none. On triangles, whose
/// Bernstein polynomials are not negative and sum to 1, a norm is at most the greatest of those of the coefficients.
/// `proofs/THEOREMS.md`, 141.
///
/// # Errors
/// When the sum rules do not hold for all parameters.
///
/// # Panics
/// Never: the differences of a symbol are as many as its sum rules.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_in_parameters;
/// use subcert::smoothness::polygon_contraction;
///
/// // Corner cutting with ratios a > 0 and b > 0, a + b < 1.
/// let mask = parse_in_parameters("[a, 1 - b, 1 - a, b]", &["a", "b"])?;
/// let rules = mask.rules().map(|c| c.in_variables(["a", "b"]).expect("polynomials"));
/// let corners = [[0, 0], [1, 0], [0, 1]].map(|corner| corner.map(Rational::from));
/// let inside = |[x, y]: [&Rational; 2]| x.sign() > 0 && y.sign() > 0 && x + y < Rational::one();
/// let proof = polygon_contraction(&rules, 0, &corners, &inside, 2)?;
/// assert_eq!(proof.expect("C^0").levels, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn polygon_contraction(
    rules: &Rules<BivariatePolynomial>,
    m: usize,
    corners: &[Point],
    contains: &dyn Fn([&Rational; 2]) -> bool,
    most: u32,
) -> Result<Result<RegionProof, Vec<Point>>, SmoothRangeError> {
    let Reduced { symbol, steps, cycles } = ParametricSymbol::of(rules).reduced(m);
    let scaled = symbol.scaled_differences(m, !steps.is_empty())?;
    let mut open = Vec::new();
    if cycles {
        // Whether the scheme converges does not follow from the reduced symbol.
        return Ok(Err(open));
    }
    let Some(triangles) = triangles(&scaled[m + 1], corners) else { return Ok(Err(open)) };
    for levels in 1..=most {
        match contracts(&scaled[m + 1], levels, &triangles, contains) {
            None => break,
            Some(Ok(())) => return Ok(Ok(RegionProof { levels, reduction: steps })),
            Some(Err(point)) => open.push(point),
        }
    }
    Ok(Err(open))
}

/// Whether the norm of so many levels is less than 1 in the region, or a point where this is not shown; `None` beyond a cap.
fn contracts(
    symbol: &ParametricSymbol<BivariatePolynomial>,
    levels: u32,
    triangles: &[[Point; 3]],
    contains: &dyn Fn([&Rational; 2]) -> bool,
) -> Option<Result<(), Point>> {
    let product = Product::of(symbol, levels)?;
    let mut waiting: Vec<(usize, [Point; 3])> =
        triangles.iter().map(|triangle| (0, triangle.clone())).collect();
    let mut looked_at = 0;
    while let Some((cuts, triangle)) = waiting.pop() {
        looked_at += 1;
        match product.on(&triangle, contains) {
            Shown::Contracts => {}
            Shown::Fails(point) => return Some(Err(point)),
            Shown::Nothing if cuts == MAX_CUTS || looked_at >= MAX_TRIANGLES => {
                return Some(Err(centre(&triangle)));
            }
            Shown::Nothing => {
                let [a, b, c] = triangle;
                let middle = centre(&[a.clone(), b.clone()]);
                waiting.push((cuts + 1, [c.clone(), b, middle.clone()]));
                waiting.push((cuts + 1, [c, a, middle]));
            }
        }
    }
    Some(Ok(()))
}

/// The triangles that make up the parts of a convex polygon between the lines on which coefficients vanish: of each part those of
/// its least corner and two others. `None` if there are too many lines.
fn triangles(
    symbol: &ParametricSymbol<BivariatePolynomial>,
    corners: &[Point],
) -> Option<Vec<[Point; 3]>> {
    let mut lines: Vec<[Rational; 3]> = Vec::new();
    for line in symbol.coefficients().iter().filter_map(BivariatePolynomial::line) {
        if !lines.iter().any(|known| are_one(known, &line)) {
            lines.push(line);
        }
    }
    if lines.len() > MAX_LINES {
        return None;
    }
    let mut cells = vec![corners.to_vec()];
    for line in &lines {
        let halves = cells.iter().flat_map(|cell| [1, -1].map(|side| half(cell, line, side)));
        cells = halves.filter(|cell| cell.len() > 2).collect();
    }
    let mut triangles = Vec::new();
    for cell in &mut cells {
        let least = (0..cell.len()).min_by_key(|&i| &cell[i]).unwrap_or(0);
        cell.rotate_left(least);
        let [first, rest @ ..] = &cell[..] else { return None };
        let fan = rest.windows(2).map(|two| [first.clone(), two[0].clone(), two[1].clone()]);
        triangles.extend(fan);
    }
    Some(triangles)
}

/// Whether two lines are one.
fn are_one(first: &[Rational; 3], second: &[Rational; 3]) -> bool {
    let same = |i: usize, j: usize| &first[i] * &second[j] == &first[j] * &second[i];
    same(0, 1) && same(0, 2) && same(1, 2)
}

/// The part of a convex polygon on one side of a line; fewer than three corners if it has no inner points.
fn half(corners: &[Point], [a, b, c]: &[Rational; 3], side: i64) -> Vec<Point> {
    let side = Rational::from(side);
    let height = |[x, y]: &Point| (a * x + b * y + c) * &side;
    let next = corners.iter().cycle().skip(1);
    let mut part = Vec::new();
    for (here, there) in corners.iter().zip(next) {
        let [h, k] = [height(here), height(there)];
        if h.sign() >= 0 {
            part.push(here.clone());
        }
        if h.sign() * k.sign() < 0 {
            let t = &h / (&h - &k);
            part.push([0, 1].map(|i| &here[i] + (&there[i] - &here[i]) * &t));
        }
    }
    if part.iter().all(|point| height(point).is_zero()) { Vec::new() } else { part }
}

/// The mean of points.
fn centre(points: &[Point]) -> Point {
    let over = Rational::from(points.len()).recip();
    let mean = |i: usize| points.iter().map(|point| point[i].clone()).sum::<Rational>() * &over;
    [mean(0), mean(1)]
}

/// What a triangle shows.
enum Shown {
    /// The norm is less than 1 at all its points that are in the region.
    Contracts,
    /// The norm is 1 or more at this corner, or at points next to it.
    Fails(Point),
    Nothing,
}

/// The coefficients of so many levels, by their classes.
struct Product {
    classes: Vec<Vec<BivariatePolynomial>>,
    degree: usize,
}

impl Product {
    fn of(symbol: &ParametricSymbol<BivariatePolynomial>, levels: u32) -> Option<Product> {
        let n = symbol.rules().arity();
        let factors = symbol.coefficients();
        let degree = |p: &BivariatePolynomial| p.total_degree();
        let degree = factors.iter().map(degree).max().unwrap_or(0) * levels as usize;
        let count = n.checked_pow(levels)?;
        let forms = (degree + 1) * (degree + 2) / 2;
        if count.checked_mul(factors.len())?.checked_mul(forms)? > MAX_WORK {
            return None;
        }
        let (mut product, mut scale) =
            (vec![BivariatePolynomial::from_rational(&Rational::one())], 1);
        for _ in 0..levels {
            (product, scale) = (with_level(&product, factors, scale), scale * n);
        }
        let class = |e: usize| product.iter().skip(e).step_by(count).cloned().collect();
        Some(Product { classes: (0..count).map(class).collect(), degree })
    }

    fn on(&self, triangle: &[Point; 3], contains: &dyn Fn([&Rational; 2]) -> bool) -> Shown {
        let one = Rational::one();
        // The corners, the sides and the triangle that the region meets: for each, which weights may be positive.
        let faces: Vec<[bool; 3]> = (1..8_u8)
            .map(|face| [0, 1, 2].map(|i| face & (1 << i) != 0))
            .filter(|face| {
                let own = (0..3).filter(|&i| face[i]).map(|i| triangle[i].clone());
                let [x, y] = centre(&own.collect::<Vec<Point>>());
                contains([&x, &y])
            })
            .collect();
        let mut shown = true;
        for class in &self.classes {
            let forms: Vec<Vec<Rational>> =
                class.iter().map(|p| p.on_triangle(triangle, self.degree)).collect();
            let places = places(self.degree);
            let sum = |at: usize| forms.iter().map(|form| form[at].abs()).sum::<Rational>();
            let sums: Vec<Rational> = (0..places.len()).map(sum).collect();
            for (weights, sum) in places.iter().zip(&sums) {
                let corner = (0..3).find(|&i| weights[i] == self.degree);
                if let Some(corner) = corner {
                    let is_met = || {
                        let [x, y] = &triangle[corner];
                        contains([x, y])
                    };
                    if *sum > one || *sum == one && is_met() {
                        return Shown::Fails(triangle[corner].clone());
                    }
                }
            }
            let less_on = |face: &[bool; 3]| {
                let mut own = places.iter().zip(&sums);
                own.any(|(weights, sum)| *sum < one && (0..3).all(|i| face[i] || weights[i] == 0))
            };
            shown &= sums.iter().all(|sum| *sum <= one) && faces.iter().all(less_on);
        }
        if shown { Shown::Contracts } else { Shown::Nothing }
    }
}

/// The exponents of the Bernstein polynomials of a triangle, in the order of [`BivariatePolynomial::on_triangle`].
fn places(degree: usize) -> Vec<[usize; 3]> {
    let pairs = (0..=degree).flat_map(|k| (0..=degree - k).map(move |l| (k, l)));
    pairs.map(|(k, l)| [degree - k - l, k, l]).collect()
}
