//! Theorems of Coq: the files of the papers agree with their claim files, and none does that says something else.

use std::fs::{read_dir, read_to_string};
use std::path::PathBuf;
use subcert_check::{Agreement, Reason, Rejection, Stop, check_theorems};

fn proofs() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn text(path: &str) -> String {
    let path = proofs().join(path);
    read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The outcome for each text; the tables of the paper need no certificate.
fn outcomes(key: &str, texts: &[&str]) -> Vec<Result<Agreement, Rejection>> {
    check_theorems(&text(&format!("claims/{key}.toml")), &[], texts).expect("a claim file")
}

/// Every file of the papers without recovered parameters.
#[test]
fn the_files_of_the_papers_agree() {
    for key in ["khan2019-newton", "khan2022-doo-sabin", "mustafa2007-bajaj", "mustafa2020-nary"] {
        let folder = proofs().join("coq/papers").join(key.replace('-', "_"));
        let files = read_dir(folder).expect("a folder").map(|file| file.expect("a file").path());
        let texts: Vec<String> = files
            .filter(|file| file.extension().is_some_and(|extension| extension == "v"))
            .map(|file| read_to_string(file).expect("a text"))
            .filter(|text| key != "mustafa2020-nary" || !text.contains("(* Not stated: "))
            .collect();
        assert!(!texts.is_empty());
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        for (text, outcome) in texts.iter().zip(outcomes(key, &texts)) {
            let head = text.lines().next().unwrap_or_default();
            let theorems = text.matches("\nTheorem ").count();
            assert_eq!(outcome.map(|agreement| agreement.theorems), Ok(theorems), "{head}");
        }
    }
}

/// What is changed in a file, and how the reason begins for which it is rejected.
type Change = (&'static str, &'static str, &'static str);

/// The form of the file: nothing that could give a name another meaning, or hide a theorem.
const FORM: &str = "the file does not have the form";
/// Another statement or comment than the claim file gives.
const STATED: &str = "the theorem says ";

/// Each of these compiles, or did before the form was read strictly, but for those in a mask or proof.
const FORMS: [Change; 17] = [
    (
        "\n(* row 1",
        "\nDefinition contraction_constant (s : scheme) (c : nat) (T : Q) := True.\n\n(* row 1",
        FORM,
    ),
    ("\n(* row 1", "\nNotation \"'scheme_1'\" := other.\n\n(* row 1", FORM),
    (
        "\n(* row 1",
        "\nSection Hidden.\nVariable bounds_distance : scheme -> nat -> Q -> Prop.\n\n(* row 1",
        FORM,
    ),
    ("\n(* row 1", "\nHypothesis all : forall P : Prop, P.\n\n(* row 1", FORM),
    ("\n(* row 1", "\nParameter all : forall P : Prop, P.\n\n(* row 1", FORM),
    ("\n(* row 1", "\nModule Type Hidden.\n\n(* row 1", FORM),
    ("\n(* row 1", "\nFrom Other Require Import Definitions.\n\n(* row 1", FORM),
    ("List.\n", "List Other.\n", FORM),
    ("Local Open Scope Q_scope.\n", "Local Open Scope Z_scope.\n", FORM),
    ("Theorem finding_1", "Theorem finding_2", FORM),
    ("Theorem finding_1", "(* *) Theorem finding_1", FORM),
    ("(eq_refl true). Qed.", "(eq_refl true). Admitted.", FORM),
    ("(eq_refl true). Qed.", "(eq_refl true). Qed. Axiom a : False.", FORM),
    (" *)\n(* This bound", " *) (* \n *)\n(* This bound", FORM),
    (
        "Theorem finding_1 :\n  bounds_distance scheme_1",
        "Theorem finding_1 :\n  bounds_distance scheme_2",
        FORM,
    ),
    ("bounds_distance scheme_1 0 1 (1 # 4)", "bounds_distance scheme_1 0 1 (1 # 4) \\/ True", FORM),
    // A Greek letter in place of a Latin one, which looks alike.
    (
        "Theorem finding_1 :\n  bounds_distance",
        "Theorem finding_1 :\n  b\u{3bf}unds_distance",
        FORM,
    ),
];

/// Differences from the claim file. All are well-formed, and Coq accepts many of them.
const NEWTON: [Change; 18] = [
    ("khan2019-newton, table", "khan2019-other, table", STATED),
    ("table table-1 (", "table table-2 (", STATED),
    ("table table-1 (", "table table-9 (", "the claim file has no such claim"),
    ("row 1, column 1: ", "row 1, column 2: ", STATED),
    ("row 1, column 1: ", "row 9, column 1: ", "the table has no such cell"),
    ("j = 0, κ = 1 prints", "j = 1, κ = 1 prints", STATED),
    ("prints 0.002500", "prints 0.002600", STATED),
    ("Scheme 4 0 [[3; 1]; [1; 3]]", "Scheme 4 0 [[3; 1]; [2; 2]]", STATED),
    ("Scheme 4 0 [[3; 1]; [1; 3]]", "Scheme 4 0 [[1; 3]; [3; 1]]", STATED),
    ("Scheme 4 0 [[3; 1]; [1; 3]]", "Scheme 4 1 [[3; 1]; [1; 3]]", STATED),
    ("Scheme 4 0 [[3; 1]; [1; 3]]", "Scheme 5 0 [[3; 1]; [1; 3]]", STATED),
    ("bounds_distance scheme_1 0 1 (1 # 4)", "bounds_distance scheme_1 0 2 (1 # 4)", STATED),
    // Coq proves any greater number.
    ("bounds_distance scheme_1 0 1 (1 # 4)", "bounds_distance scheme_1 0 1 (1000 # 1)", STATED),
    (
        "bounds_distance_by scheme_1 0 1 1",
        "bounds_distance_by scheme_1 0 13 1",
        "the line does not have",
    ),
    ("scheme_1 0 4 1 (39 # 1250)", "scheme_1 0 4 1 (38 # 1250)", STATED),
    ("scheme_1 0 4 1 (39 # 1250)", "scheme_1 (-1 # 2) 4 1 (39 # 1250)", STATED),
    ("Broken at level 4", "Broken at natural parameters at level 4", STATED),
    ("Broken at level 4: 39/125000", "Broken at level 4: 39/125001", STATED),
];

const BOUND: [Change; 9] = [
    ("theorem theorem-5 (", "theorem theorem-4 (", STATED),
    ("(20): The distance", "(21): The distance", STATED),
    (
        "Refuted for quinary-three-point, c = 2",
        "Refuted for quinary-three-point, c = 20",
        "the claim lists",
    ),
    ("Refuted for quinary-three-point", "Refuted for chaikin", STATED),
    ("at level 0; the bound is", "at level 1; the bound is", STATED),
    ("the bound is sigma", "the bound is 2*sigma", STATED),
    ("[7; 21; -3]", "[7; 20; -2]", STATED),
    (
        "exceeds_distance scheme_1 0 0 1 (125 # 144)",
        "exceeds_distance scheme_1 0 0 2 (125 # 144)",
        STATED,
    ),
    (
        "exceeds_distance scheme_1 0 0 1 (125 # 144)",
        "exceeds_distance scheme_1 0 0 1 (126 # 144)",
        STATED,
    ),
];

/// At natural parameters: the shift −3/4 of the mask, the instance and its bound. Differences and promises have their own.
const NATURAL: [Change; 5] = [
    ("exceeds_distance scheme_1 (-3 # 4)", "exceeds_distance scheme_1 (-1 # 2)", STATED),
    ("exceeds_distance scheme_1 (-3 # 4)", "exceeds_distance scheme_1 0", STATED),
    ("Refuted at natural parameters for", "Refuted for", STATED),
    (
        "Refuted at natural parameters for",
        "Refuted at the parameters for",
        "the line does not have the form",
    ),
    ("1 1 (20233 # 617320)", "1 1 (20234 # 617320)", STATED),
];

/// The interpolant of the claim, and not the points before.
const RING: [Change; 3] = [
    ("ring_1 ring_2 0 1", "ring_1 ring_1 0 1", STATED),
    ("[27; 6; 6; 6; 1; 1; 1]", "[28; 5; 6; 6; 1; 1; 1]", STATED),
    ("(0, 1); (0, 2)", "(0, 1); (1, 2)", STATED),
];

#[test]
fn nothing_else_is_accepted() {
    let files: [(&str, &str, &[Change]); 5] = [
        ("khan2019-newton", "khan2019_newton/table_1", &FORMS),
        ("khan2019-newton", "khan2019_newton/table_1", &NEWTON),
        ("mustafa2020-nary", "mustafa2020_nary/theorem_5", &BOUND),
        ("mustafa2020-nary", "mustafa2020_nary/theorem_5", &NATURAL),
        ("mustafa2007-bajaj", "mustafa2007_bajaj/eq_37_step", &RING),
    ];
    for (key, file, changes) in files {
        let original = text(&format!("coq/papers/{file}.v"));
        let changed: Vec<String> =
            changes.iter().map(|(old, new, _)| original.replacen(old, new, 1)).collect();
        let texts: Vec<&str> = changed.iter().map(String::as_str).collect();
        for ((change, text), outcome) in changes.iter().zip(&texts).zip(outcomes(key, &texts)) {
            let (old, new, reason) = change;
            assert_ne!(*text, original, "{file} does not say `{old}`");
            let found = outcome.expect_err(new).reason.to_string();
            assert!(found.starts_with(reason), "{file}, `{new}`: {found}");
        }
    }
}

/// A theorem that is copied, with the next number and another second comment, is no second finding; nor is a file that
/// is given twice. Theorems about other cells may have the same numbers.
#[test]
fn a_finding_is_stated_once() {
    let original = text("coq/papers/khan2019_newton/table_1.v");
    let theorems = original.matches("\nTheorem ").count();
    let start = original.find("\n(* row 1, column 1: ").expect("a theorem");
    let (first, _) = original[start..].split_once("Qed.\n").expect("its proof");
    let next = format!("Theorem finding_{} :", theorems + 1);
    let copied = format!("{original}{}Qed.\n", first.replace("Theorem finding_1 :", &next));
    let line = |text: &str| text.matches('\n').count() + 1;
    let outcomes = outcomes("khan2019-newton", &[&original, &copied, &original]);
    let reason = |place: usize| {
        let rejection = outcomes[place].as_ref().expect_err("a copy");
        (rejection.line, rejection.reason.clone())
    };
    assert_eq!(outcomes[0].as_ref().map(|agreement| agreement.theorems), Ok(theorems));
    let earlier = line(&original[..=start]);
    assert_eq!(reason(1), (line(&original) + 1, Reason::TwiceStated(earlier)));
    assert_eq!(reason(2), (1, Reason::OtherFile));
    // A cell has one spelling.
    for spelling in ["row 01, column 1: ", "row +1, column 1: ", "row 1, column 1 again: "] {
        let other = copied.rsplit_once("row 1, column 1: ").expect("the copy");
        let other = format!("{}{spelling}{}", other.0, other.1);
        let outcome = &self::outcomes("khan2019-newton", &[&other])[0];
        let rejection = outcome.as_ref().expect_err(spelling);
        assert!(matches!(rejection.reason, Reason::Malformed(_)), "{spelling}: {rejection:?}");
    }
}

/// A certificate with the table of a number alone.
fn certificate_of(number: usize) -> String {
    let certificate = text("certificates/mustafa2020-nary.cert");
    let start = |number: usize| certificate.find(&format!("table table-{number}\n"));
    let block =
        &certificate[start(number).expect("the table")..start(number + 1).expect("the next")];
    format!("subcert-certificate 4\npaper mustafa2020-nary\n{block}end 1\n")
}

/// A depth that suffices is that of the finding: Coq proves any greater one, too.
#[test]
fn a_depth_is_the_least_one() {
    let claims = text("claims/mustafa2020-nary.toml");
    let original = text("coq/papers/mustafa2020_nary/table_6.v");
    let line = original.lines().find(|line| line.starts_with("  sufficient_depth "));
    let (start, level) =
        line.and_then(|line| line.trim_end_matches('.').rsplit_once(' ')).expect("a depth");
    let level: i64 = level.parse().expect("a number");
    let others = [level + 1, level - 1, 1_000];
    let changed = others.map(|other| {
        original.replacen(&format!("{start} {level}."), &format!("{start} {other}."), 1)
    });
    let texts: Vec<&str> = [&original].into_iter().chain(&changed).map(String::as_str).collect();
    let outcomes = check_theorems(&claims, &[&certificate_of(6)], &texts).expect("claims");
    let reasons: Vec<_> = outcomes.into_iter().map(|it| it.err().map(|it| it.reason)).collect();
    assert_eq!(reasons[0], None);
    assert_eq!(reasons[1..], others.map(|other| Some(Reason::NotLeast(other))));
}

/// T_c has an order and a number of levels, which the cell has to use.
#[test]
fn constants_are_those_of_the_cell() {
    let original = text("coq/papers/mustafa2020_nary/table_13.v");
    assert!(outcomes("mustafa2020-nary", &[&original])[0].is_ok());
    for (old, new) in [
        ("contraction_constant scheme_1 1 ", "scheme_norm scheme_1 1 "),
        ("contraction_constant scheme_1 1 ", "contraction_constant scheme_1 5 "),
    ] {
        let lemma = |text: &str| text.split(' ').next().unwrap_or_default().to_owned() + "_by";
        let changed = original.replacen(old, new, 1).replacen(&lemma(old), &lemma(new), 1);
        assert_ne!(changed, original, "{old}");
        let outcome = &outcomes("mustafa2020-nary", &[&changed])[0];
        let reason = outcome.as_ref().expect_err(new).reason.clone();
        assert_eq!(reason, Reason::NotAsked, "{new}");
    }
}

/// A value that the paper does not state is that of a valid certificate.
#[test]
fn recovered_values_come_from_a_certificate() {
    let claims = text("claims/mustafa2020-nary.toml");
    let theorems = text("coq/papers/mustafa2020_nary/table_1.v");
    let one = certificate_of(1);
    let other = one.replacen("recovered w 39/2000", "recovered w 39/2001", 1);
    let reason = |certificates: &[&str], theorems: &str| {
        let outcomes = check_theorems(&claims, certificates, &[theorems]).expect("claims");
        outcomes[0].as_ref().map_err(|rejection| rejection.reason.to_string()).err()
    };
    assert_eq!(reason(&[&one], &theorems), None);
    let without = "no valid certificate gives a value of w";
    assert_eq!(reason(&[], &theorems).as_deref(), Some(without));
    assert_eq!(reason(&[&other], &theorems).as_deref(), Some(without), "an invalid certificate");
    let changed = theorems.replacen("w = 39/2000 *)", "w = 1/16 *)", 1);
    assert!(reason(&[&one], &changed).is_some_and(|reason| reason.starts_with(STATED)));
}

/// A value that the claim file gives for a parameter that the paper leaves open stands in the first lines, once; and a
/// file says something.
#[test]
fn assumed_values_are_not_hidden() {
    let claims = "key = 'doe'
[[scheme]]
name = 'corner'
parameters.w = { about = 'tension' }
mask = [['1 - w', 'w'], ['w', '1 - w']]
[[table]]
id = 'table-1'
locus = 'Table 1'
scheme = 'corner:w=w'
value = 'contraction(c)'
unstated = { w = '2/5' }
columns = { name = 'c', values = ['1'] }
cells = [['0.80']]
";
    let said = "(* Not stated: w = 2/5 *)\n";
    let theorems = format!(
        "(** doe, table table-1 (written by `subcert prove --coq`) *)
{said}
From Coq Require Import ZArith QArith List.
From Subcert Require Import Definitions Core Error Depth Refutation Net Ring.
Import ListNotations.
Local Open Scope Q_scope.

Definition scheme_1 :=
  Scheme 5 0 [[3; 2]; [2; 3]]%Z.

(* row 1, column 1: Table 1, c = 1 prints 0.80 *)
(* It is this constant. *)
Theorem finding_1 :
  contraction_constant scheme_1 1 (4 # 5).
Proof. apply contraction_constant_by. vm_cast_no_check (eq_refl true). Qed.
"
    );
    let reason = |text: &str| {
        let outcome = check_theorems(claims, &[], &[text]).expect("claims").remove(0);
        outcome.err().map(|rejection| rejection.reason)
    };
    assert_eq!(reason(&theorems), None);
    let hidden = Reason::Stopped(Stop::Unstated("w".to_owned()));
    assert_eq!(reason(&theorems.replace(said, "")), Some(hidden));
    let twice = theorems.replace("w = 2/5", "w = 2/5, w = 2/5");
    let (empty, _) = theorems.split_once("\nDefinition").expect("an object");
    for text in [&twice[..], empty] {
        assert!(matches!(reason(text), Some(Reason::Form(_))), "{text}");
    }
}
