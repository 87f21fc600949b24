//! The reader of TOML against the one that the program uses.

use proptest::prelude::*;
use subcert_check::{Outcome, check};

/// Whether the checker reads a text as TOML; what it says otherwise.
fn read(text: &str) -> Result<(), String> {
    match check(text, &[]) {
        Err(error) if error.contains("expected ") || error.contains("bytes") => Err(error),
        _ => Ok(()),
    }
}

/// Whether the other reader takes a text, which has no numbers but decimal integers of 64 bits, no dates and times.
fn other(text: &str) -> bool {
    toml::from_str::<toml::Table>(text.strip_prefix('\u{feff}').unwrap_or(text)).is_ok()
}

/// Pieces of files, right and wrong, of which lines are made.
const PIECES: [&str; 62] = [
    "a",
    "b",
    "a.b",
    "a.b.c",
    "\"a\"",
    "'a b'",
    "\"\\u0061\"",
    "\"a\\x62\"",
    "''",
    "a . b",
    "-",
    "1",
    "01",
    "+1",
    "-1_0",
    "1__0",
    "'x'",
    "\"x\"",
    "'''x'''",
    "'''\nx\n'''",
    "\"\"\"\\\n  x\"\"\"",
    "\"\"\"a\"\"\"\"\"",
    "\"\\e\"",
    "\"\\q\"",
    "\"\\uD800\"",
    "\"\\U0010FFFF\"",
    "true",
    "false",
    "truer",
    "[]",
    "['x', 'y']",
    "['x' 'y']",
    "['x',,]",
    "[\n'x', # c\n]",
    "{}",
    "{ a = 'x' }",
    "{ a = 'x', }",
    "{ a.b = 'x', a.c = 'y' }",
    "{ a = 'x', a = 'y' }",
    "{\n a = 'x'\n}",
    "[a]",
    "[b]",
    "[a.b]",
    "[[a]]",
    "[[b]]",
    "[[a.b]]",
    "[ a . b ]",
    "[a]]",
    "# c",
    "# \u{7f}",
    "#\u{1}",
    "=",
    " = ",
    "\t",
    "\n",
    "\r\n",
    "\r",
    "\\",
    "\u{feff}",
    "é",
    "\"é\"",
    "[a b]",
];

/// Lines that begin as entries or headers, with pieces that need not fit.
fn file() -> impl Strategy<Value = String> {
    let piece = || prop::sample::select(&PIECES[..]);
    let entry =
        (0..11_usize, piece()).prop_map(|(key, value)| format!("{} = {value}", PIECES[key]));
    let header = (40..48_usize).prop_map(|header| PIECES[header].to_owned());
    let any = prop::collection::vec(piece(), 0..4).prop_map(|pieces| pieces.concat());
    let line = prop_oneof![8 => entry, 4 => header, 1 => any];
    let end = prop_oneof![9 => Just("\n"), 2 => Just("\r\n"), 1 => Just("\r")];
    prop::collection::vec((line, end), 0..7)
        .prop_map(|lines| lines.into_iter().map(|(line, end)| line + end).collect())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4_096))]

    #[test]
    fn it_takes_what_the_other_takes(text in file()) {
        let found = read(&text);
        prop_assert_eq!(found.is_ok(), other(&text), "{:?}: {:?}", text, found);
    }
}

/// Every spelling stands for the same text.
#[test]
fn spellings_of_a_text() {
    let certificate =
        "subcert-certificate 4\npaper k\nequation e\n  left 1 + 1\n  right 2\n  holds 1\nend 1\n";
    for left in [
        "'1 + 1'",
        "\"1\\u0020+ 1\"",
        "\"\\x31 + \\U00000031\"",
        "'''\n1 + 1'''",
        "\"\"\"\r\n1 + \\\r\n\n   1\"\"\"",
    ] {
        let claims = format!(
            "\u{feff}\"key\" = 'k'\r\n[[equation]] # one\n'id' = \"e\"\n\"l\\u0065ft\" = {left}\nright = +2"
        );
        let report = check(&claims, &[certificate]).expect("a claim file");
        assert_eq!(report.claims[0].2, Outcome::Valid, "{left}");
    }
}

/// Numbers that are no decimal integers, dates and times are refused, and so is what is nested too deep.
#[test]
fn what_is_not_taken() {
    for value in ["1.5", "1e3", "0x1", "inf", "nan", "1979-05-27", "07:32:00"] {
        assert!(read(&format!("a = {value}")).is_err(), "{value}");
    }
    for depth in [33, 34, 100_000] {
        let nested = format!("a = {}{}", "[".repeat(depth), "]".repeat(depth));
        assert_eq!(read(&nested).is_ok(), depth <= 33, "{depth}");
        let path = format!("{} = 'x'", vec!["a"; depth].join("."));
        assert_eq!(read(&path).is_ok(), depth <= 33, "{depth}");
    }
    // Many keys take no longer than their number says.
    let many: Vec<String> = (0..200_000).map(|i| format!("k{i} = 'x'")).collect();
    assert!(read(&many.join("\n")).is_ok());
}
