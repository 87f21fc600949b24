//! Reports: pages.

mod document;
mod html;
mod latex;
mod pictures;
