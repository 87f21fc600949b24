//! `subcert depth`.

mod answer;
mod bound;
mod certified;
mod exact;
mod interval;
mod local_rules;
mod meshes;
mod numbers;
mod place;
mod polygon;
mod scheme_pictures;
mod sets;
mod surface;

use crate::cli::arguments::{
    BoundaryArgument, DepthArguments, DepthBoundary, DistanceArgument, FacesArgument, FindingFormat,
};
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::output::{Failure, Outcome, positive};
use crate::cli::console::progress::Progress;
use crate::cli::constants::offset::BetterOffset;
use crate::cli::geometry::commands::Geometry;
use crate::cli::geometry::net::NetInput;
use crate::cli::geometry::polygon::{Caps, read_polygon};
use crate::cli::json::{SCHEMA, depth as form};
use answer::{Answer, MAX_STEPS};
use bound::{Bounds, MAX_NORM_STEPS};
use exact::{Asked, Exact};
#[cfg(feature = "schema")]
pub(super) use local_rules::LocalReport;
use local_rules::ring_depth;
use polygon::{OfPolygon, Points};
use scheme_pictures::Drawn;
use sets::{OfSets, of_sets};
use subcert::bound::{Budget, Constants};
use subcert::exact::{Rational, format::short};
use subcert::limit::Parametrisation;
use subcert::patch::MAX_CURVE_PIECES;
use subcert::report::Sheet;
use subcert::report::html::FindingPage;
use subcert::scheme::{AnyScheme, Scheme, parse_any_scheme};

pub(super) fn depth(arguments: &DepthArguments) -> Outcome {
    let to = Destination::of(&arguments.output, &page_name(arguments))?;
    if arguments.certificate.is_some() && arguments.mesh.is_none() && arguments.polygon.is_none() {
        return Err(certified::none("give one by --polygon or --mesh"));
    }
    if let Some(path) = &arguments.mesh {
        let net = NetInput { scheme: &arguments.scheme, path, closed: arguments.closed };
        let geometry = Geometry::of(&net)?;
        only_its_boundary(arguments, matches!(geometry, Geometry::Mesh))?;
        return match geometry {
            Geometry::Mesh | Geometry::Solid if arguments.certificate.is_some() => {
                Err(certified::none("polygon meshes and solids have none"))
            }
            Geometry::Mesh => meshes::mesh_depth(path, arguments, &to),
            Geometry::Net => meshes::net_depth(&net, arguments, &to),
            Geometry::Solid => meshes::solid_depth(path, arguments, &to),
        };
    }
    only_its_boundary(arguments, false)?;
    match (&arguments.polygon, arguments.distance) {
        (None, _) => only_parametric(arguments, "all control polygons of a spread")?,
        (Some(_), Some(DistanceArgument::Parametric)) if arguments.relative => {
            let message = "--relative is for the distance of sets: leave out --distance parametric, or give \
                           the tolerance itself";
            return Err(Failure::Input(message.to_owned()));
        }
        _ => {}
    }
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::LocalRules(ring) => return ring_depth(&ring, arguments, &to),
    };
    let report = Report::of(&scheme, arguments)?;
    let page = || {
        let (sentence, command) = (report.sentence(), command());
        let pictures = report.drawn().pictures(&scheme);
        let sheet = &report.sheet(arguments);
        let pictures = &pictures;
        Ok(FindingPage { sentence: &sentence, sheet, pictures, command: &command }.to_html())
    };
    to.deliver(|| report.sheet(arguments), || report.form(arguments), page)
}

/// Refuses `--boundary` where it says nothing.
fn only_its_boundary(arguments: &DepthArguments, is_mesh: bool) -> Outcome {
    let Some(boundary) = arguments.boundary else { return Ok(()) };
    let fits = match boundary {
        DepthBoundary::Polygon(_) => arguments.polygon.is_some(),
        DepthBoundary::Mesh(_) => is_mesh,
    };
    if fits {
        return Ok(());
    }
    let message = "--boundary closed and open are for control polygons (--polygon), and none, edge and corner for \
                   polygon meshes (--mesh)";
    Err(Failure::Input(message.to_owned()))
}

