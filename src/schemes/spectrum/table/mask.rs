//! The coefficients of a mask as source code.

use super::arrays::{Array, Entries};
use super::language::Language;
use super::real::{Real, RealType};
use super::write::{Origin, identifier};
use super::writer::Writer;
use crate::exact::{Enclosed, Scalar};
use crate::limit::Functional;
use crate::scheme::Mask;

/// The rules of a mask as source code, and, where it is known, the limit at 0. The first lines say how to check it.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::spectrum::table::{Language, Origin, RealType, write_mask};
///
/// let scheme = parse_scheme("chaikin")?;
/// let origin = Origin { scheme: "chaikin", command: "subcert table chaikin --format rust" };
/// let text = write_mask(scheme.masks()[0], None, Language::Rust, RealType::F64, &origin);
/// assert!(text.contains("pub const WEIGHTS: [[f64; 2]; 2] = [\n    [0.75, 0.25],\n    [0.25, 0.75],\n];"));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
///
/// # Panics
/// When the language has no numbers of the type ([`Language::types`]).
#[must_use]
pub fn write_mask<F: Scalar + Enclosed>(
    mask: &Mask<F>,
    limit: Option<&Functional>,
    language: Language,
    real: RealType,
    origin: &Origin<'_>,
) -> String {
    let (name, bits) = match real {
        RealType::F32 => ("f32", 32),
        RealType::F64 => ("f64", 64),
    };
    let header = vec![
        format!("The rules of {}.", origin.scheme),
        format!("Every number is the {name} (IEEE 754, {bits} bits) nearest to its exact value."),
        format!("Written by subcert {}:", env!("CARGO_PKG_VERSION")),
        format!("    {}", origin.command),
        "To check a copy, write it again by this command and compare.".to_owned(),
    ];
    let row = |row: &Vec<F>| row.iter().map(|weight| Real::nearest(weight, real)).collect();
    let mut arrays = vec![Array {
        name: "weights",
        about: vec![
            "new point arity*i + a: weights[a][j] is the weight of point i + offset + j".to_owned(),
        ],
        entries: Entries::Table(mask.rules().rows().iter().map(row).collect()),
    }];
    let arity = i64::try_from(mask.arity()).expect("a small arity");
    let mut constants = vec![("arity", arity), ("offset", mask.offset())];
    if let Some((limit, (first, last))) = limit.and_then(|limit| Some((limit, limit.support()?))) {
        constants.push(("limit_first", first));
        let weights = (first..=last).map(|i| Real::nearest(&limit.coefficient(i), real)).collect();
        arrays.push(Array {
            name: "limit",
            about: vec![
                "where point i of level k goes, seen at the parameter i/arity^k: limit[j] is the weight of point".to_owned(),
                "i + limit_first + j of that level".to_owned(),
            ],
            entries: Entries::List(vec![weights]),
        });
    }
    let name = identifier(origin.scheme);
    Writer { language, real, name, constants, vectors: false }.written(&header, &arrays)
}
