//! Exact refinement of polygons and grids over several levels.

use crate::bound::{ClassCap, LocalWork};
use crate::exact::{CommonDenominator, Integer, Rational, Scalar, common_denominator};
use crate::scheme::Rules;

/// The greatest number of values of a control polygon or grid at any level.
pub const MAX_VALUES: usize = 1_000_000;

/// The most binary digits of all values together, over the common denominator of the control points.
pub const MAX_BITS: u64 = 1 << 29;

/// The greatest number of refinements.
pub const MAX_REFINED_LEVEL: u32 = 64;

/// How the ends of a polygon are treated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// A closed polygon: indices are taken mod the number of points.
    Closed,
    /// An open polygon: a rule is applied only where all of its points exist that have a weight; see
    /// [`Rules::refine_open`].
    Open,
}

/// Why reference values are not computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum OracleError {
    /// Too many residue classes.
    #[error(transparent)]
    Classes(#[from] ClassCap),
    /// Powers of a ring that are too much work.
    #[error(transparent)]
    LocalRules(#[from] LocalWork),
    /// A number of control points other than the number of points of the ring.
    #[error("{found} control points for a ring of {expected}: {names}")]
    LocalPoints {
        /// The number of control points given.
        found: usize,
        /// The number v of points of the ring.
        expected: usize,
        /// The orbits of the ring.
        names: String,
    },
    /// A control polygon without points.
    #[error("there are no control points")]
    Empty,
    /// More than [`MAX_VALUES`] values.
    #[error("more than {MAX_VALUES} values: take a lower level or fewer control points")]
    TooMany,
    /// More than [`MAX_BITS`] binary digits in all.
    #[error(
        "{count} values of {bits} binary digits each: at most {MAX_BITS} in all; take a lower level, fewer control \
         points, or such with a shorter common denominator"
    )]
    TooLong {
        /// The number of values.
        count: usize,
        /// The binary digits that each may have.
        bits: u64,
    },
    /// More than [`MAX_REFINED_LEVEL`] levels.
    #[error("level {0} is too high; at most {MAX_REFINED_LEVEL} is")]
    Level(u32),
    /// An open polygon with fewer points than the width of the rules.
    #[error(
        "nothing is left of the open polygon after level {level}: it has {count} points there, \
         and rules need up to {width}"
    )]
    TooFew {
        /// The last level that has points.
        level: u32,
        /// The number of points of this level.
        count: usize,
        /// The width N.
        width: usize,
    },
    /// A grid for a curve, or a polygon for a tensor product.
    #[error("a control {found} for a {scheme}, which refines a {expected}")]
    Shape {
        /// The control data given.
        found: &'static str,
        /// The kind of the scheme.
        scheme: &'static str,
        /// The control data that the scheme refines.
        expected: &'static str,
    },
    /// A grid whose last row is incomplete, or that has no columns.
    #[error("{count} values are not whole rows of {columns}")]
    Ragged {
        /// The number of values.
        count: usize,
        /// The number of columns.
        columns: usize,
    },
}

/// The polygon of level `level`, from the polygon `points` of level 0. A closed polygon
/// of m points gives n^level·m values. An open polygon is refined by
/// [`Rules::refine_open`] `level` times. The points are numbers of any type that converts into a
/// [`Rational`], such as `BigRational` of num-rational.
///
/// # Errors
/// When there are no points, there would be too many or too long ones, none would be left, or the level is
/// too high.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::oracle::{Boundary, refine_polygon};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("chaikin")?;
/// let points = [0, 4, 4, 0].map(Rational::from);
/// let refined = refine_polygon(scheme.masks()[0].rules(), &points, 2, Boundary::Closed)?;
/// assert_eq!(refined.len(), 16);
/// let quarters = [6, 10, 13, 15].map(|p| Rational::new(p, 4));
/// assert_eq!(refined[..4], quarters);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refine_polygon(
    rules: &Rules,
    points: &[impl Clone + Into<Rational>],
    level: u32,
    boundary: Boundary,
) -> Result<Vec<Rational>, OracleError> {
    let count = count_after(rules, points.len(), level, boundary)?;
    let (whole, scale) = whole(rules);
    let (mut values, denominator) = whole_values(points);
    within_bits(count, (&values, &denominator), &[(&whole, &scale)], level)?;
    for _ in 0..level {
        values = once(&whole, &values, boundary);
    }
    Ok(fractions(values, &(denominator * scale.pow(level))))
}

