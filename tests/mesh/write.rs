//! Meshes as text.

use super::{grid, mesh, tetrahedron};
use subcert::mesh::{
    BeyondF64, LimitPoint, MeshScheme, NoNormal, PolygonMesh, limit_points, to_json, to_obj, to_ply,
};

#[test]
fn json_is_json_and_exact() {
    let limits = limit_points(&tetrahedron(), MeshScheme::Loop).expect("small");
    let text = to_json(&tetrahedron(), &[("level", "0".to_owned())], Some(&limits));
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["points"][0]["exact"], serde_json::json!(["1", "1", "1"]));
    assert_eq!(json["points"][0]["f64"], serde_json::json!(["1.0", "1.0", "1.0"]));
    assert_eq!(json["faces"][0], serde_json::json!([0, 1, 2]));
    assert_eq!(json["limits"][0]["position"]["exact"], serde_json::json!(["1/5", "1/5", "1/5"]));
    let unit = "0.5773502691896257";
    assert_eq!(json["limits"][0]["normal"]["unit_f64"], serde_json::json!([unit, unit, unit]));
}

#[test]
fn normals_stand_in_obj_where_all_vertices_have_one() {
    let loops = limit_points(&tetrahedron(), MeshScheme::Loop).expect("small");
    let text = to_obj(&tetrahedron(), "t", &loops).expect("finite");
    assert!(text.contains("\nvn 0.5773502691896257 "), "{text}");
    assert!(
        text.ends_with("f 1//1 2//2 3//3\nf 1//1 4//4 2//2\nf 1//1 3//3 4//4\nf 2//2 4//4 3//3\n")
    );
    let flat = grid(3, 3, false);
    let limits = limit_points(&flat, MeshScheme::CatmullClark).expect("small");
    let text = to_obj(&flat, "a\nb", &limits).expect("finite");
    assert!(text.starts_with("# a b\nv 0.0 0.0 ") && text.contains("\nf 1//1 "), "{text}");
    let part: Vec<_> = limits
        .into_iter()
        .map(|limit| limit.map(|one| LimitPoint { normal: Err(NoNormal::Corner), ..one }))
        .collect();
    let text = to_obj(&flat, "a", &part).expect("finite");
    assert!(
        text.contains("\n# no vn: ") && !text.contains("\nvn") && !text.contains("//"),
        "{text}"
    );
}

#[test]
fn numbers_beyond_f64_are_for_json_only() {
    let far = mesh(&[[0, 0, 0], [1, 0, 0], [0, 1, 0]], &[&[0, 1, 2]]);
    let huge = subcert::exact::RealCyclotomic::from(subcert::exact::Rational::power_of_ten(400));
    let mut points = far.points().to_vec();
    points[0][0] = huge;
    let far = PolygonMesh::new(points, far.faces().to_vec()).expect("a surface");
    assert_eq!(to_obj(&far, "far", &[]), Err(BeyondF64));
    assert_eq!(to_ply(&far, "far"), Err(BeyondF64));
    assert!(to_json(&far, &[], None).contains("\"1000000"));
}
