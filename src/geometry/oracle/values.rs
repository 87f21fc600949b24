//! All reference values of a scheme, as plain data.

use super::control::Control;
use super::header::{COLUMNS, Header, MaskShape, SCHEMA, program};
use super::refine::{Boundary, OracleError, refine_grid, refine_polygon};
use crate::bound::{Constants, Operator, Order, Terms, displacement, surface_factor};
use crate::exact::{Enclosed, Integer, Rational, format};
use crate::float::{hexadecimal, nearest, shortest};
use crate::scheme::{Mask, Rules, Scheme};
use serde::Serialize;
use std::fmt::Display;

/// The number of significant digits of the decimals: enough to distinguish any two f64.
const DECIMAL_DIGITS: u32 = 17;

/// The input of [`reference_values`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OracleRequest {
    /// The name of the scheme for the header, such as `four-point:w=1/17`.
    pub scheme: String,
    /// The greatest c of T_c and Λ_c.
    pub max_block: u32,
    /// A polygon for a curve, a grid for a tensor product.
    pub control: Control,
    /// The number of refinements.
    pub level: u32,
    /// Whether the control polygon or grid is closed.
    pub boundary: Boundary,
}

/// Reference values, with a header.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct OracleValues {
    /// The version of this format.
    pub schema: u32,
    /// What was computed.
    pub header: Header,
    /// The values, one group for each quantity.
    pub groups: Vec<Group>,
}

/// The values of one quantity.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Group {
    /// `mask`, `difference-mask`, `contraction-constant`, `scheme-norm`, `displacement`,
    /// `control`, `refined`; for a tensor product the first five begin with `first-` or
    /// `second-`, and `surface-factor` is added. A ring has `weights` in place of the two masks.
    /// For control points with several coordinates, the groups are `control-1`, `refined-1`,
    /// `control-2`, and so on. A mask on Z^d has `limit` too, and the place of the first entry of `mask`, `control`, `refined` and `limit` in groups whose
    /// names end with `-first`.
    pub quantity: String,
    /// The formula of the quantity, and the meaning of its indices.
    pub about: &'static str,
    /// The number of values of each index.
    pub shape: Vec<usize>,
    /// The values, the last index running fastest.
    pub values: Vec<Value>,
}

/// One exact value in four forms.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Value {
    /// Its indices, as the formula of the group counts them.
    pub index: Vec<usize>,
    /// p/q in lowest terms, an integer, or a sum of cosines as a formula.
    pub exact: String,
    /// 17 significant digits, correctly rounded, half to even.
    pub decimal: String,
    /// The nearest f64, half to even, as the shortest decimal that is read as this f64.
    pub f64: String,
    /// The same f64 in hexadecimal, as `%a` of C99 prints it.
    pub hex: String,
}

impl Value {
    fn new(index: Vec<usize>, value: &(impl Enclosed + Display)) -> Value {
        let near = nearest(value);
        Value {
            index,
            exact: value.to_string(),
            decimal: format::scientific(value, DECIMAL_DIGITS),
            f64: shortest(near),
            hex: hexadecimal(near),
        }
    }
}

impl OracleValues {
    /// The group of this quantity.
    #[must_use]
    pub fn group(&self, quantity: &str) -> Option<&Group> {
        self.groups.iter().find(|group| group.quantity == quantity)
    }
}

/// The reference values of a scheme: its masks and difference masks, T_c and Λ_c (in the
/// adjoint order, which gives sound bounds), σ at the offset of the mask, the control
/// polygon or grid, and its refinement.
///
/// # Errors
/// When there are too many residue classes or values, the level is too high, or the
/// control does not fit the scheme or its boundary.
///
/// ```
/// use subcert::oracle::{Boundary, Control, OracleRequest, reference_values};
/// use subcert::scheme::parse_scheme;
///
/// let request = OracleRequest {
///     scheme: "four-point:w=1/17".to_owned(),
///     max_block: 2,
///     control: Control::seeded_polygon(1, 6),
///     level: 3,
///     boundary: Boundary::Closed,
/// };
/// let values = reference_values(&parse_scheme(&request.scheme)?, &request)?;
/// let mask = values.group("mask").unwrap();
/// assert_eq!(mask.shape, [2, 4]);
/// assert_eq!(mask.values[5].exact, "19/34");
/// assert_eq!(mask.values[5].hex, "0x1.1e1e1e1e1e1e2p-1");
/// assert_eq!(values.group("refined").unwrap().values.len(), 48);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reference_values(
    scheme: &Scheme,
    request: &OracleRequest,
) -> Result<OracleValues, OracleError> {
    let control = &request.control;
    let refined = refine(scheme, request)?;
    let mut groups = Vec::new();
    match scheme {
        Scheme::Curve(mask) => constants("", mask, request.max_block, &mut groups)?,
        Scheme::Tensor(first, second) => {
            constants("first-", first, request.max_block, &mut groups)?;
            constants("second-", second, request.max_block, &mut groups)?;
            let factor = surface_factor(first, second);
            groups.push(group("surface-factor", SURFACE_FACTOR, &[], 0, &[factor]));
        }
    }
    let shape = |count: usize, columns: usize| {
        if control.is_grid() { vec![count / columns, columns] } else { vec![count] }
    };
    let given = shape(control.values().len(), control.columns());
    for ((number, values), (refined, columns)) in control.named_coordinates().zip(&refined) {
        groups.push(group(&format!("control{number}"), CONTROL, &given, 0, values));
        let shape = shape(refined.len(), *columns);
        groups.push(group(&format!("refined{number}"), REFINED, &shape, 0, refined));
    }
    Ok(OracleValues { schema: SCHEMA, header: header(scheme, request), groups })
}

