#![allow(missing_docs, dead_code)]
mod common;
mod mesh;
mod patch;
mod solid;
