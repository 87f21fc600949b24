//! What somebody may have meant by a name that does not exist.

/// The least likeness, from 0 to 1, of a name that is suggested.
const ALIKE: f64 = 0.66;

/// Of more names than `MANY` those `FEW` are listed that are most like a word.
const MANY: usize = 24;
const FEW: usize = 8;

/// The known name that is most like `word`, if its likeness is at least 0.66. The likeness of two
/// names is 1 − d/l, with d the Damerau–Levenshtein distance and l the greater length, both in
/// lower case. A name that begins with the word, of 3 letters or more, has at least 0.66.
///
/// ```
/// use subcert::suggestion::nearest;
///
/// assert_eq!(nearest("six-pont", ["chaikin", "six-point"]), Some("six-point"));
/// assert_eq!(nearest("khan2019", ["khan2019-newton"]), Some("khan2019-newton"));
/// assert_eq!(nearest("loop", ["chaikin", "six-point"]), None);
/// ```
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let alike = known.into_iter().map(|name| (likeness(word, name), name));
    let alike = alike.filter(|(likeness, _)| *likeness >= ALIKE);
    // Of equally good names the first.
    alike.reduce(|best, next| if next.0 > best.0 { next } else { best }).map(|(_, name)| name)
}

fn likeness(word: &str, name: &str) -> f64 {
    let (word, name) = (word.to_lowercase(), name.to_lowercase());
    let begins = word.len() >= 3 && name.starts_with(&word);
    let likeness = strsim::normalized_damerau_levenshtein(&word, &name);
    if begins { likeness.max(ALIKE) } else { likeness }
}

/// The end of a message about an unknown name: a name that may be meant, and the known names; of more than 24 the 8 that
/// are most like it.
///
/// ```
/// use subcert::suggestion::known;
///
/// assert_eq!(known("taw", ["tau", "c"]), "; did you mean `tau`? Known: tau, c");
/// assert_eq!(known("gamma", ["tau", "c"]), "; known: tau, c");
/// ```
pub fn known<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    listed(word, names, ["known", "Known"])
}

/// As [`known`], for names that have a meaning at one place only.
///
/// ```
/// use subcert::suggestion::known_here;
///
/// assert_eq!(known_here("gamma", ["tau", "c"]), "; known here: tau, c");
/// ```
pub fn known_here<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    listed(word, names, ["known here", "Known here"])
}

/// The suggestion, if there is one, and the names after a label: `first` begins a sentence,
/// `within` does not.
fn listed<'a>(
    word: &str,
    names: impl IntoIterator<Item = &'a str>,
    [within, first]: [&str; 2],
) -> String {
    let names: Vec<&str> = names.into_iter().collect();
    let mut alike: Vec<(f64, &str)> =
        names.iter().map(|&name| (likeness(word, name), name)).collect();
    // Of equally good names the first stays the first.
    alike.sort_by(|a, b| b.0.total_cmp(&a.0));
    let all = if names.len() > MANY {
        let few: Vec<&str> = alike[..FEW].iter().map(|(_, name)| *name).collect();
        format!("{} and {} more", few.join(", "), names.len() - FEW)
    } else {
        names.join(", ")
    };
    let meant = alike.first().filter(|(likeness, _)| *likeness >= ALIKE);
    match (meant, all.is_empty()) {
        (Some((_, name)), _) => format!("; did you mean `{name}`? {first}: {all}"),
        (None, false) => format!("; {within}: {all}"),
        (None, true) => String::new(),
    }
}

/// `; did you mean …?`, or nothing if no name is like `word`.
///
/// ```
/// use subcert::suggestion::did_you_mean;
///
/// assert_eq!(did_you_mean("table-9", ["table-1", "eq-2"]), "; did you mean `table-1`?");
/// assert_eq!(did_you_mean("gamma", ["tau", "c"]), "");
/// ```
pub fn did_you_mean<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, names).map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
}