/// Refuses the options of distances of sets.
fn only_parametric(arguments: &DepthArguments, of: &str) -> Outcome {
    let asked = [
        (arguments.distance == Some(DistanceArgument::Geometric), "--distance geometric"),
        (arguments.faces == FacesArgument::Fan, "--faces fan"),
        (arguments.relative, "--relative"),
    ];
    match asked.iter().find(|(asked, _)| *asked) {
        None => Ok(()),
        Some((_, option)) => {
            let message = format!(
                "{option} is for polygon meshes, nets and control polygons; {of} are compared with their limits at \
                 equal parameters"
            );
            Err(Failure::Input(message))
        }
    }
}

/// The name of a page in a folder: `depth-` and that of the file, or of the scheme.
fn page_name(arguments: &DepthArguments) -> String {
    let path = arguments.mesh.as_ref().or(arguments.polygon.as_ref());
    let stem = path.and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy());
    format!("depth-{}", stem.as_deref().unwrap_or(&arguments.scheme))
}

/// The results of one command.
struct Report {
    tolerance: Rational,
    spread: Rational,
    bounds: Bounds,
    answers: Vec<Answer>,
    points: Option<Points>,
    sets: Option<OfSets>,
    better_offsets: Vec<BetterOffset>,
}

impl Report {
    fn of(scheme: &Scheme, arguments: &DepthArguments) -> Result<Report, Failure> {
        let mut tolerance = positive("--tolerance", &arguments.tolerance)?;
        let points = points(scheme, arguments)?;
        if let (Some(points), true) = (&points, arguments.relative) {
            tolerance = points.share_of_diagonal(&tolerance).ok_or_else(|| {
                let message =
                    "--relative: the box around the polygon has no diagonal that f64 can hold";
                Failure::Input(message.to_owned())
            })?;
        }
        let spread = match &points {
            Some(points) => points.spread(),
            None => positive("--spread", &arguments.spread.spread)?,
        };
        let width = match &arguments.width {
            Some(width) => positive("--width", width)?,
            None => &tolerance / Rational::from(1000),
        };
        // If the natural shifts are 0, both parametrisations are the same.
        let wanted: &[Parametrisation] = if Parametrisation::Natural.moves(scheme.masks()) {
            &[Parametrisation::Natural, Parametrisation::Indexed]
        } else {
            &[Parametrisation::Natural]
        };
        let count = wanted.len() * if points.is_some() { 2 } else { 1 };
        let budget = || Budget::new(MAX_STEPS / count as u64);
        let mut budgets: Vec<Budget> = (0..count).map(|_| budget()).collect();
        let pieces = Budget::new(MAX_CURVE_PIECES);
        budgets.push(pieces.clone());
        let progress = Progress::of_steps(&budgets, arguments.output.format != FindingFormat::Json);
        let norms = Budget::new(MAX_NORM_STEPS);
        let constants = scheme.masks().into_iter().cloned().map(Constants::new);
        let constants = constants
            .map(|one| one.with_extreme_rows().with_budget(norms.clone()))
            .collect::<Vec<_>>();
        let bounds = Bounds::of(&constants, arguments.block.levels, &tolerance, &spread)
            .map_err(|error| Failure::Input(error.to_string()))?;
        let levels = arguments.output.is_page();
        let asked = Asked { tolerance: &tolerance, spread: &spread, width: &width, levels };
        let answer = |(&parametrisation, budgets): (&Parametrisation, &[Budget])| {
            Answer::of(scheme, parametrisation, points.as_ref(), &asked, budgets)
        };
        let sets = sets(scheme, points.as_ref(), arguments, &tolerance, pieces)?;
        let answers = wanted.iter().zip(budgets.chunks(count / wanted.len())).map(answer);
        let answers = answers.collect::<Result<Vec<Answer>, Failure>>()?;
        drop(progress);
        let better_offsets = BetterOffset::all_of(&arguments.scheme, scheme)?;
        Ok(Report { tolerance, spread, bounds, answers, points, sets, better_offsets })
    }

