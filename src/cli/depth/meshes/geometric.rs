//! The depth of one polygon mesh, one net or the boundary of one solid by its distance from the limit as sets of points.

use super::faces::{FaceRow, FacesFormat, without_holes};
use super::kind::Kind;
use super::promise::Formula;
use super::refined::rounded;
use crate::cli::arguments::{DepthArguments, DistanceArgument, FacesArgument, FindingFormat};
use crate::cli::console::destination::{Destination, command};
use crate::cli::console::interrupt::Interrupt;
use crate::cli::console::output::{Failure, Outcome, note};
use crate::cli::console::progress::Progress;
use crate::cli::depth::numbers::{depth_text, digits, levels, point};
use crate::cli::json::{SCHEMA, geometric_depth as form, mesh_depth};
use std::path::Path;
use std::sync::Arc;
use subcert::exact::{Rational, format::short};
use subcert::float::{shortest, upper};
use subcert::mesh::{MeshError, MeshScheme, Point, PolygonMesh};
use subcert::patch::{
    APriori, FaceDepth, FaceSurface, GeometricDepth, GeometricPlace, LEAST_SHARE, MeshDistances,
    MeshWork, relative_tolerance,
};
use subcert::report::Sheet;
use subcert::report::html::{ColouredFaces, FindingPage, Picture};
use subcert::solid::SolidBoundary;

/// Whether the distance of sets is asked for, and the tolerance.
pub(super) fn measure(
    points: &[Point<Rational>],
    arguments: &DepthArguments,
    asked: &Rational,
    name: &str,
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

/// How many faces come from one face: at level 1, and at each level after it.
#[derive(Clone, Copy)]
pub(super) enum Growth {
    /// Four, at every level.
    Triangles,
    /// One for each corner, then four.
    Corners,
    /// A product of arities, at every level.
    Arities(usize),
}

impl Growth {
    pub(super) fn of(scheme: MeshScheme) -> Growth {
        match scheme {
            MeshScheme::Loop | MeshScheme::LoopWarren => Growth::Triangles,
            _ => Growth::Corners,
        }
    }

    fn count(self, face: &[usize], level: u32) -> f64 {
        let [first, later] = match self {
            Growth::Triangles => [4, 4],
            Growth::Corners => [face.len(), 4],
            Growth::Arities(product) => [product; 2],
        }
        .map(|count| f64::from(u32::try_from(count).unwrap_or(u32::MAX)));
        let more = i32::try_from(level).unwrap_or(i32::MAX) - 1;
        if level == 0 { 1.0 } else { first * later.powi(more) }
    }
}

/// What each face needs, and its distance at the level found.
pub(super) struct Faces {
    depths: Vec<FaceDepth>,
    /// Lower and upper bounds at the level.
    distances: Vec<[f64; 2]>,
}

impl Faces {
    pub(super) fn new(
        mut depths: Vec<FaceDepth>,
        mut distances: Vec<[f64; 2]>,
        level: u32,
        tolerance: &Rational,
    ) -> Faces {
        // The level is sufficient for all, also where the search of single faces ended early.
        for bounds in &mut distances {
            bounds[1] = bounds[1].min(upper(tolerance));
        }
        for depth in depths.iter_mut().filter(|depth| depth.level > level) {
            (depth.level, depth.is_least) = (level, false);
        }
        Faces { depths, distances }
    }

    /// The rows of `--per-face`.
    fn rows(&self, level: u32) -> Vec<FaceRow> {
        let row = |(depth, bounds): (&FaceDepth, &[f64; 2])| FaceRow {
            level,
            bounds: *bounds,
            own: Some((depth.level, depth.is_least)),
        };
        self.depths.iter().zip(&self.distances).map(row).collect()
    }

    /// The picture of the distances.
    fn picture(&self, name: &str, mesh: &PolygonMesh<Rational>, level: u32) -> Option<Picture> {
        let points: Vec<[f64; 3]> = mesh.points().iter().map(rounded).collect();
        let values: Vec<f64> = self.distances.iter().map(|[_, upper]| *upper).collect();
        Picture::of_faces(&ColouredFaces {
            name,
            values_are: format!("upper bound of the Hausdorff distance at level {level}"),
            points: &points,
            faces: mesh.faces(),
            values: &values,
            place: None,
            note: "Bounds are the tolerance, or a half, a quarter or an eighth of it.",
        })
    }

    /// How many faces but holes there are at one level for all, and where each face has its own.
    fn counts(&self, mesh: &PolygonMesh<Rational>, growth: Growth, level: u32) -> [f64; 2] {
        without_holes(mesh, &self.depths).fold([0.0; 2], |[all, each], (_, own, vertices)| {
            [all + growth.count(vertices, level), each + growth.count(vertices, own.level)]
        })
    }
}

/// What the search finds on a polygon mesh.
pub(super) struct Surface {
    /// What its faces are.
    pub(super) of_faces: FaceSurface,
    pub(super) found: GeometricDepth,
    pub(super) faces: Option<Faces>,
}

impl Surface {
    pub(super) fn of(
        mesh: &PolygonMesh<Rational>,
        scheme: MeshScheme,
        tolerance: &Rational,
        arguments: &DepthArguments,
    ) -> Result<Surface, MeshError> {
        let work = Arc::<MeshWork>::default();
        let _interrupt = Interrupt::stops_work(&work, arguments.seconds);
        let surface = match arguments.faces {
            FacesArgument::Bilinear => FaceSurface::Bilinear,
            FacesArgument::Fan => FaceSurface::Fan,
        };
        let wanted = arguments.output.format != FindingFormat::Json;
        let _progress = Progress::of_pieces(Arc::clone(&work), wanted);
        let distances = MeshDistances::new(mesh.clone(), scheme)?.with_work(work);
        let found = distances.geometric_depth(tolerance, surface)?;
        let faces = match found.level.filter(|_| asks_for_faces(arguments)) {
            None => None,
            Some(level) => {
                let depths = distances.geometric_faces(tolerance, surface)?;
                let bounds = distances.geometric_distances(level, tolerance, surface)?;
                Some(Faces::new(depths, bounds, level, tolerance))
            }
        };
        Ok(Surface { of_faces: surface, found, faces })
    }
}

/// Whether the distances of all faces are needed.
pub(super) fn asks_for_faces(arguments: &DepthArguments) -> bool {
    arguments.per_face.is_some() || arguments.output.is_page()
}

/// The answer for one mesh, net or boundary of a solid.
pub(super) struct GeometricReport<'a> {
    pub(super) scheme: String,
    pub(super) kind: Kind,
    pub(super) growth: Growth,
    pub(super) name: String,
    pub(super) mesh: &'a PolygonMesh<Rational>,
    pub(super) tolerance: Rational,
    /// The share of the diagonal that the tolerance was asked for as.
    pub(super) relative: Option<Rational>,
    pub(super) surface: FaceSurface,
    pub(super) guaranteed: APriori,
    pub(super) promised: Option<Formula>,
    pub(super) found: GeometricDepth,
    pub(super) faces: Option<Faces>,
    /// The file of the certificate, which nets alone have.
    pub(super) certificate: Option<&'a Path>,
    /// The solid that the mesh is the boundary of.
    pub(super) solid: Option<&'a SolidBoundary<Rational>>,
}

