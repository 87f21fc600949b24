//! The parameters for which limits are smoothest, enclosed.

use super::region::{Certain, Search, Sides, centre, parts};
use crate::exact::{BivariatePolynomial, Enclosure, Rational, Scalar as _};
use crate::joint::MatrixSetError;
use crate::scheme::Rules;
use crate::smoothness::parametric::{ParametricSymbol, Reduced};
use crate::smoothness::range_error::SmoothRangeError;
use crate::stop::check;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How near the bounds of the radius are to each other at the end, as a part of the greater one.
const NEAR: (i64, i64) = (1, 1 << 16);

/// The most numbers that are tried as bounds of the radius.
const TRIES: usize = 40;

/// The least joint spectral radius of the differences of the order K, for the parameters in a box.
///
/// With the Hölder exponent s, min(s, K) = −log_n of the radius, if the shifts of the basic limit function are linearly independent;
/// where they are not, s may be greater. It is greater than K only where more sum rules hold than K.
#[derive(Clone, Debug)]
pub struct BestExponent {
    /// K.
    pub order: usize,
    /// n.
    pub arity: usize,
    /// The radius is not less than this at any point of the box.
    pub least: Rational,
    /// It is less than this at the point `at`.
    pub greatest: Rational,
    /// That point.
    pub at: [Rational; 2],
    /// All points where the radius is least are in this box.
    pub places: Sides,
    /// Whether single points may have a greater exponent: where shifts are linearly dependent.
    pub but_exceptions: bool,
    /// How many boxes were looked at.
    pub looked_at: usize,
}

/// Encloses the least radius of a mask in two parameters, of which one may have a fixed value, by halving boxes and the interval
/// of the radius. At most `most` boxes are looked at, and `done` counts them.
///
/// That the radius is τ or more in a whole box, or less than τ at a point, is shown as in [`smooth_map`](super::map::smooth_map), for
/// the matrices over τ.
///
/// # Errors
/// When no sum rule holds for all parameters, or the matrices are beyond a cap.
///
/// # Panics
/// Never: the differences of a symbol begin with the symbol itself.
pub fn best_exponent(
    rules: &Rules<BivariatePolynomial>,
    region: &Sides,
    most: usize,
    done: &AtomicUsize,
) -> Result<BestExponent, SmoothRangeError> {
    let whole = ParametricSymbol::of(rules);
    // Of C^1: shifts that are dependent for all parameters are reduced.
    let Reduced { symbol, steps, .. } = whole.reduced(1);
    let scaled = symbol.scaled_differences(0, !steps.is_empty())?;
    let matrices = scaled.last().expect("the symbol itself").matrices();
    let mut search = Best { matrices, region, done, most, looked_at: 0 };
    let middle = centre(region);
    let mut greatest = Rational::one();
    while !search.is_less(&middle, &greatest)? {
        greatest *= Rational::from(2);
    }
    // The mean of the matrices has the eigenvalue B(1)/n = n^−K.
    let order = scaled.len() - 1;
    let n = Rational::from(rules.arity());
    let least = (0..order).fold(Rational::one(), |power, _| power / &n);
    let leaves = vec![region.clone()];
    let mut found = Known { least, greatest, at: middle, leaves };
    // What one try does not decide is left out: the numbers from `low` to `high`.
    let mut undecided: Option<[Rational; 2]> = None;
    let half = Rational::new(1, 2);
    for tried in 1..TRIES {
        let Some([a, b]) = found.gap(undecided.as_ref()) else { break };
        let between = (a + b) * &half;
        if !search.halve(&mut found, &between, most * tried / TRIES)? {
            let [low, high] = undecided.unwrap_or_else(|| [between.clone(), between.clone()]);
            undecided = Some([low.min(between.clone()), high.max(between)]);
        }
        undecided = undecided.filter(|[low, high]| found.least < *low && *high < found.greatest);
    }
    let places = search.places(&found)?;
    // A simple point near the one that was found, if it is as good.
    let simple = places.clone().map(|[low, high]| Enclosure::new(low, high).simplest());
    let greatest = found.greatest.clone();
    if search.is_less(&simple, &greatest)? {
        found.at = simple;
    }
    Ok(BestExponent {
        order,
        arity: rules.arity(),
        least: found.least,
        greatest: found.greatest,
        at: found.at,
        places,
        but_exceptions: !whole.is_interpolating(),
        looked_at: search.looked_at,
    })
}

