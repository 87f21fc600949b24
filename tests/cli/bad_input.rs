//! Bad input: exit code 2, nothing on the standard output, and a message with
//! the place and a remedy.

use super::subcert;

/// Runs the program and gives its message.
fn refused<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
    let assert = subcert(arguments).assert().code(2);
    let output = assert.get_output();
    let out = String::from_utf8_lossy(&output.stdout);
    assert!(out.is_empty(), "half-written: {out}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn assert_parts(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "no `{part}` in: {message}");
    }
}

/// Audits a claim file with this text.
fn refused_paper(name: &str, text: &str) -> String {
    let path = std::env::temp_dir().join(format!("subcert-{}-{name}.toml", std::process::id()));
    std::fs::write(&path, text).expect("a temporary file");
    let message = refused(["audit", path.to_str().expect("a UTF-8 path")]);
    std::fs::remove_file(&path).expect("the file is still there");
    assert_parts(&message, &[&format!("{name}.toml:")]);
    message
}

#[test]
fn schemes_and_their_parameters() {
    let cases: [(&str, &[&str]); 13] = [
        ("six-pont:w=1", &["unknown scheme `six-pont`", "six-point"]),
        ("six-point", &["needs its parameter `w`", "six-point:w="]),
        ("six-point:v=1", &["no parameter `v`", "it has: w"]),
        ("six-point:w=1/0", &["division by zero"]),
        ("six-point:w=1,w=2", &["given twice"]),
        ("six-point:w", &["name=value"]),
        ("six-point:w=2^(10^9)", &["too large"]),
        ("newton:j=1,n=1", &["the arity is 1", "from 2 to 64"]),
        ("newton:j=1/2,n=3", &["the offset is -1/2", "integer"]),
        ("newton:j=1,n=10^12", &["arity"]),
        ("a x b x c", &["two factors"]),
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
    assert_parts(&depth("1e99999"), &["--tolerance", "10000"]);
    assert_parts(&depth("abc"), &["--tolerance", "unexpected `a`"]);
    assert_parts(&refused(["constants", "chaikin", "-c", "0"]), &["1..=24"]);
    assert_parts(
        &refused(["constants", "quinary-three-point", "-c", "24"]),
        &["residue classes", "smaller number of levels"],
    );
    assert_parts(&refused(["audit", "--paper", "nobody"]), &["nobody", "khan2019-newton"]);
    assert_parts(&refused(["audit", "nowhere.toml"]), &["cannot read `nowhere.toml`"]);
    assert_parts(&refused(["explain", "khan2019-newton:table-9"]), &["no claim", "KEY:table-1"]);
    assert_parts(&refused(["frobnicate"]), &["frobnicate"]);
}

#[test]
fn rings() {
    let cases: [(&[&str], &[&str]); 12] = [
        (&["depth", "doo-sabin:n=5", "--tolerance", "1"], &["is a ring", "`subcert constants`"]),
        (&["constants", "chaikin x doo-sabin:n=5"], &["`doo-sabin` is a ring", "needs a mask"]),
        (&["constants", "doo-sabin"], &["needs its parameter `n`"]),
        (&["constants", "doo-sabin:n=5/2"], &["points of `face` is 5/2", "from 1 to 600"]),
        (&["constants", "doo-sabin:n=1"], &["joins the point face to itself", "greater valence"]),
        (&["constants", "doo-sabin:n=601"], &["from 1 to 600"]),
        (&["constants", "catmull-clark:N=300"], &["a ring of 601 points"]),
        (&["constants", "bajaj:N=cos(pi/5)"], &["points of `edge`", "must be an integer"]),
        (&["certify", "bajaj:N=3", "--tolerance", "1"], &["depths", "a ring does not have"]),
        (&["oracle", "bajaj:N=3", "--points", "7"], &["this ring has 7 points"]),
        (&["oracle", "bajaj:N=3", "--level", "65"], &["level 65 is too high"]),
        (&["oracle", "doo-sabin:n=5", "--polygon", "rustfmt.toml"], &["rustfmt.toml:1:1"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(arguments.iter().copied()), parts);
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
            &["unexpected ` `", "printed = \"6.02 - 7\""],
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
            &["unknown name `taw`", "c, tau", ":11:10"],
        ),
        (
            "unknown-function",
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = 'contractoin(1)'\n\
             columns = { name = 'c', values = ['1'] }\ncells = [['1']]\n",
            &["unknown function `contractoin`", "contraction"],
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
