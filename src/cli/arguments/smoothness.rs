//! The arguments of the commands about smoothness.

use super::Output;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(in crate::cli) struct SmoothnessArguments {
    /// The scheme: a mask, also with coefficients such as sqrt(3), of matrices of up to 24 rows
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// Write a certificate of the radius and of what follows, for subcert-check --radius
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct JsrArguments {
    /// Up to 64 square matrices of one size, up to 24 rows: one row of rational numbers on a line, and an
    /// empty line between two matrices
    #[arg(value_name = "FILE")]
    pub(in crate::cli) file: PathBuf,
    /// Write a certificate of both bounds, for subcert-check --radius
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}