/// What is known of the least radius.
struct Known {
    least: Rational,
    greatest: Rational,
    at: [Rational; 2],
    /// Boxes that fill the region.
    leaves: Vec<Sides>,
}

impl Known {
    /// The numbers above what is undecided, or else those below, if there are many.
    fn gap(&self, undecided: Option<&[Rational; 2]>) -> Option<[Rational; 2]> {
        let (least, greatest) = (self.least.clone(), self.greatest.clone());
        let gaps = match undecided {
            None => vec![[least, greatest]],
            Some([low, high]) => vec![[high.clone(), greatest], [least, low.clone()]],
        };
        let near = Rational::new(NEAR.0, NEAR.1);
        gaps.into_iter().find(|[low, high]| high - low > high * &near)
    }
}

struct Best<'a> {
    matrices: Vec<Vec<Vec<BivariatePolynomial>>>,
    region: &'a Sides,
    done: &'a AtomicUsize,
    most: usize,
    looked_at: usize,
}

impl Best<'_> {
    /// A search with the matrices over τ.
    fn over(&self, bound: &Rational) -> Result<Search, MatrixSetError> {
        let factor = BivariatePolynomial::from_rational(&bound.recip());
        let scaled = |matrix: &Vec<Vec<BivariatePolynomial>>| {
            let row =
                |row: &Vec<BivariatePolynomial>| row.iter().map(|c| c.times(&factor)).collect();
            matrix.iter().map(row).collect()
        };
        Search::new(self.matrices.iter().map(scaled).collect(), self.region)
    }

    fn look(&mut self, search: &mut Search, sides: &Sides) -> Result<Certain, MatrixSetError> {
        check();
        self.looked_at += 1;
        self.done.store(self.looked_at.min(self.most), Ordering::Relaxed);
        search.look_at(sides)
    }

    /// Whether the radius is shown to be less than this at a point.
    fn is_less(&mut self, at: &[Rational; 2], bound: &Rational) -> Result<bool, MatrixSetError> {
        let mut search = self.over(bound)?;
        Ok(self.look(&mut search, &point(at))? == Certain::Inside)
    }

    /// Finds a point where the radius is less than this number between the bounds, or shows that there is none, and changes one of
    /// the bounds; `false` where neither succeeds with so many boxes.
    fn halve(
        &mut self,
        found: &mut Known,
        between: &Rational,
        most: usize,
    ) -> Result<bool, MatrixSetError> {
        let mut search = self.over(between)?;
        let mut waiting: std::collections::VecDeque<Sides> = found.leaves.iter().cloned().collect();
        let mut outside = Vec::new();
        while let Some(sides) = waiting.pop_front() {
            if self.looked_at >= most {
                return Ok(false);
            }
            let middle = centre(&sides);
            match self.look(&mut search, &sides)? {
                Certain::Outside(_) => {
                    outside.push(sides);
                    continue;
                }
                Certain::Inside => {}
                Certain::Open => {
                    if self.look(&mut search, &point(&middle))? != Certain::Inside {
                        waiting.extend(parts(&sides));
                        continue;
                    }
                }
            }
            (found.greatest, found.at) = (between.clone(), middle);
            return Ok(true);
        }
        (found.least, found.leaves) = (between.clone(), outside);
        Ok(true)
    }

    /// The box around all boxes where the radius may be least.
    fn places(&mut self, found: &Known) -> Result<Sides, MatrixSetError> {
        let mut search = self.over(&found.greatest)?;
        let mut waiting: std::collections::VecDeque<Sides> = found.leaves.iter().cloned().collect();
        let mut kept: Vec<Sides> = Vec::new();
        while let Some(sides) = waiting.pop_front() {
            if self.looked_at >= self.most {
                kept.push(sides);
                continue;
            }
            match self.look(&mut search, &sides)? {
                // The radius is not less here than at the point that was found.
                Certain::Outside(_) => {}
                Certain::Inside => kept.push(sides),
                Certain::Open => waiting.extend(parts(&sides)),
            }
        }
        let end = |which: usize, last: bool| {
            let ends = kept.iter().map(|sides| &sides[which][usize::from(last)]);
            let end = if last { ends.max() } else { ends.min() };
            end.unwrap_or(&self.region[which][usize::from(last)]).clone()
        };
        Ok([0, 1].map(|which| [end(which, false), end(which, true)]))
    }
}

fn point(at: &[Rational; 2]) -> Sides {
    at.each_ref().map(|x| [x.clone(), x.clone()])
}
