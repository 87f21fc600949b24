//! What a radius says of the limits of a scheme. THEOREMS.md, 107, 108 and 110.

use super::independence::is_independent;
use super::number::Number;
use super::read::Certificate;
use crate::decimal::{Q, int};
use crate::reject::{RadiusReason, RadiusRejection};
use num_traits::Pow as _;

/// The m for which the limits are C^m, and that for which not all are.
pub fn check<N: Number>(
    certificate: &Certificate,
) -> Result<(Option<usize>, Option<usize>), RadiusRejection> {
    let at = |line, reason| RadiusRejection { line, reason };
    let said = certificate.continuous.or(certificate.not_continuous);
    let Some((_, order)) = certificate.order else {
        return match said {
            Some((line, _)) => Err(at(line, RadiusReason::NoMask)),
            None => Ok((None, None)),
        };
    };
    let n = certificate.rules.len();
    // n^{K − m}.
    let limit = |m: usize| -> Q {
        let base = int(i64::try_from(n).unwrap_or(i64::MAX));
        (m..order).fold(int(1), |power, _| power * &base)
    };
    if let Some((line, m)) = certificate.continuous
        && (m >= order || certificate.bound >= limit(m))
    {
        return Err(at(line, RadiusReason::NotBelow));
    }
    if let Some((line, m)) = certificate.not_continuous {
        // Not C^0: the scheme diverges, whatever the shifts are.
        if m > 0 && certificate.continuous.is_none() {
            return Err(at(line, RadiusReason::NotConvergent));
        }
        if m > 0 && !is_independent::<N>(&certificate.symbol(), n) {
            return Err(at(line, RadiusReason::Dependent));
        }
        let lower = certificate.lower.as_ref();
        let reaches =
            lower.is_some_and(|lower| m <= order && lower.bound >= limit(m).pow(lower.degree()));
        if !reaches {
            return Err(at(line, RadiusReason::NotAbove));
        }
    }
    let number = |said: Option<(usize, usize)>| said.map(|(_, m)| m);
    Ok((number(certificate.continuous), number(certificate.not_continuous)))
}
