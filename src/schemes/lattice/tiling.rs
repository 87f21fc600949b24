//! Tilings of R^d whose tiles a dilation takes to unions of tiles: by digits, and by the alcoves of reflection groups.

use super::window::{attractor, less_digits};
use crate::cap::Cap;
use crate::exact::Rational;
use crate::scheme::{Dilation, LatticeMask, Point, adjugate, apply, determinant, difference};

/// The motion x ↦ Gx + t of R^d, which takes Z^d to itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Motion {
    /// G, row by row.
    pub matrix: [Point; 3],
    /// t.
    pub shift: Point,
}

const UNIT: [Point; 3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

impl Motion {
    /// x ↦ x + t.
    pub(super) fn by(shift: Point) -> Motion {
        Motion { matrix: UNIT, shift }
    }

    /// Gx + t at a rational point.
    pub(super) fn of_point(&self, x: &[Rational]) -> Vec<Rational> {
        let row = |i: usize| {
            let terms = x.iter().zip(self.matrix[i]).map(|(x, g)| x * &Rational::from(g));
            terms.sum::<Rational>() + Rational::from(self.shift[i])
        };
        (0..x.len()).map(row).collect()
    }
}

/// The inverse of a matrix of determinant ±1.
pub(super) fn inverse(m: &[Point; 3]) -> [Point; 3] {
    let determinant = determinant(m);
    adjugate(m).map(|row| row.map(|x| determinant * x))
}

fn times(a: &[Point; 3], b: &[Point; 3]) -> [Point; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The figures whose reflections have alcoves: simplices that their mirrors cut out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// The square, with the directions (1, 0) and (0, 1).
    Square,
    /// The hexagon with the third direction (1, 1).
    HexagonSum,
    /// The hexagon with the third direction (1, −1).
    HexagonDifference,
    /// The cube.
    Cube,
}

impl Figure {
    /// The figures of a space of d dimensions.
    fn all(d: usize) -> &'static [Figure] {
        match d {
            2 => &[Figure::HexagonSum, Figure::HexagonDifference, Figure::Square],
            _ => &[Figure::Cube],
        }
    }

    /// Its directions, up to the sign.
    fn directions(self) -> Vec<Point> {
        let [x, y, z] = UNIT;
        match self {
            Figure::Square => vec![x, y],
            Figure::HexagonSum => vec![x, y, [1, 1, 0]],
            Figure::HexagonDifference => vec![x, y, [1, -1, 0]],
            Figure::Cube => vec![x, y, z],
        }
    }

    /// The corners of its alcove at 0.
    fn alcove(self) -> Vec<Vec<Rational>> {
        let sixths: &[&[i64]] = match self {
            Figure::Square => &[&[0, 0], &[3, 0], &[3, 3]],
            Figure::HexagonSum => &[&[0, 0], &[3, 0], &[4, 2]],
            Figure::HexagonDifference => &[&[0, 0], &[3, 0], &[2, 2]],
            Figure::Cube => &[&[0, 0, 0], &[3, 0, 0], &[3, 3, 0], &[3, 3, 3]],
        };
        sixths.iter().map(|corner| corner.iter().map(|x| Rational::new(*x, 6)).collect()).collect()
    }
}

/// A tile A whose images under a group of motions cover R^d, with MA = ∪_i g_i(A) for m = |det M| motions g_i of the group.
#[derive(Clone, Debug)]
pub struct Tiling {
    /// The g_i.
    pub parts: Vec<Motion>,
    /// The motions g of the group for which g(A) meets A, the unit among them.
    pub neighbours: Vec<Motion>,
    /// The linear parts of the group.
    pub group: Vec<[Point; 3]>,
    /// The figure of whose alcoves it is one; none of the tile of digits.
    pub figure: Option<Figure>,
}

impl Tiling {
    /// The tile Q = M^{−1}(Q + E) of the digits, and its translates.
    ///
    /// # Errors
    /// When its neighbours are beyond the caps.
    pub fn of_digits(dilation: &Dilation) -> Result<Tiling, Cap> {
        let digits = dilation.digits().iter().copied();
        let neighbours = attractor(dilation, &less_digits(digits.clone(), dilation))?;
        Ok(Tiling {
            parts: digits.map(Motion::by).collect(),
            neighbours: neighbours.into_iter().map(Motion::by).collect(),
            group: vec![UNIT],
            figure: None,
        })
    }

