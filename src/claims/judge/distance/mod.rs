//! How far control data are from their limit: one oracle for the promises of tables and for
//! theorems.

mod attained;
mod compare;
mod known;
mod overshoot;
mod schemes;

pub(crate) use attained::{at_point, has_words, points};
pub(crate) use known::KnownDistances;
pub(crate) use overshoot::KnownOvershoots;
pub(crate) use schemes::{LocalCap, MAX_LOCAL_SIZE, MAX_STEPS, Schemes};
