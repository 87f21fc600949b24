//! Mesh files: numbers as they are written, and errors at their place.

use super::{file, number};
use proptest::prelude::*;
use std::path::Path;
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::mesh::{MeshFormat, PolygonMesh, read_mesh, to_obj, to_off, to_ply, to_stl};

fn read(format: MeshFormat, text: &str) -> PolygonMesh<Rational> {
    let file = read_mesh(&SourceText::new("mesh", text), format);
    file.unwrap_or_else(|error| panic!("{error}")).mesh().clone()
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn the_three_forms_agree() {
    let obj = read(MeshFormat::Obj, &format!("{TRIANGLE}v 1 1 0.5\nf 1//1 2 4//4 -2\n"));
    let off = read(
        MeshFormat::Off,
        "OFF # points\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 .5\n4 0 1 3 2 255 0 0\n",
    );
    let ply = "ply\nformat ascii 1.0\ncomment a\nelement vertex 4\nproperty float nx\nproperty float x\n\
               property float y\nproperty float z\nelement face 1\nproperty uchar red\n\
               property list uchar int vertex_index\nend_header\n\
               9 0 0 0\n9 1 0 0\n9 0 1 0\n9 1 1 5e-1\n7 4 0 1 3 2\n";
    assert_eq!(obj, off);
    assert_eq!(obj, read(MeshFormat::Ply, ply));
    assert_eq!(
        obj,
        read(MeshFormat::Off, "4 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 1/2\r\n4 0 1 3 2\r\n")
    );
}

#[test]
fn decimals_are_exact() {
    let obj = "v 0.1 -.5 +5.\nv 1e-3 -2.50E+2 1/3\nv 0.30000000000000004 1e300 -0\nf 1 2 3\n";
    let mesh = file(obj);
    let written: Vec<String> =
        mesh.mesh().points().iter().flatten().map(Rational::to_string).collect();
    assert_eq!(written[..6], ["1/10", "-1/2", "5", "1/1000", "-250", "1/3"]);
    assert_eq!(written[6], "7500000000000001/25000000000000000");
    assert_eq!(written[7].len(), 301);
    assert_eq!(written[8], "0");
}

#[test]
fn forms_by_extension_or_by_content() {
    let of = |path: &str, text: &str| MeshFormat::of(Path::new(path), text);
    assert_eq!(of("a.OBJ", "ply\n"), MeshFormat::Obj);
    assert_eq!(of("a.off", "8 6 12\n"), MeshFormat::Off);
    assert_eq!(of("-", "ply\nformat ascii 1.0\n"), MeshFormat::Ply);
    assert_eq!(of("-", "# a comment\n\nCOFF\n"), MeshFormat::Off);
    assert_eq!(of("mesh", "v 0 0 0\n"), MeshFormat::Obj);
}

#[test]
fn lines_that_say_nothing_about_the_surface() {
    let text = format!(
        "\u{feff}mtllib a.mtl\no cube\n{TRIANGLE}vn 0 0 1\nvt 0 0\ng a b\ns off\nusemtl red\nf \\\n 1 2 \\\n3\n"
    );
    assert_eq!(file(&text).mesh().faces(), [[0, 1, 2]]);
    let colours = file("v 0 0 0 1 0 0\nv 1 0 0 1 .5 0 0\nv 0 1 0 1.0\nf 1 2 3");
    assert_eq!(colours.mesh().points().len(), 3);
    assert_eq!(colours.notes(), ["the colours of 2 points are dropped"]);
    // Lines of Windows are continued too.
    assert_eq!(file(&format!("{TRIANGLE}f 1 \\\r\n2 3\r\n")).mesh().faces(), [[0, 1, 2]]);
}

/// Texture coordinates are kept, and what is dropped is told.
#[test]
fn what_is_kept_and_what_is_dropped() {
    let square = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\nvn 0 0 1\n";
    let text = format!(
        "{square}vt 0 0\nvt 1/3 0\nvt 1 1\nf 2/1/1 3/2/1 4/3/1 5/1/1\nt corner 1/1/0 3 1.5\n"
    );
    let file = file(&text);
    assert_eq!(file.mesh().points().len(), 4);
    assert_eq!(file.mesh().tags().vertices().keys().copied().collect::<Vec<usize>>(), [2]);
    let texture = file.mesh().texture().expect("texture coordinates");
    assert_eq!(
        (texture.values[1][0].to_string(), &texture.faces[0][..]),
        ("1/3".to_owned(), &[0, 1, 2, 0][..])
    );
    let notes = file.notes().join("; ");
    assert!(notes.contains("2 points are vertices of no face"), "{notes}");
    assert!(
        notes.contains("point 1 (line 1)") && notes.contains("1 normals are dropped"),
        "{notes}"
    );
    let mesh = file.mesh().map(number);
    let next = subcert::mesh::refine_mesh(&mesh, subcert::mesh::MeshScheme::CatmullClark, 1)
        .expect("a small mesh");
    let texture = next.texture().expect("texture coordinates");
    // (0 + 1/3 + 1 + 0)/4, in the middle.
    assert_eq!(texture.values[texture.faces[0][2]][0].to_string(), "1/3");
    let written = to_obj(&next, "a", &[]).expect("small");
    let again = self::file(&written);
    assert_eq!(again.mesh().tags(), next.tags());
    assert_eq!(again.mesh().texture().expect("kept").faces, texture.faces);
    // No rule moves the two, and they come last.
    let isolated = [[9; 3], [7; 3]].map(|point| point.map(|x: i64| number(&Rational::from(x))));
    assert_eq!(next.isolated(), isolated);
    assert_eq!(again.mesh().map(number).isolated(), isolated);
    assert!(again.notes()[0].starts_with("2 points are vertices of no face and get no number"));
}

fn refused(format: MeshFormat, text: &str) -> (usize, String) {
    let source = SourceText::new("mesh", text);
    let error = read_mesh(&source, format).map(|_| ()).expect_err("refused");
    (error.line_and_column().0, error.to_string())
}

fn check(format: MeshFormat, text: &str, line: usize, part: &str) {
    let (found, message) = refused(format, text);
    assert!(message.contains(part), "no `{part}` in: {message}");
    assert_eq!(found, line, "{message}");
}

#[test]
fn errors_in_obj_files() {
    let check = |text: &str, line, part: &str| check(MeshFormat::Obj, text, line, part);
    let with = |rest: &str| format!("{TRIANGLE}{rest}");
    check("", 1, "there is no face");
    check("v 0 0\n", 1, "2 numbers; a point is written `v x y z`");
    check("v 0 0 nan\n", 1, "`nan` is not a number");
    check("v 0 0 1e999999\n", 1, "out of range");
    check("v 0 0 1/0\n", 1, "denominator 0");
    check("v 0 0 0 2\n", 1, "weight other than 1");
    check(&with("f 1 2\n"), 4, "a face of 2 vertices");
    check(&with("f 1 2 4\n"), 4, "there are 3 points; vertices are counted from 1");
    check(&with("f 1 2 0\n"), 4, "there is no point 0");
    check(&with("f 1 2 -4\n"), 4, "point -4 does not exist: there are 3 points before");
    check(&with("f 1 2 99999999999999999999999\n"), 4, "does not exist");
    check(&with("f 1 2 x\n"), 4, "`x` is no vertex");
    check(&with("f 1 2 2\n"), 4, "it has the vertex 2 twice");
    check(&with("v 5 5 5\nf 1 2 3\nf 1 2 4\n"), 6, "two faces run from vertex 1 to vertex 2");
    check(&with("v 5 5 5\nv 6 6 6\nf 1 2 3\nf 2 1 4\nf 1 2 5\n"), 8, "a third face at the edge");
    check(&with("v 5 5 5\nv 6 6 6\nf 1 2 3\nf 1 4 5\n"), 1, "not one disc or one fan");
    let tagged = |tag: &str| with(&format!("f 1 2 3\n{tag}\n"));
    for (tag, part) in [
        ("t crease 1/1/0 0 2", "pairs of vertices"),
        ("t crease 2/1/0 0 2", "`2/1/0` announces 3 values, and 2 follow"),
        ("t crease 2/1/0 0 2 -1", "the sharpness -1 is below 0"),
        ("t crease 2/1/0 0 3 1", "vertex 3 does not exist: there are 3"),
        ("t crease 2/2/0 0 1 1 2", "one sharpness for all"),
        ("t crease 2/1 0 1 x", "`x` is not a number"),
        ("t crease x 0 1 x", "how many"),
        ("t crease 99999999999999999999999/0/0", "how many"),
        (
            "t crease 18446744073709551615/1/0 1",
            "announces 18446744073709551616 values, and 1 follow",
        ),
        ("t", "without a name"),
        ("t corner 1/1/0 3 1", "vertex 3 does not exist: there are 3"),
        ("t hole 1/0/0 1", "face 1 does not exist: there are 1"),
        ("t interpolateboundary 1/0/0 3", "0 (none), 1 (edges and corners) or 2 (edges)"),
        ("t creasemethod 0/0/1 linear", "`normal` or `chaikin`"),
        ("t smoothtriangles 1/0/0 1", "`smoothtriangles` is not supported"),
    ] {
        check(&tagged(tag), 5, part);
    }
    check(&with("vt 0 0\nf 1/1 2/1 3/1\nv 1 1 1\nf 1 4 2\n"), 7, "without texture coordinates");
    check(&with("vt 0 0\nf 1/1 2/1 3/2\n"), 5, "texture coordinate 2 does not exist");
    check(&with("vt 0 0\nf 1/1 2/1 3\n"), 5, "some have none");
    check(&with("vt 0 0\nvt 0 0 0\nf 1/1 2/1 3/2\n"), 5, "more or fewer numbers");
    check(&with("vt\n"), 4, "0 numbers");
    check(&with("curv 0 1\n"), 4, "`curv` is no statement");
    check(&with("f 1 2 \\"), 4, "its last line is continued");
    check(&with("f 1 2 3 \\\n\n4\n"), 6, "`4` is no statement");
    check(&with("f 1 2 3 \\\r\n\r\nv 1 1 x\n"), 6, "`x` is not a number");
    check("v 0 0 0 x y z\n", 1, "`x` is not a number");
    check("v 0 0 0 1 0 nan\n", 1, "`nan` is not a number");
    check("v 0 0 0 .5 1 0 0\n", 1, "weight other than 1");
    let digits = "7".repeat(2_000);
    check(&format!("v 0 0 {digits}\n"), 1, "4096 binary digits");
}

#[test]
fn errors_in_off_files() {
    let check = |text: &str, line, part: &str| check(MeshFormat::Off, text, line, part);
    check("", 1, "the numbers of points and faces are missing");
    check("OFF\n3\n", 2, "the numbers of points, faces and edges are expected");
    check("OFF\n-3 1 0\n", 2, "the number of points is no natural number");
    check("OFF\n99999999999999999999 1 0\n", 2, "the number of points is too large");
    check("OFF BINARY\n", 1, "a binary OFF file");
    check("4OFF\n", 1, "`4OFF` is not supported");
    check("OFF\n1000000000 1 0\n0 0 0\n", 3, "1 of 1000000000 points have been read");
    check("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 6, "1 of 2 faces have been read");
    check("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 4, "2 coordinates");
    check(
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n",
        6,
        "a face of 4 vertices, of which 3 are here",
    );
    check(
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
        6,
        "there are 3 points; vertices are counted from 0",
    );
    check(
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n",
        7,
        "a line after 3 points and 1 faces",
    );
    check(
        "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n18446744073709551615 0 1 2\n",
        6,
        "a face of 18446744073709551615",
    );
}

#[test]
fn errors_in_ply_files() {
    let check = |text: &str, line, part: &str| check(MeshFormat::Ply, text, line, part);
    let header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n\
                  property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    check("plx\n", 1, "begins with the line `ply`");
    check("ply\nformat binary_little_endian 1.0\n", 2, "`end_header` is missing");
    check("ply\nformat binary_big_endian 1.0\nend_header\n", 1, "is read from its bytes");
    check("ply\nelement vertex 1\nproperty real x\n", 3, "`real` is no type of numbers");
    check("ply\nproperty float x\n", 2, "a property before the first element");
    check("ply\nelement vertex 1\nelement vertex 1\n", 3, "`vertex` is there twice");
    check("ply\nformat ascii 1.0\n", 2, "`end_header` is missing");
    check("ply\nformat ascii 1.0\nformat ascii 1.0\n", 3, "the format is there twice");
    check("ply\nnonsense\n", 2, "no line of a PLY header");
    check(&format!("{header}0 0 0\n"), 10, "1 of 3 lines of `vertex` have been read");
    check(&format!("{header}{points}3 0 1\n"), 13, "a face of 3 vertices, of which 2 are here");
    check(&format!("{header}{points}3 0 1 9\n"), 13, "point 9 does not exist");
    check(&format!("{header}{points}3 0 1 2\n4\n"), 14, "after the last one");
    check(&format!("{header}0 0 0\n1 0\n"), 11, "this point has no `z`");
    let without = header.replace("property double z\n", "");
    check(&format!("{without}{points}"), 9, "no property `z`");
    let without = header.replace("vertex_indices", "other");
    check(&format!("{without}{points}3 0 1 2\n"), 12 + 1, "no list `vertex_indices`");
}

proptest! {
    /// Whatever a file holds: a mesh or an error, never a panic.
    #[test]
    fn nonsense(text in "[ \\n0-9vfplyOF/#.e\\\\-]{0,80}", head in 0_usize..4) {
        let head = ["", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "OFF\n", "ply\nformat ascii 1.0\n"][head];
        let source = SourceText::new("mesh", format!("{head}{text}"));
        for format in [MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply] {
            if let Err(error) = read_mesh(&source, format) {
                prop_assert!(!error.to_string().is_empty());
            }
        }
    }

    /// What is written is read back, where it is in f64.
    #[test]
    fn written_meshes_are_read_back(values in prop::collection::vec(-1e6_f64..1e6, 9)) {
        let exact = |x: &f64| subcert::float::exact(*x).expect("finite");
        let points = values.chunks(3).map(|p| [exact(&p[0]), exact(&p[1]), exact(&p[2])]);
        let mesh = PolygonMesh::new(points.collect(), vec![vec![0, 1, 2]]).expect("a surface");
        let obj = to_obj(&mesh.map(number), "a", &[]).expect("finite");
        let ply = to_ply(&mesh.map(number), "a").expect("finite");
        let off = to_off(&mesh.map(number), "a\nb").expect("finite");
        let stl = to_stl(&mesh.map(number), "facet normal\nb").expect("finite");
        for (format, text) in
            [(MeshFormat::Obj, obj), (MeshFormat::Ply, ply), (MeshFormat::Off, off), (MeshFormat::Stl, stl)]
        {
            // A shortest decimal is another number, with the same nearest f64.
            let found = read(format, &text);
            let near = |mesh: &PolygonMesh<Rational>| -> Vec<f64> {
                mesh.points().iter().flatten().map(subcert::float::nearest).collect()
            };
            prop_assert_eq!(near(&found), near(&mesh));
        }
    }
}

/// What a file says twice, or otherwise than its counts say, is refused.
#[test]
fn contradictions() {
    let ply = |properties: &str, row: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n{properties}\nend_header\n0 0 0 5\n1 0 0 5\n0 1 0 5\n{row}\n"
        )
    };
    let face = "element face 1\nproperty list uchar int vertex_indices";
    check(MeshFormat::Ply, &ply(&format!("property float x\n{face}"), "3 0 1 2"), 7, "twice");
    let lists = format!("{face}\nproperty list uchar int vertex_index");
    check(MeshFormat::Ply, &ply(&lists, "3 0 1 2 3 0 2 1"), 9, "twice");
    let vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 5\n3 0 1 2\n";
    check(MeshFormat::Vtk, vtk, 8, "which have 4 numbers and not 5");
    let usd = "#usda 1.0\ndef Mesh \"m\" {\npoint3f[] points = [(0,0,0)]\npoint3f[] points = [(1,0,0)]\n}\n";
    check(MeshFormat::Usda, usd, 4, "for the second time");
    let off = SourceText::new("mesh", "OFF\n3 1 0\n0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n");
    let read = read_mesh(&off, MeshFormat::Off).expect("a mesh");
    assert!(read.notes()[0].contains("behind x, y and z"));
}
