//! Hexahedral solids: the certified level against limit points of deep levels, grids, and laws.

use crate::common::hausdorff::{Plain, Rule, distances as hausdorff};
use crate::common::r;
use crate::common::solids::{Solid, grid, moved, origins, solids, star, tetrahedron};
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, Point, PolygonMesh, limit_points, refine_mesh};
use subcert::patch::{FaceSurface, MeshDepth, MeshDistances, solid_a_priori, solid_formula_level};
use subcert::solid::{HexMesh, refine_solid, solid_limit_points};

type P = Point<f64>;

fn depth(solid: &Solid, tolerance: &Rational) -> MeshDepth {
    let distances = MeshDistances::of_solid(solid.clone()).expect("a solid within the caps");
    distances.depth(tolerance).expect("a depth")
}

fn length(p: &P, q: &P) -> f64 {
    (0..3).map(|i| (p[i] - q[i]).powi(2)).sum::<f64>().sqrt()
}

fn rounded(points: &[Point<Rational>]) -> Vec<P> {
    points.iter().map(|point| point.each_ref().map(nearest)).collect()
}

/// The level whose limit points are the samples.
const SAMPLED: u32 = 3;

/// The points of the levels up to the sampled one, of what each point of the next is in the middle, and
/// the limit points.
struct Samples {
    points: Vec<Vec<P>>,
    origins: Vec<Vec<Vec<usize>>>,
    limits: Vec<P>,
}

impl Samples {
    fn of(solid: &Solid) -> Samples {
        let (mut points, mut all, mut mesh) = (Vec::new(), Vec::new(), solid.clone());
        for _ in 0..SAMPLED {
            let refined = refine_solid(&mesh, 1).expect("small");
            points.push(rounded(mesh.points()));
            all.push(origins(&mesh, &refined));
            mesh = refined;
        }
        points.push(rounded(mesh.points()));
        Samples { points, origins: all, limits: rounded(&solid_limit_points(&mesh)) }
    }

    /// The greatest distance of the limit points from the trilinear cells of a level, at the same parameters.
    fn far(&self, level: u32) -> f64 {
        let mut values = self.points[level as usize].clone();
        for origins in &self.origins[level as usize..] {
            let at = |key: &Vec<usize>| -> P {
                let share = 1.0 / f64::from(u32::try_from(key.len()).expect("few"));
                [0, 1, 2].map(|i| key.iter().map(|&k| values[k][i]).sum::<f64>() * share)
            };
            values = origins.iter().map(at).collect();
        }
        values.iter().zip(&self.limits).map(|(p, q)| length(p, q)).fold(0.0, f64::max)
    }
}

/// No sampled limit point of any level from the certified one on is beyond the tolerance; at the level
/// below, the witness is; and the enclosure of the distance holds those of the samples.
fn attacked(solid: &Solid, samples: &Samples, tolerance: &Rational) -> usize {
    let found = depth(solid, tolerance);
    let limit = nearest(tolerance);
    let [lower, upper] = found.distance;
    assert!(lower <= upper && upper <= limit * (1.0 + 1e-9), "{found:?}");
    let mut count = 0;
    for level in 0..=found.level.min(SAMPLED) {
        let far = samples.far(level);
        count += samples.limits.len();
        if level >= found.level {
            assert!(far <= limit, "level {level}: {far} > {limit}");
            assert!(far <= upper * (1.0 + 1e-9) || level > found.level, "{far} > {upper}");
            // Vertices alone are not where the distance is greatest.
            let sharp = level == found.level && level < 2;
            assert!(!sharp || far >= 0.5 * lower, "{far} of {lower}");
        }
    }
    match (found.too_few, &found.beyond) {
        (None, None) => {}
        (Some(few), Some(place)) => {
            assert!(few < found.level);
            assert!(length(&place.on_mesh, &place.on_limit) > limit);
            if few < 2 {
                let far = samples.far(few);
                assert!(far > 0.5 * limit, "{far} at level {few}, which is too few for {limit}");
            }
        }
        other => panic!("{other:?}"),
    }
    count
}

#[test]
fn sampled_limit_points_are_within_the_tolerance() {
    let mut count = 0;
    for solid in solids() {
        let samples = Samples::of(&solid);
        for tolerance in [r(4, 1), r(2, 1), r(1, 1)] {
            count += attacked(&solid, &samples, &tolerance);
        }
    }
    assert!(count > 20_000, "{count}");
}

proptest! {
    #![proptest_config(crate::common::cases(6))]

    #[test]
    fn on_any_points(star in moved(star(3, 2, true)), four in moved(tetrahedron())) {
        attacked(&star, &Samples::of(&star), &r(2, 1));
        attacked(&four, &Samples::of(&four), &r(2, 1));
    }

    /// The corner of a box with a part cut out, and a box.
    #[test]
    fn on_any_boundary(
        concave in moved(grid([2, 2, 2], |cell| cell != [1, 1, 1])),
        convex in moved(grid([3, 3, 3], |_| true)),
    ) {
        attacked(&concave, &Samples::of(&concave), &r(3, 1));
        attacked(&convex, &Samples::of(&convex), &r(3, 1));
    }
}

