//! Names that do not exist: what may be meant, and what there is.

use super::{TemporaryFile, assert_parts, refused, written};

#[test]
fn what_may_be_meant() {
    let cases: [(&[&str], &[&str]); 14] = [
        (&["constants", "chaiken"], &["did you mean `chaikin`? Known:"]),
        (&["constants", "nothing-like-it"], &["`nothing-like-it`; known:"]),
        (&["audit", "--paper", "khan2019"], &["did you mean `khan2019-newton`?"]),
        (
            &["explain", "khan2019-newtn:table-1"],
            &["`khan2019-newtn`; did you mean `khan2019-newton`"],
        ),
        (&["explain", "khan2019-newton:eq-3.99"], &["lists its claims; did you mean `eq-3."]),
        (&["explain", "khan2019-newton:table-1:9:99"], &["no cell `9:99`", "a row from 1 to"]),
        (&["explain", "khan2019-newton::"], &["has no claim ``"]),
        (&["explain", "khan2019-newton:table-1:01:1"], &["has no cell `01:1`"]),
        (&["explain", "khan2019-newton:table-1:+1:1"], &["has no cell `+1:1`"]),
        (&["explain", "mustafa2007-bajaj:theorem-2:1:1"], &["no table, and has no cells"]),
        (
            &["explain", "examples/smoothness.toml", "doe2026-smoothness:table-1.2.order"],
            &["subcert explain doe2026-smoothness:table-1.2.order examples/smoothness.toml"],
        ),
        (&["explain", "examples/smoothness.toml"], &["write the claim before it"]),
        (&["constants", "examples"], &["`examples` is a directory, and no scheme", ".toml"]),
        (&["constants", "examples/polygon.csv"], &["`examples/polygon.csv` is a file of points"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(arguments.iter().copied()), parts);
    }
}

/// A key alone lists what can be explained; the ids are those of the audit's headings.
#[test]
fn ids_stand_in_headings_and_in_lists() {
    let file = "examples/my-paper.toml";
    let audit = written(["audit", file, "--all"]);
    let listed = written(["explain", "doe2026-corner", file]);
    let json = written(["explain", "doe2026-corner", file, "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let claims = json["claims"].as_array().expect("claims");
    assert_eq!(claims.len(), 7);
    for claim in claims {
        let id = claim["id"].as_str().expect("an id");
        assert!(listed.contains(id), "{id} in {listed}");
        assert!(audit.contains(&format!(" · {id}\n")), "{id} in {audit}");
    }
    assert_eq!(claims[6]["kind"], "theorem");
}

/// A mask whose sums depend on a parameter is refused with its value.
#[test]
fn the_values_at_which_a_mask_is_none() {
    let text = "name = 's'\nparameters.w = { default = '1/4' }\n\
                mask = [['1 - w', '2*w'], ['1/2', '1/2']]\n";
    let file = TemporaryFile::new("sums.toml", text);
    let at = |value: &str| refused(["constants", &format!("{}{value}", file.path())]);
    assert_parts(&at(":w=1/5"), &["rule 0 sums to 6/5", "at w = 1/5"]);
    assert_parts(&at(""), &["rule 0 sums to 5/4", "at w = 1/4"]);
}

/// A symbol is a name of a scheme, also where it begins with a minus; what is none is refused with its place.
#[test]
fn symbols_in_place_of_names() {
    let lines = |text: &str| {
        let said = written(["constants", text, "-c", "1"]);
        said.lines().skip(2).map(str::to_owned).collect::<Vec<_>>()
    };
    let four = lines("four-point:w=1/16");
    for text in [
        "-z^-3*(1+z)^4*(1-4*z+z^2)/16",
        "z^-1*(1+z)^2/2*(1 - 2*w*(1-z)^2*(1+z^2)/z^2):w=1/16",
        "-1/16*[1, 0, -9, -16, -9, 0, 1]",
    ] {
        assert_eq!(lines(text), four, "{text}");
    }
    for (text, parts) in [
        ("(1+z)^1000000000", &["at most 64", "SCHEME:1:1"][..]),
        (
            "-z^-3*(1+z)^4/(1-2*z)",
            &["leaves a remainder", "a factor of what stands before it", "SCHEME:1:"],
        ),
        ("(1+z)^4/16", &["write 2*(1+z)^4/16 for the arity 2"]),
        ("2z + 1", &["expected an operator", "write products with `*`"]),
    ] {
        assert_parts(&refused(["constants", text]), parts);
    }
}
