//! What makes a cell refuted: no member of the family, at no scale, explains more.

use subcert_check::{Outcome, Reason, check};

/// What the checker says of a table of a·w, a = 0, 1, 2, 3 under alternatives of a·w.
fn reason(w: &str, cells: [&str; 4], alternative: &str, block: &str) -> Option<Reason> {
    reason_of("a*w", w, cells, alternative, block)
}

/// The same of another value y.
fn reason_of(y: &str, w: &str, cells: [&str; 4], alternative: &str, block: &str) -> Option<Reason> {
    let cells = cells.join("', '");
    let claims = format!(
        "key = 'f'\n[define]\ny = '{y}'\n[[alternative]]\nof = 'y'\nlabel = 'b'\n\
         value = '{alternative}'\n[[table]]\nid = 't'\nvalue = 'y'\ngiven = {{ w = '{w}' }}\n\
         columns = {{ name = 'a', values = ['0', '1', '2', '3'] }}\ncells = [['{cells}']]\n"
    );
    let certificate = format!("subcert-certificate 4\npaper f\ntable t\n  value y\n{block}end 1\n");
    let report = check(&claims, &[&certificate]).expect("a claim file");
    assert!(report.broken.is_empty());
    match report.claims.into_iter().next().expect("a table").2 {
        Outcome::Valid => None,
        Outcome::Invalid(_, rejection) => Some(rejection.reason),
        outcome => panic!("{outcome:?}"),
    }
}

/// Cells that are refuted, with what the members give there.
fn refuted(cells: [&str; 4], values: [&str; 4], family: &str) -> String {
    let cell = |(i, (text, value)): (usize, (&str, &str))| {
        let verdict = if i == 0 { "confirmed" } else { "refuted" };
        format!("  cell 1 {} \"{text}\" {value} {verdict}\n", i + 1)
    };
    let pairs = cells.into_iter().zip(values).enumerate();
    pairs.map(cell).collect::<String>() + family
}

#[test]
fn every_scale_is_looked_at() {
    // w = 1/2, and what is printed belongs to no p/q at all; then to 3/7, of which 0 is a cell too.
    let values = ["0", "1/2", "1", "3/2"];
    let family = "  family 1\n  scale w\n  values 1 2 1/2 5/2\n  values 1 3 1 5\n  values 1 4 3/2 15/2\n  \
                  member : 1 1 1 : 1 1 1\n  member y#1 : 1 1 1 : 2 2 2\n";
    let none = ["0.0", "0.123411", "0.771309", "2.219047"];
    assert_eq!(reason("1/2", none, "5*a*w", &refuted(none, values, family)), None);
    let scaled = ["0.0", "0.428571", "0.857143", "1.285714"];
    let found = reason("1/2", scaled, "5*a*w", &refuted(scaled, values, family));
    assert!(matches!(found, Some(Reason::NotBest(1, 2..))), "{found:?}");
    let one = ["0.0", "0.428571", "0.771309", "2.219047"];
    let found = reason("1/2", one, "5*a*w", &refuted(one, values, family));
    assert!(matches!(found, Some(Reason::NotBest(1, 2..))), "{found:?}");
    // A parameter that is not positive is no scale.
    let values = ["0", "-1/20", "-1/10", "-3/20"];
    let family = "  family 1\n  values 1 2 -1/20 -1/4\n  values 1 3 -1/10 -1/2\n  \
                  values 1 4 -3/20 -3/4\n  member : 1 1 1 : 1 1 1\n  member y#1 : 1 1 1 : 2 2 2\n";
    assert_eq!(reason("-1/20", none, "5*a*w", &refuted(none, values, family)), None);
    let scale = family.replace("family 1\n", "family 1\n  scale w\n");
    assert!(reason("-1/20", none, "5*a*w", &refuted(none, values, &scale)).is_some());
}

/// A member that has no value for another reason than a division by 0, say, is no member that
/// explains nothing.
#[test]
fn a_wrong_alternative_refutes_nothing() {
    let cells = ["0.0", "0.123411", "0.771309", "2.219047"];
    let values = ["0", "1/2", "1", "3/2"];
    let family = "  family 1\n  scale w\n  values 1 2 1/2 undefined\n  values 1 3 1 undefined\n  \
                  values 1 4 3/2 undefined\n  member : 1 1 1 : 1 1 1\n  member y#1 : 0 0 0 : 2 2 2\n";
    assert_eq!(reason("1/2", cells, "a/(w - w)", &refuted(cells, values, family)), None);
    let found = reason("1/2", cells, "a/v", &refuted(cells, values, family));
    assert!(matches!(found, Some(Reason::Stopped(_))), "{found:?}");
}

