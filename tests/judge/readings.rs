//! The search for readings: on tables that were computed under a known one.

use crate::common::papers::audit_of;
use crate::common::r;
use proptest::prelude::*;
use subcert::audit::{
    CellFinding, FAMILY, Missing, PaperAudit, Recovered, RecoveredFrom, Search, Slip,
    UnstatedOffset, Verdict, audit,
};
use subcert::bound::{Constants, Suprema};
use subcert::bound::{Operator, Order, Rounded, Terms, displacement, log_level};
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::format::fixed;
use subcert::exact::{Integer, Rational};
use subcert::scheme::{Mask, parse_scheme};
use subcert_check::{Outcome, check};

/// A paper with a scheme `s` of this mask and one table with a row of cells.
fn paper(mask: &Mask, value: &str, rest: &str, columns: &str, cells: &[String]) -> Paper {
    let quoted = |values: Vec<String>| {
        values.iter().map(|value| format!("'{value}'")).collect::<Vec<_>>().join(", ")
    };
    let rows = mask.rules().rows().iter();
    let rows = rows.map(|row| quoted(row.iter().map(ToString::to_string).collect()));
    let rows: Vec<String> = rows.map(|row| format!("[{row}]")).collect();
    let text = format!(
        "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n\
         [[scheme]]\nname = 's'\nmask = [{}]\n\
         [[table]]\nid = 't'\nlocus = 'T'\nscheme = 's'\nvalue = '{value}'\n{rest}\n\
         columns = {{ name = 'c', values = [{columns}] }}\ncells = [[{}]]\n",
        rows.join(", "),
        quoted(cells.to_vec()),
    );
    read_paper(&SourceText::new("k.toml", text)).unwrap_or_else(|error| panic!("{error}"))
}

fn judged(paper: &Paper) -> PaperAudit<'_> {
    audit(paper).unwrap_or_else(|error| panic!("{error}"))
}

/// `value` cut to this many decimals.
fn cut(value: &Rational, places: u32) -> String {
    let scaled = (value * Rational::from(Integer::power_of_ten(places))).floor();
    let digits = format!("{:0>width$}", scaled.to_string(), width = places as usize + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places as usize);
    format!("{whole}.{fraction}")
}

fn says(search: &Search) -> Vec<Vec<String>> {
    let says = |differences: &[subcert::audit::Difference]| {
        differences.iter().map(ToString::to_string).collect()
    };
    search.best.iter().map(|explanation| says(&explanation.differences)).collect()
}

/// Masks of two rules and three or four columns.
fn mask() -> impl Strategy<Value = Mask> {
    let row = |width: usize| prop::collection::vec(-9_i64..10, width - 1);
    (3_usize..5).prop_flat_map(move |width| (row(width), row(width))).prop_map(|rows| {
        let affine = |row: Vec<i64>| {
            let mut row: Vec<Rational> = row.into_iter().map(|p| r(p, 16)).collect();
            let rest = row.iter().fold(Rational::one(), |rest, a| rest - a);
            row.push(rest);
            row
        };
        Mask::new(vec![affine(rows.0), affine(rows.1)], 0).unwrap()
    })
}

const PLACES: u32 = 6;

/// A mask of two rules that depends on w: the coefficients a + b·w, where the a of a
/// rule sum to 1 and the b to 0.
#[derive(Clone, Debug)]
struct Family {
    constant: Mask,
    slope: Vec<Vec<Rational>>,
}

impl Family {
    fn at(&self, w: &Rational) -> Mask {
        let rows = self.constant.rules().rows().iter().zip(&self.slope);
        let row = |(a, b): (&Vec<Rational>, &Vec<Rational>)| {
            a.iter().zip(b).map(|(a, b)| a + b * w).collect()
        };
        Mask::new(rows.map(row).collect(), 0).unwrap()
    }

