//! `subcert plot`: a picture to the output or into a file, and bad input.

use super::{TemporaryFile, assert_parts, refused, written};

#[test]
fn a_picture_goes_to_the_output_or_into_a_file() {
    let svg = written(["plot", "chaikin"]);
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    let file = TemporaryFile::new("chaikin.svg", "");
    assert_eq!(written(["plot", "chaikin", "-o", file.path()]), "");
    assert_eq!(std::fs::read_to_string(file.path()).expect("the file"), svg);
    // A scheme of one's own.
    assert!(written(["plot", "[1, 3, 3, 1]/4"]).contains("φ′"));
}

#[test]
fn nonsense_is_refused() {
    assert_parts(&refused(["plot", "chaikn"]), &["chaikin"]);
    assert_parts(&refused(["plot", "chaikin x chaikin"]), &["tensor product"]);
    assert_parts(&refused(["plot", "chaikin", "-o", "docs"]), &["is a folder", "-o FILE.svg"]);
    assert_parts(
        &refused(["plot", "chaikin", "--bounds", "a=0..1"]),
        &["--bounds", "two parameters"],
    );
    assert_parts(&refused(["plot", "colella-heil", "--bounds", "a=1..0"]), &["not below"]);
    assert_parts(&refused(["plot", "newton"]), &["needs a value"]);
}
