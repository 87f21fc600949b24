//! Numbers and masks as people type and copy them.

use super::{TemporaryFile, assert_parts, refused, subcert, written};

/// The program says of a mask typed in another form what it says of the usual one, in each command that takes it.
#[test]
fn masks_in_every_command() {
    let after_the_title = |text: String| -> Vec<String> {
        text.lines()
            .filter(|line| !line.contains("[1") && !line.contains('─'))
            .map(str::to_owned)
            .collect()
    };
    for command in
        [&["constants"][..], &["smoothness"], &["depth", "--tolerance", "½", "--spread", "1."]]
    {
        let run = |mask: &str| {
            let (name, flags) = command.split_first().expect("a name");
            after_the_title(written([&[*name, mask], flags].concat()))
        };
        assert_eq!(run("1/8 [1,4,6,4,1]"), run("[1,4,6,4,1]/8"), "{command:?}");
    }
    let range = |mask: &str| written(["range", mask, "--param", "w", "--smoothness", "1"]);
    assert_parts(&range("½*[-w, 0, 1/2 + w, 1, 1/2 + w, 0, -w] × 2"), &["w"]);
    let message = refused(["constants", "[1, 4, 6, 4, 1]/16"]);
    assert_parts(&message, &["the coefficients add up to 1", "write 2*[1, 4, 6, 4, 1]/16"]);
}

/// A row of a mask that stands one place too early is named, where moving it is all that is needed.
#[test]
fn rows_in_the_wrong_place() {
    let file = |rows: &str| {
        TemporaryFile::new("readings-rows.toml", &format!("name = 'a'\nmask = {rows}\n"))
    };
    let early = file("[['⅛', '3 / 4', '.125'], ['½', '1/2', '0']]");
    assert_parts(
        &words(["constants", early.path()]),
        &["row 1 belongs one place", "up to order 2"],
    );
    assert_parts(&words(["smoothness", early.path()]), &["row 1 belongs one place further"]);
    let third = file("[['0', '1', '0'], ['2/3', '1/3', '0'], ['1/3', '2/3', '0']]");
    assert_parts(&words(["constants", third.path()]), &["row 0 belongs one place back"]);
    let right = file("[['1/8', '3/4', '1/8'], ['0', '1/2', '1/2']]");
    assert!(!words(["smoothness", right.path()]).contains("belongs"));
    // Of a wrong coefficient no row is said to stand elsewhere.
    let wrong = file("[['1/8', '3/4', '1/8'], ['0', '1/4', '3/4']]");
    let message = words(["constants", wrong.path()]);
    assert!(
        message.contains("one of its coefficients") && !message.contains("belongs"),
        "{message}"
    );
}

/// What the program writes, with single blanks.
fn words<'a>(arguments: impl IntoIterator<Item = &'a str>) -> String {
    written(arguments).split_whitespace().collect::<Vec<_>>().join(" ")
}

const HEAD: &str =
    "key = 'k'\n[paper]\nauthors = ['R. Roe']\ntitle = 't'\nvenue = 'v'\nyear = '2026'\n";

