//! The arguments of the commands about spectra.

use super::Output;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use subcert::spectrum::table::{Language, RealType};

#[derive(Debug, Args)]
pub(in crate::cli) struct SpectrumArguments {
    /// The rules around a vertex or on a face
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The valence: the value of the parameter N or n of the rules
    #[arg(long, value_name = "N", value_parser = valence)]
    pub(in crate::cli) valence: Option<usize>,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct TableArguments {
    /// The rules around a vertex or on a face, or a mask
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The valences of rules around a vertex or on a face, from the first to the last
    #[arg(long, value_name = "FIRST..LAST", value_parser = valences)]
    pub(in crate::cli) valences: Option<(usize, usize)>,
    /// The language
    #[arg(long, value_enum)]
    pub(in crate::cli) format: LanguageArgument,
    /// The type of the numbers
    #[arg(long = "type", value_enum, default_value_t = TypeArgument::F64, value_name = "TYPE")]
    pub(in crate::cli) real: TypeArgument,
    /// Write the table into this file
    #[arg(short, long, value_name = "FILE")]
    pub(in crate::cli) output: Option<PathBuf>,
}

/// The languages of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum LanguageArgument {
    /// C99
    C,
    /// C++11
    Cpp,
    /// Rust
    Rust,
    /// Python
    Python,
    /// GLSL 3.30, or 4.00 for f64
    Glsl,
    /// JSON
    Json,
}

impl From<LanguageArgument> for Language {
    fn from(argument: LanguageArgument) -> Language {
        match argument {
            LanguageArgument::C => Language::C,
            LanguageArgument::Cpp => Language::Cpp,
            LanguageArgument::Rust => Language::Rust,
            LanguageArgument::Python => Language::Python,
            LanguageArgument::Glsl => Language::Glsl,
            LanguageArgument::Json => Language::Json,
        }
    }
}

/// The types of the numbers in tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TypeArgument {
    /// 32 bits
    F32,
    /// 64 bits
    F64,
}

impl From<TypeArgument> for RealType {
    fn from(argument: TypeArgument) -> RealType {
        match argument {
            TypeArgument::F32 => RealType::F32,
            TypeArgument::F64 => RealType::F64,
        }
    }
}

/// A valence.
fn valence(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "a valence is a whole number from 3 on".to_owned())
}

/// The first and the last valence; a single number is both.
pub(super) fn valences(text: &str) -> Result<(usize, usize), String> {
    let form = || "write the first and the last valence, such as 3..12, or a single one".to_owned();
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let number = |text: &str| text.trim().parse::<usize>().map_err(|_| form());
    let (first, last) = (number(first)?, number(last)?);
    if first > last {
        return Err(format!("the first valence, {first}, is above the last, {last}"));
    }
    Ok((first, last))
}
