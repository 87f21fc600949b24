//! The arguments of the commands about smoothness.

use super::{FindingOutput, Output};
use clap::Args;
use std::path::PathBuf;
use subcert::joint::{MAX_MATRICES, MAX_SIZE};

#[derive(Debug, Args)]
pub(in crate::cli) struct SmoothnessArguments {
    #[arg(value_name = "SCHEME", help = format!(
        "The scheme: a mask, whose coefficients may be irrational, such as sqrt(3), and whose matrices may have up to \
         {MAX_SIZE} rows; or rules around a vertex or on a face, where C¹ is meant in Reif's sense: for surfaces with \
         generic data, at the vertex or on the face, with the smoothness of the regular part elsewhere"
    ))]
    pub(in crate::cli) scheme: String,
    /// Rules around a vertex or on a face: the valences, or all from 3 on at once
    #[arg(long, alias = "valence", value_name = "FIRST..LAST|all", value_parser = valences, conflicts_with = "certificate")]
    pub(in crate::cli) valences: Option<Valences>,
    /// Write a certificate of the radius and of what follows, for subcert-check --radius
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) output: FindingOutput,
}

/// The greatest valence of a table: its time grows with the square of the valence.
const MAX_VALENCE: usize = 100;

/// Some valences, or all from 3 on.
#[derive(Clone, Copy, Debug)]
pub(in crate::cli) enum Valences {
    Some(usize, usize),
    All,
}

pub(super) fn valences(text: &str) -> Result<Valences, String> {
    if text == "all" {
        return Ok(Valences::All);
    }
    let (first, last) = super::spectrum::valences(text)?;
    if last > MAX_VALENCE {
        return Err(format!("valences up to {MAX_VALENCE} only; `all` is for all at once"));
    }
    Ok(Valences::Some(first, last))
}

#[derive(Debug, Args)]
pub(in crate::cli) struct JsrArguments {
    #[arg(value_name = "FILE", help = format!(
        "Up to {MAX_MATRICES} square matrices of one size, up to {MAX_SIZE} rows: one row of rational numbers on a \
         line, and an empty line between two matrices"
    ))]
    pub(in crate::cli) file: PathBuf,
    /// Whether the radius is below this number; for a certificate of it with few rows
    #[arg(long, value_name = "NUMBER")]
    pub(in crate::cli) below: Option<String>,
    /// Write a certificate of both bounds, for subcert-check --radius
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}
