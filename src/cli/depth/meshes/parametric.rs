//! The depth of one mesh, net or solid by its distance from the limit at equal parameters.

use super::kind::{Kind, near};
use super::promise::{APriori, Formula};
use super::subject::{Subject, searched};
use crate::cli::console::answer::{Answer, SCHEMA, deliver};
use crate::cli::console::destination::Destination;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::quantity::{Float, Text};
use crate::cli::depth::numbers::{at_most, few_text, found, levels, point};
use serde::Serialize;
use std::sync::Arc;
use subcert::exact::{Rational, format::short};
use subcert::patch::{FarPlace, MeshDepth, MeshWork};
use subcert::report::Sheet;
use subcert::report::html::Picture;

/// The depth of one mesh.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ParametricDepth<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme.
    scheme: String,
    /// The name of the file.
    mesh: String,
    /// What is to be told of the file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// The tolerance ε.
    tolerance: Text<Rational>,
    /// How distances are measured: `parametric`.
    measure: &'static str,
    /// The least level found to be sufficient, with all later ones; null with `--a-priori`.
    level: Option<u32>,
    /// Why the search ended early, so that lower levels may be open.
    #[serde(skip_serializing_if = "Option::is_none")]
    ended: Option<String>,
    /// The greatest level that is certainly not sufficient.
    too_few: Option<u32>,
    /// The distance at `level`; null where a search that was stopped did not come to that level.
    distance: Option<Bounds>,
    /// The one-sided Hausdorff distance at `level`, of the limit from the mesh; null of a solid, and of a net with a mask on Z².
    hausdorff: Option<AtLeast>,
    /// Where `distance` is greatest.
    worst_face: Option<Place>,
    /// Where the limit is beyond the tolerance at `too_few`.
    too_far: Option<Place>,
    /// How many pieces were looked at exactly.
    exact_pieces: Option<usize>,
    /// What the longest edge and the valences guarantee.
    a_priori: APriori,
    /// What a paper's formula promises; null where there is none.
    formula: Option<Formula>,
    #[serde(skip)]
    kind: Kind,
    /// The tolerance as it was given.
    #[serde(skip)]
    given: &'a str,
    #[serde(skip)]
    pictures: Vec<Picture>,
}

/// A lower and an upper bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Bounds {
    /// At least this.
    lower: Float,
    /// At most this.
    upper: Float,
}

/// A lower bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct AtLeast {
    /// At least this.
    lower: Float,
}

/// A place on a mesh and on its limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Place {
    /// The face of the control mesh, from 0; of a solid, the cell.
    face: usize,
    /// Of a net, the row and the column of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<[usize; 2]>,
    /// The vertex of that face that it is near.
    vertex: Option<usize>,
    /// The face of the level.
    level_face: Option<Text<u128>>,
    /// The point of the mesh of the level.
    on_mesh: [Float; 3],
    /// The point of the limit at the same parameter.
    on_limit: [Float; 3],
}

impl Place {
    fn of(place: &FarPlace, kind: Kind) -> Place {
        let found = found(place.on_mesh.iter().chain(&place.on_limit));
        Place {
            face: place.face,
            cell: kind.cell(place.face),
            vertex: place.vertex,
            level_face: place.level_face.map(Text),
            on_mesh: place.on_mesh.map(found),
            on_limit: place.on_limit.map(found),
        }
    }

    fn words(&self, kind: Kind) -> String {
        let Place { face, cell, vertex, level_face, on_mesh, on_limit } = self;
        let cell = cell.map(|[i, j]| format!(" (cell {i}, {j})")).unwrap_or_default();
        let near = near(*vertex, level_face.as_ref());
        format!(
            "{} {face}{cell}{near}: {} of the {}, {} of the limit",
            kind.piece(),
            point(on_mesh),
            kind.name(),
            point(on_limit)
        )
    }
}

