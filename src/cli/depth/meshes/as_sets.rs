//! The depth of one polygon mesh, one net or the boundary of one solid by its distance from the limit as sets of points.

use super::face_depths::Search;
use super::faces::FacesFormat;
use super::kind::{Kind, near};
use super::promise::{APriori, Formula};
use super::subject::Subject;
use crate::cli::arguments::{DepthArguments, DistanceArgument, FacesArgument};
use crate::cli::console::answer::{Answer, SCHEMA};
use crate::cli::console::output::{Failure, Outcome, note};
use crate::cli::console::quantity::{Float, Text};
use crate::cli::depth::distance::AsSets;
use crate::cli::depth::numbers::{found, levels, point};
use serde::Serialize;
use subcert::exact::{Rational, format::short};
use subcert::mesh::{Point, PolygonMesh};
use subcert::patch::{FaceSurface, GeometricPlace, LEAST_SHARE, SetKind, relative_tolerance};
use subcert::report::Sheet;
use subcert::report::html::Picture;
use subcert::solid::SolidBoundary;

/// Whether the distance of sets is asked for, and the tolerance. `notes` gets why equal parameters are compared where
/// nothing asks for them.
pub(super) fn measure(
    points: &[Point<Rational>],
    arguments: &DepthArguments,
    asked: &Rational,
    name: &str,
    notes: &mut Vec<String>,
) -> Result<(bool, Rational), Failure> {
    // Equal parameters have an answer for tolerances that are too small for sets.
    let small = || {
        let share = Rational::new(1, 1 << LEAST_SHARE);
        relative_tolerance(points, &share).is_none_or(|least| *asked < least)
    };
    let geometric = arguments.distance.map_or_else(
        || {
            let of_sets = arguments.relative || arguments.faces == FacesArgument::Fan;
            of_sets || arguments.a_priori || !small()
        },
        |distance| distance == DistanceArgument::Geometric,
    );
    if !geometric && arguments.distance.is_none() {
        notes.push(format!(
            "the tolerance is less than 2^-{LEAST_SHARE} of the diagonal of the box around the {name}, which is too \
             little for a distance of sets of points: points of equal parameters are compared"
        ));
    }
    if !arguments.relative {
        return Ok((geometric, asked.clone()));
    }
    if !geometric {
        // The diagonal is a root, and ties at equal parameters are decided exactly.
        let message = "--relative is for the distance of sets; leave out --distance parametric, or give \
                       the tolerance itself";
        return Err(Failure::Input(message.to_owned()));
    }
    let tolerance = relative_tolerance(points, asked).ok_or_else(|| {
        let message =
            format!("--relative: the box around the {name} has no diagonal that f64 can hold");
        Failure::Input(message)
    })?;
    Ok((true, tolerance))
}

/// Refuses fans where equal parameters are compared.
pub(super) fn no_fan(arguments: &DepthArguments) -> Outcome {
    if arguments.faces != FacesArgument::Fan {
        return Ok(());
    }
    let message =
        "--faces fan is for the distance of sets; at equal parameters, quadrilaterals are bilinear";
    Err(Failure::Input(message.to_owned()))
}

/// The depth of one mesh or net.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct SetDepth<'a> {
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
    /// The share of the diagonal that it was asked for as; null without `--relative`.
    relative: Option<Text<Rational>>,
    /// How distances are measured: `hausdorff`.
    measure: &'static str,
    /// What faces are: `bilinear` or `fan`.
    faces: &'static str,
    /// The level, and those that are too few; their fields stand here.
    #[serde(flatten)]
    found: AsSets<Place>,
    /// How many faces adaptive refinement has; null without `--per-face`.
    adaptive: Option<Adaptive>,
    /// What the longest edge and the valences guarantee, by equal parameters.
    a_priori: APriori,
    /// What a paper's formula promises; null where there is none.
    formula: Option<Formula>,
    /// The file that `--certificate` wrote, of a net; or null.
    certificate: Option<String>,
    #[serde(skip)]
    kind: Kind,
    #[serde(skip)]
    surface: FaceSurface,
    /// The tolerance as it was given.
    #[serde(skip)]
    given: &'a str,
    #[serde(skip)]
    picture: Option<Picture>,
}

