//! What a claim file must not say, or not so: nothing that it says is passed over.

use subcert_check::{Outcome, Reason, check};

const CLAIMS: &str = r#"
key = "claims"
[define]
twice = '2*w'
[[alternative]]
of = "twice"
label = "three times"
value = '3*w'
[[scheme]]
name = "corner"
parameters.w = { about = "tension", default = '1/4' }
mask = [['1 - w', 'w'], ['w', '1 - w']]
[[table]]
id = "t"
value = 'twice'
columns = { name = "w", values = ['2', '3'] }
given = { x = '1' }
promise = { level = 'x', spread = '1' }
scheme = "corner"
cells = [['4', '6']]
[[equation]]
id = "e"
symbols = ["x"]
hypotheses = ['x[0] = 2']
indices = [{ name = "i", from = '1', to = '2' }]
left = 'i*x[0]'
right = '2*i'
[[equation]]
id = "no"
left = '1'
right = '2'
[[theorem]]
id = "c"
says = "something"
proved_by = "THEOREMS 1"
proof_uses = ["e"]
[[range]]
id = "r"
variable = "w"
value = 'w^2'
below = '1'
from = '-1'
to = '1'
closed = false
"#;

const CERTIFICATE: &str = r#"subcert-certificate 4
paper claims
table t
  scheme corner
  value twice
  cell 1 1 "4" 4 confirmed
  cell 1 2 "6" 6 confirmed
  kept 1 1 1 1 1
  kept 1 2 1 1 1
equation e
  left i*x[0]
  right 2*i
  holds 2
equation no
  left 1
  right 2
  fails 1
  case = -1
theorem c
  says something
  proved-by THEOREMS 1
  proved
range r
  variable w
  value w^2
  below 1
  breaks -1 1
  signs + 0 - 0 +
  end from "-1" -1 equal
  end to "1" 1 equal
  exact
end 5
"#;

/// How many claims of a file are shown.
fn shown(claims: &str, certificate: &str) -> Option<usize> {
    let claims = check(claims, &[certificate]).ok()?.claims;
    let shown = |outcome: &Outcome| matches!(outcome, Outcome::Valid | Outcome::Cited(_));
    Some(claims.iter().filter(|(.., outcome)| shown(outcome)).count())
}

