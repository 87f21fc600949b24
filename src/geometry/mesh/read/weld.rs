//! Points that are joined where they are near each other.

use super::super::point::Point;
use super::super::polygon::PolygonMesh;
use super::assemble::{Extras, Parts, Tag};
use crate::diagnostic::Diagnostic;
use crate::exact::{CommonDenominator, Integer, Rational};
use std::collections::{BTreeMap, HashMap, HashSet};

/// The most pairs of points whose distance is compared. A pair counts as often as its numerators over one denominator have
/// pairs of parts of so many bits.
const MAX_PAIRS: u64 = 20_000_000;
const UNIT_BITS: u64 = 1_024;

/// The most bits of the common denominator, times the number of points.
const MAX_BITS: u64 = 1 << 31;

/// A cube with an edge of half the tolerance: all its points are joined, and those of cubes more than two apart are not.
type Cube = [i64; 3];

impl Parts {
    /// Joins points at most `tolerance` apart, and those that a chain of such steps connects. The point of the least x, then y,
    /// then z stays. Nothing is joined where a face or a tag names a point that does not exist, which is an error of its own.
    pub(super) fn weld(&mut self, tolerance: &Rational) -> Result<(), Diagnostic> {
        if self.has_missing_point() {
            // An error of its own, with the numbers that points have in the file.
            return Ok(());
        }
        let mut sets = Sets((0..self.points.len()).collect());
        let near = if tolerance.sign() < 0 {
            Err("it is below 0".to_owned())
        } else {
            join(&self.points, tolerance, &mut sets)
        };
        near.map_err(|why| {
            let message = format!("points at most {tolerance} apart are not joined: {why}");
            Diagnostic::new(&self.places.source, 0..0, message).with_help("give another --weld")
        })?;
        // In each set, the point that stays.
        let mut least: BTreeMap<usize, usize> = BTreeMap::new();
        for point in 0..self.points.len() {
            let best = least.entry(sets.of(point)).or_insert(point);
            if self.points[point] < self.points[*best] {
                *best = point;
            }
        }
        // Numbers in the order in which sets are met first.
        let (mut numbers, mut next) = (HashMap::new(), 0);
        let mut new = Vec::with_capacity(self.points.len());
        let (mut points, mut places) = (Vec::new(), Vec::new());
        for point in 0..self.points.len() {
            let set = sets.of(point);
            let number = *numbers.entry(set).or_insert(next);
            if number == next {
                next += 1;
                points.push(self.points[least[&set]].clone());
                places.push(self.places.points[point].clone());
            }
            new.push(number);
        }
        let joined = self.points.len() - points.len();
        let renamed = |point: usize| new[point];
        let mut lost = [0_usize; 2];
        self.merge_corners(renamed, &mut lost);
        if self.faces.is_empty() && lost[1] > 0 {
            let message = format!(
                "no face is left where points at most {tolerance} apart are joined: all {} have fewer than 3 corners \
                 then",
                lost[1]
            );
            return Err(Diagnostic::new(&self.places.source, 0..0, message)
                .with_help("give a lesser distance to --weld"));
        }
        for (tag, _) in &mut self.extras.tags {
            match tag {
                Tag::Crease(ends, _) => *ends = ends.map(renamed),
                Tag::Corner(vertex, _) => *vertex = renamed(*vertex),
                Tag::Hole(_) => {}
            }
        }
        // A crease between two points that are one is none.
        self.extras.tags.retain(|(tag, _)| !matches!(tag, Tag::Crease([a, b], _) if a == b));
        (self.points, self.places.points) = (points, places);
        let [corners, faces] = lost;
        let dropped = match (corners, faces) {
            (0, 0) => String::new(),
            _ => format!(
                "; {corners} corners that are the same as the one before are left out, and {faces} faces of fewer \
                 than 3 corners dropped"
            ),
        };
        let left = self.points.len();
        let [apart, from] = if tolerance.is_zero() {
            ["equal".to_owned(), "equal to another".to_owned()]
        } else {
            [format!("at most {tolerance} apart"), format!("at most {tolerance} from another")]
        };
        let note = match joined {
            0 => format!("no points are {apart}, and none is joined"),
            _ => format!(
                "{joined} points {from} are joined with it, {left} are left, and those after them move up{dropped}"
            ),
        };
        self.extras.notes.push(note);
        Ok(())
    }

