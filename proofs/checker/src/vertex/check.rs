//! What a certificate shows of the surface at one vertex or on one face.

use super::ball::Ball;
use super::bernstein::Form;
use super::inner::Inner;
use super::lattice::Part;
use super::net::Net;
use super::pieces::{Piece, pieces};
use super::spectrum;
use crate::numbers::{Q, int, read_rational};
use crate::schemes::LocalRules;
use crate::text::{Block, Checked, Reason, Stop, agree, require, words};
use num_traits::Zero;

/// The most bisections of a piece.
const MAX_BISECTIONS: usize = 24;

/// What is shown of the surface of generic data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// It is C^m for this m.
    Smooth(usize),
    /// It is not C¹.
    Rough,
}

/// A number of a line.
fn number(text: &str) -> Checked<Q> {
    Ok(read_rational(text).ok_or(Reason::Malformed("a number"))?)
}

fn sign(text: &str) -> Checked<i8> {
    match text {
        "+" => Ok(1),
        "-" => Ok(-1),
        _ => Err(Reason::Malformed("+ or -").into()),
    }
}

/// Reads the lines from `part` on, about the rules of a ring.
pub fn check_vertex(
    ring: &LocalRules<'_>,
    valence: usize,
    block: &mut Block<'_>,
) -> Checked<Found> {
    let inner = Inner::read(ring)?;
    require(inner.order == valence, Reason::Vertex("this is the valence of the rules"))?;
    agree(block.after("part")?, inner.part.name(), Reason::Said)?;
    if block.next_word() == "diverges" {
        let [k, side] = words(block.after("diverges")?, "a block, and + or -")?;
        let k = k.parse().map_err(|_| Reason::Malformed("a block"))?;
        spectrum::diverges(&inner, k, sign(side)?.into())?;
        return Ok(Found::Rough);
    }
    if let Some(said) = block.maybe("regular") {
        require(said.is_empty(), Reason::Malformed("nothing after `regular`"))?;
        let what = "all weights are those of the regular part at its own valence";
        require(inner.is_regular_part(), Reason::Vertex(what))?;
        return Ok(Found::Smooth(2));
    }
    let [k, low, high] = words(block.after("eigenvalue")?, "a block and two numbers")?;
    let k = k.parse().map_err(|_| Reason::Malformed("a block"))?;
    let (low, high) = (number(low)?, number(high)?);
    let r = number(block.after("below")?)?;
    spectrum::check(&inner, k, [&low, &high], &r)?;
    let value = Ball::between(&low, &high);
    let net = Net::of(&inner, k, &value)?;
    let ring = pieces(&net.refined(&value)?)?;
    if k == 0 {
        // A face has no other eigenvalue of block 0.
        block.word("outer")?;
        let what = "the eigenfunction has one sign on the outer curve";
        require(has_one_sign(&net, &ring), Reason::Vertex(what))?;
        return Ok(Found::Rough);
    }
    let unit = unit(&net)?;
    let forms: Vec<Form> = ring.iter().map(|piece| jacobian(piece).scaled(&unit)).collect();
    if block.next_word() == "positive" {
        for (word, sign) in [("positive", 1), ("negative", -1)] {
            let [a, b] = words(block.after(word)?, "two numbers")?;
            let found = at(&ring, &forms, [&number(a)?, &number(b)?])?.sign();
            require(found == Some(sign), Reason::Vertex("the Jacobian has this sign there"))?;
        }
        return Ok(Found::Rough);
    }
    let side = sign(block.after("jacobian")?)?;
    for (place, form) in forms.iter().enumerate() {
        covered(block, place, form, &mut String::new(), side)?;
    }
    let negative = high < Q::zero();
    if side == 1 && k == 1 && !negative {
        let what = "the outer curve of a sector is in the half-plane";
        require(has_one_sign(&net, &ring), Reason::Vertex(what))?;
        return Ok(Found::Smooth(1));
    }
    // For λ < 0, for k ≥ 2, and for a negative Jacobian the map is not injective.
    Ok(Found::Rough)
}

