//! Reports: pages and documents.

mod depth_pictures;
mod document;
mod explained;
mod eye;
mod figures;
mod headline;
mod html;
mod latex;
mod latex_table;
mod pictures;
mod plots;
mod smoothness;
mod witnesses;
