//! The page of `subcert smoothness` about a vertex or a face: the characteristic ring.

use super::finding::Picture;
use crate::characteristic::Vertex;
use crate::report::html::picture::ring;

impl Picture {
    /// The characteristic ring with lines of constant parameters in all sectors, and the places of the least Jacobian or of its
    /// two signs; `None` where there is no ring in the plane.
    ///
    /// ```
    /// use subcert::characteristic::Vertex;
    /// use subcert::report::html::Picture;
    ///
    /// assert!(Picture::of_ring(&Vertex::of("doo-sabin:n=5", None)?).is_some());
    /// # Ok::<(), subcert::spectrum::SpectrumError>(())
    /// ```
    #[must_use]
    pub fn of_ring(vertex: &Vertex) -> Option<Picture> {
        ring(vertex).map(|panel| Picture(panel.figure()))
    }
}
