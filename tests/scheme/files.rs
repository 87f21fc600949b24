//! Schemes in files of one's own.

use crate::common::{mask, r};
use std::collections::BTreeMap;
use std::path::PathBuf;
use subcert::diagnostic::{Diagnostic, SourceText};
use subcert::exact::Rational;
use subcert::scheme::{SchemeDefinition, SchemeError, parse_scheme, read_scheme};

const CORNER: &str = "\
name = 'corner'
parameters.w = { default = '1/8' }
offset = '-1 + 1'

mask = [
    ['1 - cut', 'cut'],
    ['cut', '1 - cut'],
]

[let]
cut = '2*w'
";

fn write(name: &str, text: &[u8]) -> PathBuf {
    let path = std::env::temp_dir().join(format!("subcert-{}-{name}", std::process::id()));
    std::fs::write(&path, text).expect("a temporary file");
    path
}

#[test]
fn a_file_is_a_scheme_with_parameters() {
    let path = write("corner.toml", CORNER.as_bytes());
    let text = path.display().to_string();
    assert_eq!(mask(&text), mask("chaikin"));
    let wide = mask(&format!("{text}:w=1/16"));
    assert_eq!(wide.rules().rows()[0], [r(7, 8), r(1, 8)]);
    let tensor = parse_scheme(&format!("{text}:w=1/8 x chaikin")).unwrap();
    assert_eq!(tensor, parse_scheme("chaikin x chaikin").unwrap());
    let error = parse_scheme(&format!("{text}:v=1")).unwrap_err().to_string();
    let expected = format!("`{text}` has no parameter `v`; it has: w");
    assert!(error.contains(&expected), "{error}");
    std::fs::remove_file(path).unwrap();
}

/// Of the schemes of one file, as those of a claim file, one is named.
#[test]
fn one_of_several_schemes() {
    let text = "[[scheme]]\nname = 'one'\nparameters.w = { default = '1/8' }\n\
                mask = '[2*w, 1 - 2*w, 1 - 2*w, 2*w]'\n[[scheme]]\nname = 'two'\nmask = '[1, 4, 6, 4, 1]/8'\n\
                [[scheme]]\nname = 'three'\nuse = 'chaikin'\n[paper]\nkey = 'any'\n";
    let path = write("several.toml", text.as_bytes()).display().to_string();
    assert_eq!(mask(&format!("{path}:one")), mask("[1, 3, 3, 1]/4"));
    assert_eq!(mask(&format!("{path}:one:w=1/16")), mask("[1, 7, 7, 1]/8"));
    assert_eq!(mask(&format!("{path}:two")), mask("[1, 4, 6, 4, 1]/8"));
    for (of, part) in [
        ("", "this file has several schemes"),
        (":tow", "no scheme `tow`; did you mean `two`?"),
        (":three", "`three` stands for another scheme"),
        (":two:w=1", "no parameter `w`"),
    ] {
        let error = parse_scheme(&format!("{path}{of}")).unwrap_err().to_string();
        assert!(error.contains(part), "{of}: {error}");
    }
    std::fs::remove_file(path).unwrap();
}

/// The mask in one text is that of the command line, with names of the file in it.
#[test]
fn a_mask_in_one_text() {
    let text = "name = 'corner'\nparameters.w = { default = '1/8' }\nmask = '[cut, 1 - cut, 1 - cut, cut]'\n\
                [let]\ncut = '2*w'\n";
    let path = write("text.toml", text.as_bytes()).display().to_string();
    assert_eq!(mask(&path), mask("[1, 3, 3, 1]/4"));
    assert_eq!(mask(&format!("{path}:w=1/16")), mask("[1, 7, 7, 1]/8"));
    for (mask, part) in [
        ("'[1, 3, 3]/4'", "the coefficients of a mask of arity n"),
        ("'[1, 3, , 1]/4'", "a coefficient is missing"),
        ("'[1, 3, 3, 1]/4 + 1'", "a sum behind the list"),
        ("'[gone, 1 - gone, 1 - gone, gone]'", "unknown name `gone`"),
        ("\"[1, 3, 3, 1]\\u002f4\"", "without escapes"),
        ("'[1, 3, 3, 1]/4'\noffset = '1'", "has its offset"),
        ("'[1, 3, 3, 1]/4'\narity = '2'", "either `mask`, or"),
        ("'chaikin'", "not a list of coefficients"),
        ("''", "not a list of coefficients"),
        ("['1', '3']", "invalid type"),
        ("'[0.33, 0.33, 0.33]'", "write 100/33*[0.33, 0.33, 0.33]"),
    ] {
        let text = format!("name = 'x'\nmask = {mask}\n");
        let error = read(&text).and_then(|scheme| {
            let none = BTreeMap::<String, Rational>::new();
            scheme.mask(&none).map(|_| ()).map_err(|error| match error {
                SchemeError::File(error) => *error,
                other => panic!("{mask}: {other}"),
            })
        });
        let error = error.expect_err(mask);
        assert!(error.to_string().contains(part), "{mask}: {error}");
    }
}

