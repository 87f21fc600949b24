//! A refutation as one checks it with paper and pencil.

use crate::audit::{self, HandCell, HandConstant};
use crate::exact::Rational;
use crate::limit::{Combination, LimitWeights};
use crate::report::json::exact::Exact;
use crate::scheme::Mask;
use serde::Serialize;

/// The computation behind the data that refute a theorem with points at i/n^k.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ByHand<'a> {
    /// The masks at their offsets; empty for a ring.
    pub masks: Vec<HandMask>,
    /// The constants in the bound.
    pub constants: Vec<Constant<'a>>,
    /// The bound with all numbers put in.
    pub bound: &'a str,
    /// The refined points of a curve that the computation needs, level by level.
    pub refined: Vec<Level>,
    /// For a distance of a curve, the weights of points that give the limit at 0.
    pub limit: Option<Weights>,
    /// For a curve, the two values whose difference is bounded.
    pub sides: Option<[Side; 2]>,
    /// `net`, `ring` or `points`, where refined points and limits are left out; null where they are
    /// not.
    pub left_out: Option<&'static str>,
}

/// A mask.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HandMask {
    /// The rules, one for each α.
    pub rules: Vec<Vec<String>>,
    /// The offset o.
    pub offset: i64,
}

/// A constant in a bound.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Constant<'a> {
    /// Its name, or the call of a function.
    pub name: &'a str,
    /// The formula that it stands for.
    pub formula: &'a str,
    /// Its value; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
    /// The id of a confirmed cell of the paper that prints it.
    pub cell: Option<&'a str>,
    /// The text of that cell.
    pub printed: Option<&'a str>,
}

/// Points of a level.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Level {
    /// The level.
    pub level: u32,
    /// The points.
    pub points: Vec<Point>,
}

/// A point, or the coefficient of one.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Point {
    /// Its index.
    pub index: i64,
    /// Its value.
    pub value: String,
}

/// Weights that give the points of a level and the refined points the same weighted sum.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Weights {
    /// The weights, which sum to 1.
    pub weights: Vec<Point>,
    /// The coefficients of the refined points with the same indices.
    pub rules: Vec<Vec<Point>>,
    /// c and T_c < 1, which show that the differences of the points tend to 0.
    pub contraction: Option<(u32, String)>,
}

/// A value as a sum over points of a level.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Side {
    /// The level.
    pub level: u32,
    /// The coefficients.
    pub coefficients: Vec<Point>,
    /// The value.
    pub value: Exact,
}

impl<'a> ByHand<'a> {
    pub(crate) fn of(hand: &'a audit::ByHand) -> ByHand<'a> {
        let level = |(level, points): &(u32, Vec<(i64, Rational)>)| Level {
            level: *level,
            points: list(points),
        };
        let limit = |LimitWeights { weights, rules }: &LimitWeights| Weights {
            weights: list(weights),
            rules: rules.iter().map(|rule| list(rule)).collect(),
            contraction: hand.contraction.as_ref().map(|(c, norm)| (*c, norm.to_string())),
        };
        ByHand {
            masks: hand.refiner.masks().iter().map(HandMask::of).collect(),
            constants: hand.constants.iter().map(Constant::of).collect(),
            bound: &hand.bound,
            refined: hand.refined.iter().map(level).collect(),
            limit: hand.weights.as_ref().map(limit),
            sides: hand.sides.as_ref().map(|sides| sides.each_ref().map(Side::of)),
            left_out: hand.left_out.map(audit::LeftOut::name),
        }
    }
}

fn list(points: &[(i64, Rational)]) -> Vec<Point> {
    points.iter().map(|(index, value)| Point { index: *index, value: value.to_string() }).collect()
}

impl HandMask {
    fn of(mask: &Mask) -> HandMask {
        let row = |row: &Vec<Rational>| row.iter().map(ToString::to_string).collect();
        HandMask { rules: mask.rules().rows().iter().map(row).collect(), offset: mask.offset() }
    }
}

impl<'a> Constant<'a> {
    fn of(HandConstant { name, formula, value, cell }: &'a HandConstant) -> Constant<'a> {
        let (id, printed) = match cell {
            Some(HandCell { id, printed, .. }) => (Some(&id[..]), Some(&printed[..])),
            None => (None, None),
        };
        Constant { name, formula, value: Exact::of(value), cell: id, printed }
    }
}

impl Side {
    fn of(side: &Combination) -> Side {
        let coefficient = |(index, coefficient, _): &(i64, Rational, Rational)| Point {
            index: *index,
            value: coefficient.to_string(),
        };
        Side {
            level: side.level,
            coefficients: side.terms.iter().map(coefficient).collect(),
            value: Exact::of(&side.value),
        }
    }
}
