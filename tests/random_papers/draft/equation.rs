//! Equations with symbols, families, indices and hypotheses.

use super::{Claim, Known};
use crate::random_papers::choices::Choices;
use crate::random_papers::formula::{Tree, call, name, number, of, times};
use crate::random_papers::naive::{Q, int};

/// What an equation says.
#[derive(Clone, Debug)]
pub struct Identity {
    /// The values of the indices in each case.
    pub cases: Vec<Vec<(String, Q)>>,
    /// Members and values, each of which asks for earlier ones only; none where they are no such
    /// list, and what follows from them is not looked at.
    pub hypotheses: Option<Vec<[Tree; 2]>>,
    pub left: Tree,
    pub right: Tree,
}

fn member(position: Tree) -> Tree {
    Tree::Member("q".to_owned(), vec![position])
}

fn atom(choices: &mut Choices, indices: &[&str]) -> Tree {
    let mut atoms = vec![name("a"), name("b"), number(2, 1), number(-1, 3), name("third")];
    atoms.extend([0, 1, 1, 2, 1].map(|i| member(number(i, 1))));
    for index in indices {
        atoms.extend([
            name(index),
            member(name(index)),
            member(of('+', name(index), number(1, 1))),
        ]);
    }
    atoms.push(Tree::Sum("h".to_owned(), Box::new([number(0, 1), number(1, 1), name("term")])));
    choices.of(&atoms)
}

fn polynomial(choices: &mut Choices, indices: &[&str], depth: usize) -> Tree {
    if depth == 0 || choices.once_in(3) {
        return atom(choices, indices);
    }
    let [left, right] = [0, 1].map(|_| polynomial(choices, indices, depth - 1));
    of(choices.of(&['+', '-', '*', '*']), left, right)
}

/// The same by other words.
fn rewritten(tree: &Tree) -> Tree {
    match tree {
        Tree::Of('*', parts) => {
            let [left, right] = &**parts;
            match left {
                Tree::Of(sign @ ('+' | '-'), terms) => {
                    let [one, other] = &**terms;
                    of(
                        *sign,
                        times(rewritten(one), right.clone()),
                        times(rewritten(other), right.clone()),
                    )
                }
                _ => times(right.clone(), rewritten(left)),
            }
        }
        Tree::Of('-', parts) => {
            let [left, right] = &**parts;
            of('+', Tree::Minus(Box::new(rewritten(right))), left.clone())
        }
        Tree::Of('+', parts) => of('+', parts[1].clone(), rewritten(&parts[0])),
        other => other.clone(),
    }
}

/// The formula with what the hypotheses say of the members in it, which ask for earlier ones only.
fn solved(tree: &Tree, hypotheses: &[[Tree; 2]]) -> Tree {
    match tree {
        Tree::Member(..) => match hypotheses.iter().position(|[member, _]| member == tree) {
            Some(at) => solved(&hypotheses[at][1], &hypotheses[..at]),
            None => tree.clone(),
        },
        Tree::Of(operator, parts) => {
            of(*operator, solved(&parts[0], hypotheses), solved(&parts[1], hypotheses))
        }
        Tree::Minus(part) => Tree::Minus(Box::new(solved(part, hypotheses))),
        other => other.clone(),
    }
}

/// Whether no value asks for a member that is stated later.
fn in_order(stated: &[[Tree; 2]]) -> bool {
    let asks = |value: &Tree, member: &Tree| value.to_string().contains(&member.to_string());
    let early = |(at, [_, value]): (usize, &[Tree; 2])| {
        stated[at..].iter().any(|[later, _]| asks(value, later))
    };
    !stated.iter().enumerate().any(early)
}

