//! Whether printed bounds and depths keep their promise.

use crate::audit::{
    Broken, CellFinding, Control, Kept, Place, PromiseCounts, Sound, TableFinding, Word,
};
use crate::claim::Promise;
use crate::exact::format::{raised_digits, short};
use crate::report::words::data::{name, parameters};

/// The longest polygon that is shown in a table's remarks.
const MAX_SHOWN_POINTS: usize = 24;

/// `12 of 28 kept, 10 ✗, 6 open`.
pub(crate) fn count(counts: PromiseCounts) -> String {
    let kept = format!("{} of {} kept", counts.kept, counts.all());
    let broken = (counts.broken > 0).then(|| format!("{} ✗", counts.broken));
    let open = (counts.open > 0).then(|| format!("{} open", counts.open));
    [Some(kept), broken, open].into_iter().flatten().collect::<Vec<String>>().join(", ")
}

/// The line below a cell of a table whose promise is broken or open, with its sound value; `None`
/// if it keeps its promise.
pub(crate) fn line(cell: &CellFinding) -> Option<String> {
    let word = match cell.kept.as_ref()? {
        Kept::Yes => return None,
        Kept::No(_) => Word::Broken,
        Kept::Open(_) => Word::Open,
    };
    Some(match &cell.sound {
        Some(Sound::Depth { level, .. }) => format!("{word}, sound {level}"),
        Some(Sound::Least(level)) => format!("{word}, least {level}"),
        Some(Sound::Bound(bound)) => {
            format!("{word}, sound {}", short(&raised_digits(bound, 4), 4))
        }
        _ => word.into(),
    })
}

/// How many cells of a table keep their promise by the formula, by the sound bound, and exactly,
/// with an example of a cell that does not.
pub(crate) fn remarks(finding: &TableFinding<'_>) -> Vec<String> {
    let Some(promise) = &finding.table.promise else { return Vec::new() };
    let what = match promise {
        Promise::Depth { .. } => "depths",
        Promise::Bound { .. } => "bounds",
    };
    let cells = || finding.cells.iter().flatten();
    let share = |kept: &dyn Fn(&CellFinding) -> Option<bool>| {
        let known: Vec<bool> = cells().filter_map(kept).collect();
        let kept = known.iter().filter(|kept| **kept).count();
        (!known.is_empty()).then(|| format!("{kept} of {}", known.len()))
    };
    let Some(by_formula) = share(&|cell| cell.kept_by_formula) else { return Vec::new() };
    let by_sound = share(&|cell| cell.kept_by_sound);
    let by_sound = by_sound.map(|count| format!(", {count} by the sound bound"));
    let by_formula = format!(
        "Promise: {by_formula} printed {what} keep it by the printed formula{}.",
        by_sound.unwrap_or_default()
    );
    let PromiseCounts { kept, broken, open } = finding.promise_counts();
    let exactly = format!("Exactly, {}.", counted([kept, broken, open]));
    // Data that break a promise also at the natural parameters come first.
    let natural_example = cells().find_map(|cell| match &cell.kept_naturally {
        Some(Kept::No(broken)) => Some((cell, broken)),
        _ => None,
    });
    let naturally = natural_example.map(|(cell, broken)| {
        let sentence = sentence(broken);
        format!("Broken at the natural parameters too at {}: {sentence}.", cell.locus)
    });
    let broken = cells().find_map(|cell| match &cell.kept {
        Some(Kept::No(broken)) => Some((cell, broken)),
        _ => None,
    });
    let text = [Some(by_formula), Some(exactly), elsewhere(finding)];
    let text = text.into_iter().flatten().collect::<Vec<String>>().join(" ");
    let open = cells().find_map(|cell| match &cell.kept {
        Some(Kept::Open(why)) => Some(format!("Open at {}: {why}.", cell.locus)),
        _ => None,
    });
    let example =
        broken.map(|(cell, broken)| format!("Broken at {}: {}.", cell.locus, sentence(broken)));
    [Some(text), naturally, example, open].into_iter().flatten().collect()
}

