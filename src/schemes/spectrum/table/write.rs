//! Arrays as source code.

use super::arrays::{Array, Entries, are_consecutive, arrays};
use super::language::Language;
use super::real::{Real, RealType};
use super::rows::{Row, TableError};
use crate::scheme::split_name;

/// What the header of a table says of where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct Origin<'a> {
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The command that writes the table.
    pub command: &'a str,
}

/// A table of rows of consecutive valences as source code. The first lines say how to check it.
///
/// # Errors
/// When the rows have different orbits, or too many weights.
///
/// # Panics
/// When there are no rows, or the language has no numbers of the type ([`Language::types`]).
///
/// ```
/// use subcert::spectrum::{surroundings, table::{Language, Origin, RealType, Row, write}};
///
/// let rows = (3..=4).map(|n| Row::of(&surroundings("loop", Some(n))?)).collect::<Result<Vec<_>, _>>()?;
/// let origin = Origin { scheme: "loop", command: "subcert table loop --valences 3..4 --format rust" };
/// let text = write(&rows, Language::Rust, RealType::F64, &origin)?;
/// assert!(text.contains("pub const SUBDOMINANT: [f64; 2] = [0.25, 0.375];"));
/// # Ok::<(), subcert::spectrum::table::TableError>(())
/// ```
pub fn write(
    rows: &[Row],
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> Result<String, TableError> {
    write_without(rows, &[], language, real, origin)
}

/// The same of ascending valences, with a list of them where some are missing; the first lines say which are left out, and why.
///
/// # Errors
/// As [`write()`].
///
/// # Panics
/// When there are no rows.
pub fn write_without(
    rows: &[Row],
    left_out: &[(usize, String)],
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> Result<String, TableError> {
    let arrays = arrays(rows, real)?;
    let (first, last) = (rows[0].valence, rows[rows.len() - 1].valence);
    let valence = |n: usize| i64::try_from(n).expect("a small valence");
    let constants = vec![("first_valence", valence(first)), ("last_valence", valence(last))];
    let writer = Writer { language, real, name: identifier(origin.scheme), constants };
    let mut header = header(rows, real, origin);
    header
        .extend(left_out.iter().map(|(valence, why)| format!("Without valence {valence}: {why}.")));
    Ok(writer.written(&header, &arrays))
}

/// The lines at the head of a table.
fn header(rows: &[Row], real: RealType, origin: &Origin<'_>) -> Vec<String> {
    let (first, last) = (rows[0].valence, rows[rows.len() - 1].valence);
    let mut lines = vec![format!(
        "Weights and stencils of {} by valence n = {first}, ..., {last}.",
        origin.scheme
    )];
    lines.extend(number_lines(real, origin));
    let row = if are_consecutive(rows) {
        format!("Row n - {first} of a table is that of valence n.")
    } else {
        "Row i of a table is that of valence[i].".to_owned()
    };
    lines.extend([
        format!("    subcert spectrum {} --valence n --format json", quoted(origin.scheme)),
        format!("{row} The cross product of tangent 1 and tangent 2"),
        "is a normal; a common positive factor of both is free.".to_owned(),
    ]);
    lines
}

/// What the numbers are, and how to check them. The command that writes exact values follows.
pub(super) fn number_lines(real: RealType, origin: &Origin<'_>) -> [String; 4] {
    let (name, bits) = match real {
        RealType::F32 => ("f32", 32),
        RealType::F64 => ("f64", 64),
    };
    [
        format!("Every number is the {name} (IEEE 754, {bits} bits) nearest to its exact value."),
        format!("Written by subcert {}:", env!("CARGO_PKG_VERSION")),
        format!("    {}", origin.command),
        "To check a copy, write it again by this command and compare; the exact values are written by"
            .to_owned(),
    ]
}

/// The text as one word of a shell.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,".contains(c);
    if text.chars().all(plain) { text.to_owned() } else { format!("'{text}'") }
}

/// The name of a scheme as an identifier: that of a file is its stem.
pub(super) fn identifier(scheme: &str) -> String {
    let (name, _) = split_name(scheme);
    let path = name.strip_suffix(".toml");
    let name = path.map_or(name, |path| path.rsplit(['/', '\\']).next().unwrap_or_default());
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let name: String = name.chars().map(plain).collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) { name } else { format!("s_{name}") }
}

