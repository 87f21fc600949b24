//! Theorems about bounds near those that hold, and a little beyond.

use super::shape::{Factor, Instance, Shape, environment, valence};
use super::{Claim, Draft, Known};
use crate::choices::Choices;
use crate::formula::{Env, Tree, call, name, number, of, times};
use crate::naive::{Net, Q, Ring};
use num_traits::{One, Zero};

/// What a theorem says of its instances.
#[derive(Clone, Debug)]
pub struct Bound {
    pub quantity: &'static str,
    pub by: Tree,
    pub from: u32,
    pub instances: Vec<Instance>,
    pub offset: Option<i64>,
    pub supposes: Option<[Tree; 2]>,
}

const QUANTITIES: [&str; 4] = ["difference", "step", "distance", "depth"];

pub fn claim(draft: &Draft, place: usize, choices: &mut Choices) -> Option<Claim> {
    let kind = choices.below(6);
    let (mut fields, mut quantity) = (String::new(), choices.of(&QUANTITIES));
    let chosen: Vec<(String, Vec<Q>)> = match choices.below(4) {
        0 | 1 => Vec::new(),
        2 => vec![("v".to_owned(), vec![Q::new(1.into(), 8.into())])],
        _ => {
            let eighth = |p: i64| Q::new(p.into(), 8.into());
            let valences = vec![Q::from_integer(3.into()), Q::from_integer(4.into())];
            let name = choices.of(&["v", "c"]);
            vec![(name.to_owned(), if kind >= 4 { valences } else { vec![eighth(1), eighth(0)] })]
        }
    };
    let parameter = match (chosen.first(), kind >= 4) {
        (Some((name, _)), _) => Tree::Name(name.clone()),
        (None, true) => number(choices.of(&[3, 4, 5]), 1),
        (None, false) => choices.of(&[number(1, 8), number(0, 1), name("size"), number(-1, 16)]),
    };
    let (shapes, offset): (Vec<Reference>, _) = if kind >= 4 {
        let interpolant = choices.of(&[None, None, Some(1), Some(2)]);
        if quantity == "depth" {
            quantity = "step";
        }
        if let Some(place) = interpolant {
            fields += &format!("interpolant = '{}:N={parameter}'\n", draft.rings[place].name);
        }
        (vec![Reference::Ring(parameter.clone(), interpolant)], None)
    } else {
        let several = if choices.once_in(4) { 2 } else { 1 };
        let mut reference = |_| {
            let factors = 1 + usize::from(kind == 3);
            Reference::Masks((0..factors).map(|_| Factor::new(choices, &parameter)).collect())
        };
        let shapes = (0..several).map(&mut reference).collect();
        (shapes, choices.of(&[None, None, Some(0), Some(-1)]))
    };
    let texts: Vec<String> = shapes.iter().map(|shape| shape.text(draft)).collect();
    fields += &match &texts[..] {
        [one] if !choices.once_in(5) => format!("scheme = '{one}'\n"),
        all => format!("schemes = ['{}']\n", all.join("', '")),
    };
    for (name, values) in &chosen {
        let values: Vec<String> = values.iter().map(ToString::to_string).collect();
        fields += &format!("values.{name} = ['{}']\n", values.join("', '"));
    }
    fields += &offset.map_or(String::new(), |offset: i64| format!("offset = '{offset}'\n"));
    let mut instances = Vec::new();
    for (shape, text) in shapes.iter().zip(&texts) {
        let values = chosen.first().map_or(vec![Vec::new()], |(name, values)| {
            values.iter().map(|value| vec![(name.clone(), value.clone())]).collect()
        });
        for values in values {
            let shape = shape.at(draft, &environment(draft, &values))?;
            instances.push(Instance { reference: text.clone(), values, shape });
        }
    }
    // The limits of wide masks take their time.
    if instances.iter().any(|instance| instance.shape.is_wide()) && !choices.once_in(8) {
        quantity = if choices.once_in(2) { "difference" } else { "step" };
    }
    let from = if quantity == "depth" { 0 } else { choices.of(&[0, 0, 1, 2, 3]) };
    let supposes = choices.once_in(5).then(|| {
        let value = if kind >= 4 {
            number(1, 2)
        } else {
            choices.of(&[name("T"), name("rate"), name("beta")])
        };
        [value, choices.of(&[number(1, 1), number(2, 3)])]
    });
    if let Some([value, below]) = &supposes {
        fields += &format!("supposes = {{ value = '{value}', below = '{below}' }}\n");
    }
    let by = if quantity == "depth" {
        depth(choices)
    } else {
        by(choices, &instances[0], quantity, from, offset)
    };
    fields += &format!("bounds = '{quantity}'\nby = '{by}'\n");
    if quantity != "depth" {
        fields += &format!("from = '{from}'\n");
    }
    let id = format!("theorem-{place}");
    let text = format!("[[theorem]]\nid = '{id}'\nlocus = ''\n{fields}");
    let bound = Bound { quantity, by, from, instances, offset, supposes };
    Some(Claim { kind: "theorem", id, text, known: Known::Bound(Box::new(bound)) })
}

enum Reference {
    Masks(Vec<Factor>),
    /// The valence, and the place of the interpolant.
    Ring(Tree, Option<usize>),
}

impl Reference {
    fn text(&self, draft: &Draft) -> String {
        match self {
            Reference::Masks(factors) => {
                factors.iter().map(|factor| factor.text(draft)).collect::<Vec<_>>().join(" x ")
            }
            Reference::Ring(valence, _) => format!("ring:N={valence}"),
        }
    }

