//! From one level to the next: the least level of all, and of each face.

use super::place::{FaceDepth, GeometricDepth, GeometricPlace, Nearness};
use super::relative::relative_tolerance;
use crate::exact::Rational;
use crate::float::upper;
use crate::mesh::Point;
use crate::patch::distance::surface::{TooMuch, positive};

/// The highest level that is looked at as a set of points.
pub(crate) const MAX_LEVEL: u32 = 14;

/// What is known of a face at a level.
pub(crate) type MeshNearness = Nearness<GeometricPlace>;

/// As a distance of sets, a tolerance is at least 2 to the power of minus this, times the diagonal of the box around a
/// mesh, or the greatest width of a control polygon in a coordinate.
pub const LEAST_SHARE: u32 = 20;

/// Refuses a tolerance that is not positive, or too small for a distance of sets of a mesh or a net with these points.
pub(crate) fn check<E: TooMuch>(
    tolerance: &Rational,
    points: &[Point<Rational>],
    what: &str,
) -> Result<(), E> {
    positive::<E>(tolerance)?;
    let least = relative_tolerance(points, &Rational::new(1, 1 << LEAST_SHARE));
    if least.is_none_or(|least| *tolerance >= least) {
        return Ok(());
    }
    Err(E::too_much(format!(
        "as a distance of sets, a tolerance is at least 2^-{LEAST_SHARE} of the diagonal of the box around the \
         {what}; take a greater one, or compare at equal parameters"
    )))
}

/// A surface that can be looked at level by level.
pub(crate) trait Levels {
    type Error: TooMuch;

    /// How many faces there are.
    fn count(&self) -> usize;

    /// What is known of the faces that are asked for. Where `all` is false the search ends at the first face that is
    /// far. A face that is not in the result is near.
    fn examine(
        &mut self,
        level: u32,
        wanted: &[bool],
        all: bool,
    ) -> Result<Vec<(usize, MeshNearness)>, Self::Error>;

    /// A level that is sufficient at equal parameters, where that bounds the distance of the sets.
    fn parametric(&self) -> Result<Option<u32>, Self::Error>;

    /// Whether somebody has stopped the search.
    fn is_stopped(&self) -> bool;

    /// The least level that is sufficient.
    fn depth(&mut self) -> Result<GeometricDepth, Self::Error> {
        let wanted = vec![true; self.count()];
        let (mut places, mut certain) = (Vec::new(), true);
        // A level that equal parameters show to be sufficient, found when it is needed.
        let mut sure: Option<u32> = None;
        for level in 0..=MAX_LEVEL {
            if sure.is_some_and(|sure| sure <= level) {
                return Ok(GeometricDepth::new(level, places));
            }
            let found = self.examine(level, &wanted, false)?;
            let far = found.iter().find_map(|(_, known)| match known {
                MeshNearness::Far(place) => Some(place.clone()),
                _ => None,
            });
            let open = found.iter().any(|(_, known)| matches!(known, MeshNearness::Open));
            match far {
                Some(place) if certain => places.push(place),
                Some(_) => {}
                None if open => {
                    certain = false;
                    if self.is_stopped() {
                        break;
                    }
                    if sure.is_none() {
                        sure = self.parametric()?;
                    }
                    if sure.is_some_and(|sure| sure <= level) {
                        return Ok(GeometricDepth::new(level, places));
                    }
                }
                None => return Ok(GeometricDepth::new(level, places)),
            }
        }
        let stopped = self.is_stopped();
        let sure = sure.map_or_else(|| self.parametric(), |sure| Ok(Some(sure)));
        Ok(match sure {
            Ok(level) if stopped => GeometricDepth::ended(level, "the search was stopped", places),
            Ok(Some(level)) => GeometricDepth::new(level, places),
            Ok(None) => GeometricDepth::ended(None, too_many(), places),
            Err(error) => GeometricDepth::ended(None, error.to_string(), places),
        })
    }