#[test]
fn files_that_cannot_be_read() {
    let latin = write("latin.toml", b"name = 'caf\xe9'");
    let large = write("large.toml", &vec![b'#'; (1 << 20) + 1]);
    for (path, reason) in
        [(&latin, "it is not UTF-8 text"), (&large, "it is larger than 1048576 bytes")]
    {
        let error = parse_scheme(&path.display().to_string()).unwrap_err();
        assert!(
            matches!(&error, SchemeError::Unreadable { reason: found, .. } if found == reason),
            "{error}"
        );
        std::fs::remove_file(path).unwrap();
    }
}

/// An error in a file that another message names is one line, and no second drawing.
#[test]
fn an_error_in_a_file_within_another_message() {
    let diagnostic = refusal("name = 's'\nmask = [['1/0', '1'], ['1/2', '1/2']]\n");
    let error = SchemeError::File(Box::new(diagnostic));
    let said = error.to_string();
    assert!(said.contains("division by zero") && said.contains("(my.toml:2:"), "{said}");
    assert!(!said.contains("error:") && !said.contains('\n'), "{said}");
}

fn read(text: &str) -> Result<SchemeDefinition, Diagnostic> {
    read_scheme(&SourceText::new("my.toml", text))
}

/// The error of a text, wherever it shows: on reading, or when the mask is asked for.
fn refusal(text: &str) -> Diagnostic {
    match read(text).map(|definition| definition.mask::<Rational>(&[].into())) {
        Err(diagnostic) => diagnostic,
        Ok(Err(SchemeError::File(diagnostic))) => *diagnostic,
        Ok(other) => panic!("{text}: {other:?}"),
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "one table")]
fn errors_say_where_what_and_what_would_be_right() {
    // The text, the place that is underlined, what is said, the remedy.
    for (text, place, message, help) in [
        (
            "name = 'a'\nmask = [['1'], ['1']]\ncolour = 'red'",
            "colour",
            "unknown field `colour`",
            "",
        ),
        (
            "name = 'a'\nmask = [['1', 0x0], ['1', '0']]",
            "0x0",
            "invalid type: integer",
            "write it as a decimal number",
        ),
        (
            "name = 'a'\nmask = [[0.5, '1/2'], ['1', '0']]",
            "0.5",
            "invalid type: floating point",
            "write it in quotes, as '0.5'",
        ),
        (
            "name = 'a'\noffset = -1.0\nmask = [['1'], ['1']]",
            "-1.0",
            "invalid type: floating point",
            "write it in quotes",
        ),
        ("name = 'a", "", "invalid literal string", ""),
        (
            "name = 'a'",
            "'a'",
            "either `mask`, or `symbol`, or `arity`, `width` and `entry`",
            "mask = [['3/4', '1/4']",
        ),
        (
            "name = 'a'\nwidth = '2'\nmask = [['1'], ['1']]",
            "'a'",
            "either `mask`",
            "`entry` is one formula",
        ),
        ("name = 'a'\nmask = []", "[]", "at least one coefficient", "['3/4', '1/4']"),
        ("name = 'a'\nmask = [['1'], []]", "[]", "at least one coefficient", "['3/4', '1/4']"),
        (
            "name = 'a'\nmask = [['1', '2 w'], ['1', '0']]",
            "w",
            "expected an operator; a product is written with `*`",
            "",
        ),
        ("name = 'a'\nmask = [['1', 'w'], ['1', '0']]", "w", "unknown name `w`", ""),
        ("name = 'a'\nmask = [['1', '1/0'], ['1', '0']]", "0", "division by zero", ""),
        (
            "name = 'a'\nmask = [['1'], ['1/2']]",
            "'1/2'",
            "rule 1 sums to 1/2, not to 1: its excess is -1/2",
            "",
        ),
        (
            "name = 'a'\nmask = [['1', '0'], ['1']]",
            "'1'",
            "rule 1 has 1 coefficients, and rule 0 has 2",
            "",
        ),
        ("name = 'a'\nmask = [['1', '0']]", "'1', '0'", "a scheme of arity 1", ""),
        (
            "name = 'a'\nparameters.2w = {}\nmask = [['1'], ['1']]",
            "2w",
            "`2w` cannot be a name",
            "use a letter or `_`",
        ),
        (
            "name = 'a'\nmask = [['1'], ['1']]\nlet.'a b' = '1'",
            "'a b'",
            "`a b` cannot be a name",
            "use a letter",
        ),
        (
            "name = 'a'\noffset = '1/2'\nmask = [['1'], ['1']]",
            "'1/2'",
            "the offset is 1/2; it must be an integer from -10000 to 10000",
            "",
        ),
        (
            "name = 'a'\noffset = '20000'\nmask = [['1'], ['1']]",
            "'20000'",
            "the offset is 20000",
            "",
        ),
        (
            "name = 'a'\narity = '65'\nwidth = '1'\nentry = '1'",
            "'65'",
            "the arity is 65; it must be an integer from 2 to 64",
            "",
        ),
        (
            "name = 'a'\narity = '2'\nwidth = '0'\nentry = '1'",
            "'0'",
            "the width is 0; it must be an integer from 1 to 256",
            "",
        ),
        (
            "name = 'a'\narity = '2'\nwidth = '2'\nentry = 'alpha + r'",
            "'alpha + r'",
            "rule 1 sums to 3",
            "",
        ),
        ("name = 'a'\nlet.a = 'a'\nmask = [['a'], ['1']]", "a", "refers to itself", ""),
    ] {
        let error = refusal(text);
        assert_eq!(text.get(error.span.clone()), Some(place), "{text}\n{error}");
        assert!(error.message.contains(message), "{text}\n{error}");
        assert!(error.help.clone().unwrap_or_default().contains(help), "{text}\n{error}");
        let (line, column) = error.line_and_column();
        let start = text.lines().take(line - 1).map(|line| line.len() + 1).sum::<usize>();
        assert_eq!(start + column - 1, error.span.start, "{text}\n{error}");
        assert!(error.to_string().contains(&format!("my.toml:{line}:{column}")), "{error}");
    }
}

