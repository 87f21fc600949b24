//! Verdicts: on the embedded papers against values found by other means, and on
//! small papers made for the purpose.

use crate::common::claims::{judged, paper};
use crate::common::papers::AUDITS;
use crate::common::r;
use subcert::audit::{
    CellFinding, Control, Direction, EquationVerdict, Kept, Missing, Reason, Slip, Sound, Verdict,
    Word, audit,
};
use subcert::cap::Cap;
use subcert::certificate::certificate;
use subcert::claim::{Kind, embedded, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::{Rational, RealCyclotomic, parse_decimal};
use subcert::report::{Background, explain_sheet};

fn exact(p: i64, q: i64) -> RealCyclotomic {
    Rational::new(p, q).into()
}

/// The verdicts on printed numbers said to equal x, the values of the header.
fn verdicts(values: &[&str], cells: &[&str]) -> Vec<Verdict> {
    let quoted = |texts: &[&str]| {
        texts.iter().map(|text| format!("'{text}'")).collect::<Vec<_>>().join(", ")
    };
    let text = format!(
        "[[table]]\nid = 't'\nlocus = 'T'\nvalue = 'x'\n\
         columns = {{ name = 'x', values = [{}] }}\ncells = [[{}]]\n",
        quoted(values),
        quoted(cells)
    );
    let paper = paper(&text);
    judged(&paper).tables[0].cells[0].iter().map(|cell| cell.verdict.clone()).collect()
}

#[test]
fn a_printed_number_against_an_exact_one() {
    let digit =
        |position, printed, correct| Verdict::Misprint(Slip::Digit { position, printed, correct });
    let cases: [(&str, &str, Verdict); 23] = [
        ("2/3", "0.667", Verdict::Confirmed),
        ("2/3", "0.666", Verdict::Rounding(Direction::Cut)),
        ("1/3", "0.334", Verdict::Rounding(Direction::Away)),
        ("1/3", "0.335", Verdict::Refuted),
        // Of two equally near decimals, either is right.
        ("0.0003125", "0.000312", Verdict::Confirmed),
        ("0.0003125", "0.000313", Verdict::Confirmed),
        ("1/7", "0.142957", digit(4, '9', '8')),
        ("1/7", "0.142587", Verdict::Misprint(Slip::Swap(4))),
        ("1/7", "1.428571", Verdict::Misprint(Slip::Exponent(1))),
        ("1/7", "1.428571e-3", Verdict::Misprint(Slip::Exponent(-2))),
        ("-1/7", "0.14286", Verdict::Misprint(Slip::Sign)),
        // Too few digits to tell a slip from luck.
        ("1/7", "0.153", Verdict::Refuted),
        ("1/7", "1.43", Verdict::Refuted),
        ("1/7", "-0.1429", Verdict::Refuted),
        ("1/7", "1.429", Verdict::Refuted),
        // A digit of the value cut: 0.142857|14… needs six digits.
        ("0.14285714", "0.14385", Verdict::Refuted),
        ("0.142857714", "0.143857", digit(3, '3', '2')),
        ("7/50", "0.160000", Verdict::Refuted),
        ("7/50", "0.014000", Verdict::Refuted),
        // Inexact computing gives another last digit too.
        ("1/7", "0.142859", Verdict::Refuted),
        // Two slips are no slip.
        ("1/7", "0.152867", Verdict::Refuted),
        ("0", "0", Verdict::Confirmed),
        ("7", "8", Verdict::Refuted),
    ];
    for (value, printed, expected) in cases {
        assert_eq!(verdicts(&[value], &[printed]), [expected], "{printed} for {value}");
    }
}

#[test]
fn a_number_of_the_next_column() {
    let expected = [
        Verdict::Misprint(Slip::Neighbour(0, 1)),
        Verdict::Confirmed,
        Verdict::Misprint(Slip::Neighbour(0, -1)),
    ];
    assert_eq!(verdicts(&["1/7", "1/11", "1/13"], &["0.090909", "0.090909", "0.090909"]), expected);
}

/// Random digits are not explained as slips of the exact value.
#[test]
fn slips_are_rarely_luck() {
    let mut state = 1_u64;
    let mut misprints = 0;
    let count = 4_000;
    let texts: Vec<String> = (0..count)
        .map(|_| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            format!("0.{:05}", 10_000 + (state >> 33) % 90_000)
        })
        .collect();
    for text in &texts {
        let verdict = &verdicts(&["0.271828182845904523536"], &[text])[0];
        misprints += usize::from(matches!(verdict, Verdict::Misprint(_)));
    }
    // 47 in 90,000 would be slips by chance alone, about 2 of these.
    assert!(misprints < 12, "{misprints} of {count}");
}

