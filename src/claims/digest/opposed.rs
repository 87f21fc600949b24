//! Claims about smoothness that contradict each other.

use crate::claim::{SmoothnessBody, SmoothnessStatement};
use crate::finding::{PaperAudit, SmoothnessFinding};

/// Two claims about the limits of one mask, of which at most one is true.
#[derive(Clone, Copy, Debug)]
pub struct Opposed<'e, 'a> {
    /// The claim that all limits are C^m.
    pub smooth: &'e SmoothnessFinding<'a>,
    /// Its m.
    pub m: usize,
    /// The claim that not all limits are.
    pub rough: &'e SmoothnessFinding<'a>,
    /// The order of which it says so, at most m.
    pub fails: usize,
}

impl<'a> PaperAudit<'a> {
    /// The pairs of claims of the paper that say of one mask that all limits are C^m, and that not all are C^l for an
    /// l ≤ m. Whichever is refuted, the other is judged by itself.
    ///
    /// ```
    /// use subcert::audit::audit;
    /// use subcert::claim::read_paper;
    /// use subcert::diagnostic::SourceText;
    ///
    /// let text = "key = 'k'\n[paper]\ntitle = 'A'\nyear = '2026'\n\
    ///             [[smoothness]]\nid = 's'\nlocus = 'S'\nscheme = 'chaikin'\ncontinuous = '1'\n\
    ///             [[smoothness]]\nid = 't'\nlocus = 'T'\nscheme = 'b-spline:degree=2'\nnot_continuous = '1'\n";
    /// let paper = read_paper(&SourceText::new("k.toml", text)).expect("a claim file");
    /// let audit = audit(&paper)?;
    /// assert_eq!(audit.opposed()[0].rough.claim.id, "t");
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn opposed<'e>(&'e self) -> Vec<Opposed<'e, 'a>> {
        let orders = |finding: &SmoothnessFinding<'_>| match &finding.claim.body {
            SmoothnessBody::Statement(_, statement) => match **statement {
                SmoothnessStatement::Continuity { continuous, not_continuous, .. } => {
                    (continuous, not_continuous)
                }
                _ => (None, None),
            },
            SmoothnessBody::NotCheckable(_) => (None, None),
        };
        let mut found = Vec::new();
        for smooth in &self.smoothness {
            let Some(m) = orders(smooth).0 else { continue };
            found.extend(self.smoothness.iter().filter_map(|rough| {
                let fails = orders(rough).1.filter(|fails| *fails <= m)?;
                let same = smooth.known.is_of_mask_of(&rough.known);
                same.then_some(Opposed { smooth, m, rough, fails })
            }));
        }
        found
    }
}
