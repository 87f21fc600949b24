//! The computation behind the data that refute theorems.

use crate::common::r;
use subcert::audit::{LeftOut, audit, by_hand};
use subcert::claim::{Paper, Statement, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::formula::{Parameters, evaluate, parse};

const PAPER: &str = "key = 'k'\npaper = { authors = [], title = '', venue = '', year = '' }\n\
    [define]\nT = 'contraction(c)'\nsigma = 'displacement(offset = 0)'\n\
    [[table]]\nid = 'constants'\nlocus = 'Table 1'\nvalue = 'T'\n\
    rows = { schemes = ['four-point:w=1/16', 'chaikin'] }\n\
    columns = { name = 'c', values = ['1', '2'] }\ncells = [['0.62', '0.33'], ['0.5', '0.25']]\n";

fn paper(theorem: &str) -> Paper {
    let text = format!("{PAPER}[[theorem]]\nid = 'q'\nlocus = 'Theorem 1'\n{theorem}\n");
    read_paper(&SourceText::new("k.toml", text)).unwrap_or_else(|error| panic!("{error}"))
}

/// What is left of the computation when each part is redone: |first − second|, the bound, and what
/// the limit weights make of refined points.
fn redone(paper: &Paper) {
    let audit = audit(paper).unwrap_or_else(|error| panic!("{error}"));
    for finding in &audit.theorems {
        let hand = by_hand(&audit, finding).unwrap_or_else(|error| panic!("{error}"));
        let Some(refutation) = &finding.refutation else {
            assert_eq!(hand, None);
            continue;
        };
        let (hand, violation) = (hand.expect("data"), &refutation.violation);
        if matches!(finding.theorem.statement, Statement::Bound { .. }) {
            let bound = parse(&hand.bound).expect("a formula");
            let bound = evaluate(&bound, &Parameters::<RealCyclotomic>::default());
            assert_eq!(bound.as_ref(), Ok(&violation.bound), "{}: {}", finding.id, hand.bound);
        }
        if let Some([first, second]) = &hand.sides {
            let gap = RealCyclotomic::from((&first.value - &second.value).abs());
            assert_eq!(gap, violation.attained.value, "{}", finding.id);
            assert!(gap > violation.bound);
        }
        let Some(weights) = &hand.weights else { continue };
        let total: Rational = weights.weights.iter().map(|(_, weight)| weight.clone()).sum();
        assert_eq!(total, Rational::one());
        let mut refined = std::collections::BTreeMap::<i64, Rational>::new();
        for ((_, weight), rule) in weights.weights.iter().zip(&weights.rules) {
            for (q, coefficient) in rule {
                *refined.entry(*q).or_insert_with(Rational::zero) += &(weight * coefficient);
            }
        }
        refined.retain(|_, weight| !weight.is_zero());
        assert_eq!(refined.into_iter().collect::<Vec<_>>(), weights.weights);
    }
}

#[test]
fn both_sides_are_those_of_the_finding() {
    let bounded = |what: &str, by: &str| {
        format!("scheme = 'four-point:w=1/16'\nbounds = '{what}'\nby = '{by}'\nfrom = '0'")
    };
    for theorem in [
        bounded("difference", "beta*(1/2)^k"),
        format!("{}\nvalues.c = ['1']", bounded("step", "beta*T^k/10")),
        bounded("distance", "sigma*beta*(1/2)^k/10"),
        bounded("distance", "beta*sum(j = 0..k, (1/2)^j)/100"),
        "scheme = 'chaikin'\noffset = '0'\nbounds = 'depth'\nby = 'levels(1/9, epsilon)'"
            .to_owned(),
        bounded("distance", "beta/100").replace("16'", "16 x chaikin'"),
        bounded("distance", "beta/100").replace("four-point:w=1/16", "doo-sabin:n=5"),
    ] {
        redone(&paper(&theorem));
    }
}

#[test]
fn every_number_of_a_small_refutation() {
    // Chaikin's points at i/2^k: the limit at 0 is (x_0 + x_1)/2, half a difference from x_0.
    let paper = paper(
        "schemes = ['chaikin']\nvalues.c = ['2']\noffset = '0'\nbounds = 'distance'\n\
         by = '(sigma*T^k/4 + contraction(1)/100)*beta'\nfrom = '0'",
    );
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    let hand = by_hand(&audit, &audit.theorems[0]).unwrap_or_else(|error| panic!("{error}"));
    let hand = hand.expect("it is refuted");
    let [sigma, t, contraction] = &hand.constants[..] else { panic!("{:?}", hand.constants) };
    // Points at i/2^k are 1/4 from the polygon, and 1/4.
    assert_eq!((&sigma.name[..], &t.name[..]), ("sigma", "T"));
    assert_eq!(t.value, r(1, 4).into());
    let cell = t.cell.as_ref().expect("a confirmed cell");
    assert_eq!((&cell.id[..], &cell.printed[..]), ("k:constants:2:2", "0.25"));
    assert_eq!(cell.locus, "Table 1, scheme = chaikin, c = 2");
    assert_eq!((&contraction.name[..], &contraction.cell), ("contraction(1)", &None));
    assert_eq!(hand.refiner.masks()[0].offset(), 0);
    assert_eq!(hand.contraction, Some((1, r(1, 2))));
    let weights = hand.weights.as_ref().expect("a limit");
    assert_eq!(weights.weights, [(0, r(1, 2)), (1, r(1, 2))]);
    assert_eq!(weights.rules[0], [(0, r(3, 4)), (1, r(1, 4))]);
    assert_eq!(hand.left_out, None);
    redone(&paper);
}

#[test]
fn what_would_be_long_is_left_out() {
    for (scheme, left_out) in
        [("chaikin x chaikin", LeftOut::Net), ("doo-sabin:n=5", LeftOut::Ring)]
    {
        let paper = paper(&format!(
            "scheme = '{scheme}'\nbounds = 'distance'\nby = 'beta/100'\nfrom = '0'"
        ));
        let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        let hand = by_hand(&audit, &audit.theorems[0]).unwrap_or_else(|error| panic!("{error}"));
        let hand = hand.expect("it is refuted");
        assert_eq!((hand.left_out, hand.sides), (Some(left_out), None));
        assert_eq!(&hand.bound[..], "1/100");
    }
}
