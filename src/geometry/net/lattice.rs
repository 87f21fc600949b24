//! Nets with a mask on Z².

use super::error::NetError;
use super::grid::Net;
use super::refine::MAX_NET_LEVEL;
use crate::exact::Rational;
use crate::lattice::{LatticeSmoothness, natural_shift, values_at_integers};
use crate::mesh::{MAX_POINTS, Point, combination};
use crate::scheme::LatticeMask;
use crate::stop::Stop;
use std::ops::Range;

/// The net of a later level, x'_α = Σ_β a(α − Mβ) x_β, for a diagonal M with positive entries; rows have the first index.
///
/// In a closed direction indices are taken modulo its size. In an open one the net of the next level has the points that the net determines.
///
/// # Errors
/// When M is another matrix, the mask is none in the plane, an open direction has too few points, too many points would arise, or the level is above
/// [`MAX_NET_LEVEL`].
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net, refine_lattice_net};
/// use subcert::scheme::parse_lattice;
///
/// let point = |k: i64| [k % 4, k / 4, 0].map(Rational::from);
/// let net = Net::new((0..16).map(point).collect(), 4, Closed::default())?;
/// let courant = parse_lattice("(1+x)*(1+y)*(1+x*y)/2")?;
/// let refined = refine_lattice_net(&net, &courant, 1)?;
/// assert_eq!(refined.sizes(), [7, 7]);
/// assert_eq!(refined.points()[1], [Rational::new(1, 2), Rational::zero(), Rational::zero()]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refine_lattice_net(net: &Net, mask: &LatticeMask, level: u32) -> Result<Net, NetError> {
    if level > MAX_NET_LEVEL {
        return Err(NetError::Level { level, most: MAX_NET_LEVEL });
    }
    let Some([n, m]) = arities(mask) else {
        return Err(NetError::TooMuch(
            "the points of later levels are a net for masks in the plane whose dilation matrix is diagonal, with \
             positive entries"
                .to_owned(),
        ));
    };
    let mut net = net.clone();
    for _ in 0..level {
        let [rows, columns] = [range(&net, mask, 0, n)?, range(&net, mask, 1, m)?];
        let count = |range: &Range<i64>| usize::try_from(range.end - range.start).unwrap_or(0);
        let points = count(&rows).saturating_mul(count(&columns));
        if points > MAX_POINTS {
            return Err(NetError::TooManyPoints(points));
        }
        let width = count(&columns);
        let all = rows.flat_map(|i| columns.clone().map(move |j| [i, j, 0]));
        let point = |at| {
            let terms: Vec<(&Rational, &Point<Rational>)> =
                mask.rule(at).filter_map(|(at, c)| Some((c, net.at(at[0], at[1])?))).collect();
            combination(terms)
        };
        net = Net::new(all.map(point).collect(), width, net.closed())?;
    }
    Ok(net)
}

/// The limit point of every point of a net, row by row: for x_α that at α + t, Σ_β φ(β) x_{α+t−β}, t the integers that are not above those of the natural shift
/// τ. Where τ is one of integers, this is the natural place. `None` where an open net does not determine it.
///
/// # Errors
/// When the scheme is not shown to converge, or the values of φ at integers are beyond a cap.
pub fn lattice_net_limits(
    net: &Net,
    mask: &LatticeMask,
) -> Result<Vec<Option<Point<Rational>>>, NetError> {
    let values = values_at_integers(mask).map_err(|cap| NetError::TooMuch(cap.to_string()))?;
    let converges = LatticeSmoothness::convergence(mask, &Stop::default()).converges;
    let values = values.filter(|_| converges == Some(true)).ok_or_else(|| {
        NetError::TooMuch(
            "the scheme is not shown to converge, so that there are no limit points".to_owned(),
        )
    })?;
    let shift: Vec<i64> =
        natural_shift(mask).iter().map(|x| x.floor().to_i64().unwrap_or(0)).collect();
    let limit = |i: i64, j: i64| -> Option<Point<Rational>> {
        let (i, j) = (i + shift[0], j + shift[1]);
        let terms: Option<Vec<(&Rational, &Point<Rational>)>> =
            values.iter().map(|(at, value)| Some((value, net.at(i - at[0], j - at[1])?))).collect();
        Some(combination(terms?))
    };
    let [rows, columns] = net.sizes().map(|size| i64::try_from(size).unwrap_or(i64::MAX));
    let all = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    Ok(all.map(|(i, j)| limit(i, j)).collect())
}

/// The entries of a diagonal 2×2 matrix M, if they are positive.
fn arities(mask: &LatticeMask) -> Option<[i64; 2]> {
    let diagonal: [i64; 2] = mask.dilation().diagonal()?.try_into().ok()?;
    diagonal.iter().all(|n| *n > 0).then_some(diagonal)
}

/// The indices of the points of the next level in one direction: those α with β from 0 to the last one in all α − nβ from the least to the greatest place of
/// the mask.
fn range(net: &Net, mask: &LatticeMask, direction: usize, n: i64) -> Result<Range<i64>, NetError> {
    let found = net.sizes()[direction];
    let size = i64::try_from(found).unwrap_or(i64::MAX);
    if net.closed().both()[direction] {
        return Ok(0..n * size);
    }
    let [low, high] = mask.ranges().map(|place| place[direction]);
    let range = high - n + 1..n * size + low;
    // A net has two points at least.
    if range.end - range.start < 2 {
        let least = (high - low + 2 + n - 1).div_euclid(n);
        let needed = usize::try_from(least).unwrap_or(usize::MAX);
        return Err(NetError::TooFew { direction, found, needed });
    }
    Ok(range)
}
