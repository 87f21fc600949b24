//! USD, binary PLY, STL and VTK polygons: the same mesh in all of them, and files that are cut off or changed.

use super::{file, number};
use proptest::prelude::*;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use subcert::diagnostic::{Diagnostic, SourceText};
use subcert::exact::Rational;
use subcert::mesh::{
    Boundary, MeshFile, MeshFormat, MeshScheme, PolygonMesh, read_binary_mesh, read_mesh,
    refine_mesh, to_obj, to_usda,
};

const POINTS: [[f32; 3]; 4] =
    [[1.0, 1.0, 1.0], [1.0, -1.0, -0.125], [-1.0, 1.0, -1.0], [-1.0, -1.0, 0.1]];
const FACES: [[i32; 3]; 4] = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];

fn read(format: MeshFormat, text: &str) -> Result<MeshFile, Diagnostic> {
    read_mesh(&SourceText::new("mesh", text), format)
}

fn exact(point: &[f32; 3]) -> [Rational; 3] {
    point.map(|x| subcert::float::exact(f64::from(x)).expect("finite"))
}

fn expected() -> PolygonMesh<Rational> {
    let faces = FACES.map(|face| face.map(|v| usize::try_from(v).expect("a vertex")).to_vec());
    PolygonMesh::new(POINTS.iter().map(exact).collect(), faces.to_vec()).expect("a surface")
}

/// A binary PLY file, with properties that are passed over before and after.
fn ply(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut bytes = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 4\nproperty uchar red\nproperty float x\n\
         property float y\nproperty double z\nelement face 4\nproperty list short float weights\n\
         property list uchar int vertex_indices\nproperty ushort flags\nend_header\n"
    )
    .into_bytes();
    let mut put = |mut number: Vec<u8>| {
        if big {
            number.reverse();
        }
        bytes.extend(number);
    };
    for [x, y, z] in POINTS {
        put(vec![7]);
        put(x.to_le_bytes().to_vec());
        put(y.to_le_bytes().to_vec());
        put(f64::from(z).to_le_bytes().to_vec());
    }
    for face in FACES {
        put(1_i16.to_le_bytes().to_vec());
        put(f32::NAN.to_le_bytes().to_vec());
        put(vec![3]);
        for v in face {
            put(v.to_le_bytes().to_vec());
        }
        put(9_u16.to_le_bytes().to_vec());
    }
    bytes
}

/// The bytes of an integer of this type.
fn integer(kind: &str, value: i64, big: bool) -> Vec<u8> {
    let size = match kind {
        "char" | "uchar" => 1,
        "short" | "ushort" => 2,
        _ => 4,
    };
    let mut bytes = value.to_le_bytes()[..size].to_vec();
    if big {
        bytes.reverse();
    }
    bytes
}

/// Strips over the four points, with the lengths as given, and a byte before each; in both orders of bytes, and as text.
fn strips(types: [&str; 2], element: &str, lists: &[(i64, &[i64])]) -> [Vec<u8>; 3] {
    ["binary_little_endian", "binary_big_endian", "ascii"].map(|form| {
        let big = form == "binary_big_endian";
        let [length, index] = types;
        let head = format!(
            "ply\nformat {form} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             element {element} {}\nproperty uchar tag\nproperty list {length} {index} vertex_indices\nend_header\n",
            lists.len()
        );
        let mut bytes = head.into_bytes();
        for [x, y, z] in POINTS {
            if form == "ascii" {
                bytes.extend(format!("{:.27} {:.27} {:.27}\n", f64::from(x), f64::from(y), f64::from(z)).into_bytes());
            } else {
                let float = |x: f32| if big { x.to_be_bytes() } else { x.to_le_bytes() };
                bytes.extend([x, y, z].map(float).concat());
            }
        }
        for (count, list) in lists {
            if form == "ascii" {
                let list = list.iter().map(i64::to_string).collect::<Vec<_>>().join(" ");
                bytes.extend(format!("9 {count} {list}\n").into_bytes());
            } else {
                bytes.push(9);
                bytes.extend(integer(length, *count, big));
                list.iter().for_each(|index_| bytes.extend(integer(index, *index_, big)));
            }
        }
        bytes
    })
}

fn bytes_or_text(bytes: &[u8]) -> Result<MeshFile, Diagnostic> {
    match read_binary_mesh("a.ply", bytes, None) {
        Some(file) => file,
        None => read(MeshFormat::Ply, &String::from_utf8_lossy(bytes)),
    }
}

