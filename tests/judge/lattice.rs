//! Relations about masks on Z^d, with the checker.

use super::relations::verdict;
use subcert::audit::Word;

const SCHEMES: &str = "
    [[scheme]]\nname = 'courant'\nsymbol = '(1+x)*(1+y)*(1+x*y)/2'\nedges = [[1, 0], [0, 1], [1, 1]]
    [[scheme]]\nname = 'loop3'\nbox = [[1,0],[1,0],[0,1],[0,1],[1,1],[1,1]]\nedges = [[1, 0], [0, 1], [1, 1]]
    [[scheme]]\nname = 'same3'\nsymbol = 's*symbol(courant)/8'\nlet.s = '(1+x)*(1+y)*(1+x*y)'
    [[scheme]]\nname = 'five'\nsymbol = '1 + w*(x+1/x+y+1/y)'\nparameters.w = { default = '1/4' }\ndilation = [[1, 1], [1, -1]]
    [[scheme]]\nname = 'midedge'\nmask = '[[1, 1], [1, 1]]/2'\norigin = [0, 0]\ndilation = [[1, 1], [1, -1]]
    [[scheme]]\nname = 'root'\nsymbol = '1+(x+1/x+y+1/y+x/y+y/x)/3'\ndilation = [[1,2],[-2,-1]]\nedges = [[1,0],[0,1],[1,-1]]
    [[scheme]]\nname = 'solid'\nsymbol = '(1+x)*(1+y)*(1+z)*(1+x*y*z)/2'\nedges = [[1,0,0],[0,1,0],[0,0,1],[1,1,1]]
    [[scheme]]\nname = 'product'\nsymbol = 'symbol(four-point, x)*symbol(four-point, y)'
    [[scheme]]\nname = 'odd'\nmask = [['1/2', '1/2', '0'], ['1/2', '1', '1/2'], ['0', '1/2', '1/2']]\nedges = [[1, 0], [1, 1]]
";

#[test]
fn what_holds_holds_and_its_contrary_fails() {
    for (text, contrary) in [
        ("coefficient(courant, 1, 1) = 1", "coefficient(courant, 1, 1) = 1/2"),
        ("coefficient(courant, 5, 0) = 0", "coefficient(courant, 2, 2) = 0"),
        ("coefficient(solid, 1, 1, 1) = 1", "coefficient(solid, 0, 0, 0) = 1"),
        ("coefficient(odd, 0, 0) = 1", "coefficient(odd, 1, 1) = 1"),
        ("arity(root) = 3", "arity(root) = 4"),
        ("arity(solid) = 8", "arity(solid) = 4"),
        ("interpolating(five)", "not interpolating(root)"),
        ("not interpolating(midedge)", "interpolating(loop3)"),
        ("symmetric(loop3)", "not symmetric(odd)"),
        ("sum_rules(loop3) = 4", "sum_rules(loop3) = 3"),
        ("sum_rules(midedge) = 2", "sum_rules(midedge) > 2"),
        ("generation(product) = 3", "generation(product) = 4"),
        ("reproduction(product) = 3", "reproduction(product) = 1"),
        ("reproduction(loop3) = 1", "reproduction(loop3) = 3"),
        ("approximation_order(loop3) = 2", "approximation_order(loop3) = 4"),
        (
            "approximation_order(loop3, data = adapted) = 4",
            "approximation_order(loop3, data = adapted) = 2",
        ),
        ("same(loop3, with = same3)", "same(loop3, with = courant)"),
        ("not same(loop3, with = chaikin)", "same(loop3, with = chaikin)"),
        ("contraction(loop3, 2) = 1/4", "contraction(loop3, 2) < 1/4"),
        ("contraction(midedge) = 1", "contraction(midedge) < 1"),
        ("contraction(five, 3) = 5/8", "contraction(five, 3) = 9/16"),
        ("contraction(root, 2) = 4/9", "contraction(root, 2) > 4/9"),
        ("contraction(solid, 2) = 1/4", "contraction(solid, 2) != 1/4"),
        ("contraction(product) = 49/64", "contraction(product) = 25/32"),
        ("contraction(odd, 2) <= 1", "contraction(odd, 2) > 2"),
        ("norm(product) = 25/16", "norm(product) = 5/4"),
        ("norm(five, 2) = norm(five)", "norm(loop3) > 1"),
    ] {
        let fields = |text: &str| format!("states = '{text}'");
        assert_eq!(verdict(SCHEMES, &fields(text)), Word::Holds, "{text}");
        assert_eq!(verdict(SCHEMES, &fields(contrary)), Word::Fails, "{contrary}");
    }
}

/// Functions that masks on Z^d have not are refused, and so are masks on Z^d where curves are needed.
#[test]
fn what_is_refused() {
    for text in [
        "smoothness(loop3) = 2",
        "support(loop3) = 4",
        "coefficient(loop3, 1) = 0",
        "displacement(loop3) = 1",
        "biorthogonal(chaikin, with = loop3)",
    ] {
        let word = std::panic::catch_unwind(|| verdict(SCHEMES, &format!("states = '{text}'")));
        assert!(
            word.is_err() || word.is_ok_and(|word| word != Word::Holds && word != Word::Fails),
            "{text}"
        );
    }
}
