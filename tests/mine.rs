#![allow(missing_docs)]
mod common;
#[path = "joint/mod.rs"]
mod joint;
#[path = "smoothness/mod.rs"]
mod smoothness;
