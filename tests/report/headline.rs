//! The sentences that audits begin with.

use crate::common::papers::AUDITS;
use subcert::audit::{PaperAudit, audit};
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert::report::{Block, overview_sheet};

/// The most words of the first sentence, its key not counted; theorems that are refuted are all named.
const MAX_WORDS: usize = 40;

fn check(audit: &PaperAudit<'_>) {
    let sheet = overview_sheet(std::slice::from_ref(audit));
    let Some(Block::Text(text)) = sheet.blocks.first() else { panic!("no sentence") };
    let (key, said) = text.split_once(": ").expect("a key");
    assert_eq!(key, audit.paper.key);
    let first = said.split(". ").next().expect("a sentence");
    assert!(first.split_whitespace().count() <= MAX_WORDS, "{first}");
    assert!(said.ends_with('.') && !said.contains("  ") && !said.contains(".."), "{said}");
    let words: Vec<&str> = said.split_whitespace().collect();
    for (place, pair) in words.windows(2).enumerate() {
        // `2 is`, `1 are`, `1 cells`; the number of a table counts nothing.
        let counts = place == 0 || !["Table", "Theorem"].contains(&words[place - 1]);
        if let Some(count) = pair[0].parse::<usize>().ok().filter(|_| counts) {
            let next = pair[1].trim_end_matches(['.', ',']);
            let singular = ["is", "differs", "cell", "promise", "takes", "fails"].contains(&next);
            let plural =
                ["are", "differ", "cells", "promises", "take", "fail", "tables"].contains(&next);
            assert!(
                !(singular && count != 1 || plural && count == 1),
                "{} in {said}",
                pair.join(" ")
            );
        }
    }
}

#[test]
fn headlines_are_short_and_say_first_what_is_wrong() {
    for audit in AUDITS.iter() {
        check(audit);
    }
    let first = |key: &str| {
        let audit = AUDITS.iter().find(|audit| audit.paper.key == key).expect("a paper");
        let sheet = overview_sheet(std::slice::from_ref(audit));
        let Some(Block::Text(text)) = sheet.blocks.first() else { panic!("no sentence") };
        text.clone()
    };
    let nary = first("mustafa2020-nary");
    assert!(
        nary.contains(
            "3 of these not at natural parameters: 8 of 10 theorems. Promises in Table 2, Table 4,"
        ),
        "{nary}"
    );
    assert!(nary.contains("and 83 of these kept at natural parameters: 164 of 220."), "{nary}");
    assert!(
        first("mustafa2007-bajaj")
            .contains("are refuted: 2 of 7 theorems. 14 of 44 equations fail.")
    );
}

#[test]
fn headlines_of_the_examples_and_of_small_papers() {
    let head = "key = 'k'\n[paper]\ntitle = 'T'\nyear = 2020\n";
    let table = |cells: &str| {
        format!(
            "{head}[[table]]\nid = 't'\nlocus = 'Table 1'\nvalue = 'c'\ncolumns = {{ name = 'c', values = [1, 2] }}\ncells = {cells}\n"
        )
    };
    let example =
        |name: &str| std::fs::read_to_string(format!("examples/{name}.toml")).expect("an example");
    let texts = [
        head.to_owned(),
        table("[[1, 2]]"),
        table("[[1, 7]]"),
        table("[[8, 7]]"),
        table("'lost'"),
        example("first-paper"),
        example("my-paper"),
    ];
    for text in texts {
        let paper =
            read_paper(&SourceText::new("k.toml", text)).unwrap_or_else(|error| panic!("{error}"));
        check(&audit(&paper).unwrap_or_else(|error| panic!("{error}")));
    }
}