/// How many of the cells that do not keep their promise, or are open, keep it with the points at their natural
/// parameters. Where all do, the claim file may have other points than the paper.
fn elsewhere(finding: &TableFinding<'_>) -> Option<String> {
    let judged = || {
        let cells = finding.cells.iter().flatten();
        cells.filter_map(|cell| Some((&cell.natural, cell.kept_naturally.as_ref()?)))
    };
    let (first, _) = judged().next()?;
    let count = |of: fn(&Kept) -> bool| judged().filter(|(_, kept)| of(kept)).count();
    let (kept, broken) =
        (count(|kept| *kept == Kept::Yes), count(|kept| matches!(kept, Kept::No(_))));
    let all = judged().count();
    let alike = judged().all(|(natural, _)| natural == first);
    let at = if alike { format!(", {}", parameters(first)) } else { String::new() };
    let others = if all == 1 {
        "The one that is not shown to keep it is".to_owned()
    } else {
        format!("The {all} that are not shown to keep it are")
    };
    let counts = counted([kept, broken, all - kept - broken]);
    // The data may be compared where the paper does not.
    let hint = if kept == all {
        " If the paper compares there, the order of its rules or its `offset` is not that of the claim file."
    } else {
        ""
    };
    Some(format!(
        "{others} judged again with each point at its natural parameter{at}: {counts}.{hint}"
    ))
}

/// `12 keep it, 1 does not, 2 are open`.
fn counted(counts: [usize; 3]) -> String {
    let words = [["keeps it", "keep it"], ["does not", "do not"], ["is open", "are open"]];
    let parts = counts.into_iter().zip(words).filter(|(count, _)| *count > 0);
    let parts = parts.map(|(count, words)| format!("{count} {}", words[usize::from(count != 1)]));
    parts.collect::<Vec<String>>().join(", ")
}

/// The data, their distance and the promise.
fn sentence(broken: &Broken) -> String {
    format!(
        "{} is {} from its limit at level {}, {}, and {} is promised",
        data(broken, MAX_SHOWN_POINTS),
        short(&broken.distance, 6),
        broken.level,
        place(broken),
        short(&broken.most, 6)
    )
}

/// The control polygon or ring, times β.
fn data(broken: &Broken, most: usize) -> String {
    let shown = |points: &[i64]| {
        let shown = points.iter().take(most).map(i64::to_string).collect::<Vec<String>>();
        format!("{}{}", shown.join(" "), if points.len() > most { " …" } else { "" })
    };
    let (what, points, after) = match &broken.attained.control {
        Control::Polygon(polygon) => {
            ("polygon", shown(&polygon.points), format!(" from index {}", polygon.first))
        }
        Control::Net { first: [i, j], rows } => {
            let more = if rows.len() > most { " / …" } else { "" };
            let rows = rows.iter().take(most).map(|row| shown(row)).collect::<Vec<String>>();
            ("net", format!("{}{more}", rows.join(" / ")), format!(" from index ({i}, {j})"))
        }
        Control::Points(points) => {
            let heights: Vec<i64> = points.iter().map(|(_, height)| *height).collect();
            ("ring", shown(&heights), String::new())
        }
    };
    format!("the control {what} {}·({points}){after}", broken.spread)
}

fn place(broken: &Broken) -> String {
    let name = name(&broken.attained.place);
    match &broken.attained.place {
        Place::Parameter(_) => format!("t = {name}"),
        Place::Parameters(_) => format!("(s, t) = {name}"),
        _ => name,
    }
}

/// The facts of one cell.
pub(crate) fn facts(cell: &CellFinding) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    match &cell.kept {
        None => {}
        Some(Kept::Yes) => fact("promise, exactly", "kept".to_owned()),
        Some(Kept::Open(why)) => fact("promise, exactly", format!("open: {why}")),
        Some(Kept::No(broken)) => {
            let Broken { level, distance, most, .. } = &**broken;
            fact("promise, exactly", "not kept".to_owned());
            fact("broken by", data(broken, usize::MAX));
            fact("at", format!("level {level}, {}", place(broken)));
            fact("its distance there", format!("{distance} = {}", short(distance, 17)));
            fact("which is more than", format!("{most} = {}", short(most, 17)));
        }
    }
    match &cell.kept_naturally {
        None => {}
        Some(Kept::Yes) => {
            fact("at natural parameters", format!("kept, at {}", parameters(&cell.natural)));
        }
        Some(Kept::Open(why)) => fact("at natural parameters", format!("open: {why}")),
        Some(Kept::No(broken)) => {
            let Broken { level, distance, most, .. } = &**broken;
            let text = format!(
                "not kept: {} is {} > {} from its limit at level {level}, {}",
                data(broken, usize::MAX),
                short(distance, 17),
                short(most, 17),
                place(broken)
            );
            fact("at natural parameters", text);
        }
    }
    facts
}
