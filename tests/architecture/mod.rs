//! The order of the modules: files import each other in no circle, and no module imports a higher
//! layer.

mod imports;

use imports::{Imports, Module, name};
use std::collections::BTreeMap;
use std::path::Path;

/// The crates from below: the folder of the sources, the name, and the modules from below. A module
/// imports its own layer and those before it. A new folder gets a word here.
const CRATES: [(&str, &str, &[&str]); 7] = [
    (
        "src/numbers",
        "subcert_numbers",
        &[
            "cap",
            "files",
            "stop",
            "cores",
            "diagnostic",
            "suggestion",
            "exact",
            "machine",
            "formula",
        ],
    ),
    (
        "src/schemes",
        "subcert_schemes",
        &[
            "scheme",
            "bound",
            "limit",
            "float",
            "joint",
            "smoothness",
            "lattice",
            "spectrum",
            "characteristic",
            "facts",
        ],
    ),
    ("src/geometry", "subcert_geometry", &["grouped", "mesh", "net", "solid", "patch", "oracle"]),
    (
        "src/claims",
        "subcert_claims",
        &[
            "verdict",
            "literal",
            "claim",
            "shipped",
            "evaluation",
            "finding",
            "judge",
            "digest",
            "evidence",
            "audit",
        ],
    ),
    ("src/reports", "subcert_reports", &["certificate", "report"]),
    ("src", "subcert", &["cli", "main"]),
    ("proofs/checker/src", "subcert_check", &[]),
];

fn imports(folder: &str, name: &str) -> Imports {
    Imports::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), name)
}

#[test]
fn files_import_each_other_in_no_circle() {
    let mut wrong = Vec::new();
    for (folder, crate_name, _) in CRATES {
        let imports = imports(folder, crate_name);
        let circles = imports.circles();
        wrong
            .extend(circles.iter().map(|circle| format!("{folder}: {}", imports.describe(circle))));
    }
    assert!(wrong.is_empty(), "circles of imports:\n{}", wrong.join("\n"));
}

