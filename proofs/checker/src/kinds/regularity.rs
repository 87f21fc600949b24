//! Tables of orders of smoothness and of Hölder exponents: every cell is a claim of kind `smoothness` or `exponent`
//! (proofs/format/regularity.md).

#![warn(clippy::arithmetic_side_effects)]

use crate::claims::{misfit, printed};
use crate::numbers::is_blank;
use crate::text::Toml;
use std::collections::BTreeSet;

/// The fields of the tables.
const FIELDS: &str = "regularity: claim rows=axis columns=*text cells=**number";

/// The columns that are fields of claims, with the kinds of these.
const COLUMNS: [(&str, &str); 5] = [
    ("continuous", "smoothness"),
    ("not_continuous", "smoothness"),
    ("value", "exponent"),
    ("at_least", "exponent"),
    ("at_most", "exponent"),
];

/// The file with the claims of the cells of its tables behind its other claims.
pub fn expanded(mut file: Toml) -> Result<Toml, String> {
    let mut claims = Vec::new();
    for table in file.list("regularity") {
        let id = table.text("id").unwrap_or_default();
        claims.extend(cells(table).map_err(|reason| format!("the table `{id}`: {reason}"))?);
    }
    for (kind, claim) in claims {
        file.push(kind, claim);
    }
    Ok(file)
}

/// A scheme, and the value of a parameter with its name.
type Row<'a> = (&'a str, Option<(&'a str, &'a str)>);

/// The claims of the cells, with their kinds.
fn cells(table: &Toml) -> Result<Vec<(&'static str, Toml)>, String> {
    if let Some(path) = misfit(table, "regularity", FIELDS) {
        return Err(format!("`{path}` is unknown, or not of its type"));
    }
    let (id, locus) = (table.text("id").unwrap_or_default(), table.text("locus"));
    let rows = rows(table)?;
    let columns: Vec<&str> = table.texts("columns").collect();
    let different: BTreeSet<&&str> = columns.iter().collect();
    if columns.is_empty() || different.len() < columns.len() {
        return Err("no column, or one twice".to_owned());
    }
    let lines = table.list("cells");
    let different: BTreeSet<&Row<'_>> = rows.iter().collect();
    if different.len() < rows.len() {
        return Err("a row stands there twice".to_owned());
    }
    if rows.is_empty() || lines.len() != rows.len() {
        return Err("one row of cells for each header".to_owned());
    }
    let mut claims = Vec::new();
    for (row, (line, (scheme, value))) in (1_usize..).zip(lines.iter().zip(rows)) {
        let line = line.as_list();
        if line.len() != columns.len() {
            return Err("one cell for each column".to_owned());
        }
        for (cell, column) in line.iter().zip(&columns) {
            let (printed, said) = printed(cell).ok_or("a cell is not a text")?;
            if is_blank(said) {
                continue;
            }
            if is_blank(printed) {
                return Err("nothing is printed in a cell, and yet read".to_owned());
            }
            let mut claim = vec![("id", Toml::Text(format!("{id}.{row}.{column}")))];
            claim.push(("locus", Toml::Text(locus.unwrap_or_default().to_owned())));
            claim.push(("scheme", Toml::Text(scheme.to_owned())));
            if let Some((name, value)) = value {
                let value = vec![(name.to_owned(), Toml::Text(value.to_owned()))];
                claim.push(("given", Toml::Table(value)));
            }
            let kind = states(&mut claim, column, cell, said.trim())?;
            let claim = claim.into_iter().map(|(name, value)| (name.to_owned(), value));
            claims.push((kind, Toml::Table(claim.collect())));
        }
    }
    Ok(claims)
}

/// Adds what a cell states to its claim, and gives the kind of this.
fn states(
    claim: &mut Vec<(&'static str, Toml)>,
    column: &str,
    cell: &Toml,
    said: &str,
) -> Result<&'static str, String> {
    let text = |text: &str| Toml::Text(text.to_owned());
    if column == "order" {
        let next = said.parse().ok().and_then(|m: usize| m.checked_add(1));
        let next = next.ok_or_else(|| format!("`{said}` is no order"))?;
        claim.push(("continuous", text(said)));
        claim.push(("not_continuous", text(&next.to_string())));
        return Ok("smoothness");
    }
    if column == "exponent" {
        claim.push(("printed", cell.clone()));
        return Ok("exponent");
    }
    let known = COLUMNS.into_iter().find(|(field, _)| *field == column);
    let (field, kind) =
        known.ok_or_else(|| format!("`{column}` is nothing that a column states"))?;
    claim.push((field, text(said)));
    Ok(kind)
}

/// The rows. Their headers are schemes, or values of one parameter of the table's scheme.
fn rows(table: &Toml) -> Result<Vec<Row<'_>>, String> {
    let axis = table.get("rows").ok_or("`rows` is missing")?;
    let (schemes, values) = (axis.list("schemes"), axis.list("values"));
    let found: Option<Vec<Row<'_>>> =
        match (table.text("scheme"), axis.text("name"), schemes.is_empty(), values.is_empty()) {
            (None, None, false, true) => {
                let scheme = |header| Toml::as_text(header).or_else(|| header.text("scheme"));
                schemes.iter().map(|header| Some((scheme(header)?, None))).collect()
            }
            (Some(scheme), Some(name), true, false) => {
                let value = |header| Some((scheme, Some((name, printed(header)?.1))));
                values.iter().map(value).collect()
            }
            _ => None,
        };
    found.ok_or_else(|| "rows that are schemes, or values of a parameter of `scheme`".to_owned())
}
