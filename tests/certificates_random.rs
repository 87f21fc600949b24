//! Whatever the program finds in random claim files, the checker accepts.
//!
//! A table is printed from the exact values of another claim file, in which the formula is read
//! otherwise or a parameter is another, and its decimals are cut or rounded, with slips.

#![allow(missing_docs)]
#![allow(clippy::format_push_string, reason = "a claim file is written line by line")]

use proptest::prelude::*;
use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert_check::{Outcome, Reason, Stop, check};

/// What is chosen at random, one number after the other.
struct Choices(std::vec::IntoIter<usize>);

impl Choices {
    fn below(&mut self, count: usize) -> usize {
        self.0.next().unwrap_or(0) % count
    }

    fn of<'a>(&mut self, items: &[&'a str]) -> &'a str {
        items[self.below(items.len())]
    }
}

/// A table without its cells, and the headers of its rows and columns.
struct Blank {
    before: String,
    value: &'static str,
    tension: &'static str,
    rows: usize,
    columns: usize,
}

/// Values of tables, and what each may be computed as instead.
const VALUES: [(&str, &[&str]); 8] = [
    (
        "contraction(c)*beta",
        &[
            "contraction(c, order = forward)*beta",
            "beta*contraction(c)/10",
            "contraction(c)*beta^2*5",
        ],
    ),
    ("norm(c)", &["norm(c, order = forward)", "norm(1)"]),
    ("displacement()", &["displacement(terms = total)", "displacement(offset = 0)"]),
    ("delta", &["norm(c)", "contraction(c, order = forward)"]),
    ("bound", &["displacement(terms = total)*beta*delta^k/(1 - delta)", "2*bound"]),
    ("tensor(c)", &["tensor(c, suprema = joint)", "contraction(c)"]),
    ("mixed*beta", &["(contraction(c) + norm(1))*beta", "mixed"]),
    ("levels(delta, beta/100)", &["levels(delta, beta/100, rounded = down)"]),
];

const HEADERS: [(&str, &[&str]); 4] = [
    ("c", &["1", "2", "3"]),
    ("k", &["0", "1", "2", "5"]),
    ("beta", &["1/10", "0.25", "3"]),
    ("w", &["1/8", "-0.1", "3/16", "0"]),
];

/// Everything of the claim file but its tables.
fn head(choices: &mut Choices) -> String {
    let mut text = "key = 'random'\n[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n\
                    [define]\ndelta = 'contraction(c)'\nmixed = 'contraction(c)*norm(1)'\n\
                    bound = 'displacement()*beta*delta^k/(1 - delta)'\n[given]\nbeta = '1/10'\n\
                    [[alternative]]\nof = 'mixed'\nlabel = 'a sum'\n\
                    value = 'contraction(c) + norm(1)'\n"
        .to_owned();
    let (arity, width) = (2 + choices.below(2), 2 + choices.below(2));
    let rules = (0..arity).map(|_| {
        let mut rule: Vec<usize> = (0..width).map(|_| choices.below(5)).collect();
        rule[choices.below(width)] += 1;
        let total: usize = rule.iter().sum();
        let mut rule: Vec<String> = rule.iter().map(|a| format!("{a}/{total}")).collect();
        rule[0] += choices.of(&["", " + w", " - 1/2*w"]);
        let rest = rule[0].split_once(' ').map_or("", |(_, rest)| rest);
        let rest =
            if rest.starts_with('+') { rest.replace('+', "-") } else { rest.replace('-', "+") };
        rule[1] = format!("{} {rest}", rule[1]);
        format!("['{}']", rule.join("', '"))
    });
    let rules: Vec<String> = rules.collect();
    let offset = choices.of(&["0", "-1", "1"]);
    text += "[[scheme]]\nname = 's'\nparameters.w = { about = '' }\n";
    text + &format!("mask = [{}]\noffset = '{offset}'\n", rules.join(", "))
}

fn blank(choices: &mut Choices, id: usize) -> (Blank, &'static str) {
    let (value, others) = VALUES[choices.below(VALUES.len())];
    let hidden = if choices.below(2) == 0 { value } else { choices.of(others) };
    let product = if value.starts_with("tensor") { " x s:w=w" } else { "" };
    let (rows, columns) = (choices.below(4), choices.below(3));
    let columns = if columns < rows { columns } else { columns + 1 };
    let mut before = format!("id = 't{id}'\nlocus = ''\nscheme = 's:w=w{product}'\n");
    let mut stated = vec!["given = { k = '1'".to_owned()];
    let assumed = choices.below(4) == 0;
    if [rows, columns].iter().all(|&axis| HEADERS[axis].0 != "c") {
        if assumed { before += "unstated = { c = '1' }\n" } else { stated.push("c = '2'".into()) }
    }
    let promise = choices.of(&["", "promise = { level = 'k', spread = 'beta' }\n"]);
    before += if value.starts_with("levels") { "" } else { promise };
    for (side, axis) in [("rows", rows), ("columns", columns)] {
        let (name, headers) = HEADERS[axis];
        let headers = headers.join("', '");
        before += &format!("{side} = {{ name = '{name}', values = ['{headers}'] }}\n");
    }
    before += &format!("{}, w = 'TENSION' }}\n", stated.join(", "));
    let tension = choices.of(&["1/8", "1/16", "-1/10"]);
    let [rows, columns] = [rows, columns].map(|axis| HEADERS[axis].1.len());
    (Blank { before, value, tension, rows, columns }, hidden)
}

