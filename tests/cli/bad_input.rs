//! Bad input: exit code 2, nothing on the standard output, and a message with
//! the place and a remedy.

use super::{TemporaryFile, assert_parts, refused};

/// Audits a claim file with this text.
fn refused_paper(name: &str, text: &str) -> String {
    let file = TemporaryFile::new(&format!("{name}.toml"), text);
    let message = refused(["audit", file.path()]);
    assert_parts(&message, &[&format!("{name}.toml:")]);
    message
}

#[test]
fn schemes_and_their_parameters() {
    let cases: [(&str, &[&str]); 19] = [
        ("4-point:w=1/16", &["unknown scheme `4-point`; did you mean `four-point`?"]),
        ("dyn-levin-gregory", &["or `four-point` or"]),
        ("four-point:1/16", &["write `four-point:w=1/16`"]),
        (
            "[-w, 0, 1/2 + w, 1, 1/2 + w, 0, -w]",
            &[
                "such as 1/16",
                "`subcert range '[-w, 0, 1/2 + w, 1, 1/2 + w, 0, -w]' --param w --smoothness 1`",
            ],
        ),
        ("ball-storry:N=5,gamma=1/20", &["write `ball-storry:N=5,gamma=1/20,beta=…`"]),
        ("[-w 0 1/2+w 1 1/2+w 0 -w]", &["write commas between coefficients"]),
        (
            "six-pont:w=1",
            &["unknown scheme `six-pont`; did you mean `six-point`?", "binary-three-point"],
        ),
        ("six-point", &["needs its parameter `w`", "six-point:w="]),
        ("six-point:v=1", &["no parameter `v`", "it has: w"]),
        ("six-point:w=1/0", &["division by zero"]),
        ("six-point:w=1,w=2", &["given twice"]),
        ("six-point:w", &["name=value"]),
        ("six-point:w=2^(10^9)", &["too large"]),
        ("newton:j=1,n=1", &["`newton` needs n >= 2, and n is 1", "the arity"]),
        ("newton:j=1/2,n=3", &["the offset is -1/2", "integer"]),
        ("newton:j=1,n=10^12", &["arity"]),
        ("a x b x c x d", &["two or three factors"]),
        ("", &["name is missing"]),
        ("nowhere.toml", &["cannot read `nowhere.toml`"]),
    ];
    for (scheme, parts) in cases {
        assert_parts(&refused(["constants", scheme]), parts);
    }
}

#[test]
fn numbers_and_flags() {
    let depth = |tolerance| refused(["depth", "chaikin", "--tolerance", tolerance]);
    assert_parts(&depth("0"), &["--tolerance must be positive"]);
    assert_parts(&depth("-1"), &["--tolerance must be positive"]);
    assert_parts(&depth("1e"), &["--tolerance", "digit"]);
    assert_parts(&depth("1e99999"), &["--tolerance", "±1000"]);
    assert_parts(&depth("abc"), &["--tolerance", "unexpected `a`"]);
    assert_parts(&refused(["constants", "chaikin", "-c", "0"]), &["1..=256"]);
    assert_parts(&refused(["constants", "chaikin", "-c", "257"]), &["1..=256"]);
    assert_parts(&refused(["audit", "--paper", "nobody"]), &["nobody", "khan2019-newton"]);
    assert_parts(&refused(["audit", "nowhere.toml"]), &["cannot read `nowhere.toml`"]);
    assert_parts(
        &refused(["explain", "khan2019-newton:table-9"]),
        &[
            "has no claim `table-9`; `subcert explain khan2019-newton` lists its claims; did you mean `table-",
        ],
    );
    assert_parts(
        &refused(["constants", "four-point:w="]),
        &["the value of `w` is missing", "write `six-point:w=3/256`"],
    );
    assert_parts(&refused(["frobnicate"]), &["frobnicate"]);
    let cases: [(&[&str], &str); 7] = [
        (&["constants", "four-point", "w=1/16"], "'four-point:w=1/16'"),
        (&["constants", "four-point", "--w", "1/16"], "'four-point:w=1/16'"),
        (&["constants", "four-point", "--w=1/16"], "'four-point:w=1/16'"),
        (&["smoothness", "four-point", "--param", "w=1/16"], "'four-point:w=1/16'"),
        (&["smoothness", "four-point", "--param", "w"], "`subcert range 'four-point' --param w`"),
        (&["constants", "[1,", "3,", "3,", "1]/4"], "in brackets and in quotes"),
        (&["constants", "-1/16, 9/16, 9/16, -1/16"], "in brackets and in quotes"),
    ];
    for (arguments, part) in cases {
        assert_parts(&refused(arguments.iter().copied()), &["tip: ", part]);
    }
}