    /// Whether a face or a tag names a point that does not exist.
    fn has_missing_point(&self) -> bool {
        let missing = |point: &usize| *point >= self.points.len();
        let of_tags = self.extras.tags.iter().any(|(tag, _)| match tag {
            Tag::Crease(ends, _) => ends.iter().any(missing),
            Tag::Corner(vertex, _) => missing(vertex),
            Tag::Hole(_) => false,
        });
        of_tags || self.faces.iter().flatten().any(missing)
    }

    /// Gives the corners of faces their new numbers, without those that are the same as the one before, and drops faces of fewer
    /// than three. Counts corners and faces that are `lost`.
    fn merge_corners(&mut self, renamed: impl Fn(usize) -> usize, lost: &mut [usize; 2]) {
        let mut keep = Vec::with_capacity(self.faces.len());
        let textured = &mut self.extras.textured;
        for (face, corners) in self.faces.iter_mut().enumerate() {
            let before = corners.len();
            for corner in corners.iter_mut() {
                *corner = renamed(*corner);
            }
            let count = corners.len();
            let stays: Vec<bool> =
                (0..count).map(|i| corners[i] != corners[(i + count - 1) % count]).collect();
            let shrink = |list: &mut Vec<usize>| {
                let mut stays = stays.iter();
                list.retain(|_| stays.next() == Some(&true));
            };
            shrink(corners);
            if let Some(own) = textured.get_mut(face).and_then(Option::as_mut) {
                shrink(own);
            }
            lost[0] += before - corners.len();
            // A face that had too few corners before is an error of its own.
            keep.push(corners.len() >= 3 || corners.len() == before);
        }
        lost[1] = keep.iter().filter(|keep| !**keep).count();
        if lost[1] == 0 {
            return;
        }
        retain(&mut self.faces, &keep);
        retain(&mut self.places.faces, &keep);
        retain(&mut self.extras.textured, &keep);
        Extras::renumber_holes(&mut self.extras.tags, &keep);
    }
}

impl Extras {
    /// Gives holes the numbers of the faces that are kept.
    fn renumber_holes(tags: &mut Vec<(Tag, std::ops::Range<usize>)>, keep: &[bool]) {
        let mut next = 0;
        let numbers: Vec<usize> = keep
            .iter()
            .map(|keep| {
                next += usize::from(*keep);
                next.saturating_sub(1)
            })
            .collect();
        tags.retain(|(tag, _)| !matches!(tag, Tag::Hole(face) if keep.get(*face) == Some(&false)));
        for (tag, _) in tags {
            if let Tag::Hole(face) = tag {
                *face = numbers.get(*face).copied().unwrap_or(*face);
            }
        }
    }
}

fn retain<T>(list: &mut Vec<T>, keep: &[bool]) {
    let mut keep = keep.iter();
    list.retain(|_| keep.next() != Some(&false));
}

