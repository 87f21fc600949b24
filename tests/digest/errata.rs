//! What the audit of a paper yields as a whole.

use crate::common::claims::{judged, paper};
use crate::common::papers::AUDITS;
use subcert::audit::{
    AsRead, Beyond, Cause, CellFinding, CellGroup, CellStanding, CellSummary, Erratum, Harm,
    Subject, Verdict, Word,
};
use subcert::claim::{Cell, Kind};
use subcert::exact::{Rational, RealCyclotomic, parse_decimal};
use subcert::report::{differences_sheet, errata_sheet};

/// The causes of a standing, with their numbers of cells.
fn causes(summary: &CellSummary, standing: CellStanding) -> Vec<(String, usize)> {
    let groups = summary.groups.iter().filter(|group| group.outcome.standing == standing);
    let cause = |group: &CellGroup| group.outcome.cause.as_ref().map(Cause::to_string);
    groups.map(|group| (cause(group).unwrap_or_default(), group.count)).collect()
}

/// Every cell of every table is in one group, and in the right one.
#[test]
fn the_summary_adds_up() {
    let (mut all, mut lost) = (0, 0);
    for audit in &*AUDITS {
        let paper = audit.paper;
        let summary = audit.cell_summary();
        let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
        let printed = paper.tables.iter().flat_map(|table| table.cells.iter().flatten());
        let cells_of = |table: &subcert::claim::Table| table.cell_count();
        assert_eq!(summary.cells(), paper.tables.iter().map(cells_of).sum::<usize>());
        let counts = audit.tally(&[Kind::Table]);
        let count = |words: &[Word]| words.iter().map(|word| counts.of(*word)).sum::<usize>();
        assert_eq!(summary.count(CellStanding::Confirmed), count(&[Word::Confirmed]));
        assert_eq!(
            summary.count(CellStanding::Explained),
            count(&[Word::Rounding, Word::OtherReading])
        );
        assert_eq!(summary.count(CellStanding::Misprinted), count(&[Word::Misprint]));
        assert_eq!(summary.count(CellStanding::Refuted), count(&[Word::Refuted]));
        assert_eq!(summary.count(CellStanding::NotCheckable), count(&[Word::NotCheckable]));
        for group in summary.groups.iter().filter(|g| g.outcome.standing == CellStanding::Explained)
        {
            let why = group.outcome.cause.as_ref().map(Cause::to_string);
            let read = |cell: &&subcert::audit::CellFinding| {
                cell.verdict_if_assumed.is_none()
                    && cell.as_read.as_ref().map(AsRead::differs) == why
            };
            assert_eq!(group.count, cells.clone().filter(read).count(), "{why:?}");
        }
        let gone = printed.filter(|cell| matches!(cell, Cell::Lost)).count();
        let groups = causes(&summary, CellStanding::NotCheckable).into_iter();
        let of_lost = groups.filter(|(cause, _)| *cause == "the cell is lost");
        assert_eq!(of_lost.map(|(_, count)| count).sum::<usize>(), gone);
        all += summary.cells();
        lost += gone;
    }
    assert_eq!((all, lost), (494 + 12, 12));
}

