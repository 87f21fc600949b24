//! How far control data are from their limit: one oracle for the promises of tables and for
//! theorems.

mod known;
mod schemes;

pub(crate) use known::{Compared, KnownDistances, at_point, has_words, points};
pub(crate) use schemes::{LocalCap, MAX_LOCAL_SIZE, MAX_STEPS, Schemes};
