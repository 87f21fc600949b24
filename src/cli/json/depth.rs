//! What `subcert depth` writes.

use crate::cli::constants::offset::BetterOffset;
use serde::Serialize;
use subcert::report::json::Exact;

/// The depth for a tolerance.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Report<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The tolerance ε.
    pub tolerance: String,
    /// The spread β.
    pub spread: String,
    /// The control polygon; null where none was given.
    pub polygon: Option<Polygon>,
    /// The true depth for every control polygon or net of the spread, each point of level k at its
    /// natural parameter (i + s)/n^k.
    pub natural: OrNone<Exactly<'a>>,
    /// The true depth with each point of level k at i/n^k, as papers do.
    pub indexed: OrNone<Exactly<'a>>,
    /// The depth by the sound bound.
    pub sound: Sound,
    /// The depths that papers compute.
    pub printed_formula: Vec<Printed>,
    /// The better offsets of files that state none; missing where there are none.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub better_offsets: &'a [BetterOffset],
}

/// An answer, or the reason that there is none.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum OrNone<T> {
    /// The answer.
    Found(T),
    /// There is none.
    None {
        /// The reason.
        none: String,
    },
}

/// A depth from both sides: the least level that meets the tolerance with all later ones.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TwoSided {
    /// A level that meets the tolerance with all later ones: the upper side.
    pub level: u32,
    /// The depth is at least this: the level before it does not meet the tolerance, or this is 0.
    pub lower: u32,
    /// The depth is at most this: this level and all later ones meet the tolerance.
    pub upper: u32,
    /// Whether `lower` and `upper` are the same.
    pub minimal: bool,
}

/// An interval that holds a number.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Interval {
    /// Its lower end.
    pub lower: Exact,
    /// Its upper end.
    pub upper: Exact,
}

/// A distance at a level.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Distance {
    /// An interval that holds it; its fields stand here.
    #[serde(flatten)]
    pub interval: Interval,
    /// The level.
    pub level: u32,
    /// Whether the interval is as narrow as was asked for.
    pub within_width: bool,
    /// A parameter at which the distance has the value of the lower end.
    pub parameter: Option<String>,
}

/// The true depth for every control polygon or net of the spread.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Exactly<'a> {
    /// The depth; its fields stand here.
    #[serde(flatten)]
    pub depth: TwoSided,
    /// The offset of each direction.
    pub offsets: &'a [i64],
    /// s for each direction.
    pub shifts: Vec<String>,
    /// Along each direction, whether the scheme takes lines to lines. If so, lines stay where they
    /// are in the natural shift; if not, this shift is the best in the mean.
    pub keeps_lines: &'a [bool],
    /// The greatest distance at the upper side of the depth.
    pub distance: Distance,
    /// Control data that are too far from their limit at the level below the depth.
    pub witness: Option<&'a Witness>,
}

/// Control data that are too far from their limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Witness {
    /// A piece of a control polygon.
    Polygon {
        /// The level.
        level: u32,
        /// The index of its first point.
        first: i64,
        /// Its points.
        points: Vec<i64>,
        /// What the points are multiplied by.
        times: String,
        /// The parameter at which the distance is too large.
        parameter: String,
        /// The distance there.
        distance: Exact,
    },
    /// A piece of a control net.
    Net {
        /// The level.
        level: u32,
        /// The indices of its first point.
        first: [i64; 2],
        /// Its points, row by row.
        net: Vec<Vec<i64>>,
        /// What the points are multiplied by.
        times: String,
        /// The parameters at which the distance is too large.
        parameters: [String; 2],
        /// The distance there.
        distance: Exact,
    },
}

/// A control polygon.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Polygon {
    /// How many points the polygon has.
    pub points: usize,
    /// How many coordinates a point has.
    pub coordinates: usize,
    /// Whether the last point is followed by the first.
    pub closed: bool,
    /// Its depth by the distance of sets of points; null for points of one coordinate and with
    /// `--distance parametric`.
    pub sets: Option<OrNone<Sets>>,
    /// Its depth with each point of level k at its natural parameter.
    pub natural: OrNone<OfPolygon>,
    /// The depth with each point of level k at i/n^k.
    pub indexed: OrNone<OfPolygon>,
}

/// The depth of a control polygon by the Hausdorff distance of polygon and limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sets {
    /// The least level found to be sufficient; null where the search ended before it found one.
    pub level: Option<u32>,
    /// Why the search ended early.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<String>,
    /// The greatest level that is certainly not sufficient, with all below it.
    pub too_few: Option<u32>,
    /// A point that shows that `too_few` is not sufficient.
    pub too_far: Option<SetPlace>,
}

/// A point of one set that is far from the other.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SetPlace {
    /// `polygon` or `limit`.
    pub from: &'static str,
    /// Its natural parameter.
    pub parameter: String,
    /// The point, to f64.
    pub point: Vec<String>,
    /// The point is at least so far from the other set.
    pub distance: String,
}

/// The depth of a control polygon.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OfPolygon {
    /// The depth; its fields stand here.
    #[serde(flatten)]
    pub depth: TwoSided,
    /// Its distance at the upper side of the depth.
    pub distance: DistanceOfPolygon,
    /// A place at which it is too far from its limit at the level below the depth.
    pub too_far: Option<TooFar>,
}

/// The distance of a control polygon: the greatest of its coordinates.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DistanceOfPolygon {
    /// The distance; its fields stand here.
    #[serde(flatten)]
    pub distance: Distance,
    /// The coordinate with that distance, counted from 1.
    pub coordinate: usize,
}

/// A place at which a control polygon is too far from its limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TooFar {
    /// The level.
    pub level: u32,
    /// The coordinate, counted from 1.
    pub coordinate: usize,
    /// The parameter.
    pub parameter: String,
    /// The distance there.
    pub distance: Exact,
}

/// The depth by the sound bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sound {
    /// The depth; null where there is none.
    pub depth: Option<u32>,
    /// The block length of the bound; missing where there is no depth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block: Option<u32>,
    /// Why there is no depth; missing where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

/// The depth by the printed formula.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Printed {
    /// The block length c.
    pub c: u32,
    /// The constant as papers print it.
    pub constant: Exact,
    /// The depth.
    pub depth: Option<u32>,
    /// Why there is none.
    pub note: Option<String>,
}
