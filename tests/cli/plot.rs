//! `subcert plot`, the pages of `subcert atlas`, and tables of masks.

use super::{TemporaryFile, assert_parts, refused, temporary, written};

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

/// Contour lines and the graph of φ, also of products and of a plane through the middle of a solid; words where the scheme diverges.
#[test]
fn masks_of_several_variables() {
    for (scheme, part) in [
        ("courant", "α in Z²"),
        ("chaikin x chaikin", "contour lines"),
        ("quincunx-five-point", "the basic limit function"),
        ("trilinear", "α in Z³"),
        ("twin-dragon", "There is no picture"),
    ] {
        let svg = written(["plot", scheme]);
        assert_parts(&svg, &[part]);
        assert_eq!(svg.contains("polyline"), scheme != "twin-dragon", "{scheme}");
    }
}

#[test]
fn nonsense_is_refused() {
    assert_parts(&refused(["plot", "chaikn"]), &["chaikin"]);
    assert_parts(&refused(["plot", "chaikin", "-o", "docs"]), &["is a folder", "-o FILE.svg"]);
    assert_parts(
        &refused(["plot", "chaikin", "--bounds", "a=0..1"]),
        &["--bounds", "two parameters"],
    );
    assert_parts(&refused(["plot", "colella-heil", "--bounds", "a=1..0"]), &["not below"]);
    assert_parts(&refused(["plot", "newton"]), &["needs its parameter"]);
}

/// An index, a page for each entry, and the pages of audits that they link to.
#[test]
fn the_atlas_is_a_folder_of_pages() {
    let folder = temporary("atlas");
    let path = folder.to_str().expect("a UTF-8 path");
    let claims = "proofs/claims/smoothness/lane1980.toml";
    let arguments = [
        "atlas", "chaikin", "loop", "b-spline", "--claims", claims, "--format", "html", "-o", path,
    ];
    assert_eq!(
        written(arguments),
        format!("{path}: 3 pages of schemes, and index.html, which leads to them\n")
    );
    let page = |name: &str| std::fs::read_to_string(folder.join(name)).expect(name);
    let (index, spline, rings) = (page("index.html"), page("b-spline.html"), page("loop.html"));
    // A row for each scheme, which leads to its section.
    for reference in ["b-spline:degree=3", "chaikin", "loop"] {
        let name = reference.split(':').next().expect("a name");
        assert!(index.contains(&format!("href=\"{name}.html#{reference}\"")), "{reference}");
        assert!(
            page(&format!("{name}.html")).contains(&format!("id=\"{reference}\"")),
            "{reference}"
        );
    }
    assert_eq!(index.matches("<tr data-words").count(), 7 + 1);
    assert_parts(
        &spline,
        &[
            "φ″",
            "<var>C</var><sup>2</sup>, not <var>C</var><sup>3</sup>",
            "pub const WEIGHTS",
            "static const double",
            "weights = [",
        ],
    );
    assert_parts(&rings, &["The characteristic ring at valence 7", "pub const SUBDOMINANT"]);
    // Each link to a claim leads to its section.
    let links: Vec<&str> = spline.split("href=\"audits/").skip(1).collect();
    assert!(!links.is_empty(), "no claims");
    for link in links {
        let (file, id) =
            link.split('"').next().and_then(|link| link.split_once('#')).expect("a link");
        assert!(page(&format!("audits/{file}")).contains(&format!("id=\"{id}\"")), "{file}#{id}");
    }
    assert_eq!(index.matches("<script").count(), 1);
    assert!(!spline.contains("<script") && !index.contains("src="));
    std::fs::remove_dir_all(&folder).expect("the folder goes");
}

