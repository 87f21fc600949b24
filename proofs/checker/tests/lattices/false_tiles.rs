//! False tiles and parts, accuracies and blocks.

use super::false_limits::{EXTREME, altered, reason, with};
use super::limits::{lines, own};

#[test]
fn simplices() {
    let lines = format!("contraction 1\n{}end", lines("three-hexagon"));
    let first = "part -1 1 0 1 1 0\n";
    let tile = |name: &'static str, why: &'static str| ("tile hexagon +", name, why);
    altered(
        "three",
        ("value", "1"),
        &lines,
        &[
            tile("tile hexagon -", "keeps the mask"),
            tile("tile square", "keeps the mask"),
            tile("tile cube", "dimension"),
            tile("tile digits", "translations"),
            tile("tile hexagon", "a tile"),
            tile("tile hexagon + +", "a tile"),
            tile("tile", "a tile"),
            ("contraction 1\n", "", "differences"),
            ("contraction 1\n", "contraction 1\nend\n", "verdict"),
            (first, "", "as many different parts"),
            (first, "part 1 0 0 1 0 0\n", "as many different parts"),
            (first, "part -1 1 0 1 1 0\npart -1 1 0 1 1 0\n", "as many different parts"),
            (first, "part -1 1 0 1 1 1\n", "in the tile"),
            (first, "part -1 1 0 1 2 0\n", "in the tile"),
            (first, "part 1 0 0 1 1 0\n", "in the tile"),
            (first, "part 0 1 1 0 0 0\n", "in the tile"),
            (first, "part 1 1 0 1 1 0\n", "has the matrices"),
            (first, "part 2 0 0 2 0 0\n", "has the matrices"),
            (first, "part 0 0 0 0 0 0\n", "has the matrices"),
            ("accuracy 2", "accuracy 1", "it is 2"),
            ("accuracy 2", "accuracy 3", "it is 2"),
            ("accuracy 2", "accuracy 0", "it is 2"),
            ("accuracy 2", "accuracy -2", "a count"),
            ("accuracy 2", "accuracy +2", "a count"),
            ("accuracy 2", "accuracy", "a count"),
            ("accuracy 2\n", "", "accuracy"),
            ("at-most 2", "at-most 1999999999/1000000000", "sum to 2"),
            ("at-most 2", "at-most 9/4", "does not show"),
            ("positive 2", "positive 2.000001", "is shown to reach"),
            ("positive 2", "positive 1.999999", "does not show"),
            ("positive 2", "modulus 2.1", "is shown to reach"),
            ("positive 2", "modulus 1.9", "does not show"),
            ("image 4:2\nimage\n", "image\nimage 4:2\n", "sum to"),
            ("image 4:2\n", "image 4:-2\n", "sum to"),
            ("image 4:2\n", "image 3:2\n", "sum to"),
            ("image 4:2\n", "image 5:2\n", "no such matrix or row"),
            ("image 4:2\nend", "end", "images of rows are missing"),
            ("row -1 1 0 1", "row -1 1 0", "one size"),
            ("row -1 1 0 1", "row -1 1 0 2", "sum to"),
            ("end", "continuous 0\nend", "end"),
            ("end", "tile square\nend", "end"),
            ("product", "basis 1 0 0 0 | 0 1 0 0 | 0 0 1 0 | 0 0 0 1\nproduct", "together"),
        ],
    );
    for extreme in EXTREME {
        for (from, to) in
            [("part -1 1", format!("part {extreme} 1")), ("1 1 0\n", format!("1 {extreme} 0\n"))]
        {
            let found = reason("three", ("value", "1"), &with(&lines, from, &to));
            assert!(found.contains("beyond a cap"), "{extreme}: {found}");
        }
        let found = reason(
            "three",
            ("value", "1"),
            &with(&lines, "accuracy 2", &format!("accuracy {extreme}")),
        );
        let why = ["beyond a cap", "it is 2", "a count"];
        assert!(why.iter().any(|why| found.contains(why)), "{extreme}: {found}");
    }
}