    /// A paper with this scheme and one table.
    fn paper(&self, value: &str, rest: &str, columns: &str, cells: &[String]) -> Paper {
        let entry = |(a, b): (&Rational, &Rational)| format!("'{a} + ({b})*w'");
        let rows = self.constant.rules().rows().iter().zip(&self.slope).map(|(a, b)| {
            let row: Vec<String> = a.iter().zip(b).map(entry).collect();
            format!("[{}]", row.join(", "))
        });
        let rows: Vec<String> = rows.collect();
        let cells: Vec<String> = cells.iter().map(|cell| format!("'{cell}'")).collect();
        let text = format!(
            "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n\
             [[scheme]]\nname = 's'\nparameters.w = {{ about = '' }}\nmask = [{}]\n\
             [[table]]\nid = 't'\nlocus = 'T'\nscheme = 's:w=w'\nvalue = '{value}'\n{rest}\n\
             columns = {{ name = 'c', values = [{columns}] }}\ncells = [[{}]]\n",
            rows.join(", "),
            cells.join(", "),
        );
        read_paper(&SourceText::new("k.toml", text)).unwrap_or_else(|error| panic!("{error}"))
    }
}

fn family() -> impl Strategy<Value = Family> {
    let slopes = prop::collection::vec(prop::collection::vec(-3_i64..4, 2), 2);
    let constants = prop::collection::vec(prop::collection::vec(-3_i64..9, 2), 2);
    (constants, slopes).prop_map(|(constants, slopes)| {
        let complete = |row: &Vec<i64>, sum: i64| {
            let row = row.iter().map(|p| r(*p, 8));
            let mut row: Vec<Rational> = row.collect();
            row.push(r(sum, 1) - row.iter().sum::<Rational>());
            row
        };
        let constant = constants.iter().map(|row| complete(row, 1)).collect();
        let slope = slopes.iter().map(|row| complete(row, 0)).collect();
        Family { constant: Mask::new(constant, 0).unwrap(), slope }
    })
}

