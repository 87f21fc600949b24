//! Exact numbers, the formulas that give them, and errors that point at a place in a file.
//!
//! | module | what it holds |
//! |---|---|
//! | [`cap`] | caps that a value is beyond |
//! | [`cores`] | work that is spread over all cores |
//! | [`diagnostic`] | errors that point at a place in a file |
//! | [`suggestion`] | what a misspelt name may have meant |
//! | [`exact`] | integers, rationals, cyclotomic and algebraic numbers, polynomials |
//! | [`files`] | which files a program may touch |
//! | [`machine`] | f64: conversion from and to exact numbers |
//! | [`stop`] | an end to work from another thread |
//! | [`formula`] | the expression language of masks and claims |

pub mod cap;
pub mod cores;
pub mod diagnostic;
pub mod exact;
pub mod files;
pub mod formula;
pub mod machine;
pub mod stop;
pub mod suggestion;
