//! What a command finds, as a page: one sentence, numbers, pictures, and the command.

use crate::report::html::document::document;
use crate::report::html::sheet::blocks;
use crate::report::html::typeset::typeset;
use crate::report::words::notation::unicode;
use crate::report::words::sheet::{Block, Sheet};
use maud::{Markup, html};

/// A picture with its caption.
#[derive(Clone, Debug)]
pub struct Picture(pub(crate) Markup);

/// The parts of a page about one computation.
#[derive(Clone, Debug)]
pub struct FindingPage<'p> {
    /// What is found, in a sentence.
    pub sentence: &'p str,
    /// The report; its heading becomes that of the page, and the names with values that follow it stand above the
    /// pictures.
    pub sheet: &'p Sheet,
    /// The pictures.
    pub pictures: &'p [Picture],
    /// The command that shows all this again.
    pub command: &'p str,
}

impl FindingPage<'_> {
    /// The page, in one file that loads nothing.
    ///
    /// ```
    /// use subcert::report::{Sheet, html::FindingPage};
    ///
    /// let mut sheet = Sheet::default();
    /// sheet.heading(1, "chaikin");
    /// let command = "subcert depth chaikin --tolerance 1/10";
    /// let page = FindingPage { sentence: "2 levels.", sheet: &sheet, pictures: &[], command };
    /// assert!(page.to_html().contains("<h1>chaikin</h1>"));
    /// ```
    #[must_use]
    pub fn to_html(&self) -> String {
        let (mut title, mut above, mut below) = (String::new(), Sheet::default(), Sheet::default());
        for block in &self.sheet.blocks {
            match block {
                Block::Heading(1, text) if title.is_empty() => title.clone_from(text),
                Block::Facts(_) if below.blocks.is_empty() => above.blocks.push(block.clone()),
                block => below.blocks.push(block.clone()),
            }
        }
        let main = html! {
            header { h1 { (typeset(&title)) } }
            main id="page:main" tabindex="-1" {
                p.headline { strong { (typeset(self.sentence)) } }
                div.beside {
                    section { (blocks(&above, 1)) }
                    @for Picture(picture) in self.pictures { (picture) }
                    section { (blocks(&below, 1)) }
                    p.command { "Reproduce: " code { (self.command) } }
                }
            }
        };
        document(&format!("{} · subcert", unicode(&title)), &main)
    }
}
