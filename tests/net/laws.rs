//! Laws of refinement and limits.

use super::{CLOSED, bumpy, nets, scheme};
use crate::common::r;
use proptest::prelude::*;
use std::collections::BTreeSet;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::mesh::{MeshScheme, Point, limit_points, refine_mesh};
use subcert::net::{Closed, Net, net_limits, net_of_limits, refine_net};

const NAMES: [&str; 5] = [
    "bicubic",
    "chaikin x b-spline:degree=4",
    "four-point:w=1/16 x chaikin",
    "ternary-three-point:a=7/27 x bicubic",
    "quaternary-four-point:mu=1/50 x chaikin",
];

/// `bicubic` is a name of nets alone.
fn names() -> impl Strategy<Value = String> {
    prop::sample::select(&NAMES[..])
        .prop_map(|name| name.replace(" x bicubic", " x b-spline:degree=3"))
}

/// An affine map with fractions.
fn affine([x, y, z]: &Point<Rational>) -> Point<Rational> {
    [x * r(2, 3) + y - z + r(5, 7), y * r(-3, 1) + x + r(1, 9), z + x * r(1, 2) - r(4, 1)]
}

fn mapped(net: &Net) -> Net {
    let points = net.points().iter().map(affine).collect();
    Net::new(points, net.columns(), net.closed()).expect("a net")
}

/// The net with rows and columns exchanged.
fn turned(net: &Net) -> Net {
    let (rows, columns) = (net.rows(), net.columns());
    let point = |k: usize| net.points()[k % rows * columns + k / rows].clone();
    let closed = Closed { u: net.closed().v, v: net.closed().u };
    Net::new((0..rows * columns).map(point).collect(), rows, closed).expect("a net")
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn affine_maps_commute_with_refinement_and_limits(net in nets(7, 7), name in names()) {
        let scheme = scheme(&name);
        let refined = refine_net(&net, &scheme, 1).expect("a net");
        prop_assert_eq!(mapped(&refined), refine_net(&mapped(&net), &scheme, 1).expect("a net"));
        let limits = net_limits(&net, &scheme).expect("limits");
        let limits: Vec<_> = limits.iter().map(|limit| limit.as_ref().map(affine)).collect();
        prop_assert_eq!(limits, net_limits(&mapped(&net), &scheme).expect("limits"));
    }

    #[test]
    fn a_refinement_of_a_refinement(net in nets(7, 7), name in names()) {
        let scheme = scheme(&name);
        let once = refine_net(&net, &scheme, 1).expect("a net");
        let twice = refine_net(&net, &scheme, 2).expect("a net");
        prop_assert_eq!(refine_net(&once, &scheme, 1).expect("a net"), twice);
    }

    #[test]
    fn directions_can_be_exchanged(net in nets(7, 7), name in names()) {
        let scheme = scheme(&name);
        let halves: Vec<&str> = name.split(" x ").collect();
        let other = match halves[..] {
            [first, second] => super::scheme(&format!("{second} x {first}")),
            _ => scheme.clone(),
        };
        let refined = refine_net(&net, &scheme, 1).expect("a net");
        prop_assert_eq!(turned(&refined), refine_net(&turned(&net), &other, 1).expect("a net"));
    }
}

fn sorted(points: impl IntoIterator<Item = Point<RealCyclotomic>>) -> Vec<[String; 3]> {
    let mut texts: Vec<[String; 3]> =
        points.into_iter().map(|point| point.map(|x| x.to_string())).collect();
    texts.sort();
    texts
}

/// A closed net has four faces at each vertex: Catmull and Clark's rules, and Doo and Sabin's, give the same points,
/// and the same limit points.
#[test]
fn closed_nets_are_meshes_of_valence_four() {
    for (name, of_meshes) in
        [("bicubic", MeshScheme::CatmullClark), ("b-spline:degree=2", MeshScheme::DooSabin)]
    {
        let scheme = scheme(name);
        let net = bumpy(5, 4, CLOSED[3]);
        let mesh = net.mesh().expect("a surface").map(|x| RealCyclotomic::from(x.clone()));
        for level in 1..3 {
            let of_net = refine_net(&net, &scheme, level).expect("a net");
            let of_mesh = refine_mesh(&mesh, of_meshes, level).expect("a mesh");
            let points = of_net.map(|x| RealCyclotomic::from(x.clone())).points().to_vec();
            assert_eq!(sorted(points), sorted(of_mesh.points().to_vec()), "{name}");
            // The faces are the same sets of points, in the same sense.
            let of_net = of_net.mesh().expect("a surface").map(|x| RealCyclotomic::from(x.clone()));
            let faces =
                |mesh: &subcert::mesh::PolygonMesh<RealCyclotomic>| -> BTreeSet<Vec<String>> {
                    let corner = |face: &Vec<usize>, k: usize| {
                        format!(
                            "{:?}",
                            mesh.points()[face[k % 4]].each_ref().map(ToString::to_string)
                        )
                    };
                    let turned = |face: &Vec<usize>| {
                        (0..4)
                            .map(|k| (k..k + 4).map(|k| corner(face, k)).collect())
                            .min()
                            .expect("four")
                    };
                    mesh.faces().iter().map(turned).collect()
                };
            assert_eq!(faces(&of_net), faces(&of_mesh), "{name}");
        }
        let of_net = net_limits(&net, &scheme).expect("limits").into_iter().flatten();
        let of_mesh = limit_points(&mesh, of_meshes).expect("limits").into_iter().flatten();
        if of_meshes == MeshScheme::CatmullClark {
            let of_net: Vec<_> = of_net.map(|point| point.map(RealCyclotomic::from)).collect();
            let of_mesh: Vec<_> = of_mesh.map(|limit| limit.position).collect();
            assert_eq!(of_net, of_mesh);
        } else {
            // The vertex itself: both say where the middle of its new face goes.
            let of_net = of_net.map(|point| point.map(RealCyclotomic::from));
            assert_eq!(sorted(of_net), sorted(of_mesh.map(|limit| limit.position)));
        }
    }
}

/// The limit points of a net are limit points of the refined net, for schemes whose points keep their
/// parameters.
#[test]
fn limit_points_stay() {
    for (name, closed) in [("bicubic", CLOSED[2]), ("four-point:w=1/16", CLOSED[3])] {
        let net = bumpy(7, 6, closed);
        let scheme = scheme(name);
        let of_net =
            net_of_limits(&net, net_limits(&net, &scheme).expect("limits")).expect("a net");
        let refined = refine_net(&net, &scheme, 2).expect("a net");
        let later: BTreeSet<_> =
            net_of_limits(&refined, net_limits(&refined, &scheme).expect("limits"))
                .expect("a net")
                .points()
                .iter()
                .map(|p| format!("{p:?}"))
                .collect();
        assert!(
            of_net.points().iter().all(|point| later.contains(&format!("{point:?}"))),
            "{name}"
        );
    }
}