proptest! {
    #![proptest_config(crate::common::cases(30))]

    /// The other order, Σ|ã|, decimals cut and a hidden scale are all recovered.
    #[test]
    fn a_hidden_reading_is_found(mask in mask(), p in 1_i64..10, q in 1_i64..10) {
        let constants = Constants::new(mask.clone());
        let t = |c, order| constants.norm(Operator::Difference, c, order).unwrap();
        let (sound, printed) = (
            displacement(&mask, Terms::Each),
            displacement(&mask, Terms::Total),
        );
        let scale = r(p, q);
        let value = |c| &sound * t(c, Order::Adjoint) * &scale;
        let cells: Vec<String> = (1..=5).map(|c| cut(&value(c), PLACES)).collect();
        let paper = paper(
            &mask,
            "displacement(terms = total, offset = 0)*contraction(c, order = forward)*beta",
            "unstated = ['beta']",
            "'1', '2', '3', '4', '5'",
            &cells,
        );
        let audit = judged(&paper);
        let table = &audit.tables[0];
        // With a scale that is solved for, another factor in front is none.
        let same_order = (1..=5).all(|c| t(c, Order::Adjoint) == t(c, Order::Forward));
        prop_assume!(!sound.is_zero() && !printed.is_zero() && !same_order);
        let search = table.search.as_ref().expect("a search");
        prop_assume!(cells.iter().all(|cell| cell.trim_matches(['0', '.']).len() > 4));
        let best = search.best.first().expect("a reading");
        prop_assert_eq!(best.count(), 5, "{:?}", says(search));
        prop_assert!(says(search).iter().any(|differences| {
            differences.iter().any(|says| says == "masks read backwards")
        }), "{:?}", says(search));
        let (low, high) = between(&table.recovered["beta"]);
        let value = &table.recovered["beta"].value;
        prop_assert!(low <= value && value <= high);
        for cell in table.cells.iter().flatten() {
            prop_assert_eq!(&cell.verdict, &Verdict::Reproduced);
        }
    }

    /// One digit altered: the reading is found, and the digit is the slip.
    #[test]
    fn a_slip_under_a_hidden_reading_is_found(mask in mask(), at in 0_usize..6, up in 1_u8..5) {
        let constants = Constants::new(mask.clone());
        let value = |c| constants.tensor(c, Order::Adjoint, Suprema::Joint).unwrap();
        let claimed = |c| constants.tensor(c, Order::Adjoint, Suprema::Independent).unwrap();
        let different = (1..=6).filter(|&c| value(c) != claimed(c)).count();
        prop_assume!(different >= 3 && (1..=6).all(|c| value(c) > r(1, 10)));
        let mut cells: Vec<String> = (1..=6).map(|c| cut(&value(c), PLACES)).collect();
        // The third digit after the point.
        let point = cells[at].find('.').unwrap();
        let digit = cells[at].as_bytes()[point + 3] - b'0';
        let other = (digit + up) % 10;
        let level = u32::try_from(at + 1).unwrap();
        prop_assume!(!cells[at].ends_with('0'));
        prop_assume!(value(level) != claimed(level));
        cells[at].replace_range(point + 3..point + 4, &other.to_string());
        let paper = paper(&mask, "tensor(c)", "", "'1', '2', '3', '4', '5', '6'", &cells);
        let audit = judged(&paper);
        let search = audit.tables[0].search.as_ref().expect("a search");
        prop_assert!(says(search).iter().any(|differences| differences
            .contains(&"one supremum over a common index".to_owned())), "{:?}", says(search));
        prop_assert_eq!(search.best[0].count(), 5);
        let verdict = &audit.tables[0].cells[0][at].verdict;
        prop_assert!(matches!(verdict, Verdict::Misprint(Slip::Digit { .. })), "{:?}", verdict);
    }

    /// A hidden parameter of the scheme, under a hidden reading: an interval that holds it
    /// is found, and a digit altered is the slip.
    #[test]
    fn a_hidden_parameter_is_found(
        family in family(), p in -40_i64..41, q in 1_i64..25, at in prop::option::of(0_usize..5),
        up in 1_u8..5,
    ) {
        let w = r(p, q * 4);
        let constants = Constants::new(family.at(&w));
        let value = |c| constants.tensor(c, Order::Adjoint, Suprema::Joint).unwrap();
        prop_assume!((1..=5).all(|c| value(c) > r(1, 10)));
        let mut cells: Vec<String> = (1..=5).map(|c| cut(&value(c), PLACES)).collect();
        let claimed = Constants::new(family.at(&r(1, 7)));
        // Where the first cells do not depend on w, or it has its assumed value, or a
        // cell has few digits, there is nothing to find.
        let differs = |c| claimed.tensor(c, Order::Adjoint, Suprema::Joint).unwrap() != value(c);
        prop_assume!((1..=5).filter(|&c| differs(c)).count() > 3);
        prop_assume!(cells.iter().all(|cell| !cell.ends_with('0')));
        if let Some(at) = at {
            let point = cells[at].find('.').unwrap();
            let digit = cells[at].as_bytes()[point + 4] - b'0';
            cells[at].replace_range(point + 4..point + 5, &((digit + up) % 10).to_string());
        }
        let columns = "'1', '2', '3', '4', '5'";
        let paper = family.paper("tensor(c)", "unstated = ['w']", columns, &cells);
        let audit = judged(&paper);
        let search = audit.tables[0].search.as_ref().expect("a search");
        let best = search.best.first().expect("a reading");
        prop_assert!(best.count() >= 4 + usize::from(at.is_none()), "{:?}", says(search));
        // Other values may do as well; this one is among those that do, or a simpler one is shown.
        let recovered = &audit.tables[0].recovered["w"];
        let (low, high) = between(recovered);
        let simpler = recovered.value.denominator() <= w.denominator();
        prop_assert!(*low <= w && w <= *high || simpler, "{:?}", recovered);
        // A reading that explains the other cells as well may have another value in this
        // one, of which the printed one is no slip.
        if let (Some(at), [only], 4) = (at, &search.best[..], best.count()) {
            let finding = &audit.tables[0].cells[0][at];
            let level = u32::try_from(at + 1).unwrap();
            if only.values[0][at] == Some(value(level).into()) && !only.explained[0][at] {
                let verdict = finding.verdict_if_assumed.as_ref().unwrap();
                let slip = matches!(verdict, Verdict::Misprint(Slip::Digit { .. }));
                prop_assert!(slip, "{:?}", verdict);
            }
        }
    }

}