#[test]
fn every_embedded_paper_reads_and_counts() {
    assert_eq!(AUDITS.len(), embedded().len());
    let counts: Vec<(String, usize)> = AUDITS
        .iter()
        .map(|audit| {
            let printed = |cell: &CellFinding| cell.printed.is_some();
            let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
            (audit.paper.key.clone(), cells.filter(|cell| printed(cell)).count())
        })
        .collect();
    assert_eq!(
        counts,
        [
            ("mustafa2007-bajaj".to_owned(), 0),
            ("mustafa2007-ternary".to_owned(), 0),
            ("khan2019-newton".to_owned(), 54),
            ("mustafa2020-nary".to_owned(), 240),
            ("khan2022-doo-sabin".to_owned(), 200),
        ]
    );
}

/// Values computed once with another program (plain Python fractions).
#[test]
fn cells_of_the_papers() {
    let cell = |id: &str| -> CellFinding {
        let cells = AUDITS.iter().flat_map(|audit| &audit.tables).flat_map(|t| t.cells.iter());
        let cell = cells.flatten().find(|cell| cell.id == id);
        cell.unwrap_or_else(|| panic!("no cell {id}")).clone()
    };
    // (6.26) as printed: σ = |Σ τ| = 5/4, ξ = |Σ b| = 1/2 for the 4-point scheme.
    let four_point = cell("khan2019-newton:table-1:2:1");
    assert_eq!(four_point.exact, Some(exact(1, 80)));
    // With ξ = Σ|b| = 21/32 it is 5/4 · 1/100 · 21/11, cut after six places.
    assert_eq!(four_point.verdict, Verdict::OtherReading);
    assert_eq!(four_point.as_read.map(|read| read.value), Some(exact(21, 880)));
    // σ = Σ|τ| = 87/64, T_1 = 21/32: 87/64 · 1/100 · (21/32)/(1 − 21/32), or less.
    let Some(Sound::Bound(sound)) = &four_point.sound else { panic!("{:?}", four_point.sound) };
    assert!(*sound <= r(87 * 21, 64 * 100 * 11) && *sound > r(1, 80), "{sound}");
    assert_eq!(cell("khan2019-newton:table-1:1:4").verdict, Verdict::Confirmed);
    assert_eq!(cell("khan2019-newton:table-3:1:1").verdict, Verdict::OtherReading);
    let quinary = cell("mustafa2020-nary:table-13:1:4");
    assert_eq!(quinary.exact, Some(parse_decimal("0.05179648").expect("a decimal").value().into()));
    assert_eq!(quinary.verdict, Verdict::Confirmed);
    let surface = cell("mustafa2020-nary:table-15:1:2");
    assert_eq!(surface.exact, Some(parse_decimal("0.33789184").expect("a decimal").value().into()));
    assert_eq!(surface.verdict, Verdict::OtherReading);
    let lost = cell("mustafa2020-nary:table-5:1:1");
    assert_eq!(lost.verdict, Verdict::NotCheckable(Missing::Cell));
    assert_eq!(lost.exact, Some(exact(143, 324)));
    let depth = cell("mustafa2020-nary:table-2:1:1");
    assert_eq!(depth.printed.as_deref(), Some("11"));
    assert_eq!(depth.verdict, Verdict::Reproduced);
    assert_eq!(depth.assumed, [("tau".to_owned(), r(1, 10)), ("w".to_owned(), r(39, 2000))]);
    assert_eq!(depth.exact, Some(exact(12, 1)));
    assert_eq!(depth.verdict_if_assumed, None);
    let differs = depth.as_read.map(|read| read.differs()).expect("a reading");
    assert!(differs.starts_with("depths rounded to the nearest"), "{differs}");
    // n = 5 and c = 1 by hand, from the weights 1/2, near, far, far, near of a rule.
    let weight = |j| {
        let cosine = RealCyclotomic::cosine(&r(j, 5)).expect("a small conductor");
        &RealCyclotomic::from(r(3, 20)) + &(&RealCyclotomic::from(r(1, 10)) * &cosine)
    };
    let (half, near, far) = (RealCyclotomic::from(r(1, 2)), weight(1), weight(2));
    let g = [&half - &near, RealCyclotomic::from(0), &far - &near, &far - &near];
    let h = [&near - &half, &far - &half, &far - &half, &near - &half];
    let largest = |t: &[RealCyclotomic; 4]| {
        let sum = |class: usize| &t[class].abs() + &t[class + 2].abs();
        sum(0).max(sum(1))
    };
    let product = &largest(&g) * &largest(&h);
    assert_eq!(cell("khan2022-doo-sabin:table-1:3:1").exact, Some(product));
}

