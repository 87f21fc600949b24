//! Tables, printed from the exact values of other ones.
//!
//! The formula is read otherwise there, or a parameter is another; decimals are cut or rounded, with
//! slips.

use super::{Claim, Draft, Known};
use crate::random_papers::choices::Choices;
use crate::random_papers::program;
use num_traits::Signed;

/// Values of tables, and what each may be computed as instead.
const VALUES: [(&str, &[&str]); 12] = [
    (
        "delta*spread",
        &["contraction(c, order = forward)*spread", "spread*delta/10", "delta*spread^2*5"],
    ),
    ("norm(c)", &["norm(c, order = forward)", "norm(1)"]),
    ("sigma", &["displacement(terms = total)", "displacement(offset = 0)"]),
    ("delta", &["norm(c)", "contraction(c, order = forward)"]),
    ("sigma*spread*T^lev", &["displacement(terms = total)*spread*T^lev", "2*sigma*spread*T^lev"]),
    ("tensor(c)", &["tensor(c, suprema = joint)", "contraction(c)"]),
    ("mixed*spread", &["(contraction(1) + T)*spread", "mixed"]),
    ("levels(T, tol/100)", &["levels(T, tol/100, rounded = down)"]),
    ("rate*spread/2^lev", &["spread/3/2^lev", "rate*spread/2^lev/3"]),
    ("sum(h = 2..lev, scale) + sigma", &["sum(h = 2..lev, scale/2) + sigma"]),
    ("levels(1/2, tol/spread)", &["levels(1/2, tol/spread) + 1", "levels(1/2, 4*tol/spread)"]),
    ("spread/2^lev", &["spread/2^(lev + 1)", "4*spread/2^lev"]),
];

const HEADERS: [(&str, &[&str]); 6] = [
    ("c", &["1", "2", "3"]),
    ("lev", &["0", "1", "2", "5"]),
    ("spread", &["1/10", "0.25", "3"]),
    ("w", &["1/8", "-0.1", "3/16", "0"]),
    ("tol", &["1/10", "0.01"]),
    ("N", &["3", "4"]),
];

/// A table without its cells.
struct Blank {
    before: String,
    value: &'static str,
    tension: &'static str,
    shape: [usize; 2],
}

impl Blank {
    fn text(&self, value: &str, tension: &str, cells: &str) -> String {
        let before = self.before.replace("TENSION", tension);
        format!("[[table]]\n{before}value = '{value}'\ncells = {cells}\n")
    }

    /// Cells by their places.
    fn cells(&self, cell: impl Fn(usize) -> String) -> String {
        let row = |i| (0..self.shape[1]).map(|j| cell(i * self.shape[1] + j)).collect::<Vec<_>>();
        let rows: Vec<String> =
            (0..self.shape[0]).map(|i| format!("[{}]", row(i).join(", "))).collect();
        format!("[{}]", rows.join(", "))
    }
}

