//! Spectra for all valences against those of single ones.

use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::diagnostic::SourceText;
use subcert::exact::{IntegerFunction, Rational, RealCyclotomic, RealExpression, Scalar as _};
use subcert::scheme::{SchemeDefinition, read_scheme};
use subcert::spectrum::{CurvaturePart, EverySpectrum, Spectrum};

const FIRST: i64 = 16;

/// Rules of the orbits vertex and edge, and perhaps of a third, that are those of their mirror image.
fn rules() -> impl Strategy<Value = SchemeDefinition> {
    (0_i64..=8, 1_i64..=5, -1_i64..=2, -3_i64..=3, -1_i64..=1, any::<bool>()).prop_map(
        |(b, v, s, c, u, three)| {
            let edge = format!(
                "(8 - {v} - 2*({s}))*kronecker(turn, 0)/8 + {s}*(kronecker(turn, 1) + kronecker(turn, N - 1))/8 + {u}*cos(4*pi*turn/N)/N/4"
            );
            let (orbits, face, edges) = if three {
                (
                    ", face = 'N'",
                    format!("weights.face = {{ vertex = '1/4', edge = '(kronecker(turn, 0) + kronecker(turn, 1))/4', face = 'kronecker(turn, 0)/4 + {u}*cos(2*pi*turn/N)/N' }}\n"),
                    ", ['edge[i]', 'face[i]'], ['face[i]', 'edge[i + 1]']",
                )
            } else {
                ("", String::new(), ", ['edge[i]', 'edge[i + 1]']")
            };
            let text = format!(
                "name = 's'\nparameters.N = {{}}\norbits = {{ vertex = '1', edge = 'N'{orbits} }}\n\
                 edges = [['vertex', 'edge[i]']{edges}]\n\
                 weights.vertex = {{ vertex = '1 - w', edge = 'w/N' }}\n\
                 weights.edge = {{ vertex = '{v}/8', edge = '{edge}' }}\n{face}\
                 let = {{ turn = 'mod(j - i, N)', w = '({b} + {c}*cos(2*pi/N))/16' }}\n"
            );
            read_scheme(&SourceText::new("s.toml", text)).expect("a ring")
        },
    )
}

fn eigenvalues(spectrum: &Spectrum, block: usize) -> Vec<RealExpression> {
    let real = spectrum.eigenvalues.iter().filter(|one| one.imaginary.is_none());
    let mut own: Vec<RealExpression> = real
        .flat_map(|one| one.blocks.iter().filter(|k| **k == block).map(|_| one.real.clone()))
        .collect();
    own.sort_by(|a, b| b.cmp(a));
    own
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn what_is_known_of_all_valences_is_so_at_each(scheme in rules()) {
        let ring = scheme.every_ring(&BTreeMap::new(), FIRST).expect("known weights");
        let every = EverySpectrum::new(ring, FIRST).expect("weights of the sum 1");
        for n in [16_i64, 21] {
            let parameters = BTreeMap::from([("N".to_owned(), RealCyclotomic::from(Rational::from(n)))]);
            let ring = scheme.ring(&parameters).expect("a ring");
            let Ok(one) = Spectrum::known(&ring, None) else { continue };
            let at = |value: Option<IntegerFunction>| value.map(|value| value.value_at(n).unwrap());
            for block in [0_usize, 1, 2, 5] {
                let known = eigenvalues(&one, block);
                for number in 1..=2 {
                    let block = i64::try_from(block).unwrap();
                    if let Some(value) = at(every.eigenvalue(block, number)) {
                        prop_assert_eq!(Some(&value), known.get(number - 1));
                    }
                }
            }
            let lambda = at(every.subdominant());
            if lambda.is_some() {
                prop_assert_eq!(&lambda, &one.conditions.subdominant);
                let square = lambda.as_ref().unwrap().times(lambda.as_ref().unwrap());
                if let Some(most) = at(every.curvature(CurvaturePart::Both)) {
                    let next = one.conditions.next.as_ref().unwrap();
                    prop_assert_eq!(most.times(&square), next.clone());
                }
                if let (Some(weight), Some(tangents)) = (at(every.tangent_weight(2, Some("edge"))), &one.tangents) {
                    prop_assert_eq!(&weight, &tangents[0][3]);
                }
            }
            if let (Some(weight), Some(limit)) = (at(every.limit_weight(Some("edge"))), &one.limit) {
                prop_assert_eq!(weight, RealExpression::from(limit[1].clone()));
            }
        }
    }
}

#[test]
fn the_law_decides_something() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let known = (0..40).filter(|_| {
        let scheme = rules().new_tree(&mut runner).unwrap().current();
        let ring = scheme.every_ring(&BTreeMap::new(), FIRST).unwrap();
        EverySpectrum::new(ring, FIRST).is_some_and(|every| every.subdominant().is_some())
    });
    let known = known.count();
    assert!(known >= 5, "only {known} have a subdominant eigenvalue");
}

#[test]
fn weights_that_are_not_those_of_a_turn_are_not_taken() {
    let known = |edge: &str, count: &str| {
        let text = format!(
            "name = 's'\nparameters.N = {{}}\norbits = {{ vertex = '1', edge = '{count}' }}\n\
             edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]\n\
             weights.vertex = {{ vertex = '1/2', edge = '1/2/{count}' }}\n\
             weights.edge = {{ vertex = '1/2', edge = '{edge}' }}\n"
        );
        let scheme = read_scheme(&SourceText::new("s.toml", text)).expect("a ring");
        let ring = scheme.every_ring(&BTreeMap::new(), FIRST);
        ring.and_then(|ring| EverySpectrum::new(ring, FIRST)).is_some()
    };
    assert!(known("kronecker(i, j)/2", "N"));
    assert!(known("kronecker(mod(j - i, N), 6)/2", "N"));
    assert!(known("(1 + cos(12*pi*(j - i)/N))/2/N", "N"));
    assert!(known("kronecker(N, 15) + kronecker(i, j)/2", "N"));
    for edge in [
        // On the place; without the turn; of another sum; far; a wave of 7; a condition that is true at large valences.
        "kronecker(i, j)/2 - kronecker(i, 0)*kronecker(j, 0)/4 + kronecker(i, 0)*kronecker(j, 1)/4",
        "kronecker(j - i, 1)/2",
        "kronecker(i, j)/3",
        "kronecker(mod(j - i, N), 7)/2",
        "(1 + cos(14*pi*(j - i)/N))/2/N",
        "(1 + kronecker(N, 40))*kronecker(i, j)/2",
        "kronecker(mod(j - i, 26), 0)/2",
        "(1 + cos(2*pi*(j - i + 1)/N))/2/N",
        "floor((j - i)/20) + kronecker(i, j)/2",
        "max(0, j - i - 13)",
    ] {
        assert!(!known(edge, "N"), "{edge}");
    }
    assert!(!known("kronecker(i, j)/2", "2*N"));
    assert!(!known("kronecker(i, j)/2", "N + 1"));
}