#[test]
fn equations_of_the_papers() {
    for audit in &*AUDITS {
        for finding in &audit.equations {
            let expected = match finding.id.as_str() {
                "khan2019-newton:eq-2.1"
                | "khan2019-newton:eq-2.4"
                | "khan2019-newton:eq-2.5"
                | "khan2019-newton:eq-3.8-derivation"
                | "khan2019-newton:eq-3.18-values"
                | "khan2019-newton:eq-3.19"
                | "khan2019-newton:eq-4.24"
                | "khan2019-newton:lemma-6.1-b"
                | "khan2019-newton:lemma-6.1-tau"
                | "khan2019-newton:remark-4.1-size"
                | "khan2022-doo-sabin:eq-9"
                | "khan2022-doo-sabin:eq-14"
                | "khan2022-doo-sabin:eq-15"
                | "khan2022-doo-sabin:eq-16"
                | "mustafa2007-ternary:bilinear-weights"
                | "mustafa2007-ternary:eq-3.4b"
                | "mustafa2007-ternary:eq-3.8"
                | "khan2022-doo-sabin:eq-24"
                | "khan2022-doo-sabin:eq-30"
                | "khan2022-doo-sabin:eq-45"
                | "khan2022-doo-sabin:eq-53"
                | "khan2022-doo-sabin:eq-54-second"
                | "khan2022-doo-sabin:eq-58"
                | "khan2022-doo-sabin:eq-62"
                | "khan2022-doo-sabin:eq-81"
                | "khan2022-doo-sabin:eq-83"
                | "khan2022-doo-sabin:eq-84-h"
                | "mustafa2020-nary:eq-4-six-point"
                | "mustafa2020-nary:eq-4-ternary"
                | "mustafa2020-nary:eq-4-quaternary"
                | "mustafa2020-nary:eq-4-quinary"
                | "mustafa2020-nary:theorem-7-eta"
                | "mustafa2020-nary:theorem-9-proof"
                | "mustafa2020-nary:eq-26-six-point"
                | "mustafa2020-nary:eq-26-ternary"
                | "mustafa2020-nary:eq-26-quaternary"
                | "mustafa2020-nary:eq-26-quinary"
                | "mustafa2007-bajaj:eq-9"
                | "mustafa2007-bajaj:eq-11"
                | "mustafa2007-bajaj:eq-24"
                | "mustafa2007-bajaj:eq-25"
                | "mustafa2020-nary:eq-27-ones"
                | "mustafa2020-nary:eq-28-window"
                | "mustafa2020-nary:example-10-falls"
                | "khan2022-doo-sabin:corollary-2-window"
                | "mustafa2007-bajaj:eq-26"
                | "mustafa2007-bajaj:eq-9-any-valence"
                | "mustafa2007-bajaj:eq-11-any-valence"
                | "mustafa2007-bajaj:eq-24-any-valence"
                | "mustafa2007-bajaj:eq-27-first"
                | "mustafa2007-bajaj:eq-28-centre"
                | "mustafa2007-bajaj:eq-30-centre"
                | "mustafa2007-bajaj:eq-30-valence-7"
                | "mustafa2007-bajaj:eq-35-level-0"
                | "mustafa2007-bajaj:eq-36-level-0" => "fails",
                "khan2019-newton:remark-3.1-ko-6" => "not-checkable",
                _ => "holds",
            };
            assert_eq!(finding.verdict.word().name(), expected, "{}", finding.id);
        }
    }
}

