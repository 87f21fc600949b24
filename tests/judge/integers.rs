//! Relations for all integers, by functions of an integer, and about rings of all valences.

use super::relations::verdict;
use subcert::audit::Word;

/// A ring in which something is different at the valence 40.
const RING: &str = "[[scheme]]\nname = 'late'\nparameters.N = {}\norbits = { vertex = '1', edge = 'N' }\n\
    edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]\n\
    weights.vertex = { vertex = '1 - b', edge = 'b/N' }\n\
    weights.edge = { vertex = '3/8', edge = '(3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8' }\n\
    let = { turn = 'mod(j - i, N)', b = '(1 + (N - 40)^2/(N + 40)^2)/8' }\n";

#[test]
fn what_is_so_at_all_valences_is_proved_and_the_contrary_refuted() {
    let lambda = "(5 + cos(2*pi/n) + sqrt((9 + cos(2*pi/n))*(1 + cos(2*pi/n))))/16";
    let half = "(5 + cos(2*pi/n) + cos(pi/n)*sqrt(2*(9 + cos(2*pi/n))))/16";
    let face = "(1 + cos(2*pi/n))/(16*subdominant(catmull-clark, n) - 4)";
    for (text, from, word) in [
        ("subdominant(loop, n) = 3/8 + cos(2*pi/n)/4", 3, Word::Holds),
        ("subdominant(loop-warren, n) = 3/8 + cos(2*pi/n)/4", 3, Word::Holds),
        (&format!("subdominant(catmull-clark, n) = {lambda}"), 3, Word::Holds),
        (&format!("subdominant(catmull-clark, n) = {half}"), 3, Word::Holds),
        (&format!("subdominant(catmull-clark, n) = {}", half.replace('9', "8")), 3, Word::Fails),
        ("subdominant(doo-sabin, n) = 1/2", 3, Word::Holds),
        ("subdominant(mid-edge, n) = (1 + cos(2*pi/n))/2", 3, Word::Holds),
        ("subdominant(catmull-clark, n) < (3 + sqrt(5))/8", 3, Word::Holds),
        ("subdominant(catmull-clark, n) < 65/100", 3, Word::Fails),
        ("eigenvalue(loop, n, 0, 2) = subdominant(loop, n)^2", 3, Word::Holds),
        ("eigenvalue(loop, n, 2, 1) < subdominant(loop, n)", 4, Word::Holds),
        ("eigenvalue(loop, n, 2, 1) < subdominant(loop, n)", 3, Word::Fails),
        ("eigenvalue(catmull-clark, n, 0, 1) = 1", 3, Word::Holds),
        ("eigenvalue(sqrt3, n, 1, 1) = 2*(1 + cos(2*pi/n))/9", 3, Word::Holds),
        ("eigenvalue(modified-butterfly, n, 1, 1) = 1/2", 5, Word::Holds),
        ("limit_weight(catmull-clark, n) = n/(n + 5)", 3, Word::Holds),
        ("limit_weight(catmull-clark, n) = n/(n + 6)", 3, Word::Fails),
        ("limit_weight(catmull-clark, n, orbit = face) = 1/(n*(n + 5))", 3, Word::Holds),
        ("limit_weight(loop-warren, n) = 1/2", 4, Word::Holds),
        ("limit_weight(doo-sabin, n) = 1/n", 3, Word::Holds),
        ("tangent_weight(loop, n, 3, orbit = edge) = cos(6*pi/n)", 3, Word::Holds),
        (&format!("tangent_weight(catmull-clark, n, 0, orbit = face) = {face}"), 3, Word::Holds),
        ("tangent_weight(catmull-clark, n, 4) = 0", 3, Word::Holds),
        ("curvature(catmull-clark, n) > 1", 5, Word::Holds),
        ("curvature(catmull-clark, n) > 1", 4, Word::Fails),
        ("curvature(loop, n) = curvature(loop, n, part = hyperbolic)", 7, Word::Holds),
        ("curvature(loop, n, part = elliptic) <= 1", 4, Word::Holds),
        ("curvature(doo-sabin, n) = 1", 4, Word::Holds),
        // 5/8 − n/32 is −1 at n = 52, so that the points have no limit from there on.
        ("limit_weight(loop-weight, n, beta = 1/32) > 0", 3, Word::Open),
        // A valence at which something else is so lies behind those that are tried.
        ("limit_weight(late, n) < 3/4", 3, Word::Open),
        ("limit_weight(late, n) < 3/4", 41, Word::Holds),
    ] {
        let found = verdict(RING, &format!("states = '{text}'\nfor = 'all n >= {from}'\n"));
        assert_eq!(found, word, "{text} for all n >= {from}");
    }
}

