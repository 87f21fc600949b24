//! Which readings give a cell by luck.

use crate::common::claims::{judged, paper};
use proptest::prelude::*;
use subcert::audit::{CellKind, Search, Verdict, readings};
use subcert::certificate::certificate;
use subcert::exact::{Integer, Rational};
use subcert_check::{Outcome, check};

/// Two tables: of decimals with the digits M, luck gives 1 in 2M each, where M has no factors 5, and of depths 1 in 4,
/// of 2 levels 1 in 2.
#[test]
fn luck_is_what_unrelated_numbers_would_give() {
    let paper = paper(
        "[define]\nT = 'contraction(c)'\nd = 'levels(T, epsilon, c)'\n\
         [[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'four-point'\nvalue = 'T'\n\
         columns = { name = 'c', values = ['1', '2', '3', '4', '5', '6'] }\n\
         cells = [['0.625', '0.375', '0.227', '0.137', '0.7', '0.9']]\n\
         [[table]]\nid = 'b'\nlocus = 'B'\nscheme = 'four-point'\nvalue = 'd'\n\
         promise = { tolerance = 'epsilon', spread = '1' }\n\
         rows = { name = 'c', values = ['1', '2'] }\n\
         columns = { name = 'epsilon', values = ['0.1', '0.01', '0.001', '0.0001', '0.00001'] }\n\
         cells = [['5', '10', '14', '19', '21'], ['2', '4', '6', '8', '9']]\n",
    );
    let audit = judged(&paper);
    // The expected number of other cells that luck gives: of the decimals at most 1/2 + 1/6 + 1/14 + 1/18 + 2/274,
    // less than one; of the depths 9/4 to 10/4, more than two and less than three.
    for (finding, most) in audit.tables.iter().zip([0, 2]) {
        let readings = readings(&paper, finding, CellKind::Plain).expect("no error");
        let mut seen = [0; 2];
        for reading in &readings {
            // None is the best of its table, which is no luck.
            assert!(finding.searches().all(|search| search.best.is_empty()));
            for (row, explained) in reading.explained.iter().enumerate() {
                for (column, here) in explained.iter().enumerate() {
                    let lucky = *here && reading.count() - 1 <= most;
                    assert_eq!(finding.is_by_luck(reading, (row, column)), lucky);
                    seen[usize::from(lucky)] += usize::from(*here);
                }
            }
        }
        assert!(seen.iter().all(|count| *count > 0), "{}: {seen:?}", finding.table.id);
    }
}

/// The first of four rows of depths is that of the mask read forwards, T_2 = 3/8, and the others are as
/// printed: what the row's reading explains is less than luck gives in the whole table, 71/4, but it
/// is the reading of the row.
#[test]
fn the_reading_of_a_row_is_no_luck() {
    let epsilon = (1..=18).map(|i| format!("'3e-{i}'")).collect::<Vec<String>>().join(", ");
    // The least k with T^k ≤ ε.
    let row = |t: f64| {
        let level = |i: i32| format!("'{}'", ((3.0 * 10f64.powi(-i)).ln() / t.ln()).ceil());
        format!("[{}]", (1..=18).map(level).collect::<Vec<String>>().join(", "))
    };
    let rows = [3.0 / 8.0, 85.0 / 512.0, 0.083_251_953_125, 0.041_656_494_14].map(row);
    let text = format!(
        "[[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'four-point'\n\
         value = 'levels(contraction(c), epsilon)'\n\
         promise = {{ tolerance = 'epsilon', spread = '1' }}\n\
         rows = {{ name = 'c', values = ['2', '3', '4', '5'] }}\n\
         columns = {{ name = 'epsilon', values = [{epsilon}] }}\ncells = [{}]\n",
        rows.join(", ")
    );
    let paper = paper(&text);
    let audit = judged(&paper);
    let finding = &audit.tables[0];
    let lines: Vec<_> = finding.searches().flat_map(|search| &search.lines).collect();
    assert_eq!(lines.len(), 1);
    let best = &lines[0].best;
    assert!((9..=18).contains(&best.count()) && best.differs() == "masks read forwards");
    // Luck gives 1 in 4 of the other 71 cells, which is no less than what it explains of them.
    assert!(4 * (best.count() - 1) <= 71);
    for column in 0..18 {
        assert!(!finding.is_by_luck(best, (0, column)));
    }
}

