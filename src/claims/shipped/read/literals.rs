//! The numbers of a table: typed into the claim file, or read from a source file.

use super::file::CellsFrom;
use super::nested::{Nested, flattened};
use super::reader::{MAX_DESCRIBED, Reader};
use crate::diagnostic::{Diagnostic, SourceText, read_text};
use crate::float::exact;
use crate::literal::{Entry, Language, LiteralTable, Precision, Written, read_literals};
use crate::scheme::Spanned;
use crate::shipped::claim::{Digits, NumberType, ShippedNumber};
use std::path::Path;
use std::sync::Arc;

/// The largest source file that is read, in bytes.
const MAX_SOURCE_BYTES: u64 = 16 << 20;

/// The most names of numbers that are read one by one.
const MAX_NAMES: usize = 64;

/// The name that a typed number gets, so that it can be read as a table of one.
const NAME: &str = "x";

impl Reader<'_> {
    /// The numbers that are typed into the claim file.
    pub(super) fn typed(
        &self,
        list: &Spanned<Vec<Spanned<Nested>>>,
        language: Language,
        kind: NumberType,
        count: usize,
    ) -> Result<Vec<ShippedNumber>, Diagnostic> {
        let texts = self.texts(list.get_ref())?;
        if texts.len() != count {
            let found = texts.len();
            let message = format!("{found} numbers, and the indices have {count} combinations");
            return Err(self.error(list.span(), message).with_help(
                "give one number for each combination of the indices, the last index fastest",
            ));
        }
        texts.iter().map(|text| self.one(text, language, kind)).collect()
    }

    fn one(
        &self,
        text: &Spanned<&str>,
        language: Language,
        kind: NumberType,
    ) -> Result<ShippedNumber, Diagnostic> {
        let plain = |c: char| c.is_ascii_alphanumeric() || " ._+-*/()'".contains(c);
        let comment = ["//", "/*"].iter().any(|sign| text.get_ref().contains(sign));
        let refuse = |message: String| {
            self.error(text.span(), message).with_help(
                "type each number as the source has it, such as \"0.8128f\" or \"1.0/6.0\"; \
                 `language` says by which rules it is read",
            )
        };
        if comment || !text.get_ref().chars().all(plain) {
            return Err(refuse(format!("`{}` is not a number", text.get_ref())));
        }
        let source = SourceText::new(NAME, format!("{NAME} = {}\n", text.get_ref()));
        let table = read_literals(&source, language, NAME, &[])
            .map_err(|error| refuse(format!("`{}`: {}", text.get_ref(), error.message)))?;
        number(&table.entries[0], &source, kind)
            .map_err(|why| refuse(format!("`{}` {why}", text.get_ref())))
    }

    /// The numbers of a table in a source file.
    pub(super) fn sourced(
        &self,
        from: &Spanned<CellsFrom>,
        language: Option<Language>,
        kind: NumberType,
        sizes: &[usize],
    ) -> Result<Vec<ShippedNumber>, Diagnostic> {
        let CellsFrom { file, after, shape, skip } = from.get_ref();
        let source = self.source_file(file)?;
        let language = language.map_or_else(|| Language::of(Path::new(file.get_ref())), Ok);
        let language = language.map_err(|why| {
            let message = format!("the language of `{}` is not known: {why}", file.get_ref());
            self.error(file.span(), message).with_help(
                "language = \"c\", or shader, hlsl, wgsl, javascript, python, rust, matlab",
            )
        })?;
        let skipped = skip.as_ref().map_or(Ok(0), |skip| self.count(skip))?;
        let wanted: usize = sizes.iter().product();
        let shape = match shape {
            Some(shape) => {
                shape.get_ref().iter().map(|size| self.count(size)).collect::<Result<_, _>>()?
            }
            None if skipped == 0 => sizes.to_vec(),
            None => {
                return Err(self
                    .error(from.span(), "`skip` needs the `shape` of the table in the source")
                    .with_help(
                        "shape = [10], skip = \"3\" passes over the first 3 of 10 numbers",
                    ));
            }
        };
        let names = flattened(std::slice::from_ref(after));
        let several = matches!(after.get_ref(), Nested::List(_));
        let has_shape = from.get_ref().shape.is_some() || skip.is_some();
        if several && (has_shape || names.len() != wanted || names.len() > MAX_NAMES) {
            let found = names.len();
            let message = format!("{found} names, and the indices have {wanted} combinations");
            return Err(self.error(after.span(), message).with_help(format!(
                "a list has the name of one number for each of up to {MAX_NAMES}, without `shape` and `skip`"
            )));
        }
        let mut entries = Vec::new();
        for name in names {
            let shape = if several { &[] } else { &shape[..] };
            let table = read_literals(&source, language, name.get_ref(), shape)?;
            has_type(&table, name.get_ref(), kind)?;
            let source = table.source;
            entries.extend(table.entries.into_iter().map(|entry| (entry, Arc::clone(&source))));
        }
        let described = entries.get(skipped..).and_then(|rest| rest.get(..wanted));
        let entries = described.ok_or_else(|| {
            let found = entries.len();
            let message = format!(
                "the source has {found} numbers, and {wanted} are described after {skipped}"
            );
            self.error(from.span(), message)
                .with_help("let the indices run over numbers that the table has")
        })?;
        let read = |(entry, source): &(Entry, Arc<SourceText>)| {
            let read = number(entry, source, kind)
                .map_err(|why| Diagnostic::new(source, entry.span(), format!("this {why}")))?;
            Ok(ShippedNumber { line: Some(entry.line()), ..read })
        };
        let numbers = entries.iter().map(read);
        numbers.collect()
    }

    /// The source file, beside the claim file.
    fn source_file(&self, file: &Spanned<String>) -> Result<Arc<SourceText>, Diagnostic> {
        let folder = Path::new(&self.source.name).parent().unwrap_or(Path::new(""));
        let path = folder.join(file.get_ref());
        let text = read_text(&path, MAX_SOURCE_BYTES).map_err(|reason| {
            self.error(file.span(), format!("cannot read `{}`: {reason}", path.display()))
                .with_help("the path is relative to the folder of the claim file")
        })?;
        Ok(SourceText::new(path.display().to_string(), text))
    }

    fn count(&self, text: &Spanned<String>) -> Result<usize, Diagnostic> {
        let count: Option<usize> = text.get_ref().parse().ok();
        count.filter(|count| *count <= MAX_DESCRIBED).ok_or_else(|| {
            let message = format!("`{}` is not a count up to {MAX_DESCRIBED}", text.get_ref());
            self.error(text.span(), message)
        })
    }
}

