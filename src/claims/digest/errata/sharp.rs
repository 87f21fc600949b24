//! Claims about smoothness that are true where more is true.

use crate::claim::{Ends, ExponentStatement, SmoothnessBody, SmoothnessClaim, SmoothnessStatement};
use crate::exact::{Enclosed as _, Interval, IntervalSet, LogSum};
use crate::finding::{
    KnownLimits, PaperAudit, RangeOfLimits, SmoothnessFinding, SmoothnessVerdict,
};
use crate::smoothness::Hoelder;
use std::ops::Bound;

/// The level of the enclosures that are compared.
const LEVEL: u32 = 1;

/// A claim that is true, and what is true beyond it.
#[derive(Clone, Debug)]
pub struct NotSharp<'e, 'a> {
    /// The finding.
    pub finding: &'e SmoothnessFinding<'a>,
    /// What is true beyond the claim.
    pub beyond: Beyond,
}

/// What is true beyond a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Beyond {
    /// The limits are C^m for this larger m.
    Continuous(usize),
    /// A bound of the exponent is not the exponent.
    Exponent,
    /// The limits are as smooth for these values of the parameter too.
    Range(IntervalSet),
}

impl<'a> PaperAudit<'a> {
    /// The claims about smoothness that are proved, of which more is true. Ends of ranges that are rounded do not
    /// count, nor a statement that says itself what is not true beyond it.
    ///
    /// ```
    /// use subcert::audit::{Beyond, audit};
    /// use subcert::claim::read_paper;
    /// use subcert::diagnostic::SourceText;
    ///
    /// let text = "key = 'k'\n[paper]\ntitle = 'A'\nyear = '2026'\n\
    ///             [[smoothness]]\nid = 's'\nlocus = 'S'\nscheme = 'b-spline:degree=3'\ncontinuous = '1'\n";
    /// let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
    /// let audit = audit(&paper)?;
    /// let more = audit.not_sharp();
    /// assert_eq!(more[0].beyond, Beyond::Continuous(2));
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn not_sharp<'e>(&'e self) -> Vec<NotSharp<'e, 'a>> {
        let proved =
            |finding: &&SmoothnessFinding<'a>| finding.verdict == SmoothnessVerdict::Confirmed;
        let findings = self.smoothness.iter().filter(proved);
        findings
            .filter_map(|finding| Some(NotSharp { finding, beyond: beyond(finding)? }))
            .collect()
    }
}

fn beyond(finding: &SmoothnessFinding<'_>) -> Option<Beyond> {
    match (stated(finding.claim)?, &finding.known) {
        (SmoothnessStatement::Continuity { continuous, not_continuous: None, .. }, known) => {
            let proved = known.proven()?.continuity?;
            (proved > (*continuous)?).then_some(Beyond::Continuous(proved))
        }
        (SmoothnessStatement::Exponent { exponent, .. }, known) => {
            apart(exponent, known.proven()?.hoelder?).then_some(Beyond::Exponent)
        }
        (SmoothnessStatement::Range(range), KnownLimits::Range(known)) => {
            let RangeOfLimits { sets, .. } = &**known;
            let more = sets.as_ref()?.inside().without(&range.domain.interval(Ends::Most));
            // An end that belongs to the range or does not is no single value more.
            let wide = more.intervals().iter().any(|part| !is_one_number(part));
            (!range.only && wide).then_some(Beyond::Range(more))
        }
        _ => None,
    }
}

fn stated(claim: &SmoothnessClaim) -> Option<&SmoothnessStatement> {
    match &claim.body {
        SmoothnessBody::Statement(_, statement) => Some(statement),
        SmoothnessBody::NotCheckable(_) => None,
    }
}

fn is_one_number(part: &Interval) -> bool {
    matches!((&part.low, &part.high), (Bound::Included(low), Bound::Included(high)) if low == high)
}

/// Whether a bound of the exponent is certainly not the exponent.
fn apart(exponent: &ExponentStatement, hoelder: &Hoelder) -> bool {
    let ExponentStatement::Bounds { at_least, at_most } = exponent else { return false };
    let enclosed = |value: &LogSum| value.enclosure(LEVEL);
    let above = |value: &LogSum| *enclosed(value).upper() < hoelder.lower;
    let below = |value: &LogSum| *enclosed(value).lower() > hoelder.upper;
    // Two bounds say that it is between them.
    match (at_least, at_most) {
        (Some(bound), None) => above(&bound.value),
        (None, Some(bound)) => below(&bound.value),
        _ => false,
    }
}