/// Where there are no other numbers, nothing says that a reading explains too few of them.
#[test]
fn the_only_number_is_no_luck() {
    let paper = paper(
        "[[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'four-point'\nvalue = 'contraction(c)'\n\
         columns = { name = 'c', values = ['2'] }\ncells = [['0.375']]\n",
    );
    let audit = judged(&paper);
    let finding = &audit.tables[0];
    assert!(finding.searches().all(|search| search.best.is_empty()));
    let readings = readings(&paper, finding, CellKind::Plain).expect("no error");
    let mut explaining = readings.iter().filter(|reading| reading.explained[0][0]).peekable();
    assert!(explaining.peek().is_some());
    assert!(explaining.all(|reading| !finding.is_by_luck(reading, (0, 0))));
}

/// A table of d(n) = n² + 5000, whose alternative is n, for these n.
fn identity(n: &[String], cells: &[String]) -> String {
    alternative("n*n + 5000", n, cells)
}

/// A table of d(n), given by this formula, whose alternative is n, for these n.
fn alternative(formula: &str, n: &[String], cells: &[String]) -> String {
    let list = |all: &[String]| format!("'{}'", all.join("', '"));
    format!(
        "[define]\nd = '{formula}'\n[[alternative]]\nof = 'd'\nlabel = 'other'\nvalue = 'n'\n\
         [[table]]\nid = 't'\nlocus = 'T'\nvalue = 'd'\n\
         columns = {{ name = 'n', values = [{}] }}\ncells = [[{}]]\n",
        list(n),
        list(cells)
    )
}

/// What the search in the only table of a claim file says, after the checker has certified the
/// verdicts.
fn searched<T>(claims: &str, of: impl Fn(&Search, &[Verdict]) -> T) -> T {
    let paper = paper(claims);
    let audit = judged(&paper);
    let text = certificate(&audit).text;
    let report = check(&paper.source.text, &[&text]).expect("a claim file");
    assert!(report.claims.iter().all(|(_, _, outcome)| matches!(outcome, Outcome::Valid)));
    let table = audit.tables.last().expect("a table");
    let verdicts: Vec<Verdict> =
        table.cells.iter().flatten().map(|cell| cell.verdict.clone()).collect();
    of(table.searches().next().expect("a search"), &verdicts)
}

/// Of the numbers that unrelated values give, the sum of the probabilities that `m` cells or more
/// are given, if equal numbers are given together or not at all.
fn together(numbers: &[(u64, usize)], m: usize) -> Rational {
    let of_choice = |choice: u32| {
        let (mut product, mut cells) = (Rational::one(), 0);
        for (place, (digits, size)) in numbers.iter().enumerate() {
            let p = Rational::new(1, Integer::from(2 * digits));
            let given = choice >> place & 1 == 1;
            product *= if given { p } else { Rational::one() - p };
            cells += if given { *size } else { 0 };
        }
        if cells >= m { product } else { Rational::zero() }
    };
    (0..1 << numbers.len()).map(of_choice).fold(Rational::zero(), |all, one| all + one)
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    /// What is told of luck is an upper bound, also where equal numbers are given together; it is
    /// sharp where all cells are given; and the checker agrees on every verdict.
    #[test]
    fn equal_numbers_are_one_piece_of_evidence(
        numbers in prop::collection::btree_map(11_u64..99, 1_usize..4, 1..6),
        left in 0_usize..4,
    ) {
        let cells: Vec<String> =
            numbers.iter().flat_map(|(digits, size)| vec![digits.to_string(); *size]).collect();
        let mut merged = std::collections::BTreeMap::new();
        for (digits, size) in numbers {
            let part = [10, 5, 5].iter().fold(digits, |rest, factor| {
                if rest % factor == 0 { rest / factor } else { rest }
            });
            *merged.entry(part).or_insert(0) += size;
        }
        let numbers: Vec<(u64, usize)> = merged.into_iter().collect();
        let m = cells.len().saturating_sub(left);
        // The values of the cells that the alternative does not give are far away.
        let n: Vec<String> = cells.iter().enumerate()
            .map(|(at, cell)| if at < m { cell.clone() } else { "1000".to_owned() })
            .collect();
        // No constant connects 2ⁿ with what is printed in cells of several n.
        let (chance, tried, found) = searched(&alternative("2^n", &n, &cells), |search, _| {
            (search.chance.clone(), search.tried, !search.best.is_empty())
        });
        let exact = together(&numbers, m) * Rational::from(2 * tried);
        prop_assert!(exact <= chance, "{exact} > {chance}");
        if left == 0 {
            // It is rounded to one digit above 1/10.
            prop_assert!(chance <= exact * Rational::new(11, 10) || chance >= Rational::new(1, 10));
        }
        let largest = numbers.iter().map(|(_, size)| *size).max().unwrap_or(0);
        let several = numbers.len() < 2 || m > largest;
        prop_assert_eq!(found, m > 0 && several && chance <= Rational::new(1, 1_000));
    }
}

