//! The part of TOML that claim files use: strings, booleans, lists and tables.

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
    /// `{…}`, or what stands under `[…]`, in the order of the file.
    Table(Vec<(String, Toml)>),
}

impl Toml {
    /// The value of a key of a table.
    pub fn get(&self, key: &str) -> Option<&Toml> {
        let Toml::Table(entries) = self else { return None };
        entries.iter().find(|(name, _)| name == key).map(|(_, value)| value)
    }

    /// The string of a key.
    pub fn text(&self, key: &str) -> Option<&str> {
        self.get(key).and_then(Toml::as_text)
    }

    /// This as a string.
    pub fn as_text(&self) -> Option<&str> {
        if let Toml::Text(text) = self { Some(text) } else { None }
    }

    /// The list of a key; empty when there is none.
    pub fn list(&self, key: &str) -> &[Toml] {
        if let Some(Toml::List(list)) = self.get(key) { list } else { &[] }
    }

    /// The entries of the table of a key; none when there is no such table.
    pub fn entries(&self, key: &str) -> &[(String, Toml)] {
        if let Some(Toml::Table(entries)) = self.get(key) { entries } else { &[] }
    }

    /// Reads a file.
    pub fn read(text: &str) -> Result<Toml, String> {
        if text.len() > MAX_BYTES {
            return Err(format!("more than {MAX_BYTES} bytes"));
        }
        let characters: Vec<char> = text.chars().collect();
        let mut reader = Reader { text: &characters, at: 0 };
        reader.file().map_err(|expected| {
            let line = 1 + characters[..reader.at].iter().filter(|c| **c == '\n').count();
            format!("line {line}: expected {expected}")
        })
    }
}

type Parsed<T> = Result<T, &'static str>;