/// One table with a cell of every kind: x = 1/3 and 0.12345 at hand.
#[test]
fn every_standing_is_counted() {
    let paper = paper(
        "[[table]]\nid = 'a'\nlocus = 'A'\nvalue = 'x/3'\n\
         columns = { name = 'x', values = ['1', '2', '0.37035', '4', '5'] }\n\
         cells = [['0.333333', '0.6666', '0.12845', '7.7', '8.8']]\n\
         [[table]]\nid = 'b'\nlocus = 'B'\nvalue = 'x*y'\nunstated = { y = '1/2' }\n\
         columns = { name = 'x', values = ['1', '2', '3'] }\n\
         cells = [['0.5', '1.00', '7.7']]\n\
         [[table]]\nid = 'c'\nlocus = 'C'\nvalue = 'x*y'\nunstated = { y = '1/2' }\n\
         columns = { name = 'x', values = ['1', '2'] }\ncells = 'lost'\n",
    );
    let summary = judged(&paper).cell_summary();
    assert_eq!(summary.cells(), 10);
    assert_eq!(summary.count(CellStanding::Confirmed), 1);
    assert_eq!(causes(&summary, CellStanding::Explained), [("cut, not rounded".to_owned(), 1)]);
    let slip = "one slip away from the value of the definition".to_owned();
    assert_eq!(causes(&summary, CellStanding::Misprinted), [(slip, 1)]);
    assert_eq!(summary.count(CellStanding::Refuted), 2);
    let (lost, unstated) = ("the cell is lost".to_owned(), "the paper does not state y".to_owned());
    assert_eq!(
        causes(&summary, CellStanding::NotCheckable),
        [(lost, 2), (unstated.clone(), 2), (unstated, 1)]
    );
}

/// What rests on a failing equation is found through theorems; cells with one cause
/// are one erratum, with the depths that change and the promises that break.
#[test]
fn errata_and_what_they_change() {
    let paper = paper(
        "[[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'chaikin'\n\
         value = 'levels(1/2, epsilon/beta, rounded = up)'\ngiven = { beta = '1' }\n\
         promise = { tolerance = 'epsilon', spread = 'beta' }\n\
         columns = { name = 'epsilon', values = ['1/9', '1/20', '1/40', '1/70'] }\n\
         cells = [['3', '9', '6', '2']]\n\
         [[equation]]\nid = 'e'\nlocus = 'E'\nleft = ['1', '2']\nright = 'i'\n\
         indices = [{ name = 'i', values = ['1', '3'] }]\n\
         [[theorem]]\nid = 't'\nlocus = 'T'\nsays = 'x'\nrests = ['e']\n\
         [[theorem]]\nid = 'u'\nlocus = 'U'\nsays = 'y'\nrests = ['t']\n\
         [[theorem]]\nid = 'v'\nlocus = 'V'\nsays = 'z'\nrests = ['a']\n",
    );
    let audit = judged(&paper);
    let errata = audit.errata();
    let places: Vec<&str> = errata.errata.iter().map(Erratum::id).collect();
    assert_eq!(places, ["a", "a", "e"]);
    let theorems = |i: usize| -> Vec<&str> {
        let erratum: &Erratum<'_, '_> = &errata.errata[i];
        erratum.consequences.theorems.iter().map(|t| t.theorem.id.as_str()).collect()
    };
    assert_eq!(theorems(2), ["t", "u"]);
    assert_eq!(theorems(1), ["v"]);
    // Exactly 4, 5, 6 and 7 levels; the first is one short by rounding down.
    let [Subject::Cells(down), Subject::Cells(refuted)] =
        [&errata.errata[0].subject, &errata.errata[1].subject]
    else {
        panic!("cells first")
    };
    assert_eq!((down.outcome.standing, &down.cells[..]), (CellStanding::Explained, &[(0, 0)][..]));
    assert_eq!(
        (refuted.outcome.standing, &refuted.cells[..]),
        (CellStanding::Refuted, &[(0, 1), (0, 3)][..])
    );
    let changes = &errata.errata[1].consequences;
    assert_eq!((changes.smaller, changes.larger), (1, 1));
    assert_eq!(changes.broken_by_formula, 1);
    assert!(errata.unchecked.is_empty());
}

/// Whether a printed number is at most half a unit of its last place from the exact value.
fn rounded(cell: &CellFinding) -> bool {
    let printed = parse_decimal(cell.printed.as_ref().expect("a number")).expect("a decimal");
    let (low, high) = printed.interval();
    cell.exact.as_ref().is_some_and(|exact| {
        *exact >= RealCyclotomic::from(low) && *exact <= RealCyclotomic::from(high)
    })
}

