//! A reader of pages: their pieces in order, unless they are not well-formed.

use html5gum::{Token, Tokenizer};
use std::collections::BTreeMap;

/// Elements without contents.
const VOID: [&str; 6] = ["br", "hr", "img", "input", "link", "meta"];

/// A tag or a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// A start tag: its name and attributes.
    Start(String, BTreeMap<String, String>),
    /// An end tag.
    End(String),
    /// A text.
    Text(String),
}

impl Piece {
    /// An attribute of a start tag.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        match self {
            Piece::Start(_, attributes) => attributes.get(name).map(String::as_str),
            _ => None,
        }
    }

    /// Whether it is the start of an element of this name and class.
    pub fn is(&self, name: &str, class: &str) -> bool {
        let classes = self.attribute("class").unwrap_or_default();
        matches!(self, Piece::Start(own, _) if own == name)
            && classes.split(' ').any(|own| own == class)
    }

    /// A number in an attribute.
    pub fn number(&self, name: &str) -> f64 {
        let text = self.attribute(name).unwrap_or_else(|| panic!("no {name} in {self:?}"));
        text.parse().unwrap_or_else(|_| panic!("{name} = {text}"))
    }
}

/// The pieces of a page.
///
/// # Panics
/// When the tokenizer of the HTML standard finds an error, or an element is not closed where it should.
pub fn read(page: &str) -> Vec<Piece> {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("UTF-8");
    let (mut pieces, mut open) = (Vec::new(), Vec::new());
    for Ok(token) in Tokenizer::new(page) {
        match token {
            Token::StartTag(tag) => {
                let name = text(&tag.name);
                let attributes = tag.attributes.iter();
                let attributes = attributes.map(|(name, value)| (text(name), text(&value.value)));
                if !VOID.contains(&name.as_str()) {
                    open.push(name.clone());
                }
                pieces.push(Piece::Start(name, attributes.collect()));
            }
            Token::EndTag(tag) => {
                let name = text(&tag.name);
                assert_eq!(open.pop().as_ref(), Some(&name), "closed in another order");
                pieces.push(Piece::End(name));
            }
            Token::String(found) => pieces.push(Piece::Text(text(&found.value))),
            Token::Doctype(_) | Token::Comment(_) => {}
            Token::Error(error) => panic!("{error:?} after {:?}", pieces.last()),
        }
    }
    assert!(open.is_empty(), "not closed: {open:?}");
    pieces
}

/// The pieces within the first element that `is` holds for, with its tags.
pub fn within(pieces: &[Piece], is: impl Fn(&Piece) -> bool) -> Vec<Piece> {
    let from = pieces.iter().position(is).expect("such an element");
    let mut depth = 0_usize;
    for (place, piece) in pieces.iter().enumerate().skip(from) {
        match piece {
            Piece::Start(name, _) if !VOID.contains(&name.as_str()) => depth += 1,
            Piece::End(_) => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return pieces[from..=place].to_vec();
        }
    }
    panic!("not closed")
}

/// All text of pieces.
pub fn text(pieces: &[Piece]) -> String {
    let text = pieces.iter().map(|piece| match piece {
        Piece::Text(text) => text.as_str(),
        _ => "",
    });
    text.collect()
}
