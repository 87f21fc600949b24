//! Whether a printed bound or depth keeps its promise.

use crate::audit::{self, CellFinding, Kept};
use crate::report::json::exact::Exact;
use crate::report::words::data::name;
use serde::Serialize;

/// Whether a printed bound or depth keeps its promise for all control data.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Promise<'a> {
    /// Whether it does; null where that is open.
    pub kept: Option<bool>,
    /// Why that is open; missing where it is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open: Option<String>,
    /// Control data that break the promise; missing where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub broken_by: Option<Broken<'a>>,
    /// Whether the promise is kept with each point at its natural parameter; missing where it is
    /// kept with the points at i/n^k, or where these are the natural parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub natural: Option<Natural<'a>>,
}

/// Control data that break a promise.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Broken<'a> {
    /// The data for spread 1, and the place; their fields stand here.
    #[serde(flatten)]
    pub data: ControlData<'a>,
    /// The spread that the data are multiplied by.
    pub times: String,
    /// The level.
    pub level: u32,
    /// The distance from the limit at that place and level.
    pub distance: Exact,
    /// The promised bound of this distance.
    pub promised: Exact,
}

/// Control data of spread 1, and a place.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum ControlData<'a> {
    /// A piece of a control polygon.
    Polygon {
        /// The index of its first point.
        first: i64,
        /// Its points.
        points: &'a [i64],
        /// The parameter t of the place.
        parameter: String,
    },
    /// A piece of a control net.
    Net {
        /// The indices of its first point.
        first: [i64; 2],
        /// Its points, row by row.
        net: &'a [Vec<i64>],
        /// The parameters s and t of the place.
        parameters: [String; 2],
    },
    /// A control ring.
    LocalRules {
        /// Its points.
        ring: Vec<i64>,
        /// The name of the point that is the place.
        point: String,
    },
}

/// A promise with each point at its natural parameter.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Natural<'a> {
    /// Whether it is kept; null where that is open.
    pub kept: Option<bool>,
    /// Control data that break the promise; missing where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub broken_by: Option<Broken<'a>>,
}

impl<'a> Promise<'a> {
    pub(crate) fn of(cell: &'a CellFinding) -> Option<Promise<'a>> {
        let kept = cell.kept.as_ref()?;
        let broken = |kept: &'a Kept| match kept {
            Kept::No(broken) => Some(Broken::of(broken)),
            _ => None,
        };
        let natural = |kept| Natural { kept: known(kept), broken_by: broken(kept) };
        Some(Promise {
            kept: known(kept),
            open: if let Kept::Open(why) = kept { Some(why.to_string()) } else { None },
            broken_by: broken(kept),
            natural: cell.kept_naturally.as_ref().map(natural),
        })
    }
}

fn known(kept: &Kept) -> Option<bool> {
    match kept {
        Kept::Yes => Some(true),
        Kept::No(_) => Some(false),
        Kept::Open(_) => None,
    }
}

impl<'a> Broken<'a> {
    fn of(broken: &'a audit::Broken) -> Broken<'a> {
        let audit::Attained { control, place, .. } = &broken.attained;
        let data = match control {
            audit::Control::Polygon(polygon) => ControlData::Polygon {
                first: polygon.first,
                points: &polygon.points,
                parameter: name(place),
            },
            audit::Control::Net { first, rows } => ControlData::Net {
                first: *first,
                net: rows,
                parameters: match place {
                    audit::Place::Parameters(both) => both.each_ref().map(ToString::to_string),
                    place => [name(place), String::new()],
                },
            },
            audit::Control::Points(points) => ControlData::LocalRules {
                ring: points.iter().map(|(_, height)| *height).collect(),
                point: name(place),
            },
        };
        Broken {
            data,
            times: broken.spread.to_string(),
            level: broken.level,
            distance: Exact::of(&broken.distance),
            promised: Exact::of(&broken.most),
        }
    }
}
