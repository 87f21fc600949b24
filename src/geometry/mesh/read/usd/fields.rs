//! The fields of a mesh.

use super::prims::{Field, Prim};
use super::tokens::{Kind, Token};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Rational, parse_rational};
use crate::mesh::crease::{Boundary, Sharpness};
use crate::mesh::read::assemble::{Extras, Parts, Tag};
use crate::mesh::read::binary::natural;
use std::ops::Range;
use std::sync::Arc;

/// The fields of a mesh that are read, and those that say nothing of its surface.
const PASSED_OVER: [&str; 7] = [
    "doubleSided",
    "extent",
    "purpose",
    "visibility",
    "proxyPrim",
    "facevaryinglinearinterpolation",
    "primvars:displaycolor",
];

/// The fields of the mesh, and what is made of them.
pub(super) struct Fields<'a> {
    pub(super) source: &'a Arc<SourceText>,
    pub(super) prim: &'a Prim,
}

/// Numbers with their places.
type Placed<T> = Vec<(T, Range<usize>)>;

impl Fields<'_> {
    fn text(&self, token: &Token) -> &str {
        &self.source.text[token.place.clone()]
    }

    fn wrong(&self, place: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, place, message)
    }

    fn field(&self, name: &str) -> Result<Option<&Field>, Diagnostic> {
        let sampled = format!("{name}.timeSamples");
        if let Some(field) = self.prim.fields.get(&sampled) {
            let message = format!("`{name}` changes with time");
            return Err(self
                .wrong(field.name.clone(), message)
                .with_help("save one time: `name = value` in place of time samples"));
        }
        Ok(self.prim.fields.get(name))
    }

    /// A list of tuples of `size` numbers, or of numbers for `size` 1.
    fn tuples(&self, name: &str, size: usize) -> Result<Placed<Vec<Rational>>, Diagnostic> {
        let Some(field) = self.field(name)? else { return Ok(Vec::new()) };
        let (mut all, mut open): (Placed<Vec<Rational>>, Option<usize>) = (Vec::new(), None);
        let mut tuple = Vec::new();
        for token in &field.value {
            match token.kind {
                Kind::Word => {
                    let number = parse_rational(self.text(token)).map_err(|error| {
                        self.wrong(token.place.clone(), error.to_string())
                            .with_help("write a decimal such as -0.25 or 2.5e-3")
                    })?;
                    if size == 1 {
                        all.push((vec![number], token.place.clone()));
                    } else {
                        tuple.push(number);
                    }
                }
                Kind::Sign(b',') => {}
                Kind::Sign(b'(') if size > 1 && open.is_none() => open = Some(token.place.start),
                Kind::Sign(b')') if open.is_some() && tuple.len() == size => {
                    let place = open.take().unwrap_or(0)..token.place.end;
                    all.push((std::mem::take(&mut tuple), place));
                }
                _ => {
                    let message = format!("`{name}` is a list of tuples of {size}");
                    return Err(self.wrong(token.place.clone(), message));
                }
            }
        }
        if !tuple.is_empty() || open.is_some() {
            let message = format!("`{name}` ends within a tuple of {size} numbers");
            return Err(self.wrong(field.name.clone(), message));
        }
        Ok(all)
    }

    fn naturals(&self, name: &str) -> Result<Placed<usize>, Diagnostic> {
        let all = self.tuples(name, 1)?.into_iter();
        all.map(|(number, place)| {
            natural(&number[0]).map(|number| (number, place.clone())).ok_or_else(|| {
                self.wrong(place, format!("a number of `{name}` is no natural number"))
            })
        })
        .collect()
    }

    /// The only word or text of a field.
    fn choice(&self, name: &str) -> Result<Option<(&str, Range<usize>)>, Diagnostic> {
        let field = self.field(name)?;
        let token = field.and_then(|field| field.value.first());
        Ok(token.map(|token| (self.text(token), token.place.clone())))
    }

    pub(super) fn put(&self, parts: &mut Parts) -> Result<(), Diagnostic> {
        for (point, place) in self.tuples("points", 3)? {
            let point = <[Rational; 3]>::try_from(point);
            parts.point(point.expect("three numbers"), place)?;
        }
        let turned = match self.choice("orientation")? {
            Some(("leftHanded", _)) => true,
            None | Some(("rightHanded", _)) => false,
            Some((other, place)) => {
                return Err(self.wrong(place, format!("`{other}` is no orientation")));
            }
        };
        let counts = self.naturals("faceVertexCounts")?;
        let sizes: Vec<usize> = counts.iter().map(|(count, _)| *count).collect();
        let total = sizes.iter().try_fold(0_usize, |sum, size| sum.checked_add(*size));
        let indices = self.naturals("faceVertexIndices")?;
        if total != Some(indices.len()) {
            let message = format!(
                "{} of `faceVertexIndices`, and `faceVertexCounts` has the sum {}",
                indices.len(),
                total.map_or("of too large numbers".to_owned(), |total| total.to_string())
            );
            let place = self.prim.fields.get("faceVertexIndices").map(|field| field.name.clone());
            return Err(self
                .wrong(place.unwrap_or(self.prim.place.clone()), message)
                .with_help("the file is cut off, or a number is missing"));
        }
        let mut at = 0;
        for (size, place) in &counts {
            let own = &indices[at..at + size];
            at += size;
            let mut vertices: Vec<usize> = own.iter().map(|(vertex, _)| *vertex).collect();
            turn(&mut vertices, turned);
            let place = match own {
                [first, .., last] => first.1.start..last.1.end,
                _ => place.clone(),
            };
            parts.face(vertices, place)?;
        }
        self.tags(&mut parts.extras)?;
        self.texture(&mut parts.extras, &sizes, &indices, turned)?;
        let read = |name: &str| {
            name.starts_with("crease")
                || name.starts_with("corner")
                || name.starts_with("faceVertex")
                || name.starts_with("xformOp")
                || [
                    "points",
                    "holeIndices",
                    "interpolateBoundary",
                    "orientation",
                    "subdivisionScheme",
                ]
                .contains(&name)
                || ["triangleSubdivisionRule", "faceVaryingLinearInterpolation"].contains(&name)
                || name.starts_with("primvars:st")
                || PASSED_OVER.iter().any(|passed| passed.eq_ignore_ascii_case(name))
        };
        let dropped = self.prim.fields.keys().filter(|name| !read(name));
        let dropped: Vec<&str> = dropped.map(String::as_str).take(10).collect();
        if !dropped.is_empty() {
            parts.extras.notes.push(format!("these fields are dropped: {}", dropped.join(", ")));
        }
        Ok(())
    }

    fn tags(&self, extras: &mut Extras) -> Result<(), Diagnostic> {
        // OpenUSD's fallback is edgeAndCorner.
        extras.rules.boundary = match self.choice("interpolateBoundary")? {
            None | Some(("edgeAndCorner", _)) => Boundary::Corner,
            Some(("edgeOnly", _)) => Boundary::Edge,
            Some(("none", _)) => Boundary::None,
            Some((other, place)) => {
                return Err(self
                    .wrong(place, format!("`{other}` is no rule at the boundary"))
                    .with_help("write \"none\", \"edgeOnly\" or \"edgeAndCorner\""));
            }
        };
        match self.choice("triangleSubdivisionRule")? {
            None | Some(("catmullClark", _)) => {}
            Some((_, place)) => {
                return Err(self
                    .wrong(place, "only the triangle rule `catmullClark` is supported")
                    .with_help("remove the field"));
            }
        }
        let scheme = self.choice("subdivisionScheme")?;
        extras.scheme = scheme.map(|(scheme, _)| scheme.to_owned());
        let sharp = |name: &str| -> Result<Placed<Option<Sharpness>>, Diagnostic> {
            let all = self.tuples(name, 1)?.into_iter();
            all.map(|(number, place)| {
                if number[0].sign() < 0 {
                    return Err(self.wrong(place, "a sharpness below 0"));
                }
                Ok((Sharpness::new(&number[0]), place))
            })
            .collect()
        };
        let (ends, lengths) = (self.naturals("creaseIndices")?, self.naturals("creaseLengths")?);
        let sharps = sharp("creaseSharpnesses")?;
        let wrong = |name: &str, message: &str| {
            let field = self.prim.fields.get(name);
            let place = field.map_or(self.prim.place.clone(), |field| field.name.clone());
            self.wrong(place, message)
        };
        let total = lengths.iter().try_fold(0_usize, |sum, (length, _)| sum.checked_add(*length));
        if total != Some(ends.len()) || lengths.iter().any(|(length, _)| *length < 2) {
            return Err(wrong(
                "creaseLengths",
                "the lengths have the sum of `creaseIndices`, and are 2 or more",
            ));
        }
        let edges = ends.len() - lengths.len();
        if sharps.len() != lengths.len() && sharps.len() != edges {
            let message = "a sharpness for each crease, or one for each of its edges, is expected";
            return Err(wrong("creaseSharpnesses", message));
        }
        let (mut at, mut edge) = (0, 0);
        for (crease, (length, _)) in lengths.iter().enumerate() {
            for pair in ends[at..at + length].windows(2) {
                let which = if sharps.len() == lengths.len() { crease } else { edge };
                let place = pair[0].1.start..pair[1].1.end;
                extras
                    .tags
                    .push((Tag::Crease([pair[0].0, pair[1].0], sharps[which].0.clone()), place));
                edge += 1;
            }
            at += length;
        }
        let (corners, sharps) = (self.naturals("cornerIndices")?, sharp("cornerSharpnesses")?);
        if corners.len() != sharps.len() {
            return Err(wrong(
                "cornerSharpnesses",
                "a sharpness for each of `cornerIndices` is expected",
            ));
        }
        for ((vertex, place), (sharp, _)) in corners.into_iter().zip(sharps) {
            extras.tags.push((Tag::Corner(vertex, sharp), place));
        }
        for (face, place) in self.naturals("holeIndices")? {
            extras.tags.push((Tag::Hole(face), place));
        }
        Ok(())
    }

    /// `primvars:st`, of vertices or of vertices of faces, with `primvars:st:indices` or without.
    fn texture(
        &self,
        extras: &mut Extras,
        sizes: &[usize],
        vertices: &Placed<usize>,
        turned: bool,
    ) -> Result<(), Diagnostic> {
        let Some(field) = self.field("primvars:st")? else { return Ok(()) };
        extras.texture = self.tuples("primvars:st", 2)?;
        let about: Vec<&str> = field.about.iter().map(|token| self.text(token)).collect();
        let place = about.iter().position(|word| *word == "interpolation");
        let interpolation = place.and_then(|place| about.get(place + 2)).copied();
        let given: Vec<usize> =
            self.naturals("primvars:st:indices")?.into_iter().map(|(index, _)| index).collect();
        let own: Vec<usize> = match interpolation {
            Some("faceVarying") => (0..vertices.len()).collect(),
            Some("vertex" | "varying") => vertices.iter().map(|(vertex, _)| *vertex).collect(),
            _ => {
                let message =
                    "texture coordinates need `interpolation = \"faceVarying\"` or `\"vertex\"`";
                return Err(self
                    .wrong(field.name.clone(), message)
                    .with_help("or remove the field"));
            }
        };
        let value = |own: usize| if given.is_empty() { Some(own) } else { given.get(own).copied() };
        let Some(values) = own.into_iter().map(value).collect::<Option<Vec<usize>>>() else {
            let message = "`primvars:st:indices` has too few numbers";
            return Err(self.wrong(field.name.clone(), message));
        };
        let mut at = 0;
        for size in sizes {
            let mut face = values[at..at + size].to_vec();
            turn(&mut face, turned);
            extras.textured.push(Some(face));
            at += size;
        }
        Ok(())
    }
}

/// The opposite order around a face, from the same vertex on.
fn turn(face: &mut [usize], turned: bool) {
    if let Some(rest) = face.get_mut(1..).filter(|_| turned) {
        rest.reverse();
    }
}
