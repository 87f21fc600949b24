//! Rings: the catalogue's, those in files, and what is none.

use crate::common::{int, r, ring};
use proptest::prelude::*;
use subcert::diagnostic::{Diagnostic, SourceText};
use subcert::exact::{Rational, RealCyclotomic, Scalar as _};
use subcert::formula::{Parameters, evaluate, parse};
use subcert::scheme::{
    AnyScheme, LocalError, LocalRules, Orbit, SchemeError, find, parse_any_scheme,
    parse_local_rules, parse_rules_of_valence, parse_scheme, read_scheme,
};

const TRIANGLE: &str = "\
name = 'corner'
parameters.w = { default = '1/2' }
orbits = { tip = '1', corner = 'n' }
edges = [
    ['tip', 'corner[i]'],
    ['corner[i]', 'corner[i + 1]'],
]

[weights.corner]
corner = '(1 - w)*kronecker(i, j) + w/n'

[weights.tip]
tip = '1 - w'
corner = 'w/n'

[let]
n = '4'
";

#[test]
fn a_file_is_a_ring_with_parameters() {
    let source = SourceText::new("corner.toml", TRIANGLE);
    let definition = read_scheme(&source).unwrap();
    assert!(definition.is_ring());
    let ring: LocalRules<Rational> = definition.ring(&[].into()).unwrap();
    let names: Vec<String> = (0..5).map(|point| ring.name(point)).collect();
    assert_eq!(names, ["tip", "corner[0]", "corner[1]", "corner[2]", "corner[3]"]);
    let row = |a| ring.weights().row(a).cloned().collect::<Vec<Rational>>();
    assert_eq!(row(0), [r(1, 2), r(1, 8), r(1, 8), r(1, 8), r(1, 8)]);
    assert_eq!(row(2), [r(0, 1), r(1, 8), r(5, 8), r(1, 8), r(1, 8)]);
    let edges = [(0, 1), (0, 2), (0, 3), (0, 4), (1, 2), (2, 3), (3, 4), (4, 1)];
    assert_eq!(ring.edges(), edges);
    assert_eq!(ring.rotation(), Some(vec![0, 2, 3, 4, 1]));
}

#[test]
fn rings_of_the_catalogue() {
    for (name, parameter, valences) in [
        ("doo-sabin", "n", 3..=12),
        ("catmull-clark", "N", 3..=12),
        ("bajaj", "N", 3..=12),
        ("loop", "N", 3..=12),
        ("loop-warren", "N", 3..=12),
        ("sqrt3", "N", 3..=12),
        ("catmull-clark-biquadratic", "n", 3..=12),
    ] {
        for valence in valences.chain([24]) {
            let ring = ring(&format!("{name}:{parameter}={valence}"));
            for row in (0..ring.point_count()).map(|a| ring.weights().row(a)) {
                let sum = RealCyclotomic::total(row.clone());
                assert_eq!(sum, RealCyclotomic::from(1), "{name} {valence}");
                assert!(row.clone().all(|weight| weight.sign() >= 0), "{name} {valence}");
            }
            assert!(ring.rotation().is_some(), "{name} {valence}");
        }
        let small = parse_local_rules(&format!("{name}:{parameter}=2")).unwrap_err();
        assert!(matches!(small, SchemeError::TooSmall { .. }), "{small}");
    }
}

#[test]
fn masks_and_rings_are_told_apart() {
    assert!(matches!(parse_any_scheme("doo-sabin:n=3"), Ok(AnyScheme::LocalRules(_))));
    assert!(matches!(parse_any_scheme("chaikin x chaikin"), Ok(AnyScheme::Uniform(_))));
    let error = parse_local_rules("chaikin").unwrap_err().to_string();
    assert!(error.contains("`chaikin` is not a ring"), "{error}");
    for scheme in ["doo-sabin:n=5", "chaikin x doo-sabin:n=5", "bajaj:N=5"] {
        let error = parse_scheme(scheme).unwrap_err();
        assert!(matches!(&error, SchemeError::LocalRules { .. }), "{error}");
        assert!(
            error.to_string().contains("`constants`") || error.to_string().contains("constants")
        );
    }
    assert!(matches!(parse_local_rules("bajaj:N=5 x bajaj:N=5"), Err(SchemeError::NotRing { .. })));
    let error = parse_local_rules("bajaj").unwrap_err().to_string();
    assert_eq!(error, "`bajaj` needs its parameter `N`: write `bajaj:N=…`");
    // Cosines need numbers that have them.
    let rational = find("doo-sabin").unwrap().ring(&[("n".to_owned(), r(5, 1))].into());
    assert!(rational.unwrap_err().to_string().contains("cos(2*pi/5) is not rational"));
}

