//! Net files.

use super::{CLOSED, bumpy, nets};
use crate::common::r;
use proptest::prelude::*;
use subcert::diagnostic::{Diagnostic, SourceText};
use subcert::net::{Closed, Net, NetFormat, read_net};

fn read(text: &str, format: NetFormat) -> Result<Net, Diagnostic> {
    read_net(&SourceText::new("net", text), format, None)
}

#[test]
fn both_forms_hold_the_same_net() {
    let csv = "# a net\n0 0 0.1, 1 0 1/3, 2.5e-1 +0 .5\n\n\"0 1 5.\" ,1 1 -7,2 1 0, # a comma at the end\n";
    let json = r#" {"points": [[[0, 0, 0.1], [1, 0, "1/3"], [2.5e-1, 0, "0.5"]],
        [[0, 1, 5.0], [1, 1, -7], [2, 1, 0]]], "closed": "none"} "#;
    let found = read(csv, NetFormat::Csv).expect("a net");
    assert_eq!(found, read(json, NetFormat::Json).expect("a net"));
    assert_eq!((found.sizes(), found.closed()), ([2, 3], CLOSED[0]));
    assert_eq!(found.points()[0][2], r(1, 10));
    assert_eq!(found.points()[2], [r(1, 4), r(0, 1), r(1, 2)]);
}

#[test]
fn what_is_said_of_the_seams() {
    let points = "[[[0,0,0],[1,0,0],[1,1,0]],[[0,0,1],[1,0,1],[1,1,1]],[[0,0,2],[1,0,2],[1,1,2]]]";
    for closed in CLOSED {
        let text = format!("{{\"closed\": \"{}\", \"points\": {points}}}", closed.name());
        assert_eq!(read(&text, NetFormat::Json).expect("a net").closed(), closed);
        let source = SourceText::new("net", points);
        let said = read_net(&source, NetFormat::Json, Some(closed)).expect("a net");
        assert_eq!(said.closed(), closed);
    }
}

/// What is wrong, the line and the column, and a part of the message.
#[test]
fn errors_have_a_place_and_a_remedy() {
    let cases: [(&str, usize, usize, &str); 15] = [
        ("", 1, 1, "no point"),
        ("0 0 0, 1 0 0\n0 1 0\n", 2, 1, "1 points, and the first row has 2"),
        ("0 0 0, 1 0\n", 1, 8, "2 numbers here"),
        ("0 0 0, , 1 0 0\n", 1, 8, "no point between"),
        ("x,y,z\n0,0,0\n", 1, 1, "number"),
        ("0,0,0\n1,0,0\n", 1, 1, "1 number here"),
        ("0 0 0, 1 0 x\n", 1, 12, "number"),
        ("0 0 0\n1 0 0\n", 1, 1, "1 points in a row"),
        ("[[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]", 1, 35, "EOF"),
        ("[[[0,0,0],[1,0]],[[0,1,0],[1,1,0]]]", 1, 11, "2 numbers here"),
        ("[[[0,0,0],[1,0,0]],[[0,1,0]]]", 1, 20, "1 points, and the first row has 2"),
        ("[[0,0,0],[1,0,0]]", 1, 3, "invalid type"),
        ("{\"points\": [], \"close\": \"u\"}", 1, 25, "no field `close`"),
        ("{\"points\": [[[0,0,null]]]}", 1, 19, "neither a number nor a string"),
        ("{\"closed\": \"u\", \"closed\": \"v\"}", 1, 27, "`closed` stands twice"),
    ];
    for (text, line, column, part) in cases {
        let format = NetFormat::of_text(text);
        let error = read(text, format).expect_err(text);
        assert_eq!(error.line_and_column(), (line, column), "{error}");
        assert!(error.message.contains(part), "{error}");
        assert!(error.help.is_some(), "{error}");
    }
}

#[test]
fn what_is_too_large() {
    let digits = "9".repeat(2_000);
    let error = read(&format!("{digits} 0 0, 1 0 0\n0 1 0, 1 1 0\n"), NetFormat::Csv);
    assert!(error.expect_err("a long number").message.contains("binary digits"));
    let row = "0 0 0,".repeat(1_001);
    let many = vec![row; 1_000].join("\n");
    let error = read(&many, NetFormat::Csv).expect_err("too many points");
    assert!(error.message.contains("more than 1000000 points"), "{}", error.message);
}

#[test]
fn small_nets_are_refused_where_they_are_closed() {
    let net = bumpy(2, 3, Closed::default());
    let error = Net::new(net.points().to_vec(), 3, CLOSED[1]).expect_err("two rows");
    assert!(error.to_string().contains("2 rows; a closed direction needs 3"), "{error}");
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    /// Whatever the text is, there is a net or an error.
    #[test]
    fn no_text_is_a_fault(text in "[-0-9 .,\\[\\]{}\"#/e\\nclosedpints:]{0,60}") {
        for format in [NetFormat::Csv, NetFormat::Json] {
            if let Err(error) = read(&text, format) {
                prop_assert!(!error.to_string().is_empty());
            }
        }
    }

    /// A net that is written exactly is read again.
    #[test]
    fn fractions_are_read_exactly(net in nets(3, 4)) {
        let rows = net.points().chunks(4).map(|row| {
            let point = |p: &[subcert::exact::Rational; 3]| format!("{} {} {}", p[0], p[1], p[2]);
            row.iter().map(point).collect::<Vec<_>>().join(", ")
        });
        let text = rows.collect::<Vec<_>>().join("\n");
        let source = SourceText::new("net", text);
        let again = read_net(&source, NetFormat::Csv, Some(net.closed())).expect("a net");
        prop_assert_eq!(again, net);
    }
}
