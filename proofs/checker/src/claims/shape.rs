//! The fields of claim files and their types.

use crate::text::Toml;

/// The fields of tables that several kinds of claims have, with their types. `*t` is a list of t,
/// `%t` is a table of t with any names, `s|t` is s or t, and `nested` is a text or a list of such.
/// A word without `=` stands for the fields of the line of this name.
const SHARED: &str = "
file: claims key=text paper=any define=%text given=%text alternative=*alternative scheme=*scheme \
 regularity=*any unclaimed=any
alternative: of=text label=text value=text
scheme: name=text title=text source=text parameters=%parameter let=%text offset=text arity=text \
 width=text entry=text mask=text|**text symbol=text orbits=%text weights=%%text edges=**text use=text \
 filter=flag dilation=**text origin=*text box=**text
parameter: default=text least=text about=text
claim: id=text locus=text title=text scheme=text note=text
axis: name=text label=text values=*number schemes=*header from=text to=text
header: printed=text scheme=text note=text
number: printed=text read=text note=text
";

/// The type of a field of a kind of table.
fn field<'l>(own: &'l str, kind: &str, name: &str) -> Option<&'l str> {
    let mut lines = own.lines().chain(SHARED.lines());
    let fields = lines.find_map(|line| line.strip_prefix(kind)?.strip_prefix(": "))?;
    fields.split_whitespace().find_map(|word| match word.split_once('=') {
        Some((known, of)) => (known == name).then_some(of),
        None => field(own, word, name),
    })
}

/// The path of the first field that is not of its type, such as `promise.spread`. The lines say
/// the types that are not shared.
pub fn misfit(value: &Toml, of: &str, own: &str) -> Option<String> {
    path(value, of, own).map(|path| path.trim_start_matches('.').to_owned())
}

/// The path with a point before each field.
fn path(value: &Toml, of: &str, own: &str) -> Option<String> {
    let nested = |(name, value): &(String, Toml), of: &str| {
        path(value, of, own).map(|rest| format!(".{name}{rest}"))
    };
    if let Some((one, other)) = of.split_once('|') {
        return path(value, one, own).and(path(value, other, own));
    }
    let each = |list: &[Toml], of: &str| list.iter().find_map(|value| path(value, of, own));
    match (value, of.strip_prefix('*'), of.strip_prefix('%')) {
        (Toml::List(list), ..) if of == "nested" => each(list, of),
        (Toml::List(list), Some(of), _) => each(list, of),
        (Toml::Table(table), _, Some(of)) => table.iter().find_map(|entry| nested(entry, of)),
        (Toml::Table(table), None, None) if !["text", "flag", "any"].contains(&of) => {
            let of = |name: &str| field(own, of, name).unwrap_or("none");
            table.iter().find_map(|entry| nested(entry, of(&entry.0)))
        }
        (Toml::Text(_), ..) if ["text", "number", "header", "nested"].contains(&of) => None,
        (Toml::Flag(_), ..) if of == "flag" => None,
        _ if of == "any" => None,
        _ => Some(String::new()),
    }
}
