//! The catalogue of schemes.

use crate::toml::Toml;

/// The schemes that every claim file may name. They are data.
const CATALOGUE: [&str; 13] = [
    include_str!("../../../src/scheme/catalogue/b-spline.toml"),
    include_str!("../../../src/scheme/catalogue/bajaj.toml"),
    include_str!("../../../src/scheme/catalogue/catmull-clark.toml"),
    include_str!("../../../src/scheme/catalogue/chaikin.toml"),
    include_str!("../../../src/scheme/catalogue/doo-sabin.toml"),
    include_str!("../../../src/scheme/catalogue/four-point.toml"),
    include_str!("../../../src/scheme/catalogue/newton.toml"),
    include_str!("../../../src/scheme/catalogue/quaternary-four-point.toml"),
    include_str!("../../../src/scheme/catalogue/quinary-three-point.toml"),
    include_str!("../../../src/scheme/catalogue/six-point.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-four-point.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-four-point-approximating.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-three-point.toml"),
];

/// Reads the files of the catalogue.
pub fn catalogue() -> Result<Vec<Toml>, String> {
    CATALOGUE.iter().map(|text| Toml::read(text)).collect()
}