    /// What pictures show.
    fn drawn(&self) -> Drawn<'_> {
        let Report { tolerance, spread, bounds, points, .. } = self;
        Drawn { tolerance, spread, bounds, answer: self.natural(), points: points.as_ref() }
    }

    /// The depth in a sentence.
    fn sentence(&self) -> String {
        let natural = self.natural();
        let tolerance = short(&self.tolerance, 6);
        if let Some(Ok(found)) = &self.sets {
            return format!("For the tolerance {tolerance}: {}.", sets::sets_text(found));
        }
        if let Some(own) = &natural.polygon {
            return match own {
                Ok(own) => format!("For the tolerance {tolerance}: {}.", own.depth_text()),
                Err(why) => format!("No depth is known: {why}."),
            };
        }
        match &natural.exact {
            Ok(exact) => format!("For the tolerance {tolerance}: {}.", exact.depth_text()),
            Err(why) => format!("No depth is known: {why}."),
        }
    }

    /// The answer with the points at their natural parameters.
    fn natural(&self) -> &Answer {
        &self.answers[0]
    }

    /// The answer with the points at i/n^k.
    fn indexed(&self) -> &Answer {
        &self.answers[self.answers.len() - 1]
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let (name, mut tolerance) = (&arguments.scheme, arguments.tolerance.clone());
        if arguments.relative {
            tolerance.push_str(" of the diagonal");
        }
        let spread = match &self.points {
            Some(_) => short(&self.spread, 9),
            None => arguments.spread.spread.clone(),
        };
        sheet.heading(1, format!("{name}, ε = {tolerance}, β = {spread}"));
        let (natural, indexed) = (self.natural(), self.answers.get(1));
        if let (Some(points), Some(own)) = (&self.points, &natural.polygon) {
            let mut facts = vec![("control polygon".to_owned(), points.text())];
            let name = match &self.sets {
                None => "depth of the polygon",
                Some(found) => {
                    facts.extend(sets::facts(found));
                    sheet.facts(std::mem::take(&mut facts));
                    "at equal parameters"
                }
            };
            match own {
                Ok(own) => facts.extend(own.facts(points, name)),
                Err(why) => facts.push((name.to_owned(), format!("none: {why}"))),
            }
            if let Some(Some(Ok(own))) = indexed.map(|indexed| &indexed.polygon) {
                facts.push(("as papers do".to_owned(), own.depth_text()));
            }
            sheet.facts(facts);
        }
        let mut facts = match &natural.exact {
            Ok(exact) => exact.facts(),
            Err(why) => vec![("exact depth".to_owned(), format!("none: {why}"))],
        };
        if let Some(Ok(exact)) = indexed.map(|indexed| &indexed.exact) {
            facts.push(("as papers do".to_owned(), exact.short()));
        }
        facts.extend(self.bounds.facts());
        sheet.facts(facts);
        sheet.grid(self.bounds.grid());
        if self.points.as_ref().is_some_and(|points| points.coordinates.len() > 1) {
            sheet.text(
                "β, and the distance and the depth at equal parameters, are the greatest of the coordinates of the \
                 points.",
            );
            if self.sets.is_some() {
                sheet.text(
                    "As sets of points: no point of the polygon is farther than ε from the limit, and no point of the \
                     limit from the polygon, in the Euclidean distance. `--certificate` writes it for subcert-check. Nothing is said about \
                     the levels in between: the depth is the least level that is within the tolerance.",
                );
            }
        }
        sheet.text(
            "The exact depth is the least level from which on every control polygon or net of this \
             spread meets the tolerance. The sound bound also guarantees it, but from a later \
             level: the cruder the bound, the later. It compares the points at i/n^k, at the scheme's own offset, as papers do. The \
             printed formula, σβT^k/(1 − T) with one power of the constant for each level, |Σ| in \
             place of σ and offset 0, does not promise it.",
        );
        self.better_offsets.iter().for_each(|better| sheet.text(better.words.clone()));
        sheet
    }

    fn form<'a>(&'a self, arguments: &'a DepthArguments) -> form::Report<'a> {
        let exact = |answer: &'a Answer| or_none(&answer.exact, Exact::form);
        let own = |answer: &Answer| {
            let missing = Err("no polygon".to_owned());
            or_none(answer.polygon.as_ref().unwrap_or(&missing), OfPolygon::form)
        };
        let polygon = |points: &Points| form::Polygon {
            points: points.count,
            coordinates: points.coordinates.len(),
            closed: points.closed,
            sets: self.sets.as_ref().map(sets::sets_form),
            natural: own(self.natural()),
            indexed: own(self.indexed()),
        };
        form::Report {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            tolerance: self.tolerance.to_string(),
            spread: self.spread.to_string(),
            polygon: self.points.as_ref().map(polygon),
            natural: exact(self.natural()),
            indexed: exact(self.indexed()),
            sound: self.bounds.sound_form(),
            printed_formula: self.bounds.printed_forms(),
            better_offsets: &self.better_offsets,
        }
    }
}