/// A weight is a formula in the valence, in SCHEME and as a default in the file.
#[test]
fn weights_by_valence() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/loop-beta.toml");
    let loops = "(5/8 - (3/8 + cos(2*π/N)/4)^2)/N";
    assert_eq!(ring(&format!("{file}:beta={loops},N=7")).weights(), ring("loop:N=7").weights());
    let apart = parse_rules_of_valence(&format!("{file}:beta={loops}"), Some(7)).unwrap();
    assert_eq!(apart.weights(), ring("loop:N=7").weights());
    let text = std::fs::read_to_string(file).unwrap();
    let text =
        text.replace("parameters.beta = {", &format!("parameters.beta = {{ default = '{loops}',"));
    let definition = read_scheme(&SourceText::new("mine.toml", text)).unwrap();
    let valence = [("N".to_owned(), RealCyclotomic::from(7))].into();
    assert_eq!(definition.ring(&valence).unwrap().weights(), ring("loop:N=7").weights());
    for (scheme, part) in [
        ("beta=3/(8*N)", "needs its parameter `N`: write `"),
        ("beta=3/(8*N)", ":beta=3/(8*N),N=…`"),
        ("N=5,beta=3/(8*n)", "unknown name `n`"),
        ("N=beta,beta=3/N", "is given by itself"),
    ] {
        let error = parse_local_rules(&format!("{file}:{scheme}")).unwrap_err().to_string();
        assert!(error.contains(part), "{scheme}: {error}");
    }
}

/// The error of a text, wherever it shows.
fn refusal(text: &str) -> Diagnostic {
    let source = SourceText::new("my.toml", text);
    match read_scheme(&source).map(|definition| definition.ring::<RealCyclotomic>(&[].into())) {
        Err(diagnostic) => diagnostic,
        Ok(Err(SchemeError::File(diagnostic))) => *diagnostic,
        Ok(other) => panic!("{text}: {other:?}"),
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "one table")]
fn errors_say_where_what_and_what_would_be_right() {
    // What is replaced in the file, by what; the place, what is said, the remedy.
    for (old, new, place, message, help) in [
        (
            "tip = '1 - w'",
            "tip = '1'",
            "'1'\ncorner = 'w/n'",
            "new point tip sum to 3/2, not to 1: their excess is 1/2",
            "",
        ),
        (
            "w/n'\n\n[weights.tip]",
            "j/n'\n\n[weights.tip]",
            "'(1 - w)*kronecker(i, j) + j/n'",
            "new point corner[0] sum to 2",
            "",
        ),
        (
            "[weights.tip]",
            "[weights.top]",
            "top",
            "no orbit is called `top`",
            "the orbits are tip, corner",
        ),
        ("\ncorner = 'w/n'", "\nside = 'w/n'", "side", "no orbit is called `side`", "tip, corner"),
        (
            "['tip', 'corner[i]']",
            "['tip', 'side[i]']",
            "'side[i]'",
            "no orbit is called `side`",
            "tip, corner",
        ),
        (
            "['tip', 'corner[i]']",
            "['tip', 'corner']",
            "['tip', 'corner']",
            "`corner` has 4 points, and this does not say which",
            "write corner[i]",
        ),
        (
            "['tip', 'corner[i]']",
            "['tip']",
            "['tip']",
            "an edge has two ends, and this has 1",
            "edges = [[",
        ),
        ("['tip', 'corner[i]']", "['tip', '2*i']", "'2*i'", "an orbit and an index", "edges = [["),
        (
            "['tip', 'corner[i]']",
            "['tip', 'corner[i/2]']",
            "'corner[i/2]'",
            "the index of a point is 1/2; it must be an integer",
            "",
        ),
        (
            "corner[i + 1]",
            "corner[i + 4]",
            "['corner[i]', 'corner[i + 4]']",
            "joins the point corner[0] to itself",
            "",
        ),
        (
            "    ['tip', 'corner[i]'],\n",
            "",
            "['corner[i]', 'corner[i + 1]']",
            "no edges lead from tip to corner[0]",
            "",
        ),
        (
            "corner = 'n'",
            "corner = 'n/3'",
            "'n/3'",
            "the number of points of `corner` is 4/3; it must be an integer from 1 to 600",
            "",
        ),
        ("corner = 'n'", "corner = '10^9'", "'10^9'", "from 1 to 600", ""),
        (
            "tip = '1', corner = 'n'",
            "tip = '300', corner = '301'",
            "'301'",
            "a ring of 601 points; there must be from 2 to 600",
            "",
        ),
        (
            "orbits = { tip = '1', corner = 'n' }",
            "orbits = {}",
            "{}",
            "at least one orbit",
            "orbits = {",
        ),
        (
            "orbits = { tip = '1', corner = 'n' }\n",
            "",
            "'corner'",
            "a ring needs `orbits`, `weights` and `edges`",
            "orbits = {",
        ),
        (
            "[weights.tip]\ntip = '1 - w'\ncorner = 'w/n'\n",
            "",
            "corner",
            "there are no weights of the new points `tip`",
            "[weights.tip]",
        ),
        (
            "parameters.w",
            "offset = '0'\nparameters.w",
            "'corner'",
            "either a mask or a ring",
            "`mask`, `symbol`, `arity`",
        ),
        (
            "parameters.w",
            "parameters.i = { default = '1' }\nparameters.w",
            "i",
            "`i` is an index",
            "another name",
        ),
        ("n = '4'", "n = 'm'", "w/n", "unknown name", ""),
        ("n = '4'", "n = '0'", "'n'", "the number of points of `corner` is 0", ""),
        ("'1 - w'", "1.5", "1.5", "invalid type: floating point", "write it in quotes"),
        ("'1 - w'", "'1 - cos(2*pi/99991)'", "cos(2*pi/99991)", "n = 99991", ""),
    ] {
        let text = TRIANGLE.replacen(old, new, 1);
        assert_ne!(text, TRIANGLE, "{old}");
        let error = refusal(&text);
        assert!(error.message.contains(message), "{error}");
        if place != "w/n" {
            assert_eq!(text.get(error.span.clone()), Some(place), "{error}");
        }
        assert!(error.help.clone().unwrap_or_default().contains(help), "{error}");
    }
}

