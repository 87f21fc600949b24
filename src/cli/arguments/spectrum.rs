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
    #[arg(long, alias = "valences", value_name = "N", value_parser = valence)]
    pub(in crate::cli) valence: Option<usize>,
    /// In place of a valence: the number of faces between two sharp edges at the vertex, or at a boundary vertex
    #[arg(long, value_name = "FACES", value_parser = faces, conflicts_with = "valence")]
    pub(in crate::cli) sector: Option<usize>,
    /// The vertex of the sector is a corner, which stays where it is
    #[arg(long, requires = "sector", conflicts_with = "valence")]
    pub(in crate::cli) corner: bool,
    #[command(flatten)]
    pub(in crate::cli) output: Output,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct TableArguments {
    /// The rules around a vertex or on a face, or a mask
    #[arg(value_name = "SCHEME")]
    pub(in crate::cli) scheme: String,
    /// The valences of rules around a vertex or on a face, from the first to the last
    #[arg(long, alias = "valence", value_name = "FIRST..LAST", value_parser = valences)]
    pub(in crate::cli) valences: Option<(usize, usize)>,
    /// In place of valences: the numbers of faces between two sharp edges at the vertex, from the first to the last
    #[arg(long, value_name = "FIRST..LAST", value_parser = sectors, conflicts_with = "valences")]
    pub(in crate::cli) sectors: Option<(usize, usize)>,
    /// The vertices of the sectors are corners, which stay where they are
    #[arg(long, requires = "sectors", conflicts_with = "valences")]
    pub(in crate::cli) corner: bool,
    /// The language
    #[arg(long, value_enum)]
    pub(in crate::cli) format: LanguageArgument,
    /// The type of the numbers: f64 where it is not given, and f32 of WGSL, which has no other
    #[arg(long = "type", value_enum, value_name = "TYPE")]
    pub(in crate::cli) real: Option<TypeArgument>,
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
    /// HLSL, from shader model 5 on for f64
    Hlsl,
    /// WGSL, f32 only
    Wgsl,
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
            LanguageArgument::Hlsl => Language::Hlsl,
            LanguageArgument::Wgsl => Language::Wgsl,
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
    let several = "; `subcert scheme` and `subcert table` take several";
    let end = if text.contains("..") { several } else { "" };
    text.parse().map_err(|_| format!("a valence is a whole number from 3 on{end}"))
}

/// A number of faces.
fn faces(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| "a number of faces is a whole number from 1 on".to_owned())
}

/// The first and the last number of faces; a single number is both.
fn sectors(text: &str) -> Result<(usize, usize), String> {
    both(text, "number of faces", "1..8")
}

/// The first and the last valence; a single number is both.
pub(super) fn valences(text: &str) -> Result<(usize, usize), String> {
    both(text, "valence", "3..12")
}

fn both(text: &str, what: &str, example: &str) -> Result<(usize, usize), String> {
    let form =
        || format!("write the first and the last {what}, such as {example}, or a single one");
    let (first, last) = text.split_once("..").unwrap_or((text, text));
    let number = |text: &str| text.trim().parse::<usize>().map_err(|_| form());
    let (first, last) = (number(first)?, number(last)?);
    if first > last {
        return Err(format!("the first {what}, {first}, is above the last, {last}"));
    }
    Ok((first, last))
}
