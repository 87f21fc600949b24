//! One field for the numbers of two.

use super::element::{Field, FieldElement};
use super::error::FieldError;
use super::extension::{adjoin, image};
use crate::exact::{Rational, RationalPolynomial};
use std::cell::RefCell;
use std::sync::Arc;

/// The most pairs of fields that are kept.
const MAX_KNOWN: usize = 64;

/// The generators of two fields in a third that contains both.
#[derive(Clone)]
struct Merged {
    fields: [Arc<Field>; 2],
    images: Result<[FieldElement; 2], FieldError>,
}

thread_local! {
    /// The pairs that have met. A formula combines numbers of the same few fields again and again, and each
    /// time another root of the same polynomial generates them.
    static KNOWN: RefCell<Vec<Merged>> = const { RefCell::new(Vec::new()) };
}

/// Two numbers in one field. The number 0 may come without a field.
pub(super) fn shared(a: &FieldElement, b: &FieldElement) -> Result<[FieldElement; 2], FieldError> {
    let (Some(left), Some(right)) = (&a.field, &b.field) else {
        return Ok([a.clone(), b.clone()]);
    };
    if Arc::ptr_eq(left, right) || left.is(right) {
        return Ok([a.clone(), FieldElement::of(b.value.clone(), Some(left))]);
    }
    let [of_a, of_b] = images(left, right)?;
    Ok([image(a, &of_a), image(b, &of_b)])
}

fn images(left: &Arc<Field>, right: &Arc<Field>) -> Result<[FieldElement; 2], FieldError> {
    let is_known = |merged: &&Merged| merged.fields[0].is(left) && merged.fields[1].is(right);
    let known = KNOWN.with_borrow(|known| known.iter().find(is_known).cloned());
    if let Some(merged) = known {
        return merged.images;
    }
    let images = computed(left, right);
    let fields = [Arc::clone(left), Arc::clone(right)];
    KNOWN.with_borrow_mut(|known| {
        if known.len() == MAX_KNOWN {
            known.remove(0);
        }
        known.push(Merged { fields, images: images.clone() });
    });
    images
}

fn computed(left: &Arc<Field>, right: &Arc<Field>) -> Result<[FieldElement; 2], FieldError> {
    // Where one field contains the other, the larger one stays as it is.
    if left.degree() < right.degree() {
        return computed(right, left).map(|[a, b]| [b, a]);
    }
    let constant = |c| FieldElement::of(RationalPolynomial::constant(Rational::from(c)), None);
    let minimal = right.minimal.coefficients().iter().cloned().map(constant);
    let extension = adjoin(Some(left), &minimal.collect::<Vec<_>>(), &right.root)?;
    Ok([extension.generator, extension.root])
}

impl FieldElement {
    /// Numbers of several fields in one field.
    ///
    /// # Errors
    /// When such a field is beyond the caps.
    ///
    /// ```
    /// use subcert::exact::{FieldElement, Rational, Scalar};
    ///
    /// let root = |x: i64| {
    ///     let square = [-x, 0, 1].map(|c| FieldElement::from_rational(&Rational::from(c)));
    ///     FieldElement::root(&square, 2).expect("a square root")
    /// };
    /// let both = FieldElement::together(&[root(2), root(3), root(6)])?;
    /// let (_, minimal) = both[0].field().expect("an irrational number");
    /// assert_eq!(minimal.degree(), Some(4));
    /// assert_eq!(both[0].times(&both[1]), both[2]);
    /// # Ok::<(), subcert::exact::FieldError>(())
    /// ```
    pub fn together(numbers: &[FieldElement]) -> Result<Vec<FieldElement>, FieldError> {
        let mut one = FieldElement::of(RationalPolynomial::constant(Rational::one()), None);
        for number in numbers {
            [one, _] = shared(&one, number)?;
            one.field = one.field.or_else(|| number.field.clone());
        }
        let inside = |number: &FieldElement| {
            let [_, mut number] = shared(&one, number)?;
            number.field.clone_from(&one.field);
            Ok(number)
        };
        numbers.iter().map(inside).collect()
    }
}