/// -1 ends a strip, and the next one begins with a triangle that is not turned: by hand, four triangles of a tetrahedron.
#[test]
fn strips_of_triangles_in_bytes_are_those_of_the_text() {
    let faces = [[0, 1, 2], [2, 1, 3], [3, 1, 0], [2, 3, 0]].map(|face: [usize; 3]| face.to_vec());
    let expected = PolygonMesh::new(POINTS.iter().map(exact).collect(), faces.to_vec());
    let expected = expected.expect("a surface");
    let list: &[i64] = &[0, 1, 2, -1, 2, 1, 3, 0];
    for length in ["uchar", "char", "ushort", "short", "uint", "int"] {
        for index in ["char", "short", "int"] {
            let lists = [(8, list), (5, &[-1, 2, 3, 0, -1])];
            for bytes in strips([length, index], "tristrips", &lists) {
                let file = bytes_or_text(&bytes).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(*file.mesh(), expected, "{length} {index}");
            }
        }
    }
    // A reader that passed over -1 would not see this mesh.
    for bytes in
        strips(["int", "int"], "tristrips", &[(7, &[0, 1, 2, 2, 1, 3, 0]), (3, &[2, 3, 0])])
    {
        assert!(
            bytes_or_text(&bytes)
                .is_err_and(|error| error.to_string().contains("orientations differ"))
        );
    }
}

#[test]
fn strips_that_are_cut_off_or_lie_are_refused() {
    let list: &[i64] = &[0, 1, 2, 3, -1, 2, 3, 0, 1];
    let [little, big, text] = strips(["uint", "int"], "tristrips", &[(9, list)]);
    for whole in [&little, &big] {
        let end = b"end_header\n";
        let start = whole.windows(end.len()).position(|part| part == end).expect("a header");
        for length in start + end.len()..whole.len() {
            let error = bytes_or_text(&whole[..length]).map(|_| ()).expect_err("cut off");
            assert!(
                error.to_string().contains("missing") || error.to_string().contains("ends before")
            );
        }
        assert_eq!(survives(MeshFormat::Ply, whole), Ok(true));
    }
    assert_eq!(bytes_or_text(&little).unwrap().mesh(), bytes_or_text(&text).unwrap().mesh());
    let refused = |types, element, lists: &[(i64, &[i64])], parts: [&str; 3]| {
        for (bytes, part) in strips(types, element, lists).iter().zip(parts) {
            let error = bytes_or_text(bytes).map(|_| ()).expect_err(part).to_string();
            assert!(error.contains(part), "{part}: {error}");
        }
    };
    let most = i64::from(u32::MAX);
    let many = "has 4294967295 numbers, and the file ends before them";
    refused(
        ["uint", "int"],
        "tristrips",
        &[(most, list)],
        [many, many, "a face of 4294967295 vertices"],
    );
    // -1 is no number of vertices, nor -2 a vertex, nor 2^32 - 1, nor -1 of a face.
    let missing = "`vertex_indices` is missing, or no number of its type";
    refused(["int", "int"], "tristrips", &[(-1, list)], [missing, missing, "-1"]);
    refused(["int", "int"], "tristrips", &[(4, &[0, 1, 2, -2])], [missing, missing, "-2"]);
    refused(["int", "uint"], "tristrips", &[(4, &[0, 1, 2, most])], ["4294967295"; 3]);
    refused(["int", "int"], "face", &[(4, &[0, 1, 2, -1])], [missing, missing, "-1"]);
    // The header tells of 2^32 - 1 strips, and one is there.
    for bytes in [little, big] {
        let head = b"element tristrips 1\n";
        let at = bytes.windows(head.len()).position(|part| part == head).expect("the header");
        let mut long = bytes[..at].to_vec();
        long.extend(format!("element tristrips {most}\n").into_bytes());
        long.extend(&bytes[at + head.len()..]);
        let error = bytes_or_text(&long).map(|_| ()).expect_err("one strip").to_string();
        assert!(error.contains("is missing"), "{error}");
    }
}

fn stl() -> Vec<u8> {
    let mut bytes = vec![b's'; 80];
    bytes.extend(4_u32.to_le_bytes());
    for face in FACES {
        bytes.extend([0; 12]);
        for v in face {
            let point = POINTS[usize::try_from(v).expect("a vertex")];
            for x in point {
                bytes.extend(x.to_le_bytes());
            }
        }
        bytes.extend([0; 2]);
    }
    bytes
}