proptest! {
    // A table of twenty depths has many readings, and takes as long as ten others.
    #![proptest_config(crate::common::cases(10))]

    /// Depths computed with a hidden spread: the interval found holds it, or another reading gives
    /// them at a plainer value.
    #[test]
    fn a_hidden_spread_is_found(mask in mask(), p in 1_i64..10, q in 1_i64..10) {
        let constants = Constants::new(mask.clone());
        let spread = r(p, q);
        let sigma = displacement(&mask, Terms::Each);
        let t = constants.norm(Operator::Difference, 2, Order::Adjoint).unwrap();
        prop_assume!(t < Rational::one() && !sigma.is_zero());
        let columns: Vec<String> = (1..=20).map(|i| format!("'1e-{i}'")).collect();
        let depth = |i: i32| {
            let epsilon = Rational::power_of_ten(-i);
            let x = epsilon * (Rational::one() - &t) / (&sigma * &spread);
            log_level(&t, &x, Rounded::Up).unwrap().to_string()
        };
        let cells: Vec<String> = (1..=20).map(depth).collect();
        let paper = paper(
            &mask,
            "levels(contraction(2), c*(1 - contraction(2))/(displacement()*tau), rounded = up)",
            "unstated = ['tau']\npromise = { tolerance = \"c\", spread = \"tau\" }",
            &columns.join(", "),
            &cells,
        );
        let audit = judged(&paper);
        let search = audit.tables[0].search.as_ref().expect("a search");
        let best = search.best.first().expect("a reading");
        prop_assert_eq!(best.count(), 20, "{:?}", says(search));
        let recovered = &audit.tables[0].recovered["tau"];
        let (low, high) = between(recovered);
        // Another reading may give all of them at a plainer value.
        let plainer = recovered.value.denominator() < spread.denominator();
        prop_assert!(*low <= spread && spread <= *high || plainer, "{:?}", recovered);
        let reproduced = |cell: &CellFinding| cell.verdict == Verdict::Reproduced;
        prop_assert!(audit.tables[0].cells.iter().flatten().all(reproduced));
    }

}

proptest! {
    #![proptest_config(crate::common::cases(30))]

    /// Random digits are explained by nothing, whatever the parameter.
    #[test]
    fn random_digits_have_no_parameter(
        family in family(), digits in prop::collection::vec(100_000_i64..1_000_000, 5),
    ) {
        let cells: Vec<String> = digits.iter().map(|digits| format!("0.{digits}")).collect();
        let columns = "'1', '2', '3', '4', '5'";
        let paper = family.paper("tensor(c)", "unstated = ['w']", columns, &cells);
        prop_assert!(nothing_is_recovered(&judged(&paper)));
    }

    /// Random digits are explained by nothing.
    #[test]
    fn random_digits_are_not_explained(
        mask in mask(), digits in prop::collection::vec(100_i64..1000, 5),
    ) {
        let cells: Vec<String> = digits.iter().map(|digits| format!("0.{digits}")).collect();
        let value = "displacement(terms = total, offset = 0)*tensor(c, order = forward)*beta";
        let columns = "'1', '2', '3', '4', '5'";
        let assumed = paper(&mask, value, "unstated = { beta = '1/10' }", columns, &cells);
        let search = judged(&assumed).tables[0].search.clone().expect("a search");
        prop_assert!(search.tried > 20 && search.best.is_empty(), "{:?}", says(&search));
        let open = paper(&mask, value, "unstated = ['beta']", columns, &cells);
        prop_assert!(nothing_is_recovered(&judged(&open)));
    }
}