struct Reader<'a> {
    text: &'a [char],
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> Option<char> {
        self.text.get(self.at).copied()
    }

    fn eat(&mut self, token: &str) -> bool {
        let length = token.chars().count();
        let found = self.text.get(self.at..self.at + length);
        let found = found.is_some_and(|found| token.chars().eq(found.iter().copied()));
        self.at += if found { length } else { 0 };
        found
    }

    /// Skips blanks; with `lines`, line ends and comments too.
    fn space(&mut self, lines: bool) {
        while let Some(c) = self.peek() {
            if lines && c == '#' {
                while self.peek().is_some_and(|c| c != '\n') {
                    self.at += 1;
                }
            } else if matches!(c, ' ' | '\t') || lines && matches!(c, '\n' | '\r') {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    fn file(&mut self) -> Parsed<Toml> {
        let mut file = Toml::Table(Vec::new());
        let mut section: Vec<String> = Vec::new();
        let mut seen: Vec<Vec<String>> = Vec::new();
        loop {
            self.space(true);
            if self.peek().is_none() {
                return Ok(file);
            }
            if self.eat("[[") {
                section = self.path()?;
                if !self.eat("]]") {
                    return Err("`]]`");
                }
                let (last, parents) = section.split_last().ok_or("a name")?;
                let table = inner(&mut file, parents)?;
                match table.iter_mut().find(|(name, _)| name == last) {
                    None => {
                        table.push((last.clone(), Toml::List(vec![Toml::Table(Vec::new())])));
                    }
                    Some((_, Toml::List(list))) => list.push(Toml::Table(Vec::new())),
                    Some(_) => return Err("a name that is not yet used"),
                }
                seen.retain(|known| !known.starts_with(&section));
            } else if self.eat("[") {
                section = self.path()?;
                if !self.eat("]") {
                    return Err("`]`");
                }
                if seen.contains(&section) {
                    return Err("a name that is not yet used");
                }
                seen.push(section.clone());
                inner(&mut file, &section)?;
            } else {
                let table = inner(&mut file, &section)?;
                self.entry(table, 0)?;
            }
            self.space(false);
            if self.peek().is_some_and(|c| !matches!(c, '\n' | '\r' | '#')) {
                return Err("the end of the line");
            }
        }
    }

    fn entry(&mut self, table: &mut Vec<(String, Toml)>, depth: usize) -> Parsed<()> {
        let path = self.path()?;
        if !self.eat("=") {
            return Err("`=`");
        }
        self.space(false);
        let value = self.value(depth)?;
        let (last, parents) = path.split_last().ok_or("a name")?;
        let table = descend(table, parents)?;
        if table.iter().any(|(name, _)| name == last) {
            return Err("a name that is not yet used");
        }
        table.push((last.clone(), value));
        Ok(())
    }

    /// `a`, `a.b`, with blanks around.
    fn path(&mut self) -> Parsed<Vec<String>> {
        let mut path = Vec::new();
        loop {
            self.space(false);
            let start = self.at;
            while self.peek().is_some_and(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-') {
                self.at += 1;
            }
            if start == self.at {
                return Err("a name");
            }
            path.push(self.text[start..self.at].iter().collect());
            self.space(false);
            if path.len() > MAX_NESTING || !self.eat(".") {
                return Ok(path);
            }
        }
    }

    fn value(&mut self, depth: usize) -> Parsed<Toml> {
        if depth > MAX_NESTING {
            return Err("less nesting");
        }
        if self.eat("true") {
            return Ok(Toml::Flag(true));
        }
        if self.eat("false") {
            return Ok(Toml::Flag(false));
        }
        for quote in ["'''", "\"\"\"", "'", "\""] {
            if self.eat(quote) {
                return self.string(quote).map(Toml::Text);
            }
        }
        let (close, mut list, mut table) = if self.eat("[") {
            ("]", Vec::new(), None)
        } else if self.eat("{") {
            ("}", Vec::new(), Some(Vec::new()))
        } else {
            return Err("a string, a list or a table; numbers stand in quotes");
        };
        loop {
            self.space(true);
            if self.eat(close) {
                return Ok(table.map_or(Toml::List(list), Toml::Table));
            }
            match &mut table {
                Some(table) => self.entry(table, depth + 1)?,
                None => list.push(self.value(depth + 1)?),
            }
            self.space(true);
            if !self.eat(",") && self.peek() != close.chars().next() {
                return Err("`,` or the closing bracket");
            }
        }
    }

    fn string(&mut self, quote: &str) -> Parsed<String> {
        let mut text = String::new();
        let (long, escapes) = (quote.len() == 3, quote.starts_with('"'));
        if long {
            self.eat("\n");
        }
        loop {
            if self.eat(quote) {
                return Ok(text);
            }
            let c = self.peek().filter(|c| long || *c != '\n').ok_or("the closing quote")?;
            self.at += 1;
            if c != '\\' || !escapes {
                text.push(c);
                continue;
            }
            let escaped = self.peek().ok_or("the closing quote")?;
            self.at += 1;
            match escaped {
                '"' | '\\' => text.push(escaped),
                'n' => text.push('\n'),
                't' => text.push('\t'),
                '\n' if long => {
                    while self.peek().is_some_and(char::is_whitespace) {
                        self.at += 1;
                    }
                }
                _ => return Err("one of the escapes \\\" \\\\ \\n \\t"),
            }
        }
    }
}

/// The table at a path of the file; of a list, its last one. Made when it is not there.
fn inner<'t>(file: &'t mut Toml, path: &[String]) -> Parsed<&'t mut Vec<(String, Toml)>> {
    let Toml::Table(table) = file else { return Err("a table") };
    descend(table, path)
}

fn descend<'t>(
    table: &'t mut Vec<(String, Toml)>,
    path: &[String],
) -> Parsed<&'t mut Vec<(String, Toml)>> {
    let Some((first, rest)) = path.split_first() else { return Ok(table) };
    let at = table.iter().position(|(name, _)| name == first).unwrap_or_else(|| {
        table.push((first.clone(), Toml::Table(Vec::new())));
        table.len() - 1
    });
    match &mut table[at].1 {
        Toml::Table(table) => descend(table, rest),
        Toml::List(list) => match list.last_mut() {
            Some(last) => inner(last, rest),
            None => Err("a table"),
        },
        _ => Err("a table"),
    }
}
