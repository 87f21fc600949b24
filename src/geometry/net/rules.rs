//! What refines nets.

use super::error::NetError;
use super::grid::Net;
use super::lattice::{lattice_net_limits, refine_lattice_net};
use super::limit::net_limits;
use super::refine::refine_net;
use super::scheme::NetScheme;
use crate::exact::Rational;
use crate::mesh::Point;
use crate::scheme::{LatticeMask, find_definition, parse_lattice};

/// What refines nets: a tensor product of curve schemes, or a mask on Z².
#[derive(Clone, Debug, PartialEq)]
pub enum NetRules {
    /// A tensor product.
    Product(NetScheme),
    /// What was typed, and the mask.
    Lattice(String, LatticeMask),
}

impl NetRules {
    /// Those of this name: a mask on Z^d, or what [`NetScheme::parse`] takes.
    ///
    /// # Errors
    /// When there are none, or they are for polygon meshes.
    ///
    /// ```
    /// use subcert::net::NetRules;
    ///
    /// assert!(matches!(NetRules::parse("loop-regular")?, NetRules::Lattice(..)));
    /// assert!(matches!(NetRules::parse("chaikin")?, NetRules::Product(..)));
    /// # Ok::<(), subcert::net::NetError>(())
    /// ```
    pub fn parse(text: &str) -> Result<NetRules, NetError> {
        let name = text.trim();
        if find_definition(name).is_ok_and(|found| found.is_lattice()) {
            return Ok(NetRules::Lattice(name.to_owned(), parse_lattice(name)?));
        }
        NetScheme::parse(name).map(NetRules::Product)
    }

    /// The name.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            NetRules::Product(scheme) => scheme.name(),
            NetRules::Lattice(name, _) => name,
        }
    }

    /// The net of a later level.
    ///
    /// # Errors
    /// As of [`refine_net`] and [`refine_lattice_net`].
    pub fn refined(&self, net: &Net, level: u32) -> Result<Net, NetError> {
        match self {
            NetRules::Product(scheme) => refine_net(net, scheme, level),
            NetRules::Lattice(_, mask) => refine_lattice_net(net, mask, level),
        }
    }

    /// Where the points of a net go, row by row.
    ///
    /// # Errors
    /// As of [`net_limits`] and [`lattice_net_limits`].
    pub fn limits(&self, net: &Net) -> Result<Vec<Option<Point<Rational>>>, NetError> {
        match self {
            NetRules::Product(scheme) => net_limits(net, scheme),
            NetRules::Lattice(_, mask) => lattice_net_limits(net, mask),
        }
    }
}
