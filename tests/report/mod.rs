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
mod notation;
mod pictures;
mod plots;
mod sets;
mod smoothness;
mod witnesses;