#[test]
fn places_count_characters_not_bytes() {
    let error = refusal("name = 'a'\n# ré\nmask = [['1', 'é + é'], ['1', '0']]");
    assert_eq!(error.line_and_column(), (3, 16));
    let error = refusal("name = 'é'\nmask = [['1', \"μ*ω 2\"], ['1', '0']]");
    assert_eq!(error.line_and_column(), (2, 20));
}

// Files without a name, empty ones and odd ones give an error that can be drawn.
#[test]
fn odd_files() {
    for text in [
        "",
        "\n\n",
        "mask = [['1'], ['1']]",
        "=",
        "[",
        "name = \"\u{0}\"",
        "\u{feff}name = 1",
        "a = \"é",
    ] {
        let error = read(text).unwrap_err();
        assert!(error.render(true).len() >= error.render(false).len());
        assert!(error.to_string().contains("my.toml"), "{error}");
    }
}

#[test]
fn parameters_without_value() {
    let definition = read("name = 'a'\nparameters.w = {}\nmask = [['w'], ['1']]").unwrap();
    let error = definition.mask::<Rational>(&[].into()).unwrap_err();
    assert_eq!(error.to_string(), "`a` needs its parameter `w`: write `a:w=…`");
    assert!(definition.mask(&[("w".to_owned(), r(1, 1))].into()).is_ok());
}

#[test]
fn whole_numbers_are_what_they_spell() {
    let read = |text: &str| {
        let source = SourceText::new("mine.toml", text.to_owned());
        read_scheme(&source).unwrap_or_else(|error| panic!("{error}"))
    };
    let spelled = read("name = 'a'\noffset = '-1'\nmask = [['1', '0'], ['3', '-2']]");
    let typed = read("name = 'a'\noffset = -1\nmask = [[1, 0], [+3, -2]]");
    let values = BTreeMap::new();
    let mask =
        |definition: &SchemeDefinition| definition.mask::<Rational>(&values).expect("a mask");
    assert_eq!(mask(&typed), mask(&spelled));
}