/// Cosines in tables: values, rounding, and depths by irrational ratios.
#[test]
fn tables_of_irrational_numbers() {
    let table = |value: &str, promise: &str, header: &str, cells: &str| {
        let text = format!(
            "[[table]]\nid = 't'\nlocus = 'T'\nvalue = '{value}'\n{promise}\n\
             columns = {{ name = 'n', values = [{header}] }}\ncells = [[{cells}]]\n"
        );
        let paper = paper(&text);
        let audit = judged(&paper);
        audit.tables[0].cells[0].iter().map(|cell| cell.verdict.clone()).collect::<Vec<_>>()
    };
    // 2cos(2π/n): 0.6180339…, 1.2469796…, 1.5320888….
    assert_eq!(
        table(
            "2*cos(2*pi/n)",
            "",
            "'5', '5', '7', '9'",
            "'0.61803', '0.6181', '1.247', '1.5302888'"
        ),
        [
            Verdict::Confirmed,
            Verdict::Rounding(Direction::Away),
            Verdict::Confirmed,
            Verdict::Misprint(Slip::Swap(4)),
        ]
    );
    // (2cos 72°)^9 = 0.01315…, so that nine levels reach 0.0132, and eight do not.
    assert_eq!(
        table(
            "levels(2*cos(2*pi/5), 0.0132)",
            "promise = { tolerance = '0.0132', spread = '1' }",
            "'1', '2', '3'",
            "'9', '8', '10'"
        ),
        [Verdict::Confirmed, Verdict::Rounding(Direction::DepthDown), Verdict::Refuted]
    );
}

/// Every number and every sign of every equation that holds matters: change one
/// left side, and the equation fails by what was changed.
#[test]
fn a_changed_coefficient_is_caught() {
    for embedded in embedded() {
        let source = SourceText::new(embedded.key, embedded.text);
        let mut paper = read_paper(&source).expect("an embedded paper");
        paper.tables.clear();
        paper.theorems.clear();
        let holding: Vec<String> = judged(&paper)
            .equations
            .iter()
            .filter(|finding| matches!(finding.verdict, EquationVerdict::Holds { .. }))
            .map(|finding| finding.equation.id.clone())
            .collect();
        for id in holding {
            let start = embedded.text.find(&format!("id = \"{id}\"")).expect("the equation");
            let left = start + embedded.text[start..].find("left = ").expect("its left side");
            let quotes = left + embedded.text[left..].find('\'').expect("a formula");
            let formula = embedded.text[quotes..].trim_start_matches('\'');
            let quote = embedded.text.len() - formula.len();
            let mut text = embedded.text.to_owned();
            text.insert_str(quote, "1/1000 + ");
            let mut paper = read_paper(&SourceText::new("changed", text)).expect("still a paper");
            paper.tables.clear();
            paper.theorems.clear();
            paper.equations.retain(|equation| equation.id == id);
            let audit = judged(&paper);
            let finding = audit.equations.iter().find(|finding| finding.equation.id == id);
            let EquationVerdict::Fails { failures, .. } = &finding.expect("the equation").verdict
            else {
                panic!("{id} still holds");
            };
            assert!(!failures.is_empty(), "{id}");
            assert_eq!(failures[0].difference().to_string(), "1/1000", "{id}");
        }
    }
}

