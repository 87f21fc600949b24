//! `subcert range --smoothness` in two parameters.

use super::smooth_range::lattice_order;
use crate::cli::arguments::{BOXES, RangeArguments};
use crate::cli::console::answer::{Answer, SCHEMA, show};
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use crate::cli::console::quantity::Text;
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::AtomicUsize;
use subcert::exact::{Rational, format::short, parse_rational};
use subcert::lattice::{MAP_BOXES, lattice_map};
use subcert::report::Sheet;
use subcert::scheme::{find_definition, parse_in_parameters, parse_lattice_in_parameters};
use subcert::smoothness::{
    Certain, MAX_BOXES, MapBox, Sides, SmoothMap as Computed, plane_rules, smooth_map as computed,
};

/// The characters in a row of the map, and the rows.
const PICTURE: [usize; 2] = [64, 32];

pub(crate) fn smooth_map(arguments: &RangeArguments, parameters: [&String; 2]) -> Outcome {
    let [first, second] = parameters;
    let refuse = |message: String| Err(Failure::Input(message));
    let Some(m) = arguments.smoothness else {
        return refuse("two parameters make a map of smoothness: add `--smoothness M`".to_owned());
    };
    if first == second {
        return refuse(format!("`--param {first}` is given twice; name two parameters"));
    }
    let most = arguments.boxes.unwrap_or(BOXES);
    if !(1..=MAX_BOXES).contains(&most) {
        return refuse(format!("`--boxes {most}`: from 1 to {MAX_BOXES} boxes can be examined"));
    }
    let region = region(arguments.bounds.as_deref(), parameters).map_err(Failure::Input)?;
    let map = if find_definition(&arguments.scheme)?.is_lattice() {
        of_lattice(arguments, [first, second], m, &region)?
    } else {
        of_curve(arguments, [first, second], (m, most), &region)?
    };
    let [inside, outside, open] = map.shares().map(Text);
    let state = |found: MapBox| {
        let (state, product) = match found.certain {
            Certain::Inside => ("inside", None),
            Certain::Outside(word) => ("outside", Some(word)),
            Certain::Open => ("open", None),
        };
        StateOfBox { state, sides: found.sides.map(|side| side.map(Text)), product }
    };
    let answer = SmoothMap {
        schema: SCHEMA,
        scheme: &arguments.scheme,
        parameters,
        smoothness: m,
        bounds: region.map(|side| side.map(Text)),
        shares: Shares { inside, outside, open },
        but_exceptions: map.but_exceptions,
        boxes: map.boxes.into_iter().map(state).collect(),
    };
    show(&arguments.output, &answer)
}

/// The map of a mask of curves.
fn of_curve(
    arguments: &RangeArguments,
    [first, second]: [&str; 2],
    (m, most): (usize, usize),
    region: &Sides,
) -> Result<Computed, Failure> {
    let mask = parse_in_parameters(&arguments.scheme, &[first, second])?;
    let rules = plane_rules(mask.rules(), [first, second]).map_err(|entry| {
        Failure::Input(format!(
            "the coefficient {entry} is not a rational polynomial in `{first}` and `{second}`"
        ))
    })?;
    let done = Arc::new(AtomicUsize::new(0));
    let _progress = Progress::of_boxes(Arc::clone(&done), most, true);
    computed(&rules, m, region, most, &done).map_err(|error| Failure::Input(error.to_string()))
}

/// The same of a mask on Z^d, where a box takes longer.
fn of_lattice(
    arguments: &RangeArguments,
    parameters: [&str; 2],
    m: usize,
    region: &Sides,
) -> Result<Computed, Failure> {
    let order = lattice_order(m)?;
    let mask = parse_lattice_in_parameters(&arguments.scheme, parameters)?;
    let most = arguments.boxes.unwrap_or(MAP_BOXES);
    let done = Arc::new(AtomicUsize::new(0));
    let _progress = Progress::of_boxes(Arc::clone(&done), most, true);
    lattice_map(&mask, order, region, most, &done)
        .map_err(|error| Failure::Input(error.to_string()))
}

/// The region that `a=-1..1,b=0..1/2` names.
pub(crate) fn region(text: Option<&str>, parameters: [&String; 2]) -> Result<Sides, String> {
    let mut sides = [None, None];
    for part in text.unwrap_or_default().split(',').filter(|part| !part.trim().is_empty()) {
        let wrong = |reason: &str| {
            let part = part.trim();
            let names = parameters.iter().filter(|name| !name.is_empty());
            let form: Vec<String> = names.map(|name| format!("{name}=-1..1/2")).collect();
            format!("`{part}` in `--bounds`: {reason}; write {}", form.join(","))
        };
        let (name, ends) = part.split_once('=').ok_or_else(|| wrong("there is no `=`"))?;
        let which = parameters.iter().position(|parameter| *parameter == name.trim());
        let which = which.ok_or_else(|| wrong("this is none of the parameters"))?;
        let (low, high) = ends.split_once("..").ok_or_else(|| wrong("there is no `..`"))?;
        let number = |text: &str| parse_rational(text.trim()).map_err(|e| wrong(&e.to_string()));
        let (low, high) = (number(low)?, number(high)?);
        if low >= high {
            return Err(wrong("the first end is not below the second"));
        }
        if sides[which].replace([low, high]).is_some() {
            return Err(wrong("this parameter has bounds already"));
        }
    }
    let default = || [-1, 1].map(Rational::from);
    Ok(sides.map(|side| side.unwrap_or_else(default)))
}