/// Rounded values at a w that is not stated are no errata, but the value is reported.
#[test]
fn right_digits_at_recovered_values_are_no_errata() {
    let paper = paper(
        "[[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'four-point:w=w'\nunstated = ['w']\n\
         value = 'contraction(c)'\ncolumns = { name = 'c', values = ['1', '2', '3'] }\n\
         cells = [['0.586000', '0.300396', '0.150834']]\n",
    );
    let audit = judged(&paper);
    let reproduced = |cell: &&CellFinding| cell.verdict == Verdict::Reproduced;
    assert_eq!(audit.tables[0].cells.iter().flatten().filter(reproduced).count(), 3);
    let errata = audit.errata();
    assert!(errata.errata.is_empty() && errata.unchecked.is_empty());
    assert_eq!(errata.recovered.len(), 1);
    let sheet = errata_sheet(std::slice::from_ref(&audit)).to_markdown();
    assert!(sheet.contains("The paper does not state w. These numbers give w = "), "{sheet}");
}

/// Every cell that is not as printed is in exactly one erratum or among the unchecked,
/// and so is every failing claim.
#[test]
fn nothing_wrong_is_left_out() {
    for audit in &*AUDITS {
        let errata = audit.errata();
        let mut listed: Vec<&str> = Vec::new();
        for erratum in &errata.errata {
            if let Subject::Cells(cells) = &erratum.subject
                && !cells.as_defined
            {
                listed.extend(cells.findings().map(|cell| cell.id.as_str()));
            }
        }
        listed.extend(errata.unchecked.iter().flat_map(|u| u.findings().map(|c| c.id.as_str())));
        listed.sort_unstable();
        let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
        let wrong = cells.filter(|cell| match cell.verdict {
            Verdict::Confirmed => false,
            Verdict::Reproduced => !rounded(cell),
            _ => true,
        });
        let mut wrong: Vec<&str> = wrong.map(|cell| cell.id.as_str()).collect();
        wrong.sort_unstable();
        assert_eq!(listed, wrong, "{}", audit.paper.key);
        for claim in audit.claims().iter().filter(|claim| claim.fails()) {
            assert!(errata.errata.iter().any(|erratum| erratum.id() == claim.id), "{}", claim.id);
        }
    }
}

/// One claim for each harm, from the least to the worst: the page has them the other way round.
const HARMS: &str = "[[smoothness]]\nid = 'c'\nlocus = 'C'\nscheme = 'b-spline:degree=3'\ncontinuous = '1'\n\
     [[smoothness]]\nid = 'r'\nlocus = 'R'\nscheme = 'chaikin'\ncontinuous = '2'\n\
     [[table]]\nid = 'n'\nlocus = 'N'\nvalue = 'x/3'\ncolumns = { name = 'x', values = ['1'] }\ncells = [['0.7']]\n\
     [[table]]\nid = 'b'\nlocus = 'B'\nscheme = 'chaikin'\nvalue = 'levels(1/2, epsilon/beta, rounded = up)'\n\
     given = { beta = '1' }\npromise = { tolerance = 'epsilon', spread = 'beta' }\n\
     columns = { name = 'epsilon', values = ['1/1000'] }\ncells = [['2']]\n\
     [[equation]]\nid = 'e'\nlocus = 'E'\nleft = ['1']\nright = '2'\n\
     [[range]]\nid = 'small'\nlocus = 'S'\nvariable = 'w'\nscheme = 'four-point:w=w'\nvalue = 'contraction(1)'\n\
     below = '1'\nfrom = '-0.125'\nto = '0.125'\n\
     [[range]]\nid = 'large'\nlocus = 'L'\nvariable = 'w'\nscheme = 'four-point:w=w'\nvalue = 'contraction(1)'\n\
     below = '1'\nfrom = '-0.5'\nto = '0.5'\n";

