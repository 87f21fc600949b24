#![allow(missing_docs, dead_code)]
mod common;
mod net;
#[path = "patch/nets/mod.rs"]
mod nets;
