//! Judging tables, functions, ranges, smoothness and theorems.

mod caps;
mod copied;
mod cut;
mod every_shift;
mod families;
mod functions_and_ranges;
mod integers;
mod lattice;
mod lattice_limits;
mod lattice_ranges;
mod lines;
mod numbers;
mod proportional;
mod readings;
mod real_indices;
mod reals;
mod recovered;
mod relations;
mod scheme_headers;
mod smoothness;
mod theorem_verdicts;
mod theorems;