fn blank(id: &str, choices: &mut Choices) -> (Blank, &'static str) {
    let (value, others) = VALUES[choices.below(VALUES.len())];
    let hidden = if choices.once_in(2) { choices.of(others) } else { value };
    let axes: &[usize] = if value.starts_with("levels") { &[4, 3, 2, 5] } else { &[0, 1, 2, 3, 5] };
    let rows = choices.below(axes.len());
    let columns = (rows + 1 + choices.below(axes.len() - 1)) % axes.len();
    let sides = [("rows", HEADERS[axes[rows]]), ("columns", HEADERS[axes[columns]])];
    let product = if value.starts_with("tensor") || choices.once_in(6) { " x t:w=w" } else { "" };
    let mut before = format!("id = '{id}'\nlocus = ''\nscheme = 's:w=w{product}'\n");
    let (mut stated, mut unstated) = (Vec::new(), vec![("scale", "1/3")]);
    // A header is no other parameter.
    let is_header = |name: &str| sides.iter().any(|(_, (header, _))| *header == name);
    let defaults = [("lev", "1"), ("spread", "1/2"), ("c", "2"), ("tol", "1/10"), ("N", "4")];
    for (name, default) in defaults {
        if !is_header(name) {
            let list = if choices.once_in(6) { &mut unstated } else { &mut stated };
            list.push((name, default));
        }
    }
    if !is_header("w") {
        stated.push(("w", "TENSION"));
    }
    let ring = choices.of(&["", "", ", ring = 'ring:N=N'", ", offset = '0'"]);
    if value.starts_with("levels") {
        before += &format!("promise = {{ tolerance = 'tol', spread = 'spread'{ring} }}\n");
    } else if choices.once_in(2) {
        before += &format!("promise = {{ level = 'lev', spread = 'spread'{ring} }}\n");
    }
    for (side, (name, headers)) in sides {
        before +=
            &format!("{side} = {{ name = '{name}', values = ['{}'] }}\n", headers.join("', '"));
    }
    for (field, entries) in [("given", &stated), ("unstated", &unstated)] {
        let entries: Vec<String> =
            entries.iter().map(|(name, value)| format!("{name} = '{value}'")).collect();
        before += &format!("{field} = {{ {} }}\n", entries.join(", "));
    }
    let shape = sides.map(|(_, (_, headers))| headers.len());
    (Blank { before, value, tension: choices.of(&["1/8", "1/16", "-1/10"]), shape }, hidden)
}

pub fn claim(draft: &Draft, place: usize, choices: &mut Choices) -> Claim {
    let id = format!("table-{place}");
    let (blank, hidden) = blank(&id, choices);
    let tension = if choices.once_in(3) { "3/32" } else { blank.tension };
    let finished = |text| Claim {
        kind: "table",
        id: id.clone(),
        text,
        known: Known::Nothing,
        doubtful: false,
    };
    if choices.once_in(12) {
        return finished(blank.text(blank.value, blank.tension, "'lost'"));
    }
    let ones = blank.cells(|_| "'1'".to_owned());
    let source = format!("{}{}", draft.head(), blank.text(hidden, tension, &ones));
    let values = program::cells(&source, blank.shape[0] * blank.shape[1]);
    // Enough for few values to be printed as 0, which would leave a scale open.
    let (mut digits, cut) = (4 + choices.below(4), choices.once_in(3));
    if blank.value.starts_with("levels") {
        digits = 0;
    }
    let printed: Vec<String> = values
        .iter()
        .map(|value| {
            let text = slipped(decimal(value, digits, cut), choices);
            match choices.below(20) {
                19 => format!("{{ printed = 'h{text}', read = '{text}', note = 'h' }}"),
                _ => format!("'{text}'"),
            }
        })
        .collect();
    let cells = blank.cells(|place| printed[place].clone());
    finished(blank.text(blank.value, blank.tension, &cells))
}

/// A number with so many decimals, rounded or cut.
fn decimal(value: &crate::random_papers::naive::Q, places: usize, cut: bool) -> String {
    let units = value.abs()
        * crate::random_papers::naive::Q::from_integer(
            num_bigint::BigInt::from(10).pow(u32::try_from(places).expect("few")),
        );
    let half = crate::random_papers::naive::Q::new(1.into(), 2.into());
    let units = if cut { units.floor() } else { (units + half).floor() };
    let digits = format!("{:0>1$}", units.to_string(), places + 1);
    let (whole, rest) = digits.split_at(digits.len() - places);
    let sign = if value.is_negative() { "-" } else { "" };
    format!("{sign}{whole}{}{rest}", if places > 0 { "." } else { "" })
}

/// A slip of the pen, now and then.
fn slipped(mut text: String, choices: &mut Choices) -> String {
    let place = choices.below(text.len());
    match choices.below(12) {
        10 if text.as_bytes()[place].is_ascii_digit() => {
            text.replace_range(place..=place, choices.of(&["1", "4", "7", "9"]));
        }
        11 if !text.starts_with('-') => text = format!("{}{text}", choices.of(&["1", "3"])),
        _ => {}
    }
    text
}
