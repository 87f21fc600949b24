//! Reference values as arrays in the sources of tests.

use super::matlab::{arrays, matlab_name};
use super::values::OracleValues;
use super::write::header_lines;
use crate::exact::RealCyclotomic;
use crate::float::{nearest, ulp};
use crate::mesh::{BeyondF64, LimitPoint, Point, PolygonMesh, one_line, without_normals};
use crate::solid::HexMesh;
use crate::spectrum::table::{Array, Entries, Language, Real, write_vectors};

/// Numbers in rows, each row with its exact values, and whether they are one list.
type Rows = (Vec<(Vec<f64>, String)>, bool);

/// The values as arrays in a language. `control` goes into an implementation and `refined` comes out, for which `refined_ulp` has the units in
/// the last place. Each number is the nearest f64, and exact values stand behind them as comments. Names begin with
/// [`matlab_name`] where a language has no modules.
///
/// # Errors
/// When a value is beyond the greatest f64.
///
/// # Panics
/// When the language has no f64 ([`Language::types`]).
///
/// ```
/// use subcert::oracle::{Boundary, Control, OracleRequest, reference_values, to_source};
/// use subcert::scheme::parse_scheme;
/// use subcert::spectrum::table::Language;
///
/// let request = OracleRequest {
///     scheme: "chaikin".to_owned(),
///     max_block: 1,
///     control: Control::polygon(vec![0, 1, 3]),
///     level: 1,
///     boundary: Boundary::Closed,
/// };
/// let values = reference_values(&parse_scheme("chaikin")?, &request)?;
/// let text = to_source(&values, Language::Rust)?;
/// assert!(text.contains("pub static REFINED: [f64; 6] = [\n    0.25, // 1/4\n    0.75, // 3/4\n"));
/// let text = to_source(&values, Language::C)?;
/// assert!(text.contains("static const double oracle_chaikin_refined[6] = {\n    0x1p-2, // 1/4\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_source(values: &OracleValues, language: Language) -> Result<String, BeyondF64> {
    let groups = arrays(&values.groups);
    let mut source = Source::default();
    for group in &groups {
        let row = |row: Vec<&super::Value>| {
            let numbers = row.iter().map(|value| value.f64.parse().expect("an f64")).collect();
            let exact: Vec<&str> = row.iter().map(|value| value.exact.as_str()).collect();
            (numbers, exact.join(", "))
        };
        let rows = group.rows().map(row).collect();
        let list = group.columns.len() == 1 && group.columns[0].shape.len() < 2;
        let (about, computed) = (group.columns[0].about, group.name == "refined");
        source.numbers(&group.name, about, (rows, list), computed);
    }
    let header = &values.header;
    let head = header_lines(header).into_iter().filter(|(key, _)| *key != "columns");
    source.written(language, &header.scheme, header.level, head)
}

/// Points, and the cells that have them as corners: the faces of a polygon mesh or a net, or hexahedra.
#[derive(Clone, Debug)]
pub struct OracleMesh {
    /// `face` or `cell`.
    pub what: &'static str,
    /// The points.
    pub points: Vec<Point<RealCyclotomic>>,
    /// The corners of each cell.
    pub cells: Vec<Vec<usize>>,
}

impl From<&PolygonMesh<RealCyclotomic>> for OracleMesh {
    fn from(mesh: &PolygonMesh<RealCyclotomic>) -> OracleMesh {
        OracleMesh { what: "face", points: mesh.points().to_vec(), cells: mesh.faces().to_vec() }
    }
}

impl<S: Clone + Into<RealCyclotomic>> From<&HexMesh<S>> for OracleMesh {
    fn from(mesh: &HexMesh<S>) -> OracleMesh {
        let point = |point: &Point<S>| point.clone().map(Into::into);
        let points = mesh.points().iter().map(point).collect();
        let cells = mesh.cells().iter().map(|cell| cell.to_vec()).collect();
        OracleMesh { what: "cell", points, cells }
    }
}

