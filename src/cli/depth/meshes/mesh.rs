//! The depth of one polygon mesh.

use super::faces::{FacesFormat, plain_rows};
use super::geometric::{GeometricReport, Growth, Surface, measure, no_fan};
use super::kind::Kind;
use super::pictures::{Drawn, Pieces};
use super::promise::{Formula, Promise, promises};
use super::refined::Refined;
use crate::cli::arguments::{DepthArguments, DepthBoundary, FindingFormat};
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::interrupt::Interrupt;
use crate::cli::console::output::{Outcome, positive};
use crate::cli::console::progress::Progress;
use crate::cli::depth::numbers::{digits, few_text, levels, point};
use crate::cli::geometry::mesh::{failure, read, with_boundary};
use crate::cli::json::{SCHEMA, mesh_depth as form};
use std::path::Path;
use std::sync::Arc;
use subcert::exact::{Rational, format::short};
use subcert::float::shortest;
use subcert::mesh::MeshScheme;
use subcert::patch::{
    APriori, FORMULA_PAPER, FarPlace, MeshDepth, MeshDistances, a_priori, formula_level,
};
use subcert::report::Sheet;
use subcert::report::html::{FindingPage, Picture};

pub(in crate::cli::depth) fn mesh_depth(
    path: &Path,
    arguments: &DepthArguments,
    to: &Destination,
) -> Outcome {
    let asked = positive("--tolerance", &arguments.tolerance)?;
    let (scheme, name, file) = read(&arguments.scheme, path)?;
    let file = match arguments.boundary {
        Some(DepthBoundary::Mesh(boundary)) => with_boundary(file, boundary),
        _ => file,
    };
    let (geometric, tolerance) = measure(file.mesh().points(), arguments, &asked, "mesh")?;
    let refused = |error| failure(&file, &error);
    let guaranteed = a_priori(file.mesh(), scheme, &tolerance).map_err(refused)?;
    let promised = (scheme == MeshScheme::DooSabin).then(|| Formula {
        paper: FORMULA_PAPER,
        level: formula_level(file.mesh(), guaranteed.longest_edge, &tolerance),
    });
    let kind = Kind::Mesh { tagged: !file.mesh().tags().is_plain() };
    let per_face = arguments.per_face.as_deref();
    let per_face =
        per_face.map(|path| FacesFormat::of(path).map(|format| (path, format))).transpose()?;
    let (mut pictures, mut stopped) = (Vec::new(), false);
    if geometric && !arguments.a_priori {
        let mesh = file.mesh();
        let Surface { of_faces: surface, found, faces } =
            Surface::of(mesh, scheme, &tolerance, arguments).map_err(refused)?;
        let report = GeometricReport {
            scheme: scheme.name().to_owned(),
            kind,
            growth: Growth::of(scheme),
            name,
            mesh,
            tolerance,
            relative: arguments.relative.then_some(asked),
            surface,
            guaranteed,
            promised,
            found,
            faces,
            certificate: None,
            solid: None,
        };
        return report.show(arguments, to);
    }
    no_fan(arguments)?;
    let found = if arguments.a_priori {
        None
    } else {
        let distances = MeshDistances::new(file.mesh().clone(), scheme).map_err(refused)?;
        let wanted = arguments.output.format != FindingFormat::Json;
        let work = distances.work();
        let interrupt = Interrupt::stops_work(&work, arguments.seconds);
        let progress = Progress::of_pieces(Arc::clone(&work), wanted);
        let depth = distances.depth(&tolerance).map_err(refused)?;
        if let Some((path, format)) = per_face {
            let rows = plain_rows(depth.level, distances.faces(depth.level));
            format.write(path, file.mesh(), &rows)?;
        }
        if arguments.output.is_page() {
            let pieces = Pieces::of_mesh(file.mesh(), distances.faces(depth.level));
            let refined = Refined::of_mesh(file.mesh(), scheme, depth.level);
            let drawn = Drawn { name: &name, tolerance: &tolerance, depth: &depth, refined };
            let promised = promises(promised.as_ref(), &guaranteed);
            pictures = drawn.pictures(&pieces, promised, |level| distances.distance(level));
        }
        stopped = work.is_stopped();
        drop((interrupt, progress));
        Some(depth)
    };
    let scheme = scheme.name().to_owned();
    Report { scheme, name, tolerance, guaranteed, promised, found, kind, pictures, stopped }
        .show(arguments, to)
}

/// The answers for one mesh, net or solid.
pub(super) struct Report {
    pub(super) scheme: String,
    pub(super) name: String,
    pub(super) tolerance: Rational,
    pub(super) guaranteed: APriori,
    /// The number of levels by the formula of a paper, if there is one for the scheme.
    pub(super) promised: Option<Formula>,
    pub(super) found: Option<MeshDepth>,
    pub(super) kind: Kind,
    pub(super) pictures: Vec<Picture>,
    /// Whether the search was stopped.
    pub(super) stopped: bool,
}

/// Why a search ended early.
const STOPPED: &str = "the search was stopped";

