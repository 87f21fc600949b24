//! Parameters that a paper does not state, recovered from its tables.

use proptest::prelude::*;
use subcert::audit::{AsRead, CellKind, PaperAudit, RecoveredFrom, Verdict, audit, readings};
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Integer, Rational};

fn paper(tables: &str) -> Paper {
    let head = "key = 'k'\n[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n\
                [define]\nhalf = 'x/2'\n[[alternative]]\nof = 'half'\nlabel = 'a third'\n\
                value = 'x/3'\n";
    let source = SourceText::new("k.toml", format!("{head}{tables}"));
    read_paper(&source).unwrap_or_else(|error| panic!("{error}"))
}

fn judged(paper: &Paper) -> PaperAudit<'_> {
    audit(paper).unwrap_or_else(|error| panic!("{error}"))
}

/// A table of one row over x.
fn table(id: &str, value: &str, unstated: &str, x: &[&str], cells: &[&str]) -> String {
    let list = |texts: &[&str]| {
        texts.iter().map(|text| format!("'{text}'")).collect::<Vec<_>>().join(", ")
    };
    format!(
        "[[table]]\nid = '{id}'\nlocus = '{id}'\nvalue = '{value}'\nunstated = {unstated}\n\
         columns = {{ name = 'x', values = [{}] }}\ncells = [[{}]]\n",
        list(x),
        list(cells)
    )
}

/// With T = 1/2 and σ = 1/4 the depth at ε is ⌈log_2(τ/(2ε))⌉, and 0 at τ ≤ 2ε: at τ = 1/5 these
/// depths. Every τ up to 1/10 fits the zeros of the other table, and 0 is no spread.
#[test]
fn depths_of_no_level_bound_the_spread_from_above_alone() {
    let table = |id: &str, epsilon: &[&str], cells: &[&str]| {
        let list = |texts: &[&str]| format!("['{}']", texts.join("', '"));
        format!(
            "[[table]]\nid = '{id}'\nlocus = '{id}'\nscheme = 'chaikin'\n\
             value = 'levels(contraction(1), epsilon*(1 - contraction(1))/(displacement()*tau))'\n\
             unstated = ['tau']\npromise = {{ tolerance = 'epsilon', spread = 'tau' }}\n\
             columns = {{ name = 'epsilon', values = {} }}\ncells = [{}]\n",
            list(epsilon),
            list(cells)
        )
    };
    let epsilon = [
        "0.1", "0.05", "0.01", "3e-3", "3e-4", "3e-5", "3e-6", "3e-7", "3e-8", "7e-3", "7e-4",
        "7e-5", "7e-6", "7e-7", "7e-8", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8",
    ];
    let depths = [
        "0", "1", "4", "6", "9", "12", "16", "19", "22", "4", "8", "11", "14", "18", "21", "7",
        "10", "14", "17", "20", "24",
    ];
    let paper = paper(&table("mixed", &epsilon, &depths));
    let audit = judged(&paper);
    assert_eq!(verdicts(&audit, 0), ["reproduced"; 21]);
    let tau = &audit.tables[0].recovered["tau"].value;
    // 2·3e-8·2^21 = 0.12582912, and of the others 2·3e-6·2^15 = 0.196608 is the greatest lower bound.
    assert!(*tau > Rational::new(196_608, 1_000_000) && *tau <= Rational::new(1, 5), "{tau}");
    let paper = crate::judge::recovered::paper(&table("zeros", &epsilon[..3], &["0", "0", "0"]));
    let zeros = judged(&paper);
    let spreads = zeros.tables[0].recovered.values().map(|recovered| recovered.value.sign());
    assert!(spreads.into_iter().all(|sign| sign > 0));
}