#[test]
fn what_is_no_ring() {
    let orbits = |count| vec![Orbit { name: "p".to_owned(), count }];
    let identity = |count: usize| -> Vec<Vec<Rational>> {
        (0..count)
            .map(|a| (0..count).map(|b| Rational::from(i64::from(a == b))).collect())
            .collect()
    };
    let ring = |count, rows, edges: &[(usize, usize)]| {
        LocalRules::new(orbits(count), rows, edges.to_vec())
    };
    assert_eq!(ring(1, identity(1), &[]).unwrap_err(), LocalError::Points(1));
    assert_eq!(ring(601, Vec::new(), &[]).unwrap_err(), LocalError::Points(601));
    assert_eq!(ring(3, identity(2), &[]).unwrap_err(), LocalError::Shape { points: 3 });
    let no_point = LocalError::NoPoint { point: 2, last: 1 };
    assert_eq!(ring(2, identity(2), &[(0, 2)]).unwrap_err(), no_point);
    assert_eq!(ring(2, identity(2), &[(1, 1)]).unwrap_err(), LocalError::Loop("p[1]".to_owned()));
    let (first, point) = ("p[0]".to_owned(), "p[2]".to_owned());
    let apart = ring(3, identity(3), &[(0, 1)]).unwrap_err();
    assert_eq!(apart, LocalError::Disconnected { first, point });
    let ring = ring(2, identity(2), &[(0, 1), (1, 0), (0, 1)]).unwrap();
    assert_eq!(ring.edges(), [(0, 1)]);
}

// (Mx)_a = Σ_b m_{a,b} x_b, and wᵀ(Mx) = (wᵀM)x.
#[test]
fn refinement_as_defined() {
    let dot = |left: &[RealCyclotomic], right: &[RealCyclotomic]| {
        let terms: Vec<_> = left.iter().zip(right).map(|(a, b)| a * b).collect();
        RealCyclotomic::total(&terms)
    };
    for scheme in ["doo-sabin:n=5", "catmull-clark:N=5", "bajaj:N=10"] {
        let ring = ring(scheme);
        let count = int(ring.point_count());
        let numbers = |shift: i64| -> Vec<RealCyclotomic> {
            (0..count).map(|j| RealCyclotomic::cosine(&r(j * j + shift, 5)).unwrap()).collect()
        };
        let (w, x) = (numbers(1), numbers(2));
        let refined = ring.refine(&x);
        let row = |a| ring.weights().row(a).cloned().collect::<Vec<RealCyclotomic>>();
        let naive: Vec<_> = (0..ring.point_count()).map(|a| dot(&row(a), &x)).collect();
        assert_eq!(refined, naive, "{scheme}");
        assert_eq!(dot(&w, &refined), dot(&ring.pull_back(&w), &x), "{scheme}");
    }
    let sparse = ring("catmull-clark:N=5");
    assert_eq!(sparse.product_count(), 11 + 5 * 6 + 5 * 4);
}

