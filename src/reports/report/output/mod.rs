//! Sheets as text, Markdown and LaTeX.

pub(super) mod fit;
pub(super) mod latex;
pub(super) mod latex_document;
pub(super) mod text;
