//! Constructors that keep the numbers in them.

use super::declared::{Element, count, element};
use super::entry::Entry;
use super::language::{Language, Precision};
use super::reader::Reader;
use super::token::Kind;
use crate::diagnostic::Diagnostic;

/// What stands in the brackets of a constructor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// The numbers.
    Numbers,
    /// This many of them.
    Exactly(usize),
    /// One list.
    List,
}

/// A constructor here.
pub(super) struct Constructor {
    holds: Holds,
    element: Option<Element>,
    /// The bracket that opens.
    open: usize,
}

impl Reader<'_> {
    /// The constructor that begins here; `None` where no call does, or a conversion of one number.
    ///
    /// # Errors
    /// Of another call.
    pub(super) fn constructor(&self) -> Result<Option<Constructor>, Diagnostic> {
        let new = usize::from(self.text(self.at) == "new");
        let mut open = self.at + new;
        let name_begins = open;
        while self.kind(open) == Some(Kind::Name) {
            open += 1;
            let dot = usize::from(self.text(open) == ".");
            let colons = if self.text(open) == ":" && self.text(open + 1) == ":" { 2 } else { 0 };
            if self.text(open) == "!" || dot + colons == 0 {
                break;
            }
            open += dot + colons;
        }
        open += usize::from(self.language == Language::Rust && self.text(open) == "!");
        let name: String = (name_begins..open).map(|at| self.text(at)).collect();
        let (open, of_template) = self.template(open);
        let after_size = self.size(open);
        let sized = after_size.is_some();
        let open = after_size.unwrap_or(open);
        let calls = match self.text(open) {
            "(" => {
                let converts = self.cast(self.at).is_some() && open == self.at + 1;
                !converts || self.language == Language::Matlab && self.text(open + 1) == "["
            }
            "{" => true,
            "[" => name.ends_with('!'),
            _ => false,
        };
        if !calls {
            return Ok(None);
        }
        let braces = self.text(open) == "{";
        match known(self.language, &name, new == 1, sized, braces) {
            Some((holds, element)) => {
                Ok(Some(Constructor { holds, element: element.or(of_template), open }))
            }
            None => Err(self.wrong(format!(
                "a call of `{name}`: what it makes of the numbers in it is not computed"
            ))),
        }
    }

    /// The bracket behind `<…>` of WGSL, and the type of numbers that it names.
    fn template(&self, open: usize) -> (usize, Option<Element>) {
        if self.language != Language::Wgsl || self.text(open) != "<" {
            return (open, None);
        }
        let (mut at, mut depth, mut found) = (open, 0_usize, None);
        while let Some(kind) = self.kind(at) {
            match kind {
                Kind::Sign('<') => depth += 1,
                Kind::Sign('>') => depth -= 1,
                Kind::Name => {
                    found = element(self.text(at), self.language).map(|(one, _)| one).or(found);
                }
                _ => {}
            }
            at += 1;
            if depth == 0 {
                break;
            }
        }
        (at, found)
    }

    /// The bracket behind the size, as in `float[7](…)`.
    fn size(&self, open: usize) -> Option<usize> {
        let mut at = open;
        while self.text(at) == "[" {
            at += 1 + usize::from(self.kind(at + 1) == Some(Kind::Number));
            (self.text(at) == "]").then_some(())?;
            at += 1;
        }
        (at > open && matches!(self.text(at), "(" | "{")).then_some(at)
    }

    /// The numbers of a constructor.
    pub(super) fn construct(
        &mut self,
        constructor: &Constructor,
        entries: &mut Vec<Entry>,
        depth: usize,
    ) -> Result<(), Diagnostic> {
        let name = self.at..constructor.open;
        let span = self.span();
        self.types.extend(constructor.element.map(|element| (element, span.clone())));
        self.at = constructor.open;
        if constructor.holds == Holds::List {
            let number = !matches!(self.text(self.at + 1), "[" | "(" | "{")
                && self.kind(self.at + 1) != Some(Kind::Name);
            let several = self.commas(self.at) > 0 && self.language != Language::Python;
            if number || several {
                let name: String = name.map(|at| self.text(at)).collect();
                return Err(self.wrong(format!("`{name}` is read with one list in it only")));
            }
        }
        self.mixes = matches!(constructor.holds, Holds::Exactly(_));
        let before = entries.len();
        if constructor.holds == Holds::List && self.language == Language::Python {
            self.list_and_type(entries, depth)?;
        } else {
            self.group(entries, depth)?;
        }
        let found = entries.len() - before;
        match constructor.holds {
            Holds::Exactly(wanted) if found != wanted => {
                self.at = name.start;
                let message = format!("{found} numbers, where {wanted} are expected");
                Err(self.wrong(message))
            }
            _ => Ok(()),
        }
    }
}