    /// The alcove of the square, the hexagon or the cube, if all symmetries of this figure are symmetries of the mask about 0, and the dilation takes the
    /// alcove to a union of alcoves.
    #[must_use]
    pub fn of_alcove<S: PartialEq>(mask: &LatticeMask<S>) -> Option<Tiling> {
        let dilation = mask.dilation();
        let d = mask.dimension();
        Figure::all(d).iter().find_map(|figure| {
            let group = group_of(&figure.directions(), d);
            let fixes = |g: &[Point; 3]| {
                mask.coefficients()
                    .iter()
                    .all(|(place, c)| mask.coefficients().get(&apply(g, *place)) == Some(c))
            };
            (group.iter().all(fixes) && normalises(dilation, &group))
                .then(|| alcoves(dilation, group, *figure))?
        })
    }
}

/// The matrices that permute some directions and their opposites.
fn group_of(directions: &[Point], dimension: usize) -> Vec<[Point; 3]> {
    let both: Vec<Point> = directions.iter().flat_map(|u| [*u, difference([0; 3], *u)]).collect();
    // The images of the unit vectors, which are directions.
    let mut all = vec![Vec::new()];
    for _ in 0..dimension {
        all = all
            .into_iter()
            .flat_map(|columns: Vec<Point>| {
                both.iter().map(move |u| columns.iter().copied().chain([*u]).collect())
            })
            .collect();
    }
    let matrix = |columns: Vec<Point>| -> [Point; 3] {
        let column = |j: usize| columns.get(j).copied().unwrap_or(UNIT[j]);
        std::array::from_fn(|i| std::array::from_fn(|j| column(j)[i]))
    };
    let permutes = |g: &[Point; 3]| {
        let mut images: Vec<Point> = both.iter().map(|u| apply(g, *u)).collect();
        let mut own = both.clone();
        images.sort_unstable();
        own.sort_unstable();
        images == own
    };
    all.into_iter().map(matrix).filter(permutes).collect()
}

/// Whether MGM^{−1} is in the group for each G of it.
fn normalises(dilation: &Dilation, group: &[[Point; 3]]) -> bool {
    let unit = |j: usize| -> Point { std::array::from_fn(|i| i64::from(i == j)) };
    let columns: Vec<Point> = (0..3).map(|j| dilation.times(unit(j))).collect();
    let m: [Point; 3] = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    group.iter().all(|g| {
        let image = times(&m, g);
        group.iter().any(|h| times(h, &m) == image)
    })
}

/// The tiling by the images of a simplex.
fn alcoves(dilation: &Dilation, group: Vec<[Point; 3]>, figure: Figure) -> Option<Tiling> {
    let (d, corners) = (dilation.dimension(), figure.alcove());
    let images = |motion: &Motion| -> Vec<Vec<Rational>> {
        corners.iter().map(|corner| motion.of_point(corner)).collect()
    };
    // M^{−1}g(A) is in A if its corners are. As many parts as M has classes fill A, since images of A do not overlap.
    let reach = dilation.rows().flatten().map(|x| x.abs()).sum::<i64>() + 1;
    let motions = |reach: i64| {
        let range = move |axis: usize| if axis < d { -reach..=reach } else { 0..=0 };
        let shifts = range(0)
            .flat_map(move |x| range(1).flat_map(move |y| range(2).map(move |z| [x, y, z])));
        let group = &group;
        shifts.flat_map(move |shift| {
            group.iter().map(move |matrix| Motion { matrix: *matrix, shift })
        })
    };
    let inside = |motion: &Motion| {
        images(motion).iter().all(|corner| is_inside(&dilation.inverse_times(corner), &corners))
    };
    let parts: Vec<Motion> = motions(reach).filter(inside).collect();
    let meets = |motion: &Motion| images(motion).iter().any(|corner| corners.contains(corner));
    let neighbours: Vec<Motion> = motions(2).filter(meets).collect();
    (parts.len() == dilation.class_count()).then_some(Tiling {
        parts,
        neighbours,
        group,
        figure: Some(figure),
    })
}

/// Whether a point is in a simplex: its barycentric coordinates are not negative.
fn is_inside(point: &[Rational], corners: &[Vec<Rational>]) -> bool {
    let d = point.len();
    let row = |i: usize| -> Vec<Rational> {
        corners.iter().map(|corner| corner[i].clone()).chain([point[i].clone()]).collect()
    };
    let ones = vec![Rational::one(); d + 2];
    let rows = (0..d).map(row).chain([ones]).collect::<Vec<_>>();
    crate::exact::solve(&rows).is_some_and(|all| all.iter().all(|x| x.sign() >= 0))
}
