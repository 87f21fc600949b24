//! The rule `in-every-shift`: the greatest point of a level and the greatest value of the next
//! level, or of the limit, differ by more than the bound of the theorem.

use super::instance::Instance;
use super::sides::{MAX_LEVEL, Stated};
use crate::claims::Paper;
use crate::data::{MAX_CLASSES, Polygon, Rules, Setting, moved};
use crate::numbers::{Q, Value, int, read_rational};
use crate::schemes::{Library, Scheme};
use crate::text::{Block, Checked, Reason, Toml, compare, require};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// Checks one polygon, or the two polygons of a net, against the limit or the next level.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    instance: Instance<'a>,
) -> Checked<()> {
    let stated = Stated::read(claim, block)?;
    let mut polygons = Vec::new();
    while let Some(said) = block.maybe("polygon") {
        polygons.push(Polygon::read(said)?);
    }
    let Instance { scope, schemes, offset, setting } = instance;
    let Setting::Masks(rules, converge) = &setting else {
        return Err(Reason::Malformed("masks").into());
    };
    require(polygons.len() == rules.len(), Reason::Malformed("a polygon for each index"))?;
    let greatest = |level: u32| -> Checked<Q> {
        let of = |(rules, polygon)| Ok(Level::of(rules, polygon, level)?.greatest());
        rules.iter().zip(&polygons).map(of).sum()
    };
    let now = greatest(stated.level)?;
    let apart = match stated.quantity {
        "step" => (now - greatest(stated.level + 1)?).abs(),
        "distance" => {
            require(*converge, Reason::NoLimit)?;
            let said = block.after("limit")?;
            let words: Vec<&str> = said.split_whitespace().collect();
            let [side, said, places @ ..] = &words[..] else {
                return Err(Reason::Malformed("limit at-most or at-least VALUE …").into());
            };
            require(places.len() == rules.len(), Reason::Malformed("a place for each index"))?;
            let said = read_rational(said).ok_or(Reason::Malformed("a number"))?;
            let axes = rules.iter().zip(&polygons).zip(places);
            match *side {
                "at-most" => {
                    let mut most = Q::zero();
                    for (((rules, polygon), place), scheme) in axes.zip(&schemes) {
                        let level = place.parse().ok().filter(|level| *level <= MAX_LEVEL);
                        let level = level.ok_or(Reason::Malformed("a level"))?;
                        let offset = offset.unwrap_or(scheme.offset);
                        let last = Level::of(rules, polygon, level)?;
                        most += last.greatest();
                        if !rules.averages() {
                            most += last.spread() * nearness(paper.library, scheme, offset)?;
                        }
                    }
                    compare(most <= said, &most, &said, Reason::TooLarge)?;
                    now - said
                }
                "at-least" => {
                    let mut value = Q::zero();
                    for ((rules, polygon), place) in axes {
                        let t = read_rational(place).ok_or(Reason::Malformed("a place"))?;
                        let limit = rules.limit(&t)?;
                        value += limit.ok_or(Reason::Malformed("an n-adic number"))?.of(polygon);
                    }
                    compare(value == said, &said, &value, Reason::Value)?;
                    said - now
                }
                _ => return Err(Reason::Malformed("at-most or at-least").into()),
            }
        }
        _ => return Err(Reason::Malformed("a theorem about a step or a distance").into()),
    };
    let spreads: Vec<Q> = polygons.iter().map(|own| Q::from_integer(own.spread())).collect();
    stated.violated((paper, claim), scope, block, &spreads, &apart.into())
}

/// The points of a level, over a denominator.
struct Level(Polygon, BigInt);

impl Level {
    fn of(rules: &Rules<'_>, control: &Polygon, level: u32) -> Checked<Level> {
        let mut last = Level(control.clone(), BigInt::one());
        for _ in 0..level {
            let (points, over) = rules.refined((&last.0, &last.1))?;
            last = Level(points, over);
        }
        Ok(last)
    }

    fn greatest(&self) -> Q {
        Q::new(self.0.points.iter().max().cloned().unwrap_or_default(), self.1.clone())
    }

    fn spread(&self) -> Q {
        Q::new(self.0.spread(), self.1.clone())
    }
}

/// σ(T_0 + … + T_{c−1})/(1 − T_c) for the least c with T_c < 1: a bound of the distance of the
/// limit from points whose neighbours differ by at most 1.
fn nearness(library: &Library<'_>, scheme: &Scheme, offset: i64) -> Checked<Q> {
    let (mut sum, mut c) = (Q::one(), 1);
    let last = loop {
        require(scheme.arity().saturating_pow(c) <= MAX_CLASSES, Reason::NoContraction)?;
        let norm = library.products.greatest(&scheme.difference, &Value::int(c.into()))?;
        let norm = norm.rational().ok_or(Reason::NoContraction)?;
        if norm < Q::one() {
            break norm;
        }
        (sum, c) = (sum + norm, c + 1);
    };
    let moved = Value::greatest(&moved(library.meter, None, (scheme, offset), 0)?, None)?;
    let moved = moved.rational().ok_or(Reason::NoContraction)?;
    Ok(moved * sum / (int(1) - last))
}