/// A parabola over a grid, far from its edges: (i² + j² + k²)/2 as a coordinate has second differences 1,
/// and 1/6 of each of three is the distance at inner vertices.
#[test]
fn second_differences_of_a_parabola() {
    let count = 7;
    let flat = grid([count, count, count], |_| true);
    let mut points =
        vec![[Rational::zero(), Rational::zero(), Rational::zero()]; flat.points().len()];
    for (index, cell) in flat.cells().iter().enumerate() {
        let at = [index % count, index / count % count, index / (count * count)];
        for (place, bits) in crate::common::solids::FILE_ORDER.into_iter().enumerate() {
            let at = [0, 1, 2].map(|i| at[i] + (bits >> i & 1));
            let square: usize = at.iter().map(|x| x * x).sum();
            let [x, y, _] = at.map(Rational::from);
            points[cell[place]] = [x, y, Rational::from(square) * r(1, 2)];
        }
    }
    let solid = flat.with_points(points);
    let distances = MeshDistances::of_solid(solid).expect("within the caps");
    for level in 0..3 {
        let bounds = distances.faces(level);
        let middle = (count / 2) * (1 + count + count * count);
        let [lower, upper] = bounds[middle];
        let expected = 0.5 * 0.25_f64.powi(i32::try_from(level).expect("small"));
        assert!(lower <= expected * (1.0 + 1e-9) && expected <= upper * (1.0 + 1e-9));
        assert!(upper - lower <= 0.06 * expected, "{lower} {upper} {expected}");
    }
}

/// A turn by a Pythagorean angle, a stretch by 5, and a move far away.
fn similar(point: &Point<Rational>) -> Point<Rational> {
    let [x, y, z] = point;
    let times = |factor: i64, x: &Rational| Rational::from(factor) * x;
    [
        times(3, y) + times(4, z) + Rational::from(1_000_000_000_007_i64),
        times(5, x) - Rational::from(3),
        times(4, y) - times(3, z),
    ]
}

#[test]
fn similarities_and_numbers() {
    for solid in solids() {
        let here = depth(&solid, &r(1, 1));
        let image = solid.with_points(solid.points().iter().map(similar).collect());
        let there = depth(&image, &r(5, 1));
        assert_eq!((here.level, here.too_few), (there.level, there.too_few));
        for (x, y) in here.distance.iter().zip(there.distance) {
            assert!((5.0 * x - y).abs() <= 0.05 * y.abs(), "{x} {y}");
        }
        let turned = |[a, b, c, d, e, f, g, h]: [usize; 8]| [b, f, g, c, a, e, h, d];
        let cells: Vec<[usize; 8]> = solid.cells().into_iter().rev().map(turned).collect();
        let other = HexMesh::new(solid.points().to_vec(), &cells).expect("the same solid");
        let other = depth(&other, &r(1, 1));
        assert_eq!((here.level, here.too_few), (other.level, other.too_few));
    }
}

/// A refined solid needs a level less, what it guarantees a priori is enough, and smaller tolerances need
/// more levels.
#[test]
fn levels_and_bounds_are_in_order() {
    for solid in solids() {
        let found = depth(&solid, &r(1, 1));
        let next = refine_solid(&solid, 1).expect("small");
        let later = depth(&next, &r(1, 1));
        // What is certain of one is not against what is certain of the other.
        let enough = later.level.max(found.level.saturating_sub(1));
        assert!(later.too_few.is_none_or(|few| few < found.level.saturating_sub(1)), "{found:?}");
        assert!(found.too_few.is_none_or(|few| few < later.level + 1), "{later:?}");
        assert!(enough <= later.level + 1, "{found:?} {later:?}");
        assert!(depth(&solid, &r(1, 3)).level >= found.level);
        let distances = MeshDistances::of_solid(solid.clone()).expect("within the caps");
        let guaranteed = solid_a_priori(&solid, &distances, &r(1, 1)).expect("a level");
        assert!(guaranteed.level >= found.level, "{guaranteed:?}");
        assert!(guaranteed.ratio < 1.0, "{guaranteed:?}");
    }
}

/// Points move by 3/4 of the longest edge at most in the first step: level 0 needs so much more than level 1.
#[test]
fn what_the_first_step_guarantees() {
    let cube = crate::common::solids::grid([1, 1, 1], |_| true);
    let distances = MeshDistances::of_solid(cube.clone()).expect("within the caps");
    let guaranteed =
        |tolerance: &Rational| solid_a_priori(&cube, &distances, tolerance).expect("a level");
    let least = |level: u32| {
        let (mut low, mut high) = (r(0, 1), r(1_000, 1));
        for _ in 0..40 {
            let middle = (&low + &high) / Rational::from(2);
            if guaranteed(&middle).level <= level { high = middle } else { low = middle }
        }
        nearest(&high)
    };
    let more = (least(0) - least(1)) / guaranteed(&r(1, 1)).longest_edge;
    assert!((more - 0.75).abs() < 1e-6, "{more}");
}

