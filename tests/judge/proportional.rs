//! Proportionality is decided by the form of a formula, not by its values at some places.

use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, check};

/// The certificate of a table of this value at w = 1, with what is printed at w = 7/4; and whether
/// the checker accepts it.
fn of(value: &str) -> (String, bool) {
    let text = format!(
        "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n\
         [define]\nhalf = 'w/2'\nrest = 'w + half'\n\
         [[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nvalue = '{value}'\ngiven = {{ w = '1' }}\n\
         columns = {{ name = 'a', values = ['1.23456784', '2.77123416', '3.91345648', '5.11978124', '6.33712348'] }}\n\
         cells = [['2.16049372', '4.84965978', '6.84854884', '8.95961717', '11.08996609']]\n"
    );
    let paper = read_paper(&SourceText::new("k.toml", text.clone())).expect("a claim file");
    let audit = audit(&paper).expect("an audit");
    let written = certificate(&audit).text;
    let report = check(&text, &[&written]).expect("a claim file");
    let valid = report.claims.iter().all(|(_, _, outcome)| *outcome == Outcome::Valid);
    (written, valid)
}

#[test]
fn forms_that_are_proportional() {
    let forms = [
        "a*w",
        "abs(-w)*a",
        "2*a*(rest - half) - a*w",
        "max(a*w, half)",
        "w^2*a/(rest - half)",
        "sum(i = 1..2, a*w^i/w^i*half)",
        "a*w^-1*w^2",
    ];
    // The sum is no product with a written exponent, and so its degree is not known.
    for (form, scale) in forms.into_iter().zip([true, true, true, true, true, false, true]) {
        let (text, valid) = of(form);
        assert!(valid, "{form}\n{text}");
        assert_eq!(text.contains("scale w"), scale, "{form}\n{text}");
        assert_eq!(text.contains("read parameter w 7/4"), scale, "{form}\n{text}");
    }
}

#[test]
fn forms_that_are_not_shown_to_be_proportional() {
    // At w = 1, 2 and 3 all are a, 2a and 3a; two of them are so everywhere, but for no form that is known.
    for form in
        ["a*w + a*(w - 1)*(w - 2)*(w - 3)", "a*max(w, floor(w))", "a*floor(w)", "a*w + 0*rest^2"]
    {
        let (text, valid) = of(form);
        assert!(valid, "{form}\n{text}");
        assert!(!text.contains("scale w"), "{form}\n{text}");
    }
}
