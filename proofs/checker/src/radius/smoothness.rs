//! What a radius says of the limits of a scheme. THEOREMS.md, 107, 108 and 110.

use super::independence::is_independent;
use super::read::{Certificate, Lower};
use crate::numbers::{Meter, count};
use crate::text::{At, RadiusChecked as Checked, RadiusReason, RadiusRejection, require};
use num_traits::Pow as _;

/// The m for which the limits are C^m, and that for which not all are.
pub fn check(certificate: &Certificate, meter: &Meter) -> Checked<(Option<usize>, Option<usize>)> {
    let Certificate { continuous, not_continuous, .. } = certificate;
    let Some((_, order)) = certificate.order else {
        return match continuous.or(*not_continuous) {
            Some((line, _)) => Err(RadiusRejection { line, reason: RadiusReason::NoMask }),
            None => Ok((None, None)),
        };
    };
    let n = certificate.rules.len();
    // n^{K − m}.
    let limit = |m: usize| (m..order).fold(count(1), |power, _| power * count(n));
    if let Some((line, m)) = *continuous {
        let below = m < order && certificate.bound < limit(m);
        require(below, RadiusReason::NotBelow).at(line)?;
    }
    if let Some((line, m)) = *not_continuous {
        // Not C^0: the scheme diverges, whatever the shifts are.
        require(m == 0 || continuous.is_some(), RadiusReason::NotConvergent).at(line)?;
        let independent = || is_independent(&certificate.symbol(), n, meter);
        let is_independent = m == 0 || independent().map_err(Into::into).at(line)?;
        require(is_independent, RadiusReason::Dependent).at(line)?;
        let reaches =
            |lower: &Lower| m <= order && lower.bound >= limit(m).pow(lower.product.len());
        let reached = certificate.lower.as_ref().is_some_and(reaches);
        require(reached, RadiusReason::NotAbove).at(line)?;
    }
    Ok([continuous, not_continuous].map(|said| said.map(|(_, m)| m)).into())
}