/// The values of a parameter that the numbers of its table fit.
fn between(recovered: &Recovered) -> (&Rational, &Rational) {
    match &recovered.from {
        RecoveredFrom::Solved(low, high) => (low, high),
        other => panic!("{other:?}"),
    }
}

fn nothing_is_recovered(audit: &PaperAudit<'_>) -> bool {
    let table = &audit.tables[0];
    let missing = |cell: &CellFinding| matches!(cell.verdict, Verdict::NotCheckable(_));
    table.recovered.is_empty() && table.cells.iter().flatten().all(missing)
}

/// A table of a·w, a = 0, 1, 2, 3, where w = 0.12345 is stated, with an alternative.
fn multiples(alternative: &str, cells: &[String]) -> Search {
    multiples_at("0.12345", alternative, cells)
}

/// The text of the paper with that table.
fn with_alternative(w: &str, alternative: &str, cells: &[String]) -> String {
    format!(
        "key = 'k'\n[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n[define]\n\
         y = 'a*w'\n[[alternative]]\nof = 'y'\nlabel = 'b'\nvalue = '{alternative}'\n[[table]]\n\
         id = 't'\nlocus = ''\nvalue = 'y'\ngiven = {{ w = '{w}' }}\n\
         columns = {{ name = 'a', values = ['0', '1', '2', '3'] }}\ncells = [['{}']]\n",
        cells.join("', '")
    )
}

/// The same for any w.
fn multiples_at(w: &str, alternative: &str, cells: &[String]) -> Search {
    let text = with_alternative(w, alternative, cells);
    let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
    judged(&paper).tables[0].search.clone().expect("a search")
}

/// What the printed text gives anyway is no sign of another reading, nor is what is printed as 0.
#[test]
fn luck_counts_what_is_new() {
    for (last, found) in [("0.9", false), ("0.901234567", true)] {
        let other = format!("a*w + a*(a - 1)*(a - 2)/6*({last} - 3*w)");
        let cells = ["0.0", "0.12345", "0.2469", last].map(str::to_owned);
        let search = multiples(&other, &cells);
        assert_eq!((search.as_printed, search.most), (3, 4));
        assert_eq!(!search.best.is_empty(), found, "{last}");
    }
    for (last, found) in [("0.901", false), ("0.901234567", true)] {
        let cells = ["0.0", "0.00", "0.00", last].map(str::to_owned);
        let search = multiples(&format!("a*(a - 1)*(a - 2)/6*{last}"), &cells);
        assert_eq!((search.as_printed, search.most), (1, 4));
        assert_eq!(!search.best.is_empty(), found, "{last}");
    }
}

/// Which of a·s, a = 0, 1, 2, 3, become these decimals when they are rounded to the nearest, cut,
/// or rounded away from zero; with those whose rounding reaches to 0.
fn given(s: &Rational, cells: &[String; 4], way: usize) -> Vec<bool> {
    let reaches = |(a, cell): (i64, &String)| {
        let decimals = cell.split_once('.').map_or("", |(_, digits)| digits);
        let unit = decimals.bytes().fold(r(1, 1), |unit, _| &unit * &r(1, 10));
        let shown = &unit * &Rational::from(cell.replace('.', "").parse::<i64>().expect("digits"));
        let value = s * &Rational::from(a);
        let (off, side) = ((&value - &shown).abs(), (value.abs() - shown.abs()).sign());
        let (given, low) = match way {
            0 => (&off + &off <= unit, &shown.abs() - &(&unit / &Rational::from(2))),
            1 => (off < unit && side >= 0, shown.abs()),
            _ => (off < unit && side <= 0, shown.abs() - &unit),
        };
        given.then_some(low.sign() <= 0)
    };
    (0..).zip(cells).filter_map(reaches).collect()
}