pub(super) struct Writer {
    pub(super) language: Language,
    pub(super) real: RealType,
    pub(super) name: String,
    /// Whole numbers before the arrays, with their names.
    pub(super) constants: Vec<(&'static str, i64)>,
}

impl Writer {
    /// # Panics
    /// When the language has no numbers of the type.
    pub(super) fn written(&self, header: &[String], arrays: &[Array]) -> String {
        assert!(self.language.types().contains(&self.real), "a language without this type");
        match self.language {
            Language::Json => self.json(header, arrays),
            _ => self.source(header, arrays),
        }
    }

    /// A constant, in the form that a language has for it.
    fn constant(&self, name: &str, value: i64) -> String {
        match self.language {
            Language::C => format!("{}_{name} = {value}", self.name),
            Language::Rust => {
                // The others are not negative.
                let kind =
                    if ["offset", "limit_first"].contains(&name) { "isize" } else { "usize" };
                format!("pub const {}: {kind} = {value};", name.to_uppercase())
            }
            Language::Glsl => format!("const int {}_{name} = {value};", self.name),
            Language::Hlsl => format!("static const int {}_{name} = {value};", self.name),
            Language::Wgsl => format!("const {}_{name}: i32 = {value};", self.name),
            Language::Cpp | Language::Python | Language::Json => format!("{name} = {value}"),
        }
    }

    fn source(&self, header: &[String], arrays: &[Array]) -> String {
        let mut lines: Vec<String> =
            header.iter().map(|line| self.language.comment(line)).collect();
        lines.push(String::new());
        let constants: Vec<String> =
            self.constants.iter().map(|(name, value)| self.constant(name, *value)).collect();
        match self.language {
            Language::C => {
                lines.extend(
                    self.guard().map(|guard| format!("#ifndef {guard}\n#define {guard}\n")),
                );
                lines.push(format!("enum {{ {} }};", constants.join(", ")));
            }
            Language::Cpp => {
                lines.extend(
                    self.guard().map(|guard| format!("#ifndef {guard}\n#define {guard}\n")),
                );
                lines.push(format!("namespace {} {{", self.name));
                lines.push(format!("constexpr int {};", constants.join(", ")));
            }
            _ => lines.extend(constants),
        }
        for array in arrays {
            lines.push(String::new());
            lines.extend(array.about.iter().map(|line| self.language.comment(line)));
            lines.push(self.array(array));
        }
        if self.language == Language::Cpp {
            lines.push(String::new());
            lines.push("}".to_owned());
        }
        if self.guard().is_some() {
            lines.push("\n#endif".to_owned());
        }
        lines.join("\n") + "\n"
    }

    /// The macro by which a header of C or C++ is read once only.
    fn guard(&self) -> Option<String> {
        let headers = [Language::C, Language::Cpp];
        let name = self.name.to_ascii_uppercase();
        headers.contains(&self.language).then(|| format!("SUBCERT_{name}_H"))
    }

    fn literal(&self, value: &Real) -> String {
        self.language.literal(*value)
    }

    /// The declaration of an array.
    fn array(&self, array: &Array) -> String {
        let Array { name, entries, .. } = array;
        let kind = self.language.type_name(self.real);
        match entries {
            Entries::Integers(values) => {
                let kind = match self.language {
                    Language::Rust => "usize",
                    Language::Wgsl => "i32",
                    _ => "int",
                };
                let values = vec![values.iter().map(ToString::to_string).collect()];
                self.list(name, kind, &values)
            }
            Entries::List(rows) => {
                let rows: Vec<Vec<String>> =
                    rows.iter().map(|row| row.iter().map(|x| self.literal(x)).collect()).collect();
                self.list(name, kind, &rows)
            }
            Entries::Table(rows) => {
                let rows: Vec<Vec<String>> =
                    rows.iter().map(|row| row.iter().map(|x| self.literal(x)).collect()).collect();
                self.table(name, kind, &rows)
            }
        }
    }

