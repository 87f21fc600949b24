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
