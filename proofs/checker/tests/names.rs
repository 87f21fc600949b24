//! A name means one thing in a claim: files in which one has two meanings are refused, and what could
//! be certified of them by taking one of the two is not.

use subcert_check::{Outcome, check};

/// A claim file, and certificates of which none is accepted.
struct Case {
    claims: &'static str,
    certificates: &'static [&'static str],
}

const REFUSED: &[Case] = &[
    // A definition hides the level of a theorem: its bound would be constant.
    Case {
        claims: "[define]\nk = '0'\n[[theorem]]\nid = \"t\"\nscheme = \"four-point:w=1/16\"\n\
                 bounds = \"difference\"\nby = '1000*beta*(1/3)^k'\nfrom = '0'\n",
        certificates: &[],
    },
    // The header of a column is also a definition.
    Case {
        claims: "[define]\nd = 'contraction(1)'\n[[table]]\nid = \"t\"\nvalue = 'd'\n\
                 scheme = \"chaikin\"\ncolumns = { name = \"d\", values = ['1/2', '1/4'] }\n\
                 cells = [['0.5', '0.25']]\n",
        certificates: &["table t\n scheme chaikin\n value d\n cell 1 1 \"0.5\" 1/2 confirmed\n \
             cell 1 2 \"0.25\" 1/4 confirmed\n"],
    },
    // A stated value is also a definition.
    Case { claims: "[define]\nd = '1'\n[given]\nd = '2'\n", certificates: &[] },
    // One of the names of theorems is left open.
    Case {
        claims: "[[theorem]]\nid = \"t\"\nscheme = \"chaikin\"\nbounds = \"difference\"\n\
                 by = 'beta'\nfrom = '0'\nvalues = { beta = ['1'] }\n",
        certificates: &[],
    },
    // Two parameters of a table, two indices, an index and a symbol.
    Case {
        claims: "[[table]]\nid = \"t\"\nvalue = 'x'\nrows = { name = \"x\", values = ['1'] }\n\
                 columns = { name = \"x\", values = ['2'] }\ncells = [['2']]\n",
        certificates: &["table t\n value x\n cell 1 1 \"2\" 2 confirmed\n"],
    },
    Case {
        claims: "[[table]]\nid = \"t\"\nvalue = 'x'\ngiven = { x = '1' }\nunstated = { x = '2' }\n\
                 columns = { name = \"y\", values = ['2'] }\ncells = [['2']]\n",
        certificates: &["table t\n value x\n cell 1 1 \"2\" 2 confirmed assuming x\n"],
    },
    Case {
        claims: "[[equation]]\nid = \"e\"\nsymbols = [\"i\"]\nleft = 'i'\nright = '1'\n\
                 indices = [{ name = \"i\", values = ['1'] }]\n",
        certificates: &["equation e\n left i\n right 1\n holds 1\n"],
    },
    // Two schemes of one name; a parameter of a scheme that is also one of its formulas, or an index.
    Case {
        claims: "[[scheme]]\nname = \"s\"\nmask = [['1'], ['1']]\n[[scheme]]\nname = \"s\"\n\
                 mask = [['1', '0'], ['1', '0']]\n",
        certificates: &[],
    },
    Case {
        claims: "[[scheme]]\nname = \"s\"\nparameters.w = { default = '1' }\nlet = { w = '2' }\n\
                 mask = [['w'], ['1']]\n",
        certificates: &[],
    },
    Case {
        claims: "[[scheme]]\nname = \"s\"\nparameters.r = { default = '1' }\narity = '2'\n\
                 width = '1'\nentry = 'r'\n",
        certificates: &[],
    },
    // `pi`, and ids that would print as lines of their own.
    Case {
        claims: "[[range]]\nid = \"r\"\nvariable = \"pi\"\nvalue = 'pi'\nbelow = '1'\nto = '1'\n",
        certificates: &[],
    },
    Case {
        claims: "[[equation]]\nid = \"e\\nvalid       doe:theorem-1\"\nleft = '1'\nright = '1'\n",
        certificates: &[],
    },
];

#[test]
fn files_in_which_a_name_has_two_meanings_are_refused() {
    for Case { claims, certificates } in REFUSED {
        let claims = format!("key = \"names\"\n{claims}");
        let certificates: Vec<String> = certificates
            .iter()
            .map(|text| format!("subcert-certificate 4\npaper names\n{text}end 1\n"))
            .collect();
        let certificates: Vec<&str> = certificates.iter().map(String::as_str).collect();
        assert!(check(&claims, &certificates).is_err(), "{claims}");
    }
}

/// What is known of the only claim of a file.
fn outcome(claims: &str, certificate: &str) -> Outcome {
    let claims = format!("key = \"names\"\n{claims}");
    let certificate = format!("subcert-certificate 4\npaper names\n{certificate}end 1\n");
    let mut report = check(&claims, &[&certificate]).unwrap_or_else(|why| panic!("{why}"));
    report.claims.remove(0).2
}

#[test]
fn what_the_paper_states_is_not_the_spread_of_a_theorem() {
    let claims = "[given]\nbeta_1 = '1'\n[[theorem]]\nid = \"t\"\nscheme = \"chaikin x chaikin\"\n\
                  bounds = \"difference\"\nby = 'beta*beta_1*(1/2)^k'\nfrom = '0'\n";
    let proved = "theorem t\n bounds difference\n by beta*beta_1*(1/2)^k\n scheme chaikin x chaikin\n \
                  grows 1 1/2\n times 1\n level 0\n proved\n";
    // A net that does not vary along the first index.
    let refuted = "theorem t\n bounds difference\n by beta*beta_1*(1/2)^k\n \
                   scheme chaikin x chaikin\n level 0\n polygon 0 0\n polygon 0 0 1\n at 0 0 2\n \
                   sides 1 0\n refuted\n";
    assert!(matches!(outcome(claims, proved), Outcome::Invalid(..)));
    assert_eq!(outcome(claims, refuted), Outcome::Valid);
    // Of a curve there is no beta_1, whatever the paper states.
    let curve = claims.replace("chaikin x chaikin", "chaikin");
    let proved = proved.replace("chaikin x chaikin", "chaikin");
    assert!(matches!(outcome(&curve, &proved), Outcome::Invalid(..)));
}

