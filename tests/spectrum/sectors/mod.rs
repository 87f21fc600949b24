//! Sectors between sharp edges: the matrix of the rules, its characteristic polynomial and left eigenvectors, limits of meshes,
//! and many refinements.

mod algebra;
mod limits;

use crate::common::r;
use subcert::exact::{Rational, RealCyclotomic, RealExpression};
use subcert::spectrum::{MAX_SECTOR_FACES, Sector, SpectrumError};

type Row = Vec<Rational>;

/// Σ of multiples of rows.
fn mix(terms: &[(Rational, &Row)]) -> Row {
    let length = terms[0].1.len();
    let entry = |i: usize| terms.iter().fold(r(0, 1), |sum, (w, row)| &sum + &(w * &row[i]));
    (0..length).map(entry).collect()
}

/// The new points of a sector as combinations of the old ones, from the words of the rules: face points are means, edge points means of the
/// ends and the face points beside, or (3, 3, 1, 1)/8; sharp edges have midpoints.
fn matrix(scheme: &str, faces: usize, corner: bool) -> Vec<Row> {
    let quadrilaterals = scheme == "catmull-clark";
    let points = faces + 2 + if quadrilaterals { faces } else { 0 };
    let unit = |at: usize| -> Row { (0..points).map(|i| r(i64::from(i == at), 1)).collect() };
    let v = unit(0);
    let edge = |i: usize| unit(1 + i);
    let face = |i: usize| unit(2 + faces + i);
    let mean = |rows: &[&Row]| {
        let share = Rational::new(1, rows.len());
        mix(&rows.iter().map(|row| (share.clone(), *row)).collect::<Vec<_>>())
    };
    let face_point = |i: usize| mean(&[&v, &edge(i), &face(i), &edge(i + 1)]);
    let vertex = if corner {
        v.clone()
    } else {
        mix(&[(r(3, 4), &v), (r(1, 8), &edge(0)), (r(1, 8), &edge(faces))])
    };
    let mut rows = vec![vertex];
    for i in 0..=faces {
        rows.push(if i == 0 || i == faces {
            mean(&[&v, &edge(i)])
        } else if quadrilaterals {
            mean(&[&v, &edge(i), &face_point(i - 1), &face_point(i)])
        } else {
            let near = [(r(3, 8), &v), (r(3, 8), &edge(i))];
            let far = [(r(1, 8), &edge(i - 1)), (r(1, 8), &edge(i + 1))];
            mix(&near.into_iter().chain(far).collect::<Vec<_>>())
        });
    }
    if quadrilaterals {
        rows.extend((0..faces).map(face_point));
    }
    rows
}

fn sectors() -> impl Iterator<Item = (&'static str, usize, bool)> {
    let schemes = ["catmull-clark", "loop"];
    schemes.into_iter().flat_map(|scheme| {
        (1..=8).flat_map(move |faces| [false, true].map(|corner| (scheme, faces, corner)))
    })
}

fn sector(scheme: &str, faces: usize, corner: bool) -> Sector {
    Sector::of(scheme, faces, corner).unwrap_or_else(|error| panic!("{error}"))
}

fn expressions(weights: &[RealCyclotomic]) -> Vec<RealExpression> {
    weights.iter().map(|weight| RealExpression::from(weight.clone())).collect()
}

// Loop and Warren differ at smooth vertices alone; what is no such scheme is refused.
#[test]
fn names_and_numbers() {
    assert_eq!(sector("loop", 5, false), sector("loop-warren", 5, false));
    let error = |scheme: &str, faces| Sector::of(scheme, faces, false).expect_err("an error");
    assert!(matches!(error("doo-sabin", 3), SpectrumError::NoSectors { .. }));
    for faces in [0, MAX_SECTOR_FACES + 1, usize::MAX] {
        assert!(matches!(error("loop", faces), SpectrumError::Faces { .. }));
    }
    assert_eq!(sector("catmull-clark", MAX_SECTOR_FACES, true).limit.len(), 130);
    assert_eq!(sector("catmull-clark", 2, false).name(5), "face[1]");
}
