//! Closed forms that are stated for some values of the parameter: 1/2 + 2|w| is the contraction of the 4-point scheme,
//! so that 1/2 + 2w is it for w ≥ 0 alone.

use super::{judged, paper};
use subcert::audit::FunctionVerdict;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;

fn text(ends: &str) -> String {
    format!(
        "[[function]]\nid = 'f'\nlocus = 'l'\nvariable = 'w'\nscheme = 'four-point:w=w'\n\
         left = '1/2 + 2*w'\nright = 'contraction(1)'\n{ends}\n"
    )
}

/// Where the printed form is smaller and the example; `None` where it holds.
fn found(ends: &str) -> Option<(String, String)> {
    let paper = paper(&text(ends));
    let audit = judged(&paper);
    match &audit.functions[0].verdict {
        FunctionVerdict::Holds => None,
        FunctionVerdict::Fails { larger, smaller, example } => {
            assert!(larger.is_empty() && smaller.contains(&example.at), "{ends}");
            Some((smaller.to_string(), example.at.to_string()))
        }
        FunctionVerdict::BeyondCap(cap) => panic!("{cap}"),
    }
}

#[test]
fn it_is_judged_where_it_is_stated() {
    let fails = |set: &str, at: &str| Some((set.to_owned(), at.to_owned()));
    let cases = [
        ("", fails("(-inf, 0)", "-1")),
        ("from = '0'", None),
        ("from = '0'\nto = '1/3'\nclosed = true", None),
        ("from = '0'\nto = 'cos(pi/5)'", None),
        ("to = '-1/2'\nclosed = true", fails("(-inf, -1/2]", "-3/2")),
        ("from = '-1'\nto = '1'", fails("(-1, 0)", "-1/2")),
    ];
    for (ends, expected) in cases {
        assert_eq!(found(ends), expected, "{ends}");
    }
}

/// 0.26 may stand for 0.25, so that what fails only in between is not held against the paper.
#[test]
fn a_rounded_end_is_no_counterexample() {
    let at = |to: &str| {
        let text = text(&format!("from = '0'\nto = '{to}'"));
        let paper = paper(&text.replace("left = '1/2 + 2*w'", "left = 'max(1/2 + 2*w, 4*w)'"));
        let audit = judged(&paper);
        (audit.functions[0].verdict == FunctionVerdict::Holds, audit.functions[0].above.to_string())
    };
    assert!(at("1/4").0 && at("0.25").0 && at("0.26").0);
    assert!(!at("0.27").0 && !at("0.3").0 && !at("13/50").0);
    assert_eq!(at("0.25").1, "(1/4, inf)");
}

#[test]
fn ends_that_are_none() {
    let refused = |ends: &str| {
        let source = SourceText::new("k.toml", format!("{}{}", super::HEAD, text(ends)));
        let error = read_paper(&source).expect_err("no paper");
        (error.message.clone(), error.source.text[error.span.clone()].to_owned())
    };
    let (message, place) = refused("from = '1'\nto = '0'");
    assert!(
        message.contains("the upper end 0 is not above") && place == "'0'",
        "{message}, {place}"
    );
    let (message, place) = refused("closed = true");
    assert!(message.contains("there are none") && place == "true", "{message}, {place}");
    assert!(refused("from = 'w'").0.contains("unknown name"));
}
