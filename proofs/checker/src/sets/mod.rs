//! Certificates of depths: how many levels a control polygon or a net needs as a set of points. proofs/format/depth.md.

mod direction;
mod far;
mod near;
mod net;
mod point;
mod ratio;
mod read;

use crate::numbers::Meter;
use crate::text::{At, DepthChecked as Checked, DepthReason, DepthRejection, require};
use direction::Direction;
use near::Set;
use net::Net;
use ratio::{Ratio, less};
use read::Certificate;
use std::fmt;

/// The most steps of a certificate, of all its lines together.
const MAX_STEPS: u64 = 200_000_000;

/// What a valid certificate proves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Depth {
    /// The Hausdorff distance is at most the tolerance at this level.
    pub enough: Option<u32>,
    /// It is more than the tolerance at these levels.
    pub too_few: Vec<u32>,
}

/// Checks a certificate of a depth.
///
/// # Errors
/// The line that is wrong, or not decided, and the reason.
pub fn check_depth(text: &str) -> Result<Depth, DepthRejection> {
    let certificate = Certificate::read(text)?;
    let meter = Meter::up_to(MAX_STEPS);
    let mut directions = Vec::new();
    let is_net = certificate.directions.len() > 1;
    for given in &certificate.directions {
        directions.push(Direction::new(given, is_net, &meter).at(given.line)?);
    }
    let Certificate { points, tolerance, end, .. } = &certificate;
    let mut net = Net::new(&directions, points, tolerance, &meter).at(*end)?;
    let mut too_few: Vec<u32> = Vec::new();
    for far in &certificate.too_few {
        require(!too_few.contains(&far.level), DepthReason::Twice).at(far.line)?;
        let parameters = far.at.iter().map(Ratio::of).collect::<Checked<Vec<Ratio>>>();
        let parameters = parameters.at(far.line)?;
        let outside = (0..).zip(&parameters).any(|(which, x): (usize, &Ratio)| {
            let [from, to] = net.ranges[which];
            directions[which].range.is_some() && (less(*x, from) || less(to, *x))
        });
        require(!outside, DepthReason::Outside).at(far.line)?;
        let set = if far.of_limit { Set::Limit } else { Set::Polygon };
        far::check(&mut net, far.level, set, &parameters, &meter).at(far.line)?;
        too_few.push(far.level);
    }
    if let Some((line, level)) = certificate.enough {
        near::check(&mut net, level, &meter).at(line)?;
    }
    too_few.sort_unstable();
    let enough = certificate.enough.map(|(_, level)| level);
    Ok(Depth { enough, too_few })
}

impl fmt::Display for Depth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let few: Vec<String> = self.too_few.iter().map(ToString::to_string).collect();
        let few = match &few[..] {
            [] => String::new(),
            [one] => format!("level {one} is not enough"),
            [all @ .., last] => format!("levels {} and {last} are not enough", all.join(", ")),
        };
        let enough = self.enough.map(|level| format!("level {level} is enough"));
        let least = self.enough.is_some_and(|level| (0..level).eq(self.too_few.iter().copied()));
        match (enough, &few[..]) {
            (Some(enough), "") => f.write_str(&enough),
            (Some(enough), few) if least => write!(f, "{enough}, and {few}: it is the least"),
            (Some(enough), few) => write!(f, "{enough}, and {few}"),
            (None, few) => f.write_str(few),
        }
    }
}
