//! The depth of a curve or a surface: for all control data of a spread, and for one control polygon.

use super::bound::{Bounds, MAX_NORM_STEPS};
use super::certified;
use super::compared::{Compared, MAX_STEPS};
use super::exact::{Asked, Exactly};
use super::points::Points;
use super::polygon::{OfPolygon, Polygon};
use super::scheme_pictures::Drawn;
use super::sets::{self, Sets, of_sets};
use crate::cli::arguments::{
    AnyBoundary, BoundaryArgument, DepthArguments, DistanceArgument, FindingFormat,
};
use crate::cli::console::answer::{Answer, OrNone, SCHEMA};
use crate::cli::console::output::{Failure, positive};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::Text;
use crate::cli::constants::offset::BetterOffset;
use crate::cli::geometry::polygon::{Caps, ControlPolygon, read_polygon};
use serde::Serialize;
use subcert::bound::{Budget, Constants};
use subcert::exact::{Rational, format::short};
use subcert::limit::Parametrisation;
use subcert::patch::MAX_CURVE_PIECES;
use subcert::report::Sheet;
use subcert::report::html::Picture;
use subcert::scheme::Scheme;

/// The depth for a tolerance.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Depth<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The tolerance ε.
    tolerance: Text<Rational>,
    /// The spread β.
    spread: Text<Rational>,
    /// The control polygon; null where none was given.
    polygon: Option<Polygon>,
    /// The true depth for every control polygon or net of the spread, each point of level k at its
    /// natural parameter (i + s)/n^k.
    natural: OrNone<Exactly>,
    /// The true depth with each point of level k at i/n^k, as papers do.
    indexed: OrNone<Exactly>,
    /// What bounds promise; their fields stand here.
    #[serde(flatten)]
    bounds: Bounds,
    /// The better offsets of files that state none; missing where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    better_offsets: Vec<BetterOffset>,
    /// Whether both parametrisations differ.
    #[serde(skip)]
    is_moved: bool,
    /// The tolerance and the spread as they were given.
    #[serde(skip)]
    given: [String; 2],
    #[serde(skip)]
    pictures: Vec<Picture>,
}

impl Depth<'_> {
    pub(super) fn of<'a>(
        scheme: &Scheme,
        arguments: &'a DepthArguments,
    ) -> Result<Depth<'a>, Failure> {
        let mut tolerance = positive("--tolerance", &arguments.tolerance)?;
        let points = points(scheme, arguments)?;
        let mut given = [arguments.tolerance.clone(), arguments.spread.spread.clone()];
        if let (Some(points), true) = (&points, arguments.relative) {
            tolerance = points.share_of_diagonal(&tolerance).ok_or_else(|| {
                let message =
                    "--relative: the box around the polygon has no diagonal that f64 can hold";
                Failure::Input(message.to_owned())
            })?;
        }
        if arguments.relative {
            given[0].push_str(" of the diagonal");
        }
        let spread = match &points {
            Some(points) => points.spread(),
            None => positive("--spread", &arguments.spread.spread)?,
        };
        if points.is_some() {
            given[1] = short(&spread, 9);
        }
        let width = match &arguments.width {
            Some(width) => positive("--width", width)?,
            None => &tolerance / Rational::from(1000),
        };
        // If the natural shifts are 0, both parametrisations are the same.
        let is_moved = Parametrisation::Natural.moves(scheme.masks());
        let of_each = 1 + usize::from(points.is_some());
        let count = of_each * (1 + usize::from(is_moved));
        let mut budgets: Vec<Budget> =
            (0..count).map(|_| Budget::new(MAX_STEPS / count as u64)).collect();
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
        let compared = |parametrisation, budgets: &[Budget]| {
            Compared::of(scheme, parametrisation, points.as_ref(), &asked, budgets)
        };
        let sets = sets(scheme, points.as_ref(), arguments, &tolerance, pieces)?;
        let natural = compared(Parametrisation::Natural, &budgets[..of_each])?;
        let indexed = if is_moved {
            compared(Parametrisation::Indexed, &budgets[of_each..])?
        } else {
            natural.clone()
        };
        drop(progress);
        let pictures = if levels {
            let (tolerance, spread, points) = (&tolerance, &spread, points.as_ref());
            Drawn { tolerance, spread, bounds: &bounds, natural: &natural, points }.pictures(scheme)
        } else {
            Vec::new()
        };
        let polygon = points.zip(natural.polygon.zip(indexed.polygon));
        let polygon = polygon.map(|(points, (natural, indexed))| Polygon {
            points: points.count,
            coordinates: points.coordinates.len(),
            closed: points.closed,
            notes: points.notes,
            sets,
            natural,
            indexed,
        });
        Ok(Depth {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            tolerance: Text(tolerance),
            spread: Text(spread),
            polygon,
            natural: natural.exact,
            indexed: indexed.exact,
            bounds,
            better_offsets: BetterOffset::all_of(&arguments.scheme, scheme)?,
            is_moved,
            given,
            pictures,
        })
    }

    /// The depth with the points at i/n^k, where that is another one.
    fn moved<'t, T>(&self, indexed: &'t OrNone<T>) -> Option<&'t T> {
        indexed.found().filter(|_| self.is_moved)
    }

    fn facts_of_polygon(&self, polygon: &Polygon, sheet: &mut Sheet) {
        let mut facts = vec![("control polygon".to_owned(), polygon.words())];
        let mut name = "depth of the polygon";
        if let Some(found) = &polygon.sets {
            facts.extend(sets::facts(found, &self.tolerance.0));
            sheet.facts(std::mem::take(&mut facts));
            name = "at equal parameters";
        }
        match &polygon.natural {
            OrNone::Found(own) => {
                facts.extend(own.facts(polygon.coordinates, name, &self.tolerance.0));
            }
            OrNone::None { none } => facts.push((name.to_owned(), format!("none: {none}"))),
        }
        if let Some(own) = self.moved(&polygon.indexed) {
            facts.push(("as papers do".to_owned(), own.depth_text()));
        }
        sheet.facts(facts);
        sheet.notes(&polygon.notes);
    }
}

