//! The numbers of all valences as arrays.

use super::real::{Real, RealType};
use super::rows::{MAX_TABLE_WEIGHTS, Row, TableError};

/// An array of a table.
#[derive(Clone, Debug)]
pub struct Array<'a> {
    /// Its name, in letters, digits and `_`.
    pub name: &'a str,
    /// What its entries are.
    pub about: Vec<String>,
    /// The entries.
    pub entries: Entries,
}

/// The entries of an array.
#[derive(Clone, Debug)]
pub enum Entries {
    /// The same number of them in each row, such as for each valence.
    Table(Vec<Vec<Real>>),
    /// One list; a row is a part of it, such as for each valence as many as its orbits have points.
    List(Vec<Vec<Real>>),
    /// Integers.
    Integers(Vec<usize>),
    /// The same number of f64 in each row, and what is said of them behind it, such as their exact values: a table, or one list.
    Noted {
        /// The rows.
        rows: Vec<(Vec<f64>, String)>,
        /// Whether this is one list.
        list: bool,
    },
}

/// Whether no valence is missing between the first and the last.
pub(super) fn are_consecutive(rows: &[Row]) -> bool {
    rows.windows(2).all(|pair| pair[0].valence + 1 == pair[1].valence)
}

/// The arrays of rows of ascending valences, with a list of these where some are missing.
pub(super) fn arrays(rows: &[Row], real: RealType) -> Result<Vec<Array<'static>>, TableError> {
    let [first, ..] = rows else { return Ok(Vec::new()) };
    if let Some(other) = rows.iter().find(|row| row.orbits != first.orbits) {
        return Err(TableError::Different { valence: other.valence });
    }
    let total: usize = rows.iter().map(|row| row.tangents[0].len()).sum();
    if total > MAX_TABLE_WEIGHTS {
        return Err(TableError::TooMany);
    }
    let names: Vec<&str> = first.orbits.iter().map(|(name, _)| &name[..]).collect();
    let full: Vec<&str> =
        first.orbits.iter().filter(|(_, full)| *full).map(|(name, _)| &name[..]).collect();
    let each = |(name, full): &(String, bool)| {
        if *full { format!("each {name}") } else { name.clone() }
    };
    let columns = first.orbits.iter().map(each).collect::<Vec<String>>().join(", ");
    let points = full.join("[0], ..., [n - 1], then ") + "[0], ..., [n - 1]";
    let consecutive = are_consecutive(rows);
    let start = if consecutive {
        format!("from offset[n - {}] on", first.valence)
    } else {
        "from offset[i] on".to_owned()
    };
    let numbers = |row: &dyn Fn(&Row) -> Vec<Real>| rows.iter().map(row).collect::<Vec<_>>();
    let single = !first.orbits[0].1;
    let rule = numbers(&|row| row.rule.iter().map(|w| Real::nearest(w, real)).collect());
    let rule = if single {
        let about = vec![format!("new {}: the weights of {columns}", names[0])];
        Array { name: "weights", about, entries: Entries::Table(rule) }
    } else {
        let about = vec![format!("new {}[0], {start}: the weights of {points}", names[0])];
        Array { name: "weights", about, entries: Entries::List(rule) }
    };
    let tangent = |i: usize, name: &'static str| {
        let about = vec![format!("tangent {}, {start}: the weights of {points}", i + 1)];
        let entries = numbers(&|row| {
            row.tangents[i].iter().map(|weight| Real::nearest(weight, real)).collect()
        });
        Array { name, about, entries: Entries::List(entries) }
    };
    let subdominant = rows.iter().map(|row| Real::nearest(&row.subdominant, real)).collect();
    let limit = numbers(&|row| row.limit.iter().map(|w| Real::nearest(w, real)).collect());
    let lengths = rows.iter().map(|row| row.tangents[0].len());
    let offsets = lengths.scan(0, |next, length| Some(std::mem::replace(next, *next + length)));
    let valences = Array {
        name: "valence",
        about: vec!["the valence of row i".to_owned()],
        entries: Entries::Integers(rows.iter().map(|row| row.valence).collect()),
    };
    let valences = (!consecutive).then_some(valences).into_iter();
    Ok(valences
        .chain([
            rule,
            Array {
                name: "subdominant",
                about: vec!["the subdominant eigenvalue".to_owned()],
                entries: Entries::List(vec![subdominant]),
            },
            Array {
                name: "limit",
                about: vec![format!("limit point: the weights of {columns}")],
                entries: Entries::Table(limit),
            },
            Array {
                name: "offset",
                about: vec!["where the entries of a valence begin in the lists".to_owned()],
                entries: Entries::Integers(offsets.collect()),
            },
            tangent(0, "tangent_1"),
            tangent(1, "tangent_2"),
        ])
        .collect())
}
