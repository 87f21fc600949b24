//! Reports: pages.

mod document;
mod html;
mod pictures;