/// 7.5 levels are none, and what they would promise is not decided.
#[test]
fn a_depth_that_is_no_integer_promises_nothing() {
    let text = "[[table]]\nid = 't'\nlocus = 'T'\nscheme = 'chaikin'\n\
                value = 'levels(contraction(1), epsilon, rounded = up)'\n\
                promise = { tolerance = 'epsilon', spread = '1' }\n\
                columns = { name = 'epsilon', values = ['1/100', '1/100'] }\n\
                cells = [['7.5', '7']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let cells = &audit.tables[0].cells[0];
    assert!(matches!(cells[0].kept, Some(Kept::Open(_))), "{:?}", cells[0].kept);
    assert_eq!(cells[1].kept, Some(Kept::Yes));
    // The certificate has a line for 7, and none for 15/2.
    let certificate = certificate(&audit).text;
    assert!(!certificate.contains("kept 1 1") && certificate.contains("kept 1 2"), "{certificate}");
}

#[test]
fn a_depth_without_a_value_is_refuted_and_says_why() {
    let text = "[[table]]\nid = 't'\nlocus = 'T'\nscheme = 'four-point:w=w'\n\
                value = 'levels(contraction(1), epsilon, rounded = up)'\n\
                promise = { tolerance = 'epsilon', spread = '1' }\n\
                rows = { name = 'w', values = ['1/16', '1/4', '1/2'] }\n\
                columns = { name = 'epsilon', values = ['1/100'] }\n\
                cells = [['10'], ['10'], ['10']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let cells = &audit.tables[0].cells;
    // (5/8)^10 < 1/100 < (5/8)^9.
    assert_eq!(cells[0][0].verdict, Verdict::Confirmed);
    assert_eq!(cells[1][0].verdict, Verdict::Refuted);
    assert_eq!(cells[1][0].exact, None);
    assert!(cells[1][0].undefined.as_ref().is_some_and(|why| why.contains("not below 1")));
    // T_1 = 1 at w = 1/4, but T_2 < 1; at w = 1/2 no T_c is.
    assert!(matches!(cells[1][0].sound, Some(Sound::Depth { .. })));
    assert!(matches!(cells[2][0].sound, Some(Sound::None(_))));
}

#[test]
fn a_name_for_a_scheme_sees_the_parameters_where_it_is_used() {
    let text = "[[scheme]]\nname = 'mine'\nuse = 'four-point:w=w/2'\n\
                [[table]]\nid = 't'\nlocus = 'T'\nscheme = 'mine'\nvalue = 'contraction(1)'\n\
                columns = { name = 'w', values = ['1/8', '1/4'] }\ncells = [['0.625', '0.75']]\n";
    let verdict = |text| {
        let paper = paper(text);
        judged(&paper).tally(&[Kind::Table]).of(Word::Confirmed)
    };
    // T_1 = 1/2 + 2w for the tension w, here half of the header.
    assert_eq!(verdict(text), 2);
}

/// A value that the program cannot reach says nothing about the printed number.
/// A definition that says nothing of the column may depend on it by the scheme.
#[test]
fn a_definition_follows_the_scheme_of_its_column() {
    let paper = paper(
        "[define]\nT = 'contraction(1)'\n[[table]]\nid = 't'\nlocus = 'T'\n\
         scheme = 'corner-cutting:w=w'\nvalue = 'T'\n\
         columns = { name = 'w', values = ['1/4', '1/8', '3/8'] }\n\
         cells = [['0.5', '0.75', '0.75']]\n[[scheme]]\nname = 'corner-cutting'\n\
         parameters.w = {}\nmask = [['1 - w', 'w'], ['w', '1 - w']]\n",
    );
    let audit = judged(&paper);
    // |1 − 2w| and 2w.
    let values = audit.tables[0].cells[0].iter().map(|cell| cell.exact.clone());
    let expected = [exact(1, 2), exact(3, 4), exact(3, 4)].map(Some);
    assert_eq!(values.collect::<Vec<_>>(), expected);
}