impl GeometricReport<'_> {
    /// The vertex that a place is near, as the file numbers it.
    fn vertex(&self, place: &GeometricPlace) -> Option<usize> {
        place.vertex.map(|vertex| self.solid.map_or(vertex, |solid| solid.points[vertex]))
    }

    fn place_text(&self, place: &GeometricPlace) -> String {
        let GeometricPlace { face, level_face, from, point: at, distance, .. } = place;
        let kind = self.kind;
        let cell = match (self.solid, kind.cell(*face)) {
            (Some(solid), _) => format!(" (of cell {})", solid.cells[*face]),
            (None, Some([i, j])) => format!(" (cell {i}, {j})"),
            (None, None) => String::new(),
        };
        let corner =
            self.vertex(place).map(|vertex| format!(" near vertex {vertex}")).unwrap_or_default();
        let of_level =
            level_face.map(|face| format!(", face {face} of the level")).unwrap_or_default();
        let (from, other) = match from {
            subcert::patch::SetKind::Mesh => (kind.name(), "limit"),
            subcert::patch::SetKind::Limit => ("limit", kind.name()),
        };
        format!(
            "face {face}{cell}{corner}{of_level}: {} of the {from} is at least {} from the {other}",
            point(at),
            digits(*distance)
        )
    }

    pub(super) fn show(&self, arguments: &DepthArguments, to: &Destination) -> Outcome {
        match (&arguments.per_face, self.of_faces()) {
            (Some(path), Some((faces, level))) => {
                FacesFormat::of(path)?.write(path, self.mesh, &faces.rows(level))?;
            }
            (Some(path), None) => {
                let path = path.display();
                note(&format!("`{path}` is not written: no level is known to be sufficient"));
            }
            (None, _) => {}
        }
        let page = || {
            let (sentence, command) = (self.sentence(), command());
            let sheet = &self.sheet(arguments);
            let faces = self.of_faces();
            let picture =
                faces.and_then(|(faces, level)| faces.picture(&self.name, self.mesh, level));
            let pictures = &picture.into_iter().collect::<Vec<Picture>>();
            Ok(FindingPage { sentence: &sentence, sheet, pictures, command: &command }.to_html())
        };
        to.deliver(|| self.sheet(arguments), || self.form(), page)
    }

    fn sentence(&self) -> String {
        let tolerance = short(&self.tolerance, 6);
        let Some(level) = self.found.level else {
            return format!(
                "Levels of refinement after which the {} is within {tolerance} of its limit, as a set of points: {}.",
                self.kind.name(),
                depth_text(&self.found, "")
            );
        };
        let few = self.found.too_few.map(|few| format!(", and not after {few}"));
        let levels = levels(level);
        let few = few.unwrap_or_default();
        format!(
            "The {} is within {tolerance} of its limit, as a set of points, after {levels} of refinement{few}.",
            self.kind.name()
        )
    }

    fn sheet(&self, arguments: &DepthArguments) -> Sheet {
        let mut sheet = Sheet::default();
        let (scheme, kind) = (&self.scheme, self.kind);
        let tolerance = match &self.relative {
            None => arguments.tolerance.clone(),
            Some(_) => format!("{} of the diagonal", arguments.tolerance),
        };
        sheet.heading(1, format!("{}, {scheme}, ε = {tolerance}", self.name));
        let found = &self.found;
        let mut facts = vec![(format!("depth of the {}", kind.name()), depth_text(found, ""))];
        if self.relative.is_some() {
            facts.push(("tolerance".to_owned(), short(&self.tolerance, 9)));
        }
        facts.push((
            "distance".to_owned(),
            format!("Hausdorff: of {} and limit as sets of points, from both sides", kind.name()),
        ));
        facts.push(("faces".to_owned(), faces_text(self.surface, kind).to_owned()));
        let few = found.too_few.zip(found.beyond.as_ref());
        facts.extend(
            few.map(|(level, x)| (format!("too far at level {level}"), self.place_text(x))),
        );
        if let Some((faces, level)) = self.of_faces() {
            let [all, own] = faces.counts(self.mesh, self.growth, level);
            facts.push((
                "adaptive refinement".to_owned(),
                format!(
                    "{own} faces where each has its own level, {all} at one level for all; faces that \
                     join levels are not counted"
                ),
            ));
        }
        facts.push((
            "a priori".to_owned(),
            format!(
                "{}, for all {} edges of length at most {}, at equal parameters",
                levels(self.guaranteed.level),
                kind.all(),
                digits(self.guaranteed.longest_edge)
            ),
        ));
        if let Some(Formula { paper, level }) = self.promised {
            let text = match level {
                None => "nothing: its constant is not below 1 for this mesh".to_owned(),
                Some(level) => format!("{}: {}", levels(level), self.verdict(level)),
            };
            facts.push((format!("formula of {paper}"), text));
        }
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
        let name = kind.name();
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
             point of the surface from the {name}. {certificate} Nothing is said about \
             the levels in between: the depth is the least level that is within the tolerance. \
             `--distance parametric` compares {compares}.{net}"
        ));
        sheet
    }

    /// A promised number of levels, compared with what is known as sets of points.
    fn verdict(&self, level: u32) -> &'static str {
        match (self.found.too_few, self.found.level) {
            (Some(few), _) if level <= few => "too few",
            (_, Some(found)) if level > found => "more than needed",
            (_, Some(found)) if level == found => "enough",
            _ => "open",
        }
    }

    /// What is known of all faces, with the level that is sufficient.
    fn of_faces(&self) -> Option<(&Faces, u32)> {
        self.faces.as_ref().zip(self.found.level)
    }

    fn form(&self) -> form::Report<'_> {
        let place = |place: &GeometricPlace| form::Place {
            face: place.face,
            cell: self.kind.cell(place.face),
            solid_cell: self.solid.map(|solid| solid.cells[place.face]),
            vertex: self.vertex(place),
            level_face: place.level_face.map(|face| face.to_string()),
            from: place.from.name(),
            point: place.point.map(shortest),
            other: place.other.map(shortest),
            distance: shortest(place.distance),
        };
        let adaptive = self.of_faces().map(|(faces, level)| {
            let [uniform, adaptive] = faces.counts(self.mesh, self.growth, level);
            form::Adaptive { uniform: shortest(uniform), adaptive: shortest(adaptive) }
        });
        form::Report {
            schema: SCHEMA,
            scheme: &self.scheme,
            mesh: &self.name,
            tolerance: self.tolerance.to_string(),
            relative: self.relative.as_ref().map(ToString::to_string),
            measure: "hausdorff",
            faces: self.surface.name(),
            level: self.found.level,
            ended: self.found.ended.as_deref(),
            too_few: self.found.too_few,
            too_far: self.found.beyond.as_ref().map(place),
            adaptive,
            a_priori: mesh_depth::APriori {
                level: self.guaranteed.level,
                longest_edge: shortest(self.guaranteed.longest_edge),
                ratio: shortest(self.guaranteed.ratio),
            },
            formula: self.promised.map(|Formula { paper, level }| mesh_depth::Formula {
                paper,
                level,
                verdict: level.map(|level| self.verdict(level)),
            }),
            certificate: self.certificate.map(|path| path.display().to_string()),
        }
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
