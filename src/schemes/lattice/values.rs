//! The basic limit function of a mask on Z^d at rational points, and the space of its values near a tile.

use super::monomials::{of_degree, power_of};
use super::places::of_tiling;
use super::span::Span;
use super::tiling::{Motion, Tiling, inverse};
use super::window::{attractor, less_digits};
use crate::cap::Cap;
use crate::exact::{Rational, Scalar, echelon, null_rows, short_echelon};
use crate::scheme::{LatticeMask, Point, apply, difference, sum};
use std::collections::{BTreeMap, BTreeSet};

/// The most dimensions of the space.
pub(super) const MAX_DIMENSION: usize = 96;

/// The same together with powers of points.
const MAX_JOINED: usize = 256;

/// φ at the integers, where the scheme converges: the only vector v with Σ_β a(Mα − β) v_β = v_α, Σ_α v_α = 1.
///
/// # Errors
/// When the window is too large; `Ok(None)` where there is no such vector, or more than one, so that the scheme does not converge.
///
/// # Panics
/// Never.
pub fn values_at_integers(mask: &LatticeMask) -> Result<Option<BTreeMap<Point, Rational>>, Cap> {
    let window = window(mask)?;
    let entry = |alpha: &Point, beta: &Point| {
        let place = difference(mask.dilation().times(*alpha), *beta);
        mask.coefficients().get(&place).cloned().unwrap_or_else(Rational::zero)
    };
    let fixed = window.iter().enumerate().map(|(i, alpha)| {
        let row = window
            .iter()
            .enumerate()
            .map(|(j, beta)| entry(alpha, beta) - Rational::from(i64::from(i == j)));
        row.chain([Rational::zero()]).collect::<Vec<Rational>>()
    });
    let total = vec![Rational::one(); window.len() + 1];
    let (rows, pivots) = echelon(fixed.chain([total]).collect());
    if !pivots.into_iter().eq(0..window.len()) {
        return Ok(None);
    }
    let values = rows.into_iter().map(|mut row| row.pop().expect("a right side"));
    Ok(Some(window.into_iter().zip(values).filter(|(_, value)| !value.is_zero()).collect()))
}

/// The integer points of the attractor of supp a − E.
///
/// # Errors
/// When there are too many.
pub fn window<S>(mask: &LatticeMask<S>) -> Result<Vec<Point>, Cap> {
    attractor(mask.dilation(), &less_digits(mask.coefficients().keys().copied(), mask.dilation()))
}

/// The space U of the Φ(x) = (φ(x + α))_α for x near a tile, and in it the differences of high order.
///
/// With the parts (G_i, t_i) of the tiling, (T_i v)_α = Σ_β a(Mα + t_i − G_iβ) v_β takes Φ(x) to Φ(M^{−1}(G_i x + t_i)), and so U to itself.
#[derive(Clone, Debug)]
pub struct ValueSpace {
    /// The number of dimensions of U.
    pub dimension: usize,
    /// K', the accuracy: Σ_i c_i x_i^μ, |μ| < K', depends only on Σ_i c_i Φ(x_i), and polynomials of degree below K' are sums of shifts of φ.
    pub accuracy: u32,
    /// For each part T_i on the Σ_i c_i Φ(x_i) with Σ_i c_i x_i^μ = 0, |μ| < K', in the reduced echelon basis of these: row i has the coordinates of the
    /// image of vector i.
    pub matrices: Vec<Vec<Vec<Rational>>>,
}