/// Cells that are all printed «1» explain nothing, however many they are.
#[test]
fn a_table_of_ones_says_nothing() {
    for count in [8, 12] {
        let levels: Vec<String> = (1..=count).map(|c| c.to_string()).collect();
        let claims = format!(
            "[define]\nT = 'contraction(c)'\n[[scheme]]\nname = 'first'\n\
             use = 'four-point-derivative:w=1/16'\n[[scheme]]\nname = 'second'\noffset = '-1'\n\
             mask = [['-1/4', '6/4', '-1/4'], ['2/4', '2/4', '0']]\n[[table]]\nid = 'u'\n\
             locus = 'U'\nscheme = 'first'\nvalue = 'T'\n\
             columns = {{ name = 'c', values = ['1', '2'] }}\ncells = [['1', '0.75']]\n\
             [[table]]\nid = 't'\nlocus = 'T'\nscheme = 'second'\nvalue = 'T'\n\
             columns = {{ name = 'c', values = ['{}'] }}\ncells = [['{}']]\n",
            levels.join("', '"),
            vec!["1"; count].join("', '")
        );
        searched(&claims, |search, verdicts| {
            assert!(search.best.is_empty() && search.lines.is_empty());
            assert!(verdicts.iter().all(|verdict| *verdict == Verdict::Refuted));
        });
    }
}

/// Values rounded away from zero: a value below half a unit is no unit.
#[test]
fn nobody_rounds_a_sixteenth_to_one() {
    let cells = ["1.235", "2.346", "3.457", "1", "1"].map(str::to_owned);
    let n = ["1.23401", "2.34501", "3.45601", "1/16", "1/2"].map(str::to_owned);
    searched(&identity(&n, &cells), |search, verdicts| {
        assert_eq!(search.best[0].differs(), "other; decimals rounded away from zero");
        assert_eq!(search.best[0].explained[0], [true, true, true, false, true]);
        assert_eq!(verdicts[3], Verdict::Refuted);
    });
}

/// The count takes a time that is linear in the cells.
#[test]
fn luck_is_counted_quickly() {
    let n: Vec<String> = (1..=2_000).map(|i| format!("{i}/7")).collect();
    let cells: Vec<String> = (1..=2_000).map(|i| format!("{:.9}", f64::from(i) / 7.0)).collect();
    searched(&identity(&n, &cells), |search, _| {
        assert_eq!((search.most, search.cells), (2_000, 2_000));
        assert!(search.chance > Rational::zero());
    });
}