/// 1 over the square of the length of the first point; 1 where that may be 0.
fn unit(net: &Net) -> Checked<Ball> {
    let [p, q] = net.at(if net.part == Part::Biquadratic { (0, 0) } else { (1, 0) })?;
    let twice = net.cosine.plus(&net.cosine);
    let square = p.times(&p).plus(&q.times(&q)).plus(&twice.times(&p.times(&q)));
    Ok(square.inverse().unwrap_or_else(|| Ball::from(1)))
}

/// p_u·q_v − p_v·q_u.
fn jacobian(piece: &Piece) -> Form {
    let [p, q] = &piece.coordinates;
    let along_v = |form: &Form| form.exchanged().along_u().exchanged();
    p.along_u().times(&along_v(q)).minus(&along_v(p).times(&q.along_u()))
}

/// Reads the boxes of a part of a piece, and checks that they cover it.
fn covered(
    block: &mut Block<'_>,
    place: usize,
    form: &Form,
    path: &mut String,
    side: i8,
) -> Checked<()> {
    block.look();
    let line = block.peek().ok_or(Reason::Malformed("box"))?;
    let words: Vec<&str> = line.text.split_whitespace().collect();
    let ["box", piece, said, rest @ ..] = &words[..] else {
        return Err(Reason::Malformed("box").into());
    };
    require(*piece == place.to_string(), Reason::Vertex("the boxes cover the pieces in order"))?;
    let said = if *said == "-" { "" } else { said };
    if said == path {
        let [least] = rest else { return Err(Reason::Malformed("a box").into()) };
        let least = number(least)?;
        require(least > Q::zero(), Reason::Vertex("a positive bound of the coefficients"))?;
        let bound = Ball::from(&least);
        for x in form.rows.iter().flatten() {
            let holds = x.sign() == Some(side) && bound.is_below(&x.least_size());
            require(
                holds,
                Reason::Vertex("the coefficients have this sign, and are above the bound"),
            )?;
        }
        block.any()?;
        return Ok(());
    }
    let inside = said.starts_with(path.as_str()) && path.len() < MAX_BISECTIONS;
    require(inside, Reason::Vertex("the boxes cover the pieces in order"))?;
    for (digit, second) in [('0', false), ('1', true)] {
        path.push(digit);
        covered(block, place, &form.half(second), path, side)?;
        path.pop();
    }
    Ok(())
}

/// The value of the Jacobian at a place on the lattice of the refined points.
fn at(ring: &[Piece], forms: &[Form], [a, b]: [&Q; 2]) -> Checked<Ball> {
    for (piece, form) in ring.iter().zip(forms) {
        let along = |x: &Q, corner: i32| (x - int(corner.into())) * int(piece.direction.into());
        let (u, v) = (along(a, piece.corner.0), along(b, piece.corner.1));
        let within = |x: &Q| *x >= Q::zero() && *x <= int(1);
        if within(&u) && within(&v) && (!form.triangle || &u + &v <= int(1)) {
            return Ok(form.at(&u, &v));
        }
    }
    Err(Stop::Undefined("no place of the ring").into())
}

/// Whether the coefficients of p + q, or on a face p + cq, have one sign on the outer curve of sector 0.
fn has_one_sign(net: &Net, ring: &[Piece]) -> bool {
    let factor = if net.part == Part::Biquadratic { net.cosine.clone() } else { Ball::from(1) };
    let (mut curve, last) = (Vec::new(), 2 * net.start - 1);
    for piece in ring {
        let [p, q] = &piece.coordinates;
        let d = p.rows.len() - 1;
        let mut add =
            |i: usize, j: usize| curve.push(p.rows[i][j].plus(&factor.times(&q.rows[i][j])));
        if p.triangle {
            if piece.direction == 1 && piece.corner.0 + piece.corner.1 == last {
                (0..=d).for_each(|i| add(i, d - i));
            }
            continue;
        }
        if piece.corner.0 == last {
            (0..=d).for_each(|j| add(d, j));
        }
        if piece.corner.1 == last {
            (0..=d).for_each(|i| add(i, d));
        }
    }
    [1, -1].iter().any(|side| curve.iter().all(|x| x.sign() == Some(*side)))
}