/// Searches, and writes the answer. `find` gives the depth, when the file of `--per-face` is written, and `draw` the
/// pictures of a page.
pub(super) fn search(
    subject: Subject<'_>,
    work: &Arc<MeshWork>,
    to: &Destination,
    find: impl FnOnce(&Subject<'_>) -> Result<MeshDepth, Failure>,
    draw: impl FnOnce(&Subject<'_>, &MeshDepth) -> Vec<Picture>,
) -> Outcome {
    let arguments = subject.arguments;
    let ((depth, pictures), stopped) = searched(work, arguments, || {
        let depth = find(&subject)?;
        let is_page = arguments.output.is_page();
        let pictures = if is_page { draw(&subject, &depth) } else { Vec::new() };
        Ok((depth, pictures))
    })?;
    deliver(to, &ParametricDepth::of(subject, Some((depth, stopped)), pictures))
}

impl ParametricDepth<'_> {
    /// The answer from what was found, and why the search was stopped; nothing is found where only the guarantee is
    /// asked for.
    pub(super) fn of(
        subject: Subject<'_>,
        found: Option<(MeshDepth, Option<String>)>,
        pictures: Vec<Picture>,
    ) -> ParametricDepth<'_> {
        let Subject { scheme, name, notes, kind, arguments, tolerance, guaranteed, promised } =
            subject;
        let (found, ended) = found.unzip();
        let ended = ended.flatten();
        let found = found.as_ref();
        // A search that is stopped may know less than is known before it.
        let level = found.map(|found| found.level);
        let level =
            level.map(|level| if ended.is_some() { level.min(guaranteed.level) } else { level });
        let measured = found.filter(|found| level == Some(found.level));
        let place = |place: &FarPlace| Place::of(place, kind);
        ParametricDepth {
            schema: SCHEMA,
            scheme,
            mesh: name,
            notes,
            tolerance: Text(tolerance),
            measure: "parametric",
            level,
            ended,
            too_few: found.and_then(|found| found.too_few),
            distance: measured.map(|found| {
                let [lower, upper] = found.distance.map(Float);
                Bounds { lower, upper }
            }),
            hausdorff: measured
                .filter(|_| !matches!(kind, Kind::Solid | Kind::LatticeNet { .. }))
                .map(|found| AtLeast { lower: Float(found.apart) }),
            worst_face: measured.and_then(|found| found.worst.as_ref()).map(place),
            too_far: found.and_then(|found| found.beyond.as_ref()).map(place),
            exact_pieces: found.map(|found| found.exact_pieces),
            a_priori: guaranteed,
            formula: promised.map(|formula| match found {
                Some(found) => formula.compared(found.too_few, level),
                None => formula,
            }),
            kind,
            given: &arguments.tolerance,
            pictures,
        }
    }
}

impl Answer for ParametricDepth<'_> {
    const NAME: &'static str = "depth-mesh";

    fn sentence(&self) -> String {
        let tolerance = short(&self.tolerance.0, 6);
        let Some(level) = self.level else {
            let level = self.a_priori.level;
            return format!("A priori, {} are enough for {tolerance}.", levels(level));
        };
        let few = self.too_few.map(|few| format!(", and not after {few}")).unwrap_or_default();
        format!(
            "The {} is within {tolerance} of its limit after {} of refinement{few}.",
            self.kind.name(),
            levels(level)
        )
    }

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let ParametricDepth { scheme, mesh, a_priori, kind, .. } = self;
        sheet.heading(1, format!("{mesh}, {scheme}, ε = {}", self.given));
        sheet.notes(&self.notes);
        let mut facts = Vec::new();
        if let Some(level) = self.level {
            let few = few_text(level, self.too_few);
            let few = self.ended.as_ref().map_or(few.clone(), |why| format!("{few}: {why}"));
            let most = at_most(level, self.too_few, self.ended.is_some());
            let depth = format!("{most}{}, at equal parameters{few}", levels(level));
            facts.push((format!("depth of the {}", kind.name()), depth));
            let distance = self.distance.iter();
            facts.extend(distance.map(|Bounds { lower, upper }| {
                (
                    format!("distance at level {level}"),
                    format!("{} to {}", lower.down(), upper.up(9)),
                )
            }));
            let worst = self.worst_face.iter();
            facts.extend(worst.map(|place| ("greatest at".to_owned(), place.words(*kind))));
            let apart = self.hausdorff.iter();
            facts.extend(apart.map(|AtLeast { lower }| {
                ("Hausdorff distance".to_owned(), format!("at least {}", lower.down()))
            }));
            let few = self.too_few.zip(self.too_far.as_ref());
            facts.extend(
                few.map(|(level, place)| (format!("too far at level {level}"), place.words(*kind))),
            );
            let pieces = match self.exact_pieces {
                Some(count) if matches!(kind, Kind::LatticeNet { .. }) => {
                    format!("for all {count} squares that were looked at")
                }
                None | Some(0) => {
                    "nowhere; all was decided in f64 with bounds of its errors".to_owned()
                }
                Some(count) => format!("for {count} pieces that were too near to call in f64"),
            };
            facts.push(("exact numbers needed".to_owned(), pieces));
        }
        let text = format!(
            "{}, for all {} edges of length at most {}",
            levels(a_priori.level),
            kind.all(),
            a_priori.longest_edge.up(9)
        );
        facts.push(("a priori".to_owned(), text));
        facts.extend(self.formula.iter().map(|formula| {
            let (name, text) = formula.fact(kind.name());
            if *kind == Kind::Solid {
                (name, format!("for the boundary, {text}"))
            } else {
                (name, text)
            }
        }));
        sheet.facts(facts);
        sheet.text(kind.distance());
        sheet
    }

    fn pictures(&self) -> Vec<Picture> {
        self.pictures.clone()
    }
}
