//! Words of which it is not clear what a compiler makes of them.

use super::language::Language;
use super::quoted::{is_digraph, regex_length, splits_word};
use super::token::{Kind, Tokens};

impl Tokens<'_> {
    /// Why the next word is refused, and what helps.
    pub(super) fn unclear(
        &self,
        kind: Kind,
        word: &str,
        rest: &str,
    ) -> Option<(&'static str, &'static str)> {
        let cut = "if the language reads it in one way, cut the file to the table";
        let in_matrix = matches!(self.open.last(), Some(('[' | '{', _)));
        match (kind, self.language) {
            (Kind::Sign('\\'), language) if language.has_preprocessor() => Some((
                "`\\` joins two lines outside of a macro",
                "write both as one line, without the `\\`",
            )),
            (Kind::Sign('\\'), Language::JavaScript) => {
                Some(("a name with `\\u`", "write the character itself"))
            }
            (Kind::Directive, _) if splits_word(word) => {
                Some(("`\\` joins two parts of a word", "write the word on one line"))
            }
            (Kind::Sign('<' | '%' | ':'), Language::C) if is_digraph(rest) => {
                Some(("two signs that stand for another one", "write `#`, `[`, `]`, `{` or `}`"))
            }
            // Python takes `ｗ` for `w`.
            (Kind::Name, Language::Python) if !word.is_ascii() => {
                Some(("a name with other than ASCII characters", "rename it, or cut the file"))
            }
            (Kind::Text | Kind::Sign('/'), Language::JavaScript)
                if self.seen.sign == Some('}') && regex_length(rest).is_some() =>
            {
                Some(("behind `}`, this divides or begins a regular expression", cut))
            }
            (Kind::Text, Language::Matlab)
                if word.starts_with('\'') && self.seen.value && !in_matrix =>
            {
                Some(("behind a blank, `'` transposes or begins a text", cut))
            }
            _ => None,
        }
    }
}
