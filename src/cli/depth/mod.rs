//! `subcert depth`.

mod bound;
mod exact;
mod interval;
mod local_rules;
mod polygon;
mod surface;

use super::arguments::{BoundaryArgument, DepthArguments, Format};
use super::json::{SCHEMA, depth as form};
use super::output::{Failure, Outcome, positive, show};
use super::polygon::read_polygon;
use super::progress::Progress;
use bound::Bounds;
use exact::{Asked, Exact};
use local_rules::ring_depth;
use polygon::{OfPolygon, Points};
use subcert::bound::{Budget, Constants};
use subcert::exact::{Rational, format::short};
use subcert::limit::{Distances, Limit, LimitError};
use subcert::report::Sheet;
use subcert::scheme::{AnyScheme, Mask, Scheme, parse_any_scheme};

pub(super) fn depth(arguments: &DepthArguments) -> Outcome {
    let scheme = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => scheme,
        AnyScheme::LocalRules(ring) => return ring_depth(&ring, arguments),
    };
    let report = Report::of(&scheme, arguments)?;
    show(arguments.output.format, || report.sheet(arguments), || report.form(arguments))
}

/// The answers to a question about a depth.
struct Report {
    tolerance: Rational,
    spread: Rational,
    bounds: Bounds,
    /// Where no limit is shown to exist, the reason.
    exact: Result<Exact, String>,
    polygon: Option<(Points, Result<OfPolygon, LimitError>)>,
}

impl Report {
    fn of(scheme: &Scheme, arguments: &DepthArguments) -> Result<Report, Failure> {
        let tolerance = positive("--tolerance", &arguments.tolerance)?;
        let points = points(scheme, arguments)?;
        let spread = match &points {
            Some(points) => points.spread(),
            None => positive("--spread", &arguments.spread.spread)?,
        };
        let width = match &arguments.width {
            Some(width) => positive("--width", width)?,
            None => &tolerance / Rational::from(1000),
        };
        // With a polygon there are two answers.
        let own_steps = if points.is_some() { MAX_STEPS / 2 } else { 0 };
        let budgets = [MAX_STEPS - own_steps, own_steps].map(Budget::new);
        let wanted = arguments.output.format != Format::Json;
        let progress = Progress::of_steps(&budgets, wanted);
        let [budget, own_budget] = budgets;
        let constants: Vec<Constants> =
            scheme.masks().into_iter().cloned().map(Constants::new).collect();
        let bounds = Bounds::of(&constants, arguments.block.levels, &tolerance, &spread)
            .map_err(|error| Failure::Input(error.to_string()))?;
        let asked = Asked { tolerance: &tolerance, spread: &spread, width: &width };
        let mut polygon = None;
        let exact = match scheme {
            Scheme::Curve(mask) => {
                let distances = distances(mask, &budget);
                let of = |distances: &Distances| Exact::of(mask, distances, &asked);
                let exact = distances.as_ref().map_err(Clone::clone).and_then(of);
                if let Some(points) = points {
                    let distances = distances.map(|all| all.with_budget(own_budget));
                    let of = |distances| OfPolygon::of(distances, &points, &tolerance, &width);
                    let own = distances.as_ref().map_err(Clone::clone).and_then(of);
                    if let Err(error @ LimitError::TooFew { .. }) = own {
                        return Err(Failure::Input(format!("--polygon: {error}")));
                    }
                    polygon = Some((points, own));
                }
                exact.map_err(|error| error.to_string())
            }
            Scheme::Tensor(first, second) => Exact::of_surface([first, second], &asked, &budget)
                .map_err(|error| error.to_string()),
        };
        drop(progress);
        Ok(Report { tolerance, spread, bounds, exact, polygon })
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let (name, tolerance) = (&arguments.scheme, &arguments.tolerance);
        let spread = match &self.polygon {
            Some(_) => short(&self.spread, 9),
            None => arguments.spread.spread.clone(),
        };
        sheet.heading(1, format!("{name}, ε = {tolerance}, β = {spread}"));
        if let Some((points, own)) = &self.polygon {
            let mut facts = vec![("control polygon".to_owned(), points.text())];
            match own {
                Ok(own) => facts.extend(own.facts(points)),
                Err(error) => {
                    facts.push(("depth of the polygon".to_owned(), format!("none: {error}")));
                }
            }
            sheet.facts(facts);
        }
        let mut facts = match &self.exact {
            Ok(exact) => exact.facts(),
            Err(why) => vec![("depth, exactly".to_owned(), format!("none: {why}"))],
        };
        facts.extend(self.bounds.facts());
        sheet.facts(facts);
        sheet.grid(self.bounds.grid());
        if self.polygon.as_ref().is_some_and(|(points, _)| points.coordinates.len() > 1) {
            sheet.text(
                "β, the distance and the depth of a polygon of points are the greatest of their \
                 coordinates.",
            );
        }
        sheet.text(
            "The exact depth is the least level that meets the tolerance for every control \
             polygon or net of this spread; the sound bound promises it too, the later the cruder it is. \
             Both compare at the scheme's own offset. The printed formula, σβT^k/(1 − T) with one \
             power of the constant for each level, |Σ| in place of σ and offset 0, does not \
             promise it.",
        );
        sheet
    }

    fn form<'a>(&'a self, arguments: &'a DepthArguments) -> form::Report<'a> {
        let polygon = |(points, own): &(Points, Result<OfPolygon, LimitError>)| match own {
            Ok(own) => form::OrNone::Found(own.form(points)),
            Err(error) => form::OrNone::None { none: error.to_string() },
        };
        form::Report {
            schema: SCHEMA,
            scheme: &arguments.scheme,
            tolerance: self.tolerance.to_string(),
            spread: self.spread.to_string(),
            polygon: self.polygon.as_ref().map(polygon),
            depth: match &self.exact {
                Ok(exact) => form::OrNone::Found(exact.form()),
                Err(why) => form::OrNone::None { none: why.clone() },
            },
            sound: self.bounds.sound_form(),
            printed_formula: self.bounds.printed_forms(),
        }
    }
}

/// The steps that the exact distances of one command may take.
const MAX_STEPS: u64 = 1_000_000_000;

fn distances(mask: &Mask, budget: &Budget) -> Result<Distances, LimitError> {
    let distances = Distances::new(&Limit::new(mask)?)?;
    Ok(distances.with_cells(u32::MAX).with_budget(budget.clone()))
}

/// The control polygon that was given.
fn points(scheme: &Scheme, arguments: &DepthArguments) -> Result<Option<Points>, Failure> {
    let Some(path) = &arguments.polygon else { return Ok(None) };
    if let Scheme::Tensor(..) = scheme {
        let message = "--polygon is for curves; a surface has a control net";
        return Err(Failure::Input(message.to_owned()));
    }
    let closed = arguments.boundary != Some(BoundaryArgument::Open);
    let points = Points::new(&read_polygon(path)?, closed);
    if points.spread().is_zero() {
        let message = "--polygon: all points are the same, and so is the limit at every level";
        return Err(Failure::Input(message.to_owned()));
    }
    Ok(Some(points))
}