impl Blank {
    fn table(&self, value: &str, tension: &str, cell: impl Fn(usize, usize) -> String) -> String {
        let row = |i| (0..self.columns).map(|j| cell(i, j)).collect::<Vec<_>>().join("', '");
        let rows: Vec<String> = (0..self.rows).map(|i| format!("['{}']", row(i))).collect();
        let before = self.before.replace("TENSION", tension);
        format!("[[table]]\n{before}value = '{value}'\ncells = [{}]\n", rows.join(", "))
    }
}

/// A number with so many decimals, rounded or cut.
fn decimal(value: &Rational, places: u32, cut: bool) -> String {
    let units = value.abs() * Rational::from(10).pow(places.cast_signed());
    let units = if cut { units.floor() } else { (units + Rational::new(1, 2)).floor() };
    let digits = format!("{:0>1$}", units.to_string(), places as usize + 1);
    let (whole, rest) = digits.split_at(digits.len() - places as usize);
    let sign = if value.sign() < 0 { "-" } else { "" };
    format!("{sign}{whole}{}{rest}", if places > 0 { "." } else { "" })
}

/// A slip of the pen, now and then.
fn slipped(mut text: String, choices: &mut Choices) -> String {
    let place = choices.below(text.len());
    match choices.below(12) {
        0 if text.as_bytes()[place].is_ascii_digit() => {
            text.replace_range(place..=place, choices.of(&["1", "4", "7", "9"]));
        }
        1 if !text.starts_with('-') => text = format!("{}{text}", choices.of(&["1", "3"])),
        _ => {}
    }
    text
}

fn paper(text: &str) -> Paper {
    read_paper(&SourceText::new("random", text)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A claim file, with numbers that are those of another one.
fn claims(mut choices: Choices) -> String {
    let head = head(&mut choices);
    let mut text = head.clone();
    for id in 0..=choices.below(2) {
        let (blank, hidden) = blank(&mut choices, id);
        let tension = if choices.below(3) == 0 { "3/32" } else { blank.tension };
        let source = paper(&format!("{head}{}", blank.table(hidden, tension, |_, _| "1".into())));
        let found = audit(&source).unwrap_or_else(|error| panic!("{error}"));
        // Enough for no value to be printed as 0, which would leave a scale open.
        let (places, cut) = (4 + choices.below(4), choices.below(3) == 0);
        let places = if blank.value.starts_with("levels") { 0 } else { places };
        let mut printed = Vec::new();
        for finding in found.tables[0].cells.iter().flatten() {
            let exact = finding.exact.as_ref().and_then(|exact| exact.as_rational());
            let exact = exact.cloned().unwrap_or_else(|| Rational::new(1, 3));
            let places = u32::try_from(places).expect("few places");
            printed.push(slipped(decimal(&exact, places, cut), &mut choices));
        }
        let cell = |i: usize, j: usize| printed[i * blank.columns + j].clone();
        text += &blank.table(blank.value, blank.tension, cell);
    }
    let sides = ["contraction(1)", "norm(1)", "displacement()", "max(1/2, abs(w) + 1/4)"];
    text += &format!(
        "[[function]]\nid = 'f'\nlocus = ''\ntitle = ''\nvariable = 'w'\nscheme = 's:w=w'\n\
         left = '{}'\nright = '{}'\n[[range]]\nid = 'r'\nlocus = ''\ntitle = ''\nvariable = 'w'\n\
         scheme = 's:w=w'\nvalue = '{}'\n{} = '1'\nfrom = '-0.25'\nto = '0.375'\n",
        choices.of(&sides),
        choices.of(&sides),
        choices.of(&sides),
        choices.of(&["below", "at_most"]),
    );
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn what_is_found_is_accepted(numbers in prop::collection::vec(0_usize..1_000, 120)) {
        let text = claims(Choices(numbers.into_iter()));
        let paper = paper(&text);
        let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        let written = certificate(&audit);
        prop_assert!(written.omitted.is_empty(), "{:?}\n{text}", written.omitted);
        let report = check(&text, &[&written.text]).expect("a claim file");
        prop_assert!(report.broken.is_empty());
        for (_, id, outcome) in report.claims {
            // What is beyond a cap, a depth of 20,000, say, is left open.
            let accepted = match &outcome {
                Outcome::Incomplete(Some(why)) => {
                    matches!(why.reason, Reason::Stopped(Stop::Capped(_)))
                }
                outcome => *outcome == Outcome::Valid,
            };
            prop_assert!(accepted, "{outcome:?}\n{id}\n{text}\n{}", written.text);
        }
    }
}
