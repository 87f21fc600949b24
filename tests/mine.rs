#![allow(missing_docs, dead_code)]
mod architecture;
mod cli;
mod common;
mod net;
#[path = "patch/nets/mod.rs"]
mod nets;