impl ValueSpace {
    /// That of a mask whose scheme converges, near a tile of a tiling; the accuracy is looked for up to `most`.
    ///
    /// # Errors
    /// When a cap is met; `Ok(None)` where φ has no values, so that the scheme does not converge.
    pub fn of(mask: &LatticeMask, tiling: &Tiling, most: u32) -> Result<Option<ValueSpace>, Cap> {
        let Some(values) = values_at_integers(mask)? else { return Ok(None) };
        let window = of_tiling(mask, tiling)?;
        // φ(gx + α) = φ(x + G^{−1}(α + t)).
        let place =
            |motion: &Motion, at: Point| difference(apply(&motion.matrix, at), motion.shift);
        let moved = tiling.neighbours.iter();
        let moved = moved.flat_map(|motion| window.iter().map(move |at| place(motion, *at)));
        let places: Vec<Point> = moved.collect::<BTreeSet<Point>>().into_iter().collect();
        let steps = Transitions::new(mask, &tiling.parts, &places);
        // Φ(0), of which all values at points of the tile follow.
        let start: Vec<Rational> = places
            .iter()
            .map(|place| values.get(place).cloned().unwrap_or_else(Rational::zero))
            .collect();
        let origin = vec![Rational::zero(); mask.dimension()];
        // The same at the neighbours of the tile, and what is left of both after many steps.
        let near = |k: u32| {
            let mut near = Vec::new();
            let tile = steps.generated(vec![(start.clone(), origin.clone())], k)?;
            for motion in &tiling.neighbours {
                let back = inverse(&motion.matrix);
                for (vector, point) in &tile {
                    let place = |place: &Point| {
                        let at = places.binary_search(&apply(&back, sum(*place, motion.shift)));
                        at.map_or_else(|_| Rational::zero(), |at| vector[at].clone())
                    };
                    let values = places.iter().map(place).collect::<Vec<Rational>>();
                    near.push((values, motion.of_point(point)));
                }
            }
            steps.settled(near, k)
        };
        let basis = near(0)?;
        let joined = Joined::new(&steps, &basis, most);
        // That the Φ(x) determine x^μ has to hold for all x near the tile, not only for those of a basis.
        let mut accuracy = joined.accuracy(most);
        while accuracy > 0 && near(accuracy)?.len() > basis.len() {
            accuracy -= 1;
        }
        Ok(Some(joined.space(&steps, accuracy)))
    }
}

/// The rows (Φ(x), (x^μ)_μ) of a basis of U and of its images, in reduced echelon form.
struct Joined {
    /// The degrees |μ|.
    degrees: Vec<u32>,
    rows: Vec<Vec<Rational>>,
    pivots: Vec<usize>,
    /// The length of Φ(x).
    width: usize,
}

impl Joined {
    fn new(steps: &Transitions<'_>, basis: &[Values], most: u32) -> Joined {
        let d = steps.mask.dimension();
        let degrees = (0..most).flat_map(|k| of_degree(k, d).into_iter().map(move |_| k)).collect();
        let images = basis.iter().flat_map(|(vector, point)| steps.images(vector, point));
        let all = basis.iter().cloned().chain(images).map(|values| joined(&values, most));
        let (rows, pivots) = short_echelon(all.collect());
        Joined { degrees, rows, pivots, width: steps.rules[0].len() }
    }

    /// The functionals Φ(x) ↦ x^μ are well defined on U only if each row that is 0 in U is 0 beyond.
    fn accuracy(&self, most: u32) -> u32 {
        let undefined = self.pivots.iter().filter(|pivot| **pivot >= self.width);
        undefined.map(|pivot| self.degrees[pivot - self.width]).min().unwrap_or(most)
    }

    fn space(&self, steps: &Transitions<'_>, accuracy: u32) -> ValueSpace {
        let Joined { degrees, rows, pivots, width } = self;
        let width = *width;
        let dimension = pivots.iter().filter(|pivot| **pivot < width).count();
        let kept = degrees.iter().filter(|k| **k < accuracy).count();
        let moments: Vec<Vec<Rational>> =
            rows[..dimension].iter().map(|row| row[width..width + kept].to_vec()).collect();
        let vector = |combination: Vec<Rational>| {
            let mut sum = vec![Rational::zero(); width];
            for (c, row) in combination.iter().zip(rows).filter(|(c, _)| !c.is_zero()) {
                sum.iter_mut().zip(row).for_each(|(x, v)| *x += &(c * v));
            }
            sum
        };
        let matrices = steps.on(null_rows(&moments).into_iter().map(vector).collect());
        ValueSpace { dimension, accuracy, matrices }
    }
}

/// A vector and the point whose values it has.
type Values = (Vec<Rational>, Vec<Rational>);

/// (Φ(x), (x^μ)_{|μ| < k}).
fn joined((vector, point): &Values, k: u32) -> Vec<Rational> {
    let powers = (0..k).flat_map(|k| of_degree(k, point.len()));
    vector.iter().cloned().chain(powers.map(|exponents| power_of(point, exponents))).collect()
}

/// Those of the values that are independent of those before them, together with the x^μ, |μ| < k.
fn independent(all: Vec<Values>, k: u32) -> Result<Vec<Values>, Cap> {
    let mut span = Span::default();
    let mut kept = Vec::new();
    for values in all {
        if span.insert(&joined(&values, k)) {
            kept.push(values);
        }
        if kept.len() > most(k) {
            return Err(beyond());
        }
    }
    Ok(kept)
}

