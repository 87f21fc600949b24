//! Judging tables, functions, ranges and theorems.

mod copied;
mod every_shift;
mod functions_and_ranges;
mod lines;
mod proportional;
mod readings;
mod recovered;
mod scheme_headers;
mod theorem_verdicts;
mod theorems;
