//! The tables of TOML: what may be added to which.

use super::text::{is_line_end, name, space, string, whole_number};
use super::value::Toml;
use crate::text::cursor::{Cursor, Parsed};
use std::collections::HashMap;

/// How deep lists and tables may be nested.
const MAX_NESTING: usize = 32;

const USED: &str = "a name that is not yet used";

/// How a table came about, which decides what may still be added to it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Made {
    /// By a longer path in a header.
    Path,
    /// By its own header.
    Header,
    /// By a dotted key.
    Dotted,
}

/// What a file has at a name while it is read.
enum Node {
    /// A value, which nothing is added to.
    Value(Toml),
    Table(Tree),
    /// The tables under `[[…]]`.
    Tables(Vec<Tree>),
}

/// A table while it is read.
struct Tree {
    made: Made,
    entries: Vec<(String, Node)>,
    /// The places of the entries.
    places: HashMap<String, usize>,
}

impl Tree {
    fn new(made: Made) -> Tree {
        Tree { made, entries: Vec::new(), places: HashMap::new() }
    }

    fn get(&mut self, name: &str) -> Option<&mut Node> {
        let place = *self.places.get(name)?;
        self.entries.get_mut(place).map(|(_, node)| node)
    }

    /// The node of a name, which is made if there is none.
    fn node(&mut self, name: &str, new: impl FnOnce() -> Node) -> &mut Node {
        let place = self.places.get(name).copied().unwrap_or_else(|| {
            self.places.insert(name.to_owned(), self.entries.len());
            self.entries.push((name.to_owned(), new()));
            self.entries.len() - 1
        });
        &mut self.entries[place].1
    }

    /// The table at a path of a header, or the last table of a list there. A missing table is made.
    fn descend(&mut self, path: &[String]) -> Parsed<&mut Tree> {
        path.iter().try_fold(self, |tree, name| {
            match tree.node(name, || Node::Table(Tree::new(Made::Path))) {
                Node::Table(inner) => Ok(inner),
                Node::Tables(list) => list.last_mut().ok_or("a table"),
                Node::Value(_) => Err("a table"),
            }
        })
    }

    /// The table of a header `[…]`, which is new, or was made by longer paths alone.
    fn table(&mut self, name: &str) -> Parsed<()> {
        match self.node(name, || Node::Table(Tree::new(Made::Path))) {
            Node::Table(tree) if tree.made == Made::Path => tree.made = Made::Header,
            _ => return Err(USED),
        }
        Ok(())
    }

    /// Another table of a header `[[…]]`.
    fn another(&mut self, name: &str) -> Parsed<()> {
        match self.node(name, || Node::Tables(Vec::new())) {
            Node::Tables(list) => list.push(Tree::new(Made::Header)),
            _ => return Err(USED),
        }
        Ok(())
    }

    /// Reads an entry `a.b = …`. Its path makes tables, and adds to those that such paths made.
    fn entry(&mut self, c: &mut Cursor, depth: usize) -> Parsed<()> {
        let path = path(c)?;
        c.expect("=")?;
        space(c, false)?;
        let value = value(c, depth)?;
        let (last, parents) = path.split_last().ok_or("a name")?;
        let tree = parents.iter().try_fold(self, |tree, name| {
            match tree.node(name, || Node::Table(Tree::new(Made::Dotted))) {
                Node::Table(inner) if inner.made != Made::Header => {
                    inner.made = Made::Dotted;
                    Ok(inner)
                }
                _ => Err(USED),
            }
        })?;
        if tree.get(last).is_some() {
            return Err(USED);
        }
        tree.node(last, || Node::Value(value));
        Ok(())
    }

    fn finished(self) -> Toml {
        let finished = |(name, node)| {
            let value = match node {
                Node::Value(value) => value,
                Node::Table(tree) => tree.finished(),
                Node::Tables(list) => Toml::List(list.into_iter().map(Tree::finished).collect()),
            };
            (name, value)
        };
        Toml::Table(self.entries.into_iter().map(finished).collect())
    }
}

/// Reads a file.
pub fn file(c: &mut Cursor) -> Parsed<Toml> {
    let (mut file, mut section) = (Tree::new(Made::Header), Vec::new());
    loop {
        space(c, true)?;
        if c.peek().is_none() {
            return Ok(file.finished());
        }
        if c.eat("[[") {
            section = path(c)?;
            c.expect("]]")?;
            let (last, parents) = section.split_last().ok_or("a name")?;
            file.descend(parents)?.another(last)?;
        } else if c.eat("[") {
            section = path(c)?;
            c.expect("]")?;
            let (last, parents) = section.split_last().ok_or("a name")?;
            file.descend(parents)?.table(last)?;
        } else {
            file.descend(&section)?.entry(c, 0)?;
        }
        space(c, false)?;
        if !is_line_end(c) && !c.is_at("#") {
            return Err("the end of the line");
        }
    }
}

/// Reads a path such as `a` or `a."b c"`, with blanks around names.
fn path(c: &mut Cursor) -> Parsed<Vec<String>> {
    let mut path = Vec::new();
    loop {
        space(c, false)?;
        path.push(name(c)?);
        space(c, false)?;
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
        let mut table = Tree::new(Made::Header);
        items(c, "}", |c| table.entry(c, depth + 1))?;
        Ok(table.finished())
    } else if c.peek().is_some_and(|c| c.is_ascii_digit() || c == '-' || c == '+') {
        whole_number(c).map(Toml::Text)
    } else {
        Err("a string, a list or a table; numbers stand in quotes")
    }
}

/// Reads items up to a bracket. Commas separate them, and one may follow the last.
fn items(
    c: &mut Cursor,
    close: &'static str,
    mut item: impl FnMut(&mut Cursor) -> Parsed<()>,
) -> Parsed<()> {
    let mut comma = true;
    loop {
        space(c, true)?;
        if c.eat(close) {
            return Ok(());
        }
        if !comma {
            return Err("`,` or the closing bracket");
        }
        item(c)?;
        space(c, true)?;
        comma = c.eat(",");
    }
}
