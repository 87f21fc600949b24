//! Numbers that are printed in some way are read back, and no text makes the reader panic.

use super::read;
use proptest::prelude::*;
use std::fmt::Write as _;
use subcert::exact::Rational;
use subcert::literal::{Language, Precision, Written};

fn languages() -> impl Strategy<Value = Language> {
    prop::sample::select(vec![
        Language::C,
        Language::Shader,
        Language::JavaScript,
        Language::Python,
        Language::Rust,
    ])
}

/// A number with its text, as some program may write it.
fn written() -> impl Strategy<Value = (String, f64)> {
    let finite = any::<f64>().prop_filter("finite", |x| x.is_finite());
    (prop_oneof![finite, -10.0..10.0_f64], 0..4_u8).prop_map(|(x, style)| {
        let text = match style {
            0 => format!("{x:?}"),
            1 => format!("{x:e}"),
            2 => format!("{x:.17E}"),
            // As `.5`.
            _ if x.abs() < 1.0 && x.abs() > 0.1 => format!("{x:?}").replacen("0.", ".", 1),
            _ => format!("{x:?}"),
        };
        let point = text.contains('.') || text.to_ascii_lowercase().contains('e');
        (if point { text } else { format!("{text}.") }, x)
    })
}

/// What may stand between numbers.
fn space(language: Language) -> BoxedStrategy<String> {
    let comments: Vec<&str> = match language {
        Language::Python => vec![" ", "\n\t", " # table = [1], 2\n"],
        _ => vec![" ", "\n\t", " // table = {1}, 2\n", "/* 3, } */"],
    };
    prop::sample::select(comments).prop_map(str::to_owned).boxed()
}

fn sources() -> impl Strategy<Value = (Language, String, Vec<f64>)> {
    let rows = prop::collection::vec(prop::collection::vec(written(), 3), 1..5).boxed();
    languages().prop_flat_map(move |language| {
        (Just(language), rows.clone(), prop::collection::vec(space(language), 15)).prop_map(
            |(language, rows, spaces)| {
                let [open, close] = match language {
                    Language::C | Language::Shader => ["{", "}"],
                    _ => ["[", "]"],
                };
                let mut spaces = spaces.iter().cycle();
                let mut space = || spaces.next().cloned().unwrap_or_default();
                let name = if language == Language::Python { "table" } else { "x table" };
                let mut text = format!("{name} ={}{open}", space());
                for row in &rows {
                    text += open;
                    for (number, _) in row {
                        write!(text, "{}{number}{},", space(), space()).expect("memory");
                    }
                    write!(text, "{close},{}", space()).expect("memory");
                }
                text += close;
                text += if language == Language::Python { "\n" } else { ";" };
                (language, text, rows.concat().into_iter().map(|(_, x)| x).collect())
            },
        )
    })
}

/// A number, without the sign of zero.
fn bits(x: f64) -> u64 {
    (x + 0.0).to_bits()
}

proptest! {
    #[test]
    fn numbers_are_read_back((language, text, numbers) in sources()) {
        let shape = [numbers.len() / 3, 3];
        let table = read(language, &text, &shape).unwrap_or_else(|error| panic!("{error}"));
        for (entry, expected) in table.entries.iter().zip(&numbers) {
            let double = match language {
                // A shader's literal is a float.
                Language::Shader => f64::from(text[entry.span()].parse::<f32>().expect("a float")),
                _ => *expected,
            };
            prop_assert_eq!(bits(entry.held(Precision::Double)), bits(double));
            // Rust's own reader rounds correctly.
            let single: f32 = text[entry.span()].parse().expect("a float");
            if language != Language::C && language != Language::JavaScript && language != Language::Python {
                prop_assert_eq!(bits(entry.held(Precision::Single)), bits(f64::from(single)));
            }
            let Written::Literal { value, .. } = entry.written() else { panic!("a literal") };
            prop_assert_eq!(bits(subcert::float::nearest(&value)), bits(*expected));
        }
    }

    /// A change of one character gives a table of as many numbers, or an error, and never a panic.
    #[test]
    fn broken_files((language, text, numbers) in sources(), at in any::<prop::sample::Index>(), c in "[-+*/(){}\\[\\],.=;:'\"#0-9a-fx_ \n\\\\&<>é]") {
        let mut characters: Vec<char> = text.chars().collect();
        let at = at.index(characters.len());
        characters.splice(at..=at, c.chars());
        let broken: String = characters.into_iter().collect();
        if let Ok(table) = read(language, &broken, &[numbers.len()]) {
            prop_assert_eq!(table.entries.len(), numbers.len());
        }
    }

    #[test]
    fn any_text(language in languages(), text in "(table|=|[-+*/(){}\\[\\],.=;:'\"#0-9a-fx_ \n\\\\&<>é]){0,40}") {
        let _ = read(language, &text, &[1]);
    }

    /// The nearest f32 by its definition: no other f32 is nearer.
    #[test]
    fn floats_are_nearest(digits in "[0-9]{1,40}", exponent in -60..50_i32) {
        let text = format!("x table = {digits}.e{exponent};");
        let table = read(Language::Shader, &text, &[]).expect("a number");
        let found = table.entries[0].held(Precision::Single);
        let Written::Literal { value, .. } = table.entries[0].written() else { panic!("a literal") };
        prop_assume!(found.is_finite());
        let distance = |x: f64| subcert::float::exact(x).map(|x: Rational| (x - value.clone()).abs());
        let bits = format!("{found:e}").parse::<f32>().expect("a float").to_bits();
        for other in [bits + 1, bits.saturating_sub(1)] {
            let other = f64::from(f32::from_bits(other));
            prop_assert!(!other.is_finite() || distance(found) <= distance(other));
        }
    }
}
