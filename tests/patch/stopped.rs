//! Searches that are stopped: what they say holds, and is less.

use super::{cube, depth, tetrahedron};
use crate::common::r;
use std::sync::Arc;
use subcert::mesh::{MeshScheme, Point};
use subcert::net::{Closed, Net, NetScheme};
use subcert::patch::{FaceSurface, MeshDepth, MeshDistances, MeshWork, NetDistances};

fn stopped() -> Arc<MeshWork> {
    let work = Arc::<MeshWork>::default();
    work.stop();
    work
}

/// The level suffices, none is said not to, and the bounds are around the distance.
fn holds(found: &MeshDepth, whole: &MeshDepth) {
    assert!(whole.too_few.is_some(), "there is something to search");
    assert!(found.level >= whole.level);
    assert_eq!((found.too_few, found.exact_pieces), (None, 0));
    if found.level == whole.level {
        assert!(found.distance[0] <= whole.distance[0] && whole.distance[1] <= found.distance[1]);
    }
}

#[test]
fn meshes_and_nets() {
    let tolerance = r(1, 100);
    for scheme in [MeshScheme::CatmullClark, MeshScheme::DooSabin] {
        let distances = MeshDistances::new(cube(), scheme).expect("a closed mesh");
        let found = distances.with_work(stopped()).depth(&tolerance).expect("a level");
        holds(&found, &depth(&cube(), scheme, &tolerance));
    }
    let point = |k: u32| -> Point<_> { [k % 5, k / 5, k * k % 7].map(|x| i64::from(x).into()) };
    let points: Vec<_> = (0..25).map(point).collect();
    let net = Net::new(points, 5, Closed { u: false, v: true }).expect("a net");
    let scheme = NetScheme::parse("chaikin x four-point:w=1/16").expect("a scheme");
    let distances = || NetDistances::new(net.clone(), &scheme).expect("a net within the caps");
    let found = distances().with_work(stopped()).depth(&tolerance).expect("a level");
    holds(&found, &distances().depth(&tolerance).expect("a level"));
}

/// As sets of points: a level is sufficient by equal parameters where these bound the distance, and else none is known.
#[test]
fn as_sets_of_points() {
    let tolerance = r(1, 100);
    for (scheme, mesh, surface, known) in [
        (MeshScheme::CatmullClark, cube(), FaceSurface::Bilinear, true),
        (MeshScheme::CatmullClark, cube(), FaceSurface::Fan, false),
        (MeshScheme::DooSabin, tetrahedron(), FaceSurface::Bilinear, false),
        (MeshScheme::Loop, tetrahedron(), FaceSurface::Bilinear, true),
    ] {
        let distances = || MeshDistances::new(mesh.clone(), scheme).expect("small");
        let whole = distances().geometric_depth(&tolerance, surface).expect("a depth");
        assert!(whole.too_few.is_some() && whole.ended.is_none());
        let ended = distances().with_work(stopped());
        let found = ended.geometric_depth(&tolerance, surface).expect("what is proved");
        // What a few points show at once is said all the same.
        assert!(found.level.is_some() == known && found.too_few <= whole.too_few, "{found:?}");
        assert!(found.level.is_none_or(|level| Some(level) >= whole.level));
        assert!(found.ended.is_some_and(|why| why.contains("stopped")));
        let faces = ended.geometric_faces(&tolerance, surface);
        assert_eq!(faces.is_ok(), known, "{scheme:?}");
        let own = distances().geometric_faces(&tolerance, surface).expect("few levels");
        for (face, own) in faces.into_iter().flatten().zip(own) {
            assert!(face.level >= own.level && !face.is_least, "{face:?}, {own:?}");
        }
    }
}