const MASK: &str = "a[alpha][j]: x'[n*i+alpha] = sum over j of a[alpha][j]*x[i+offset+j]";
const DIFFERENCE: &str = "b[beta][j]: the same for the differences x[i+1] - x[i]";
pub(super) const CONTRACTION: &str =
    "T_c, c = 1, 2, ...: the largest factor of the differences in c levels";
pub(super) const NORM: &str =
    "Lambda_c, c = 1, 2, ...: the largest factor of the values in c levels";
const SIGMA: &str = "sigma: the largest distance of two polygons of consecutive levels, piecewise \
                     linear in i/n^k, per unit of the largest difference";
const SURFACE_FACTOR: &str = "the same for the tensor product";
pub(super) const CONTROL: &str = "x[i], or x[i][j] of a grid: the control points of level 0";
pub(super) const REFINED: &str = "the points of the level in the header, counted from 0 here";

fn constants(
    prefix: &str,
    mask: &Mask,
    max_block: u32,
    groups: &mut Vec<Group>,
) -> Result<(), OracleError> {
    let constants = Constants::new(mask.clone());
    // The greatest c comes first, so that too many classes are refused at once.
    let norms = |operator| -> Result<Vec<Rational>, OracleError> {
        let norm = |c| Ok(constants.norm(operator, c, Order::Adjoint)?);
        let mut norms = (1..=max_block).rev().map(norm).collect::<Result<Vec<_>, OracleError>>()?;
        norms.reverse();
        Ok(norms)
    };
    let shape = [mask.arity(), mask.width()];
    let entries = |rules: &Rules| rules.rows().concat();
    let mut push = |quantity: &str, about, shape: &[usize], first, values: &[Rational]| {
        groups.push(group(&format!("{prefix}{quantity}"), about, shape, first, values));
    };
    push("mask", MASK, &shape, 0, &entries(mask.rules()));
    push("difference-mask", DIFFERENCE, &shape, 0, &entries(constants.difference()));
    for (quantity, about, operator) in [
        ("contraction-constant", CONTRACTION, Operator::Difference),
        ("scheme-norm", NORM, Operator::Scheme),
    ] {
        let values = norms(operator)?;
        push(quantity, about, &[values.len()], 1, &values);
    }
    push("displacement", SIGMA, &[], 0, &[displacement(mask, Terms::Each)]);
    Ok(())
}

/// A group whose indices start at `first`.
pub(super) fn group(
    quantity: &str,
    about: &'static str,
    shape: &[usize],
    first: usize,
    values: &[impl Enclosed + Display],
) -> Group {
    let index = |mut position: usize| {
        let mut index: Vec<usize> = Vec::with_capacity(shape.len());
        for &size in shape.iter().rev() {
            index.push(position % size + first);
            position /= size;
        }
        index.reverse();
        index
    };
    let values = values.iter().enumerate().map(|(at, value)| Value::new(index(at), value));
    let values = values.collect();
    Group { quantity: quantity.to_owned(), about, shape: shape.to_vec(), values }
}

/// The refined values of each coordinate, and their number of columns.
fn refine(
    scheme: &Scheme,
    request: &OracleRequest,
) -> Result<Vec<(Vec<Rational>, usize)>, OracleError> {
    let OracleRequest { control, level, boundary, .. } = request;
    let shape = |found, scheme, expected| Err(OracleError::Shape { found, scheme, expected });
    match scheme {
        Scheme::Curve(_) if control.is_grid() => shape("grid", "scheme for curves", "polygon"),
        Scheme::Tensor(..) if !control.is_grid() => shape("polygon", "tensor product", "grid"),
        Scheme::Curve(mask) => control
            .coordinates()
            .map(|values| Ok((refine_polygon(mask.rules(), values, *level, *boundary)?, 1)))
            .collect(),
        Scheme::Tensor(first, second) => {
            let rules = [first.rules(), second.rules()];
            let grid = control.values();
            Ok(vec![refine_grid(rules, grid, control.columns(), *level, *boundary)?])
        }
    }
}

fn header(scheme: &Scheme, request: &OracleRequest) -> Header {
    let masks = scheme.masks();
    let shape = |mask: &&Mask| MaskShape {
        arity: mask.arity(),
        width: mask.width(),
        offset: mask.offset(),
    };
    let first_index = |mask: &&Mask| match request.boundary {
        Boundary::Closed => Integer::zero(),
        Boundary::Open => (0..request.level).fold(Integer::zero(), |start, _| {
            let first = mask.rules().open_range(0).start;
            (start - Integer::from(mask.offset())) * Integer::from(mask.arity())
                + Integer::from(first)
        }),
    };
    Header {
        program: program(),
        scheme: request.scheme.clone(),
        masks: masks.iter().map(shape).collect(),
        max_block: request.max_block,
        level: request.level,
        ring: None,
        boundary: Some(match request.boundary {
            Boundary::Closed => "closed",
            Boundary::Open => "open",
        }),
        seed: request.control.seed().map(|seed| seed.to_string()),
        first_index: masks.iter().map(first_index).map(|index| index.to_string()).collect(),
        notes: Vec::new(),
        columns: COLUMNS,
    }
}