/// Numbers that differ by powers of ten alone are one, as a header that scales makes them from one, however they are
/// written; binary and unit fractions are simple values.
#[test]
fn simple_numbers_are_one_number() {
    let of = |number: fn(u32) -> String| (0..12).map(number).collect::<Vec<String>>();
    for cells in [
        of(|i| format!("37e{}", i64::from(i) - 9)),
        of(|i| format!("{}/{}", 37 * 10_u64.pow(i), 10_u64.pow(12))),
        of(|i| format!("{}", 3.0 / f64::from(1 << i))),
        of(|i| format!("{}/{}", 3_000_000, 1_000_000 << i)),
        of(|i| format!("{}/{}", 123_456_789, 370_370_367_u64 * 3_u64.pow(i))),
        of(|i| format!("{}/{}", 2_000_000, 1_000_000 * (i + 3))),
    ] {
        searched(&identity(&cells, &cells), |search, verdicts| {
            assert!(
                search.best.is_empty() && search.chance >= Rational::new(1, 1_000),
                "{cells:?}"
            );
            assert!(verdicts.iter().all(|verdict| *verdict == Verdict::Refuted));
        });
    }
}

/// A unit that is far above a value is no rounding of it, and no slip; one that is as far below it is not either.
#[test]
fn a_power_of_ten_is_no_rounding_of_a_small_value() {
    let cells = ["1e1000", "1e-1000", "1e4"].map(str::to_owned);
    let n = ["1", "1", "1"].map(str::to_owned);
    searched(&identity(&n, &cells), |_, verdicts| {
        assert!(verdicts[..2].iter().all(|verdict| *verdict == Verdict::Refuted));
        // 5001 is more than half of it.
        assert_eq!(verdicts[2], Verdict::Confirmed);
    });
}

/// A table of one row with this value, in which the parameters are given.
fn row(given: &str, value: &str, header: &str, columns: &[String], cells: &[String]) -> String {
    let list = |all: &[String]| format!("'{}'", all.join("', '"));
    format!(
        "[given]\n{given}\n[[scheme]]\nname = 's'\nuse = 'chaikin'\n[[table]]\nid = 't'\nlocus = 'T'\n\
         scheme = 's'\nvalue = '{value}'\ncolumns = {{ name = '{header}', values = [{}] }}\ncells = [[{}]]\n",
        list(columns),
        list(cells)
    )
}

/// Numbers that are a constant times the values of the printed text are one number, however many they are: a scale that
/// hits the constant by luck gives them all.
#[test]
fn a_constant_is_one_number() {
    // Three digits from the first that is not 0.
    let three = |x: f64| {
        let places =
            (0..20).find(|places| x * 10_f64.powi(*places) >= 100.0).expect("no small number");
        format!("{x:.*}", usize::try_from(places).expect("a number of places"))
    };
    for constant in [0.137, 0.219, 0.0883] {
        let levels: Vec<String> = (1..9).map(|k| k.to_string()).collect();
        let halves: Vec<String> = (1..9).map(|k| three(constant * 0.5_f64.powi(k))).collect();
        let places: Vec<String> = (1..9).map(|k| format!("{}.7", 2 * k)).collect();
        let times: Vec<String> =
            (1..9).map(|k| three(constant * (2.0 * f64::from(k) + 0.7))).collect();
        for claims in [
            row("T = '1'", "T*contraction(1)^c", "c", &levels, &halves),
            row("r = '1/10'", "r*x", "x", &places, &times),
        ] {
            searched(&claims, |search, verdicts| {
                assert!(search.most >= 3 && search.best.is_empty(), "{search:?}");
                assert!(verdicts.iter().all(|verdict| *verdict == Verdict::Refuted));
            });
        }
    }
    // With as many digits as no scale has by luck, it is an explanation.
    let cells: Vec<String> =
        (1..9).map(|k| format!("{:.13}", 10.0 / 73.0 * 0.5_f64.powi(k))).collect();
    let levels: Vec<String> = (1..9).map(|k| k.to_string()).collect();
    searched(&row("T = '1'", "T*contraction(1)^c", "c", &levels, &cells), |search, _| {
        assert_eq!(search.best[0].count(), 8);
    });
}