/// The precision of a type of floating-point numbers.
fn precision(kind: NumberType) -> Option<Precision> {
    match kind {
        NumberType::Single => Some(Precision::Single),
        NumberType::Double => Some(Precision::Double),
        NumberType::Decimal(_) => None,
    }
}

/// Checks that a source gives no other type to the numbers of a table.
fn has_type(table: &LiteralTable, name: &str, kind: NumberType) -> Result<(), Diagnostic> {
    let (Some(wanted), Some((held, span))) = (precision(kind), &table.declared) else {
        return Ok(());
    };
    if wanted == *held {
        return Ok(());
    }
    let word = |precision| if precision == Precision::Single { "f32" } else { "f64" };
    let [held, wanted] = [word(*held), word(wanted)];
    let message =
        format!("the numbers of `{name}` have the type {held} here, and the claim says {wanted}");
    let help = format!(
        "write type = \"{held}\" in the claim file; where the program converts them later, type the numbers into it, as `cells`"
    );
    Err(Diagnostic::new(&table.source, span.clone(), message).with_help(help))
}

/// The number of an entry. The error says why it has none.
fn number(
    entry: &Entry,
    source: &SourceText,
    kind: NumberType,
) -> Result<ShippedNumber, &'static str> {
    // `\` joins lines in a macro and in Python.
    let text = source.text[entry.span()].replace("\\\n", " ").replace("\\\r\n", " ");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (value, written) = match entry.written() {
        Written::Literal { value, digits, places } => {
            let count = digits.zip(places);
            (Some(value.clone()), Some(Digits { value, count }))
        }
        Written::Expression { value } => (value, None),
    };
    let precision = precision(kind);
    if precision.is_some() && entry.depends_on_machine() {
        return Err(
            "has a long double, which is rounded to a format of the machine first: the number that the \
                    program holds is not known",
        );
    }
    if precision.is_some_and(|precision| entry.depends_on_compiler(precision)) {
        return Err(
            "is another number where the compiler rounds to a double first: write it with the digits of the \
                    float, such as 0.33333334f",
        );
    }
    let held = precision.map_or(value, |precision| exact(entry.held(precision)));
    let held = held.ok_or("has no finite value in the type of the table")?;
    Ok(ShippedNumber { text, written, held, line: None })
}