/// 23/12·(3/4)^k β ≤ ε, for the longest edge of the boundary.
#[test]
fn the_formula_of_the_paper() {
    let cube = crate::common::solids::grid([1, 1, 1], |_| true);
    let points = (0..8_usize).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from));
    let cells = cube.cells();
    let order: Vec<usize> = cells[0].to_vec();
    let mut placed = vec![[0, 0, 0].map(Rational::from); 8];
    for (place, point) in crate::common::solids::FILE_ORDER.into_iter().zip(order) {
        placed[point] = points.clone().nth(place).expect("8");
    }
    let cube = cube.with_points(placed);
    assert_eq!(solid_formula_level(&cube, &r(2, 1)), Ok(0));
    // 23/12·(3/4)^19 = 0.0081…, and for 18 it is 0.0108….
    assert_eq!(solid_formula_level(&cube, &r(1, 100)), Ok(19));
}

/// A distance that is the tolerance exactly is within it, and no f64 can say so.
#[test]
fn too_near_to_call() {
    let cube = crate::common::solids::grid([1, 1, 1], |_| true);
    // The corners of a box of 9, 18 and 18 move by 2/9 of each: 6 in all.
    let mut points = cube.points().to_vec();
    for (place, bits) in crate::common::solids::FILE_ORDER.into_iter().enumerate() {
        let at = |i: usize, length: usize| Rational::from(length * (bits >> i & 1));
        points[cube.cells()[0][place]] = [at(0, 9), at(1, 18), at(2, 18)];
    }
    let cube = cube.with_points(points);
    // Bounds at an irregular vertex come near to the tolerance, and never below it.
    let found = depth(&cube, &r(6, 1));
    assert_eq!((found.level, found.too_few), (1, None), "{found:?}");
    assert!(found.exact_pieces > 0, "{found:?}");
    let less = Rational::from(6) - r(1, 10).pow(30);
    let found = depth(&cube, &less);
    assert_eq!(found.too_few, Some(0), "{found:?}");
    assert!(found.exact_pieces > 0, "{found:?}");
}

/// What `surface` has as a mesh of the tests' own code.
fn plain(surface: &PolygonMesh<Rational>) -> Plain {
    Plain { points: rounded(surface.points()), faces: surface.faces().to_vec() }
}

/// The boundary of the levels, and of their limits, is that of the surface that the boundary is.
#[test]
fn the_boundary_is_a_surface_of_its_own() {
    for solid in solids() {
        let boundary = solid.boundary().expect("one");
        let limits = solid_limit_points(&solid);
        let real = boundary.mesh.map(|x| RealCyclotomic::from(x.clone()));
        let surface = limit_points(&real, MeshScheme::Bajaj).expect("small");
        for (&point, limit) in boundary.points.iter().zip(&surface) {
            let limit = &limit.as_ref().expect("a closed surface").position;
            assert_eq!(
                limit.each_ref().map(|x| x.as_rational()),
                limits[point].each_ref().map(Some)
            );
        }
        let refined = refine_solid(&solid, 2).expect("small").boundary().expect("one").mesh;
        let alone = refine_mesh(&real, MeshScheme::Bajaj, 2).expect("small");
        let faces = |faces: &[Vec<usize>], at: &dyn Fn(usize) -> Point<Rational>| {
            let mut all: Vec<Vec<Point<Rational>>> =
                faces.iter().map(|face| face.iter().map(|&v| at(v)).collect()).collect();
            for face in &mut all {
                face.sort();
            }
            all.sort();
            all
        };
        let exact = |v: usize| {
            let point = alone.points()[v].each_ref();
            point.map(|x| x.as_rational().expect("rational weights").clone())
        };
        let own = faces(refined.faces(), &|v| refined.points()[v].clone());
        assert_eq!(own, faces(alone.faces(), &exact));
    }
}

/// As sets of points, the boundary needs the levels that dense samples say.
#[test]
fn the_boundary_as_a_set_of_points() {
    let all = solids();
    let mut least = 0;
    for (solid, tolerances) in [(&all[0], [r(1, 2), r(1, 5)]), (&all[3], [r(4, 3), r(2, 5)])] {
        let boundary = solid.boundary().expect("one").mesh;
        let sampled = hausdorff(&plain(&boundary), Rule::Bajaj, 3, 4, 3);
        let distances = MeshDistances::new(boundary, MeshScheme::Bajaj).expect("small");
        for tolerance in tolerances {
            let found =
                distances.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few levels");
            let level = sampled.iter().position(|&x| x <= nearest(&tolerance)).expect("a level");
            let least_level = found.level.expect("a level");
            assert_eq!(least_level as usize, level, "{tolerance}, {sampled:?}");
            least += usize::from(found.too_few.is_some_and(|few| few as usize + 1 == level));
            let of_cells = depth(solid, &tolerance).level;
            assert!(least_level <= of_cells, "the boundary is a part of the solid");
        }
    }
    assert!(least >= 3, "{least} levels are the least ones");
}
