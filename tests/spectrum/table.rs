//! Tables: every literal is the nearest number of its type.

use super::SCHEMES;
use subcert::exact::{Enclosed, Real, RealExpression, Scalar};
use subcert::float::exact;
use subcert::spectrum::table::{Language, Origin, RealType, Row, write, write_sectors};
use subcert::spectrum::{Sector, surroundings};

fn rows(scheme: &str) -> Vec<Row> {
    (3..=9)
        .map(|n| Row::of(&surroundings(scheme, Some(n)).expect("rules")).expect("a row"))
        .collect()
}

fn table(rows: &[Row], scheme: &str, language: Language, real: RealType) -> String {
    write(rows, language, real, &Origin { scheme, command: "subcert table" }).expect("a table")
}

/// The literals of an array, as they stand between brackets of any kind.
fn literals(text: &str, name: &str) -> Vec<String> {
    // The header of JSON is a list of texts.
    let text = &text[text.find("\"first_").unwrap_or(0)..];
    let line = text.lines().position(|line| {
        let words = line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let is = |word: &str| word.to_lowercase().ends_with(name);
        !line.starts_with("//") && !line.starts_with('#') && words.clone().any(is)
    });
    let lines: Vec<&str> = text.lines().collect();
    let from = &lines[line.unwrap_or_else(|| panic!("no {name} in {text}"))..].join("\n");
    // What follows the last sign of the declaration, up to the end of the list.
    let start = from.find('=').or_else(|| from.find("\": ")).expect("a declaration");
    let body = &from[start + 1..];
    let ends = [";", "]\n\n", "\n  \"", "\n}"].into_iter().filter_map(|end| body.find(end));
    let end = ends.min().unwrap_or(body.len());
    // `array<f32, 21>` of WGSL has a number that is no literal of the list.
    let plain = |word: &str| {
        word.starts_with(|c: char| c.is_ascii_digit() || c == '-') && !word.ends_with('>')
    };
    body[..end]
        .split(|c: char| c.is_whitespace() || "[](){},:".contains(c))
        .filter(|word| plain(word))
        .map(str::to_owned)
        .collect()
}

/// Whether no neighbour of a number is nearer to the exact value.
fn nearest(value: &RealExpression, found: f64, neighbours: [f64; 2]) -> bool {
    let off = |x: f64| RealExpression::from(exact(x).expect("finite")).minus(value).magnitude();
    neighbours.iter().all(|other| off(found) <= off(*other))
}

/// The exact values of the arrays in which every entry counts.
fn expected(rows: &[Row]) -> Vec<(&'static str, Vec<RealExpression>)> {
    let all = |of: &dyn Fn(&Row) -> Vec<RealExpression>| rows.iter().flat_map(of).collect();
    let number = |values: &[subcert::exact::RealCyclotomic]| -> Vec<RealExpression> {
        values.iter().map(|value| RealExpression::from(value.clone())).collect()
    };
    vec![
        ("weights", all(&|row| number(&row.rule))),
        ("subdominant", all(&|row| vec![row.subdominant.clone()])),
        ("limit", all(&|row| number(&row.limit))),
        ("tangent_1", all(&|row| row.tangents[0].clone())),
        ("tangent_2", all(&|row| row.tangents[1].clone())),
    ]
}

#[test]
fn literals_are_nearest() {
    for scheme in SCHEMES {
        let rows = rows(scheme);
        for language in Language::ALL {
            for &real in language.types() {
                let text = table(&rows, scheme, language, real);
                assert_nearest(&text, &expected(&rows), language, real);
            }
        }
    }
}

