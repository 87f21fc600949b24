//! Where, in a plane of two parameters, the limits are C^m: boxes inside, boxes outside, and open boxes.

use super::region::{Certain, Search, Sides, parts};
use crate::exact::{BivariatePolynomial, Rational};
use crate::joint::MatrixSetError;
use crate::scheme::Rules;
use crate::smoothness::parametric::{ParametricSymbol, Reduced};
use crate::smoothness::range_error::SmoothRangeError;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The most boxes that can be asked for.
pub const MAX_BOXES: usize = 20_000;

/// A closed box, and what is certain in it.
#[derive(Clone, Debug)]
pub struct MapBox {
    /// The box.
    pub sides: Sides,
    /// What is certain.
    pub certain: Certain,
}

/// A map of two parameters.
#[derive(Clone, Debug)]
pub struct SmoothMap {
    /// Boxes that meet in their sides only, and fill the region.
    pub boxes: Vec<MapBox>,
    /// Whether parameters outside may be exceptions: those where the shifts of the basic limit function are linearly
    /// dependent, which are zeros of a polynomial that is not 0.
    pub but_exceptions: bool,
    /// How many boxes were looked at.
    pub looked_at: usize,
}

impl SmoothMap {
    /// The same, where what is outside is open.
    pub(crate) fn without_outside(mut self) -> SmoothMap {
        for found in &mut self.boxes {
            if matches!(found.certain, Certain::Outside(_)) {
                found.certain = Certain::Open;
            }
        }
        self
    }

    /// The part of the area of the region that is inside, outside and open.
    #[must_use]
    pub fn shares(&self) -> [Rational; 3] {
        let area = |sides: &Sides| -> Rational {
            sides.iter().fold(Rational::one(), |area, [low, high]| area * (high - low))
        };
        let whole: Rational = self.boxes.iter().map(|found| area(&found.sides)).sum();
        let share = |which: fn(&Certain) -> bool| {
            let boxes = self.boxes.iter().filter(|found| which(&found.certain));
            boxes.map(|found| area(&found.sides)).sum::<Rational>() / &whole
        };
        [
            share(|certain| *certain == Certain::Inside),
            share(|certain| matches!(certain, Certain::Outside(_))),
            share(|certain| *certain == Certain::Open),
        ]
    }
}

/// A map of where the limits of a mask in two parameters are C^m, by halving both sides of open boxes until `most`
/// boxes have been looked at. `done` counts them.
///
/// Inside: a hull is invariant under the matrices of which those of the box are the mean. Outside: a polynomial in
/// the parameters, which has a sign in the whole box by its Bernstein coefficients, shows that a product has an
/// eigenvalue of 1 or more in absolute value. `proofs/THEOREMS.md`, 122.
///
/// # Errors
/// When the sum rules do not hold for all parameters, or the matrices are beyond a cap.
///
/// # Panics
/// Never: the differences of a symbol begin with the symbol itself.
pub fn smooth_map(
    rules: &Rules<BivariatePolynomial>,
    m: usize,
    region: &Sides,
    most: usize,
    done: &AtomicUsize,
) -> Result<SmoothMap, SmoothRangeError> {
    let whole = ParametricSymbol::of(rules);
    let Reduced { symbol, steps, cycles } = whole.reduced(m);
    let search = |symbol: &ParametricSymbol<BivariatePolynomial>, m| {
        let scaled = symbol.scaled_differences(m, !steps.is_empty())?;
        let last = scaled.last().expect("the symbol itself");
        Ok::<Search, SmoothRangeError>(Search::new(last.matrices(), region)?)
    };
    // Whether the scheme converges may not follow from the reduced symbol.
    let mut searches = vec![search(&symbol, m)?];
    if cycles {
        searches.push(search(&whole.reduced(0).symbol, 0)?);
    }
    let sure = m == 0 || whole.is_interpolating();
    Ok(SmoothMap { but_exceptions: !sure, ..map_of(searches, &|_| false, region, (most, done))? })
}

/// The map of where all of these contract, and where one does not. Boxes that are `inside` for another reason are not looked at.
pub(crate) fn map_of(
    mut searches: Vec<Search>,
    inside: &dyn Fn(&Sides) -> bool,
    region: &Sides,
    (most, done): (usize, &AtomicUsize),
) -> Result<SmoothMap, MatrixSetError> {
    let mut waiting = VecDeque::from([region.clone()]);
    let (mut boxes, mut looked_at) = (Vec::new(), 0);
    while let Some(sides) = waiting.pop_front() {
        if looked_at == most {
            boxes.push(MapBox { sides, certain: Certain::Open });
            continue;
        }
        looked_at += 1;
        done.store(looked_at, Ordering::Relaxed);
        if inside(&sides) {
            boxes.push(MapBox { sides, certain: Certain::Inside });
            continue;
        }
        let mut certain = Certain::Inside;
        for search in &mut searches {
            match search.look_at(&sides)? {
                outside @ Certain::Outside(_) => {
                    certain = outside;
                    break;
                }
                Certain::Open => certain = Certain::Open,
                Certain::Inside => {}
            }
        }
        match certain {
            Certain::Open => waiting.extend(parts(&sides)),
            certain => boxes.push(MapBox { sides, certain }),
        }
    }
    Ok(SmoothMap { boxes, but_exceptions: false, looked_at })
}
