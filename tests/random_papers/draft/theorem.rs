//! Theorems about bounds near those that hold, and a little beyond.

use super::by::{by, depth};
use super::shape::{Factor, Instance, Shape, environment, valence};
use super::{Claim, Draft, Known, Mood};
use crate::random_papers::choices::Choices;
use crate::random_papers::formula::{Env, Tree, name, number, times};
use crate::random_papers::naive::{Net, Q};

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
        (vec![Reference::LocalRules(parameter.clone(), interpolant)], None)
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
    // Before the data are known, a spread has no value.
    let doubtful = draft.names.mood == Mood::Ambiguous;
    let (odd, even) = ([name("T"), name("beta"), name("k")], [name("T"), name("rate"), name("T")]);
    let supposes = choices.once_in(5).then(|| {
        let value =
            if kind >= 4 { number(1, 2) } else { choices.of(if doubtful { &odd } else { &even }) };
        [value, choices.of(&[number(1, 1), number(2, 3), number(2, 1)])]
    });
    if let Some([value, below]) = &supposes {
        fields += &format!("supposes = {{ value = '{value}', below = '{below}' }}\n");
    }
    let by = if quantity == "depth" {
        depth(choices)
    } else {
        let by = by(choices, &instances[0], quantity, from, offset);
        // A spread that is given may be thought to be a number.
        match draft.names.double.as_deref().and_then(|double| double.strip_suffix(" is given")) {
            Some(spread) if spread.starts_with("beta_") => times(name(spread), by),
            _ => by,
        }
    };
    fields += &format!("bounds = '{quantity}'\nby = '{by}'\n");
    if quantity != "depth" {
        fields += &format!("from = '{from}'\n");
    }
    let id = format!("theorem-{place}");
    let text = format!("[[theorem]]\nid = '{id}'\nlocus = ''\n{fields}");
    let turned = instances.iter().any(|instance| match &instance.shape {
        Shape::LocalRules(ring, Some(earlier)) => ring.names != earlier.names,
        _ => false,
    });
    let bound = Bound { quantity, by, from, instances, offset, supposes };
    Some(Claim {
        kind: "theorem",
        id,
        text,
        known: Known::Bound(Box::new(bound)),
        doubtful: turned,
    })
}

enum Reference {
    Masks(Vec<Factor>),
    /// The valence, and the place of the interpolant.
    LocalRules(Tree, Option<usize>),
}

impl Reference {
    fn text(&self, draft: &Draft) -> String {
        match self {
            Reference::Masks(factors) => {
                factors.iter().map(|factor| factor.text(draft)).collect::<Vec<_>>().join(" x ")
            }
            Reference::LocalRules(valence, _) => format!("ring:N={valence}"),
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
            Reference::LocalRules(formula, interpolant) => {
                let valence = valence(env, formula)?;
                let earlier = interpolant.map(|place| draft.rings[place].at(valence));
                Shape::LocalRules(draft.rings[0].at(valence), earlier)
            }
        })
    }
}
