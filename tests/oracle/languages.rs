//! Reference values for other languages: tables without header lines, and functions of MATLAB.
//! `.ci/languages.py` runs them in Octave.

use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::oracle::{
    Boundary, Control, OracleRequest, OracleValues, matlab_name, reference_values, to_matlab,
    to_table,
};
use subcert::scheme::parse_scheme;

fn values_of(scheme: &str, control: Control) -> OracleValues {
    let (max_block, level, boundary) = (3, 2, Boundary::Closed);
    let request = OracleRequest { scheme: scheme.to_owned(), max_block, control, level, boundary };
    reference_values(&parse_scheme(scheme).expect("a scheme"), &request).expect("values")
}

/// Three points of the plane.
fn triangle() -> Control {
    let coordinates = [["0", "1", "5/2"], ["1/3", "-1/7", "3"]];
    let number = |text: &str| subcert::exact::parse_rational(text).expect("a number");
    Control::points(coordinates.map(|row| row.map(number).to_vec()).to_vec())
}

/// The rows of an array of a MATLAB file, its entries as text.
fn array(file: &str, name: &str) -> Vec<Vec<String>> {
    let head = format!("  values.{name} = ");
    let lines = file.lines().skip_while(|line| !line.starts_with(&head)).skip(1);
    let rows = lines.take_while(|line| line.starts_with("    "));
    rows.map(|row| row.split_whitespace().map(str::to_owned).collect()).collect()
}

#[test]
fn tables_have_numbers_in_their_columns() {
    let values = values_of("four-point:w=1/17", triangle());
    let text = to_table(&values);
    let mut rows = text.lines().skip(1).map(|line| line.split(',').collect::<Vec<&str>>());
    for group in &values.groups {
        for value in &group.values {
            let row = rows.next().expect("a row for each value");
            assert_eq!(row.len(), 6);
            assert_eq!(row[0], group.quantity);
            for (at, field) in row[1..3].iter().enumerate() {
                assert_eq!(field.parse().ok(), value.index.get(at).copied());
            }
            assert_eq!([row[3], row[4], row[5]], [&value.f64, &value.exact, &value.hex]);
            assert!(row[3].parse::<f64>().is_ok());
        }
    }
    assert!(rows.next().is_none());
}

#[test]
fn points_are_rows_in_matlab() {
    let values = values_of("four-point:w=1/17", triangle());
    let file = to_matlab(&values);
    assert!(file.starts_with("function values = oracle_four_point_w_1_17(refine, ulps)\n"));
    for (name, count) in [("control", 3), ("refined", 12)] {
        let rows = array(&file, name);
        assert_eq!(rows.len(), count);
        for (column, number) in ["1", "2"].iter().enumerate() {
            let group = values.group(&format!("{name}-{number}")).expect("a coordinate");
            let expected: Vec<&str> = group.values.iter().map(|value| value.f64.as_str()).collect();
            let found: Vec<&str> = rows.iter().map(|row| row[column].as_str()).collect();
            assert_eq!(found, expected);
        }
    }
    let exact = values.group("refined-2").expect("a coordinate").values[0].exact.clone();
    assert_eq!(array(&file, "refined_exact")[0][1], format!("'{exact}'"));
    assert_eq!(array(&file, "mask").len(), 2);
    assert_eq!(array(&file, "displacement").concat().len(), 1);
}

#[test]
fn nets_are_matrices_in_matlab() {
    let net = Control::grid((1..=6).map(Rational::from).collect(), 3).expect("a net");
    let file = to_matlab(&values_of("chaikin x chaikin", net));
    assert_eq!(array(&file, "control"), [["1.0", "2.0", "3.0"], ["4.0", "5.0", "6.0"]]);
    let refined = array(&file, "refined");
    assert_eq!((refined.len(), refined[0].len()), (8, 12));
}

proptest! {
    #[test]
    fn names_are_names(scheme in "\\PC*") {
        let name = matlab_name(&scheme);
        prop_assert!(name.starts_with("oracle") && name.len() <= 63);
        prop_assert!(name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_'));
    }
}

/// Whatever a scheme is called, the lines of the help stay comments.
#[test]
fn the_help_is_a_comment() {
    let mut values = values_of("chaikin", triangle());
    values.header.scheme = "chaikin\nerror('now')\r\u{85}error".to_owned();
    let file = to_matlab(&values);
    let lines: Vec<&str> = file.lines().skip(1).collect();
    let help = lines.iter().take_while(|line| line.starts_with('%')).count();
    assert!(lines[help].starts_with("  values.mask = ["), "{}", lines[help]);
}