impl Answer for Depth<'_> {
    const NAME: &'static str = "depth";

    fn sentence(&self) -> String {
        let tolerance = short(&self.tolerance.0, 6);
        let polygon = self.polygon.as_ref();
        if let Some(found) = polygon.and_then(|own| own.sets.as_ref()?.found()) {
            return format!("For the tolerance {tolerance}: {}.", sets::sets_text(found));
        }
        let depth = match polygon {
            Some(polygon) => polygon.natural.map(OfPolygon::depth_text),
            None => self.natural.map(Exactly::depth_text),
        };
        match depth {
            OrNone::Found(depth) => format!("For the tolerance {tolerance}: {depth}."),
            OrNone::None { none } => format!("No depth is known: {none}."),
        }
    }

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let [tolerance, spread] = &self.given;
        sheet.heading(1, format!("{}, ε = {tolerance}, β = {spread}", self.scheme));
        if let Some(polygon) = &self.polygon {
            self.facts_of_polygon(polygon, &mut sheet);
        }
        let mut facts = match &self.natural {
            OrNone::Found(exact) => exact.facts(&self.tolerance.0),
            OrNone::None { none } => vec![("exact depth".to_owned(), format!("none: {none}"))],
        };
        if let Some(exact) = self.moved(&self.indexed) {
            facts.push(("as papers do".to_owned(), exact.short()));
        }
        facts.extend(self.bounds.facts());
        sheet.facts(facts);
        sheet.grid(self.bounds.grid());
        if let Some(polygon) = self.polygon.as_ref().filter(|polygon| polygon.coordinates > 1) {
            sheet.text(
                "β, and the distance and the depth at equal parameters, are the greatest of the coordinates of the \
                 points.",
            );
            if let Some(found) = polygon.sets.as_ref().and_then(OrNone::found) {
                sheet.text(format!(
                    "As sets of points: no point of the polygon is farther than ε from the limit, and no point of the \
                     limit from the polygon, in the Euclidean distance. `--certificate` writes it for subcert-check. {}",
                    found.meaning()
                ));
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

    fn pictures(&self) -> Vec<Picture> {
        self.pictures.clone()
    }
}

/// The answer as sets of points: for points of several coordinates, if it is not left out.
fn sets(
    scheme: &Scheme,
    points: Option<&Points>,
    arguments: &DepthArguments,
    tolerance: &Rational,
    budget: Budget,
) -> Result<Option<OrNone<Sets>>, Failure> {
    let certificate = arguments.certificate.as_deref();
    let (Some(mask), Some(points)) = (scheme.only(), points) else { return Ok(None) };
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
    if scheme.only().is_none() {
        let message = "--polygon is for curves; a surface has a control net";
        return Err(Failure::Input(message.to_owned()));
    }
    let closed = arguments.boundary != Some(AnyBoundary::Polygon(BoundaryArgument::Open));
    let ControlPolygon { coordinates, notes } = read_polygon(path, &CAPS, closed)?;
    let points = Points::new(&coordinates, closed, notes);
    if points.spread().is_zero() {
        let message = "--polygon: all points are the same, and so is the limit at every level";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(Some(points))
}
