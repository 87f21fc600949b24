//! Which readings give a cell by luck.

use crate::common::claims::{judged, paper};
use subcert::audit::{CellKind, readings};

/// Two tables of eight numbers: of decimals with d digits, luck gives 1 in 9·10^(d−1) each, and of
/// depths 1 in 4.
#[test]
fn luck_is_what_unrelated_numbers_would_give() {
    let paper = paper(
        "[define]\nT = 'contraction(c)'\nd = 'levels(T, epsilon, c)'\n\
         [[table]]\nid = 'a'\nlocus = 'A'\nscheme = 'four-point'\nvalue = 'T'\n\
         columns = { name = 'c', values = ['1', '2', '3', '4', '5', '6'] }\n\
         cells = [['0.625', '0.375', '0.227', '0.137', '0.5', '0.7']]\n\
         [[table]]\nid = 'b'\nlocus = 'B'\nscheme = 'four-point'\nvalue = 'd'\n\
         promise = { tolerance = 'epsilon', spread = '1' }\n\
         rows = { name = 'c', values = ['1', '2'] }\n\
         columns = { name = 'epsilon', values = ['0.1', '0.01', '0.001', '0.0001', '0.00001'] }\n\
         cells = [['5', '10', '14', '19', '21'], ['2', '4', '6', '8', '9']]\n",
    );
    let audit = judged(&paper);
    // The expected number of other cells that luck gives: of the decimals at most 1/9 + 1/9 + 3/900,
    // less than one; of the depths 9/4, more than two and less than three.
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