/// An answer in JSON, or the reason that there is none.
fn or_none<'a, T, F>(answer: &'a Result<T, String>, form: impl Fn(&'a T) -> F) -> form::OrNone<F> {
    match answer {
        Ok(answer) => form::OrNone::Found(form(answer)),
        Err(why) => form::OrNone::None { none: why.clone() },
    }
}

/// The answer as sets of points: for points of several coordinates, if it is not left out.
fn sets(
    scheme: &Scheme,
    points: Option<&Points>,
    arguments: &DepthArguments,
    tolerance: &Rational,
    budget: Budget,
) -> Result<Option<OfSets>, Failure> {
    let certificate = arguments.certificate.as_deref();
    let (Scheme::Curve(mask), Some(points)) = (scheme, points) else { return Ok(None) };
    match (points.coordinates.len(), arguments.distance) {
        (_, Some(DistanceArgument::Parametric)) | (1, None) if certificate.is_some() => {
            Err(certified::none("leave out --distance parametric, and write (i, x) for numbers"))
        }
        (_, Some(DistanceArgument::Parametric)) | (1, None) => Ok(None),
        (1, Some(DistanceArgument::Geometric)) => {
            let message = "--distance geometric is for points of two coordinates or more; numbers are values \
                           at parameters: write (i, x) on each line for their graph";
            Err(Failure::Input(message.to_owned()))
        }
        _ => of_sets(mask, points, tolerance, budget, certificate).map(Some),
    }
}

/// The caps on a control polygon whose depth is asked for.
const CAPS: Caps = Caps { bytes: 1 << 20, points: 10_000, bits: 4_096 };

/// The control polygon that was given.
fn points(scheme: &Scheme, arguments: &DepthArguments) -> Result<Option<Points>, Failure> {
    let Some(path) = &arguments.polygon else { return Ok(None) };
    if let Scheme::Tensor(..) = scheme {
        let message = "--polygon is for curves; a surface has a control net";
        return Err(Failure::Input(message.to_owned()));
    }
    let closed = arguments.boundary != Some(DepthBoundary::Polygon(BoundaryArgument::Open));
    let points = Points::new(&read_polygon(path, &CAPS)?, closed);
    if points.spread().is_zero() {
        let message = "--polygon: all points are the same, and so is the limit at every level";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(Some(points))
}
