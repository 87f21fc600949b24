//! Laws, and the path for polygon meshes.

use super::{depth, distances};
use crate::common::r;
use crate::net::{CLOSED, bumpy, nets, scheme};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::mesh::MeshScheme;
use subcert::net::{Closed, Net};
use subcert::patch::MeshDistances;

fn moved(net: &Net, factor: &Rational) -> Net {
    // A rotation with rational entries, and a translation.
    let map = |[x, y, z]: &[Rational; 3]| {
        let turned = [x * r(3, 5) - y * r(4, 5), x * r(4, 5) + y * r(3, 5), z.clone()];
        let [x, y, z] = turned.map(|x| x * factor);
        [x + r(1000, 7), y - r(3, 1), z + r(1, 3)]
    };
    Net::new(net.points().iter().map(map).collect(), net.columns(), net.closed()).expect("a net")
}

/// The net with rows and columns exchanged.
fn turned(net: &Net) -> Net {
    let (rows, columns) = (net.rows(), net.columns());
    let point = |k: usize| net.points()[k % rows * columns + k / rows].clone();
    let closed = Closed { u: net.closed().v, v: net.closed().u };
    Net::new((0..rows * columns).map(point).collect(), rows, closed).expect("a net")
}

fn near(left: [f64; 2], right: [f64; 2], factor: f64) -> bool {
    // Two enclosures of one number.
    left[0] * factor <= right[1] * (1.0 + 1e-9) && right[0] <= left[1] * factor * (1.0 + 1e-9)
}

proptest! {
    #![proptest_config(crate::common::cases(16))]

    /// A similarity of the net and the tolerance keeps levels, and multiplies distances.
    #[test]
    fn similar_nets_have_one_depth(
        net in nets(8, 8),
        name in prop::sample::select(&["bicubic", "chaikin", "four-point:w=1/16"][..]),
        tolerance in 1_i64..40,
    ) {
        let (scheme, tolerance, factor) = (scheme(name), r(tolerance, 9), r(7, 3));
        let own = depth(&net, &scheme, &tolerance);
        let other = depth(&moved(&net, &factor), &scheme, &(&tolerance * &factor));
        prop_assert_eq!((own.level, own.too_few), (other.level, other.too_few));
        prop_assert!(near(own.distance, other.distance, 7.0 / 3.0), "{:?} {:?}", own, other);
    }

    #[test]
    fn directions_can_be_exchanged(net in nets(8, 9), tolerance in 1_i64..40) {
        let tolerance = r(tolerance, 9);
        let own = depth(&net, &scheme("chaikin x four-point:w=1/16"), &tolerance);
        let other = depth(&turned(&net), &scheme("four-point:w=1/16 x chaikin"), &tolerance);
        prop_assert_eq!((own.level, own.too_few), (other.level, other.too_few));
        prop_assert!(near(own.distance, other.distance, 1.0), "{:?} {:?}", own, other);
    }

    /// A closed net has four faces at each vertex: Catmull and Clark's surface, and Doo and Sabin's.
    #[test]
    fn closed_nets_are_meshes_of_valence_four(net in nets(5, 4), tolerance in 1_i64..60) {
        let net = Net::new(net.points().to_vec(), 4, CLOSED[3]).expect("a net");
        let tolerance = r(tolerance, 11);
        for (name, of_meshes) in
            [("bicubic", MeshScheme::CatmullClark), ("chaikin", MeshScheme::DooSabin)]
        {
            let of_net = distances(&net, &scheme(name)).without_apart();
            let of_mesh = MeshDistances::new(net.mesh().expect("a surface"), of_meshes);
            let of_mesh = of_mesh.expect("a mesh").without_apart();
            let own = of_net.depth(&tolerance).expect("a depth");
            let other = of_mesh.depth(&tolerance).expect("a depth");
            prop_assert_eq!((own.level, own.too_few), (other.level, other.too_few));
            prop_assert!(near(own.distance, other.distance, 1.0), "{:?} {:?}", own, other);
            let faces = of_net.faces(own.level).into_iter().zip(of_mesh.faces(own.level));
            for (face, (own, other)) in faces.enumerate() {
                prop_assert!(near(own, other, 1.0), "{name} face {face}: {:?} {:?}", own, other);
            }
        }
    }
}

/// The greatest distance of the faces is that of the net, and no face without a piece has one.
#[test]
fn faces_make_up_the_net() {
    for name in ["bicubic", "chaikin", "four-point:w=1/16", "ternary-four-point-approximating"] {
        let net = bumpy(9, 10, CLOSED[0]);
        let distances = distances(&net, &scheme(name)).without_apart();
        let found = distances.depth(&r(1, 10)).expect("a depth");
        let faces = distances.faces(found.level);
        assert_eq!(faces.len(), 72);
        let [lower, upper] =
            [0, 1].map(|end| faces.iter().map(|face| face[end]).fold(0.0_f64, f64::max));
        assert!(near([lower, upper], found.distance, 1.0), "{name}: {lower} {upper} {found:?}");
        assert!(upper <= 1.06 * found.distance[1], "{name}: {upper} {found:?}");
        assert!(faces.iter().all(|[lower, upper]| lower <= upper));
        let worst = found.worst.expect("a bumpy net").face;
        assert!(faces[worst][1] >= found.distance[0] * (1.0 - 1e-9), "{name}");
    }
    let faces = distances(&bumpy(9, 10, CLOSED[0]), &scheme("bicubic")).faces(1);
    let inside = |face: usize| (1..7).contains(&(face / 9)) && (1..8).contains(&(face % 9));
    assert!(faces.iter().enumerate().all(|(face, [_, upper])| inside(face) == (*upper > 0.0)));
}