/// Where, in a plane of two parameters, the limits are C^m.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct SmoothMap<'a> {
    /// The version of this form.
    schema: u32,
    /// The scheme as it was given.
    scheme: &'a str,
    /// The two parameters.
    parameters: [&'a String; 2],
    /// m.
    smoothness: usize,
    /// The ends of the region, for both parameters.
    bounds: Bounds,
    /// The parts of the area.
    shares: Shares,
    /// Whether parameters outside may be exceptions: zeros of a polynomial.
    but_exceptions: bool,
    /// The boxes, which fill the region.
    boxes: Vec<StateOfBox>,
}

/// The ends of intervals of two parameters.
type Bounds = [[Text<Rational>; 2]; 2];

/// Parts of an area, which sum to 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Shares {
    /// Where all limits are C^m.
    inside: Text<Rational>,
    /// Where not all are, or the scheme diverges.
    outside: Text<Rational>,
    /// Where neither is shown.
    open: Text<Rational>,
}

/// A box of parameters.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "MapBox"))]
struct StateOfBox {
    /// `inside`, `outside` or `open`.
    state: &'static str,
    /// The ends, for both parameters.
    sides: Bounds,
    /// The factors of the product that shows that the box is outside, counted from 0; absent elsewhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    product: Option<Vec<usize>>,
}

impl SmoothMap<'_> {
    /// The rows of the map, the greatest second parameter first.
    fn picture(&self) -> Vec<String> {
        let [columns, rows] = PICTURE;
        let mut picture = vec![vec![None; columns]; rows];
        for found in &self.boxes {
            let sign = match found.state {
                "inside" => '#',
                "outside" => '.',
                _ => '?',
            };
            let [across, up] = [0, 1].map(|which| self.cells(found, which));
            for row in up {
                for column in across.clone() {
                    let cell = &mut picture[rows - 1 - row][column];
                    *cell = Some(if cell.is_none_or(|old| old == sign) { sign } else { '?' });
                }
            }
        }
        let line = |row: &Vec<Option<char>>| row.iter().map(|cell| cell.unwrap_or('?')).collect();
        picture.iter().map(line).collect()
    }

    /// The cells of the picture that a box meets, along one side.
    fn cells(&self, found: &StateOfBox, which: usize) -> std::ops::Range<usize> {
        let [Text(low), Text(high)] = &self.bounds[which];
        let [Text(from), Text(to)] = &found.sides[which];
        let scale = Rational::from(PICTURE[which]) / (high - low);
        let start = ((from - low) * &scale).floor().to_i64();
        let end = ((to - low) * &scale).ceil().to_i64();
        let place = |x: Option<i64>| x.and_then(|x| usize::try_from(x).ok()).unwrap_or(0);
        place(start)..place(end)
    }
}

impl Answer for SmoothMap<'_> {
    const NAME: &'static str = "range-smoothness-map";

    fn sheet(&self) -> Sheet {
        let [first, second] = self.parameters;
        let mut sheet =
            Sheet::titled(format!("{}: where the limits are C^{}", self.scheme, self.smoothness));
        let side = |which: usize| {
            let [Text(low), Text(high)] = &self.bounds[which];
            format!("from {low} to {high}")
        };
        let share = |state: &str, Text(share): &Text<Rational>| {
            let count = self.boxes.iter().filter(|one| one.state == state).count();
            let percent = share * Rational::from(100);
            let boxes = if count == 1 { "box" } else { "boxes" };
            (state.to_owned(), format!("{} % of the area, {count} {boxes}", short(&percent, 4)))
        };
        let facts = [
            (first.clone(), side(0)),
            (second.clone(), side(1)),
            share("inside", &self.shares.inside),
            share("outside", &self.shares.outside),
            share("open", &self.shares.open),
        ];
        sheet.facts(facts.to_vec());
        sheet.heading(2, "Map");
        sheet.facts(vec![(second.clone(), self.picture().join("\n"))]);
        sheet.text(format!(
            "# inside, . outside, ? open; {first} grows to the right, {second} upwards. A character that stands for \
             several boxes is # or . where all are."
        ));
        sheet.text(
            "Inside, all limits have this smoothness, in the whole box: by invariant hulls. Outside, at no point of the \
             box all limits have it, or the scheme diverges: a product of matrices of the differences has too large an \
             eigenvalue. Neither is shown for the open boxes.",
        );
        if self.but_exceptions {
            sheet.text(
                "Parameters outside may be exceptions where the shifts of the basic limit function are linearly \
                 dependent: these are zeros of a polynomial.",
            );
        }
        sheet
    }
}