/// What the printed text gives anyway is no sign of another reading, nor is what is printed as 0.
#[test]
fn luck_counts_what_is_new() {
    let w = "0.12345";
    let of = |last: &str, verdict: &str, values: &str| {
        // In a refuted cell each member has its value.
        let [first, second] = if values.is_empty() { ["", ""] } else { [" : 1", " : 2"] };
        format!(
            "  cell 1 1 \"0.0\" 0 confirmed\n  cell 1 2 \"0.12345\" 0.12345 confirmed\n  \
             cell 1 3 \"0.2469\" 0.2469 confirmed\n  cell 1 4 \"{last}\" 0.37035 {verdict}\n  \
             family 4\n  scale w\n{values}  member : 3 3 3{first}\n  member y#1 : 4 4 4{second}\n"
        )
    };
    // One more cell, of one digit, of six, and of nine: each of 6087 scales is a reading.
    let lucks =
        [("0.9", Some(Reason::Luck)), ("0.901234", Some(Reason::Luck)), ("0.901234567", None)];
    for (last, luck) in lucks {
        let other = format!("a*w + a*(a - 1)*(a - 2)/6*({last} - 3*w)");
        let cells = ["0.0", "0.12345", "0.2469", last];
        let read = of(last, &format!("other-reading {last}"), "");
        let read = format!("  read definition y 1\n{read}");
        assert_eq!(reason(w, cells, &other, &read), luck, "{last}");
        let values = format!("  values 1 4 0.37035 {last}\n");
        let unread = of(last, "refuted", &values);
        let not_luck = luck.is_none().then_some(Reason::NotLuck);
        assert_eq!(reason(w, cells, &other, &unread), not_luck, "{last}");
    }
    // Three more cells, two of which are 0.
    for (last, luck) in [("0.901", Some(Reason::Luck)), ("0.901234567", None)] {
        let other = format!("a*(a - 1)*(a - 2)/6*{last}");
        let block = format!(
            "  read definition y 1\n  cell 1 1 \"0.0\" 0 confirmed\n  \
             cell 1 2 \"0.00\" 0.12345 other-reading 0\n  \
             cell 1 3 \"0.00\" 0.2469 other-reading 0\n  \
             cell 1 4 \"{last}\" 0.37035 other-reading {last}\n  family 4\n  scale w\n  \
             member : 1 1 1\n  member y#1 : 4 4 4\n"
        );
        let found = reason(w, ["0.0", "0.00", "0.00", last], &other, &block);
        assert_eq!(found, luck, "{last}");
    }
}

/// A parameter of a reading is the scale, and that a number that someone would choose.
#[test]
fn a_reading_has_a_simple_scale() {
    for (w, known) in [("3/7", true), ("7/9", true), ("103/700", false)] {
        let exact: Vec<String> = (0..4).map(|a| format!("{a}*{w}")).collect();
        let cells = match w {
            "3/7" => ["0.0", "0.428571428571", "0.857142857143", "1.285714285714"],
            "7/9" => ["0.0", "0.777777777778", "1.555555555556", "2.333333333333"],
            _ => ["0.0", "0.147142857143", "0.294285714286", "0.441428571429"],
        };
        let rows = (1..4).map(|a| {
            format!("  cell 1 {} \"{}\" {a}/2 other-reading {}\n", a + 1, cells[a], exact[a])
        });
        let block = format!(
            "  read parameter w {w}\n  cell 1 1 \"0.0\" 0 confirmed\n{}  family 4\n  scale w\n  \
             member : 1 1 1\n  member y#1 : 1 1 1\n",
            rows.collect::<String>()
        );
        let found = reason("1/2", cells, "5*a*w", &block);
        let foreign = Some(Reason::NotInFamily("w".to_owned()));
        assert_eq!(found, if known { None } else { foreign }, "{w}");
    }
}

/// Only members that are proportional to the scale are of the family at other scales, and only
/// choices and definitions that the value as printed consults give members.
#[test]
fn readings_are_members() {
    // (a·w)² at w = 6/7, with w = 1/2 stated.
    let cells = ["0.0", "0.734694", "2.938776", "6.612245"];
    let rows = |numbers: [&str; 3]| {
        let row = |(i, number): (usize, &str)| {
            let (a, cell) = (i + 1, cells[i + 1]);
            format!("  cell 1 {} \"{cell}\" {a}/2 other-reading {number}\n", a + 1)
        };
        numbers.into_iter().enumerate().map(row).collect::<String>()
    };
    let block = |read: &str| {
        let rows = rows(["36/49", "144/49", "324/49"]);
        format!(
            "  {read}\n  cell 1 1 \"0.0\" 0 confirmed\n{rows}  family 4\n  scale w\n  \
             member : 1 1 1\n  member y#1 : 1 1 1\n"
        )
    };
    let read = block("read definition y 1\n  read parameter w 6/7");
    let found = reason("1/2", cells, "a*a*w^2", &read);
    assert_eq!(found, Some(Reason::NotInFamily("w".to_owned())));
    // A choice that nothing consults.
    let consulted = block("read definition y 1\n  read choice order forward");
    let found = reason("1/2", cells, "a*a*36/49", &consulted);
    assert_eq!(found, Some(Reason::NotInFamily("order=forward y#1".to_owned())));
    // Of a power that is twice as much at 2k there is no scale.
    let cells = ["0.0", "0.123411", "0.771309", "2.219047"];
    let power = refuted(
        cells,
        ["0", "2", "4", "6"],
        "  family 1\n  values 1 2 2\n  values 1 3 4\n  values 1 4 6\n  \
         member : 1 1 1 : 1 1 1\n  member y#1 : 1 1 1 : 1 1 1\n",
    );
    assert_eq!(reason_of("a*2^w", "1", cells, "a*2^w", &power), None);
    let scaled = power.replace("family 1\n", "family 1\n  scale w\n");
    assert!(reason_of("a*2^w", "1", cells, "a*2^w", &scaled).is_some());
    assert!(reason_of("a*2*w", "1", cells, "a*2*w", &power).is_some());
    assert_eq!(reason_of("a*2*w", "1", cells, "a*2*w", &scaled), None);
}
