//! Reference values for other languages: tables without header lines, functions of MATLAB, arrays in C and Rust.
//! `.ci/languages.py` runs them in Octave, and compiles them.

use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::float::{exact as exact_value, parse_hexadecimal, ulp};
use subcert::mesh::{MeshScheme, PolygonMesh, limit_points, refine_mesh};
use subcert::oracle::{
    Boundary, Control, OracleRequest, OracleValues, matlab_name, mesh_to_source, reference_values,
    to_matlab, to_source, to_table,
};
use subcert::scheme::parse_scheme;
use subcert::spectrum::table::Language;

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

/// The numbers of an array in C or Rust, and what stands behind each row.
fn declared(text: &str, name: &str) -> (Vec<f64>, Vec<String>) {
    let mut lines = text.lines().skip_while(|line| {
        let words = line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        !line.ends_with(['[', '{', ';']) || !words.into_iter().any(|word| word == name)
    });
    let first = lines.next().unwrap_or_else(|| panic!("no {name} in {text}"));
    let (_, inline) = first.split_once('=').expect("a declaration");
    let lines = lines.take_while(|line| line.starts_with("    "));
    let (mut numbers, mut notes) = (Vec::new(), Vec::new());
    for line in std::iter::once(inline).chain(lines) {
        let (row, note) = line.split_once(" // ").unwrap_or((line, ""));
        let words = row.split(|c: char| c.is_whitespace() || "[]{},;".contains(c));
        let words = words.filter(|word| !word.is_empty());
        let number = |word: &str| {
            let decimal = || word.parse().expect("a number");
            parse_hexadecimal(word).ok().filter(|_| word.contains("0x")).unwrap_or_else(decimal)
        };
        numbers.extend(words.map(number));
        notes.extend((!note.is_empty()).then(|| note.to_owned()));
    }
    (numbers, notes)
}

#[test]
fn arrays_in_sources_are_nearest() {
    for values in [
        values_of("four-point:w=1/17", triangle()),
        values_of("chaikin", Control::seeded_polygon(3, 5)),
        values_of("chaikin x chaikin", Control::seeded_grid(3, 4, 3)),
    ] {
        let head = &matlab_name(&values.header.scheme);
        for language in [Language::C, Language::Rust] {
            let text = to_source(&values, language).expect("f64");
            let name = |name: &str| match language {
                Language::C => format!("{head}_{name}"),
                _ => name.to_uppercase(),
            };
            // Coordinates stand side by side.
            let points = values.group("refined-1").is_some();
            let columns = |quantity: &str| -> Vec<&subcert::oracle::Group> {
                let names = if points { &["-1", "-2"][..] } else { &[""] };
                let group = |end| values.group(&format!("{quantity}{end}")).expect("a group");
                names.iter().map(group).collect()
            };
            for quantity in ["control", "refined"] {
                let columns = columns(quantity);
                let (numbers, notes) = declared(&text, &name(quantity));
                let row = |at: usize| columns.iter().map(move |group| &group.values[at]);
                let all = (0..columns[0].values.len()).flat_map(row);
                let hex: Vec<f64> =
                    all.clone().map(|value| parse_hexadecimal(&value.hex).expect("hex")).collect();
                assert_eq!(numbers, hex, "{quantity} in {text}");
                let exact: Vec<&str> = all.map(|value| value.exact.as_str()).collect();
                assert_eq!(notes.join(", "), exact.join(", "));
            }
            let (numbers, _) = declared(&text, &name("refined"));
            let (units, _) = declared(&text, &name("refined_ulp"));
            assert_eq!(numbers.len(), units.len());
            for (x, unit) in numbers.iter().zip(units) {
                assert_eq!(exact_value(unit), ulp(*x), "of {x}");
            }
            assert!(text.contains("level = 2") || text.contains("LEVEL: usize = 2;"), "{text}");
        }
    }
}

#[test]
fn sources_of_meshes_have_what_goes_in_and_what_comes_out() {
    let points = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [1, 1, 5]];
    let points = points.map(|point| point.map(RealCyclotomic::from)).to_vec();
    let faces = vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]];
    let mesh = PolygonMesh::new(points, faces).expect("a mesh");
    let refined = refine_mesh(&mesh, MeshScheme::Loop, 1).expect("a level");
    let limits = limit_points(&refined, MeshScheme::Loop).expect("limits");
    let head = [("scheme", "loop".to_owned()), ("mesh", "a\nb.off\\".to_owned())];
    let both = [&mesh, &refined].map(Into::into);
    let text = mesh_to_source(&both, &limits, 1, &head, Language::C).expect("f64");
    let of = |name: &str| declared(&text, &format!("oracle_loop_a_b_off_{name}"));
    assert_eq!(of("control_points").0.len(), 12);
    assert_eq!(of("control_face_points").0, [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3].map(f64::from));
    assert_eq!(of("face_sizes").0, [3.0; 16]);
    for (at, limit) in limits.iter().enumerate() {
        let limit = limit.as_ref().expect("a limit");
        let (numbers, notes) = of("limits");
        assert_eq!(numbers[3 * at..][..3], limit.position.each_ref().map(subcert::float::nearest));
        assert_eq!(notes[at], limit.position.each_ref().map(ToString::to_string).join(", "));
        let unit = limit.normal.as_ref().expect("a normal").unit();
        assert_eq!(of("normals").0[3 * at..][..3], unit);
    }
    assert_eq!(of("points_ulp").0.len(), of("points").0.len());
    // What a path may hold ends no comment.
    assert!(text.contains("// mesh: a b.off\\ .\n"), "{text}");
}

/// Numbers beyond f64 have no literal.
#[test]
fn sources_hold_f64_only() {
    let far = subcert::exact::parse_rational("1e400").expect("a number");
    let values = values_of("chaikin", Control::polygon(vec![far, Rational::zero()]));
    let error = to_source(&values, Language::C).expect_err("beyond f64");
    assert!(error.to_string().contains("only JSON"), "{error}");
}
