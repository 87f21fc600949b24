//! C¹ at the vertex: against closed formulas, meshes that are refined, and rules that were broken.

mod butterfly;
mod slow;

use slow::{Kind, Net};
use std::f64::consts::PI;
use std::io::Write as _;
use subcert::characteristic::{
    Family, Hypothesis, Reason, Refutation, Verdict, Vertex, regular_for_all_valences, vertex_range,
};
use subcert::exact::format::short;
use subcert::exact::{Interval, Rational, RealCyclotomic};
use subcert::float::{exact as exactly, nearest};
use subcert::mesh::{MeshScheme, PolygonMesh, refine_mesh};
use subcert::scheme::parse_rules_in_parameter;
use subcert::spectrum::Curvature;

/// λ at a valence, by closed formulas.
fn subdominant(scheme: &str, n: usize) -> f64 {
    let c = (2.0 * PI / real(n)).cos();
    match scheme {
        "catmull-clark" => (5.0 + c + ((c + 9.0) * (c + 1.0)).sqrt()) / 16.0,
        "doo-sabin" => 0.5,
        _ => 0.375 + c / 4.0,
    }
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
fn real(n: usize) -> f64 {
    n as f64
}

#[test]
fn schemes_of_the_catalogue_are_smooth_at_every_valence() {
    for scheme in ["catmull-clark", "loop", "loop-warren", "doo-sabin"] {
        for n in (3..=12).chain([20, 31, 50]) {
            let vertex = Vertex::of(scheme, Some(n)).expect("a valence");
            let Verdict::Proved { least, .. } = &vertex.verdict else {
                panic!("{scheme} {n}: {:?}", vertex.verdict)
            };
            assert!(least.sign() > 0);
            let found = vertex.spectrum.conditions.subdominant.expect("an eigenvalue");
            let found = short(&found, 15).parse::<f64>().expect("a number");
            assert!((found - subdominant(scheme, n)).abs() < 1e-12, "{scheme} {n}: {found}");
        }
    }
    for family in [Family::Bicubic, Family::BoxSpline, Family::Biquadratic] {
        assert!(regular_for_all_valences(family), "{family:?}");
    }
}

/// A plane mesh of n sectors is refined: next to the vertex no face turns over, and the edges shrink by λ.
#[test]
fn refined_meshes_keep_their_orientation() {
    for n in [3, 5, 8] {
        let turned = |k: usize, x: usize, y: usize| {
            let at = |k: usize| 2.0 * PI * real(k) / real(n);
            let (a, b) = (at(k), at(k + 1));
            let (x, y) = (real(x), real(y));
            [x * a.cos() + y * b.cos(), x * a.sin() + y * b.sin(), 0.0]
        };
        // Point (x, y), x ≥ 1, of sector k.
        let index = |k: usize, x: usize, y: usize| match (x, y) {
            (0, 0) => 0,
            (0, y) => 1 + ((k + 1) % n) * 12 + (y - 1) * 4,
            (x, y) => 1 + (k % n) * 12 + (x - 1) * 4 + y,
        };
        let mut points = vec![[0.0; 3]];
        for k in 0..n {
            points.extend((1..=3).flat_map(|x| (0..=3).map(move |y| turned(k, x, y))));
        }
        let face = |k, x, y| {
            vec![index(k, x, y), index(k, x + 1, y), index(k, x + 1, y + 1), index(k, x, y + 1)]
        };
        let faces = (0..n).flat_map(|k| (0..9).map(move |i| face(k, i / 3, i % 3))).collect();
        let exact = |x: f64| {
            let x = exactly((x * 1e6).round()).expect("finite") / Rational::from(1_000_000);
            RealCyclotomic::from(x)
        };
        let points = points.iter().map(|point| point.map(exact)).collect();
        let mut mesh = PolygonMesh::new(points, faces).expect("a mesh");
        let mut lengths = Vec::new();
        for _ in 0..4 {
            mesh = refine_mesh(&mesh, MeshScheme::CatmullClark, 1).expect("small");
            let at = |v: usize| mesh.points()[v].each_ref().map(nearest);
            let next: Vec<&Vec<usize>> =
                mesh.faces().iter().filter(|face| face.contains(&0)).collect();
            assert_eq!(next.len(), n);
            for face in next {
                let area: f64 = (0..4)
                    .map(|i| (at(face[i]), at(face[(i + 1) % 4])))
                    .map(|(p, q)| p[0] * q[1] - p[1] * q[0])
                    .sum();
                assert!(area > 0.0, "{n}");
                let first = face.iter().position(|&v| v == 0).expect("the vertex");
                let edge = at(face[(first + 1) % 4]);
                lengths.push(edge[0].hypot(edge[1]));
            }
        }
        let ratio = lengths[3 * n] / lengths[2 * n];
        assert!((ratio - subdominant("catmull-clark", n)).abs() < 0.02, "{n}: {ratio}");
    }
}

/// A ring in a file of its own.
fn ring(name: &str, text: &str) -> Vertex {
    let path = std::env::temp_dir().join(format!("subcert-{}-{name}.toml", std::process::id()));
    std::fs::File::create(&path)
        .and_then(|mut file| file.write_all(text.as_bytes()))
        .expect("a file");
    let vertex = Vertex::of(path.to_str().expect("a path"), None);
    std::fs::remove_file(&path).expect("the file");
    vertex.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Rules on a face of three vertices, with a weight for each distance.
fn face(weights: [&str; 3]) -> String {
    let [own, next, last] = weights;
    format!(
        "name = 'face'\ntitle = 'Rules on a triangle'\norbits = {{ face = '3' }}\nedges = [['face[i]', 'face[i + 1]']]\n\
         [weights.face]\nface = '({own})*kronecker(t, 0) + ({next})*kronecker(t, 1) + ({last})*kronecker(t, 2)'\n\
         [let]\nt = 'mod(j - i, 3)'\n"
    )
}

/// λ = 9/10 with blocks 1 and 2, all others at most 1/4: the eigenvalues are in order, and the map folds over.
#[test]
fn a_map_that_folds_is_refuted() {
    let vertex = ring("folds", &face(["28/30", "1/30", "1/30"]));
    let subdominant = vertex.spectrum.conditions.subdominant.as_ref().expect("in order");
    assert_eq!(short(subdominant, 6), "0.9");
    let Verdict::Refuted(Refutation::Folds { values, .. }) = &vertex.verdict else {
        panic!("{:?}", vertex.verdict)
    };
    assert!(values[0].lower().sign() > 0 && values[1].upper().sign() < 0);
    // Computed by hand in another scale, at (1, 0) and (1, 1).
    let by_hand = Rational::new(23, 806) / Rational::new(-133_785, 43_525_612);
    let [first, second] = values.each_ref().map(|value| value.lower().clone());
    let off = (first / second / by_hand - Rational::one()).abs();
    assert!(off < Rational::new(1, 1_000_000_000), "{off}");
    // Doo and Sabin's own weights do not fold.
    let own = ring("own", &face(["2/3", "1/6", "1/6"]));
    assert!(matches!(own.verdict, Verdict::Proved { .. }), "{:?}", own.verdict);
}

/// Loop's rules with another weight of all neighbours together, which is 1 less the one of the vertex.
fn vertex_rules(vertex: &str, edge: &str) -> String {
    let text = std::fs::read_to_string("examples/loop.toml").expect("an example");
    let text =
        text.replace("'(5/8 - (3/8 + cos(2*pi/N)/4)^2)/N'", vertex).replace("vertex = '3/8'", edge);
    text.replace("parameters.N = {", "parameters.N = { default = '6',")
        .replace("name = \"loop\"", "name = \"changed\"")
}

/// Block 0 has 5/8 − Nβ: with β = 1/100 and N = 6 it is 0.565, above λ = 1/2.
#[test]
fn an_eigenvalue_of_block_0_above_the_others_refutes() {
    let changed = ring("block0", &vertex_rules("'1/100'", "vertex = '3/8'"));
    let Verdict::Refuted(Refutation::Block0 { value, size: 1 }) = &changed.verdict else {
        panic!("{:?}", changed.verdict)
    };
    assert_eq!(short(value, 6), "0.565");
    // Nβ = 9/8 gives −1/2, as large as λ: nothing is refuted.
    let tie = ring("tie", &vertex_rules("'9/8/N'", "vertex = '3/8'"));
    assert_eq!(tie.verdict, Verdict::Fails(Hypothesis::Alone));
    let same = ring("same", &vertex_rules("'(5/8 - 1/4)/N'", "vertex = '3/8'"));
    assert!(matches!(same.verdict, Verdict::Proved { .. }));
}

/// Rules on a face of n points with the eigenvalues 1, and these of the blocks 1, 2, …; and their weights.
fn face_with(name: &str, eigenvalues: &[(i64, i64)], n: usize) -> (Vertex, Vec<f64>) {
    let both = if n.is_multiple_of(2) { eigenvalues.len() - 1 } else { eigenvalues.len() };
    let factor = |k: usize| if k < both { 2 } else { 1 };
    let terms = eigenvalues
        .iter()
        .enumerate()
        .map(|(k, (p, q))| format!(" + {}*({p})/{q}*cos(2*pi*{}*(j - i)/{n})", factor(k), k + 1));
    let text = format!(
        "name = 'face'\ntitle = 'Rules on a face'\norbits = {{ face = '{n}' }}\nedges = [['face[i]', 'face[i + 1]']]\n\
         [weights.face]\nface = '(1{})/{n}'\n",
        terms.collect::<String>()
    );
    let weight = |d: usize| {
        let turn = |k: usize| (2.0 * PI * real(k * d) / real(n)).cos();
        let terms = eigenvalues.iter().enumerate().map(|(k, (p, q))| {
            f64::from(factor(k))
                * turn(k + 1)
                * nearest(&RealCyclotomic::from(Rational::new(*p, *q)))
        });
        (1.0 + terms.sum::<f64>()) / real(n)
    };
    (ring(name, &text), (0..n).map(weight).collect())
}

/// The verdicts on the catalogue against cells of refined nets.
#[test]
fn slow_nets_agree_with_proofs() {
    for n in [3, 4, 5, 7, 12, 20] {
        for (kind, k) in [(Kind::Vertex, 1), (Kind::Triangles, 1)] {
            let net = Net::new(kind, n, k, &[]);
            let (_, negative) = net.areas();
            assert_eq!(negative, 0, "{n}");
            assert!((net.winding() - 1.0).abs() < 1e-6, "{n}");
        }
    }
}

/// The eigenvalues of a face are chosen: folds, winding numbers, negative eigenvalues, ties.
#[test]
fn faces_with_chosen_eigenvalues() {
    // Block 1 above: λ from 1/2 to 0.9.
    let n = 5;
    for (p, q, smooth) in [(1, 2, true), (3, 5, true), (19, 20, false)] {
        let (vertex, weights) = face_with(&format!("lambda{p}-{q}"), &[(p, q), (1, 5)], n);
        let net = Net::new(Kind::Face, 5, 1, &weights);
        let (positive, negative) = net.areas();
        if smooth {
            assert!(
                matches!(vertex.verdict, Verdict::Proved { .. }),
                "{p}/{q}: {:?}",
                vertex.verdict
            );
            assert_eq!(negative, 0, "{p}/{q}");
            assert!((net.winding() - 1.0).abs() < 1e-6);
        } else {
            assert!(
                matches!(vertex.verdict, Verdict::Refuted(Refutation::Folds { .. })),
                "{p}/{q}: {:?}",
                vertex.verdict
            );
            assert!(positive > 0 && negative > 0, "{p}/{q}");
        }
    }
    // Block 2 above: the map winds twice.
    let (vertex, weights) = face_with("winds", &[(3, 10), (1, 2)], n);
    let Verdict::Refuted(Refutation::Winds { number: Some(2) }) = vertex.verdict else {
        panic!("{:?}", vertex.verdict)
    };
    let net = Net::new(Kind::Face, 5, 2, &weights);
    assert!((net.winding() - 2.0).abs() < 1e-6);
    assert_eq!(net.areas().1, 0);
    // Negative.
    let (vertex, _) = face_with("negative", &[(-1, 2), (1, 5)], n);
    assert!(
        matches!(vertex.verdict, Verdict::Refuted(Refutation::Negative | Refutation::Folds { .. })),
        "{:?}",
        vertex.verdict
    );
    // Ties, and too small.
    for (name, eigenvalues) in
        [("tie", [(1, 2), (1, 2)]), ("opposite", [(1, 2), (-1, 2)]), ("outer", [(1, 4), (1, 5)])]
    {
        let (vertex, _) = face_with(name, &eigenvalues, n);
        let Verdict::Fails(hypothesis) = vertex.verdict else {
            panic!("{name}: {:?}", vertex.verdict)
        };
        assert!(
            matches!(hypothesis, Hypothesis::Alone | Hypothesis::Simple),
            "{name}: {hypothesis:?}"
        );
    }
    // Not below 1: rings do not shrink to a point.
    for (name, eigenvalues, value, blocks) in [
        ("one", [(1, 1), (1, 5)], 1, vec![0, 1, 4]),
        ("more", [(1, 2), (2, 1)], 2, vec![2, 3]),
        ("minus", [(1, 2), (-1, 1)], -1, vec![2, 3]),
    ] {
        let (vertex, _) = face_with(name, &eigenvalues, n);
        let Verdict::Refuted(Refutation::Diverges { eigenvalue }) = &vertex.verdict else {
            panic!("{name}: {:?}", vertex.verdict)
        };
        assert_eq!(eigenvalue.real, Rational::from(value).into(), "{name}");
        assert_eq!(eigenvalue.blocks, blocks, "{name}");
        assert_eq!(vertex.is_continuous(1), Some(false));
    }
    // Block n/2 alone.
    let (vertex, _) = face_with("half", &[(3, 10), (1, 2)], 4);
    assert_eq!(vertex.verdict, Verdict::Fails(Hypothesis::Blocks));
}

/// Ranges of a parameter against verdicts at single values, in and out of them.
#[test]
fn ranges_agree_with_verdicts_at_values() {
    for (file, parameter, valences) in [
        ("loop-beta", "beta", &[3, 4, 5, 6, 7, 12][..]),
        ("catmull-clark-gamma", "gamma", &[3, 4, 5, 8]),
        ("doo-sabin-alpha", "alpha", &[3, 4, 5]),
    ] {
        for &n in valences {
            let scheme = format!("examples/{file}.toml");
            let ring = parse_rules_in_parameter(&scheme, parameter, Some(n)).expect("rules");
            let range = vertex_range(&ring, parameter)
                .unwrap_or_else(|error| panic!("{file} {n}: {error}"));
            assert!(!range.inside.is_empty(), "{file} {n}");
            assert!(range.inside.intersection(&range.outside).is_empty());
            for (set, smooth) in [(&range.inside, true), (&range.outside, false)] {
                for at in set.intervals().iter().filter_map(Interval::rational) {
                    let vertex = Vertex::of(&format!("{scheme}:{parameter}={at}"), Some(n));
                    let verdict = vertex.expect("a spectrum").verdict;
                    assert_eq!(
                        matches!(verdict, Verdict::Proved { .. }),
                        smooth,
                        "{file} {n} {at}: {verdict:?}"
                    );
                    assert_eq!(
                        matches!(verdict, Verdict::Refuted(_)),
                        !smooth,
                        "{file} {n} {at}: {verdict:?}"
                    );
                }
            }
            // The ends of Loop's weight: |5/8 − nβ| < λ.
            if file == "loop-beta" {
                let ends: Vec<f64> = range.inside.ends().map(|(end, _)| nearest(end)).collect();
                let value = subdominant("loop", n);
                let expected = [(0.625 - value) / real(n), (0.625 + value) / real(n)];
                assert!(
                    ends.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12),
                    "{n}: {ends:?}"
                );
            }
        }
    }
}

/// Beyond the end of the range of a face's eigenvalue the cells of a refined net have both orientations, and before it one.
#[test]
fn the_end_of_a_range_is_where_nets_fold() {
    let ring =
        parse_rules_in_parameter("examples/doo-sabin-alpha.toml", "alpha", Some(3)).expect("rules");
    let range = vertex_range(&ring, "alpha").expect("a range");
    let (end, _) = range.inside.ends().last().expect("an end");
    let end = nearest(end);
    assert!((0.8..0.95).contains(&end), "{end}");
    let areas = |value: f64| {
        let weight = |d: usize| {
            let turn = (2.0 * PI * real(d) / 3.0).cos();
            (1.0 + 2.0 * value * turn) / 3.0
        };
        Net::new(Kind::Face, 3, 1, &[weight(0), weight(1), weight(2)]).areas()
    };
    assert_eq!(areas(end - 0.02).1, 0);
    let (positive, negative) = areas(end + 0.03);
    assert!(positive > 0 && negative > 0);
}

/// Rings without polynomial pieces that are known: nothing is proved, and the eigenvalues are said.
#[test]
fn other_regular_parts_are_open_with_what_the_eigenvalues_say() {
    for n in [3, 4, 5, 7, 9] {
        let vertex = Vertex::of("modified-butterfly", Some(n)).expect("a spectrum");
        assert!(matches!(vertex.verdict, Verdict::Open(_)));
        let value = vertex.second.expect("an eigenvalue").value;
        assert_eq!((value.to_string().as_str(), vertex.hypothesis), ("1/2", None), "{n}");
    }
    let vertex = Vertex::of("mid-edge", Some(5)).expect("a spectrum");
    assert!(matches!(vertex.verdict, Verdict::Open(_)) && vertex.hypothesis.is_none());
}

/// Kobbelt's rules have complex eigenvalues that are not computed, and are below λ.
#[test]
fn complex_eigenvalues_below_the_subdominant_one_do_not_decide() {
    for n in [3, 4, 5, 6, 9] {
        let vertex = Vertex::of("kobbelt", Some(n)).expect("a spectrum");
        assert!(matches!(vertex.verdict, Verdict::Open(Reason::RegularPart)), "{n}");
        assert_eq!(vertex.hypothesis, None, "{n}");
        let between = vertex.between().expect("a number below λ");
        let most = vertex.spectrum.complex.iter().map(|one| &one.greatest[1]);
        assert!(most.into_iter().all(|modulus| *modulus <= between), "{n}");
        assert!(n == 4 || !vertex.spectrum.complex.is_empty(), "{n}");
    }
}

/// Rules of their own for edge points: eigenvalues of the blocks 1, 2, and of all others, are chosen.
#[test]
fn edge_points_with_rules_of_their_own() {
    let text = std::fs::read_to_string("examples/loop-own-edges.toml").expect("an example");
    for (n, [p, q, rest], smooth) in [
        (6, [1, 2, 8], true),
        (5, [1, 2, 8], true),
        (9, [1, 2, 8], true),
        (5, [99, 100, 8], false),
        (7, [99, 100, 8], false),
    ] {
        // λ of block 1, 1/4 of block 2, and 1/8.
        let value = f64::from(p) / f64::from(q);
        let own = format!(
            "kronecker(turn, 0)/{rest} + (1/2 + 2*({p}/{q} - 1/{rest})*cos(2*pi*turn/N) + 2*(1/4 - 1/{rest})*cos(4*pi*turn/N))/N"
        );
        let old = "here/8 + (1/2 + 3/4*cos(2*pi*turn/N) + 1/4*cos(4*pi*turn/N))/N";
        assert!(text.contains(old));
        let text =
            text.replace(old, &own).replace("{ least = '5',", &format!("{{ default = '{n}',"));
        let vertex = ring(&format!("edges{n}-{p}"), &text);
        let weight = |d: usize| {
            let turn = 2.0 * PI * real(d) / real(n);
            let around = 0.5 + 2.0 * (value - 0.125) * turn.cos() + 0.25 * (2.0 * turn).cos();
            around / real(n) + if d == 0 { 0.125 } else { 0.0 }
        };
        let weights: Vec<f64> = (0..n).map(weight).collect();
        let order = i32::try_from(n).expect("small");
        let net = Net::new(Kind::Triangles, order, 1, &weights);
        let (positive, negative) = net.areas();
        assert_eq!(vertex.own, n != 6);
        if smooth {
            assert!(matches!(vertex.verdict, Verdict::Proved { .. }), "{n}: {:?}", vertex.verdict);
            assert_eq!(vertex.exponent.expect("a proof").curvature, Curvature::Bounded);
            assert_eq!(negative, 0, "{n}");
            assert!((net.winding() - 1.0).abs() < 1e-6);
        } else {
            assert!(
                matches!(vertex.verdict, Verdict::Refuted(Refutation::Folds { .. })),
                "{n}: {:?}, {positive} and {negative}",
                vertex.verdict
            );
            assert!(positive > 0 && negative > 0, "{n}: {positive} {negative}");
        }
    }
}
