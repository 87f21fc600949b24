//! Readings of the same scheme with other numbers of its points.

use crate::common::claims::{HEAD, judged, paper, theorem};
use crate::common::r;
use proptest::prelude::*;
use subcert::audit::{Copied, Correction, Difference, PaperAudit, TheoremVerdict, Verdict};
use subcert::bound::{Order, power_norm};
use subcert::certificate::certificate;
use subcert::exact::Rational;
use subcert::scheme::{Mask, parse_scheme};
use subcert_check::{Outcome, check};

/// T_1, …, T_5 of the ternary three-point scheme with a = 0.2778, its mask typed as [a, 4/3 − 2a, a −
/// 1/3], [0, 1, 0], [a − 1/3, 4/3 − 2a, a] and read forwards; computed by another program from the definition. The
/// catalogue's mask begins with the point that stays, and gives 0.222163 for T_2.
const PRINTED: [&str; 5] = ["0.555467", "0.253017", "0.11107", "0.047856", "0.020353"];

fn table(scheme: &str, rest: &str, cells: &[&str]) -> String {
    format!(
        "[[table]]\nid = 't'\nlocus = 'T'\nscheme = '{scheme}'\nvalue = 'contraction(c)'\n{rest}\n\
         columns = {{ name = 'c', values = ['1', '2', '3', '4', '5'] }}\ncells = [['{}']]\n",
        cells.join("', '")
    )
}

/// The numbers of the first points of the readings that give most cells.
fn firsts(audit: &PaperAudit<'_>) -> Vec<usize> {
    let search = audit.tables[0].search.as_ref().expect("a search");
    let first = |difference: &Difference| match difference {
        Difference::Copied(Copied::Numbers { first }) => Some(*first),
        _ => None,
    };
    search.best.iter().filter_map(|best| best.differences.iter().find_map(first)).collect()
}

fn certified(claims: &str, audit: &PaperAudit<'_>) {
    let text = certificate(audit).text;
    let outcome = |text: &str| {
        let report = check(&format!("{HEAD}{claims}"), &[text]).expect("a claim file");
        report.claims.into_iter().next().expect("a claim").2
    };
    assert_eq!(outcome(&text), Outcome::Valid, "{text}");
    // Of three rows there is no fourth.
    let other = text.replacen("read copied scheme@row#2", "read copied scheme@row#4", 1);
    assert_ne!(other, text);
    assert!(matches!(outcome(&other), Outcome::Invalid(..)), "{other}");
}

#[test]
fn a_table_of_the_same_scheme_with_other_numbers_is_reproduced() {
    let claims = table("ternary-three-point:a=a", "unstated = ['a']", &PRINTED);
    let paper = paper(&claims);
    let audit = judged(&paper);
    let cells: Vec<_> = audit.tables[0].cells.iter().flatten().map(|cell| &cell.verdict).collect();
    assert_eq!(cells, [&Verdict::Reproduced; 5]);
    assert_eq!(audit.tables[0].recovered["a"].value, r(1389, 5000));
    // The mask is symmetric.
    assert_eq!(firsts(&audit), [1, 2]);
    certified(&claims, &audit);
}

#[test]
fn where_the_parameter_is_stated_it_is_another_reading() {
    let claims = table("ternary-three-point:a=1389/5000", "", &PRINTED);
    let paper = paper(&claims);
    let audit = judged(&paper);
    let cells: Vec<_> = audit.tables[0].cells.iter().flatten().map(|cell| &cell.verdict).collect();
    assert_eq!(cells[0], &Verdict::Confirmed);
    assert_eq!(cells[1..], [&Verdict::OtherReading; 4]);
    assert_eq!(firsts(&audit), [1, 2]);
    certified(&claims, &audit);
}

/// Where masks are not read forwards, the numbers of the points change nothing, and give no readings.
#[test]
fn other_digits_are_refuted() {
    let printed = ["0.655467", "0.353017", "0.21107", "0.147856", "0.120353"];
    let claims = table("ternary-three-point:a=1389/5000", "", &printed);
    let paper = paper(&claims);
    let audit = judged(&paper);
    assert!(firsts(&audit).is_empty());
    let search = audit.tables[0].search.as_ref().expect("a search");
    // The order, the terms of T_1, and the decimals; then two numbers with the order forward, alone or with the terms.
    assert!(search.elsewhere && search.tried == 3 * 4 + 3 * 4, "{}", search.tried);
}

