//! The part of TOML that claim files use: strings, booleans, lists, tables, and whole numbers, which are the strings that
//! they spell. Other numbers stand in quotes.

use crate::cursor::{Cursor, Parsed};
use std::collections::BTreeSet;

/// The most bytes of a claim file.
pub const MAX_BYTES: usize = 4 << 20;

/// How deep lists and tables may be nested.
const MAX_NESTING: usize = 32;

/// A value of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Toml {
    /// A string.
    Text(String),
    /// `true` or `false`.
    Flag(bool),
    /// `[…]`, or the tables under `[[…]]`.
    List(Vec<Toml>),
    /// `{…}`, or the entries under `[…]`.
    Table(Table),
}

/// Keys with their values, in the order of the file.
type Table = Vec<(String, Toml)>;

impl Toml {
    /// Reads a file.
    pub fn read(text: &str) -> Result<Toml, String> {
        if text.len() > MAX_BYTES {
            return Err(format!("more than {MAX_BYTES} bytes"));
        }
        let mut cursor = Cursor::new(text);
        file(&mut cursor).map(Toml::Table).map_err(|what| cursor.expected(what))
    }

    /// Adds an item to the list of a key of a table.
    pub fn push(&mut self, key: &str, item: Toml) {
        if let Toml::Table(table) = self
            && let Toml::List(list) = slot(table, key, Toml::List(Vec::new()))
        {
            list.push(item);
        }
    }

    /// The value of a key of a table.
    pub fn get(&self, key: &str) -> Option<&Toml> {
        self.as_table().iter().find(|(name, _)| name == key).map(|(_, value)| value)
    }

    /// The string of a key.
    pub fn text(&self, key: &str) -> Option<&str> {
        self.get(key).and_then(Toml::as_text)
    }

    /// The string that this is.
    pub fn as_text(&self) -> Option<&str> {
        if let Toml::Text(text) = self { Some(text) } else { None }
    }

    /// The list that this is, or an empty one.
    pub fn as_list(&self) -> &[Toml] {
        if let Toml::List(list) = self { list } else { &[] }
    }

    /// The list of a key, or an empty one.
    pub fn list(&self, key: &str) -> &[Toml] {
        self.get(key).map_or(&[], Toml::as_list)
    }

    /// The strings in the list of a key.
    pub fn texts(&self, key: &str) -> impl Iterator<Item = &str> {
        self.list(key).iter().filter_map(Toml::as_text)
    }

    /// Whether a key is `true`.
    pub fn is_set(&self, key: &str) -> bool {
        self.get(key) == Some(&Toml::Flag(true))
    }

    /// The table that this is, or an empty one.
    pub fn as_table(&self) -> &[(String, Toml)] {
        if let Toml::Table(table) = self { table } else { &[] }
    }

    /// The entries of the table of a key. There are none without a table.
    pub fn entries(&self, key: &str) -> &[(String, Toml)] {
        self.get(key).map_or(&[], Toml::as_table)
    }
}

const USED: &str = "a name that is not yet used";

/// Skips blanks, and line ends and comments if `lines`.
fn space(c: &mut Cursor, lines: bool) {
    loop {
        c.take(|c| matches!(c, ' ' | '\t') || lines && matches!(c, '\n' | '\r'));
        if !lines || c.take(|c| c == '#').is_empty() {
            return;
        }
        c.take(|c| c != '\n');
    }
}

fn file(c: &mut Cursor) -> Parsed<Table> {
    let (mut file, mut section) = (Table::new(), Vec::new());
    let mut seen: BTreeSet<Vec<String>> = BTreeSet::new();
    loop {
        space(c, true);
        if c.peek().is_none() {
            return Ok(file);
        }
        if c.eat("[[") {
            section = path(c)?;
            c.expect("]]")?;
            let (last, parents) = section.split_last().ok_or("a name")?;
            let list = slot(descend(&mut file, parents)?, last, Toml::List(Vec::new()));
            let Toml::List(list) = list else { return Err(USED) };
            list.push(Toml::Table(Table::new()));
            seen.retain(|known| !known.starts_with(&section));
        } else if c.eat("[") {
            section = path(c)?;
            c.expect("]")?;
            if !seen.insert(section.clone()) {
                return Err(USED);
            }
            descend(&mut file, &section)?;
        } else {
            entry(c, descend(&mut file, &section)?, 0)?;
        }
        space(c, false);
        if !matches!(c.peek(), None | Some('\n' | '\r' | '#')) {
            return Err("the end of the line");
        }
    }
}