fn ascii_stl() -> String {
    let mut text = "solid a tetrahedron\n".to_owned();
    for face in FACES {
        text.push_str("facet normal 0 0 1\n outer loop\n");
        for v in face {
            let [x, y, z] = exact(&POINTS[usize::try_from(v).expect("a vertex")]);
            let _ = writeln!(text, "  vertex {x} {y} {z}");
        }
        text.push_str(" endloop\nendfacet\n");
    }
    text + "endsolid\n"
}

fn vtk() -> String {
    let point = |p: &[f32; 3]| exact(p).map(|x| x.to_string()).join(" ");
    let points: Vec<String> = POINTS.iter().map(point).collect();
    let faces: Vec<String> = FACES.iter().map(|[a, b, c]| format!("3 {a} {b} {c}")).collect();
    format!(
        "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n{}\nPOLYGONS 4 16\n{}\n",
        points.join("\n"),
        faces.join("\n")
    )
}

const USDA: &str = r#"#usda 1.0
( defaultPrim = "a" upAxis = "Y" )
def Xform "a" ( kind = "component" ) {
    double3 xformOp:translate = (1, 2, 3)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def Mesh "cube" {
        uniform bool doubleSided = 1
        float3[] extent = [(-1, -1, -1), (1, 1, 1)]
        int[] faceVertexCounts = [4, 4, 4, 4, 4, 4]
        int[] faceVertexIndices = [0, 1, 3, 2, 2, 3, 5, 4, 4, 5, 7, 6, 6, 7, 1, 0, 1, 7, 5, 3, 6, 0, 2, 4]
        point3f[] points = [(-1, -1, 1), (1, -1, 1), (-1, 1, 1), (1, 1, 1), (-1, 1, -1), (1, 1, -1), (-1, -1, -1), (1, -1, -0.1)]
        int[] creaseIndices = [0, 1, 3, 2, 0, 4, 5]
        int[] creaseLengths = [5, 2]
        float[] creaseSharpnesses = [2.5, 10]
        int[] cornerIndices = [7]
        float[] cornerSharpnesses = [1.25]
        int[] holeIndices = [5]
        normal3f[] normals = [(0, 0, 1)] ( interpolation = "constant" )
        uniform token interpolateBoundary = "edgeOnly" # a comment
        uniform token subdivisionScheme = "catmullClark"
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 0.1)] (
            interpolation = "faceVarying"
        )
        int[] primvars:st:indices = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]
        rel material:binding = </a/b>
    }
}
"#;

#[test]
fn all_forms_hold_the_same_mesh() {
    for big in [false, true] {
        let file = read_binary_mesh("a.ply", &ply(big), None).expect("binary").expect("a mesh");
        assert_eq!(*file.mesh(), expected());
    }
    for file in [
        read_binary_mesh("a.stl", &stl(), None).expect("binary"),
        read(MeshFormat::Stl, &ascii_stl()),
    ] {
        let file = file.expect("a mesh");
        assert_eq!(*file.mesh(), expected());
        assert!(file.notes()[0].starts_with("12 vertices of triangles are at 4 different points"));
    }
    assert_eq!(*read(MeshFormat::Vtk, &vtk()).expect("a mesh").mesh(), expected());
    assert_eq!(subcert::mesh::MeshFormat::of(std::path::Path::new("-"), &vtk()), MeshFormat::Vtk);
}

/// The word stands in a comment, and lines end in three ways; a line feed after a \r is then a number.
#[test]
fn where_a_binary_header_ends() {
    let whole = ply(false);
    let marker = b"end_header\n";
    let at = whole.windows(marker.len()).position(|part| part == marker).expect("a header");
    let (head, rest) = whole.split_at(at + marker.len());
    let head = String::from_utf8(head.to_vec()).expect("a text");
    let noted =
        head.replace("element vertex", "comment end_header\nobj_info end_header\nelement vertex");
    for head in [noted.clone(), noted.replace('\n', "\r\n"), noted.replace('\n', "\r")] {
        for first in [7, b'\n'] {
            let bytes = [head.as_bytes(), &[first], &rest[1..]].concat();
            let file = read_binary_mesh("a.ply", &bytes, None).expect("binary").expect("a mesh");
            assert_eq!(*file.mesh(), expected());
        }
    }
    // These words stand in comments alone, and the file is a text.
    let text = b"ply\ncomment format binary_little_endian 1.0\nend_header\n";
    assert!(read_binary_mesh("a.ply", text, None).is_none());
}