#[test]
fn no_module_imports_a_higher_layer() {
    let mut wrong = Vec::new();
    for (folder, crate_name, layers) in CRATES.iter().filter(|(.., layers)| !layers.is_empty()) {
        let layer = |module: &Module| {
            let first = module.first().map(String::as_str);
            layers.iter().position(|layer| Some(*layer) == first)
        };
        // The root only declares the modules, and names those of the crates below.
        let modules = imports(folder, crate_name);
        for (module, imported) in modules.iter().filter(|(module, _)| !module.is_empty()) {
            let Some(own) = layer(module) else {
                wrong.push(format!("{crate_name}::{} is in no layer of CRATES", name(module)));
                continue;
            };
            for (other, items) in imported.iter().filter(|(other, _)| !other.is_empty()) {
                if layer(other).is_none_or(|other| other > own) {
                    let items: Vec<&str> = items.iter().map(String::as_str).collect();
                    let items = items.join(", ");
                    wrong.push(format!("{} imports {items} from {}", name(module), name(other)));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "imports of a higher layer:\n{}", wrong.join("\n"));
}

/// Modules with these sources.
fn modules(sources: &[(&str, &str)]) -> Imports {
    let path = |name: &str| -> Module {
        name.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect()
    };
    let sources: BTreeMap<Module, String> =
        sources.iter().map(|(name, source)| (path(name), (*source).to_owned())).collect();
    Imports::of(&sources, "own")
}

/// The circles among these modules, by name.
fn circles(sources: &[(&str, &str)]) -> Vec<Vec<String>> {
    let circles = modules(sources).circles();
    circles.iter().map(|circle| circle.iter().map(name).collect()).collect()
}

#[test]
fn circles_are_found_through_every_form_of_import() {
    let top = ("", "mod a; mod b;");
    for (a, b) in [
        ("use crate::b::B;", "use crate::a::{A, Other};"),
        ("use crate::{a, b::{self, B}};", "use super::a;"),
        ("use super::b::B as C;", "fn f() -> super::a::A { }"),
        ("use own::b::{c::{D, E}, *};", "impl<'a> crate::a::A<'a> for B { }"),
        ("const C: char = '\\''; use super::b;", "fn f<'a>(x: &'a str) { } use super::a;"),
    ] {
        assert_eq!(circles(&[top, ("a", a), ("b", b)]), [["a", "b"]], "{a} {b}");
    }
    let exported = [top, ("a", "pub use x::X; mod x;"), ("a::x", "use crate::b::B;")];
    let through = [("b", "use crate::a::X;")];
    assert_eq!(circles(&[&exported[..], &through].concat()), [["a::x", "b"]]);
    let inside = [top, ("a", "mod x; use x::g;"), ("a::x", "use super::f;"), ("b", "")];
    assert_eq!(circles(&inside), [["a", "a::x"]]);
    // A folder that calls its file by its path alone.
    let called = [top, ("a", "mod x; fn f() { x::g() }"), ("a::x", "use super::F;"), ("b", "")];
    assert_eq!(circles(&called), [["a", "a::x"]]);
    // In a body, by the name of a folder above.
    let imported = [top, ("a", "use super::b; fn f() { b::g() }"), ("b", "pub use c::g; mod c;")];
    let below = [("b::c", "use super::super::a::A;")];
    assert_eq!(circles(&[&imported[..], &below].concat()), [["a", "b::c"]]);
    let three = [
        ("a", "use crate::b::{B, C};"),
        ("b", "use crate::c;"),
        ("c", "use crate::a::A;"),
        ("d", "use crate::a::A;"),
    ];
    let imports = modules(&three);
    assert_eq!(circles(&three), [["a", "b", "c"]]);
    assert_eq!(
        imports.describe(&imports.circles()[0]),
        "a imports B, C from b; b imports * from c; c imports A from a"
    );
}

#[test]
fn what_is_no_import_makes_no_circle() {
    for a in [
        "// use crate::b::B;",
        "/* use crate::b::B; */",
        "const TEXT: &str = \"use crate::b::B;\";",
        "const TEXT: &str = r#\"\"use crate::b::B;\"#;",
        "fn f() { b::g(); x.b(); } fn g() -> impl Iterator + use<'_> { crate::f() }",
        "use other::b::B; use std::b;",
        "pub(in crate::b) fn f() { }",
    ] {
        assert!(circles(&[("", ""), ("a", a), ("b", "use crate::a::A;")]).is_empty(), "{a}");
    }
}

/// `cargo test` tries the same random cases every time: `.cargo/config.toml` has their seed.
#[test]
fn random_cases_have_a_seed() {
    let seed = proptest::test_runner::Config::default().rng_seed;
    assert!(
        matches!(seed, proptest::test_runner::RngSeed::Fixed(_)),
        "PROPTEST_RNG_SEED is not set"
    );
}

/// The folders that read numbers of files and of the command line.
const READERS: [&str; 13] = [
    "src/numbers/machine",
    "src/numbers/formula",
    "src/schemes/scheme",
    "src/geometry/mesh/read",
    "src/geometry/net/read",
    "src/geometry/solid/read",
    "src/claims/claim",
    "src/claims/shipped",
    "src/claims/literal",
    "src/claims/evaluation",
    "src/claims/judge",
    "src/cli",
    "proofs/checker/src",
];

/// What an integer of a file must not go through: −2^63 has no absolute value, and a number beyond a cap is an error and
/// no other number. `exact::within` is for caps, and `decimal::capped` of the checker.
const NOT_IN_READERS: [&str; 6] =
    [".abs() <", ".abs() >", ".wrapping_", ".overflowing_", "parse().unwrap_or", ".parse().map_or"];

#[test]
fn readers_do_not_wrap_integers() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut folders, mut wrong) = (READERS.map(|folder| root.join(folder)).to_vec(), Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let found =
                text.lines().filter(|line| NOT_IN_READERS.iter().any(|what| line.contains(what)));
            wrong.extend(found.map(|line| format!("{}: {}", path.display(), line.trim())));
        }
    }
    assert!(wrong.is_empty(), "integers that may wrap:\n{}", wrong.join("\n"));
}
