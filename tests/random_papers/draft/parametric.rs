//! Functions and ranges of a parameter.

use super::{Claim, Known};
use crate::random_papers::choices::Choices;
use crate::random_papers::formula::{Tree, call, name, number, of, times};
use crate::random_papers::naive::{Q, int};

/// What a claim about the parameter w says.
#[derive(Clone, Debug)]
pub struct Parametric {
    /// The place of the scheme, and what its own parameter is for w = 1.
    pub scheme: (usize, Q),
    /// Of a function, what is said to be equal.
    pub sides: Option<[Tree; 2]>,
    /// Of a range, the value that is below 1, whether it may be 1, and the printed ends.
    pub range: Option<(Tree, bool, [Q; 2])>,
}

fn side(choices: &mut Choices) -> Tree {
    let w = || name("w");
    let absolute = || call("abs", &[w()]);
    let choice = [
        call("contraction", &[number(1, 1)]),
        call("norm", &[number(1, 1)]),
        call("displacement", &[]),
        call("max", &[number(1, 2), of('+', absolute(), number(1, 4))]),
        name("T"),
        times(w(), of('-', number(1, 1), w())),
        of('-', w(), times(w(), w())),
        call("max", &[w(), Tree::Minus(Box::new(w()))]),
        absolute(),
        of('+', times(number(2, 1), absolute()), number(1, 2)),
    ];
    choices.of(&choice)
}

pub fn claim(place: usize, choices: &mut Choices) -> Claim {
    let schemes = [
        ("s:w=w", (0, int(1))),
        ("t:w=w/2", (1, Q::new(1.into(), 2.into()))),
        ("alias", (0, int(1))),
    ];
    let (reference, scheme) = choices.of(&schemes);
    let fields = format!("locus = ''\nvariable = 'w'\nscheme = '{reference}'\n");
    let (kind, text, sides, range);
    if choices.once_in(2) {
        let [left, right] = [side(choices), side(choices)];
        kind = "function";
        text = format!("left = '{left}'\nright = '{right}'\n");
        (sides, range) = (Some([left, right]), None);
    } else {
        let value = side(choices);
        let at_most = choices.once_in(2);
        let from = choices.of(&["-0.25", "-0.25", "-0.75", "-0.24"]);
        let to = choices.of(&["0.25", "0.25", "0.75", "0.375"]);
        let closed = choices.of(&["", "closed = true\n", "closed = false\n"]);
        let relation = if at_most { "at_most" } else { "below" };
        kind = "range";
        text =
            format!("value = '{value}'\n{relation} = '1'\nfrom = '{from}'\nto = '{to}'\n{closed}");
        let thousandths = |text: &str| {
            let digits = format!("{:0<5}", text.trim_start_matches('-').replacen("0.", "", 1));
            let value = Q::new(digits.parse().expect("digits"), 100_000.into());
            if text.starts_with('-') { -value } else { value }
        };
        (sides, range) = (None, Some((value, at_most, [thousandths(from), thousandths(to)])));
    }
    let id = format!("{kind}-{place}");
    let text = format!("[[{kind}]]\nid = '{id}'\n{fields}{text}");
    Claim {
        doubtful: false,
        kind,
        id,
        text,
        known: Known::Parametric(Box::new(Parametric { scheme, sides, range })),
    }
}
