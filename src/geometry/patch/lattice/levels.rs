//! Coordinates of levels, and how far a point of the limit looks.

use crate::exact::Rational;
use crate::lattice::{mean, natural_shift};
use crate::scheme::LatticeMask;

/// A place in the coordinates of a level: the point α of the level stands at α.
pub(super) type Place = [Rational; 2];

/// In each coordinate the open interval between two numbers.
pub(super) type Sides = [[Rational; 2]; 2];

/// y ↦ Ay + b.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    pub(super) matrix: [[Rational; 2]; 2],
    pub(super) constant: Place,
}

impl Affine {
    /// y ↦ y.
    pub(super) fn identity() -> Affine {
        let entry = |i: usize, j: usize| Rational::from(i64::from(i == j));
        let matrix = [0, 1].map(|i| [0, 1].map(|j| entry(i, j)));
        Affine { matrix, constant: [0, 1].map(|_| Rational::zero()) }
    }

    /// Ay + b.
    pub(super) fn at(&self, y: &Place) -> Place {
        [0, 1].map(|i| {
            let [a, b] = &self.matrix[i];
            a * &y[0] + b * &y[1] + &self.constant[i]
        })
    }

    /// This after another one.
    fn after(&self, other: &Affine) -> Affine {
        let entry = |i: usize, j: usize| {
            &self.matrix[i][0] * &other.matrix[0][j] + &self.matrix[i][1] * &other.matrix[1][j]
        };
        let matrix = [0, 1].map(|i| [0, 1].map(|j| entry(i, j)));
        Affine { matrix, constant: self.at(&other.constant) }
    }

    /// The least box around the image of a box.
    pub(super) fn hull(&self, sides: &Sides) -> Sides {
        [0, 1].map(|i| {
            let ends = |pick: usize| {
                let terms = self.matrix[i]
                    .iter()
                    .zip(sides)
                    .map(|(a, side)| a * &side[if a.sign() < 0 { 1 - pick } else { pick }]);
                terms.sum::<Rational>() + &self.constant[i]
            };
            [ends(0), ends(1)]
        })
    }
}

/// The least box around two boxes.
fn around(a: &Sides, b: &Sides) -> Sides {
    [0, 1].map(|i| [(&a[i][0]).min(&b[i][0]).clone(), (&a[i][1]).max(&b[i][1]).clone()])
}

/// The sums of the numbers of two boxes.
fn plus(a: &Sides, b: &Sides) -> Sides {
    [0, 1].map(|i| [0, 1].map(|end| &a[i][end] + &b[i][end]))
}

/// How levels of a net in the plane follow each other: the place y of a level is the place My + m_1 of the next one, m_1 the mean of the mask, where
/// points stand at their natural places.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    /// To the next level.
    pub(super) up: Affine,
    /// To the level before.
    pub(super) down: Affine,
    /// How many levels squares are divided at a time, and whether their images then consist of squares: where each row of this power of M has one entry other
    /// than 0.
    pub(super) stride: u32,
    pub(super) nested: bool,
    /// M^{−steps} takes each square into a smaller one.
    pub(super) steps: u32,
    /// |P^∞ − P^k| at y, and all that bounds it, depends on points of level k in y + this.
    pub(super) reach: Sides,
    /// The limit on a square of level 0, and all levels there, depend on points of level 0 in the places of the square + this.
    pub(super) window: Sides,
}

/// The most levels that squares are divided at a time.
const MAX_STRIDE: u32 = 3;

/// The greatest denominator of the mean of a mask.
const MAX_DENOMINATOR: i64 = 16;

/// The most steps of which one contracts squares, and the most times that a box grows.
const MOST: u32 = 64;