/// A column's header goes before a value that the paper states elsewhere, in definitions too.
#[test]
fn a_definition_follows_the_header_of_its_column() {
    for given in ["[given]\nbeta = '1'\n", ""] {
        let paper = paper(&format!(
            "{given}[define]\nE = '2*beta'\n[[table]]\nid = 't'\nlocus = 'T'\nvalue = 'E'\n\
             unstated = {{ gamma = '5' }}\ncolumns = {{ name = 'beta', values = ['1', '3'] }}\n\
             cells = [['2', '6']]\n"
        ));
        let audit = judged(&paper);
        let values = audit.tables[0].cells[0].iter().map(|cell| cell.exact.clone());
        assert_eq!(values.collect::<Vec<_>>(), [exact(2, 1), exact(6, 1)].map(Some));
    }
}

/// What is wrong in a definition is underlined there, and the claim that needs it is named.
#[test]
fn an_error_in_a_definition_is_shown_there() {
    let paper = paper(
        "[define]\nbound = '2*inner'\ninner = '1 + nobody'\n[[table]]\nid = 't'\nlocus = 'T'\n\
         value = 'bound + x'\ncolumns = { name = 'x', values = ['1'] }\ncells = [['1']]\n",
    );
    let error = audit(&paper).expect_err("an unknown name");
    assert_eq!(&error.source.text[error.span.clone()], "nobody");
    assert_eq!(error.help.as_deref(), Some("this definition is needed for `bound + x`"));
}

#[test]
fn a_value_beyond_the_caps_is_not_checkable() {
    let text = "[[table]]\nid = 't'\nlocus = 'T'\nscheme = 'chaikin'\n\
                value = 'contraction(c)'\n\
                columns = { name = 'c', values = ['1', '300'] }\n\
                cells = [['0.5', '9.3e-10']]\n\
                [[table]]\nid = 'u'\nlocus = 'U'\nscheme = 'chaikin'\n\
                value = 'tau*contraction(c)'\nunstated = { tau = '1/10' }\n\
                columns = { name = 'c', values = ['300'] }\ncells = [['9.3e-11']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let [known, beyond] = &audit.tables[0].cells[0][..] else { panic!("two cells") };
    assert_eq!(known.verdict, Verdict::Confirmed);
    let Verdict::NotCheckable(Missing::Capacity(cap)) = &beyond.verdict else {
        panic!("{:?}", beyond.verdict)
    };
    assert_eq!(*cap, Cap::new("the number 300 of levels", 256));
    let unstated = &audit.tables[1].cells[0][0];
    let missing = Missing::Parameters(vec!["tau".to_owned()]);
    assert_eq!(unstated.verdict, Verdict::NotCheckable(missing));
    assert!(matches!(
        unstated.verdict_if_assumed,
        Some(Verdict::NotCheckable(Missing::Capacity(_)))
    ));
}

/// (1/2)^3 > 1/10 ≥ (1/2)^4: a depth that the paper's own definition rounds down
/// is confirmed, and does not keep its promise.
#[test]
fn a_depth_that_is_defined_rounded_down_keeps_no_promise() {
    let text = "[[table]]\nid = 't'\nlocus = 'T'\nscheme = 'chaikin'\n\
                value = 'levels(contraction(1), epsilon, rounded = down)'\n\
                promise = { tolerance = 'epsilon', spread = 'beta' }\n\
                unstated = { beta = '1/7' }\n\
                columns = { name = 'epsilon', values = ['1/10', '1/8'] }\ncells = [['3', '3']]\n";
    let paper = paper(text);
    let audit = judged(&paper);
    let [short, enough] = &audit.tables[0].cells[0][..] else { panic!("two cells") };
    assert_eq!(short.verdict, Verdict::Confirmed);
    assert_eq!(short.kept_by_formula, Some(false));
    assert_eq!(enough.kept_by_formula, Some(true));
    // The value needs no spread, so none is assumed for the sound depth either.
    assert_eq!(short.sound, Some(Sound::None(Reason::Unstated("beta".to_owned()))));
    assert_eq!(short.kept_by_sound, None);
}