/// Sections in small letters, an array with the name of one, and offsets that leave no corner out.
#[test]
fn sections_and_offsets_of_vtk() {
    let listed = vtk();
    let at = listed.find("POLYGONS").expect("faces");
    let offsets = "polygons 5 12\nOffsets vtktypeint64\n0 3 6 9 12\nconnectivity vtktypeint64\n0 1 2 0 3 1 0 2 3 1 3 2\n";
    let field = "field f 2\npolygons 1 2 int\n1 2\nlines 1 1 int\n7\nmetadata\ninformation 0\n\n";
    let text = format!("{}{field}{offsets}cell_data 4\n", listed[..at].replace("POINTS", "points"));
    let file = read(MeshFormat::Vtk, &text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(*file.mesh(), expected());
    let old = text.replace('\n', "\r");
    assert_eq!(*read(MeshFormat::Vtk, &old).expect("old line ends").mesh(), expected());
    for (from, to, part) in [
        ("\n0 3 6", "\n1 3 6", "the first offset is 1, and it must be 0"),
        ("9 12\n", "9 11\n", "the last offset is 11, and it must be 12"),
        ("9 12\n", "9 13\n", "the last offset is 13, and it must be 12"),
        (
            "polygons 5 12\nOffsets vtktypeint64\n0 3 6 9 12",
            "polygons 0 12\nOffsets vtktypeint64",
            "the last offset is 0",
        ),
        ("0 3 6", "0 6 3", "the offsets must rise"),
        ("9 12\n", "9 18446744073709551615\n", "the last offset is 18446744073709551615"),
    ] {
        assert!(text.contains(from), "{from}");
        let error = read(MeshFormat::Vtk, &text.replace(from, to)).map(|_| ()).expect_err(part);
        assert!(error.to_string().contains(part), "no `{part}` in {error}");
    }
}

/// Faces with curved edges are not passed over, as faces with straight ones are not.
#[test]
fn curved_faces_of_medit() {
    let text = "MeshVersionFormatted 2 Dimension 3 Vertices 3 0 0 0 0 1 0 0 0 0 1 0 0\nTriangles 1 1 2 3 0\n";
    let with = |more: &str| read(MeshFormat::Medit, &format!("{text}{more}\nEnd\n"));
    for kind in
        ["TrianglesP2", "quadrilateralsq3", "TETRAHEDRAP2", "HexahedraQ4", "PrismsP2", "PyramidsP2"]
    {
        let error = with(&format!("{kind} 2 1 2 3 1 2 3 0")).map(|_| ()).expect_err(kind);
        let linear = format!("as `{}`", &kind[..kind.len() - 2]);
        assert!(error.to_string().contains(&format!("2 curved cells under `{kind}`")), "{error}");
        assert!(error.help.is_some_and(|help| help.contains(&linear)));
        assert!(with(&format!("{kind} 0")).is_ok());
    }
    assert!(with("InnerPolygonHeaders 1 1 0").is_err());
    assert!(with("EdgesP2 1 1 2 3 0\nTrianglesP2Ordering 1 1").is_ok());
}

#[test]
fn fields_of_usd() {
    let file = read(MeshFormat::Usda, USDA).unwrap_or_else(|error| panic!("{error}"));
    let (mesh, tags) = (file.mesh(), file.mesh().tags());
    assert_eq!(mesh.points()[7][2].to_string(), "-1/10");
    assert_eq!(tags.boundary, Boundary::Edge);
    let sharps: Vec<String> = tags.edges().values().map(ToString::to_string).collect();
    assert_eq!(sharps.iter().filter(|s| *s == "5/2").count(), 4);
    assert_eq!(sharps.iter().filter(|s| *s == "10").count(), 1);
    assert_eq!(tags.vertices()[&7].to_string(), "5/4");
    assert!(tags.holes(mesh.connectivity()).contains(&5));
    assert_eq!(mesh.texture().expect("st").values[3][1].to_string(), "1/10");
    let notes = file.notes().join("; ");
    assert!(notes.contains("xformOp") && notes.contains("material:binding, normals"), "{notes}");
    let turned =
        USDA.replace("uniform bool doubleSided = 1", "uniform token orientation = \"leftHanded\"");
    let turned = read(MeshFormat::Usda, &turned).expect("a mesh");
    assert_eq!(turned.mesh().faces()[0], [0, 2, 3, 1]);
    // Without a word, OpenUSD has edgeAndCorner.
    let plain = USDA.replace("uniform token interpolateBoundary", "uniform token other");
    assert_eq!(
        read(MeshFormat::Usda, &plain).expect("a mesh").mesh().tags().boundary,
        Boundary::Corner
    );
}

/// What is written is read again with the same creases, one level lower, and so is OBJ.
#[test]
fn creases_are_written_one_level_lower() {
    let control = read(MeshFormat::Usda, USDA).expect("a mesh").mesh().map(number);
    let next = refine_mesh(&control, MeshScheme::CatmullClark, 1).expect("small");
    let usda = to_usda(&next, MeshScheme::CatmullClark, "cube").expect("small");
    let usda = read(MeshFormat::Usda, &usda).unwrap_or_else(|error| panic!("{error}"));
    let obj = file(&to_obj(&next, "cube", &[]).expect("small"));
    for again in [usda, obj] {
        assert_eq!(again.mesh().tags(), next.tags());
        assert_eq!(again.mesh().faces(), next.faces());
        assert_eq!(again.mesh().texture().expect("st").faces, next.texture().expect("st").faces);
        assert!(again.notes().is_empty(), "{:?}", again.notes());
    }
    assert_eq!(next.tags().edges().values().filter(|s| s.to_string() == "3/2").count(), 8);
    assert_eq!(next.tags().vertices()[&7].to_string(), "1/4");
}

#[test]
fn errors_in_usd_files() {
    for (from, to, line, part) in [
        ("#usda 1.0", "PXR-USDC", 1, "begins with `#usda 1.0`"),
        ("(1, -1, 1)", "(1, -1)", 11, "a list of tuples of 3"),
        ("(1, -1, 1)", "(1, -1, x)", 11, "`x` is not a number"),
        ("[4, 4, 4, 4, 4, 4]", "[4, 4, 4, 4, 4]", 10, "`faceVertexCounts` has the sum 20"),
        ("[5, 2]", "[5, 3]", 13, "the lengths have the sum"),
        ("[2.5, 10]", "[2.5]", 14, "a sharpness for each crease"),
        ("[2.5, 10]", "[2.5, -1]", 14, "a sharpness below 0"),
        (
            "[0, 1, 3, 2, 0, 4, 5]",
            "[0, 1, 3, 2, 0, 4, 0]",
            12,
            "no edge between the vertices 4 and 0",
        ),
        ("cornerIndices = [7]", "cornerIndices = [8]", 15, "vertex 8 does not exist"),
        ("[1.25]", "[]", 16, "a sharpness for each of `cornerIndices`"),
        ("holeIndices = [5]", "holeIndices = [6]", 17, "face 6 does not exist"),
        ("\"edgeOnly\"", "\"edges\"", 19, "`edges` is no rule at the boundary"),
        ("def Mesh \"cube\"", "def Cube \"cube\"", 1, "there is no `def Mesh`"),
        ("\"faceVarying\"", "\"uniform\"", 21, "interpolation = "),
        (
            "points = [",
            "points.timeSamples = {0: [(1, 1, 1)]}\n point3f[] other = [",
            11,
            "changes with time",
        ),
    ] {
        assert!(USDA.contains(from), "{from}");
        let error = read(MeshFormat::Usda, &USDA.replace(from, to)).map(|_| ()).expect_err(from);
        assert!(error.to_string().contains(part), "no `{part}` in {error}");
        assert_eq!(error.line_and_column().0, line, "{error}");
    }
    let twice = USDA.to_owned() + &USDA[USDA.find("def Xform").expect("a prim")..];
    assert!(read(MeshFormat::Usda, &twice).expect_err("two").to_string().contains("a second mesh"));
    let deep = "#usda 1.0\n".to_owned() + &"def Xform \"a\" {\n".repeat(100_000);
    assert!(read(MeshFormat::Usda, &deep).expect_err("deep").to_string().contains("nested deeper"));
}

#[test]
fn what_follows_a_surface_in_a_file() {
    let named = ascii_stl().replace("endsolid", "endsolid a tetrahedron\r\n\n ");
    assert!(read(MeshFormat::Stl, &named).is_ok());
    assert!(read(MeshFormat::Stl, &format!("{named}\nsolid b\nendsolid b\n")).is_ok());
    let second = format!("{named}\nfacet normal 0 0 1\n");
    let points = "POINTS 1 float\n9 9 9\nPOLYGONS";
    let one =
        "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet";
    // A name may be what a triangle begins with, and a triangle may stand in the line of the name.
    let other = one.replace("0 0 0", "0 0 7").replace("1 0 0", "1 0 7").replace("0 1 0", "0 1 7");
    for (text, faces) in [
        (format!("solid a {one} endsolid a"), 1),
        (format!("solid facet normal\n{one}\nendsolid facet normal 1 2 3\n"), 1),
        (format!("solid {}\nendsolid", one.replace("outer", "\nouter")), 1),
        (format!("solid {}\nendsolid", one.replace("normal", "\nnormal")), 1),
        (format!("solid a {one}\nendsolid\nsolid b {other}\nendsolid"), 2),
    ] {
        let found = read(MeshFormat::Stl, &text).map(|file| file.mesh().faces().len());
        assert_eq!(found.ok(), Some(faces), "{text}");
    }
    let twice = "CELL_TYPES 0 CELL_TYPES 0";
    for (format, text, part) in [
        (MeshFormat::Stl, second, "more after the end of the solid"),
        (MeshFormat::Stl, format!("solid\n{one}\nendsolid {one}\n"), "in the line of `endsolid`"),
        (MeshFormat::Vtk, vtk().replace("POLYGONS", points), "`POINTS` for the second time"),
        (
            MeshFormat::Vtk,
            vtk().replace("POLYGONS", "POLYGONS 0 0 polygons"),
            "`polygons` for the second time",
        ),
        (
            MeshFormat::Vtk,
            vtk().replace("POLYDATA", &format!("UNSTRUCTURED_GRID {twice}")),
            "`CELL_TYPES` for the second time",
        ),
    ] {
        let error = read(format, &text).map(|_| ()).expect_err(part);
        assert!(error.to_string().contains(part) && error.help.is_some(), "{error}");
    }
}

/// Bytes of every form, as files.
fn all() -> Vec<(MeshFormat, Vec<u8>)> {
    vec![
        (MeshFormat::Ply, ply(false)),
        (MeshFormat::Ply, ply(true)),
        (MeshFormat::Stl, stl()),
        (MeshFormat::Stl, ascii_stl().into_bytes()),
        (MeshFormat::Vtk, vtk().into_bytes()),
        (MeshFormat::Usda, USDA.as_bytes().to_vec()),
        (
            MeshFormat::Obj,
            format!("{}vt 0 1\nf 1/1 2/1 3/1\nt crease 2/1/0 0 1 2.5\n", "v 1 0 1\n".repeat(3))
                .into_bytes(),
        ),
    ]
}

/// The file is read, or refused with a message; it does not panic.
fn survives(format: MeshFormat, bytes: &[u8]) -> Result<bool, String> {
    let read = || match read_binary_mesh("a", bytes, None) {
        Some(file) => file,
        None => read(format, &String::from_utf8_lossy(bytes)),
    };
    match catch_unwind(AssertUnwindSafe(read)) {
        Ok(Ok(_)) => Ok(true),
        Ok(Err(error)) if !error.to_string().is_empty() => Ok(false),
        _ => Err(format!("{format:?}: {:?}", String::from_utf8_lossy(bytes))),
    }
}

/// A file that is cut off is refused, wherever that is, but for blanks and words at its end that say nothing.
#[test]
fn files_that_are_cut_off() {
    for (format, bytes) in all() {
        assert_eq!(survives(format, &bytes), Ok(true), "{format:?}");
        let mut accepted = 0;
        for length in 0..bytes.len() {
            accepted +=
                usize::from(survives(format, &bytes[..length]).unwrap_or_else(|e| panic!("{e}")));
        }
        // OBJ has no end, and a number may lose its last digit.
        let most = match format {
            MeshFormat::Obj => 30,
            MeshFormat::Vtk | MeshFormat::Usda => 2,
            _ => 1,
        };
        assert!(accepted <= most, "{format:?}: {accepted}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(400))]

    #[test]
    fn files_that_are_changed(
        which in 0_usize..7,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0_u8..3), 1..6),
    ) {
        let (format, mut bytes) = all().swap_remove(which);
        for (place, byte, how) in changes {
            let at = place.index(bytes.len());
            match how {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, b"(){}[]\"'-0<,#\n"[usize::from(byte) % 14]),
                _ => drop(bytes.remove(at)),
            }
        }
        prop_assert!(survives(format, &bytes).is_ok());
    }
}
