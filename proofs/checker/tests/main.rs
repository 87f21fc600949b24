//! The tests of the checker, in one program: one link, and `cargo test -p subcert-check rules::` runs one file.

#![allow(missing_docs)]

mod altered;
mod arithmetic;
mod bounds_on_pieces;
mod certificates;
mod claims;
mod command;
mod composed;
mod depth;
mod derivatives;
mod exact_roots;
mod exponents;
mod families;
mod family;
mod filters;
mod format;
mod integers;
mod kernel;
mod lattices;
mod limits;
mod lists;
mod masks;
mod moduli;
mod mutation;
mod names;
mod no_filters;
mod opposites;
mod radius;
mod random_independence;
mod random_reals;
mod ratios;
mod reals_of_index;
mod region_cells;
mod region_lines;
mod regions;
mod regular_vertices;
mod relations;
mod root_masks;
mod rules;
mod shape;
mod tangents;
mod toml;
mod twins;
mod vertices;
mod zeros;