#[test]
fn rings() {
    let cases: [(&[&str], &[&str]); 14] = [
        (
            &["depth", "doo-sabin:n=5", "--tolerance", "1", "--polygon", "rustfmt.toml"],
            &["--polygon and --width are for curves"],
        ),
        (&["constants", "chaikin x doo-sabin:n=5"], &["`doo-sabin` is a ring", "needs a mask"]),
        (&["constants", "doo-sabin"], &["needs its parameter `n`"]),
        (&["constants", "doo-sabin:n=5", "--forward"], &["--forward", "a ring", "leave it out"]),
        (&["constants", "doo-sabin:n=7/2"], &["points of `face` is 7/2", "from 1 to 600"]),
        (&["constants", "doo-sabin:n=2"], &["needs n >= 3, and n is 2", "vertices of the face"]),
        (
            &["constants", "catmull-clark:N=2"],
            &["needs N >= 3, and N is 2; its meaning: the valence"],
        ),
        (&["constants", "doo-sabin:n=601"], &["from 1 to 600"]),
        (&["constants", "catmull-clark:N=300"], &["a ring of 601 points"]),
        (&["constants", "bajaj:N=cos(pi/5)"], &["points of `edge`", "must be an integer"]),
        (
            &["certify", "bajaj:N=3", "--tolerance", "1"],
            &["for masks", "`subcert depth` gives the exact depth"],
        ),
        (&["oracle", "bajaj:N=3", "--points", "7"], &["this ring has 7 points"]),
        (&["oracle", "bajaj:N=3", "--level", "65"], &["level 65 is too high"]),
        (&["oracle", "doo-sabin:n=5", "--polygon", "rustfmt.toml"], &["rustfmt.toml:1:1"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(arguments.iter().copied()), parts);
    }
}

/// The remedy names the file as it is typed, not the name that it gives the scheme.
#[test]
fn a_scheme_of_a_file() {
    let file = TemporaryFile::new(
        "own.toml",
        "name = 'mine'\nparameters.w = {}\nmask = [['w', '1 - w'], ['0', '1']]\n",
    );
    let remedy = format!("write `{}:w=…`", file.path());
    assert_parts(&refused(["scheme", file.path()]), &[&remedy]);
}

#[test]
fn ranges() {
    let cases: [(&str, &str, &[&str]); 11] = [
        ("six-point", "v", &["no parameter `v` open", "known: w"]),
        ("six-point:w=3/256", "w", &["does not depend on `w`", "no value", "it has: w"]),
        ("chaikin", "w", &["does not depend on `w`", "it has none"]),
        ("six-point", "", &["does not depend on ``", "it has: w"]),
        ("six-point x chaikin", "w", &["tensor product", "one of its factors"]),
        ("doo-sabin", "n", &["the number of points of `face` is n", "integer from 1"]),
        ("newton:j=1", "n", &["the arity is n", "integer"]),
        ("newton:n=3", "w", &["no parameter `w` open", "known: j"]),
        ("six-point:w=1/w", "w", &["w"]),
        ("six-point:w=cos(2*pi/7)*v", "v", &["not a polynomial in `v` with rational coefficients"]),
        ("six-point:w=v^60", "v", &["degree 240", "smaller number of levels"]),
    ];
    for (scheme, parameter, parts) in cases {
        assert_parts(&refused(["range", scheme, "--param", parameter]), parts);
    }
    assert_parts(&refused(["range", "six-point:w=0"]), &["leaves no parameter open"]);
    let deep = refused(["range", "six-point", "--param", "w", "-c", "10"]);
    assert_parts(&deep, &["2^10 residue classes", "524288", "smaller number"]);
}

/// Asks for the depth of the control polygon in a file with this text.
fn refused_polygon(name: &str, text: &str) -> String {
    let file = TemporaryFile::new(name, text);
    refused(["depth", "b-spline:degree=3", "--tolerance", "1/9", "--polygon", file.path()])
}

#[test]
fn control_polygons() {
    let digits = "1".repeat(2_000);
    let (long, many) = (format!("0\n{digits}\n"), "0\n1\n".repeat(5_001));
    let cases: [(&str, &str, &[&str]); 16] = [
        ("header.csv", "x, y\n0, 0\n", &["header.csv:1:1", "unexpected `x`", "`#` before"]),
        ("cell.csv", "0, 0\n1, 1/0\n", &["cell.csv:2:4", "denominator 0"]),
        ("ragged.csv", "0, 0\n1\n", &["ragged.csv:2:1", "1 coordinates here, and 2"]),
        ("space.csv", "0\u{3000}0\n1\u{3000}x\n", &["space.csv:2:3", "unexpected `x`"]),
        (
            "one.csv",
            "0, 4, 4, 0\n",
            &["from 2 to 10000 points; there are 1", "one point on a line"],
        ),
        ("none.csv", "# nothing\n", &["there are 0"]),
        ("same.csv", "3\n3\n3\n", &["all points are the same"]),
        ("many.csv", &many, &["there are 10002"]),
        ("long.csv", &long, &["long.csv:2:1", "4096 binary digits", "round"]),
        ("word.json", "[1, 2, true]", &["word.json:1:8", "this is neither a number"]),
        ("object.json", "[1, {\"x\": 2}]", &["object.json:1:5", "this is neither a number"]),
        ("text.json", "[1, \"two\"]", &["text.json:1:5", "unexpected `t`"]),
        ("syntax.json", "[1,\n 2,, 3]", &["syntax.json:2:4", "expected value"]),
        (
            "unfinished.json",
            "[[1, 2], [3, é",
            &["unfinished.json:1:1", "[[0, \"1/3\"], [0.25, 1]]"],
        ),
        ("ragged.json", "[[1, 2],\n [3]]", &["ragged.json:2:3", "1 coordinates here"]),
        ("empty.json", "[[], []]", &["from 1 to 16"]),
    ];
    for (name, text, parts) in cases {
        assert_parts(&refused_polygon(name, text), parts);
    }
    let with = |more: &[&'static str]| {
        let depth = ["depth", "chaikin", "--tolerance", "1"];
        refused(depth.into_iter().chain(more.iter().copied()))
    };
    assert_parts(&with(&["--polygon", "nowhere.csv"]), &["cannot read `nowhere.csv`"]);
    assert_parts(&with(&["--boundary", "open"]), &["--polygon"]);
    let polygon = ["--polygon", "examples/polygon.csv"];
    assert_parts(&with(&[&polygon[..], &["--boundary", "edge"]].concat()), &["--mesh"]);
    let both = ["--polygon", "examples/polygon.csv", "--spread", "2"];
    assert_parts(&with(&both), &["cannot be used with '--spread <B>'"]);
    assert_parts(&with(&["--width", "0"]), &["--width must be positive"]);
    let surface = ["depth", "chaikin x chaikin", "--tolerance", "1"];
    let surface = surface.into_iter().chain(["--polygon", "examples/polygon.csv"]);
    assert_parts(&refused(surface), &["--polygon is for curves"]);
    let six = ["depth", "six-point:w=3/256", "--tolerance", "1", "--boundary", "open"];
    let six = six.into_iter().chain(["--polygon", "examples/polygon.csv"]);
    assert_parts(&refused(six), &["--polygon: fewer than", "control points"]);
}

/// Whatever a polygon file holds, the program ends with a message, not a panic.
#[test]
fn nonsense_polygons() {
    let deep = "[".repeat(100_000);
    for (name, text) in [
        ("deep.json", deep.as_str()),
        ("zeros.json", "[\u{0}, \u{0}]"),
        ("open.json", "[\"1"),
        ("late.json", "[1, 2]]"),
        ("comma.csv", ",,,\n,\n"),
        ("exponent.csv", "1e9999\n1e-9999\n"),
    ] {
        let message = refused_polygon(name, text);
        assert!(!message.contains("panicked"), "{message}");
    }
}

const PAPER: &str = r#"
key = "k"
[paper]
authors = ["A B"]
title = "t"
venue = "v"
year = "2026"
"#;

#[test]
fn claim_files() {
    let cases: [(&str, &str, &[&str]); 16] = [
        (
            "theorem",
            "[[theorem]]\nid = 't'\nlocus = 'l'\nsays = 'x'\nrests = ['nothing']\n",
            &["`nothing` is no other claim", ":12:10"],
        ),
        (
            "contents",
            "[[unclaimed]]\nlocus = '(1)'\nreason = 'x'\n",
            &["(1) is not among the numbered items", ":9:9", "numbered = "],
        ),
        ("not-toml", "[paper", &["unclosed table", ":8:7"]),
        ("unknown-key", "colour = 1\n", &["unknown field `colour`"]),
        (
            "number",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = '1'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [[0.5]]\n",
            &["floating point", "in quotes"],
        ),
        (
            "ragged",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = '1'\n\
             columns = { name = 'c', values = ['1', '2'] }\ncells = [['0.5']]\n",
            &["1 cells, and 2 column headers", ":13:"],
        ),
        (
            "rows",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = '1'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1'], ['2']]\n",
            &["2 rows of cells, and 1 row headers"],
        ),
        (
            "damaged",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = '1'\n\
             columns = { name = 'c', values = ['6.02 - 7'] }\ncells = [['1']]\n",
            &["unexpected `-`", "printed = \"6.02 - 7\""],
        ),
        (
            "twice",
            "[[equation]]\nid = 'e'\nlocus = 'l'\nabsent = 'x'\n\
             [[equation]]\nid = 'e'\nlocus = 'l'\nabsent = 'x'\n",
            &["`e` is used twice"],
        ),
        (
            "formula",
            "[define]\nT = '2*(1 +'\n",
            &["expected a number, a name or `(`", "T = '2*(1 +'"],
        ),
        (
            "unknown-name",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = 'taw'\ngiven = { tau = '1' }\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["unknown name `taw`; did you mean `tau`?", "c, tau", ":11:10"],
        ),
        (
            "unknown-function",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = 'contractoin(1)'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["unknown function `contractoin`; did you mean `contraction`?"],
        ),
        (
            "no-scheme",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = 'contraction(c)'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["needs a scheme"],
        ),
        (
            "option",
            "[[table]]\nid = 't'\nlocus = 'l'\nscheme = 'chaikin'\n\
             value = 'contraction(c, order = backward)'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["adjoint, forward", "backward"],
        ),
        (
            "itself",
            "[define]\nA = 'B + 1'\nB = 'A'\n[[table]]\nid = 't'\nlocus = 'l'\nvalue = 'A'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["refers to itself"],
        ),
        (
            "not-affine",
            "[[scheme]]\nname = 's'\nmask = [['1/2', '1/2'], ['1/2', '1/3']]\n\
             [[table]]\nid = 't'\nlocus = 'l'\nscheme = 's'\nvalue = 'contraction(1)'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["rule 1 sums to 5/6", "-1/6"],
        ),
    ];
    for (name, text, parts) in cases {
        assert_parts(&refused_paper(name, &format!("{PAPER}{text}")), parts);
    }
}

/// Whatever a file holds, the program ends with a message, not a panic.
#[test]
fn nonsense_files() {
    let deep = format!("[define]\na = '{}1'\n", "(".repeat(5_000));
    let cases = [
        ("empty", String::new()),
        ("binary", "\u{0}\u{1}\u{2}".repeat(100)),
        ("deep-formula", format!("{PAPER}{deep}")),
        ("deep-toml", format!("{PAPER}x = {}", "[".repeat(100_000))),
        ("many-indices", {
            let index = |i| format!("{{ name = 'i{i}', values = [{}] }}", "'0', ".repeat(10));
            let indices: Vec<String> = (0..30).map(index).collect();
            format!(
                "{PAPER}[[equation]]\nid = 'e'\nlocus = 'l'\nindices = [{}]\n\
                 left = ['1']\nright = '1'\n",
                indices.join(", ")
            )
        }),
    ];
    for (name, text) in cases {
        let message = refused_paper(name, &text);
        assert!(!message.contains("panicked"), "{message}");
    }
}

#[test]
fn certificates_that_cannot_be_written() {
    let cases: [(&[&str], &[&str]); 5] = [
        (&["prove"], &["--output <DIR>"]),
        (&["prove", "-o", "-"], &["one certificate at a time", "name one paper"]),
        (&["prove", "khan", "-o", "-"], &["`khan` is no claim file", "did you mean `khan20"]),
        (
            &["prove", "khan2019-newton", "khan2019-newton", "-o", "-"],
            &["the key `khan2019-newton`"],
        ),
        (&["prove", "khan2019-newton", "-o", "Cargo.toml"], &["cannot write `Cargo.toml/khan"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(arguments.iter().copied()), parts);
    }
}

#[test]
fn a_file_that_has_not_begun_is_told_how_to_begin() {
    let help = ["missing fields", "[paper]", "subcert new"];
    assert_parts(&refused_paper("empty", ""), &help);
    assert_parts(&refused_paper("key-only", "key = \"k\"\n"), &help);
    let begun = refused_paper("begun", "key = \"k\"\n[paper]\n");
    assert!(!begun.contains("subcert new"), "{begun}");
}

#[test]
fn a_cell_of_a_table_of_smoothness_that_states_nothing() {
    let file = "examples/smoothness.toml";
    // The second exponent of the table is not printed.
    for cell in ["2:2", "4:1", "0:1", "x"] {
        let message = refused(["explain", &format!("doe2026-smoothness:table-1:{cell}"), file]);
        assert_parts(
            &message,
            &[
                &format!("cell `{cell}`"),
                "explain doe2026-smoothness:table-1 examples/smoothness.toml`",
            ],
        );
    }
}

#[test]
fn keys_in_the_place_of_files() {
    assert_parts(&refused(["audit", "khan2019-newton"]), &["--paper khan2019-newton"]);
    assert_parts(&refused(["audit", "examples/smoothness"]), &["`examples/smoothness.toml`"]);
}
