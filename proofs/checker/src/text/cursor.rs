//! A position in a text. Parsers read from there.

/// The value that a parser reads, or a description of what it expected.
pub type Parsed<T> = Result<T, &'static str>;

/// A text and the position up to which it has been read.
pub struct Cursor {
    text: Vec<char>,
    at: usize,
}

impl Cursor {
    /// The beginning of a text.
    pub fn new(text: &str) -> Cursor {
        Cursor { text: text.chars().collect(), at: 0 }
    }

    /// The next character.
    pub fn peek(&self) -> Option<char> {
        self.text.get(self.at).copied()
    }

    /// Takes the next character.
    pub fn next(&mut self) -> Option<char> {
        self.at += 1;
        self.text.get(self.at - 1).copied()
    }

    /// Whether a token stands here.
    pub fn is_at(&self, token: &str) -> bool {
        let rest = self.text[self.at.min(self.text.len())..].iter();
        rest.copied().take(token.chars().count()).eq(token.chars())
    }

    /// Takes a token if it stands here.
    pub fn eat(&mut self, token: &str) -> bool {
        let found = self.is_at(token);
        self.at += if found { token.chars().count() } else { 0 };
        found
    }

    /// Takes blanks and line ends.
    pub fn space(&mut self) {
        self.take(char::is_whitespace);
    }

    /// Takes a token and the blanks behind it, if it stands here.
    pub fn token(&mut self, token: &str) -> bool {
        let found = self.eat(token);
        if found {
            self.space();
        }
        found
    }

    /// Takes a token. It has to stand here.
    pub fn expect(&mut self, token: &'static str) -> Parsed<()> {
        if self.eat(token) { Ok(()) } else { Err(token) }
    }

    /// Takes a text, which is described by `what`. It has to stand here.
    pub fn expect_text(&mut self, text: &str, what: &'static str) -> Parsed<()> {
        if self.eat(text) { Ok(()) } else { Err(what) }
    }

    /// Takes the characters that fit.
    pub fn take(&mut self, fits: impl Fn(char) -> bool) -> String {
        let start = self.at.min(self.text.len());
        let taken: String = self.text[start..].iter().take_while(|c| fits(**c)).collect();
        self.at += taken.chars().count();
        taken
    }

    /// The position.
    pub fn at(&self) -> usize {
        self.at
    }

    /// Returns to a position.
    pub fn back(&mut self, at: usize) {
        self.at = at;
    }

    /// The line of the position, counted from 1.
    pub fn line(&self) -> usize {
        1 + self.text[..self.at.min(self.text.len())].iter().filter(|c| **c == '\n').count()
    }

    /// A message that says what was expected, and in which line and column.
    pub fn expected(&self, what: &str) -> String {
        let before = &self.text[..self.at.min(self.text.len())];
        let line = self.line();
        let column = 1 + before.iter().rev().take_while(|c| **c != '\n').count();
        format!("expected {what} in line {line}, column {column}")
    }
}