fn verdicts(audit: &PaperAudit<'_>, table: usize) -> Vec<&'static str> {
    audit.tables[table].cells.iter().flatten().map(|cell| cell.verdict.word().name()).collect()
}

/// τ = 7/20 by hand: 1.2345·τ = 0.432075, 2.3457·τ = 0.820995 and 3.4561·τ = 1.209635.
#[test]
fn values_are_solved_for_lent_and_left_open() {
    let x = ["1.2345", "2.3457", "3.4561", "4.1"];
    let text = [
        table("own", "x*tau", "['tau']", &x, &["0.432075", "0.820995", "1.209635", "9.99999"]),
        // With x/3 in place of x/2: 0.144025, 0.273665 and 0.4032116….
        table("read", "half*tau", "['tau']", &x[..3], &["0.144025", "0.273665", "0.403212"]),
        table("lent", "floor(x + tau)", "['tau']", &["1", "2"], &["1", "2"]),
        table("open", "x*rho", "['rho']", &["1", "2"], &["0.71", "1.4"]),
        table("assumed", "x*tau", "{ tau = '7/20' }", &["1.2345"], &["0.432075"]),
    ];
    let paper = paper(&text.concat());
    let audit = judged(&paper);
    let recovered = |table: usize, name: &str| audit.tables[table].recovered.get(name).cloned();
    let tau = Rational::new(7, 20);
    let own = recovered(0, "tau").expect("a value");
    assert_eq!(own.value, tau);
    let RecoveredFrom::Solved(low, high) = &own.from else { panic!("{own:?}") };
    // 0.820995 ± 5e-7 over 2.3457 is the least of the intervals but for that of 3.4561.
    assert!(*low < tau && tau < *high && high - low < Rational::new(1, 1_000_000));
    let reproduced = ["reproduced"; 3];
    assert_eq!(verdicts(&audit, 0), [&reproduced[..], &["not-checkable"]].concat());
    let last = &audit.tables[0].cells[0][3];
    assert_eq!(last.verdict_if_assumed, Some(Verdict::Refuted));
    // The same value, under another reading or another value as printed; both are 3 of 3.
    assert_eq!(verdicts(&audit, 1), reproduced);
    let read = recovered(1, "tau").expect("a value");
    let by = audit.tables[1].cells[0][0].as_read.as_ref().map(AsRead::differs);
    match by.as_deref() {
        Some("a third") => assert_eq!(read.value, tau),
        None => assert_eq!(read.value, Rational::new(7, 30)),
        other => panic!("{other:?}"),
    }
    let lent = recovered(2, "tau").expect("a value");
    assert!(matches!(lent.from, RecoveredFrom::Table { .. }), "{lent:?}");
    // Two small integers say nothing of τ.
    assert_eq!(verdicts(&audit, 2), ["not-checkable"; 2]);
    let [first, _] = &audit.tables[2].cells[0][..] else { panic!("two cells") };
    assert_eq!(first.verdict_if_assumed, Some(Verdict::Confirmed));
    assert_eq!(recovered(3, "rho"), None);
    let cell = &audit.tables[3].cells[0][0];
    assert_eq!((&cell.exact, cell.unknown.as_deref()), (&None, Some("rho")));
    assert_eq!(verdicts(&audit, 4), ["not-checkable"]);
    assert!(audit.tables[4].recovered.is_empty());
    // The printed text is one of the readings at the recovered value.
    let all = readings(&paper, &audit.tables[0], CellKind::Assumed).expect("readings");
    assert!(all.iter().any(|reading| reading.differences.is_empty() && reading.count() == 3));
}

/// min(10^e, q²): how many decimal places, or how large a denominator, a number needs.
fn cost(value: &Rational) -> Integer {
    let square = value.denominator().pow(2);
    let places = (0..30).find(|e| (value * Rational::power_of_ten(*e)).is_integer());
    places.map_or(square.clone(), |e| Rational::power_of_ten(e).numerator().min(square))
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    /// Of a hidden factor, with a few digits or a small denominator, what is recovered is at
    /// least as plain, and no number between the ends is plainer: none was found by trying all.
    #[test]
    fn the_plainest_factor_is_recovered(p in 1_i64..90, q in 1_i64..90, decimal in any::<bool>()) {
        let hidden = if decimal { Rational::new(p, 100) } else { Rational::new(p, q) };
        let x = ["1.2345", "2.3457", "3.4561", "7.7713"];
        let cell = |x: &&str| {
            let x: Rational = x.replace('.', "").parse::<i64>().expect("digits").into();
            let value = x * &hidden / Rational::from(10_000);
            subcert::exact::format::fixed(&value, 7)
        };
        let cells: Vec<String> = x.iter().map(cell).collect();
        let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
        let paper = paper(&table("t", "x*tau", "['tau']", &x, &cells));
        let audit = judged(&paper);
        prop_assert_eq!(verdicts(&audit, 0), ["reproduced"; 4]);
        let recovered = &audit.tables[0].recovered["tau"];
        let RecoveredFrom::Solved(low, high) = &recovered.from else { panic!("{recovered:?}") };
        prop_assert!(cost(&recovered.value) <= cost(&hidden), "{:?} for {}", recovered, hidden);
        for d in 1..100_i64 {
            let over = Rational::from(d);
            let first = (low * &over).floor() + Integer::one();
            let inside = Rational::from(first) / &over;
            if inside < *high && Integer::from(d * d) < cost(&recovered.value) {
                prop_assert!(cost(&inside) >= cost(&recovered.value), "{}", inside);
            }
        }
    }
}

/// τ = 9/91 gives ten of ten cells of the first table, 1/10 gives eight and all of the second. Two cells of two
/// digits are no evidence among the numbers as plain as 9/91; three of six digits are.
#[test]
fn tables_share_a_value_unless_one_has_evidence_of_its_own() {
    let rough = [
        ("11", "1.1"),
        ("12", "1.2"),
        ("13", "1.3"),
        ("21", "2.1"),
        ("22", "2.2"),
        ("31", "3.1"),
        ("32", "3.2"),
        ("41", "4.1"),
        ("66", "6.5"),
        ("77", "7.6"),
    ];
    let (x, cells): (Vec<&str>, Vec<&str>) = rough.into_iter().unzip();
    let fine = ["1.23456", "2.34567", "3.45678"];
    let tenth = ["0.123456", "0.234567", "0.345678"];
    let other = ["0.112233", "0.213243", "0.314253"];
    let rough = table("rough", "x*tau", "['tau']", &x, &cells);
    let sure = table("sure", "x*tau", "['tau']", &fine, &tenth);
    let else_ = table("else", "x*tau", "['tau']", &fine, &other);
    let lent = table("lent", "floor(x + tau)", "['tau']", &["1", "2"], &["1", "2"]);
    let found = |tables: &[&String]| {
        let text: String = tables.iter().map(|table| table.as_str()).collect();
        let paper = paper(&text);
        let audit = judged(&paper);
        let value = |table: &subcert::audit::TableFinding<'_>| table.recovered["tau"].value.clone();
        audit.tables.iter().map(value).collect::<Vec<_>>()
    };
    let (of_rough, of_sure) = (Rational::new(9, 91), Rational::new(1, 10));
    assert_eq!(found(&[&rough]), [of_rough]);
    let all = [of_sure.clone(), of_sure.clone(), of_sure.clone()];
    assert_eq!(found(&[&rough, &sure, &lent]), all);
    assert_eq!(found(&[&sure, &lent, &rough]), all);
    assert_eq!(found(&[&else_, &sure]), [Rational::new(1, 11), of_sure]);
}

/// Two of three cells fit an interval of k, which may be luck: nothing is recovered, and the values that fit are said.
#[test]
fn what_fits_and_may_be_luck_is_said_and_certifies_nothing() {
    let cells = ["0.7", "1.4", "3.9"];
    let paper = paper(&table("few", "k*x", "['k']", &["1", "2", "3"], &cells));
    let audit = judged(&paper);
    let finding = &audit.tables[0];
    assert!(finding.recovered.is_empty());
    let fitting = finding.fitting.as_ref().expect("values that fit");
    assert_eq!(fitting.cells, 2);
    let found = &fitting.values["k"];
    assert!(found.value >= Rational::new(65, 100) && found.value <= Rational::new(75, 100));
    assert!(matches!(&found.from, RecoveredFrom::Solved(low, high) if low < high));
    let report = subcert::report::audit_sheet(&[audit], true).to_text(Some(200));
    assert!(report.contains("2 of 3 fit k from 0.675 to 0.725, which may be luck"), "{report}");
}