/// The exact values of the arrays of sectors.
fn expected_of_sectors(sectors: &[Sector]) -> Vec<(&'static str, Vec<RealExpression>)> {
    let number = |values: &[subcert::exact::RealCyclotomic]| -> Vec<RealExpression> {
        values.iter().map(|value| RealExpression::from(value.clone())).collect()
    };
    let across = |sector: &Sector| sector.across.clone().expect("an eigenvalue");
    let all = |of: &dyn Fn(&Sector) -> Vec<RealExpression>| sectors.iter().flat_map(of).collect();
    let mut expected = vec![
        ("limit", all(&|sector| number(&sector.limit[..2]))),
        ("tangent_1", all(&|sector| number(&sector.along[0]))),
    ];
    if sectors[0].corner {
        expected.push(("tangent_2", all(&|sector| number(&sector.along[1]))));
    } else {
        expected.push(("across", all(&|sector| vec![across(sector).eigenvalue])));
        expected.push(("tangent_2", all(&|sector| across(sector).stencil.expect("a tangent"))));
    }
    expected
}

#[test]
fn literals_of_sectors_are_nearest() {
    for (scheme, corner) in [("catmull-clark", false), ("loop", false), ("catmull-clark", true)] {
        let sectors: Vec<Sector> =
            (1..=8).map(|n| Sector::of(scheme, n, corner).expect("a sector")).collect();
        let origin = Origin { scheme, command: "subcert table" };
        for language in Language::ALL {
            for &real in language.types() {
                let text = write_sectors(&sectors, language, real, &origin);
                assert_nearest(&text, &expected_of_sectors(&sectors), language, real);
            }
        }
        let json = write_sectors(&sectors, Language::Json, RealType::F64, &origin);
        let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
        let vertex = if corner { 1.0 } else { 0.75 };
        assert_eq!((&json["first_faces"], &json["last_faces"]), (&1.into(), &8.into()));
        assert_eq!(json["weights"][7][0], vertex);
        // Where the entries of the last sector begin: after those of 1, …, 7 faces.
        let before: usize = sectors[..7].iter().map(|sector| sector.limit.len()).sum();
        assert_eq!(json["offset"][7], before);
    }
}

fn assert_nearest(
    text: &str,
    expected: &[(&str, Vec<RealExpression>)],
    language: Language,
    real: RealType,
) {
    for (name, values) in expected {
        let found = literals(text, name);
        assert_eq!(found.len(), values.len(), "{language:?} {name}: {text}");
        for (word, value) in found.iter().zip(values) {
            let word = word.trim_end_matches(['f', 'l', 'L']);
            let ok = match real {
                RealType::F32 => {
                    let single: f32 = word.parse().expect("a number");
                    if matches!(language, Language::Python | Language::Json) {
                        let wide: f64 = word.parse().expect("a number");
                        assert!(wide.to_bits() == f64::from(single).to_bits(), "{word}");
                    }
                    let around = [single.next_down(), single.next_up()];
                    nearest(value, single.into(), around.map(f64::from))
                }
                RealType::F64 => {
                    let double: f64 = word.parse().expect("a number");
                    nearest(value, double, [double.next_down(), double.next_up()])
                }
            };
            assert!(ok, "{language:?} {name}: {word} for {value}");
        }
    }
}

#[test]
fn shapes() {
    let rows = rows("catmull-clark");
    let text = table(&rows, "catmull-clark", Language::C, RealType::F32);
    for part in [
        "static const float catmull_clark_limit[7][3] = {",
        "enum { catmull_clark_first_valence = 3, catmull_clark_last_valence = 9 };",
        "static const int catmull_clark_offset[7] = {0, 6, 14, 24, 36, 50, 66};",
        "static const float catmull_clark_tangent_1[84] = {",
        "// To check a copy",
    ] {
        assert!(text.contains(part), "no `{part}` in {text}");
    }
    // 16/36, 4/36, 1/36 at valence 4.
    assert!(text.contains("{0.44444445f, 0.11111111f, 0.027777778f}"), "{text}");
    let json = table(&rows, "catmull-clark", Language::Json, RealType::F64);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["offset"][6], 66);
    assert_eq!(json["limit"][1][0], 4.0 / 9.0);
    // The names of files become identifiers.
    let text = table(&rows, "some/my-ring.toml:w=1/16", Language::Glsl, RealType::F64);
    assert!(text.contains("const double my_ring_limit[21] = double[]("), "{text}");
    assert!(rows[0].limit[0].enclosure(0).width().is_zero());
}
