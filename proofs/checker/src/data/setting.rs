//! The setting of a witness: the masks or the ring that refine control data.

use super::functional::Rules;
use crate::numbers::Piece;
use crate::schemes::{Library, LocalRules, Scheme, Sequence};
use crate::text::{Checked, Reason, Stop, require};
use std::rc::Rc;

/// The most residue classes of a constant that shows convergence.
pub const MAX_CLASSES: usize = 1 << 12;

/// The rules that refine control data.
pub enum Setting<'a> {
    /// One mask, or one for each index of a net, and whether all are shown to converge.
    Masks(Vec<Rules<'a>>, bool),
    /// A ring, and perhaps the interpolant with whose points the next level is compared.
    LocalRules(Box<LocalRules<'a>>, Option<Box<LocalRules<'a>>>),
}

impl<'a> Setting<'a> {
    /// The rational masks of a scheme, at this offset or at their own.
    pub fn masks(
        library: &'a Library<'a>,
        schemes: &[Rc<Scheme>],
        offset: Option<i64>,
    ) -> Checked<Setting<'a>> {
        require(!schemes.is_empty(), Reason::NoPromise)?;
        let (mut rules, mut converge) = (Vec::new(), true);
        for scheme in schemes {
            let offset = offset.unwrap_or(scheme.offset);
            let rational = Rules::new(library.meter, scheme, offset)?;
            rules.push(rational.ok_or(Reason::Malformed("rational masks"))?);
            converge &= converges(library, scheme)?;
        }
        Ok(Setting::Masks(rules, converge))
    }
}

/// The most of them for a mask with the symbol of a piece.
const MAX_CLASSES_ON_PIECE: usize = 1 << 8;

/// Whether T_c < 1 for some n^c ≤ 4096, or by a line `constant`.
pub fn converges(library: &Library<'_>, scheme: &Scheme) -> Result<bool, Stop> {
    let rules = &scheme.difference[..];
    let of = Sequence { rules, forward: false };
    Ok(library.products.contract(of) || contracts(library, of, MAX_CLASSES, None)?)
}

/// Whether T_c < 1 on a piece for some n^c ≤ 256.
pub fn converges_on(
    library: &Library<'_>,
    scheme: &Scheme,
    piece: &Piece<'_>,
) -> Result<bool, Stop> {
    let of = Sequence { rules: &scheme.difference, forward: false };
    contracts(library, of, MAX_CLASSES_ON_PIECE, Some(piece))
}

/// Whether T_c < 1 for some c with so many residue classes.
pub fn contracts(
    library: &Library<'_>,
    of: Sequence<'_>,
    most: usize,
    piece: Option<&Piece<'_>>,
) -> Result<bool, Stop> {
    let mut c = 1;
    while of.rules.len().saturating_pow(c) <= most {
        if library.products.are_below_one(of, c, piece)? {
            return Ok(true);
        }
        c += 1;
    }
    Ok(false)
}