/// A point of one set that is far from the other.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Place {
    /// The face of the control mesh or net, from 0.
    face: usize,
    /// For a net, the row and the column of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<[usize; 2]>,
    /// For the boundary of a solid, the cell of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    solid_cell: Option<usize>,
    /// The vertex of that face that it is near; of a solid, as the file numbers it.
    vertex: Option<usize>,
    /// The face of the level.
    level_face: Option<Text<u128>>,
    /// `mesh`, which a net is too, or `limit`.
    from: &'static str,
    /// The point.
    point: [Float; 3],
    /// A point of the other set that is near.
    other: [Float; 3],
    /// The point is at least so far from the other set.
    distance: Float,
    #[serde(skip)]
    set: SetKind,
}

impl Place {
    fn of(place: &GeometricPlace, kind: Kind, solid: Option<&SolidBoundary<Rational>>) -> Place {
        let GeometricPlace { face, vertex, from, .. } = *place;
        let found = found(place.point.iter().chain(&place.other));
        Place {
            face,
            cell: kind.cell(face),
            solid_cell: solid.map(|solid| solid.cells[face]),
            vertex: vertex.map(|vertex| solid.map_or(vertex, |solid| solid.points[vertex])),
            level_face: place.level_face.map(Text),
            from: from.name(),
            point: place.point.map(found),
            other: place.other.map(found),
            distance: Float(place.distance),
            set: from,
        }
    }

    fn words(&self, kind: Kind, tolerance: &Rational) -> String {
        let Place { face, cell, solid_cell, vertex, level_face, distance, .. } = self;
        let distance = distance.above(tolerance);
        let cell = match (solid_cell, cell) {
            (Some(cell), _) => format!(" (of cell {cell})"),
            (None, Some([i, j])) => format!(" (cell {i}, {j})"),
            (None, None) => String::new(),
        };
        let near = near(*vertex, level_face.as_ref());
        let (from, other) = match self.set {
            SetKind::Mesh => (kind.name(), "limit"),
            SetKind::Limit => ("limit", kind.name()),
        };
        format!(
            "face {face}{cell}{near}: {} of the {from} is at least {distance} from the {other}",
            point(&self.point)
        )
    }
}

/// Numbers of faces, those that join levels not counted.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Adaptive {
    /// At one level for all.
    uniform: Float,
    /// Where each face has its own level.
    adaptive: Float,
}

impl SetDepth<'_> {
    /// The answer for a mesh, which may be the boundary of a solid, after the file of `--per-face` is written. `share` is
    /// the tolerance as it was asked for.
    pub(super) fn of<'a>(
        subject: Subject<'a>,
        share: Rational,
        mesh: &PolygonMesh<Rational>,
        solid: Option<&SolidBoundary<Rational>>,
        search: Search,
    ) -> Result<SetDepth<'a>, Failure> {
        let Subject { scheme, name, notes, kind, arguments, tolerance, guaranteed, promised } =
            subject;
        let Search { surface, growth, mut found, faces } = search;
        if found.ended.is_some() {
            // A search that is stopped may know less than is known before it.
            found.level = found.level.map(|level| level.min(guaranteed.level));
        }
        let faces = faces.zip(found.level);
        match (&arguments.per_face, &faces) {
            (Some(path), Some((faces, level))) => {
                FacesFormat::of(path)?.write(path, mesh, &faces.rows(*level))?;
            }
            (Some(path), None) => {
                let path = path.display();
                note(&format!("`{path}` is not written: no level is known to be sufficient"));
            }
            (None, _) => {}
        }
        let adaptive = faces.as_ref().map(|(faces, level)| {
            let [uniform, adaptive] = faces.counts(mesh, growth, *level).map(Float);
            Adaptive { uniform, adaptive }
        });
        let picture = faces.filter(|_| arguments.output.is_page());
        let picture = picture.and_then(|(faces, level)| faces.picture(&name, mesh, level));
        Ok(SetDepth {
            schema: SCHEMA,
            scheme,
            mesh: name,
            notes,
            tolerance: Text(tolerance),
            relative: arguments.relative.then_some(Text(share)),
            measure: "hausdorff",
            faces: surface.name(),
            adaptive,
            a_priori: guaranteed,
            formula: promised.map(|formula| formula.compared(found.too_few, found.level)),
            certificate: arguments.certificate.as_ref().map(|path| path.display().to_string()),
            found: AsSets::of(found, |place| Place::of(&place, kind, solid)),
            kind,
            surface,
            given: &arguments.tolerance,
            picture,
        })
    }
}