fn most(k: u32) -> usize {
    if k == 0 { MAX_DIMENSION } else { MAX_JOINED }
}

fn beyond() -> Cap {
    Cap::new("the number of dimensions of the space of values", MAX_DIMENSION as u64)
}

/// (T_i v)_α = Σ_β a(Mα + t_i − G_iβ) v_β for the parts (G_i, t_i) of a tiling, for v on given places.
pub(super) struct Transitions<'m, S = Rational> {
    mask: &'m LatticeMask<S>,
    parts: &'m [Motion],
    /// For each part and each place α, the places β with a(Mα + t_i − G_iβ).
    rules: Vec<Vec<Rule<S>>>,
}

/// The terms of a row: places with coefficients.
type Rule<S> = Vec<(usize, S)>;

impl<'m, S: Scalar> Transitions<'m, S> {
    pub(super) fn new(
        mask: &'m LatticeMask<S>,
        parts: &'m [Motion],
        places: &[Point],
    ) -> Transitions<'m, S> {
        let rule = |part: &Motion, alpha: &Point| {
            let corner = sum(part.shift, mask.dilation().times(*alpha));
            let back = inverse(&part.matrix);
            let terms = mask.coefficients().iter();
            let terms = terms.filter_map(|(place, c)| {
                let beta = apply(&back, difference(corner, *place));
                Some((places.binary_search(&beta).ok()?, c.clone()))
            });
            terms.collect::<Rule<S>>()
        };
        let of = |part: &Motion| places.iter().map(|alpha| rule(part, alpha)).collect();
        Transitions { mask, parts, rules: parts.iter().map(of).collect() }
    }

    /// The T_i on the invariant space that these vectors span, in its reduced echelon basis: row j has the coordinates of the image of vector j.
    pub(super) fn on(&self, vectors: Vec<Vec<Rational>>) -> Vec<Vec<Vec<S>>> {
        let (basis, pivots) = short_echelon(vectors);
        let on = |rules: &Vec<Rule<S>>| {
            let row = |vector: &Vec<Rational>| {
                pivots.iter().map(|at| applied(&rules[*at], vector)).collect()
            };
            basis.iter().map(row).collect()
        };
        self.rules.iter().map(on).collect()
    }
}

impl Transitions<'_> {
    /// T_iΦ(x) = Φ(M^{−1}(G_i x + t_i)) for each part.
    fn images(&self, vector: &[Rational], point: &[Rational]) -> Vec<Values> {
        let dilation = self.mask.dilation();
        let image = |(part, rules): (&Motion, &Vec<Rule<Rational>>)| {
            let value = |rule: &Rule<Rational>| applied(rule, vector);
            (rules.iter().map(value).collect(), dilation.inverse_times(&part.of_point(point)))
        };
        self.parts.iter().zip(&self.rules).map(image).collect()
    }

    /// Values that span what is left of some after many steps, together with the x^μ, |μ| < k.
    fn settled(&self, near: Vec<Values>, k: u32) -> Result<Vec<Values>, Cap> {
        let mut near = independent(near, k)?;
        loop {
            let images = near.iter().flat_map(|(vector, point)| self.images(vector, point));
            let next = independent(images.collect(), k)?;
            if next.len() == near.len() {
                return Ok(next);
            }
            near = next;
        }
    }

    /// Values that span all that follow from some by steps, together with the x^μ, |μ| < k.
    fn generated(&self, mut waiting: Vec<Values>, k: u32) -> Result<Vec<Values>, Cap> {
        let mut span = Span::default();
        let mut kept: Vec<Values> = Vec::new();
        waiting.reverse();
        while let Some((vector, point)) = waiting.pop() {
            let values = (vector, point);
            if !span.insert(&joined(&values, k)) {
                continue;
            }
            if kept.len() >= most(k) {
                return Err(beyond());
            }
            waiting.extend(self.images(&values.0, &values.1));
            kept.push(values);
        }
        Ok(kept)
    }
}

/// The value of a rule at a vector.
fn applied<S: Scalar>(rule: &[(usize, S)], vector: &[Rational]) -> S {
    let mut sum = S::zero();
    for (at, c) in rule.iter().filter(|(at, _)| !vector[*at].is_zero()) {
        sum.accumulate(&c.times(&S::from_rational(&vector[*at])));
    }
    sum
}
