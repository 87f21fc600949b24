//! TOML as people write it: from a file to the tables of a reader, with the places of errors.

use crate::diagnostic::{Diagnostic, SourceText};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// The most missing fields that are named at once.
const MAX_MISSING: usize = 32;

/// Deserialises TOML. An error points at its place; fields that are missing are named all at once.
///
/// Whole numbers are taken as the texts that they spell: `arity = 3` is `arity = "3"`. Other numbers are refused, since
/// TOML rounds them.
///
/// # Errors
/// When the text is no TOML, or not of the form of `T`.
///
/// # Panics
/// Never.
pub fn from_toml<T: serde::de::DeserializeOwned>(
    source: &Arc<SourceText>,
) -> Result<T, Diagnostic> {
    let mut root = DeTable::parse(&source.text).map_err(|error| explained(source, &error))?;
    for (_, value) in root.get_mut().iter_mut() {
        spell(value);
    }
    let read = |root: &Spanned<DeTable<'_>>| T::deserialize(Deserializer::from(root.clone()));
    let error = match read(&root) {
        Ok(found) => return Ok(found),
        Err(error) => error,
    };
    let Some(first) = missing(&error) else { return Err(explained(source, &error)) };
    // A field that is missing is put there, until something else is wrong: the readers name one at a time.
    let mut all = vec![first];
    while all.len() < MAX_MISSING {
        let (span, name) = all.last().expect("one at least").clone();
        let stand_ins = [
            DeValue::String(Cow::Borrowed("")),
            DeValue::Array(<_>::default()),
            DeValue::Table(<_>::default()),
        ];
        let next = stand_ins.into_iter().find_map(|value| {
            let mut filled = root.clone();
            put(&mut filled, &span, &name, value)?;
            let found = read(&filled).err().as_ref().and_then(missing)?;
            Some((filled, found)).filter(|(_, found)| !all.contains(found))
        });
        let Some((filled, found)) = next else { break };
        root = filled;
        all.push(found);
    }
    Err(named(source, &all))
}

/// Whole numbers as texts. What is not decimal stays as it is, and is refused.
fn spell(value: &mut Spanned<DeValue<'_>>) {
    let spelled = match value.get_mut() {
        DeValue::Integer(number) if number.radix() == 10 => {
            Some(number.as_str().trim_start_matches('+').to_owned())
        }
        DeValue::Array(items) => {
            items.iter_mut().for_each(spell);
            None
        }
        DeValue::Table(table) => {
            table.iter_mut().for_each(|(_, value)| spell(value));
            None
        }
        _ => None,
    };
    if let Some(text) = spelled {
        *value.get_mut() = DeValue::String(Cow::Owned(text));
    }
}

/// The place and the name of a field that is missing.
fn missing(error: &Error) -> Option<(Range<usize>, String)> {
    let name = error.message().strip_prefix("missing field `")?.strip_suffix('`')?;
    Some((error.span().unwrap_or(0..0), name.to_owned()))
}

/// Puts a value into the table at this place; into the root, if there is none.
fn put<'i>(
    root: &mut Spanned<DeTable<'i>>,
    span: &Range<usize>,
    name: &str,
    value: DeValue<'i>,
) -> Option<()> {
    fn find<'t, 'i>(
        value: &'t mut Spanned<DeValue<'i>>,
        span: &Range<usize>,
    ) -> Option<&'t mut DeTable<'i>> {
        let here = value.span() == *span;
        match value.get_mut() {
            DeValue::Table(table) => {
                if here {
                    return Some(table);
                }
                table.iter_mut().find_map(|(_, value)| find(value, span))
            }
            DeValue::Array(items) => items.iter_mut().find_map(|value| find(value, span)),
            _ => None,
        }
    }
    let at_root = root.span() == *span || *span == (0..0);
    let table = if at_root {
        root.get_mut()
    } else {
        root.get_mut().iter_mut().find_map(|(_, value)| find(value, span))?
    };
    let key = Spanned::new(span.clone(), Cow::Owned(name.to_owned()));
    table.insert(key, Spanned::new(span.clone(), value));
    Some(())
}

/// One error for all fields that are missing, with the tables that they belong to.
fn named(source: &Arc<SourceText>, all: &[(Range<usize>, String)]) -> Diagnostic {
    let mut places: Vec<(&Range<usize>, Vec<&str>)> = Vec::new();
    for (span, name) in all {
        match places.iter_mut().find(|(known, _)| *known == span) {
            Some((_, names)) => names.push(name),
            None => places.push((span, vec![name])),
        }
    }
    let message = |names: &[&str]| {
        let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        match quoted.split_last() {
            Some((last, [])) => format!("missing field {last}"),
            Some((last, others)) => format!("missing fields {} and {last}", others.join(", ")),
            None => String::new(),
        }
    };
    let (first, names) = &places[0];
    let diagnostic = Diagnostic::new(source, (*first).clone(), message(names));
    let others = &places[1..];
    others.iter().fold(diagnostic, |diagnostic, (span, names)| {
        diagnostic.with_place((*span).clone(), message(names))
    })
}

fn explained(source: &Arc<SourceText>, error: &Error) -> Diagnostic {
    let diagnostic = Diagnostic::new(source, error.span().unwrap_or(0..0), error.message());
    let is = |kind: &str| error.message().contains(&format!("invalid type: {kind}"));
    if is("floating point") {
        let text = error.span().and_then(|span| source.text.get(span)).unwrap_or("0.5");
        return diagnostic.with_help(format!(
            "write it in quotes, as '{text}': it is read exactly then, and its digits are kept"
        ));
    }
    if error.message().contains("invalid type: sequence, expected a string") {
        return diagnostic.with_help(
            "a coefficient is a text with a number or a formula; schemes with matrices as coefficients, such as Hermite schemes, and \
             masks of two variables are not taken",
        );
    }
    if is("integer") {
        return diagnostic.with_help("write it as a decimal number, or as a text in quotes");
    }
    diagnostic
}