/// A theorem that differences are at most this from level 2 on.
fn differences_at_most(by: &str) -> String {
    theorem(&format!(
        "scheme = 'ternary-three-point:a=1389/5000'\nbounds = 'difference'\nby = '{by}'\nfrom = '2'"
    ))
}

/// Differences after two levels are at most T_2 = 0.222163…, and reach it. Nine tenths of T_2 read
/// forwards are less in the catalogue's numbers, and 9/10·0.253017… in the two others.
#[test]
fn a_theorem_is_true_in_other_numbers_of_the_points() {
    let by = "beta*contraction(2, order=forward)*(9/10)^(k-1)";
    let claims = differences_at_most(by);
    let paper = paper(&claims);
    let finding = &judged(&paper).theorems[0];
    assert_eq!(finding.verdict, TheoremVerdict::Refuted);
    let saves = |one: &Correction| match one {
        Correction::Numbers { first } => *first,
        Correction::Way(choice, _) if choice.key == "order" => 0,
        other => panic!("{other}"),
    };
    assert_eq!(finding.corrections.iter().map(saves).collect::<Vec<_>>(), [0, 1, 2]);
    let sets: Vec<_> =
        finding.repairs.iter().map(|one| (&one.corrections[..], one.proved)).collect();
    assert_eq!(sets, [(&[1][..], true), (&[2], true)]);
}

/// A bound that is false in every numbering of the points stays so, and no set holds two numberings or
/// one of them beside the order in which they change nothing.
#[test]
fn a_theorem_that_is_false_in_all_numbers_is_not_saved() {
    let by = "beta*contraction(2, order=forward)/2*(9/10)^(k-2)";
    let claims = differences_at_most(by);
    let paper = paper(&claims);
    let finding = &judged(&paper).theorems[0];
    assert_eq!(finding.verdict, TheoremVerdict::Refuted);
    assert_eq!((finding.corrections.len(), finding.repairs.len()), (3, 0));
}

fn mask() -> impl Strategy<Value = Mask> {
    let rows = |(n, width): (usize, usize)| {
        prop::collection::vec(prop::collection::vec(-9_i64..10, width - 1), n)
    };
    (2_usize..5, 2_usize..5).prop_flat_map(rows).prop_map(|rows| {
        let affine = |row: Vec<i64>| {
            let mut row: Vec<Rational> = row.into_iter().map(|p| r(p, 16)).collect();
            row.push(row.iter().fold(Rational::one(), |rest, a| rest - a));
            row
        };
        Mask::new(rows.into_iter().map(affine).collect(), -1).expect("affine rules")
    })
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    /// Point i of the new scheme is point i + first of the old one, so norms of powers are the same.
    #[test]
    fn numbers_change_no_norm(mask in mask(), first in 0_usize..4, points in prop::collection::vec(-9_i64..10, 5..9)) {
        let first = first % mask.arity();
        let other = mask.numbered_from(first);
        let points: Vec<Rational> = points.into_iter().map(Rational::from).collect();
        let mut refined = mask.rules().refine_closed(&points);
        refined.rotate_left(first);
        prop_assert_eq!(other.rules().refine_closed(&points), refined);
        let differences = [other.difference(), mask.difference().numbered_from(first)];
        prop_assert_eq!(differences[0].rows(), differences[1].rows());
        for c in 1..=3 {
            let norm = |mask: &Mask| power_norm(&mask.difference(), c, Order::Adjoint).unwrap().value;
            prop_assert_eq!(norm(&other), norm(&mask));
        }
    }
}

/// Read forwards, T_2 depends on the numbers, but not on the number of a multiple of the arity.
#[test]
fn numbers_matter_forwards() {
    let scheme = parse_scheme("ternary-three-point:a=1389/5000").expect("a scheme");
    let mask = &scheme.masks()[0];
    let norm = |mask: &Mask| power_norm(&mask.difference(), 2, Order::Forward).unwrap().value;
    assert_ne!(norm(&mask.numbered_from(1)), norm(mask));
    assert_eq!(norm(&mask.numbered_from(1).numbered_from(2)), norm(mask));
}