#[test]
fn differences_stand_by_their_harm() {
    let of_all = paper(HARMS);
    let audit = judged(&of_all);
    let errata = audit.errata();
    let harms: Vec<(&str, Harm)> = errata.errata.iter().map(|one| (one.id(), one.harm())).collect();
    assert_eq!(
        harms,
        [
            ("n", Harm::Number),
            ("b", Harm::Broken),
            ("e", Harm::Formula),
            ("small", Harm::NotSharp),
            ("large", Harm::Broken),
            ("r", Harm::Refuted),
        ]
    );
    let page = differences_sheet(std::slice::from_ref(&audit)).to_markdown();
    let at = |text: &str| page.find(text).unwrap_or_else(|| panic!("no {text} in {page}"));
    let order =
        ["7 differences in 1 of 1", "k:r", "k:b", "k:large", "k:e", "k:n", "k:small", "k:c"];
    let places: Vec<usize> = order.iter().map(|text| at(text)).collect();
    assert!(places.is_sorted(), "{page}");
    // A number as printed and exactly, with the sound level of a broken promise.
    assert!(
        page.contains("| 0.7 | 0.3 |") && page.contains("| 2 | 10 by definition; sound: "),
        "{page}"
    );
    // Nothing differs in no paper, and in one without claims.
    assert!(differences_sheet(&[]).to_markdown().contains("0 differences in 0 of 0 papers"));
    let open = paper(
        "[[smoothness]]\nid = 'o'\nlocus = 'O'\nscheme = 'sqrt3'\nvalences = '5'\ncontinuous = '1'\n",
    );
    let page = differences_sheet(&[judged(&open)]).to_markdown();
    assert!(page.contains("(k, of which 1 claim is not decided)"), "{page}");
    let empty = paper("");
    let page = differences_sheet(&[judged(&empty)]).to_markdown();
    assert!(
        page.contains("0 differences in 0 of 1") && page.contains("Papers without a difference")
    );
}

#[test]
fn what_is_true_beyond_a_claim() {
    let range = |id: &str, scheme: &str, m: u32, from: &str, to: &str| {
        format!(
            "[[range]]\nid = '{id}'\nlocus = ''\nvariable = 'w'\nscheme = '{scheme}=w'\nsmoothness = '{m}'\n\
             from = '{from}'\nto = '{to}'\n"
        )
    };
    let exponent = |id: &str, said: &str| {
        format!("[[exponent]]\nid = '{id}'\nlocus = ''\nscheme = 'chaikin'\n{said}\n")
    };
    let claims = [
        range("wider", "four-point:w", 1, "0", "1/8"),
        range("sharp", "ternary-four-point:mu", 2, "1/15", "1/9"),
        range("rounded", "four-point:w", 1, "0", "0.1927"),
        exponent("above", "at_least = '3/2'"),
        exponent("equal", "at_least = '2'"),
        exponent("below", "at_most = '5/2'"),
        exponent("between", "at_least = '3/2'\nat_most = '5/2'"),
        exponent("wrong", "at_least = '5/2'"),
        "[[smoothness]]\nid = 'less'\nlocus = ''\nscheme = 'chaikin'\ncontinuous = '0'\n"
            .to_owned(),
        "[[smoothness]]\nid = 'most'\nlocus = ''\nscheme = 'chaikin'\ncontinuous = '1'\n"
            .to_owned(),
    ];
    let paper = paper(&claims.concat());
    let audit = judged(&paper);
    let more = audit.not_sharp();
    let ids: Vec<&str> = more.iter().map(|one| &one.finding.claim.id[..]).collect();
    assert_eq!(ids, ["less", "above", "below", "wider"]);
    assert_eq!(more[0].beyond, Beyond::Continuous(1));
    let Beyond::Range(set) = &more[3].beyond else { panic!("a range") };
    let inside = |p, q| set.contains(&Rational::new(p, q));
    assert_eq!([inside(3, 20), inside(1, 16), inside(1, 5)], [true, false, false]);
}
