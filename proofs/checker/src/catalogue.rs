//! The catalogue of schemes.

use crate::toml::Toml;

/// The schemes that every claim file may name. They are data.
const CATALOGUE: [&str; 18] = [
    include_str!("../catalogue/b-spline.toml"),
    include_str!("../catalogue/bajaj.toml"),
    include_str!("../catalogue/catmull-clark.toml"),
    include_str!("../catalogue/chaikin.toml"),
    include_str!("../catalogue/doo-sabin.toml"),
    include_str!("../catalogue/four-point.toml"),
    include_str!("../catalogue/loop.toml"),
    include_str!("../catalogue/loop-warren.toml"),
    include_str!("../catalogue/mid-edge.toml"),
    include_str!("../catalogue/modified-butterfly.toml"),
    include_str!("../catalogue/newton.toml"),
    include_str!("../catalogue/quaternary-four-point.toml"),
    include_str!("../catalogue/quinary-three-point.toml"),
    include_str!("../catalogue/six-point.toml"),
    include_str!("../catalogue/sqrt3.toml"),
    include_str!("../catalogue/ternary-four-point.toml"),
    include_str!("../catalogue/ternary-four-point-approximating.toml"),
    include_str!("../catalogue/ternary-three-point.toml"),
];

/// Reads the files of the catalogue.
pub fn catalogue() -> Result<Vec<Toml>, String> {
    CATALOGUE.iter().map(|text| Toml::read(text)).collect()
}