/// Terms of a weight of old point j in new point i, of which each row sums to the second.
const TERMS: [(&str, i64); 9] = [
    ("kronecker(i, j)", 1),
    ("2*kronecker(turn, 1)", 2),
    ("3*kronecker(mod(i - j + 2, N), 0)", 3),
    ("cos(2*pi*(j - i)/N)", 0),
    ("(mod(j - i, N) - (N - 1)/2)^2 - (N^2 - 1)/12", 0),
    ("sum(k = 1..2, cos(2*pi*k*(j - i)/N))", 0),
    ("kronecker(j, 1)/2 - kronecker(j, 2)/2", 0),
    ("i*cos(2*pi*j/N)", 0),
    ("kronecker(i, 1)*(kronecker(j, 0) - kronecker(turn, 0))", 0),
];

proptest! {
    #![proptest_config(crate::common::cases(64))]
    // Weights that are found once for many places, against each formula at each place; and
    // the rotation against the definition.
    #[test]
    fn weights_as_written(n in 3_usize..9, chosen in prop::collection::vec(0_usize..9, 0..4)) {
        let chosen: Vec<(&str, i64)> = chosen.into_iter().map(|term| TERMS[term]).collect();
        let sum: i64 = chosen.iter().map(|(_, sum)| sum).sum();
        let terms: Vec<&str> = chosen.iter().map(|(term, _)| *term).collect();
        let weight = [&[&*format!("(1 - {sum})/N")], &terms[..]].concat().join(" + ");
        let text = format!(
            "name = 'ring'\nparameters.N = {{}}\norbits = {{ p = 'N' }}\n\
             edges = [['p[i]', 'p[i + 1]']]\n[weights.p]\np = '{weight}'\n\
             [let]\nturn = 'mod(j - i, N)'\n"
        );
        let definition = read_scheme(&SourceText::new("ring.toml", text)).unwrap();
        let count = RealCyclotomic::from(int(n));
        let ring: LocalRules = definition.ring(&[("N".to_owned(), count.clone())].into()).unwrap();
        let formula = parse(&weight.replace("turn", "mod(j - i, N)")).unwrap();
        let naive = |i: usize, j: usize| {
            let [i, j] = [i, j].map(|index| RealCyclotomic::from(int(index)));
            evaluate(&formula, &Parameters::from([("N", count.clone()), ("i", i), ("j", j)])).unwrap()
        };
        let mut turns = true;
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            prop_assert_eq!(ring.weights().entry(i, j), &naive(i, j), "{} at {}, {}", weight, i, j);
            turns &= naive(i, j) == naive((i + 1) % n, (j + 1) % n);
        }
        prop_assert_eq!(ring.rotation().is_some(), turns, "{}", weight);
    }
}

// Counts 2 and 6 turn by 1 and by 3; a weight that differs, or an edge, stops the turn.
#[test]
fn rotations() {
    let orbits =
        vec![Orbit { name: "a".to_owned(), count: 2 }, Orbit { name: "b".to_owned(), count: 6 }];
    let mean = vec![vec![r(1, 8); 8]; 8];
    let mut edges: Vec<(usize, usize)> = (0..6).map(|i| (2 + i, 2 + (i + 1) % 6)).collect();
    edges.extend([(0, 2), (1, 5)]);
    let ring = LocalRules::new(orbits.clone(), mean.clone(), edges.clone()).unwrap();
    assert_eq!(ring.rotation(), Some(vec![1, 0, 5, 6, 7, 2, 3, 4]));
    let chosen = ring.representatives();
    assert_eq!(chosen.points, [0, 2, 3, 4]);
    assert_eq!(chosen.edges, [(2, 3), (3, 4), (4, 5), (0, 2)]);
    let mut uneven = mean.clone();
    uneven[0] = (0..8).map(|b| Rational::from(i64::from(b == 0))).collect();
    assert_eq!(LocalRules::new(orbits.clone(), uneven, edges.clone()).unwrap().rotation(), None);
    edges.pop();
    edges.push((1, 4));
    assert_eq!(LocalRules::new(orbits, mean, edges).unwrap().rotation(), None);
}
