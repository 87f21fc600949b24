//! Tables as comma-separated values (RFC 4180, with line feeds).

use serde::Serialize;
use serde_json::Value;
use subcert::audit::PaperAudit;
use subcert::exact::format::short;
use subcert::report::Grid;
use subcert::report::json::ProjectsReport;
use subcert::shipped::ProjectAudit;

/// How many significant digits a decimal beside an exact value has.
const DIGITS: u32 = 17;

/// A table.
pub(crate) fn of_grid(grid: &Grid) -> String {
    let mut out = Table { text: String::new() };
    for row in std::iter::once(&grid.header).chain(&grid.rows) {
        out.row(&row.iter().map(String::as_str).collect::<Vec<&str>>());
    }
    out.text
}

/// The cells of the tables of papers: one row for each, with its verdict.
pub(crate) fn cells(audits: &[PaperAudit<'_>]) -> String {
    let mut out = Table::new(&["id", "printed", "exact", "decimal", "verdict"]);
    let tables = audits.iter().flat_map(|audit| &audit.tables);
    for cell in tables.flat_map(|table| table.cells.iter().flatten()) {
        let printed = cell.printed.as_deref().unwrap_or_default();
        let exact = cell.exact.as_ref().map(ToString::to_string).unwrap_or_default();
        let decimal = cell.exact.as_ref().map(|exact| short(exact, DIGITS)).unwrap_or_default();
        out.row(&[&cell.id, printed, &exact, &decimal, cell.verdict.word().name()]);
    }
    out.text
}

/// Constants that programs ship: one row for each number.
pub(crate) fn shipped(audits: &[ProjectAudit<'_>]) -> String {
    let header = ["project", "table", "at", "shipped", "verdict", "exact", "nearest", "error"];
    let mut out = Table::new(&header);
    let report = ProjectsReport::of(audits);
    for project in &report.projects {
        for table in &project.tables {
            for number in &table.numbers {
                let at: Vec<String> =
                    number.at.iter().map(|(name, value)| format!("{name}={value}")).collect();
                let nearest = number.nearest.as_deref().unwrap_or_default();
                let (shipped, verdict) = (number.shipped, number.verdict);
                let [exact, error] =
                    [&number.exact, &number.error].map(|text| text.as_deref().unwrap_or_default());
                out.row(&[
                    project.key,
                    table.id,
                    &at.join(" "),
                    shipped,
                    verdict,
                    exact,
                    nearest,
                    error,
                ]);
            }
        }
    }
    out.text
}

/// Any report: one row for each value of its JSON, named as jq names it, such as `levels[0].c`.
pub(crate) fn values(json: &impl Serialize) -> String {
    let mut out = Table::new(&["name", "value"]);
    out.values("", &serde_json::to_value(json).expect("keys that are texts"));
    out.text
}

struct Table {
    text: String,
}

impl Table {
    fn new(header: &[&str]) -> Table {
        let mut table = Table { text: String::new() };
        table.row(header);
        table
    }

    fn values(&mut self, name: &str, value: &Value) {
        match value {
            Value::Object(fields) => {
                for (key, value) in fields {
                    let dot = if name.is_empty() { "" } else { "." };
                    self.values(&format!("{name}{dot}{key}"), value);
                }
            }
            Value::Array(entries) => {
                for (i, value) in entries.iter().enumerate() {
                    self.values(&format!("{name}[{i}]"), value);
                }
            }
            Value::Null => self.row(&[name, ""]),
            Value::String(text) => self.row(&[name, text]),
            Value::Bool(_) | Value::Number(_) => self.row(&[name, &value.to_string()]),
        }
    }

    fn row(&mut self, fields: &[&str]) {
        let fields: Vec<String> = fields.iter().map(|field| quoted(field)).collect();
        self.text.push_str(&fields.join(","));
        self.text.push('\n');
    }
}

/// A field, in quotes where it needs them.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