/// The value of a key. If there is none, it becomes `empty`.
fn slot<'t>(table: &'t mut Table, key: &str, empty: Toml) -> &'t mut Toml {
    let at = table.iter().position(|(name, _)| name == key).unwrap_or_else(|| {
        table.push((key.to_owned(), empty));
        table.len() - 1
    });
    &mut table[at].1
}

/// The table at a path, or the last table of a list there. A missing table is made.
fn descend<'t>(table: &'t mut Table, path: &[String]) -> Parsed<&'t mut Table> {
    path.iter().try_fold(table, |table, name| {
        let mut inner = slot(table, name, Toml::Table(Table::new()));
        if let Toml::List(list) = inner {
            inner = list.last_mut().ok_or("a table")?;
        }
        if let Toml::Table(table) = inner { Ok(table) } else { Err("a table") }
    })
}

/// Reads an entry `a.b = …`.
fn entry(c: &mut Cursor, table: &mut Table, depth: usize) -> Parsed<()> {
    let path = path(c)?;
    c.expect("=")?;
    space(c, false);
    let value = value(c, depth)?;
    let (last, parents) = path.split_last().ok_or("a name")?;
    let table = descend(table, parents)?;
    if table.iter().any(|(name, _)| name == last) {
        return Err(USED);
    }
    table.push((last.clone(), value));
    Ok(())
}

/// Reads a path such as `a` or `a.b`, with blanks around names.
fn path(c: &mut Cursor) -> Parsed<Vec<String>> {
    let mut path = Vec::new();
    loop {
        space(c, false);
        let name = c.take(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
        if name.is_empty() {
            return Err("a name");
        }
        path.push(name);
        space(c, false);
        if path.len() > MAX_NESTING || !c.eat(".") {
            return Ok(path);
        }
    }
}

fn value(c: &mut Cursor, depth: usize) -> Parsed<Toml> {
    if depth > MAX_NESTING {
        return Err("less nesting");
    }
    for quote in ["'''", "\"\"\"", "'", "\""] {
        if c.eat(quote) {
            return string(c, quote).map(Toml::Text);
        }
    }
    if c.eat("true") {
        Ok(Toml::Flag(true))
    } else if c.eat("false") {
        Ok(Toml::Flag(false))
    } else if c.eat("[") {
        let mut list = Vec::new();
        items(c, "]", |c| value(c, depth + 1).map(|item| list.push(item)))?;
        Ok(Toml::List(list))
    } else if c.eat("{") {
        let mut table = Table::new();
        items(c, "}", |c| entry(c, &mut table, depth + 1))?;
        Ok(Toml::Table(table))
    } else if c.peek().is_some_and(|c| c.is_ascii_digit() || c == '-' || c == '+') {
        whole_number(c).map(Toml::Text)
    } else {
        Err("a string, a list or a table; numbers stand in quotes")
    }
}

/// Reads a decimal whole number: a sign, digits without a 0 before them, and `_` between digits. A `+` and `_` are left out.
fn whole_number(c: &mut Cursor) -> Parsed<String> {
    const WHOLE: &str = "a whole number; other numbers stand in quotes";
    let negative = c.eat("-");
    if !negative {
        c.eat("+");
    }
    let spelled = c.take(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '+' | '-' | ':'));
    let groups: Vec<&str> = spelled.split('_').collect();
    let digits = groups.concat();
    let right =
        groups.iter().all(|group| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit()));
    if !right || digits.len() > 1 && digits.starts_with('0') {
        return Err(WHOLE);
    }
    Ok(if negative { format!("-{digits}") } else { digits })
}

/// Reads items up to a bracket. Commas separate them, and one may follow the last.
fn items(
    c: &mut Cursor,
    close: &'static str,
    mut item: impl FnMut(&mut Cursor) -> Parsed<()>,
) -> Parsed<()> {
    let mut comma = true;
    loop {
        space(c, true);
        if c.eat(close) {
            return Ok(());
        }
        if !comma {
            return Err("`,` or the closing bracket");
        }
        item(c)?;
        space(c, true);
        comma = c.eat(",");
    }
}

fn string(c: &mut Cursor, quote: &str) -> Parsed<String> {
    let mut text = String::new();
    let (long, escapes) = (quote.len() == 3, quote.starts_with('"'));
    if long {
        c.eat("\n");
    }
    while !c.eat(quote) {
        match c.next().filter(|c| long || *c != '\n').ok_or("the closing quote")? {
            '\\' if escapes => match c.next().ok_or("the closing quote")? {
                escaped @ ('"' | '\\') => text.push(escaped),
                'n' => text.push('\n'),
                't' => text.push('\t'),
                '\n' if long => _ = c.take(char::is_whitespace),
                _ => return Err("one of the escapes \\\" \\\\ \\n \\t"),
            },
            other => text.push(other),
        }
    }
    Ok(text)
}