/// The p/q, p, q = 1, …, 100, that give a cell whose rounding does not reach to 0 are all tried.
#[test]
fn every_simple_scale_is_looked_at() {
    for cells in [
        ["0.0", "0.43", "0.9", "1.28571"],
        ["0.0", "-0.43", "0.86", "1.3"],
        ["0.1", "0.4", "0.98", "1.4"],
        ["0.00", "0.0", "0.003", "-7"],
        ["0.5", "0.00", "0.0", "0.0"],
        ["0", "77.77", "1.3", "9.9"],
    ] {
        let cells = cells.map(str::to_owned);
        let simple = (1..=100).flat_map(|p| (1..=100).map(move |q| r(p, q)));
        let ways = simple.flat_map(|s| (0..3).map(move |way| (s.clone(), way)));
        let given_at = |(s, way): (Rational, usize)| given(&s, &cells, way);
        let scaled = ways.map(given_at).filter(|given| given.contains(&false));
        let stated = (0..3).map(|way| given_at((r(12_345, 100_000), way)));
        let most = scaled.chain(stated).map(|given| given.len()).max();
        assert_eq!(Some(multiples("a*w", &cells).most), most, "{cells:?}");
    }
}

/// A reading that is not proportional to the scale is not scaled.
#[test]
fn only_proportional_readings_are_scaled() {
    // (a·w)² at w = 1/2, times 12/7: not what it is at w = 6/7. At 3/7 the printed text gives two.
    let cells = ["0.0", "0.428571", "1.714286", "3.857143"].map(str::to_owned);
    assert_eq!(multiples_at("1/2", "a*a*w^2", &cells).most, 2);
    assert_eq!(multiples_at("1/2", "a*a*w", &cells).most, 4);
}

/// How many numbers are looked at as scales.
#[test]
fn simple_scales_are_counted() {
    let cells = ["0.0", "0.43", "0.9", "1.28571"].map(str::to_owned);
    let gcd = |mut p: u32, mut q: u32| {
        while q > 0 {
            (p, q) = (q, p % q);
        }
        p
    };
    let pairs = (1..=100).flat_map(|p| (1..=100).map(move |q| (p, q)));
    let simple = pairs.filter(|(p, q)| gcd(*p, *q) == 1).count();
    // Two readings with three roundings of decimals, at these scales and as stated.
    assert_eq!(multiples("a*a*w", &cells).tried, 6 * (simple + 1));
}

/// A power that is twice as much at 2k is not proportional to k.
#[test]
fn powers_have_no_scale() {
    let text = |value: &str| {
        format!(
            "key = 'k'\n[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n[[table]]\n\
             id = 't'\nlocus = ''\nvalue = '{value}'\ngiven = {{ k = '1' }}\n\
             columns = {{ name = 'a', values = ['1', '2', '3'] }}\n\
             cells = [['1.428571428571', '2.857142857143', '4.285714285714']]\n",
        )
    };
    for (value, found) in [("a*k", true), ("a*2^k", false)] {
        let paper = read_paper(&SourceText::new("k.toml", text(value))).expect("a claim file");
        let search = judged(&paper).tables[0].search.clone().expect("a search");
        assert_eq!(!search.best.is_empty(), found, "{value}");
    }
}

/// The tables of the founding papers that a reading explains whole.
#[test]
fn tables_of_the_papers() {
    let table_of = |key: &str, table: &str| {
        audit_of(key).tables.iter().find(|finding| finding.table.id == table).unwrap()
    };
    let explained = |id: &str| {
        let (key, table) = id.split_once(':').unwrap();
        let finding = table_of(key, table);
        let search = finding.search.clone().expect("a search");
        (search.best[0].count(), search.cells, says(&search).remove(0))
    };
    let whole = |count: usize, differences: &[&str]| {
        (count, count, differences.iter().map(|&says| says.to_owned()).collect::<Vec<String>>())
    };
    let nearest = "depths rounded to the nearest";
    assert_eq!(
        explained("khan2019-newton:table-1"),
        whole(18, &["Σ|b| in the contraction constant", "decimals cut"])
    );
    let joint = "one supremum over a common index";
    assert_eq!(explained("mustafa2020-nary:table-3"), whole(4, &[joint]));
    let solved = |table: &str| {
        let finding = table_of("mustafa2020-nary", table);
        let recovered = finding.recovered.values().map(|one| one.value.clone());
        recovered.collect::<Vec<_>>()
    };
    assert_eq!(solved("table-1"), [r(39, 2000)]);
    assert_eq!(solved("table-3"), [r(3, 400)]);
    assert_eq!(solved("table-11"), [r(6, 5)]);
    // μ and τ, ξ and w in the order of their names.
    assert_eq!(solved("table-10"), [r(0, 1), r(1, 10)]);
    assert_eq!(solved("table-4"), [r(3, 400), r(1, 10)]);
    assert_eq!(explained("mustafa2020-nary:table-6"), whole(28, &[nearest]));
    assert_eq!(explained("mustafa2020-nary:table-15"), whole(4, &["masks read forwards"]));
    assert_eq!(
        explained("mustafa2020-nary:table-16"),
        whole(28, &["masks read forwards", nearest])
    );
}