impl Answer for SetDepth<'_> {
    const NAME: &'static str = "depth-mesh-geometric";

    fn sentence(&self) -> String {
        let (tolerance, name) = (short(&self.tolerance.0, 6), self.kind.name());
        let Some(level) = self.found.level else {
            return format!(
                "Levels of refinement after which the {name} is within {tolerance} of its limit, as a set of points: {}.",
                self.found.words("")
            );
        };
        let few = self.found.too_few.map(|few| format!(", and not after {few}"));
        format!(
            "The {name} is within {tolerance} of its limit, as a set of points, after {} of refinement{}.",
            levels(level),
            few.unwrap_or_default()
        )
    }

    fn sheet(&self) -> Sheet {
        let mut sheet = Sheet::default();
        let SetDepth { scheme, mesh, kind, found, a_priori, .. } = self;
        let of = if self.relative.is_some() { " of the diagonal" } else { "" };
        sheet.heading(1, format!("{mesh}, {scheme}, ε = {}{of}", self.given));
        sheet.notes(&self.notes);
        let name = kind.name();
        let mut facts = vec![(format!("depth of the {name}"), found.words(""))];
        if self.relative.is_some() {
            facts.push(("tolerance".to_owned(), short(&self.tolerance.0, 9)));
        }
        facts.push((
            "distance".to_owned(),
            format!("Hausdorff: of {name} and limit as sets of points, from both sides"),
        ));
        facts.push(("faces".to_owned(), faces_text(self.surface, *kind).to_owned()));
        facts.extend(found.beyond().map(|(level, place)| {
            (format!("too far at level {level}"), place.words(*kind, &self.tolerance.0))
        }));
        if let Some(Adaptive { uniform, adaptive }) = &self.adaptive {
            facts.push((
                "adaptive refinement".to_owned(),
                format!(
                    "{} faces where each has its own level, {} at one level for all; faces that \
                     join levels are not counted",
                    adaptive.0, uniform.0
                ),
            ));
        }
        facts.push((
            "a priori".to_owned(),
            format!(
                "{}, for all {} edges of length at most {}, at equal parameters",
                levels(a_priori.level),
                kind.all(),
                a_priori.longest_edge.up(9)
            ),
        ));
        facts.extend(self.formula.as_ref().map(|formula| formula.fact("mesh")));
        sheet.facts(facts);
        let net = match kind {
            Kind::Net { .. } => {
                " Both are taken where the points determine the limit. Cells, faces and vertices are numbered \
                 from 0, row by row."
            }
            Kind::Boundary => {
                " Cells and vertices are numbered from 0 as in the file, faces of the boundary from 0, cell by cell."
            }
            _ => " Faces and vertices are numbered from 0.",
        };
        let certificate = match kind {
            Kind::Net { .. } => "`--certificate` writes it for subcert-check.",
            _ => "It has no certificate.",
        };
        let compares = match kind {
            Kind::Boundary => "all cells of the solid with the limit solid at equal parameters",
            _ => "points of equal parameters",
        };
        sheet.text(format!(
            "The distance is the greatest one of any point of the {name} from the limit surface, and of any \
             point of the surface from the {name}. {certificate} {} \
             `--distance parametric` compares {compares}.{net}",
            found.meaning()
        ));
        sheet
    }

    fn pictures(&self) -> Vec<Picture> {
        self.picture.iter().cloned().collect()
    }
}

/// What faces are, in words.
fn faces_text(surface: FaceSurface, kind: Kind) -> &'static str {
    match surface {
        _ if matches!(kind, Kind::Net { .. }) => "bilinear",
        FaceSurface::Bilinear if kind == Kind::Boundary => "quadrilaterals, bilinear",
        FaceSurface::Fan if kind == Kind::Boundary => {
            "quadrilaterals, as fans from their centroids"
        }
        FaceSurface::Bilinear => {
            "triangles flat, quadrilaterals bilinear, others as fans from their centroids"
        }
        FaceSurface::Fan => "triangles flat, others as fans from their centroids",
    }
}