    fn at(&self, draft: &Draft, env: &Env<'_>) -> Option<Shape> {
        Some(match self {
            Reference::Masks(factors) => {
                let curves: Option<Vec<_>> =
                    factors.iter().map(|factor| factor.at(draft, env)).collect();
                match <[_; 2]>::try_from(curves?) {
                    Ok(pair) => Shape::Net(Net(pair)),
                    Err(mut one) => Shape::Curve(one.pop()?),
                }
            }
            Reference::Ring(formula, interpolant) => {
                let valence = valence(env, formula)?;
                let earlier = interpolant.map(|place| draft.rings[place].at(valence));
                Shape::Ring(draft.rings[0].at(valence), earlier)
            }
        })
    }
}

/// The greatest value of a quantity at a level, at least, and of the differences after one level.
fn greatest(instance: &Instance, quantity: &str, level: u32, offset: Option<i64>) -> (Q, Q) {
    let of_curve = |curve: &crate::naive::Curve| {
        let curve = curve.with_offset(offset);
        let value = match quantity {
            "difference" => curve.greatest_difference(level),
            "step" => curve.greatest_step(level),
            _ => curve.farthest(level, level + 3),
        };
        (value, curve.greatest_difference(1))
    };
    match &instance.shape {
        Shape::Curve(curve) => of_curve(curve),
        Shape::Net(Net(pair)) => {
            let [one, other] = pair.each_ref().map(of_curve);
            let value = if quantity == "difference" { one.0.max(other.0) } else { one.0 + other.0 };
            (value, one.1.max(other.1))
        }
        Shape::Ring(ring, earlier) => {
            let heights = ring.heights();
            let rows = if quantity == "difference" {
                ring.differences(level)
            } else {
                ring.steps(level, earlier.as_ref())
            };
            (Ring::greatest(&rows, &heights), Ring::greatest(&ring.differences(1), &heights))
        }
    }
}

fn depth(choices: &mut Choices) -> Tree {
    let epsilon = name("epsilon");
    let choice = [
        of('-', number(4, 1), call("floor", &[times(epsilon.clone(), number(20, 1))])),
        call("floor", &[of('/', number(1, 4), epsilon.clone())]),
        number(2, 1),
        of('+', number(1, 1), call("kronecker", &[epsilon, number(1, 4)])),
    ];
    choices.of(&choice)
}

/// A bound that is true, or false by little, at the first level.
fn by(
    choices: &mut Choices,
    instance: &Instance,
    quantity: &str,
    from: u32,
    offset: Option<i64>,
) -> Tree {
    let ring = matches!(instance.shape, Shape::Ring(..));
    let spread = match &instance.shape {
        Shape::Net(_) if choices.once_in(2) => choices.of(&[
            name("beta_1"),
            name("beta_2"),
            name("beta_3"),
            of('/', of('+', name("beta_1"), name("beta_2")), number(2, 1)),
        ]),
        _ => name("beta"),
    };
    let (value, fall) = greatest(instance, quantity, from, offset);
    // Now and then one that is true for long, and false in the end.
    let late = choices.once_in(4);
    let factors = [(1, 1), (9, 10), (11, 10), (4, 1), (50, 1), (1000, 1)];
    let factors = factors.map(|(p, q): (i64, i64)| Q::new(p.into(), q.into()));
    let mut value = value * choices.of(&factors[if late { 4..6 } else { 0..6 }]);
    if value.is_zero() && choices.once_in(2) {
        value = Q::one();
    }
    let level = name("k");
    let after =
        if from == 0 { level.clone() } else { of('-', level.clone(), number(from.into(), 1)) };
    let less = Tree::Number(&fall * choices.of(&factors[..2]) * Q::new(4.into(), 5.into()));
    let fall = Tree::Number(fall);
    let named = if ring { fall.clone() } else { choices.of(&[name("T"), name("rate")]) };
    let ratios =
        [fall.clone(), fall, named, less.clone(), number(1, 2), number(3, 4), number(1, 1)];
    let ratio = if late { less } else { choices.of(&ratios) };
    let plain = || {
        times(
            times(Tree::Number(value.clone()), spread.clone()),
            of('^', ratio.clone(), after.clone()),
        )
    };
    let half = call("floor", &[of('/', after.clone(), number(2, 1))]);
    match choices.below(if ring { 7 } else { 11 }) {
        0 | 1 => plain(),
        _ if late => plain(),
        4 if quantity == "distance" => plain(),
        2 => times(spread.clone(), of('^', ratio.clone(), after.clone())),
        3 => times(
            times(Tree::Number(value.clone()), spread.clone()),
            of('^', times(ratio.clone(), ratio.clone()), half),
        ),
        4 => of(
            '-',
            plain(),
            times(
                spread.clone(),
                of('/', call("kronecker", &[level, number(i64::from(from) + 4, 1)]), number(2, 1)),
            ),
        ),
        5 => Tree::Minus(Box::new(times(of('-', number(0, 1), plain()), number(1, 1)))),
        6 => of(
            '/',
            plain(),
            of('^', number(choices.of(&[1, 2]), 1), call("abs", &[of('-', level, number(5, 1))])),
        ),
        7 => choices.of(&[name("bound"), name("series")]),
        8 => times(times(Tree::Number(value), spread), name("power")),
        9 => {
            let ends = Box::new([number(0, 1), choices.of(&[number(2, 1), level]), name("term")]);
            times(times(Tree::Number(value), spread), Tree::Sum("h".to_owned(), ends))
        }
        _ => times(times(name("mixed"), spread), of('^', name("rate"), after)),
    }
}
