//! Tables as comma-separated values (RFC 4180, with line feeds).

use serde::Serialize;
use serde_json::Value;
use subcert::report::Grid;

/// A table.
pub(crate) fn of_grid(grid: &Grid) -> String {
    let mut out = String::new();
    for row in std::iter::once(&grid.header).chain(&grid.rows) {
        out += &row.iter().map(|field| quoted(field)).collect::<Vec<String>>().join(",");
        out.push('\n');
    }
    out
}

/// Any answer: one row for each value of its JSON, named as jq names it, such as `levels[0].c`.
pub(crate) fn values(json: &impl Serialize) -> Grid {
    let mut rows = Vec::new();
    list("", &serde_json::to_value(json).expect("keys that are texts"), &mut rows);
    Grid::of(["name", "value"], rows, 2)
}

fn list(name: &str, value: &Value, rows: &mut Vec<Vec<String>>) {
    let text = match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                let dot = if name.is_empty() { "" } else { "." };
                list(&format!("{name}{dot}{key}"), value, rows);
            }
            return;
        }
        Value::Array(entries) => {
            for (i, value) in entries.iter().enumerate() {
                list(&format!("{name}[{i}]"), value, rows);
            }
            return;
        }
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Bool(_) | Value::Number(_) => value.to_string(),
    };
    rows.push(vec![name.to_owned(), text]);
}

/// A field, in quotes where it needs them.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