/// T_1 = 5/8 and T_2 = 21/64 of the four-point scheme: a fraction is confirmed only where it is equal, cells without a number
/// are no claims, and the checker agrees.
#[test]
fn fractions_and_blanks_in_tables() {
    let table = "[[table]]\nid = 't'\nlocus = 'l'\nscheme = 'four-point:w=1/16'\nvalue = 'contraction(c)'\n\
                 rows = { name = 'd', values = ['1', '+2.', '½'] }\ncolumns = { name = 'c', values = ['1', '2'] }\n\
                 cells = [['5/8', ' 21 / 64'], ['+0.625', '—'], ['', '1/3']]\n";
    let file = TemporaryFile::new("readings-fractions.toml", &format!("{HEAD}{table}"));
    let text = written(["audit", file.path(), "--certified", "--all"]);
    assert_parts(
        &text,
        &[
            "3 are confirmed",
            "5/8 ✓",
            "+0.625 ✓",
            "—",
            "1/3 ✗",
            "Nothing is printed in 2 cells",
            "certified",
        ],
    );
    assert!(!["lost ?", "lost.", "— ?"].iter().any(|words| text.contains(words)), "{text}");
    let json = written(["audit", file.path(), "--certified", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let cells = json["papers"][0]["claims"].as_array().expect("cells");
    assert_eq!(cells.len(), 4);
    assert!(cells.iter().all(|cell| cell["certified"] == true), "{json}");
    assert_parts(&written(["errata", file.path()]), &["1/3 → 21/64"]);
    let exponent = "[[exponent]]\nid = 'e'\nlocus = 'l'\nscheme = 'chaikin'\nprinted = '1/2'\n";
    let file = TemporaryFile::new("readings-exponent.toml", &format!("{HEAD}{exponent}"));
    assert_parts(&refused(["audit", file.path()]), &["value = '1/2'"]);
}

/// The verdicts of the claims of a file, with `certified` behind those that the checker has certified.
fn verdicts(name: &str, claims: &str) -> String {
    let file = TemporaryFile::new(name, &format!("{HEAD}{claims}"));
    let json = written(["audit", file.path(), "--certified", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    let said = |claim: &serde_json::Value| {
        let certified = if claim["certified"] == true { " certified" } else { "" };
        format!("{}{certified}", claim["verdict"].as_str().expect("a word"))
    };
    claims.iter().map(said).collect::<Vec<_>>().join(", ")
}

/// A depth is a number of levels, whatever the unit of its last digit: 1e1 is 10, not 17, and 17 is not 17.6.
#[test]
fn depths_are_whole() {
    let table = |value: &str, cells: &str| {
        format!(
            "[[table]]\nid = 't'\nlocus = 'l'\nscheme = 'chaikin'\nvalue = '{value}'\n\
             promise = {{ tolerance = 'epsilon', spread = '1' }}\n\
             columns = {{ name = 'epsilon', values = ['1/1024', '1/100000'] }}\ncells = [{cells}]\n"
        )
    };
    for (value, cells, expected) in [
        ("levels(1/2, epsilon)", "['1e1', '17']", "confirmed certified, confirmed certified"),
        ("levels(1/2, epsilon)", "['1e1', '1e1']", "confirmed certified, refuted certified"),
        ("levels(1/2, epsilon)", "['1e1', '2e1']", "confirmed certified, refuted certified"),
        ("88/5", "['17', '18']", "refuted certified, confirmed certified"),
    ] {
        assert_eq!(verdicts("readings-depths.toml", &table(value, cells)), expected, "{cells}");
    }
}

/// Exponents that are printed as 0 or less: nobody cuts 0.6 to 0.
#[test]
fn exponents_that_are_not_positive() {
    for (scheme, printed, expected) in [
        ("chaikin", "0", "refuted certified"),
        ("chaikin", "-2", "refuted certified"),
        ("four-point:w=3/10", "0", "refuted certified"),
        ("four-point:w=3/10", "-0.0", "refuted certified"),
        ("four-point:w=3/10", "1", "confirmed certified"),
        ("four-point:w=49/100", "0", "confirmed certified"),
    ] {
        let claim = format!(
            "[[exponent]]\nid = 'e'\nlocus = 'l'\nscheme = '{scheme}'\nprinted = '{printed}'\n"
        );
        assert_eq!(verdicts("readings-exponents.toml", &claim), expected, "{scheme} {printed}");
    }
}

/// A stated value beyond a cap leaves the claims open that need it, and no others.
#[test]
fn stated_values_beyond_a_cap() {
    let table = |id: &str, value: &str| {
        format!(
            "[[table]]\nid = '{id}'\nlocus = 'l'\nvalue = '{value}'\n\
             columns = {{ name = 'x', values = ['1'] }}\ncells = [['1']]\n"
        )
    };
    let function =
        "[[function]]\nid = 'f'\nlocus = 'l'\nvariable = 'x'\nleft = 'x*q'\nright = 'x*q'\n";
    for given in ["10^200000", "2^9223372036854775808", "binomial(10^7, 10001)"] {
        let claims = [table("t", "x*q/q"), table("u", "x"), function.to_owned()].concat();
        let claims = format!("[given]\nq = '{given}'\n{claims}");
        let expected = "not-checkable, confirmed certified, not-checkable";
        assert_eq!(verdicts("readings-given.toml", &claims), expected, "{given}");
    }
}

/// Equal cases of a theorem are one case.
#[test]
fn equal_cases_count_once() {
    let theorem = "[[theorem]]\nid = 'c'\nlocus = 'l'\nbounds = 'difference'\nby = 'beta/2^k'\nfrom = '0'\n\
                   schemes = ['four-point:w=0', 'four-point:w=0.0', 'four-point:w=0', 'chaikin']\n";
    let file = TemporaryFile::new("readings-cases.toml", &format!("{HEAD}{theorem}"));
    assert_parts(&words(["audit", file.path(), "--all"]), &["proved in the 2 cases stated"]);
}

/// A text that is no number is refused with a form that is one.
#[test]
fn what_a_message_suggests_is_read() {
    for (text, words) in
        [("0,625", "unexpected `,`"), ("6.02 - 7", "unexpected `-`"), ("1/0", "denominator 0")]
    {
        let table = format!(
            "[[table]]\nid = 't'\nlocus = 'l'\nvalue = '1'\ncolumns = {{ name = 'c', values = ['1'] }}\ncells = [['{text}']]\n"
        );
        let file = TemporaryFile::new("readings-cell.toml", &format!("{HEAD}{table}"));
        assert_parts(&refused(["audit", file.path()]), &[words]);
        let suggested = table.replace(&format!("cells = [['{text}']]"), "cells = [['-35/1296']]");
        let file = TemporaryFile::new("readings-suggested.toml", &format!("{HEAD}{suggested}"));
        subcert(["audit", file.path()]).assert().success();
    }
}

/// Whether the checker has accepted the certificate of the only table.
fn is_certified(text: &str) -> bool {
    text.lines().any(|line| line.contains("k:w") && line.ends_with(" certified"))
}

/// Constants of a header one by one, and lists of numpy with their type.
#[test]
fn sources_of_programs() {
    let header = TemporaryFile::new("readings-w.h", "#define W0 0.1875\n#define W1 (1.0 / 16)\n");
    let script =
        TemporaryFile::new("readings-w.py", "W = np.array([0.1875, 0.0625], dtype=np.float64)\n");
    let claims = |file: &str, after: &str| {
        let text = format!(
            "key = 'k'\n[project]\nname = 'x'\n[[shipped]]\nid = 'w'\nlocus = 'l'\ntype = 'f64'\nindices = ['k = 1..2']\n\
             equals_cells = ['3/16', '1/16']\ncells_from = {{ file = '{file}', after = {after} }}\n"
        );
        TemporaryFile::new("readings-claims.toml", &text)
    };
    for (file, after) in [(header.path(), "['W0', 'W1']"), (script.path(), "'W'")] {
        let file = claims(file, after);
        assert!(is_certified(&written(["audit", file.path(), "--certified"])));
    }
    let one = claims(header.path(), "'W0'");
    assert_parts(
        &refused(["audit", one.path()]),
        &["`W0` has 1 number", "after = [\"W0\", \"W1\"]"],
    );
    let three = claims(header.path(), "['W0', 'W1', 'W0']");
    assert_parts(&refused(["audit", three.path()]), &["3 names, and the indices have 2"]);
}

/// Every literal of a table for a shader is read back as the nearest float.
#[test]
fn tables_for_shaders_are_read_back() {
    for language in ["hlsl", "wgsl", "glsl"] {
        let text = written(["table", "four-point:w=1/17", "--format", language, "--type", "f32"]);
        let source = TemporaryFile::new(&format!("readings-w.{language}"), &text);
        let name = text.lines().find(|line| line.contains("_weights")).expect("a table");
        let name = name.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let name = name.clone().find(|word| word.ends_with("_weights")).expect("its name");
        let claims = format!(
            "key = 'k'\n[project]\nname = 'x'\n[[shipped]]\nid = 'w'\nlocus = 'l'\ntype = 'f32'\nindices = ['k = 1..8']\n\
             equals_cells = ['0', '1', '0', '0', '-1/17', '19/34', '19/34', '-1/17']\n\
             cells_from = {{ file = '{}', after = '{name}' }}\n",
            source.path()
        );
        let file = TemporaryFile::new("shader-claims.toml", &claims);
        let text = written(["audit", file.path(), "--certified"]);
        assert!(is_certified(&text) && text.contains("1 is right to the last bit"), "{text}");
    }
    let message = refused(["table", "chaikin", "--format", "wgsl", "--type", "f64"]);
    assert_parts(&message, &["wgsl has no f64", "--type f32"]);
    assert_parts(
        &written(["table", "chaikin", "--format", "wgsl"]),
        &["array<array<f32, 2>, 2>", "0.75f"],
    );
}