/// Blocks are those of the matrices fT_g: their first columns are not 0 below the diagonal in any order.
#[test]
fn blocks() {
    let unit = "1 0 0 0 | 0 1 0 0 | 0 0 1 0 | 0 0 0 1";
    let lines = format!("contraction 1\n{}end", lines("three-hexagon"));
    let of = |basis: &str, inverse: &str, sizes: &str| {
        let blocks = format!("basis {basis}\ninverse {inverse}\nblocks {sizes}\nproduct");
        reason("three", ("value", "1"), &with(&lines, "product", &blocks))
    };
    assert_eq!(of(unit, unit, "4"), "Valid");
    for (sizes, why) in
        [("3", "one size"), ("5", "one size"), ("0 4", "one size"), ("", "one size")]
    {
        assert!(of(unit, unit, sizes).contains(why), "{sizes}");
    }
    let turned = "0 0 0 1 | 0 0 1 0 | 0 1 0 0 | 1 0 0 0";
    for sizes in ["1 3", "3 1", "2 2", "1 1 1 1"] {
        let refused = [of(unit, unit, sizes), of(turned, turned, sizes)];
        assert!(refused.iter().all(|found| found != "Valid"), "{sizes}: {refused:?}");
        assert!(
            refused.iter().any(|found| found.contains("right of a block")),
            "{sizes}: {refused:?}"
        );
    }
    assert!(of(unit, turned, "4").contains("inverse"));
}

/// The group of a tile keeps the mask where its mean is an integer point, and the dilation keeps the group.
#[test]
fn symmetry() {
    let parts = "part 1 0 0 1 0 0\npart 1 0 0 1 1 0\npart 1 0 0 1 0 1\npart 1 0 0 1 1 1\n";
    for (scheme, tile, why) in [
        ("four", "square", "natural shift is integer"),
        ("three", "square", "keeps the mask"),
        ("six", "square", "keeps the mask"),
        ("bilinear", "hexagon +", "keeps the mask"),
        ("bilinear", "hexagon -", "keeps the mask"),
        ("bilinear", "square", "in the tile"),
        ("quincunx", "hexagon +", "keeps the group"),
        ("root-three", "square", "keeps the group"),
        ("mixed", "square", "alike"),
        ("mixed", "digits", "alike"),
        ("cube", "square", "dimension"),
        ("cube", "cube", "keeps the mask"),
    ] {
        let parts = if scheme == "cube" { "" } else { parts };
        let lines =
            format!("contraction 2\ntile {tile}\n{parts}accuracy 2\nat-most 1\nunit 1\nend");
        let found = reason(scheme, ("at_least", "0"), &lines);
        assert!(found.contains(why), "{scheme} {tile}: {found}");
    }
}

/// Whether the dilation of a scheme shrinks all directions alike is decided exactly.
#[test]
fn dilations() {
    let (two, three) = ("(1+x)^2*(1+y)^2/4", "(1+x)^2*(1+y)^2*(1+z)^2/8");
    for (symbol, dilation, level, alike) in [
        (two, "[[2, 0], [0, -2]]", 1, true),
        (two, "[[-2, 0], [0, -2]]", 1, true),
        (two, "[[0, 2], [-2, 0]]", 1, true),
        (two, "[[2, 1], [0, 2]]", 3, false),
        (two, "[[2, 1], [0, -2]]", 3, true),
        ("(1+x)^2/2", "[[0, 2], [1, 0]]", 2, true),
        ("(1+x)^2/2", "[[0, -2], [1, 0]]", 2, true),
        ("(1+x)^2/2", "[[0, 0, 2], [1, 0, 0], [0, 1, 0]]", 3, true),
        ("(1+x)^2/2", "[[0, 0, -2], [1, 0, 0], [0, 1, 0]]", 3, true),
        (three, "[[2, 0, 0], [0, 2, 0], [0, 0, -2]]", 1, true),
        (three, "[[0, 2, 0], [-2, 0, 0], [0, 0, -2]]", 1, true),
        (three, "[[2, 1, 0], [0, 2, 0], [0, 0, 2]]", 3, false),
        (three, "[[2, 1, 0], [0, 2, 0], [0, 0, -2]]", 3, false),
        (three, "[[2, 1, 0], [0, -2, 0], [0, 0, 2]]", 3, true),
        ("(1+x)^2*(1+y+y^2)^2/6", "[[2, 0], [0, 3]]", 1, false),
        ("(1+x)^2*(1+y)^2*(1+z+z^2)^2/12", "[[2, 0, 0], [0, 2, 0], [0, 0, 3]]", 1, false),
        ("(1+x)^2*(1+y)^2*(1+z+z^2+z^3)^2/16", "[[2, 0, 0], [0, 2, 0], [0, 0, 4]]", 1, false),
    ] {
        let scheme = format!("symbol = '{symbol}'\ndilation = {dilation}");
        let lines = format!("contraction {level}\ntile digits\naccuracy 2\nat-most 1\nunit 1\nend");
        let found = own(&scheme, ("at_least", "0"), &lines, "confirmed");
        let found = format!("{found:?}");
        let why = if alike { "one digit of each class" } else { "alike" };
        assert!(found.contains(why), "{dilation}: {found}");
    }
}