fn place_text(place: &FarPlace, kind: Kind) -> String {
    let FarPlace { face, vertex, level_face, on_mesh, on_limit } = place;
    let cell = kind.cell(*face).map(|[i, j]| format!(" (cell {i}, {j})")).unwrap_or_default();
    let corner = vertex.map(|vertex| format!(" near vertex {vertex}")).unwrap_or_default();
    let of_level = level_face.map(|face| format!(", face {face} of the level")).unwrap_or_default();
    format!(
        "{} {face}{cell}{corner}{of_level}: {} of the {}, {} of the limit",
        kind.piece(),
        point(on_mesh),
        kind.name(),
        point(on_limit)
    )
}

impl Report {
    pub(super) fn show(&self, arguments: &DepthArguments, to: &Destination) -> Outcome {
        let page = || {
            let (sentence, command) = (self.sentence(), command());
            let sheet = &self.sheet(arguments);
            let pictures = &self.pictures;
            Ok(FindingPage { sentence: &sentence, sheet, pictures, command: &command }.to_html())
        };
        to.deliver(|| self.sheet(arguments), || self.form(), page)
    }

    /// The depth in a sentence.
    fn sentence(&self) -> String {
        let Report { guaranteed, tolerance, kind, .. } = self;
        let tolerance = short(tolerance, 6);
        let Some(found) = &self.found else {
            let level = guaranteed.level;
            return format!("A priori, {} are enough for {tolerance}.", levels(level));
        };
        let few = found.too_few.map(|few| format!(", and not after {few}"));
        format!(
            "The {} is within {tolerance} of its limit after {} of refinement{}.",
            kind.name(),
            levels(found.level),
            few.unwrap_or_default()
        )
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let Report { scheme, name, guaranteed, kind, .. } = self;
        let place_text = |place| place_text(place, *kind);
        sheet.heading(1, format!("{name}, {scheme}, ε = {}", arguments.tolerance));
        let mut facts = Vec::new();
        if let Some(found) = &self.found {
            let few = few_text(found.level, found.too_few);
            let few = if self.stopped { format!("{few}: {STOPPED}") } else { few };
            facts.push((
                format!("depth of the {}", kind.name()),
                format!("{}{few}", levels(found.level)),
            ));
            let [least, most] = found.distance.map(digits);
            facts
                .push((format!("distance at level {}", found.level), format!("{least} to {most}")));
            facts.extend(found.worst.as_ref().map(|x| ("greatest at".to_owned(), place_text(x))));
            if *kind != Kind::Solid {
                let apart = format!("at least {}", digits(found.apart));
                facts.push(("Hausdorff distance".to_owned(), apart));
            }
            let few = found.too_few.zip(found.beyond.as_ref());
            facts
                .extend(few.map(|(level, x)| (format!("too far at level {level}"), place_text(x))));
            let pieces = match found.exact_pieces {
                0 => "nowhere; all was decided in f64 with bounds of its errors".to_owned(),
                count => format!("for {count} pieces that were too near to call in f64"),
            };
            facts.push(("exact numbers needed".to_owned(), pieces));
        }
        let all = kind.all();
        let text = format!(
            "{}, for all {all} edges of length at most {}",
            levels(guaranteed.level),
            digits(guaranteed.longest_edge)
        );
        facts.push(("a priori".to_owned(), text));
        if let Some(promised) = self.promised {
            let text = match (promised.level, &self.found) {
                (None, _) => {
                    format!("nothing: its constant is not below 1 for this {}", kind.name())
                }
                (Some(level), None) => levels(level),
                (Some(level), Some(found)) => {
                    format!("{}: {}", levels(level), Promise::of(level, found).name())
                }
            };
            let text =
                if *kind == Kind::Solid { format!("for the boundary, {text}") } else { text };
            facts.push((format!("formula of {}", promised.paper), text));
        }
        sheet.facts(facts);
        sheet.text(kind.distance());
        sheet
    }

    pub(super) fn form(&self) -> form::Report<'_> {
        let place = |place: &FarPlace| form::Place {
            face: place.face,
            cell: self.kind.cell(place.face),
            vertex: place.vertex,
            level_face: place.level_face.map(|face| face.to_string()),
            on_mesh: place.on_mesh.map(shortest),
            on_limit: place.on_limit.map(shortest),
        };
        let found = self.found.as_ref();
        form::Report {
            schema: SCHEMA,
            scheme: &self.scheme,
            mesh: &self.name,
            tolerance: self.tolerance.to_string(),
            measure: "parametric",
            level: found.map(|found| found.level),
            ended: self.stopped.then_some(STOPPED),
            too_few: found.and_then(|found| found.too_few),
            distance: found.map(|found| {
                let [lower, upper] = found.distance.map(shortest);
                form::Bounds { lower, upper }
            }),
            hausdorff: found
                .filter(|_| self.kind != Kind::Solid)
                .map(|found| form::AtLeast { lower: shortest(found.apart) }),
            worst_face: found.and_then(|found| found.worst.as_ref()).map(place),
            too_far: found.and_then(|found| found.beyond.as_ref()).map(place),
            exact_pieces: found.map(|found| found.exact_pieces),
            a_priori: form::APriori {
                level: self.guaranteed.level,
                longest_edge: shortest(self.guaranteed.longest_edge),
                ratio: shortest(self.guaranteed.ratio),
            },
            formula: self.promised.map(|Formula { paper, level }| form::Formula {
                paper,
                level,
                verdict: level.zip(found).map(|(level, found)| Promise::of(level, found).name()),
            }),
        }
    }
}