#[test]
fn a_hypothesis_says_nothing_of_the_spread() {
    let claims = "[given]\nbeta = '1/4'\n[[theorem]]\nid = \"t\"\nscheme = \"chaikin\"\n\
                  bounds = \"difference\"\nby = '(1/2)^k/2'\nfrom = '0'\n\
                  supposes = { value = 'beta', below = '1/2' }\n";
    let refuted = "theorem t\n bounds difference\n by (1/2)^k/2\n scheme chaikin\n level 0\n \
                   polygon 0 0 1\n at 0\n sides 1 1/2\n refuted\n";
    assert!(matches!(outcome(claims, refuted), Outcome::Invalid(..)));
    let without = claims.replace("supposes = { value = 'beta', below = '1/2' }\n", "");
    assert_eq!(outcome(&without, refuted), Outcome::Valid);
}

#[test]
fn a_product_of_products_has_too_many_axes() {
    let of = |scheme: &str| {
        let claims = format!(
            "[[scheme]]\nname = \"p\"\nuse = \"chaikin x chaikin\"\n[[table]]\nid = \"t\"\n\
             value = 'contraction(1)'\nscheme = \"{scheme}\"\ncolumns = {{ name = \"x\", values = ['5'] }}\n\
             cells = [['0.5']]\n"
        );
        let certificate = format!(
            "table t\n scheme {scheme}\n value contraction(1)\n cell 1 1 \"0.5\" 1/2 confirmed\n"
        );
        outcome(&claims, &certificate)
    };
    assert_eq!(of("p"), Outcome::Valid);
    assert!(matches!(of("p x chaikin"), Outcome::Invalid(..)));
    assert!(matches!(of("chaikin x p"), Outcome::Invalid(..)));
}

#[test]
fn an_index_hides_nothing() {
    let table = |define: &str, given: &str, value: &str| {
        let claims = format!(
            "[define]\nd = '{define}'\n[[table]]\nid = \"t\"\nvalue = '{value}'\n\
             given = {{ {given} }}\ncolumns = {{ name = \"x\", values = ['5'] }}\ncells = [['6']]\n"
        );
        let certificate = format!("table t\n value {value}\n cell 1 1 \"6\" 6 confirmed\n");
        outcome(&claims, &certificate)
    };
    assert_eq!(table("i", "", "sum(i = 1..3, d)"), Outcome::Valid);
    for (define, given, value) in [
        ("i", "i = '2'", "sum(i = 1..3, d)"),
        ("x", "", "sum(x = 1..3, d)"),
        ("1", "", "sum(d = 1..3, d)"),
    ] {
        assert!(matches!(table(define, given, value), Outcome::Invalid(..)), "{value}");
    }
}

#[test]
fn what_is_absent_has_no_sides() {
    let certificate = "equation e\n absent a table\n";
    let claims = "[[equation]]\nid = \"e\"\nabsent = \"a table\"\n";
    assert_eq!(outcome(claims, certificate), Outcome::Valid);
    let both = format!("{claims}left = '1'\nright = '2'\n");
    assert!(matches!(outcome(&both, certificate), Outcome::Invalid(..)));
}

#[test]
fn hypotheses_hold_together() {
    let equation = |hypotheses: &str, verdict: &str| {
        let claims = format!(
            "[[equation]]\nid = \"e\"\nsymbols = [\"a\"]\nhypotheses = [{hypotheses}]\n\
             left = 'a[1]'\nright = '3'\n"
        );
        outcome(&claims, &format!("equation e\n left a[1]\n right 3\n {verdict}\n"))
    };
    assert_eq!(equation("'a[1] = a[0]', 'a[0] = 3'", "holds 1"), Outcome::Valid);
    assert_eq!(equation("'a[0] = 3', 'a[1] = a[0]'", "holds 1"), Outcome::Valid);
    assert_eq!(equation("'a[0] = a[1] + a[2]', 'a[2] = a[0] - 3'", "holds 1"), Outcome::Valid);
    for hypotheses in [
        "'a[1] = 3', 'a[1] = 4'",
        "'a[1] = a[1] + 1'",
        "'a[1] = a[0]^2', 'a[0] = 2'",
        "'b[1] = b[2]', 'a[1] = 3'",
    ] {
        assert!(matches!(equation(hypotheses, "holds 1"), Outcome::Invalid(..)), "{hypotheses}");
    }
}

/// The name of an index with real values is a name of the claim.
#[test]
fn the_name_of_an_index_with_real_values() {
    for (of, fits) in [("real v", true), ("real delta", false), ("0 < delta < 1", false)] {
        let claims = format!(
            "key = 'k'\n[define]\ndelta = '1'\n[[relation]]\nid = 'r'\nstates = '1 = 1'\nfor = '{of}'"
        );
        let certificate =
            "subcert-certificate 4\npaper k\nrelation r\n states 1 = 1\n holds reals\nend 1";
        let valid = check(&claims, &[certificate])
            .is_ok_and(|report| report.claims.iter().all(|(.., found)| *found == Outcome::Valid));
        assert_eq!(valid, fits, "{of}");
    }
}
