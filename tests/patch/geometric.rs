//! The distance of meshes from their limits as sets of points, against dense samples.

use super::{Mesh, cube, mesh};
use crate::common::hausdorff::{Rule, distances as dense};
use crate::common::hausdorff_cases::{Case, cases};
use crate::common::r;
use subcert::diagnostic::SourceText;
use subcert::float::nearest;
use subcert::mesh::{MeshFormat, MeshScheme, read_mesh};
use subcert::patch::{FaceSurface, MeshDistances};

fn scheme(rule: Rule) -> MeshScheme {
    match rule {
        Rule::CatmullClark => MeshScheme::CatmullClark,
        Rule::Bajaj => MeshScheme::Bajaj,
        Rule::DooSabin => MeshScheme::DooSabin,
        Rule::Loop => MeshScheme::Loop,
    }
}

fn exact(case: &Case) -> Mesh {
    mesh(&case.points, case.faces.clone())
}

/// A case at its first tolerances: the whole table is `benches/hausdorff.rs`.
fn agrees(name: &str, rule: Rule, count: usize) {
    let all = cases();
    let case = all.iter().find(|case| case.name == name && case.rule == rule).expect("there");
    let sampled = dense(&case.plain(), rule, 4, 5, 3);
    let distances = MeshDistances::new(exact(case), scheme(rule)).expect("small");
    for &(p, q) in &case.tolerances[..count] {
        let depth = distances.geometric_depth(&r(p, q), FaceSurface::Bilinear).expect("few levels");
        let tolerance = nearest(&r(p, q));
        let level = sampled.iter().position(|&x| x <= tolerance);
        let level = level.unwrap_or_else(|| panic!("{name}, {tolerance}: {sampled:?}"));
        assert_eq!(
            depth.level.map(|level| level as usize),
            Some(level),
            "{name}, {tolerance}, {sampled:?}, {depth:?}"
        );
        assert_eq!(depth.too_few, level.checked_sub(1).and_then(|x| u32::try_from(x).ok()));
        if let Some(place) = depth.beyond {
            let sampled = sampled[level - 1];
            assert!(place.distance > tolerance && place.distance <= sampled * 1.02);
        }
    }
}

#[test]
fn the_least_level_is_that_of_dense_samples() {
    agrees("cube", Rule::CatmullClark, 2);
    agrees("cube", Rule::DooSabin, 2);
    agrees("tetrahedron", Rule::Loop, 2);
    agrees("bipyramid of 8", Rule::Loop, 2);
    agrees("trapezohedron of 7", Rule::CatmullClark, 1);
    agrees("prism of 5", Rule::DooSabin, 2);
}

/// Meshes whose first levels have no inner vertex, or none that is regular.
#[test]
fn meshes_of_one_face() {
    let corners = [[0, 0, 0], [3, 0, 0], [3, 2, 1], [0, 3, 0], [-2, 1, 1]];
    for (count, scheme) in [
        (3, MeshScheme::Loop),
        (3, MeshScheme::LoopWarren),
        (3, MeshScheme::CatmullClark),
        (4, MeshScheme::CatmullClark),
        (5, MeshScheme::CatmullClark),
    ] {
        let one = mesh(&corners[..count], vec![(0..count).collect()]);
        let distances = MeshDistances::new(one, scheme).expect("small");
        let tolerance = r(1, 50);
        let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few");
        let parametric = distances.depth(&tolerance).expect("few");
        let levels = 1..=parametric.level;
        assert!(depth.level.is_some_and(|level| levels.contains(&level)), "{count}: {depth:?}");
    }
}

#[test]
fn the_eye_needs_fewer_levels_than_equal_parameters() {
    let distances = MeshDistances::new(cube(), MeshScheme::DooSabin).expect("small");
    let tolerance = r(1, 450);
    let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few");
    let parametric = distances.without_apart().depth(&tolerance).expect("few");
    assert!(depth.level.is_some_and(|level| level < parametric.level), "{depth:?}, {parametric:?}");
}

/// Two sharp quadrilaterals far from flat: pieces are near to a part of one, and not near to the plane of all of it.
#[test]
fn a_bilinear_face_is_divided_like_the_limit() {
    let text = "v 9/8 1/4 5/16\nv 19/8 1/8 -1/2\nv 9/8 17/16 7/16\nv 2 23/16 0\nv 7/8 35/16 -5/16\nv 2 39/16 5/16\n\
                f 1 2 4 3\nf 3 4 6 5\n\
                t crease 2/1/0 2 3 2\nt corner 1/1/0 2 1/2\nt corner 1/1/0 4 2\nt interpolateboundary 1/0/0 1\n";
    let file = read_mesh(&SourceText::new("sharp.obj", text), MeshFormat::Obj).expect("a mesh");
    let distances =
        MeshDistances::new(file.mesh().clone(), MeshScheme::CatmullClark).expect("small");
    for (tolerance, least) in [(r(1, 25), 0), (r(1, 50), 3_u32)] {
        let depth = distances.geometric_depth(&tolerance, FaceSurface::Bilinear).expect("few");
        assert_eq!(
            (depth.level, depth.too_few),
            (Some(least), least.checked_sub(1)),
            "{tolerance}"
        );
    }
}
