//! Claim files of projects: what is read, and what is refused with a remedy.

use super::{HEAD, found, project, table};
use subcert::diagnostic::SourceText;
use subcert::shipped::{Outcome, read_project};

fn refused(text: &str) -> String {
    match read_project(&SourceText::new("k.toml", text.to_owned())) {
        Ok(_) => panic!("accepted: {text}"),
        Err(errors) => errors.to_string(),
    }
}

#[test]
fn bad_files() {
    let good = table("f32", "'k = 1..2'", "k/2", &["0.5f", "1"]);
    for (from, to, parts) in [
        ("key = 'k'", "key = 'a b'", &["cannot be the key of a project", "use letters"][..]),
        ("id = 't'", "id = 't/'", &["cannot be the id of a table"]),
        (
            "0123456789012345678901234567890123456789",
            "012345",
            &["is not a commit", "git rev-parse"],
        ),
        ("'f32'", "'f16'", &["`f16` is not a type", "decimal:6"]),
        ("'f32'", "'decimal:0'", &["is not a type"]),
        ("k = 1..2", "k = 2..1", &["k = 2..1"]),
        ("k = 1..2", "k", &["`k`"]),
        ("k = 1..2", "k = 1..99999", &["20000"]),
        ("k = 1..2", "k = 1..3", &["3"]),
        ("k = 1..2", "n = 1..2", &["unknown name `k`"]),
        ("'k/2'", "'k/'", &["expected"]),
        ("'k/2'", "'1/(k-1)'", &["division by zero"]),
        ("'k/2'", "'sqrt(-k)'", &["sqrt"]),
        ("'0.5f', '1'", "'0.5f', 'x'", &["`x`"]),
        ("'0.5f', '1'", "['0.5f'], '1'", &["equally many entries"]),
        ("'0.5f', '1'", "'0.5f', '1e99f'", &["no finite value"]),
        ("cells = ", "numbers = ", &["numbers"]),
        ("equals = ", "value = ", &["value"]),
        ("title = 'a table'\n", "title = 'a table'\ntolerance = '-1'\n", &["greater than 0"]),
        (
            "title = 'a table'\n",
            "title = 'a table'\nlanguage = 'fortran'\n",
            &["is not a language"],
        ),
        (
            "cells = ['0.5f', '1']",
            "cells_from = { file = 'no.c', after = 't' }",
            &["cannot read", "relative"],
        ),
    ] {
        let text = format!("{HEAD}{good}");
        assert!(text.contains(from), "{from}");
        let text = text.replacen(from, to, 1);
        let message = match read_project(&SourceText::new("k.toml", text.clone())) {
            Err(errors) => errors.to_string(),
            // What a formula lacks is seen when it is evaluated.
            Ok(project) => match subcert::shipped::audit_project(&project) {
                Err(errors) => errors.to_string(),
                Ok(_) => panic!("accepted: {text}"),
            },
        };
        for part in parts {
            assert!(message.contains(part), "no `{part}` in: {message}");
        }
    }
}

#[test]
fn empty_files_and_ids_twice() {
    assert!(refused(HEAD).contains("describes no table"));
    let one = table("f32", "", "1/2", &["0.5f"]);
    assert!(refused(&format!("{HEAD}{one}{one}")).contains("the id `t` is used twice"));
    let many: String = (0..65).map(|i| one.replace("'t'", &format!("'t{i}'"))).collect();
    assert!(refused(&format!("{HEAD}{many}")).contains("more than 64 tables"));
}

/// The range of an index has ends within a million, also where an end has no absolute value in an i64.
#[test]
fn ends_of_indices_have_a_cap() {
    let ends = ["-9223372036854775808..5", "0..9223372036854775807", "-1000001..5", "0..1000001"];
    for range in ends {
        let said =
            refused(&format!("{HEAD}{}", table("f32", &format!("'n = {range}'"), "n", &["0"])));
        assert!(said.contains("is not an index with its range"), "{range}: {said}");
    }
}

#[test]
fn nested_cells_and_a_formula_for_each() {
    let text = "[[shipped]]\nid = 't'\nlocus = 'l'\ntitle = 't'\ntype = 'f32'\nindices = ['i = 0..1', 'j = 0..2']\n\
                equals_cells = [['1/2', '1/3', '0'], ['1', '2', '-1/4']]\n\
                cells = [['0.5f', '1.f/3', '0'], ['1', '2', '-0.25f']]\n";
    let project = project(text);
    assert_eq!(found(&project).outcome, Outcome::Nearest);
    assert_eq!(project.shipped[0].at(4), [("i", 1), ("j", 1)]);
}

/// The example of the documentation: the numbers come from the source file beside it.
#[test]
fn numbers_from_a_source_file() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/weights.toml");
    let text = std::fs::read_to_string(path).expect("a file");
    let project = read_project(&SourceText::new(path, text)).expect("a claim file");
    let lines: Vec<Option<usize>> =
        project.shipped[0].numbers.iter().map(|number| number.line).collect();
    assert_eq!(lines, [6, 7, 8, 9, 10, 11].map(Some));
    assert_eq!(project.shipped[1].numbers[2].text, "1.0 / 8.0");
}

/// Part of a table: four numbers, of which the first is passed over.
#[test]
fn a_part_of_a_table() {
    let folder = std::env::temp_dir().join(format!("subcert-{}-shipped", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("t.h"), "float t[2][2] = {{9, .5f}, {1.f, 1.5f}};\n")
        .expect("a file");
    let read_as = |kind: &str, from: &str| {
        let text = format!(
            "{HEAD}[[shipped]]\nid = 't'\nlocus = 'l'\ntitle = 't'\ntype = '{kind}'\nindices = ['k = 1..2']\n\
             equals = 'k/2'\ncells_from = {{ file = 't.h', after = 't', {from} }}\n"
        );
        read_project(&SourceText::new(folder.join("k.toml").display().to_string(), text))
    };
    let read = |from: &str| read_as("f32", from);
    let project = read("shape = [2, 2], skip = '1'").expect("a claim file");
    assert_eq!(found(&project).outcome, Outcome::Nearest);
    let errors = |from: &str| read(from).expect_err("a wrong file").to_string();
    assert!(
        errors("shape = [2, 2], skip = '3'").contains("4 numbers, and 2 are described after 3")
    );
    // The source says `float`.
    let other = read_as("f64", "shape = [2, 2], skip = '1'").expect_err("another type").to_string();
    assert!(other.contains("have the type f32 here") && other.contains("t.h"), "{other}");
    assert!(read_as("decimal:1", "shape = [2, 2], skip = '1'").is_ok());
    assert!(errors("skip = '1'").contains("needs the `shape`"));
    assert!(errors("shape = [3, 2]").contains("t.h"));
    std::fs::remove_dir_all(&folder).expect("the folder is still there");
}
