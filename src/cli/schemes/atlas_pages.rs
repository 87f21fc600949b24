//! `subcert atlas --format html`: an index of schemes, a page for each entry of the catalogue, and the pages of audits that
//! they link to.

use super::words::{continuity, hoelder, proved, sheet};
use crate::cli::arguments::{AtlasArguments, BOXES};
use crate::cli::console::destination::plain;
use crate::cli::console::lattice::smoothness_words;
use crate::cli::console::output::{Failure, Outcome};
use crate::cli::console::progress::Progress;
use crate::cli::papers::judged::{judge_all, papers};
use crate::cli::papers::pages::{INDEX, folder, tell, write, write_pages};
use crate::cli::spectrum::table::{of_mask, ring_table};
use std::collections::BTreeMap;
use subcert::audit::{PaperAudit, on_all_cores};
use subcert::claim::SmoothnessBody;
use subcert::exact::Rational;
use subcert::facts::{AtlasEntry, Drawing, FamilyDrawing, SchemeFacts};
use subcert::report::html::{
    AtlasRow, EntryPage, Picture, Plot, SchemeSection, atlas_page, entry_page,
};
use subcert::report::json::FactsForm;
use subcert::scheme::{Reference, SchemeDefinition};
use subcert::spectrum::table::{Language, RealType};

/// The folder of the pages of audits, within that of the atlas.
const AUDITS: &str = "audits";

/// The languages of the code on a page.
const LANGUAGES: [Language; 3] = [Language::C, Language::Rust, Language::Python];

pub(crate) fn pages(arguments: &AtlasArguments, entries: &[AtlasEntry]) -> Outcome {
    let folder = folder(arguments.file.as_deref())?;
    let mut files = BTreeMap::new();
    for (entry, _) in entries {
        if let Some(other) = files.insert(plain(&entry.name), &entry.name) {
            return Err(Failure::Input(format!(
                "the pages of `{other}` and `{}` would have one name: write them into two folders",
                entry.name
            )));
        }
    }
    let papers = if arguments.claims.is_empty() { Vec::new() } else { papers(&arguments.claims)? };
    let audits = judge_all(&papers, true)?;
    let progress = Progress::of_schemes(entries.len(), true);
    let made = on_all_cores(entries, |(entry, references)| {
        let page = page(entry, references, &audits);
        progress.step();
        page
    });
    drop(progress);
    let mut rows = Vec::new();
    for made in made {
        let (of_entry, page) = made?;
        write(folder, &plain(&page.name), &entry_page(&page))?;
        rows.extend(of_entry);
    }
    write(folder, INDEX, &atlas_page(&rows))?;
    if !audits.is_empty() {
        write_pages(&audits, None, false, &folder.join(AUDITS))?;
    }
    tell(folder, entries.len(), " of schemes")
}