impl Levels {
    /// Those of a mask in the plane; `None` where no few steps contract squares.
    pub(super) fn of(mask: &LatticeMask) -> Option<Levels> {
        let dilation = mask.dilation();
        let rows: Vec<&[i64]> = dilation.rows().collect();
        let matrix = [0, 1].map(|i| [0, 1].map(|j| Rational::from(rows[i][j])));
        let mean: Place = mean(mask).try_into().ok()?;
        let column = |j: usize| {
            let unit: Vec<Rational> = (0..2).map(|i| i64::from(i == j).into()).collect();
            dilation.inverse_times(&unit)
        };
        let columns = [column(0), column(1)];
        let inverse = [0, 1].map(|i| [0, 1].map(|j| columns[j][i].clone()));
        let up = Affine { matrix, constant: mean };
        let (stride, nested) = stride(&up);
        let zero = [0, 1].map(|_| Rational::zero());
        let back = Affine { matrix: inverse.clone(), constant: zero };
        let constant = back.at(&up.constant).map(|x| -x);
        let down = Affine { matrix: inverse, constant };
        // The points of a level at the places of a set depend on those of the level before in M^{−1}(set + m_1 − support).
        let sources: Vec<Place> = mask
            .coefficients()
            .keys()
            .map(|at| [0, 1].map(|i| &up.constant[i] - &Rational::from(at[i])))
            .collect();
        let denominator = up.constant.iter().filter_map(|x| x.denominator().to_i64()).max()?;
        if denominator > MAX_DENOMINATOR {
            return None;
        }
        let (mut power, mut sum) =
            (Affine::identity(), [0, 1].map(|_| [0, 1].map(|_| Rational::zero())));
        let mut powers = vec![(power.clone(), sum.clone())];
        while powers.len() == 1
            || !contracts(&power)
            || !(powers.len() - 1).is_multiple_of(stride as usize)
        {
            if powers.len() > MOST as usize {
                return None;
            }
            power = back.after(&power);
            let images: Vec<Place> = sources.iter().map(|x| power.at(x)).collect();
            for (i, side) in sum.iter_mut().enumerate() {
                side[0] += images.iter().map(|x| &x[i]).min()?;
                side[1] += images.iter().map(|x| &x[i]).max()?;
            }
            powers.push((power.clone(), sum.clone()));
        }
        let unit = natural_shift(mask).iter().fold(1_i64, |unit, x| {
            x.denominator().to_i64().filter(|d| unit % d != 0).map_or(unit, |d| unit * d)
        });
        let dependence = Dependence { powers, unit: Rational::from(unit) };
        let wide = |x: Rational| [0, 1].map(|_| [-x.clone(), x.clone()]);
        let reach = dependence.closed(dependence.before(&wide(Rational::one()), 1))?;
        let (reach, window) = if nested {
            // Differences are those of levels at which there are squares.
            let window = dependence.before(&reach, stride);
            (reach, window)
        } else {
            // A corner of the square of a later level is as near to a place in it, after steps back.
            let corners = wide(Rational::one());
            let near = dependence.powers.iter().map(|(power, _)| power.hull(&corners));
            let near = near.fold(corners.clone(), |all, hull| around(&all, &hull));
            let reach = plus(&reach, &near);
            // Squares of later levels meet the image of the one of level 0, and may not be in it.
            let window = dependence.before(&dependence.closed(plus(&reach, &corners))?, 1);
            (reach, window)
        };
        let steps = u32::try_from(dependence.powers.len()).ok()? - 1;
        Some(Levels { up, down, stride, nested, steps, reach, window })
    }

    /// Where squares of the first levels at which there are any begin, up to integers, and from which of these on they come again and again. Squares of level 0 begin at integers,
    /// and nested ones later at the images of such places.
    pub(super) fn offsets(&self) -> (Vec<Place>, usize) {
        let mut all = vec![[0, 1].map(|_| Rational::zero())];
        if !self.nested {
            return (all, 0);
        }
        // The images have the denominators of the mean of the mask, so that they are finitely many up to integers.
        loop {
            let next = self
                .forth(self.stride)
                .at(&all[all.len() - 1])
                .map(|x| &x - &Rational::from(x.floor()));
            if let Some(again) = all.iter().position(|place| *place == next) {
                return (all, again);
            }
            all.push(next);
        }
    }

    /// From a level to the one so many later.
    pub(super) fn forth(&self, count: u32) -> Affine {
        (0..count).fold(Affine::identity(), |all, _| self.up.after(&all))
    }

    /// From a level to the one so many before.
    pub(super) fn back(&self, count: u32) -> Affine {
        (0..count).fold(Affine::identity(), |all, _| self.down.after(&all))
    }
}

/// The least power of which each row has one entry other than 0, and whether there is one within few.
fn stride(up: &Affine) -> (u32, bool) {
    let mut power = up.clone();
    for count in 1..=MAX_STRIDE {
        if power.matrix.iter().all(|row| row.iter().filter(|x| !x.is_zero()).count() == 1) {
            return (count, true);
        }
        power = up.after(&power);
    }
    (1, false)
}

/// Whether a linear map takes each square around 0 into a smaller one.
fn contracts(map: &Affine) -> bool {
    map.matrix.iter().all(|row| row.iter().map(Rational::abs).sum::<Rational>() < Rational::one())
}

/// On which points points depend, so many levels before.
struct Dependence {
    /// M^{−i}, and the least box around Σ_{j ≤ i} M^{−j}(m_1 − support), i = 0, 1, ….
    powers: Vec<(Affine, Sides)>,
    /// Boxes have ends whose products with this are integers.
    unit: Rational,
}

impl Dependence {
    /// The least box around the places, i levels before, of what a box depends on.
    fn earlier(sides: &Sides, (power, sum): &(Affine, Sides)) -> Sides {
        plus(&power.hull(sides), sum)
    }

    /// A box around a box that contains the places of what it depends on, as many levels before as contract.
    fn closed(&self, sides: Sides) -> Option<Sides> {
        let mut sides = sides;
        for _ in 0..MOST {
            let earlier = Dependence::earlier(&sides, self.powers.last()?);
            let out = earlier.map(|[low, high]| {
                let low = Rational::from((low * &self.unit).floor()) / self.unit.clone();
                [low, Rational::from((high * &self.unit).ceil()) / self.unit.clone()]
            });
            let next = around(&sides, &out);
            if next == sides {
                return Some(sides);
            }
            sides = next;
        }
        None
    }

    /// The least box around what a box depends on at all of fewer levels before than contract, of which each is a multiple of the stride.
    fn before(&self, sides: &Sides, stride: u32) -> Sides {
        let few = self.powers[..self.powers.len() - 1].iter().step_by(stride as usize);
        few.fold(sides.clone(), |all, power| around(&all, &Dependence::earlier(sides, power)))
    }
}