/// The path whose distances are 2, 17/8, 1/2, 17/32, …: the first is within 2, but the next is not.
#[test]
fn a_promise_of_a_depth_is_for_all_later_levels() {
    let table = |id: &str, promise: &str, cells: &str| {
        format!(
            "[[table]]\nid = '{id}'\nlocus = 'T'\nvalue = '0'\n\
             promise = {{ {promise}, spread = '1', ring = 'path' }}\n\
             columns = {{ name = 'x', values = ['1', '2'] }}\ncells = [[{cells}]]\n"
        )
    };
    let path = "[[scheme]]\nname = 'path'\norbits = { a = '1', b = '1', c = '1' }\n\
                edges = [['a', 'b'], ['b', 'c']]\n[scheme.weights.a]\na = '1'\n\
                [scheme.weights.b]\na = '1'\nb = '-2'\nc = '2'\n\
                [scheme.weights.c]\na = '7/8'\nb = '-15/8'\nc = '2'\n";
    let depths = table("depths", "tolerance = '2'", "'0', '2'");
    let bounds = table("bounds", "level = '0'", "'2', '1.9'");
    let paper = paper(&[path, &depths, &bounds].concat());
    let audit = judged(&paper);
    let kept = |table: usize, cell: usize| audit.tables[table].cells[0][cell].kept.as_ref();
    assert!(matches!(kept(0, 0), Some(Kept::No(broken)) if broken.level == 1), "{:?}", kept(0, 0));
    assert_eq!((kept(0, 1), kept(1, 0)), (Some(&Kept::Yes), Some(&Kept::Yes)));
    assert!(matches!(kept(1, 1), Some(Kept::No(broken)) if broken.level == 0));
}

/// Chaikin's polygons are up to 2^−k/2 from their limit, its nets and the points of a
/// square face 2^−k.
#[test]
fn promises_are_kept_or_broken_by_control_data() {
    let table = |id: &str, scheme: &str, promise: &str, cells: &str| {
        format!(
            "[[table]]\nid = '{id}'\nlocus = 'T'\n{scheme}\nvalue = '1'\n\
             promise = {{ {promise}, spread = '3' }}\n\
             columns = {{ name = 'x', values = ['1', '1', '1'] }}\ncells = [[{cells}]]\n"
        )
    };
    let text = [
        table("depths", "scheme = 'chaikin'", "tolerance = '3/8'", "'2', '1', '1.5'"),
        table("bounds", "scheme = 'chaikin'", "level = '3'", "'0.1875', '0.1874', '1'"),
        table("nets", "scheme = 'chaikin x chaikin'", "tolerance = '3/8'", "'3', '2', '200'"),
        table("rings", "", "tolerance = '3/8', ring = 'doo-sabin:n=4'", "'3', '2', '200'"),
    ]
    .concat();
    let paper = paper(&text);
    let audit = judged(&paper);
    let cells = |table: usize| &audit.tables[table].cells[0];
    for table in 0..4 {
        assert_eq!(cells(table)[0].kept, Some(Kept::Yes), "{}", cells(table)[0].id);
        let Some(Kept::No(broken)) = &cells(table)[1].kept else {
            panic!("{}: {:?}", cells(table)[1].id, cells(table)[1].kept)
        };
        let distance = [exact(3, 4), exact(3, 16), exact(3, 4), exact(3, 4)];
        assert_eq!(broken.distance, distance[table]);
        assert_eq!(broken.spread, Rational::from(3));
        match &broken.attained.control {
            Control::Polygon(polygon) => assert_eq!(polygon.points, [0, 1]),
            Control::Net { rows, .. } => {
                let ascends = |(i, row): (i64, &Vec<i64>)| (i..).zip(row).all(|(sum, x)| sum == *x);
                assert!((0..).zip(rows).all(ascends), "{rows:?}");
            }
            Control::Points(points) => {
                assert!(points.iter().map(|(_, height)| height).eq(&[2, 1, 0, 1]));
            }
        }
    }
    assert!(matches!(&cells(0)[2].kept, Some(Kept::Open(Reason::NoLevel | Reason::LevelOf(..)))));
    assert_eq!(cells(1)[2].kept, Some(Kept::Yes));
    let counts = audit.promise_counts();
    assert_eq!((counts.kept, counts.broken, counts.open, counts.all()), (7, 4, 1, 12));
}

