//! Reading claim files.

#![allow(missing_docs)]

mod names;
