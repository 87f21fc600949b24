//! Judging claims about the smoothness of limits.

mod exponent;
mod mask;
mod range;
mod region;
mod trial;
mod vertex_range;
mod vertices;

use crate::claim::{Paper, SmoothnessBody, SmoothnessClaim, SmoothnessStatement};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::limits::LimitScheme;
use crate::exact::RealCyclotomic;
use crate::finding::{KnownLimits, SmoothnessFinding, SmoothnessVerdict};
use crate::judge::kind::JudgeAlone;
use mask::{lattice_limits, limits, no_valences};

impl<'a> JudgeAlone<'a> for SmoothnessClaim {
    type Finding = SmoothnessFinding<'a>;

    const WORK: usize = 20;

    /// Judges a claim about the limits of a scheme.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<SmoothnessFinding<'a>, Diagnostic> {
        let (verdict, known) = match &self.body {
            SmoothnessBody::NotCheckable(_) => {
                (SmoothnessVerdict::NotCheckable, KnownLimits::Absent)
            }
            SmoothnessBody::Statement(located, statement) => {
                let scheme = LimitScheme { paper, library, located, given: &self.given };
                let found = Diagnostic::or_cap(of(&scheme, statement))?;
                found.unwrap_or_else(|cap| {
                    (SmoothnessVerdict::NotCheckable, KnownLimits::BeyondCap(cap))
                })
            }
        };
        Ok(SmoothnessFinding {
            id: format!("{}:{}", paper.key, self.id),
            claim: self,
            verdict,
            known,
        })
    }
}

fn of(
    scheme: &LimitScheme<'_>,
    statement: &SmoothnessStatement,
) -> Result<(SmoothnessVerdict, KnownLimits), Diagnostic> {
    if let SmoothnessStatement::Range(range) = statement {
        return range::judge(scheme, range);
    }
    if let SmoothnessStatement::Region(region) = statement {
        return region::judge(scheme, region);
    }
    let first = match statement {
        SmoothnessStatement::Continuity { valences: Some(valences), .. } => Some(valences.first),
        _ => None,
    };
    let instances = scheme.instances::<RealCyclotomic>(None, first)?;
    if scheme.is_ring(&instances)? {
        return vertices::judge(scheme, &instances, statement);
    }
    let known = if let Some(mask) = scheme.lattice(&instances)? {
        lattice_limits(mask)
    } else {
        match limits(scheme.mask(&[])?) {
            Ok(limits) => limits,
            Err(capped) => {
                return Ok((SmoothnessVerdict::NotCheckable, KnownLimits::Capped(capped)));
            }
        }
    };
    let proven = known.proven().expect("they are those of one mask");
    let verdict = match statement {
        SmoothnessStatement::Continuity { valences: Some(valences), .. } => {
            return Err(no_valences(scheme, valences));
        }
        SmoothnessStatement::Continuity { continuous, not_continuous, valences: None } => {
            SmoothnessVerdict::of_all(&[
                continuous.map_or(Some(true), |m| proven.is_continuous(m)),
                not_continuous
                    .map_or(Some(true), |m| proven.is_continuous(m).map(|continuous| !continuous)),
            ])
        }
        SmoothnessStatement::Exponent { exponent, attained } => {
            exponent::judge(&proven, exponent, *attained)
        }
        SmoothnessStatement::Range(_) | SmoothnessStatement::Region(_) => {
            unreachable!("ranges are judged above")
        }
    };
    Ok((verdict, known))
}
