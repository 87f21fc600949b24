//! `subcert oracle`.

use super::commands::{self, check_boundary};
use super::mesh::input;
use super::polygon::{Caps, read_grid, read_polygon};
use crate::cli::arguments::{AnyBoundary, BoundaryArgument, OracleArguments, OracleFormat};
use crate::cli::console::output::{Failure, Outcome, deliver, note};
use std::path::Path;
use subcert::oracle::{
    Boundary, Control, LatticeRequest, LocalRequest, MAX_VALUES, OracleError, OracleRequest,
    OracleValues, lattice_reference_values, reference_values, ring_reference_values, to_csv,
    to_json, to_matlab, to_source, to_table,
};
use subcert::scheme::{AnyScheme, LatticeMask, LocalRules, Scheme, parse_any_scheme};
use subcert::spectrum::table::Language;

/// The largest control polygon that is read.
const CAPS: Caps = Caps { bytes: 16 << 20, points: MAX_VALUES, bits: u64::MAX };

/// The number of points of a seeded polygon, where none is given.
const SEEDED_POINTS: usize = 8;

pub(crate) fn oracle(arguments: &OracleArguments) -> Outcome {
    if let Some(path) = &arguments.mesh {
        if arguments.format == OracleFormat::Matlab {
            let message = "--mesh writes json, csv, table, c or rust; `subcert refine` writes other forms too";
            return Err(Failure::Input(message.to_owned()));
        }
        return commands::reference_values(arguments, path);
    }
    check_boundary(arguments.boundary, true, false)?;
    let mut notes = subcert::scheme::notes(&arguments.scheme);
    let mut values = match parse_any_scheme(&arguments.scheme)? {
        AnyScheme::Uniform(scheme) => uniform(&scheme, arguments, &mut notes)?,
        AnyScheme::Lattice(mask) => of_lattice(&mask, arguments, &mut notes)?,
        AnyScheme::LocalRules(ring) => of_ring(&ring, arguments, &mut notes)?,
    };
    for told in &notes {
        note(told);
    }
    values.header.notes = notes;
    let text = match arguments.format {
        OracleFormat::Json => to_json(&values),
        OracleFormat::Csv => to_csv(&values),
        OracleFormat::Table => to_table(&values),
        OracleFormat::Matlab => to_matlab(&values),
        OracleFormat::C => to_source(&values, Language::C).map_err(|error| input(&error))?,
        OracleFormat::Rust => to_source(&values, Language::Rust).map_err(|error| input(&error))?,
    };
    deliver(&text, arguments.file.as_deref())
}

fn refused(error: &OracleError) -> Failure {
    Failure::Input(error.to_string())
}

fn uniform(
    scheme: &Scheme,
    arguments: &OracleArguments,
    notes: &mut Vec<String>,
) -> Result<OracleValues, Failure> {
    let request = OracleRequest {
        scheme: arguments.scheme.clone(),
        max_block: arguments.block.levels,
        control: control(arguments, scheme, notes)?,
        level: arguments.level,
        boundary: if is_open(arguments) { Boundary::Open } else { Boundary::Closed },
    };
    reference_values(scheme, &request).map_err(|error| refused(&error))
}

/// A mask on Z^d: of data in the plane from a file, or else of a single 1.
fn of_lattice(
    mask: &LatticeMask,
    arguments: &OracleArguments,
    notes: &mut Vec<String>,
) -> Result<OracleValues, Failure> {
    let sides = arguments.points.is_some() || arguments.boundary.is_some();
    let solid = arguments.polygon.is_some() && mask.dimension() == 3;
    if sides || solid {
        let problem = "a mask on Z^d has no --points and no --boundary, since data are 0 beyond those given; --polygon FILE has rows of numbers, for masks on Z^2";
        return Err(Failure::Input(problem.to_owned()));
    }
    let control = arguments.polygon.as_ref().map(|path| of_grid(path, notes)).transpose()?;
    if control.is_none() {
        notes.push("the data are a single 1 at 0; --polygon FILE has others".to_owned());
    }
    let request = LatticeRequest {
        scheme: arguments.scheme.clone(),
        max_block: arguments.block.levels,
        control,
        level: arguments.level,
    };
    lattice_reference_values(mask, &request).map_err(|error| refused(&error))
}

fn of_ring(
    ring: &LocalRules,
    arguments: &OracleArguments,
    notes: &mut Vec<String>,
) -> Result<OracleValues, Failure> {
    let points = ring.point_count();
    if arguments.points.is_some() || arguments.boundary.is_some() {
        return Err(Failure::Input(format!(
            "--points and --boundary are for polygons; this ring has {points} points, and no ends"
        )));
    }
    let request = LocalRequest {
        scheme: arguments.scheme.clone(),
        max_block: arguments.block.levels,
        control: match &arguments.polygon {
            Some(path) => of_polygon(path, false, notes)?,
            None => Control::seeded_polygon(arguments.seed, points),
        },
        level: arguments.level,
    };
    ring_reference_values(ring, &request).map_err(|error| refused(&error))
}

fn is_open(arguments: &OracleArguments) -> bool {
    arguments.boundary == Some(AnyBoundary::Polygon(BoundaryArgument::Open))
}

/// The control polygon or grid: from a file, or seeded.
fn control(
    arguments: &OracleArguments,
    scheme: &Scheme,
    notes: &mut Vec<String>,
) -> Result<Control, Failure> {
    let surface = scheme.only().is_none();
    if let Some(path) = &arguments.polygon {
        return if surface {
            of_grid(path, notes)
        } else {
            of_polygon(path, !is_open(arguments), notes)
        };
    }
    let (seed, points) = (arguments.seed, arguments.points.unwrap_or(SEEDED_POINTS));
    Ok(if surface {
        Control::seeded_grid(seed, points, points)
    } else {
        Control::seeded_polygon(seed, points)
    })
}

/// The control polygon in a file.
fn of_polygon(path: &Path, closed: bool, notes: &mut Vec<String>) -> Result<Control, Failure> {
    let polygon = read_polygon(path, &CAPS, closed)?;
    notes.extend(polygon.notes);
    Ok(Control::points(polygon.coordinates))
}

/// The control grid in a file.
fn of_grid(path: &Path, notes: &mut Vec<String>) -> Result<Control, Failure> {
    let (rows, told) = read_grid(path, &CAPS)?;
    notes.extend(told);
    let columns = rows.first().map_or(0, Vec::len);
    let ragged = || Failure::Input("the rows have different lengths".to_owned());
    Control::grid(rows.concat(), columns).ok_or_else(ragged)
}
