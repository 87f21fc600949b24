//! The pictures of a scheme, in one file or on its page.

use super::finding::Picture;
use crate::facts::{CurveDrawing, Drawing};
use crate::report::html::picture::sample;
use crate::report::html::picture::{Panel, basic, contours, family, ring, standalone, surface};

/// The pictures of a scheme.
#[derive(Clone, Debug)]
pub struct Plot {
    title: String,
    panels: Vec<Panel>,
}

impl Plot {
    /// What is drawn of the scheme of this name, with words in place of what is not.
    ///
    /// ```
    /// use subcert::facts::Drawing;
    /// use subcert::report::html::Plot;
    ///
    /// let region = [[-1, 1].map(Into::into), [-1, 1].map(Into::into)];
    /// let svg = Plot::of("chaikin", &Drawing::of("chaikin", &region, 100)?).to_svg();
    /// assert!(svg.contains("φ″ is not drawn: not all limits are C²."));
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn of(scheme: &str, drawing: &Drawing) -> Plot {
        let mut panels = Vec::new();
        match &drawing.curve {
            Some(CurveDrawing::Rational(shape)) => {
                panels.extend([basic(scheme, shape), sample(scheme, shape)]);
            }
            Some(CurveDrawing::Algebraic(shape)) => {
                panels.extend([basic(scheme, shape), sample(scheme, shape)]);
            }
            None => {}
        }
        match &drawing.lattice {
            Some(Ok(shape)) => panels.extend([contours(scheme, shape), surface(scheme, shape)]),
            Some(Err(reason)) => {
                let title = format!("{scheme}: the basic limit function");
                panels.push(Panel::of_words(title, format!("There is no picture: {reason}.")));
            }
            None => {}
        }
        panels.extend(drawing.family.as_ref().and_then(|found| family(scheme, found)));
        for (n, found) in &drawing.rings {
            let none = |reason: String| {
                let title = format!("The characteristic ring at valence {n}");
                Panel::of_words(title, format!("There is no picture at valence {n}: {reason}."))
            };
            panels.push(match found {
                Ok(vertex) => {
                    ring(vertex).unwrap_or_else(|| none("there is no ring in the plane".to_owned()))
                }
                Err(error) => none(error.to_string()),
            });
        }
        Plot { title: format!("{scheme}, by subcert"), panels }
    }

    /// The pictures with their words as one SVG file, in light or dark as the reader has it, without a script.
    #[must_use]
    pub fn to_svg(&self) -> String {
        standalone(&self.title, &self.panels)
    }

    /// The pictures for a page.
    #[must_use]
    pub fn pictures(&self) -> Vec<Picture> {
        self.panels.iter().map(|panel| Picture(panel.figure())).collect()
    }
}