/// The grid of level `level` and its number of columns, from the `grid` of level 0, row by
/// row: `p'_{ni+α, mj+β} = Σ_{r,s} a_{α,r} a'_{β,s} p_{i+o+r, j+o'+s}`. The first rules act
/// along the columns of the grid (on i), the second along its rows (on j).
///
/// # Errors
/// As [`refine_polygon`], and when the last row of the grid is incomplete.
pub fn refine_grid(
    rules: [&Rules; 2],
    grid: &[impl Clone + Into<Rational>],
    columns: usize,
    level: u32,
    boundary: Boundary,
) -> Result<(Vec<Rational>, usize), OracleError> {
    if grid.len() > MAX_VALUES {
        return Err(OracleError::TooMany);
    }
    if columns == 0 || !grid.len().is_multiple_of(columns) {
        return Err(OracleError::Ragged { count: grid.len(), columns });
    }
    let rows_after = count_after(rules[0], grid.len() / columns, level, boundary)?;
    let columns_after = count_after(rules[1], columns, level, boundary)?;
    if rows_after.saturating_mul(columns_after) > MAX_VALUES {
        return Err(OracleError::TooMany);
    }
    let [(first, first_scale), (second, second_scale)] = rules.map(whole);
    let (mut values, denominator) = whole_values(grid);
    let rules = [(&first, &first_scale), (&second, &second_scale)];
    within_bits(rows_after * columns_after, (&values, &denominator), &rules, level)?;
    let mut width = columns;
    for _ in 0..level {
        let height = values.len() / width;
        let across = along_rows(&second, &values, width, boundary);
        let turned = transposed(&across, across.len() / height);
        let along = along_rows(&first, &turned, height, boundary);
        width = across.len() / height;
        values = transposed(&along, along.len() / width);
    }
    let scale = denominator * first_scale.pow(level) * second_scale.pow(level);
    Ok((fractions(values, &scale), width))
}

/// The number of points at `level` of a polygon of `count` points.
fn count_after(
    rules: &Rules,
    count: usize,
    level: u32,
    boundary: Boundary,
) -> Result<usize, OracleError> {
    if level > MAX_REFINED_LEVEL {
        return Err(OracleError::Level(level));
    }
    if count == 0 {
        return Err(OracleError::Empty);
    }
    let mut now = count;
    for k in 0..level {
        let next = match boundary {
            Boundary::Closed => now.saturating_mul(rules.arity()),
            Boundary::Open => rules.open_range(now).count(),
        };
        if next == 0 {
            return Err(OracleError::TooFew { level: k, count: now, width: rules.width() });
        }
        now = next;
        if now > MAX_VALUES {
            return Err(OracleError::TooMany);
        }
    }
    if count > MAX_VALUES { Err(OracleError::TooMany) } else { Ok(now) }
}

/// Refuses more digits than the cap allows for: those of the control points, and what these rules add at each level.
fn within_bits(
    count: usize,
    (values, denominator): (&[Whole], &Integer),
    rules: &[(&Rules<Whole>, &Integer)],
    level: u32,
) -> Result<(), OracleError> {
    let of_row =
        |row: &Vec<Whole>| row.iter().map(|Whole(entry)| entry.abs()).sum::<Integer>().bits();
    let added = |(rules, scale): &(&Rules<Whole>, &Integer)| {
        rules.rows().iter().map(of_row).max().unwrap_or(0).max(scale.bits())
    };
    let own = values.iter().map(|Whole(value)| value.bits()).max().unwrap_or(0);
    let bits =
        own.max(denominator.bits()) + u64::from(level) * rules.iter().map(added).sum::<u64>();
    if (count as u64).saturating_mul(bits) > MAX_BITS {
        return Err(OracleError::TooLong { count, bits });
    }
    Ok(())
}

fn once(rules: &Rules<Whole>, values: &[Whole], boundary: Boundary) -> Vec<Whole> {
    match boundary {
        Boundary::Closed => rules.refine_closed(values),
        Boundary::Open => rules.refine_open(values),
    }
}

fn along_rows(
    rules: &Rules<Whole>,
    values: &[Whole],
    columns: usize,
    boundary: Boundary,
) -> Vec<Whole> {
    values.chunks(columns).flat_map(|row| once(rules, row, boundary)).collect()
}

/// The grid with rows and columns exchanged.
fn transposed(values: &[Whole], columns: usize) -> Vec<Whole> {
    let column = |j: usize| values.iter().skip(j).step_by(columns).cloned();
    (0..columns).flat_map(column).collect()
}

/// An integer as a [`Scalar`]. The refinement uses integers over one common denominator;
/// fractions are reduced only at the end.
#[derive(Clone, PartialEq)]
struct Whole(Integer);

impl Scalar for Whole {
    /// For integers only; a refinement needs no other numbers.
    fn from_rational(value: &Rational) -> Whole {
        debug_assert!(value.is_integer());
        Whole(value.numerator())
    }
    fn plus(&self, other: &Whole) -> Whole {
        Whole(&self.0 + &other.0)
    }
    fn minus(&self, other: &Whole) -> Whole {
        Whole(&self.0 - &other.0)
    }
    fn times(&self, other: &Whole) -> Whole {
        Whole(&self.0 * &other.0)
    }
    fn zero() -> Whole {
        Whole(Integer::zero())
    }
}

/// The rules as integers over a common denominator, and that denominator.
fn whole(rules: &Rules) -> (Rules<Whole>, Integer) {
    let common = CommonDenominator::of(rules.rows());
    let scale = Rational::from(common.denominator.clone());
    (rules.map(|value| Whole((value * &scale).numerator())), common.denominator)
}

fn whole_values(values: &[impl Clone + Into<Rational>]) -> (Vec<Whole>, Integer) {
    let values: Vec<Rational> = values.iter().cloned().map(Into::into).collect();
    let denominator = common_denominator(&values);
    let scale = Rational::from(denominator.clone());
    (values.iter().map(|value| Whole((value * &scale).numerator())).collect(), denominator)
}

fn fractions(values: Vec<Whole>, denominator: &Integer) -> Vec<Rational> {
    values.into_iter().map(|Whole(value)| Rational::new(value, denominator.clone())).collect()
}