impl Reader<'_> {
    /// `([…])`, and the type behind the list of numpy: `([…], dtype=np.float64)`, also without `dtype=`.
    fn list_and_type(&mut self, entries: &mut Vec<Entry>, depth: usize) -> Result<(), Diagnostic> {
        self.at += 1;
        let name = self.peek() == Some(Kind::Name);
        match if name { self.constructor()? } else { None } {
            Some(inner) => self.construct(&inner, entries, depth + 1)?,
            None => self.group(entries, depth + 1)?,
        }
        if self.text(self.at) == "," && self.text(self.at + 1) != ")" {
            self.at += 1;
            if self.text(self.at) == "dtype" && self.text(self.at + 1) == "=" {
                self.at += 2;
            }
            let begins = self.at;
            while self.kind(self.at) == Some(Kind::Name) && self.text(self.at + 1) == "." {
                self.at += 2;
            }
            // `'float32'` and `"<f4"` too.
            let word = self.text(self.at).trim_matches(['"', '\'', '<', '>', '=']);
            let known = match word {
                "f4" => Some(Element::Float(Precision::Single)),
                "f8" | "d" => Some(Element::Float(Precision::Double)),
                _ => numpy(word).or_else(|| element(word, self.language).map(|(one, _)| one)),
            };
            let Some(known) = known else {
                self.at = begins;
                return Err(self.wrong(format!(
                    "`{}` is no type of numbers that is read: write one such as dtype=np.float64",
                    self.text(begins)
                )));
            };
            let span = self.span();
            self.types.push((known, span));
            self.at += 1;
        }
        self.at += usize::from(self.text(self.at) == ",");
        if self.text(self.at) != ")" {
            return Err(self.wrong(format!(
                "`{}`: behind the list, only its type is read, as dtype=np.float64",
                self.text(self.at)
            )));
        }
        self.at += 1;
        Ok(())
    }
}

/// The types of numpy that only it calls so; integers have 32 bits on some machines.
fn numpy(word: &str) -> Option<Element> {
    match word {
        "single" => Some(Element::Float(Precision::Single)),
        "double" | "float_" => Some(Element::Float(Precision::Double)),
        "int" | "int_" | "intp" => Some(Element::Whole { bits: 32, signed: true }),
        _ => None,
    }
}

/// What a constructor holds, and the type that it gives to its numbers.
fn known(
    language: Language,
    name: &str,
    new: bool,
    sized: bool,
    braces: bool,
) -> Option<(Holds, Option<Element>)> {
    let double = Some(Element::Float(Precision::Double));
    let single = Some(Element::Float(Precision::Single));
    let last = name.rsplit(':').next().unwrap_or_default();
    match language {
        Language::C | Language::Shader | Language::Hlsl => {
            if let "std::array" | "std::vector" | "std::initializer_list" = name {
                return braces.then_some((Holds::Numbers, None));
            }
            let plain = last.strip_prefix("make_").unwrap_or(last);
            if let Some((element, count)) = element(plain, language) {
                let holds = if sized { Holds::Numbers } else { Holds::Exactly(count) };
                // `double(0.1, 0.2)` is none.
                return (sized || count > 1).then_some((holds, Some(element)));
            }
            // Of a program's own types, the name says how many numbers they have.
            let square = last.starts_with("mat");
            let size = last.strip_prefix("vec").or_else(|| last.strip_prefix("mat"))?;
            let count = count(size, square).filter(|_| !size.is_empty())?;
            Some((if sized { Holds::Numbers } else { Holds::Exactly(count) }, None))
        }
        Language::JavaScript => {
            let (base, way) = name.split_once('.').unwrap_or((name, ""));
            match (base, way, new) {
                ("Object", "freeze", _) | ("Array", "from", _) => return Some((Holds::List, None)),
                ("Array", "of", _) => return Some((Holds::Numbers, None)),
                _ => {}
            }
            let (element, _) = element(base, language).filter(|_| base.ends_with("Array"))?;
            match (way, new) {
                ("", true) | ("from", false) => Some((Holds::List, Some(element))),
                ("of", false) => Some((Holds::Numbers, Some(element))),
                _ => None,
            }
        }
        Language::Python => {
            let plain = name.strip_prefix("np.").or_else(|| name.strip_prefix("numpy."));
            match (plain, name) {
                (Some("array" | "asarray"), _) | (_, "array" | "asarray" | "list" | "tuple") => {
                    Some((Holds::List, None))
                }
                (Some("float32" | "single"), _) => Some((Holds::List, single)),
                (Some("float64" | "double"), _) => Some((Holds::List, double)),
                _ => None,
            }
        }
        Language::Wgsl => {
            if name == "array" {
                return Some((Holds::Numbers, None));
            }
            if let Some((element, count)) = element(name, language).filter(|(_, count)| *count > 1)
            {
                return Some((Holds::Exactly(count), Some(element)));
            }
            let size = name.strip_prefix("vec").or_else(|| name.strip_prefix("mat"))?;
            let count = count(size, false).filter(|_| !size.is_empty())?;
            Some((Holds::Exactly(count), None))
        }
        Language::Matlab => match name {
            "single" => Some((Holds::List, single)),
            "double" => Some((Holds::List, double)),
            _ => None,
        },
        Language::Rust => match name {
            "vec!" => Some((Holds::Numbers, None)),
            "Vec::from" | "Box::new" => Some((Holds::List, None)),
            _ => None,
        },
    }
}
