//! The schemes that nets are refined by.

use super::error::NetError;
use crate::mesh::MeshScheme;
use crate::scheme::{Mask, parse_scheme};

/// The tensor product of two curve schemes, by its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NetScheme {
    name: String,
    masks: [Mask; 2],
}

/// Names that are used for nets alone, and the curve that serves both directions.
const SHORT: [(&str, &str); 2] =
    [("bicubic", "b-spline:degree=3"), ("biquadratic", "b-spline:degree=2")];

impl NetScheme {
    /// The scheme of this name: a curve, which then serves both directions; two with ` x ` between
    /// them, the first from row to row, the second along the rows; `bicubic` or `biquadratic`.
    ///
    /// # Errors
    /// When there is none, or it is one for polygon meshes.
    ///
    /// ```
    /// use subcert::net::NetScheme;
    ///
    /// let bicubic = NetScheme::parse("bicubic")?;
    /// let curve = NetScheme::parse("b-spline:degree=3")?;
    /// assert_eq!(bicubic.masks(), curve.masks());
    /// let mixed = NetScheme::parse("chaikin x four-point:w=1/16")?;
    /// assert_eq!(mixed.masks().each_ref().map(|mask| mask.width()), [2, 4]);
    /// # Ok::<(), subcert::net::NetError>(())
    /// ```
    pub fn parse(text: &str) -> Result<NetScheme, NetError> {
        let name = text.trim();
        if MeshScheme::parse(name).is_ok() {
            return Err(NetError::ForMeshes(name.to_owned()));
        }
        let short = SHORT.iter().find(|(short, _)| *short == name);
        let meant = short.map_or(name, |(_, curve)| curve);
        let masks = parse_scheme(meant)?.pair();
        Ok(NetScheme { name: name.to_owned(), masks })
    }

    /// The tensor product of two masks, the first from row to row; its name says no more.
    #[must_use]
    pub fn of_masks(masks: [Mask; 2]) -> NetScheme {
        NetScheme { name: "a tensor product".to_owned(), masks }
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The masks of u, from row to row, and of v.
    #[must_use]
    pub fn masks(&self) -> &[Mask; 2] {
        &self.masks
    }
}