/// A control mesh, the refined mesh of a level, and the limits of its points, as [`to_source`]. The head says what was refined; of `scheme`
/// and `mesh` in it the names are made.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// When the language has no f64 ([`Language::types`]).
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{MeshScheme, PolygonMesh, limit_points, refine_mesh};
/// use subcert::oracle::mesh_to_source;
/// use subcert::spectrum::table::Language;
///
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
/// let points = points.map(|point| point.map(RealCyclotomic::from)).to_vec();
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points, faces)?;
/// let refined = refine_mesh(&mesh, MeshScheme::Loop, 1)?;
/// let limits = limit_points(&refined, MeshScheme::Loop)?;
/// let head = [("scheme", "loop".to_owned()), ("mesh", "tetrahedron".to_owned())];
/// let both = [&mesh, &refined].map(Into::into);
/// let text = mesh_to_source(&both, &limits, 1, &head, Language::C)?;
/// assert!(text.contains("static const int oracle_loop_tetrahedron_face_sizes[16] = {3, 3,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_to_source(
    [control, refined]: &[OracleMesh; 2],
    limits: &[Option<LimitPoint>],
    level: u32,
    head: &[(&'static str, String)],
    language: Language,
) -> Result<String, BeyondF64> {
    let mut source = Source::default();
    for (prefix, mesh, about) in
        [("control_", control, "the control mesh"), ("", refined, "the refined mesh")]
    {
        let points = mesh.points.iter().map(exact).collect();
        let name = format!("{prefix}points");
        source.numbers(&name, &format!("{about}: its points"), (points, false), prefix.is_empty());
        let what = mesh.what;
        let sizes = mesh.cells.iter().map(Vec::len).collect();
        let about = format!("{about}: how many corners each {what} has");
        source.integers(format!("{prefix}{what}_sizes"), about, sizes);
        let about =
            format!("the corners of one {what} after the other, as numbers of points from 0 on");
        source.integers(format!("{prefix}{what}_points"), about, mesh.cells.concat());
    }
    let found = || limits.iter().enumerate().filter_map(|(at, limit)| Some((at, limit.as_ref()?)));
    let of = found().map(|(at, _)| at).collect();
    source.integers("limit_of".to_owned(), "limits[i] is that of point limit_of[i]".to_owned(), of);
    let positions = found().map(|(_, limit)| exact(&limit.position)).collect();
    source.numbers("limits", "where points of the refined mesh go", (positions, false), true);
    let normals = || found().filter_map(|(at, limit)| Some((at, limit.normal.as_ref().ok()?)));
    let of = normals().map(|(at, _)| at).collect();
    source.integers(
        "normal_of".to_owned(),
        "normals[i] is that at point normal_of[i]".to_owned(),
        of,
    );
    let unit = normals().map(|(_, normal)| {
        (normal.unit().to_vec(), format!("the direction of {}", normal.exact().join(", ")))
    });
    source.numbers("normals", "unit normals of the limit surface", (unit.collect(), false), false);
    let named = head.iter().filter(|(key, _)| ["scheme", "mesh"].contains(key));
    let name: Vec<&str> = named.map(|(_, value)| value.as_str()).collect();
    let told = without_normals(limits).map(|told| ("normals", told));
    source.written(language, &name.join(" "), level, head.iter().cloned().chain(told))
}

fn exact(point: &Point<RealCyclotomic>) -> (Vec<f64>, String) {
    (point.iter().map(nearest).collect(), point.each_ref().map(ToString::to_string).join(", "))
}

/// Arrays, each with its name and what it is.
#[derive(Default)]
struct Source(Vec<(String, String, Entries)>);

impl Source {
    /// Numbers, if there are any, with the units in the last place of what an implementation computes.
    fn numbers(&mut self, name: &str, about: &str, (rows, list): Rows, computed: bool) {
        let unit = |x: &f64| Real::F64(ulp(*x).map_or(f64::INFINITY, |ulp| nearest(&ulp)));
        let units = rows.iter().map(|(row, _)| row.iter().map(unit).collect::<Vec<Real>>());
        let units = computed.then(|| {
            if list {
                Entries::List(vec![units.flatten().collect()])
            } else {
                Entries::Table(units.collect())
            }
        });
        let empty = rows.is_empty();
        let mut push = |name, about, entries| {
            if !empty {
                self.0.push((name, about, entries));
            }
        };
        push(name.to_owned(), about.to_owned(), Entries::Noted { rows, list });
        if let Some(units) = units {
            push(format!("{name}_ulp"), format!("the units in the last place of {name}"), units);
        }
    }

    fn integers(&mut self, name: String, about: String, values: Vec<usize>) {
        if !values.is_empty() {
            self.0.push((name, about, Entries::Integers(values)));
        }
    }

    fn written(
        self,
        language: Language,
        what: &str,
        level: u32,
        head: impl Iterator<Item = (&'static str, String)>,
    ) -> Result<String, BeyondF64> {
        let finite = |(_, _, entries): &(_, _, Entries)| match entries {
            Entries::Noted { rows, .. } => {
                rows.iter().flat_map(|(row, _)| row).all(|x| x.is_finite())
            }
            _ => true,
        };
        if !self.0.iter().all(finite) {
            return Err(BeyondF64);
        }
        let mut header = vec![
            "Reference values for the test of an implementation: `control` goes in, and each array with a partner `_ulp` comes out.".to_owned(),
            "Every number is the f64 (IEEE 754, 64 bits) nearest to its exact value, which stands behind it.".to_owned(),
            "A unit in the last place is the distance to the next f64. 4 of them are a usual bound: |found - expected| <= 4*ulp.".to_owned(),
        ];
        header.extend(head.map(|(key, value)| one_line(&format!("{key}: {value}"))));
        let (names, others): (Vec<String>, Vec<(String, Entries)>) =
            self.0.into_iter().map(|(name, about, entries)| (name, (about, entries))).unzip();
        let array = |(name, (about, entries))| Array { name, about: vec![about], entries };
        let arrays: Vec<Array<'_>> =
            names.iter().map(String::as_str).zip(others).map(array).collect();
        let constants = vec![("level", i64::from(level))];
        Ok(write_vectors(language, &matlab_name(what), constants, &header, &arrays))
    }
}
