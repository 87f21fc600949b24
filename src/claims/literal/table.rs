//! A table of numbers in a file.

use super::declared::{Element, decide};
use super::entry::Entry;
use super::language::{Language, Precision};
use super::locate::{Initialiser, initialiser};
use super::reader::{MAX_ENTRIES, Reader};
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// The numbers of a table, the last index running fastest.
#[derive(Clone, Debug)]
pub struct LiteralTable {
    /// The file, where each macro in the table is replaced by its value: what the places here refer to.
    pub source: Arc<SourceText>,
    /// The number of values of each index; empty for one number.
    pub shape: Vec<usize>,
    /// The numbers.
    pub entries: Vec<Entry>,
    /// The bytes of the name in the file.
    pub name: Range<usize>,
    /// The type that the source gives to the numbers, and the bytes of the word that says it; `None` where no word
    /// does, or an integer type that holds them.
    pub declared: Option<(Precision, Range<usize>)>,
}

/// Reads the numbers that the name `after` gets in a source file, such as `gregoryToLoopMatrix`. Nested
/// brackets are taken as they come, as are constructors that keep their numbers, such as `vec3(…)` or `np.array(…, dtype=np.float64)`; the numbers
/// have to fill `shape`, in the order in which they stand. A table of one number has the shape `[]`. A macro in the table is replaced by
/// its value, `#define W0 0.5f`, as the preprocessor does.
///
/// # Errors
/// At its place in the file, whatever is no number: a name, a macro without a value or with several, another call, a preprocessor line, an unknown suffix, a comma
/// without a number, lists of different lengths. Also when the name does not occur, gets no value or two, or is changed; when a conditional of the preprocessor stands
/// around it; when the types that the source gives to the numbers are several, or do not hold one of them; and when there are more or fewer numbers than the
/// shape has, or more than [`MAX_ENTRIES`].
///
/// ```
/// use subcert::diagnostic::SourceText;
/// use subcert::literal::{Language, Precision, read_literals};
///
/// let source = SourceText::new("taps.c", "static const float taps[2] = { .5f, /* half */ 1.0/6 };");
/// let table = read_literals(&source, Language::C, "taps", &[2])?;
/// assert_eq!(table.entries[0].held(Precision::Single), 0.5);
/// assert_eq!(table.entries[1].held(Precision::Single), f64::from(1.0_f32 / 6.0));
/// # Ok::<(), subcert::diagnostic::Diagnostic>(())
/// ```
pub fn read_literals(
    source: &Arc<SourceText>,
    language: Language,
    after: &str,
    shape: &[usize],
) -> Result<LiteralTable, Diagnostic> {
    let wanted = shape.iter().try_fold(1_usize, |product, &size| product.checked_mul(size));
    let Some(wanted) = wanted.filter(|&wanted| 0 < wanted && wanted <= MAX_ENTRIES) else {
        let message = format!("a shape of no numbers, or of more than {MAX_ENTRIES}: {shape:?}");
        return Err(Diagnostic::new(source, 0..0, message));
    };
    let mut ends = source.text.match_indices(['\r', '\u{2028}', '\u{2029}']);
    let other = ends.find(|(at, end)| match *end {
        "\r" => !source.text[at + 1..].starts_with('\n'),
        _ => language == Language::JavaScript,
    });
    if let Some((at, end)) = other {
        let message = "a character that ends lines in some languages, and in others does not";
        return Err(Diagnostic::new(source, at..at + end.len(), message)
            .with_help("end the lines with \\n or \\r\\n"));
    }
    let (source, found) = initialiser(source, language, after)?;
    let Initialiser { tokens, name, mut types, directives, size } = found;
    let source = &source;
    let mut reader = Reader::new(source, language, &tokens);
    let mut entries = Vec::new();
    reader.items(&mut entries, 0)?;
    types.append(&mut reader.types);
    if language == Language::Wgsl && types.is_empty() {
        // There are no others.
        types.push((Element::Float(Precision::Single), name.clone()));
    }
    let declared = decide(source, &types, &entries, &directives)?;
    if entries.len() != wanted {
        let count = entries.len();
        let numbers = if count == 1 { "number" } else { "numbers" };
        let message =
            format!("`{after}` has {count} {numbers}, and the shape {shape:?} has {wanted}");
        let error = Diagnostic::new(source, name, message);
        // `#define W0 0.5`
        let one = entries.len() == 1 && wanted > 1;
        let help =
            "of constants with one number each, give a list of names: after = [\"W0\", \"W1\"]";
        return Err(if one { error.with_help(help) } else { error });
    }
    if let Some(size) = size.filter(|&size| size != wanted) {
        let message =
            format!("`{after}` is declared with {size} numbers, and {wanted} are written");
        return Err(Diagnostic::new(source, name, message).with_help(
            "type the numbers that the program holds into the claim file, as `cells`: those that are not written are 0",
        ));
    }
    let source = Arc::clone(source);
    Ok(LiteralTable { source, shape: shape.to_vec(), entries, name, declared })
}