/// Texts of the file, and what is known of them.
fn hypotheses(choices: &mut Choices) -> (Vec<[Tree; 2]>, Option<Vec<[Tree; 2]>>) {
    let q = |i| member(number(i, 1));
    let first = choices.of(&[name("a"), times(number(2, 1), name("b")), number(3, 1)]);
    let chain = [
        [q(0), first],
        [
            q(1),
            choices.of(&[
                times(number(3, 1), q(0)),
                of('+', q(0), name("a")),
                of('-', q(2), number(1, 1)),
            ]),
        ],
        [q(2), choices.of(&[name("b"), times(number(2, 1), q(0))])],
    ];
    let order: &[usize] =
        choices.of(&[&[0, 2, 1][..], &[0, 1, 2], &[2, 1, 0], &[1, 0, 2], &[1, 2, 0]]);
    let mut stated: Vec<[Tree; 2]> = order.iter().map(|i| chain[*i].clone()).collect();
    stated.truncate(choices.of(&[0, 1, 2, 3, 3]));
    // q[2] may ask for q[0], and q[1] for both.
    let mut sorted: Vec<[Tree; 2]> = [0, 2, 1]
        .iter()
        .map(|i| chain[*i].clone())
        .filter(|known| stated.contains(known))
        .collect();
    match choices.below(8) {
        6 => stated.push([q(0), of('+', q(1), name("b"))]),
        7 => stated.push([q(choices.of(&[0, 1])), name("b")]),
        _ => return (stated, Some(std::mem::take(&mut sorted))),
    }
    (stated, None)
}

pub fn claim(place: usize, choices: &mut Choices) -> Claim {
    let lists = [
        ("", vec![]),
        ("values = ['1', '2']", vec![1, 2]),
        ("from = '0', to = '2'", vec![0, 1, 2]),
        ("from = '2', to = '1'", vec![]),
    ];
    let (said, first) = choices.of(&lists);
    let mut cases: Vec<Vec<(String, Q)>> = vec![Vec::new()];
    let (mut names, mut indices) = (Vec::new(), String::new());
    if !said.is_empty() {
        names.push("i");
        indices = format!("{{ name = 'i', {said} }}");
        cases = first.iter().map(|i| vec![("i".to_owned(), int(*i))]).collect();
        if choices.once_in(3) {
            names.push("j");
            indices += ", { name = 'j', from = 'i', to = '2' }";
            let both = cases.iter().flat_map(|case| {
                let start: i64 = case[0].1.to_integer().try_into().expect("small");
                (start..=2).map(|j| [&case[..], &[("j".to_owned(), int(j))]].concat())
            });
            cases = both.collect();
        }
    }
    let (stated, hypotheses) = hypotheses(choices);
    // Nothing is claimed where the indices have no values.
    let doubtful = hypotheses.is_none() || !in_order(&stated) || cases.is_empty();
    let left = match choices.below(3) {
        2 => member(number(1, 1)),
        _ => polynomial(choices, &names, 2),
    };
    let mut right = rewritten(&left);
    match choices.below(6) {
        2 => right = polynomial(choices, &names, 2),
        3 => {
            let index = names.last().map_or(number(0, 1), |index| name(index));
            right = of('+', right, times(call("kronecker", &[index, number(2, 1)]), name("a")));
        }
        4 | 5 => right = solved(&right, hypotheses.as_deref().unwrap_or_default()),
        _ => {}
    }
    let stated: Vec<String> =
        stated.iter().map(|[member, value]| format!("'{member} = {value}'")).collect();
    let listed = said.starts_with("values") && names.len() == 1 && choices.once_in(2);
    let lefts = if listed { format!("['{left}', '{left}']") } else { format!("'{left}'") };
    let id = format!("equation-{place}");
    let text = format!(
        "[[equation]]\nid = '{id}'\nlocus = ''\nscheme = 's:w=1/8'\nsymbols = ['a', 'b', 'q']\n\
         hypotheses = [{}]\nindices = [{indices}]\nleft = {lefts}\nright = '{right}'\n",
        stated.join(", ")
    );
    let identity = Identity { cases, hypotheses, left, right };
    let known = Known::Identity(Box::new(identity));
    Claim { kind: "equation", id, text, known, doubtful }
}
