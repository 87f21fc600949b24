//! Files of solids: what is read, what is refused, and what is written is read back.

use crate::common::r;
use crate::common::solids::{solids, tetrahedron};
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::solid::{HexMesh, SolidFile, SolidFormat, read_solid, refine_solid, to_medit, to_vtk};

const VTK: &str = include_str!("../../examples/star.vtk");
const MEDIT: &str = include_str!("../../examples/bracket.mesh");

fn read(text: &str, format: SolidFormat) -> Result<SolidFile, String> {
    read_solid(&SourceText::new("test", text), format).map_err(|error| error.to_string())
}

/// An error, with its place.
fn refused(text: &str, format: SolidFormat, parts: &[&str]) {
    let error = read(text, format).err().unwrap_or_else(|| panic!("it is read: {text}"));
    for part in parts {
        assert!(error.contains(part), "no `{part}` in: {error}");
    }
}

fn mesh(text: &str, format: SolidFormat) -> HexMesh<Rational> {
    read(text, format).unwrap_or_else(|error| panic!("{error}")).mesh().clone()
}

#[test]
fn decimals_are_read_exactly() {
    let solid = mesh(VTK, SolidFormat::Vtk);
    assert_eq!((solid.points().len(), solid.cells().len()), (21, 6));
    assert_eq!(solid.points()[8], [r(13, 10), r(0, 1), r(7, 10)]);
    assert_eq!(solid.cells()[1], [0, 3, 4, 5, 7, 10, 11, 12]);
    let solid = mesh(MEDIT, SolidFormat::Medit);
    assert_eq!((solid.points().len(), solid.cells().len()), (36, 10));
    // Fractions, exponents and carriage returns too.
    let text = VTK.replace("1.2 0 0\n", "6/5 0e3 .0\r\n");
    assert_eq!(mesh(&text, SolidFormat::Vtk), mesh(VTK, SolidFormat::Vtk));
}

/// The form of version 5, voxels, data after the cells, comments, references.
#[test]
fn other_ways_to_write_the_same() {
    let cell = "0 1 2 3 4 5 6 7";
    let points = "POINTS 8 float\n0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n";
    let head = "# vtk DataFile Version 5.1\n\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    let old = format!("{head}{points}CELLS 1 9\n8 {cell}\nCELL_TYPES 1\n12\n");
    let new = format!(
        "{head}FIELD FieldData 1\nTIME 1 1 double\n0.5\n{points}METADATA\nINFORMATION 0\n\n\
         CELLS 2 8\nOFFSETS vtktypeint64\n0 8\nCONNECTIVITY vtktypeint64\n{cell}\n\
         CELL_TYPES 1\n12\n\nPOINT_DATA 8\nSCALARS t float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n"
    );
    let voxel = format!("{head}{points}CELLS 1 9\n8 0 1 3 2 4 5 7 6\nCELL_TYPES 1\n11\n");
    let medit = "MeshVersionFormatted 1\nDimension\n3\n# a comment\nVertices\n8\n0 0 0 1\n1 0 0 1\n\
                 1 1 0 -1\n0 1 0 2\n0 0 1 3\n1 0 1 3\n1 1 1 3\n0 1 1 3\nQuadrilaterals\n1\n1 2 3 4 5\n\
                 Tetrahedra\n0\nHexahedra\n1\n1 2 3 4 5 6 7 8 7\nEnd\nwhatever comes after\n";
    let expected = mesh(&old, SolidFormat::Vtk);
    assert_eq!(mesh(&new, SolidFormat::Vtk), expected);
    assert_eq!(mesh(&voxel, SolidFormat::Vtk), expected);
    assert_eq!(mesh(medit, SolidFormat::Medit), expected);
}

#[test]
fn what_is_written_is_read_back() {
    for solid in solids().into_iter().chain([tetrahedron()]) {
        let solid = refine_solid(&solid, 1).expect("small");
        let near = solid.map(nearest);
        let vtk = to_vtk(&solid, "a title\nof two lines").expect("finite");
        assert!(mesh(&vtk, SolidFormat::Vtk).map(nearest) == near);
        let medit = to_medit(&solid, "a title\nof two lines").expect("finite");
        assert!(mesh(&medit, SolidFormat::Medit).map(nearest) == near);
        assert_eq!(SolidFormat::of("-".as_ref(), &vtk), Some(SolidFormat::Vtk));
        assert_eq!(SolidFormat::of("-".as_ref(), &medit), Some(SolidFormat::Medit));
    }
    assert_eq!(SolidFormat::of("a.obj".as_ref(), "v 0 0 0\n"), None);
}

