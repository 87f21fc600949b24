//! The fields of claim files and their types.

use crate::text::toml::Toml;

/// The kinds of claims.
pub const KINDS: [&str; 7] =
    ["table", "equation", "function", "range", "smoothness", "exponent", "theorem"];

/// The fields of each kind of table with their types. `*t` is a list of t, `%t` is a table of t
/// with any names, `s|t` is s or t, and `nested` is a text or a list of such.
const SHAPES: &str = "
file: key=text paper=any define=%text given=%text alternative=*alternative scheme=*scheme \
 table=*any equation=*any function=*any range=*any smoothness=*any exponent=*any regularity=*any theorem=*any unclaimed=any
alternative: of=text label=text value=text
scheme: name=text title=text source=text parameters=%parameter let=%text offset=text arity=text \
 width=text entry=text mask=**text orbits=%text weights=%%text edges=**text use=text
parameter: default=text least=text about=text
claim: id=text locus=text title=text scheme=text note=text
table: value=text promise=promise rows=axis columns=axis cells=text|**number given=%text \
 unstated=%text|*text figures=*figure
figure: locus=text lines=*text
equation: symbols=*text hypotheses=*text indices=*axis left=text|*text right=text absent=text
function: variable=text left=text right=text
range: variable=text value=text below=text at_most=text smoothness=text from=number to=number \
 closed=flag only=flag valences=text
smoothness: continuous=text not_continuous=text valences=text absent=text given=%text
exponent: value=text printed=number at_least=text at_most=text attained=flag absent=text given=%text
regularity: id=text locus=text title=text scheme=text note=text rows=axis columns=*text cells=**number
theorem: bounds=text by=text from=text says=text rests=*text schemes=*text values=%*text \
 offset=text interpolant=text supposes=supposes block=text corrections=*correction \
 proved_by=text refuted_by=text proof_uses=*text
promise: tolerance=text level=text spread=text offset=text ring=text
axis: name=text label=text values=*number schemes=*header from=text to=text
header: printed=text scheme=text note=text
number: printed=text read=text note=text
supposes: value=text below=text
correction: of=text says=text value=text
project-file: key=text project=project define=%text shipped=*any
project: name=text repository=text commit=text licence=text note=text
shipped: id=text locus=text title=text type=text indices=*text equals=text equals_cells=nested \
 cells=nested cells_from=source language=text tolerance=text note=text convention=*convention
source: file=text after=text shape=*text skip=text
convention: label=text equals=text equals_cells=nested
";

/// The type of a field of a kind of table, or of every claim.
fn field(kind: &str, name: &str) -> Option<&'static str> {
    let of = |kind: &str| {
        let fields = SHAPES.lines().find_map(|line| line.strip_prefix(kind)?.strip_prefix(": "))?;
        let mut fields = fields.split_whitespace().filter_map(|field| field.split_once('='));
        fields.find(|(known, _)| *known == name).map(|(_, of)| of)
    };
    of(kind).or_else(|| of("claim").filter(|_| KINDS.contains(&kind)))
}

/// The path of the first field that is not of its type, such as `promise.spread`.
pub fn misfit(value: &Toml, of: &str) -> Option<String> {
    path(value, of).map(|path| path.trim_start_matches('.').to_owned())
}

/// The path with a point before each field.
fn path(value: &Toml, of: &str) -> Option<String> {
    let nested = |(name, value): &(String, Toml), of: &str| {
        path(value, of).map(|rest| format!(".{name}{rest}"))
    };
    if let Some((one, other)) = of.split_once('|') {
        return path(value, one).and(path(value, other));
    }
    match (value, of.strip_prefix('*'), of.strip_prefix('%')) {
        (Toml::List(list), ..) if of == "nested" => list.iter().find_map(|value| path(value, of)),
        (Toml::List(list), Some(of), _) => list.iter().find_map(|value| path(value, of)),
        (Toml::Table(table), _, Some(of)) => table.iter().find_map(|entry| nested(entry, of)),
        (Toml::Table(table), None, None) if !["text", "flag", "any"].contains(&of) => {
            table.iter().find_map(|entry| nested(entry, field(of, &entry.0).unwrap_or("none")))
        }
        (Toml::Text(_), ..) if ["text", "number", "header", "nested"].contains(&of) => None,
        (Toml::Flag(_), ..) if of == "flag" => None,
        _ if of == "any" => None,
        _ => Some(String::new()),
    }
}
