//! Masks along one axis for curves, and along two for surfaces.

use super::mask::Mask;
use crate::exact::Rational;

/// The greatest number of axes.
pub(super) const MAX_AXES: usize = 2;

/// One thing for each axis of the indices.
#[derive(Clone, Debug, PartialEq)]
pub enum Axes<T> {
    /// One axis, of a scheme for curves.
    Curve(T),
    /// Two axes, of a tensor product for surfaces.
    Tensor(T, T),
}

/// A scheme for curves, or the tensor product of two for surfaces: a mask along each axis.
pub type Scheme<S = Rational> = Axes<Mask<S>>;

impl<T> Axes<T> {
    /// As many axes as there are things.
    ///
    /// # Panics
    /// When there are none, or more than two.
    #[must_use]
    pub fn of(axes: Vec<T>) -> Axes<T> {
        let count = axes.len();
        let mut axes = axes.into_iter();
        match (axes.next(), axes.next(), axes.next()) {
            (Some(only), None, _) => Axes::Curve(only),
            (Some(first), Some(second), None) => Axes::Tensor(first, second),
            _ => panic!("{count} axes; there are one or two"),
        }
    }

    /// The thing of the first axis.
    #[must_use]
    pub fn first(&self) -> &T {
        let (Axes::Curve(first) | Axes::Tensor(first, _)) = self;
        first
    }

    /// The thing of the only axis; `None` where there are two.
    #[must_use]
    pub fn only(&self) -> Option<&T> {
        if let Axes::Curve(only) = self { Some(only) } else { None }
    }

    /// The things, axis by axis.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        let second = if let Axes::Tensor(_, second) = self { Some(second) } else { None };
        std::iter::once(self.first()).chain(second)
    }

    /// The things of two axes; those of a single one serve both.
    #[must_use]
    pub fn pair(self) -> [T; 2]
    where
        T: Clone,
    {
        match self {
            Axes::Curve(only) => [only.clone(), only],
            Axes::Tensor(first, second) => [first, second],
        }
    }

    /// What `f` makes of each.
    #[must_use]
    pub fn map<'a, U>(&'a self, mut f: impl FnMut(&'a T) -> U) -> Axes<U> {
        match self {
            Axes::Curve(only) => Axes::Curve(f(only)),
            Axes::Tensor(first, second) => Axes::Tensor(f(first), f(second)),
        }
    }
}

impl<S> Scheme<S> {
    /// The masks, axis by axis.
    #[must_use]
    pub fn masks(&self) -> Vec<&Mask<S>> {
        self.iter().collect()
    }
}

/// The mask of a scheme for curves.
impl TryFrom<Scheme> for Mask {
    type Error = Scheme;
    fn try_from(scheme: Scheme) -> Result<Mask, Scheme> {
        match scheme {
            Scheme::Curve(mask) => Ok(mask),
            tensor @ Scheme::Tensor(..) => Err(tensor),
        }
    }
}