/// Names, words and sentences of the family tell its choices apart.
#[test]
fn the_family_is_told_apart() {
    let mut names: Vec<&str> = FAMILY.iter().map(|choice| choice.name).collect();
    let mut says: Vec<&str> =
        FAMILY.iter().flat_map(|choice| choice.ways.iter().map(|way| way.says)).collect();
    for list in [&mut names, &mut says] {
        let count = list.len();
        list.sort_unstable();
        list.dedup();
        assert_eq!(list.len(), count);
    }
    assert!(FAMILY.iter().all(|choice| choice.ways.len() > 1 && !choice.source.is_empty()));
}

/// A right table of the 4-point scheme, whose offset -1 is forgotten.
#[test]
fn a_forgotten_offset_is_said_and_comes_before_another_scale() {
    let scheme = parse_scheme("four-point").unwrap();
    let own = scheme.masks()[0];
    let (sigma, mask) = (displacement(own, Terms::Each), own.with_offset(0));
    let delta = Constants::new(own.clone()).norm(Operator::Difference, 1, Order::Adjoint).unwrap();
    let bound = |k: i32| &sigma * r(1, 10) * delta.pow(k) / (Rational::one() - &delta);
    let cells: Vec<String> = (1..6).map(|k| fixed(&bound(k), 6)).collect();
    let value = "displacement()*beta*contraction(1)^c/(1 - contraction(1))";
    let rest = "given = { beta = '1/10' }\npromise = { level = 'c', spread = 'beta' }";
    let paper = paper(&mask, value, rest, "'1', '2', '3', '4', '5'", &cells);
    let audit = judged(&paper);
    let [UnstatedOffset { better, .. }] = &audit.unstated_offsets[..] else { panic!("one scheme") };
    assert_eq!((better.offset, &better.least, &better.at_zero), (-1, &r(1, 8), &r(9, 8)));
    let search = audit.tables[0].search.as_ref().unwrap();
    // β = 1/90 explains as much.
    assert_eq!(says(search), [["displacement at the scheme's best offset"]]);
    let text = certificate(&audit).text;
    let report = check(&paper.source.text, &[&text]).unwrap();
    assert!(report.claims.iter().all(|(_, _, outcome)| *outcome == Outcome::Valid), "{text}");
    // With the offset nothing is to be said.
    let stated = paper.source.text.replace("name = 's'\n", "name = 's'\noffset = '-1'\n");
    let stated = read_paper(&SourceText::new("k.toml", stated)).unwrap();
    let audit = judged(&stated);
    assert!(audit.unstated_offsets.is_empty() && audit.tables[0].search.is_none());
}