/// A text with other words in the place of these.
fn altered(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn nothing_that_a_claim_says_is_passed_over() {
    assert_eq!(shown(CLAIMS, CERTIFICATE), Some(5));
    for (from, to) in [
        ("['2', '3']", "['2', { printed = '3', read = '3', unit = 'm' }]"),
        ("values = ['2', '3']", "values = ['2', '3'], step = '1'"),
        ("given = { x = '1' }", "given = ['x']"),
        ("spread = '1'", "spread = '1', norm = 'l2'"),
        ("spread = '1'", "spread = '-1'"),
        ("hypotheses = ['x[0] = 2']", "hypotheses = 'x[0] = 2'"),
        ("indices = [{ name", "indices = [{ step = '2', name"),
        ("closed = false", "closed = 'no'"),
        ("closed = false", "closed = false\nat_most = '1'"),
        ("proof_uses = [\"e\"]", "proof_uses = [\"no\"]"),
        ("proof_uses = [\"e\"]", "proof_uses = \"no\""),
        ("proof_uses = [\"e\"]", "proof_uses = [[\"no\"]]"),
        ("proof_uses = [\"e\"]", "proof_uses = { e = \"no\" }"),
    ] {
        let claims = altered(CLAIMS, from, to);
        assert!(shown(&claims, CERTIFICATE).is_some_and(|shown| shown < 5), "{to}");
    }
    for (from, to) in [
        ("key = \"claims\"", "key = \"claims\"\nunits = 'm'"),
        ("[[equation]]\nid = \"no\"", "[[conjecture]]\nid = \"no\""),
        ("id = \"no\"", "id = \"e\""),
        ("label = \"three times\"", "label = \"three times\"\nif = 'w > 1'"),
        ("default = '1/4'", "default = '1/4', range = '0..1'"),
        ("mask = [['1 - w', 'w'],", "mask = [['1 - w', ['w']],"),
    ] {
        let claims = altered(CLAIMS, from, to);
        assert_eq!(shown(&claims, CERTIFICATE), None, "{to}");
    }
}

#[test]
fn a_cell_that_is_no_number_is_not_lost() {
    for text in ["+-6", "0,5", "1/0", ".", "6 6", "½½", "n/a", "----", "1e400000"] {
        let claims = altered(CLAIMS, "'6']]", &format!("'{text}']]"));
        let lost = altered(CERTIFICATE, "\"6\" 6 confirmed", "lost 6");
        let lost = altered(&lost, "  kept 1 2 1 1 1\n", "");
        assert_eq!(shown(&claims, &lost), Some(4), "{text}");
    }
}

/// A cell in which nothing is printed claims nothing: its line is neither that of a number nor that of a lost one.
#[test]
fn a_blank_cell_claims_nothing() {
    let kept = "  kept 1 2 1 1 1\n";
    let with = |cell: &str, line: &str, kept_too: bool| {
        let claims = altered(CLAIMS, "'6']]", &format!("{cell}]]"));
        let certificate = altered(CERTIFICATE, "\"6\" 6 confirmed", line);
        let certificate = if kept_too { certificate } else { altered(&certificate, kept, "") };
        let report = check(&claims, &[&certificate]).expect("a claim file");
        let valid = report
            .claims
            .iter()
            .any(|(.., id, outcome)| id == "t" && matches!(outcome, Outcome::Valid));
        valid.then(|| report.verdicts["t"].clone())
    };
    let said = Some("1 confirmed; promises: 1 kept".to_owned());
    for cell in ["''", "'—'", "' -- '", "{ printed = '6', read = '–', note = 'n' }"] {
        assert_eq!(with(cell, "blank 6", false), said, "{cell}");
        assert_eq!(with(cell, "lost 6", false), None, "{cell}");
    }
    assert_eq!(with("'6'", "blank 6", false), None);
    let read = "{ printed = '—', read = '6', note = 'n' }";
    assert_eq!(with(read, "\"—\" 6 confirmed", true), None);
}

/// A stated value beyond a cap leaves open the claims that need it, and no others.
#[test]
fn stated_values_beyond_a_cap() {
    for (given, twice, expected) in [
        ("2^9223372036854775808", "2*w", 5),
        ("10^200000", "2*w + 0*big", 4),
        ("binomial(10^7, 10001)", "2*w + 0*big", 4),
    ] {
        let claims = altered(CLAIMS, "[define]", &format!("[given]\nbig = '{given}'\n[define]"));
        let claims = altered(&claims, "twice = '2*w'", &format!("twice = '{twice}'"));
        assert_eq!(shown(&claims, CERTIFICATE), Some(expected), "{given}");
        let report = check(&claims, &[CERTIFICATE]).expect("a claim file");
        let wrong =
            report.claims.iter().any(|(.., outcome)| matches!(outcome, Outcome::Invalid(..)));
        assert!(!wrong, "{given}");
    }
}

/// Lists beside each other have equally many numbers: those of a table that is jagged have no certain places.
#[test]
fn lists_of_numbers_are_even() {
    let shown = |cells: &str, equals: &str| {
        let claims = format!(
            "key = 'p'\n[project]\nname = 'n'\n[[shipped]]\nid = 's'\nlocus = 'l'\ntitle = 't'\ntype = 'f64'\n\
             indices = ['k = 1..4']\n{equals}\ncells = {cells}\n"
        );
        let cells: Vec<String> = (1..=4).map(|k| format!(" cell {k} \"{k}\" nearest\n")).collect();
        let cells = cells.concat();
        let head = "subcert-certificate 4\nproject p\nshipped s\n bits 64\n";
        self::shown(&claims, &format!("{head}{cells} outcome nearest\nend 1\n"))
    };
    for even in ["['1', '2', '3', '4']", "[['1', '2'], ['3', '4']]", "[[['1', '2', '3', '4']]]"] {
        assert_eq!(shown(even, "equals = 'k'"), Some(1), "{even}");
        assert_eq!(shown("['1', '2', '3', '4']", &format!("equals_cells = {even}")), Some(1));
    }
    for uneven in
        ["[['1', '2', '3'], ['4']]", "[['1', '2', '3'], '4']", "[[['1'], '2'], ['3', '4']]"]
    {
        assert_eq!(shown(uneven, "equals = 'k'"), Some(0), "{uneven}");
        assert_eq!(shown("['1', '2', '3', '4']", &format!("equals_cells = {uneven}")), Some(0));
    }
}

/// A definition is read in one way.
#[test]
fn a_definition_is_read_once() {
    let claims = altered(
        CLAIMS,
        "value = '3*w'",
        "value = '3*w'\n[[alternative]]\nof = \"twice\"\nlabel = \"four times\"\nvalue = '4*w'",
    );
    let claims = altered(&claims, "['4', '6']", "['8', '12']");
    let read = |lines: &str| {
        let read = format!("value twice\n{lines}");
        let read = altered(CERTIFICATE, "value twice\n", &read);
        let read = altered(&read, "\"4\" 4 confirmed", "\"8\" 4 other-reading 8");
        let read = altered(&read, "\"6\" 6 confirmed", "\"12\" 6 other-reading 12");
        let family = "  kept 1 2 1 1 1\n  family 2\n  member : 0 0 0\n  member twice#1 : 0 0 0\n  member twice#2 : 2 2 2\n";
        altered(&read, "  kept 1 2 1 1 1\n", family)
    };
    let reason = |lines: &str| {
        let report = check(&claims, &[&read(lines)]).expect("a claim file");
        let outcome = report.claims.into_iter().find(|(_, id, _)| id == "t");
        let Some((.., Outcome::Invalid(_, rejection))) = outcome else { panic!("{outcome:?}") };
        rejection.reason
    };
    // That few digits are luck is the only thing that is wrong with one reading.
    assert_eq!(reason("  read definition twice 2\n"), Reason::Luck);
    let twice = reason("  read definition twice 1\n  read definition twice 2\n");
    assert_eq!(twice, Reason::NotInFamily("twice".to_owned()));
}

/// A table in which every cell says that its value is 1/2.
fn of_schemes(fields: &str, before: &str) -> (String, &'static str) {
    let claims = format!(
        "key = \"claims\"\n{before}[[table]]\nid = \"t\"\nvalue = 'contraction(1)'\n{fields}\n\
         cells = [['0.5']]\n"
    );
    (
        claims,
        "subcert-certificate 4\npaper claims\ntable t\n value contraction(1)\n \
              cell 1 1 \"0.5\" 1/2 confirmed\nend 1\n",
    )
}

#[test]
fn headers_that_are_schemes_are_these_alone() {
    let accepted = |fields: &str| {
        let (claims, certificate) = of_schemes(fields, "");
        shown(&claims, certificate) == Some(1)
    };
    for fields in [
        "columns = { schemes = ['chaikin'] }",
        "rows = { label = 'scheme', schemes = ['chaikin'] }\ncolumns = { name = 'w', values = ['1'] }",
        "columns = { schemes = [{ printed = 'Ch.', scheme = 'chaikin', note = 'so called' }] }",
    ] {
        assert!(accepted(fields), "{fields}");
    }
    for fields in [
        // Two schemes, or none.
        "scheme = 'chaikin'\ncolumns = { schemes = ['chaikin'] }",
        "rows = { schemes = ['chaikin'] }\ncolumns = { schemes = ['chaikin'] }",
        "columns = { schemes = [] }",
        // Numbers as well, or a name.
        "columns = { name = 'w', schemes = ['chaikin'] }",
        "columns = { name = 'w', values = ['1'], schemes = ['chaikin'] }",
        "columns = { values = ['1'], schemes = ['chaikin'] }",
        // Other fields, and none.
        "columns = { schemes = [{ printed = 'Ch.' }] }",
        "columns = { schemes = [{ printed = 'Ch.', scheme = 'chaikin', read = 'chaikin' }] }",
        "columns = { schemes = ['nowhere'] }",
    ] {
        assert!(!accepted(fields), "{fields}");
    }
}

#[test]
fn a_name_hands_on_the_parameters_that_have_a_place_in_its_use() {
    let schemes = "define = { half = 'w/2' }\n\
                   [[scheme]]\nname = 'corner'\nparameters.w = {}\n\
                   mask = [['1 - w', 'w'], ['w', '1 - w']]\n\
                   [[scheme]]\nname = 'mine'\nuse = 'corner:w=v'\n\
                   [[scheme]]\nname = 'yours'\nuse = 'mine:v=2*u'\n\
                   [[scheme]]\nname = 'fixed'\nuse = 'corner:w=1/4'\n\
                   [[scheme]]\nname = 'halved'\nuse = 'corner:w=half'\n\
                   [[scheme]]\nname = 'summed'\nuse = 'corner:w=sum(t = 1..2, t)/12'\n";
    let accepted = |reference: &str| {
        let fields = format!("columns = {{ schemes = ['{reference}'] }}");
        let (claims, certificate) = of_schemes(&fields, schemes);
        shown(&claims, certificate) == Some(1)
    };
    for reference in ["mine:v=1/4", "yours:u=1/8", "fixed", "summed"] {
        assert!(accepted(reference), "{reference}");
    }
    for reference in [
        "mine",
        "mine:w=1/4",
        "yours:v=1/4",
        "yours:u=1/4",
        "fixed:w=1/4",
        "halved:half=1/4",
        "summed:t=1",
        "mine:v=1/4,w=1/4",
        "mine:v=1/4,v=1/4",
    ] {
        assert!(!accepted(reference), "{reference}");
    }
}

#[test]
fn whole_numbers_are_the_texts_that_they_spell() {
    let with = |text: &str| shown(&altered(CLAIMS, "values = ['2', '3']", text), CERTIFICATE);
    assert_eq!(with("values = [2, +3]"), Some(5));
    let typed = altered(CLAIMS, "from = '-1'\nto = '1'", "from = -1\nto = 1");
    assert_eq!(shown(&typed, CERTIFICATE), Some(5));
    // Other numbers are not taken.
    for other in ["3.0", "03", "0x3", "3e0", "-", "3_"] {
        assert_eq!(with(&format!("values = [2, {other}]")), None, "{other}");
    }
}
