//! `subcert smoothness` of a mask on Z^d.

use super::radius::{Radius, apart};
use crate::cli::arguments::SmoothnessArguments;
use crate::cli::console::answer::{Answer, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::interrupt::{Interrupt, reason};
use crate::cli::console::lattice::{matrix, sentence, smoothness_words};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use serde::Serialize;
use subcert::lattice;
use subcert::report::Sheet;
use subcert::report::json::LatticeSmoothnessForm;
use subcert::scheme::LatticeMask;
use subcert::stop::Stop;

pub(super) fn smoothness(
    arguments: &SmoothnessArguments,
    mask: &LatticeMask,
    to: &Destination,
) -> Outcome {
    if arguments.certificate.is_some() {
        let problem = "--certificate: there is no certificate of the smoothness of masks on Z^d yet; leave it out";
        return Err(Failure::Input(problem.to_owned()));
    }
    let progress = Progress::of_search(true);
    let stop = Stop::default();
    let interrupt = Interrupt::stops_search(&stop);
    let found = lattice::LatticeSmoothness::until(mask, &stop);
    drop((interrupt, progress));
    let decides = found.radius.as_ref().or(found.differences.as_ref());
    let radius = decides.map(|one| {
        let order = usize::try_from(one.order).ok();
        Radius::of(&one.matrices, 'T', order, &one.radius)
    });
    deliver(
        to,
        &LatticeSmoothness {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            dilation: mask.dilation().rows().map(<[i64]>::to_vec).collect(),
            sum_rules: found.sum_rules,
            found: LatticeSmoothnessForm::of(&found),
            contraction: found.contraction.as_ref().map(|(c, _)| *c),
            radius,
            open: found.open.clone(),
            ended: stop.is_stopped().then(reason),
        },
    )
}

/// How smooth the limits of a mask on Z^d are.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LatticeSmoothness<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The dilation matrix M, row by row.
    dilation: Vec<Vec<i64>>,
    /// The order of the sum rules.
    sum_rules: u32,
    /// What is proven; its fields stand here.
    #[serde(flatten)]
    found: LatticeSmoothnessForm,
    /// c, where T_c < 1 shows convergence; null where it is shown otherwise, or not at all.
    contraction: Option<u32>,
    /// The radius of which the exponent is made; null of products of masks of curves, and where it is not computed.
    radius: Option<Radius>,
    /// What is open; absent where nothing is.
    #[serde(skip_serializing_if = "Option::is_none")]
    open: Option<String>,
    /// Why the searches ended early; absent where they did not.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
}

impl Answer for LatticeSmoothness<'_> {
    const NAME: &'static str = "smoothness-lattice";

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::titled(self.scheme);
        let mut facts = vec![
            ("dilation matrix M".to_owned(), matrix(&self.dilation)),
            ("sum rules".to_owned(), format!("of order {}", self.sum_rules)),
        ];
        facts.extend(smoothness_words(&self.found, Some(self.sum_rules)));
        sheet.facts(facts);
        if let Some(radius) = &self.radius {
            sheet.heading(2, "The joint spectral radius");
            let size = radius.size;
            let matrices = format!("{}, {size}×{size}", radius.matrices.len());
            let mut facts = vec![("matrices".to_owned(), matrices)];
            facts.extend(radius.facts());
            sheet.facts(facts);
            if !radius.exact && radius.at_most.is_some() {
                sheet.text(apart("", radius));
            }
        }
        let notes = [&self.open, &self.ended];
        notes.into_iter().flatten().for_each(|note| sheet.text(note.clone()));
        sheet
    }

    fn sentence(&self) -> String {
        sentence(self.scheme, &self.found)
    }
}