/// One's own schemes have pages like those of the catalogue.
#[test]
fn own_schemes_have_pages() {
    let folder = temporary("own-atlas");
    let path = folder.to_str().expect("a UTF-8 path");
    let own = ["examples/my-scheme.toml", "examples/my-scheme.toml:w=1/8", "[1, 3, 3, 1]/4"];
    let arguments = [&["atlas"], &own[..], &["chaikin", "--format", "html", "-o", path]].concat();
    let said = written(arguments);
    assert_eq!(said, format!("{path}: 3 pages of schemes, and index.html, which leads to them\n"));
    let page = |name: &str| std::fs::read_to_string(folder.join(name)).expect(name);
    let index = page("index.html");
    for (file, id) in [
        ("examples-my-scheme.toml.html", "examples/my-scheme.toml"),
        ("examples-my-scheme.toml.html", "examples/my-scheme.toml:w=1/8"),
        ("-1--3--3--1--4.html", "[1,_3,_3,_1]/4"),
        ("chaikin.html", "chaikin"),
    ] {
        assert!(index.contains(&format!("href=\"{file}#{id}\"")), "{id}: {index}");
        let page = page(file);
        assert_parts(&page, &[&format!("id=\"{id}\""), "φ′", "pub const WEIGHTS"]);
    }
    std::fs::remove_dir_all(&folder).expect("the folder goes");
    let scheme = std::fs::read_to_string("examples/my-scheme.toml").expect("the example");
    let [first, second] = [" ", "-"].map(|between| {
        let path = format!("{path}{between}clash.toml");
        std::fs::write(&path, &scheme).expect("a temporary file");
        path
    });
    let clash = ["atlas", &first, &second, "--format", "html", "-o", path];
    assert_parts(&refused(clash), &["would have one name", "two folders"]);
    assert!(!folder.exists(), "half-written");
    for file in [first, second] {
        std::fs::remove_file(file).expect("the file goes");
    }
}

/// What is drawn of a scheme of the catalogue is drawn of the same file of one's own.
#[test]
fn own_schemes_have_the_pictures_of_the_catalogue() {
    for (name, parameters, bounds) in [
        ("chaikin", "", None),
        ("four-point", "", None),
        ("four-point", ":w=1/10", None),
        ("four-point", ":w=sqrt(2)/32", None),
        ("corner-cutting", "", None),
        ("colella-heil", "", Some("a=0..1,b=0..1/2")),
        ("daubechies-4", "", None),
        ("b-spline", ":degree=3", None),
    ] {
        let text = std::fs::read_to_string(format!("src/schemes/scheme/catalogue/{name}.toml"));
        let file = TemporaryFile::new(&format!("{name}.toml"), &text.expect(name));
        let drawn = |scheme: &str| {
            let scheme = format!("{scheme}{parameters}");
            let bounds = bounds.map(|bounds| ["--bounds", bounds]);
            let arguments = ["plot", &scheme].into_iter().chain(bounds.into_iter().flatten());
            written(arguments).replace(&scheme, "SCHEME")
        };
        assert!(drawn(file.path()) == drawn(name), "{name}{parameters}");
    }
    let ring = written(["plot", "examples/loop.toml:N=7"]);
    assert_eq!(ring.replace("examples/loop.toml", "loop"), written(["plot", "loop:N=7"]));
}

/// A mask on Z² with two parameters has a map as curves have.
#[test]
fn maps_of_masks_on_lattices() {
    let map = written(["plot", "(1+x)^2*(1+y)^2/4*(1+a*(x-1)+b*(y-1))"]);
    let shares = [
        "C^0: 71.9 % of the area proven, 0 % refuted",
        "C^1: 8.59 % of the area proven, 75 % refuted",
    ];
    assert_parts(&map, &shares);
}

#[test]
fn pages_of_the_atlas_need_a_folder_and_claims_need_pages() {
    assert_parts(&refused(["atlas", "chaikin", "--format", "html"]), &["-o DIR"]);
    let claims = ["atlas", "chaikin", "--claims", "proofs/claims/smoothness/lane1980.toml"];
    assert_parts(&refused(claims), &["--claims", "--format html"]);
}

/// The numbers in the code of a mask are its coefficients, and its limit stencil is that of Chaikin's scheme.
#[test]
fn masks_have_tables() {
    let python = written(["table", "chaikin", "--format", "python"]);
    assert_parts(
        &python,
        &[
            "arity = 2",
            "offset = 0",
            "[0.75, 0.25]",
            "[0.25, 0.75]",
            "limit = [0.5, 0.5]",
            "limit_first = 0",
        ],
    );
    let json: serde_json::Value =
        serde_json::from_str(&written(["table", "four-point:w=1/16", "--format", "json"]))
            .expect("JSON");
    assert_eq!(json["weights"][1], serde_json::json!([-0.0625, 0.5625, 0.5625, -0.0625]));
    assert!(
        written(["table", "daubechies-4", "--format", "rust"]).contains("pub const OFFSET: isize")
    );
    assert_parts(&refused(["table", "loop", "--format", "c"]), &["--valences 3..12"]);
    assert_parts(&refused(["table", "chaikin x chaikin", "--format", "c"]), &["tensor product"]);
}