    /// One list of the entries of all rows, with a line for each row.
    fn list(&self, name: &str, kind: &str, rows: &[Vec<String>]) -> String {
        let length: usize = rows.iter().map(Vec::len).sum();
        let body = if let [row] = rows {
            row.join(", ")
        } else {
            let lines = rows.iter().map(|row| format!("\n    {},", row.join(", ")));
            let body = lines.collect::<String>();
            // GLSL allows no comma before the closing parenthesis.
            let cut = if self.language == Language::Glsl { body.len() - 1 } else { body.len() };
            format!("{}\n", &body[..cut])
        };
        match self.language {
            Language::C | Language::Hlsl => {
                format!("static const {kind} {}_{name}[{length}] = {{{body}}};", self.name)
            }
            Language::Wgsl => {
                let list = format!("array<{kind}, {length}>");
                format!("const {}_{name}: {list} = {list}({body});", self.name)
            }
            Language::Cpp => format!("constexpr {kind} {name}[{length}] = {{{body}}};"),
            Language::Rust => {
                format!("pub const {}: [{kind}; {length}] = [{body}];", name.to_uppercase())
            }
            Language::Glsl => {
                format!("const {kind} {}_{name}[{length}] = {kind}[]({body});", self.name)
            }
            Language::Python | Language::Json => format!("{name} = [{body}]"),
        }
    }

    /// A list of lists.
    fn table(&self, name: &str, kind: &str, rows: &[Vec<String>]) -> String {
        let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
        let of_row = format!("array<{kind}, {width}>(");
        let [open, close] = match self.language {
            Language::C | Language::Cpp | Language::Hlsl => ["{", "}"],
            Language::Wgsl => [of_row.as_str(), ")"],
            _ => ["[", "]"],
        };
        let lines = rows.iter().map(|row| format!("\n    {open}{}{close},", row.join(", ")));
        let body = lines.collect::<String>() + "\n";
        match self.language {
            Language::C | Language::Hlsl => {
                format!("static const {kind} {}_{name}[{count}][{width}] = {{{body}}};", self.name)
            }
            Language::Wgsl => {
                let rows = format!("array<array<{kind}, {width}>, {count}>");
                format!("const {}_{name}: {rows} = {rows}({body});", self.name)
            }
            Language::Cpp => format!("constexpr {kind} {name}[{count}][{width}] = {{{body}}};"),
            Language::Rust => {
                format!(
                    "pub const {}: [[{kind}; {width}]; {count}] = [{body}];",
                    name.to_uppercase()
                )
            }
            // Arrays of arrays came with GLSL 4.30.
            Language::Glsl => self.list(name, kind, rows),
            Language::Python | Language::Json => format!("{name} = [{body}]"),
        }
    }

    fn json(&self, header: &[String], arrays: &[Array]) -> String {
        let text = |text: &str| serde_json::to_string(text).expect("a text");
        let header = header.iter().map(|line| format!("    {}", text(line.trim_start())));
        let mut fields =
            vec![format!("  \"about\": [\n{}\n  ]", header.collect::<Vec<String>>().join(",\n"))];
        let constants = self.constants.iter();
        fields.extend(constants.map(|(name, value)| format!("  \"{name}\": {value}")));
        for array in arrays {
            let row = |row: &Vec<Real>| {
                let entries: Vec<String> = row.iter().map(|x| self.literal(x)).collect();
                entries.join(", ")
            };
            let body = match &array.entries {
                Entries::Integers(values) => {
                    values.iter().map(ToString::to_string).collect::<Vec<String>>().join(", ")
                }
                Entries::List(rows) => {
                    rows.iter().map(row).collect::<Vec<String>>().join(",\n    ")
                }
                Entries::Table(rows) => {
                    let rows = rows.iter().map(|entries| format!("[{}]", row(entries)));
                    rows.collect::<Vec<String>>().join(",\n    ")
                }
            };
            fields.push(format!("  \"{}\": [{body}]", array.name));
        }
        format!("{{\n{}\n}}\n", fields.join(",\n"))
    }
}
