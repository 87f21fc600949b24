//! The least level by the Hausdorff distance: certified, by dense samples, and by equal parameters.
//!
//! `cargo bench --bench hausdorff` writes the table of all cases, `cargo bench --bench hausdorff -- 3` that of case 3
//! alone.

#[path = "../tests/common/hausdorff.rs"]
mod hausdorff;
#[path = "../tests/common/hausdorff_cases.rs"]
mod hausdorff_cases;

use hausdorff::{Rule, distances};
use hausdorff_cases::{Case, cases};
use std::time::Instant;
use subcert::exact::Rational;
use subcert::mesh::{MeshScheme, PolygonMesh};
use subcert::patch::{FaceSurface, MeshDistances};

const LEVELS: u32 = 6;

fn main() {
    let chosen: Vec<usize> = std::env::args().filter_map(|word| word.parse().ok()).collect();
    println!("case, scheme, tolerance, dense, certified, parametric, seconds, parametric seconds");
    let (mut pairs, mut same, mut above) = (0, 0, 0);
    for (number, case) in cases().iter().enumerate() {
        if !chosen.is_empty() && !chosen.contains(&number) {
            continue;
        }
        for [pair, equal, beyond] in table(case) {
            (pairs, same, above) = (pairs + pair, same + equal, above + beyond);
        }
    }
    println!(
        "{pairs} pairs, {same} of them the same, {above} with the dense level above the certified"
    );
}

fn table(case: &Case) -> Vec<[u32; 3]> {
    let sampled = distances(&case.plain(), case.rule, LEVELS, case.dense, 4);
    println!("{}, {:?}: sampled distances {sampled:.6?}", case.name, case.rule);
    let scheme = match case.rule {
        Rule::CatmullClark => MeshScheme::CatmullClark,
        Rule::Bajaj => MeshScheme::Bajaj,
        Rule::DooSabin => MeshScheme::DooSabin,
        Rule::Loop => MeshScheme::Loop,
    };
    let points = case.points.iter().map(|point| point.map(Rational::from)).collect();
    let mesh = PolygonMesh::new(points, case.faces.clone()).expect("a surface");
    let distances = MeshDistances::new(mesh, scheme).expect("small").without_apart();
    let mut rows = Vec::new();
    for &(p, q) in &case.tolerances {
        let tolerance = Rational::new(p, q);
        let small = |x: i64| f64::from(i32::try_from(x).expect("small"));
        let wanted = small(p) / small(q);
        let dense = sampled.iter().position(|&x| x <= wanted);
        let start = Instant::now();
        let found = distances.geometric_depth(&tolerance, FaceSurface::Bilinear);
        let seconds = start.elapsed().as_secs_f64();
        let start = Instant::now();
        let parametric = distances.depth(&tolerance).map(|x| x.level).ok();
        let other = start.elapsed().as_secs_f64();
        let certified = match &found {
            Ok(found) => {
                format!("{:?} to {}", found.too_few.map(|x| x + 1), found.level.unwrap_or(u32::MAX))
            }
            Err(error) => error.to_string(),
        };
        let level = found.as_ref().ok().and_then(|x| x.level).map(|x| x as usize);
        let exact = found.as_ref().is_ok_and(|x| Some(x.too_few.map_or(0, |x| x + 1)) == x.level);
        println!(
            "{}, {:?}, {p}/{q}, {dense:?}, {certified}, {parametric:?}, {seconds:.2}, {other:.2}",
            case.name, case.rule
        );
        let is_above = dense.zip(level).is_some_and(|(dense, level)| dense > level);
        rows.push([1, u32::from(exact && dense == level), u32::from(is_above)]);
    }
    rows
}