#[test]
fn bad_vtk() {
    let vtk = |from: &str, to: &str, parts: &[&str]| {
        assert!(VTK.contains(from), "{from}");
        refused(&VTK.replacen(from, to, 1), SolidFormat::Vtk, parts);
    };
    vtk("ASCII", "BINARY", &["test:3:1", "a binary VTK file", "ascii"]);
    vtk("# vtk", "<VTKFile", &["test:1:1", "this is no VTK file", "MeshVersionFormatted"]);
    vtk("UNSTRUCTURED_GRID", "POLYDATA", &["test:4:1", "`DATASET UNSTRUCTURED_GRID` is expected"]);
    vtk(
        "POINTS 21",
        "POINTS 22",
        &["test:27:1", "and not `CELLS`", "21 of 22 points have been read"],
    );
    vtk("POINTS 21", "POINTS 20", &["test:26:1", "is not expected here", "count"]);
    vtk("\n12\n12", "\n12\n10", &["a cell of type 10, a tetrahedron", "save only the hexahedra"]);
    vtk("8 0 1 2 3 7", "8 0 1 2 21 7", &["test:28:1", "point 21 does not exist", "21 points"]);
    vtk("8 0 1 2 3 7", "8 0 1 2 2 7", &["test:28:1", "a degenerate cell", "corner 2 twice"]);
    vtk("8 0 1 2 3 7", "8 0 1 2 -3 7", &["test:28:9", "no natural number"]);
    vtk("1.2 0 0", "1.2 0 nan", &["test:7:7", "a coordinate is expected here, and not `nan`"]);
    let long = format!("1.2 0 1{}", "0".repeat(9_900));
    vtk("1.2 0 0", &long, &["test:7:1", "binary digits", "round"]);
    vtk("1.2 0 0", "1.2 0 1e99999", &["test:7:7", "out of range"]);
    vtk("CELL_TYPES 6\n12\n", "CELL_TYPES 6\n", &["the file ends here", "5 of 6 types"]);
    vtk("CELL_TYPES 6\n12\n12\n12\n12\n12\n12\n", "", &["there is no `CELL_TYPES`"]);
    vtk("CELL_TYPES 6", "CELLS 0 0\nCELL_TYPES 6", &["test:34:1", "`CELLS` for the second time"]);
    vtk("CELL_TYPES 6\n12\n", "CELL_TYPES 5\n", &["6 cells, but 5 types of cells"]);
    vtk("POINTS 21 double\n", "POINTS 22 double\n9 9 9\n", &["point 21 is a corner of no cell"]);
    vtk("POINTS 21", "POINTS 99999999999999999999", &["the number of points is too large"]);
    // The second cell inside out.
    vtk(
        "8 0 3 4 5 7 10 11 12",
        "8 7 10 11 12 0 3 4 5",
        &["test:29:1", "on the same side of their face", "the other place", "exchange its bottom"],
    );
    refused("", SolidFormat::Vtk, &["this is no VTK file"]);
    refused("\u{feff}  é\u{2003}", SolidFormat::Vtk, &["this is no VTK file"]);
    refused("# vtk DataFile Version 3.0\n", SolidFormat::Vtk, &["`ASCII` is expected"]);
    refused(&VTK[..VTK.len() / 2], SolidFormat::Vtk, &["the file ends here"]);
}

#[test]
fn bad_medit() {
    let medit = |from: &str, to: &str, parts: &[&str]| {
        assert!(MEDIT.contains(from), "{from}");
        refused(&MEDIT.replacen(from, to, 1), SolidFormat::Medit, parts);
    };
    medit("Dimension 3", "Dimension 2", &["points of dimension 2; 3 is needed"]);
    medit("MeshVersionFormatted", "solid", &["`MeshVersionFormatted` is expected here"]);
    medit("Hexahedra\n10", "Tetrahedra\n10", &["10 cells under `Tetrahedra`", "hexahedra"]);
    medit("Hexahedra\n10", "HexahedraQ2\n10", &["10 curved cells", "as `Hexahedra`"]);
    medit("\n36\n", "\n37\n", &["and not `Hexahedra`", "36 of 37 vertices"]);
    medit("\n36\n", "\n35\n", &["a keyword is expected here", "count"]);
    medit("0 0 0 0\n", "0 0 0\n", &["the reference of a vertex is expected here", "0 where"]);
    medit("Hexahedra\n10\n1 ", "Hexahedra\n10\n0 ", &["points are counted from 1"]);
    medit("Hexahedra\n10\n1 ", "Hexahedra\n10\n37 ", &["point 37 does not exist", "36 points"]);
    medit(
        "Hexahedra\n10\n",
        "Hexahedra\n11\n",
        &["no natural number", "10 of 11 hexahedra have been read so far"],
    );
    medit("\nHexahedra", "\nVertices", &["`Vertices` for the second time"]);
    let cut = MEDIT.find("Hexahedra").expect("cells");
    refused(&MEDIT[..cut], SolidFormat::Medit, &["there is no `Hexahedra`"]);
    refused(&MEDIT[..cut + 40], SolidFormat::Medit, &["the file ends here", "of 10 hexahedra"]);
}
