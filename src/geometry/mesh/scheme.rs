//! The schemes that whole meshes are refined by.

use crate::scheme::split_name;
use crate::suggestion::known;

/// A scheme for polygon meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshScheme {
    /// Catmull and Clark 1978. Faces of any number of vertices become quadrilaterals.
    CatmullClark,
    /// The rules of the boundary of Bajaj's solids: Catmull–Clark's, but for the vertices.
    Bajaj,
    /// Doo and Sabin 1978, without rules for the boundary: the mesh shrinks there.
    DooSabin,
    /// Loop 1987, on triangles.
    Loop,
    /// Loop's scheme with the rational weights of Warren 1995: β = 3/16 for valence 3, else 3/(8N).
    LoopWarren,
}

impl MeshScheme {
    /// All schemes.
    pub const ALL: [MeshScheme; 5] = [
        MeshScheme::CatmullClark,
        MeshScheme::Bajaj,
        MeshScheme::DooSabin,
        MeshScheme::Loop,
        MeshScheme::LoopWarren,
    ];

    /// The name, which is that of the rules in the catalogue.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            MeshScheme::CatmullClark => "catmull-clark",
            MeshScheme::Bajaj => "bajaj",
            MeshScheme::DooSabin => "doo-sabin",
            MeshScheme::Loop => "loop",
            MeshScheme::LoopWarren => "loop-warren",
        }
    }

    /// Whether its faces are triangles at every level.
    pub(crate) fn is_triangular(self) -> bool {
        matches!(self, MeshScheme::Loop | MeshScheme::LoopWarren)
    }

    /// Whether it has the rules of Catmull and Clark but for the weights of vertices, so that regular pieces are bicubic.
    pub(crate) fn is_bicubic(self) -> bool {
        matches!(self, MeshScheme::CatmullClark | MeshScheme::Bajaj)
    }

    /// The scheme of this name.
    ///
    /// # Errors
    /// When there is none; the message lists the known names.
    ///
    /// ```
    /// use subcert::mesh::MeshScheme;
    ///
    /// assert_eq!(MeshScheme::parse("loop"), Ok(MeshScheme::Loop));
    /// assert!(MeshScheme::parse("catmul-clark").unwrap_err().contains("did you mean `catmull-clark`?"));
    /// ```
    pub fn parse(text: &str) -> Result<MeshScheme, String> {
        let names = MeshScheme::ALL.map(MeshScheme::name);
        let found = MeshScheme::ALL.into_iter().find(|scheme| scheme.name() == text);
        found.ok_or_else(|| {
            let name = split_name(text).0;
            let valence = if names.contains(&name) {
                format!("; a mesh has its own valences: write `{name}`")
            } else {
                known(text, names)
            };
            format!("no scheme for meshes is called `{text}`{valence}")
        })
    }
}