/// The identity fails in the last of many cases: the search for a mend looks there
/// first, and the mask is made once.
#[test]
fn many_cases_are_compared_in_good_time() {
    let sum = " + 0*1".repeat(40);
    let text = format!(
        "[[equation]]\nid = 'e'\nlocus = 'l'\nscheme = 'newton:j=8,n=8'\nsymbols = ['x']\n\
         indices = [{{ name = 'i', from = '1', to = '1000' }}]\n\
         left = 'mask(1, 1)*x'\n\
         right = 'mask(1, 1)*x + (max(i, 999) - 999)*x{sum}'\n"
    );
    let paper = paper(&text);
    let audit = judged(&paper);
    let EquationVerdict::Fails { cases, failures, mends } = &audit.equations[0].verdict else {
        panic!("{:?}", audit.equations[0].verdict)
    };
    assert_eq!((*cases, failures.len()), (1000, 1));
    assert_eq!(failures[0].at, "i = 1000");
    assert_eq!(mends.len(), 0, "{mends:?}");
}

/// A printed decimal that is the exact value, rounded or cut, is told as such, and no change of a symbol is proposed: 7/99 is 0.0707….
#[test]
fn equations_with_rounded_decimals_are_told_as_such() {
    let equation = |left: &str, right: &str| {
        let text = format!(
            "[[equation]]\nid = 'e'\nlocus = 'l'\nscheme = 'ternary-four-point:mu=1/11'\n\
             indices = [{{ name = 'i', values = ['0', '1', '2', '3'] }}]\nleft = {left}\nright = '{right}'\n"
        );
        let paper = paper(&text);
        let audit = judged(&paper);
        let finding = &audit.equations[0];
        let EquationVerdict::Fails { mends, .. } = &finding.verdict else { panic!("{finding:?}") };
        let sheet =
            explain_sheet(std::slice::from_ref(&audit), "k:e", Background::default(), false);
        let words = sheet.expect("a report").to_markdown();
        assert!(!finding.verdict.is_rounded() || mends.is_empty());
        (finding.verdict.is_rounded(), words)
    };
    let (rounded, words) = equation("['-0.07', '0.77', '0.34', '-0.04']", "mask(1, i)");
    assert!(
        rounded
            && words.contains("The printed decimals are the exact values, rounded to the nearest"),
        "{words}"
    );
    let (rounded, words) = equation("['-0.07', '0.76', '0.34', '-0.04']", "mask(1, i)");
    assert!(rounded && words.contains("are the exact values, rounded or cut"), "{words}");
    // 0.75 is neither, 1 has no digits behind a point, and a product is no printed decimal.
    for wrong in ["0.75", "1", "0.77*1"] {
        let left = format!("['-0.07', '{wrong}', '0.34', '-0.04']");
        let (rounded, words) = equation(&left, "mask(1, i)");
        assert!(!rounded && !words.contains("exact value"), "{wrong}: {words}");
    }
}