    /// Whether a level is sufficient; `None` where that is open.
    fn is_within(&mut self, level: u32) -> Result<Option<bool>, Self::Error> {
        let found = self.examine(level, &vec![true; self.count()], false)?;
        if found.iter().any(|(_, known)| matches!(known, MeshNearness::Far(_))) {
            return Ok(Some(false));
        }
        let open = found.iter().any(|(_, known)| matches!(known, MeshNearness::Open));
        Ok((!open).then_some(true))
    }

    /// What each face needs.
    fn faces(&mut self) -> Result<Vec<FaceDepth>, Self::Error> {
        let none = FaceDepth { level: 0, is_least: true, too_far: None };
        let mut faces = vec![none; self.count()];
        let mut wanted = vec![true; faces.len()];
        for level in 0..=MAX_LEVEL {
            let mut next = vec![false; faces.len()];
            for (face, known) in self.examine(level, &wanted, true)? {
                match known {
                    MeshNearness::Near => continue,
                    MeshNearness::Open => faces[face].is_least = false,
                    MeshNearness::Far(place) => faces[face].too_far = Some((level, place.distance)),
                }
                faces[face].level = level + 1;
                next[face] = true;
            }
            if !next.contains(&true) {
                return Ok(faces);
            }
            wanted = next;
            if self.is_stopped() {
                break;
            }
        }
        // What is left is within the tolerance at the level at which all are.
        let Some(level) = self.parametric()? else {
            let stopped = "the search was stopped before every face had a level that is sufficient";
            let why = if self.is_stopped() { stopped.to_owned() } else { too_many() };
            return Err(Self::Error::too_much(why));
        };
        for (face, _) in faces.iter_mut().zip(wanted).filter(|(_, wanted)| *wanted) {
            face.is_least &= face.too_far.as_ref().is_some_and(|(far, _)| far + 1 == level);
            face.level = level;
        }
        Ok(faces)
    }

    /// Which of the faces that are asked for are within the tolerance of this search, of which `upper` is an upper bound;
    /// `bounds` are those of their distances.
    fn sharpen(
        &mut self,
        level: u32,
        upper: f64,
        wanted: &[bool],
        bounds: &mut [[f64; 2]],
    ) -> Result<Vec<bool>, Self::Error> {
        let mut near = wanted.to_vec();
        for (face, known) in self.examine(level, wanted, true)? {
            match known {
                MeshNearness::Near => continue,
                MeshNearness::Open => {}
                MeshNearness::Far(place) => bounds[face][0] = bounds[face][0].max(place.distance),
            }
            near[face] = false;
        }
        for (bounds, _) in bounds.iter_mut().zip(&near).filter(|(_, near)| **near) {
            bounds[1] = upper;
        }
        Ok(near)
    }
}

/// That the levels are too many.
fn too_many() -> String {
    format!(
        "the tolerance needs more than {MAX_LEVEL} levels as a distance of sets, or is too near to call; take a \
         greater one, or compare at equal parameters"
    )
}

/// For each face a lower and an upper bound of its distance: with upper bounds ε, ε/2, ε/4 or ε/8, or infinite where ε
/// is none, or is too small a tolerance. `search` makes the search for a tolerance.
pub(crate) fn distances<S: Levels>(
    level: u32,
    tolerance: &Rational,
    search: impl Fn(&Rational) -> Result<S, S::Error>,
) -> Result<Vec<[f64; 2]>, S::Error> {
    let (mut bounds, mut wanted) = (Vec::new(), Vec::new());
    for halved in 0..4 {
        let tolerance = tolerance * &Rational::new(1, 1_i64 << halved);
        let mut search = match search(&tolerance) {
            // The one before was large enough; there is no sharper bound.
            Err(_) if halved > 0 => break,
            search => search?,
        };
        if halved == 0 {
            bounds = vec![[0.0, f64::INFINITY]; search.count()];
            wanted = vec![true; search.count()];
        }
        wanted = search.sharpen(level, upper(&tolerance), &wanted, &mut bounds)?;
    }
    Ok(bounds)
}