#[test]
fn comparisons_of_functions_of_an_integer_are_proved_and_the_contrary_refuted() {
    for (text, from, word) in [
        ("sqrt(n^2 + 1) > n", 3, Word::Holds),
        ("sqrt(n^2 + 1) - n < 1/n", 3, Word::Holds),
        ("sqrt(n^2 + 1) - n < 1/(2*n) - 1/n^2", 3, Word::Fails),
        ("1/n <= 1/3", 3, Word::Holds),
        ("1/n < 1/3", 3, Word::Fails),
        ("cos(2*pi/n) > 1 - 20/n^2", 3, Word::Holds),
        ("cos(2*pi/n) > 1 - 19/n^2", 3, Word::Fails),
        ("cos(2*pi/n) < 1 - 39/2/n^2", 3, Word::Fails),
        ("cos(pi/n)^2 = (1 + cos(2*pi/n))/2", 3, Word::Holds),
        ("cos(pi - pi/n) = -cos(pi/n)", 3, Word::Holds),
        ("cos(3*pi/n) < cos(2*pi/n)", 3, Word::Holds),
        ("max(n, 3) + abs(1 - n) = 2*n - 1", 3, Word::Holds),
        ("floor(1/n) + ceil(1/n) + mod(n - 1, n) = n", 3, Word::Holds),
        ("kronecker(n, 2)", 3, Word::Fails),
        ("not kronecker(n, 2)", 3, Word::Holds),
        ("1/n in {2/n - 1/n, 5}", 3, Word::Holds),
        // Something else is so behind the values that are tried.
        ("1/(n - 100) < 1/50", 3, Word::Open),
        ("1/(n - 200) < 1", 3, Word::Open),
        ("floor(n/50) = 0", 3, Word::Open),
        ("floor(n/27) = 0", 3, Word::Open),
        ("sqrt(100 - n) >= 0", 3, Word::Open),
        ("max(n, 50) = 50", 3, Word::Open),
        ("kronecker(1/n, 1/1000) = 0", 3, Word::Open),
        ("cos(2*pi*n/7) < 2", 3, Word::Open),
        ("2^n > n", 3, Word::Open),
        // Large powers and multiples end at caps.
        ("((n + 1)^64)^64 > 0", 3, Word::Open),
        ("((n + cos(pi/n))^64)^64 > 0", 3, Word::Open),
        ("cos(128*pi/n) > -2", 3, Word::Open),
        ("root([-n, 0, 1], 2) = sqrt(n)", 3, Word::Open),
    ] {
        let found = verdict("", &format!("states = '{text}'\nfor = 'all n >= {from}'\n"));
        assert_eq!(found, word, "{text} for all n >= {from}");
    }
    let families = "[[scheme]]\nname = 'spline'\nparameters.k = {}\nsymbol = '(1+z)^(k+1)/2^k'\n";
    let of = "for = ['i = 1..3', 'all n']\n";
    let text = "1/sum_rules(spline, k = n) = i/(i*n + i)";
    assert_eq!(verdict(families, &format!("states = '{text}'\n{of}")), Word::Holds);
}

#[test]
fn the_difference_of_numbers_without_a_common_field_is_enclosed() {
    let field = "states = 'cos(pi/n) > sqrt(30)'\nfor = 'n = 209'\n";
    let paper =
        crate::common::claims::paper(&format!("[[relation]]\nid = 'r'\nlocus = 'l'\n{field}"));
    let audit = crate::common::claims::judged(&paper);
    assert_eq!(audit.equations[0].verdict.word(), Word::Fails);
    let text = subcert::certificate::certificate(&audit).text;
    assert!(text.contains("case 209 in "), "{text}");
}
