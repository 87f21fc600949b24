//! Certificates that rest on each other.

use std::fmt::Write as _;
use subcert_check::{Outcome, check};

const CLAIMS: &str = r#"
key = "together"
[[equation]]
id = "true"
left = '1'
right = '1'
[[theorem]]
id = "cites"
says = "the step is attained at a point"
proved_by = "THEOREMS 44"
proof_uses = ["true"]
[[table]]
id = "gives"
value = 'x*p'
unstated = ["p"]
columns = { name = "x", values = ['1.2345', '2.3457', '3.4561', '4.1'] }
cells = [['0.432075', '0.820995', '1.209635', '9.99999']]
[[table]]
id = "gives-more"
value = 'x*p + sum(i = 2..y, q)'
unstated = ["p", "q"]
rows = { name = "y", values = ['1', '2'] }
columns = { name = "x", values = ['1.2345', '2.3457', '3.4561'] }
cells = [['0.432075', '0.820995', '1.209635'], ['7.123457', '7.123457', '7.123457']]
[[table]]
id = "takes"
value = 'x*q'
unstated = ["q"]
columns = { name = "x", values = ['1.2345', '2.3457', '3.4561'] }
cells = [['0.432075', '0.820995', '1.209635']]
[[table]]
id = "takes-other"
value = 'x*q'
unstated = ["q"]
columns = { name = "x", values = ['1.2345', '2.3457', '3.4561'] }
cells = [['1.666575', '3.166695', '4.665735']]
"#;

const TRUE: &str = "equation true\n left 1\n right 1\n holds 1\n";

const CITES: &str =
    "theorem cites\n says the step is attained at a point\n proved-by THEOREMS 44\n proved\n";

/// The outcome for a claim, with these blocks, each in a certificate of its own.
fn outcome(blocks: &[&str], id: &str) -> Outcome {
    let texts: Vec<String> = blocks
        .iter()
        .map(|block| format!("subcert-certificate 4\npaper together\n{block}end 1\n"))
        .collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let report = check(CLAIMS, &texts).expect("a claim file");
    report.claims.into_iter().find(|(_, known, _)| known == id).expect("the claim").2
}

/// A table of three numbers with the value `x*q`, and `q` from the table `gives-more`.
fn takes(id: &str, q: &str, cells: [(&str, &str); 3]) -> String {
    let mut text = format!("table {id}\n value x*q\n recovered q {q} from gives-more\n");
    for (place, (printed, value)) in (1..).zip(cells) {
        let _ = writeln!(text, " cell 1 {place} \"{printed}\" {value} reproduced assuming q");
    }
    text + " family 3\n member : 3 3 3\n"
}

/// A table that gives p by its first row. Its second row says nothing of q, which it takes to be this number.
fn gives(q: &str, sums: [&str; 3]) -> String {
    let mut text = format!(
        "table gives-more\n value x*p + sum(i = 2..y, q)\n recovered p 7/20\n recovered q {q}\n"
    );
    let values = ["17283/40000", "164199/200000", "241927/200000"];
    for (place, (printed, value)) in
        (1..).zip(["0.432075", "0.820995", "1.209635"].iter().zip(values))
    {
        let _ = writeln!(text, " cell 1 {place} \"{printed}\" {value} reproduced assuming p");
    }
    for (place, sum) in (1..).zip(sums) {
        let _ = writeln!(text, " cell 2 {place} \"7.123457\" {sum} differs assuming p q");
    }
    text + " family 3\n member : 3 3 3\n"
}

/// What is certified twice is not shown, and proves nothing else.
#[test]
fn a_premise_that_is_certified_twice() {
    assert!(matches!(outcome(&[TRUE, CITES], "cites"), Outcome::Cited(_)));
    for blocks in
        [[TRUE, TRUE, CITES], [TRUE, CITES, TRUE], [CITES, TRUE, TRUE], [TRUE, CITES, CITES]]
    {
        assert!(!matches!(outcome(&blocks, "cites"), Outcome::Cited(_)));
    }
}

/// A table may not get any number from a table that does not need it.
#[test]
fn a_value_that_another_table_hands_over() {
    let first =
        [("0.432075", "17283/40000"), ("0.820995", "164199/200000"), ("1.209635", "241927/200000")];
    let second =
        [("1.666575", "66663/40000"), ("3.166695", "633339/200000"), ("4.665735", "933147/200000")];
    let sums = ["31283/40000", "234199/200000", "311927/200000"];
    let others = ["71283/40000", "434199/200000", "511927/200000"];
    let one = outcome(&[&gives("7/20", sums), &takes("takes", "7/20", first)], "takes");
    let other =
        outcome(&[&gives("27/20", others), &takes("takes-other", "27/20", second)], "takes-other");
    for outcome in [&one, &other] {
        assert!(matches!(outcome, Outcome::Invalid(..)), "{one:?} {other:?}");
    }
}