/// Joins the sets of all pairs of points at most `tolerance` apart; or why not.
fn join(points: &[Point<Rational>], tolerance: &Rational, sets: &mut Sets) -> Result<(), String> {
    let mut first: HashMap<&Point<Rational>, usize> = HashMap::with_capacity(points.len());
    for (number, point) in points.iter().enumerate() {
        let other = *first.entry(point).or_insert(number);
        sets.join(number, other);
    }
    if tolerance.is_zero() {
        return Ok(());
    }
    let scale = Rational::from(2) / tolerance.clone();
    let mut cubes: HashMap<Cube, Vec<usize>> = HashMap::new();
    for (point, number) in first {
        let mut cube = [0; 3];
        for (place, x) in cube.iter_mut().zip(point) {
            // So that neighbours are numbers, too.
            let number = (x * &scale).floor().to_i64().filter(|n| n.unsigned_abs() < 1 << 60);
            *place = number.ok_or("it is too small for the coordinates")?;
        }
        cubes.entry(cube).or_default().push(number);
    }
    // As integers: fractions would be reduced for every pair.
    let rows: Vec<Vec<Rational>> =
        std::iter::once(vec![tolerance.clone()]).chain(points.iter().map(|p| p.to_vec())).collect();
    let mut denominator = Integer::one();
    for x in rows.iter().flatten() {
        denominator = denominator.lcm(&x.denominator());
        if denominator.bits().saturating_mul(points.len() as u64) > MAX_BITS {
            return Err("their coordinates have too large a common denominator".to_owned());
        }
    }
    let longest = points.iter().flatten().map(Rational::bits).max().unwrap_or(0);
    let parts = (denominator.bits() + longest) / UNIT_BITS + 1;
    let weight = parts.saturating_mul(parts);
    let CommonDenominator { numerators, .. } = CommonDenominator::of(&rows);
    let square = &numerators[0][0] * &numerators[0][0];
    let near = |a: usize, b: usize| {
        let side = |i: usize| &numerators[a + 1][i] - &numerators[b + 1][i];
        let sides = [side(0), side(1), side(2)];
        sides.iter().fold(Integer::zero(), |sum, side| sum + side * side) <= square
    };
    let mut pairs = 0_u64;
    for own in cubes.values() {
        for number in own {
            sets.join(*number, own[0]);
        }
    }
    // In order, so that the cap does not depend on chance.
    let mut all: Vec<(&Cube, &Vec<usize>)> = cubes.iter().collect();
    all.sort_unstable();
    for (cube, own) in all {
        for other in neighbours(cube).iter().filter_map(|cube| cubes.get(cube)) {
            if sets.of(own[0]) == sets.of(other[0]) {
                continue;
            }
            let more = (own.len() as u64).saturating_mul(other.len() as u64);
            pairs = pairs.saturating_add(more.saturating_mul(weight));
            if pairs > MAX_PAIRS {
                let most = MAX_PAIRS / weight;
                return Err(format!(
                    "more than {most} pairs of points of so many digits would be compared"
                ));
            }
            if own.iter().any(|a| other.iter().any(|b| near(*a, *b))) {
                sets.join(own[0], other[0]);
            }
        }
    }
    Ok(())
}

/// Half of the cubes at most two apart, so that each pair is met once.
fn neighbours(cube: &Cube) -> Vec<Cube> {
    let offsets =
        (-2..=2).flat_map(|x| (-2..=2).flat_map(move |y| (-2..=2).map(move |z| [x, y, z])));
    let later = offsets.filter(|offset| *offset > [0, 0, 0]);
    later.map(|[x, y, z]| [cube[0] + x, cube[1] + y, cube[2] + z]).collect()
}

/// Disjoint sets: each number has another one of its set, or itself.
struct Sets(Vec<usize>);

impl Sets {
    /// The number that stands for the set of this one.
    fn of(&mut self, mut number: usize) -> usize {
        while self.0[number] != number {
            self.0[number] = self.0[self.0[number]];
            number = self.0[number];
        }
        number
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        let (low, high) = (a.min(b), a.max(b));
        self.0[high] = low;
    }
}

/// A note on a mesh whose faces have no edge in common.
pub(super) fn unwelded(mesh: &PolygonMesh<Rational>) -> Option<String> {
    let edges = mesh.connectivity().edges();
    if mesh.faces().len() < 2 || edges.iter().any(|edge| edge.other.is_some()) {
        return None;
    }
    let different: HashSet<&Point<Rational>> = mesh.points().iter().collect();
    let (count, different) = (mesh.points().len(), different.len());
    let advice = if different < count {
        format!(
            "; its {count} points are at {different} places, and --weld joins those at one place"
        )
    } else {
        String::new()
    };
    Some(format!(
        "no two faces have an edge in common, so that every edge is at the boundary{advice}"
    ))
}