/// A reading whose values are beyond a cap leaves a number open that no other reading gives, but not a number where it
/// has a value while it cannot explain more than the printed text.
#[test]
fn a_reading_beyond_a_cap_leaves_numbers_open() {
    let cells = |cells: [&str; 4]| cells.map(str::to_owned);
    let verdicts = |alternative: &str, cells: [String; 4]| {
        let text = with_alternative("0.12345", alternative, &cells);
        let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
        let audit = judged(&paper);
        let row = audit.tables[0].cells[0].iter().map(|cell| cell.verdict.clone());
        let certified = certificate(&audit).text.contains("\ntable t");
        (row.collect::<Vec<_>>(), certified)
    };
    let open = |verdict: &Verdict| {
        matches!(verdict, Verdict::NotCheckable(Missing::Capacity(_) | Missing::Reading(_)))
    };
    let (all, certified) = verdicts("2^(10^9*(a + 1))", cells(["1", "2", "3", "4"]));
    assert!(all.iter().all(open) && !certified, "{all:?}");
    // Three cells are as printed, and the alternative may explain one.
    let (row, _) = verdicts("2^(10^9*(3 - a))*0", cells(["0", "0.12345", "0.2469", "0.9"]));
    assert_eq!(row[3], Verdict::Refuted);
    let (row, _) = verdicts("2^(10^9*a)*0", cells(["0", "0.12345", "0.2469", "0.9"]));
    assert!(open(&row[3]), "{row:?}");
}

/// An alternative that is wrong is an error at its place, and no reading without values.
#[test]
fn a_wrong_alternative_is_an_error() {
    let cells = ["1", "2", "3", "4"].map(str::to_owned);
    let text = with_alternative("0.12345", "twice(a)", &cells);
    let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
    let error = audit(&paper).expect_err("an unknown function").to_string();
    assert!(error.contains("unknown function `twice`"), "{error}");
}

/// Where there are more readings than 4096, or more than 100,000 values under them, those with fewer differences are
/// compared, and the checker has the same family. Of d definitions with a alternatives each there are (a + 1)^d.
#[test]
fn large_families_have_fewer_differences() {
    for (definitions, alternatives, columns, most) in [(4, 7, 3, 4), (4, 8, 3, 3), (2, 20, 250, 1)]
    {
        for changed in (most..=definitions).take(2) {
            let list = |of: &dyn Fn(usize) -> String, last: usize| {
                (1..=last).map(of).collect::<Vec<String>>()
            };
            let definition = |i: usize| {
                let other = |value: usize| {
                    format!(
                        "[[alternative]]\nof = 'a_{i}'\nlabel = 'a_{i} = {value}'\nvalue = '{}'\n",
                        value + 1
                    )
                };
                list(&other, alternatives).concat()
            };
            let cell = |x: usize| {
                let term = |i: usize| {
                    let factor = if i <= changed { i + 1 } else { 1 };
                    i64::try_from(factor).expect("small")
                        * i64::try_from(x.pow(u32::try_from(i).expect("small"))).expect("small")
                };
                format!(
                    "'{}'",
                    fixed(&Rational::new((1..=definitions).map(term).sum::<i64>(), 7), 4)
                )
            };
            let text = format!(
                "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n[define]\n{}{}\
                 [[table]]\nid = 't'\nlocus = 'T'\nvalue = '({})/7'\n\
                 columns = {{ name = 'x', values = [{}] }}\ncells = [[{}]]\n",
                list(&|i| format!("a_{i} = '1'\n"), definitions).concat(),
                list(&definition, definitions).concat(),
                list(&|i| format!("a_{i}*x^{i}"), definitions).join(" + "),
                list(&|x| format!("'{x}'"), columns).join(", "),
                list(&cell, columns).join(", "),
            );
            let paper = read_paper(&SourceText::new("k.toml", text.clone()))
                .unwrap_or_else(|error| panic!("{error}"));
            let audit = judged(&paper);
            let search = audit.tables[0].search.as_ref().expect("a search");
            assert_eq!(search.max_differences, most);
            let all = search.best.first().is_some_and(|best| best.count() == columns);
            assert_eq!(all, changed == most, "{definitions} {changed}");
            let report = check(&text, &[&certificate(&audit).text]).expect("a claim file");
            assert!(matches!(report.claims[..], [(_, _, Outcome::Valid)]), "{:?}", report.claims);
        }
    }
}