fn page(
    entry: &SchemeDefinition,
    references: &[String],
    audits: &[PaperAudit<'_>],
) -> Result<(Vec<AtlasRow>, EntryPage), Failure> {
    let (mut rows, mut schemes) = (Vec::new(), Vec::new());
    for scheme in references {
        let facts = SchemeFacts::of(scheme)?;
        let form = FactsForm::of(scheme, &facts);
        let pictures = Plot::of(scheme, &Drawing::of_facts(scheme, &facts)?).pictures();
        let valences = form.valences.iter().flatten().map(|one| one.valence);
        let valences = valences.clone().min().zip(valences.max());
        let code = LANGUAGES.map(|language| {
            (language.name().to_owned(), code(scheme, language, valences.unwrap_or((0, 0))))
        });
        rows.push(AtlasRow {
            name: plain(&entry.name),
            scheme: scheme.clone(),
            title: entry.title.clone(),
            cells: cells(&form),
        });
        schemes.push(SchemeSection {
            scheme: scheme.clone(),
            facts: sheet(&form, None),
            pictures,
            code: code.to_vec(),
        });
    }
    let parameters = entry.parameters.iter();
    let page = EntryPage {
        name: entry.name.clone(),
        title: entry.title.clone(),
        source: entry.citation.clone(),
        parameters: parameters.map(|(name, spec)| (name.clone(), spec.about.clone())).collect(),
        family: family(&entry.name),
        schemes,
        claims: claims(&entry.name, audits),
    };
    Ok((rows, page))
}

/// Where the family is smooth.
fn family(name: &str) -> Vec<Picture> {
    let side = || [-1, 1].map(Rational::from);
    let Some(found) = FamilyDrawing::of(name, &[side(), side()], BOXES) else { return Vec::new() };
    let drawing = Drawing { curve: None, lattice: None, family: Some(found), rings: Vec::new() };
    Plot::of(name, &drawing).pictures()
}

fn code(scheme: &str, language: Language, valences: (usize, usize)) -> Result<String, String> {
    let real = RealType::F64;
    match of_mask(scheme, language, real) {
        Ok(Some(text)) => Ok(text),
        // Rules without a valence have a table.
        Ok(None) => {
            ring_table(scheme, valences, language, real, &|| {}).map_err(|error| error.to_string())
        }
        Err(_) => Err("it has no table".to_owned()),
    }
}

/// The cells of a scheme in the index, with the keys by which they are sorted.
fn cells(form: &FactsForm) -> Vec<(String, String)> {
    let number = |n: usize| (n.to_string(), n.to_string());
    let none = || ("–".to_owned(), String::new());
    if let Some(curve) = &form.curve {
        let kind = if curve.interpolating { "interpolating" } else { "approximating" };
        // A divergent scheme is below C^0.
        let order = match (curve.continuity, curve.continuity_fails) {
            (Some(m), _) => m.to_string(),
            (None, Some(0)) => "-1".to_owned(),
            (None, _) => String::new(),
        };
        let exponent = curve.hoelder.as_ref().map(|found| found.lower.clone());
        return vec![
            number(curve.arity),
            number(curve.points),
            (kind.to_owned(), kind.to_owned()),
            (continuity(curve), order),
            (hoelder(curve), exponent.unwrap_or_default()),
            ("curves".to_owned(), "curves".to_owned()),
        ];
    }
    if let Some(mask) = &form.lattice {
        let kind = if mask.interpolating { "interpolating" } else { "approximating" };
        let order = match (mask.smoothness.continuity, mask.smoothness.continuity_fails) {
            (Some(m), _) => m.to_string(),
            (None, Some(0)) => "-1".to_owned(),
            (None, _) => String::new(),
        };
        let exponent = mask.smoothness.hoelder.as_ref().map(|found| found.lower.clone());
        let words = smoothness_words(&mask.smoothness, mask.smoothness.accuracy);
        let [limits, hoelder] = [0, 1].map(|i: usize| words[i].1.clone());
        let dimension = format!("Z^{}", mask.dilation.len());
        return vec![
            number(mask.arity),
            number(mask.coefficients),
            (kind.to_owned(), kind.to_owned()),
            (limits, order),
            (hoelder, exponent.unwrap_or_default()),
            (dimension.clone(), dimension),
        ];
    }
    let valences = form.valences.as_deref().unwrap_or_default();
    let (proved, smooth) = proved(valences);
    let key = if proved == valences.len() { "1" } else { "" };
    let surfaces = ("surfaces".to_owned(), "surfaces".to_owned());
    vec![none(), none(), none(), (smooth, key.to_owned()), none(), surfaces]
}

/// What claims say of the entry: their verdicts, and their addresses.
fn claims(name: &str, audits: &[PaperAudit<'_>]) -> Vec<(String, String)> {
    let of = |reference: &Reference| reference.names().any(|known| known == name);
    let mut found = Vec::new();
    for audit in audits {
        let paper = audit.paper;
        let smooth = paper.smoothness.iter().filter_map(|claim| match &claim.body {
            SmoothnessBody::Statement(scheme, _) => of(&scheme.reference).then_some(&claim.id),
            SmoothnessBody::NotCheckable(_) => None,
        });
        let tables = paper.tables.iter().filter_map(|table| {
            table.scheme.as_ref().filter(|scheme| of(&scheme.reference)).map(|_| &table.id)
        });
        let ids: Vec<&String> = smooth.chain(tables).collect();
        for claim in audit.claims().iter().filter(|claim| ids.iter().any(|id| *id == claim.id)) {
            let verdicts: Vec<String> = claim
                .verdicts
                .iter()
                .map(|(verdict, count)| match count {
                    1 => verdict.into(),
                    _ => format!("{verdict} {count} times"),
                })
                .collect();
            let text =
                format!("{}, {}: {}", paper.bibliography.short(), claim.locus, verdicts.join(", "));
            found.push((text, format!("{AUDITS}/{}.html#{}", paper.key, claim.id)));
        }
    }
    found
}
