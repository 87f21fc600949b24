//! Arrays as source code.

use super::arrays::{Array, Entries};
use super::language::Language;
use super::real::{Real, RealType};
use crate::float::hexadecimal;

pub(super) struct Writer {
    pub(super) language: Language,
    pub(super) real: RealType,
    pub(super) name: String,
    /// Whole numbers before the arrays, with their names.
    pub(super) constants: Vec<(&'static str, i64)>,
    /// Whether these are test vectors.
    pub(super) vectors: bool,
}

/// What keeps gcc and clang from warnings about arrays that are not used, and the end of it.
const UNUSED: [&str; 2] = [
    "#ifdef __GNUC__\n#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored \"-Wunused-const-variable\"\n#endif\n",
    "\n#ifdef __GNUC__\n#pragma GCC diagnostic pop\n#endif",
];

impl Writer {
    /// # Panics
    /// When the language has no numbers of the type.
    pub(super) fn written(&self, header: &[String], arrays: &[Array<'_>]) -> String {
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
                let unused = self.unused();
                format!("{unused}pub const {}: {kind} = {value};", name.to_uppercase())
            }
            Language::Glsl => format!("const int {}_{name} = {value};", self.name),
            Language::Hlsl => format!("static const int {}_{name} = {value};", self.name),
            Language::Wgsl => format!("const {}_{name}: i32 = {value};", self.name),
            Language::Cpp | Language::Python | Language::Json => format!("{name} = {value}"),
        }
    }

    fn source(&self, header: &[String], arrays: &[Array<'_>]) -> String {
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
                lines.extend(self.vectors.then(|| UNUSED[0].to_owned()));
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
        if self.vectors && self.language == Language::C {
            lines.push(UNUSED[1].to_owned());
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

    /// The literal of a number; of test vectors one that a reader need not round: hexadecimal in C.
    fn literal(&self, value: &Real) -> String {
        match value {
            Real::F64(x) if self.vectors && self.language == Language::C => hexadecimal(*x),
            _ => self.language.literal(*value),
        }
    }

    /// In Rust, what stands before an item that may not be used.
    fn unused(&self) -> &'static str {
        if self.vectors { "#[allow(dead_code, clippy::all, clippy::pedantic)]\n" } else { "" }
    }

    /// In Rust, what begins an array. A constant would be copied wherever it is used.
    fn item(&self) -> String {
        format!("{}pub {}", self.unused(), if self.vectors { "static" } else { "const" })
    }

    /// The declaration of an array.
    fn array(&self, array: &Array<'_>) -> String {
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
                self.list(name, kind, &values, &[])
            }
            Entries::List(rows) => {
                let rows: Vec<Vec<String>> =
                    rows.iter().map(|row| row.iter().map(|x| self.literal(x)).collect()).collect();
                self.list(name, kind, &rows, &[])
            }
            Entries::Table(rows) => {
                let rows: Vec<Vec<String>> =
                    rows.iter().map(|row| row.iter().map(|x| self.literal(x)).collect()).collect();
                self.table(name, kind, &rows, &[])
            }
            Entries::Noted { rows: noted, list } => {
                let literal = |x: &f64| self.literal(&Real::F64(*x));
                let rows: Vec<Vec<String>> =
                    noted.iter().map(|(row, _)| row.iter().map(literal).collect()).collect();
                let notes: Vec<&str> = noted.iter().map(|(_, note)| note.as_str()).collect();
                if *list {
                    self.list(name, kind, &rows, &notes)
                } else {
                    self.table(name, kind, &rows, &notes)
                }
            }
        }
    }

    /// The lines of rows, with what is noted behind each; the brackets are those of a row.
    fn lines(&self, rows: &[Vec<String>], [open, close]: [&str; 2], notes: &[&str]) -> String {
        let line = |(at, row): (usize, &Vec<String>)| {
            // GLSL allows no comma before the closing parenthesis.
            let last = self.language == Language::Glsl && at + 1 == rows.len();
            let comma = if last { "" } else { "," };
            let note = notes.get(at).map(|note| format!(" {}", self.language.comment(note)));
            format!("\n    {open}{}{close}{comma}{}", row.join(", "), note.unwrap_or_default())
        };
        rows.iter().enumerate().map(line).collect::<String>() + "\n"
    }

    /// One list of the entries of all rows, with a line for each row.
    fn list(&self, name: &str, kind: &str, rows: &[Vec<String>], notes: &[&str]) -> String {
        let length: usize = rows.iter().map(Vec::len).sum();
        let body = match rows {
            [row] if notes.is_empty() => row.join(", "),
            _ => self.lines(rows, ["", ""], notes),
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
                let item = self.item();
                format!("{item} {}: [{kind}; {length}] = [{body}];", name.to_uppercase())
            }
            Language::Glsl => {
                format!("const {kind} {}_{name}[{length}] = {kind}[]({body});", self.name)
            }
            Language::Python | Language::Json => format!("{name} = [{body}]"),
        }
    }

    /// A list of lists.
    fn table(&self, name: &str, kind: &str, rows: &[Vec<String>], notes: &[&str]) -> String {
        let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
        let of_row = format!("array<{kind}, {width}>(");
        let brackets = match self.language {
            Language::C | Language::Cpp | Language::Hlsl => ["{", "}"],
            Language::Wgsl => [of_row.as_str(), ")"],
            _ => ["[", "]"],
        };
        let body = self.lines(rows, brackets, notes);
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
                let (item, name) = (self.item(), name.to_uppercase());
                format!("{item} {name}: [[{kind}; {width}]; {count}] = [{body}];")
            }
            // Arrays of arrays came with GLSL 4.30.
            Language::Glsl => self.list(name, kind, rows, notes),
            Language::Python | Language::Json => format!("{name} = [{body}]"),
        }
    }

    fn json(&self, header: &[String], arrays: &[Array<'_>]) -> String {
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
                Entries::Noted { rows, list } => {
                    let rows = rows.iter().map(|(row, _)| {
                        let row = format!("{row:?}");
                        if *list { row[1..row.len() - 1].to_owned() } else { row }
                    });
                    rows.collect::<Vec<String>>().join(",\n    ")
                }
            };
            fields.push(format!("  \"{}\": [{body}]", array.name));
        }
        format!("{{\n{}\n}}\n", fields.join(",\n"))
    }
}
