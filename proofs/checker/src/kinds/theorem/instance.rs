//! An instance of a theorem: one scheme and one value of each parameter.

#![warn(clippy::arithmetic_side_effects)]

use crate::claims::{OF_THEOREMS, Paper};
use crate::data::{Points, Setting};
use crate::formulas::{Scope, formula, formula_of};
use crate::numbers::Value;
use crate::schemes::{LocalRules, MAX_OFFSET, Scheme};
use crate::text::{Block, Checked, Reason, Stop, Toml, compare, require};
use std::collections::BTreeSet;
use std::rc::Rc;

/// A scheme and values of parameters for which a theorem is stated.
pub struct Instance<'a> {
    /// The scope with the parameters.
    pub scope: Scope<'a>,
    /// The factors of the scheme. A ring has none.
    pub schemes: Vec<Rc<Scheme>>,
    /// The offset at which masks are taken, if not their own.
    pub offset: Option<i64>,
    /// The rules that refine control data.
    pub setting: Setting<'a>,
}

impl<'a> Instance<'a> {
    /// Reads `scheme …` and the lines `let …`.
    pub fn read(
        paper: &'a Paper<'a>,
        claim: &'a Toml,
        block: &mut Block<'_>,
    ) -> Checked<Instance<'a>> {
        let reference = block.after("scheme")?;
        let mut values = Vec::new();
        while let Some(said) = block.maybe("let") {
            let (name, value) = said.split_once(' ').unwrap_or((said, ""));
            values.push((name.to_owned(), paper.number(value.trim())?));
        }
        Instance::new(paper, claim, reference, values)
    }

    /// The instance of a scheme that the claim lists, and of a value for each name of `values`.
    pub fn new(
        paper: &'a Paper<'a>,
        claim: &'a Toml,
        reference: &str,
        values: Vec<(String, Value)>,
    ) -> Checked<Instance<'a>> {
        let known = claim.list("schemes").iter().map(Toml::as_text).chain([claim.text("scheme")]);
        let known: Vec<&str> = known.flatten().collect();
        let same = |known: &&str| known.split_whitespace().eq(reference.split_whitespace());
        let listed = known.iter().any(same);
        compare(listed, reference, &known.join(", "), Reason::Restated)?;
        let mut scope = paper.stated();
        // The theorem defines these names, whatever the paper states.
        scope.values.retain(|name, _| !OF_THEOREMS.contains(&&name[..]));
        scope.beyond.retain(|name, _| !OF_THEOREMS.contains(&&name[..]));
        scope.reserved = &OF_THEOREMS;
        let mut left: BTreeSet<&str> = claim.names("values").collect();
        for (name, value) in values {
            let same = |text: &Toml| {
                let known =
                    paper.library.closed().value(&formula(text.as_text().unwrap_or_default())?)?;
                known.equals(&value)
            };
            let values = claim.get("values").map_or(&[][..], |values| values.list(&name));
            let same = values.iter().map(same).collect::<Result<Vec<bool>, Stop>>()?;
            let listed = left.remove(&name[..]) && same.contains(&true);
            require(listed, Reason::NotListed(name.clone()))?;
            scope.values.insert(name, value);
        }
        if let Some(name) = left.first() {
            return Err(Reason::NotListed((*name).to_owned()).into());
        }
        let (mut schemes, mut offset) = (Vec::new(), None);
        let setting = if paper.library.is_ring(reference) {
            require(claim.get("offset").is_none(), Reason::Malformed("no offset of a ring"))?;
            let ring = |reference: &str| LocalRules::new(paper.library, reference, &scope);
            let (own, earlier) =
                (ring(reference)?, claim.text("interpolant").map(ring).transpose()?);
            let alike = earlier.as_ref().is_none_or(|earlier| earlier.names == own.names);
            require(alike, Reason::Malformed("an interpolant of the same points"))?;
            Setting::LocalRules(Box::new(own), earlier.map(Box::new))
        } else {
            let plain = claim.get("interpolant").is_none();
            require(plain, Reason::Malformed("no interpolant of masks"))?;
            schemes = paper.library.resolve(reference, &scope)?;
            let said = claim.text("offset").map(|text| scope.value(&formula(text)?)).transpose()?;
            offset = said.map(|offset| offset.integer(MAX_OFFSET)).transpose()?;
            scope.scheme = schemes.first().map(Rc::clone);
            Setting::masks(paper.library, &schemes, offset)?
        };
        if let Some(supposed) = claim.get("supposes") {
            let of = |key| scope.value(&formula_of(supposed, key)?);
            let (value, below) = (of("value")?, of("below")?);
            compare(value.compare(&below)?.is_lt(), &value, &below, Reason::Supposed)?;
        }
        Ok(Instance { scope, schemes, offset, setting })
    }
}

/// The first level that a bound is stated for.
pub fn first_level(claim: &Toml) -> Result<u32, Stop> {
    match claim.text("from") {
        None if claim.text("bounds") == Some("depth") => Ok(0),
        from => {
            from.and_then(|from| from.parse().ok()).ok_or(Stop::Wrong("`from` is no level".into()))
        }
    }
}

/// Where a theorem has the points of a level. Differences are the same wherever these are.
pub fn points(claim: &Toml) -> Checked<Points> {
    if claim.text("bounds") == Some("difference") {
        return Ok(Points::Indexed);
    }
    match claim.text("parameters") {
        None | Some("indexed") => Ok(Points::Indexed),
        Some("natural") => {
            let place = ["offset", "interpolant"].iter().find(|key| claim.get(key).is_some());
            require(place.is_none(), Reason::Malformed("one place of the points"))?;
            Ok(Points::Natural)
        }
        Some(_) => Err(Reason::Malformed("natural or indexed parameters").into()),
    }
}
