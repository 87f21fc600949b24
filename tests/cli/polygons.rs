//! `oracle` reads the control polygons that `depth` reads.

use super::{TemporaryFile, assert_parts, refused, written};
use serde_json::Value;

/// What `oracle` writes of this scheme and this file.
fn oracle(scheme: &str, file: &str) -> Value {
    let text = written(["oracle", scheme, "--level", "1", "-c", "1", "--polygon", file]);
    serde_json::from_str(&text).expect("JSON")
}

/// The exact values of a group.
fn values(json: &Value, quantity: &str) -> Vec<String> {
    let groups = json["groups"].as_array().expect("groups");
    let group = groups.iter().find(|group| group["quantity"] == quantity).expect(quantity);
    let values = group["values"].as_array().expect("values");
    values.iter().map(|value| value["exact"].as_str().expect("a value").to_owned()).collect()
}

/// Each coordinate has a group, which is what it gives by itself.
#[test]
fn points_are_refined_coordinate_by_coordinate() {
    let points = oracle("chaikin", "examples/polygon.csv");
    for (number, column) in [(1, "0\n4\n4\n2.5\n0\n-1/3\n"), (2, "0 0 5/2 4 4 2")] {
        let alone = TemporaryFile::new(&format!("{number}.csv"), &column.replace(' ', "\n"));
        let alone = oracle("chaikin", alone.path());
        for quantity in ["control", "refined"] {
            let of_points = values(&points, &format!("{quantity}-{number}"));
            assert_eq!(of_points, values(&alone, quantity));
        }
    }
    assert_eq!(values(&points, "refined-1").len(), 12);
    let space = oracle("four-point", "examples/polygon.json");
    assert_eq!(values(&space, "control-3")[..2], ["1/3", "1/3"]);
    let ring = TemporaryFile::new("ring.json", "[[0, 1], [1, 1], [1, 0]]");
    assert_eq!(values(&oracle("doo-sabin:n=3", ring.path()), "refined-2").len(), 3);
}

#[test]
fn grids_have_a_row_on_a_line() {
    let [csv, json] =
        [("grid.csv", "0, 1, 2\n3 4 5 # a row\n"), ("grid.json", "[[0, 1, 2], [3, 4, 5]]")];
    let [csv, json] = [csv, json].map(|(name, text)| TemporaryFile::new(name, text));
    let surface = "chaikin x chaikin";
    assert_eq!(oracle(surface, csv.path()), oracle(surface, json.path()));
    let apart = TemporaryFile::new("apart.csv", "0 1\n# a comment\n\n2 3\n");
    let notes = oracle(surface, apart.path())["header"]["notes"].to_string();
    assert!(notes.contains("an empty line before line 4; the rows"), "{notes}");
    let ragged = TemporaryFile::new("rows.csv", "0 1\n2\n");
    let message = refused(["oracle", surface, "--polygon", ragged.path()]);
    assert_parts(&message, &["rows.csv:2:1", "1 numbers in this row, and 2"]);
}

#[test]
fn what_depth_refuses_oracle_refuses() {
    let cases: [(&str, &str, &[&str]); 8] = [
        ("gap.csv", "1,2,3\n1,,2\n", &["gap.csv:2:3", "no number in this cell"]),
        ("blank.csv", "1; ;2\n", &["blank.csv:1:3", "no number in this cell"]),
        ("comma.csv", "0,1\n,1,2\n", &["comma.csv:2:1", "no number in this cell"]),
        ("row.csv", "0,1\n,\n2,3\n", &["row.csv:2:1", "no number in this cell"]),
        ("line.csv", "0, 4, 4, 0\n", &["there are 1", "one point on a line"]),
        ("points.csv", "0, 0\n1\n", &["points.csv:2:1", "1 coordinates here, and 2"]),
        ("word.json", "[1, true]", &["word.json:1:5", "this is neither a number"]),
        ("header.csv", "x\n", &["header.csv:1:1", "`#` before what is not a number"]),
    ];
    for (name, text, parts) in cases {
        let file = TemporaryFile::new(name, text);
        assert_parts(&refused(["oracle", "chaikin", "--polygon", file.path()]), parts);
        let depth = ["depth", "chaikin", "--tolerance", "1", "--polygon", file.path()];
        assert_parts(&refused(depth), parts);
    }
}

/// A file of a spreadsheet: with a byte order mark, line ends of Windows or of old Macintoshes, semicolons.
#[test]
fn files_of_spreadsheets() {
    let plain = TemporaryFile::new("sheet-plain.csv", "0,0\n4,0\n4,.5\n0,1/2\n");
    let expected = oracle("chaikin", plain.path());
    for (name, text) in [
        ("sheet-mark.csv", "\u{feff}0,0\r\n4,0\r\n4,+0.5\r\n0,½\r\n"),
        ("sheet-old.csv", "0,0\r4,0 # a comment\r4,5e-1\r0,1/2\r"),
        ("sheet-ends.csv", "0 , 0,\n4,0, # a comment\n4 0.5 ,\r\n0,.5\n"),
        ("sheet-semicolons.csv", "0;0\n4;0\n4;0.50\n0;.5\n"),
        ("sheet-text.json", "\u{feff}[[0, 0], [4, 0], [4, \" .5\"], [0, \"½\"]]"),
    ] {
        let file = TemporaryFile::new(name, text);
        for quantity in ["control-1", "control-2", "refined-2"] {
            let found = values(&oracle("chaikin", file.path()), quantity);
            assert_eq!(found, values(&expected, quantity), "{name}");
        }
    }
    let commas = TemporaryFile::new("sheet-commas.csv", "0;0\n4,5;0\n");
    let message = refused(["oracle", "chaikin", "--polygon", commas.path()]);
    assert_parts(&message, &["sheet-commas.csv:2:2", "a decimal comma or a separator"]);
}

/// Numbers on the command line are read as in files.
#[test]
fn numbers_of_flags() {
    let file = "examples/polygon.csv";
    let depth = |tolerance: &str| {
        let text = written(["depth", "chaikin", "--polygon", file, "--tolerance", tolerance]);
        text.lines().skip(2).map(str::to_owned).collect::<Vec<String>>()
    };
    let expected = depth("1/20");
    for tolerance in [".05", "0.05", "+5e-2", " 1 / 20 ", "5 × 10^−2"] {
        assert_eq!(depth(tolerance), expected, "{tolerance}");
    }
}
