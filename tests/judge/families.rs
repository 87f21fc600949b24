//! Relations for all integers about schemes whose symbols have powers in them.

use super::relations::verdict;
use subcert::audit::Word;

const FAMILIES: &str = "[[scheme]]\nname = 'spline'\nparameters.k = {}\nsymbol = '(1+z)^(k+1)/2^k'\n\
    [[scheme]]\nname = 'ternary'\nparameters.k = {}\nsymbol = '(1+z+z^2)^(k+1)/3^k/z^k'\n\
    [[scheme]]\nname = 'six'\nparameters.k = {}\nsymbol = '(1-z^6)^k/(1-z)^k/6^(k-1)'\n\
    [[scheme]]\nname = 'hs'\nparameters.k = {}\nsymbol = '2*((1+z)/2)^k*(-k/8 + (1+k/4)*z - k/8*z^2)/z'\n\
    [[scheme]]\nname = 'four'\nparameters.k = {}\nsymbol = 'u*((1+z)/2)^(k+3)'\nlet = { u = '2*(-1+4*z-z^2)/2/z' }\n\
    [[scheme]]\nname = 'vanish'\nparameters.k = {}\nsymbol = '2*((1+z)/2)^k*(k-30 + (61-2*k)*z + (k-30)*z^2)'\n\
    [[scheme]]\nname = 'more'\nparameters.k = {}\nsymbol = '2*((1+z)/2)^k*((k-30)*(1-z)^2/4 + z)'\n\
    [[scheme]]\nname = 'twice'\nparameters.k = {}\nsymbol = '(1+z)^(k+1)*(1+z^2)/2^(k+1)'\n\
    [[scheme]]\nname = 'beside'\nparameters.k = {}\nsymbol = '(1+z)^k/2^(k-1)*(5*z^3-2)/3/z^3'\n\
    [[scheme]]\nname = 'unequal'\nparameters.k = {}\nsymbol = '2*((1+z)/2)^2*((1+z+z^2)/2)^k'\n";

#[test]
fn what_is_so_for_all_integers_is_proved_and_the_contrary_refuted() {
    for (text, of, word) in [
        ("sum_rules(spline, k = n) = n + 1", "all n", Word::Holds),
        ("sum_rules(spline, k = n) = n + 2", "all n", Word::Fails),
        ("generation(spline, k = n) = n", "all n >= 0", Word::Holds),
        ("support(spline, k = n) = n + 1", "all n", Word::Holds),
        ("support_start(ternary, k = n) = -n/2", "all n", Word::Holds),
        ("support_end(ternary, k = n) < n/2 + 1", "all n", Word::Fails),
        ("reproduction(spline, k = n) = 1", "all n", Word::Holds),
        ("approximation_order(spline, k = n) = 2", "all n", Word::Holds),
        ("approximation_order(spline, k = n, data = adapted) = n + 1", "all n", Word::Holds),
        ("symmetric(spline, k = n)", "all n", Word::Holds),
        ("smoothness(spline, k = n) = n - 1", "all n", Word::Holds),
        ("smoothness(spline, k = n) >= n", "all n", Word::Fails),
        ("hoelder(spline, k = n) = n", "all n", Word::Holds),
        ("sobolev(spline, k = n) = n + 1/2", "all n", Word::Holds),
        ("sobolev(spline, k = n) > n + 1/2", "all n", Word::Fails),
        ("sobolev(ternary, k = n) = n + 1/2", "all n", Word::Holds),
        ("independent(spline, k = n)", "all n", Word::Holds),
        ("not independent(twice, k = n)", "all n", Word::Holds),
        ("independent(twice, k = n)", "all n", Word::Fails),
        ("hurwitz(spline, k = n)", "all n", Word::Holds),
        ("not hurwitz(four, k = n)", "all n", Word::Holds),
        ("independent(hs, k = n)", "all n >= 1", Word::Open),
        ("monotone(spline, k = n)", "all n", Word::Holds),
        ("convex(ternary, k = n)", "all n", Word::Holds),
        ("positive(ternary, k = n)", "all n >= 2", Word::Holds),
        ("not convex(spline, k = n)", "all n", Word::Fails),
        ("gibbs(spline, k = n) = 1", "all n", Word::Holds),
        ("overshoot(ternary, k = n) <= 1", "all n", Word::Holds),
        ("overshoot(spline, k = n) > 1", "all n", Word::Fails),
        ("riesz_upper(spline, k = n) = 1", "all n >= 0", Word::Holds),
        ("riesz_upper(spline, k = n) < 1", "all n", Word::Fails),
        ("modulus_upper(ternary, k = n) = 3", "all n", Word::Holds),
        // Negative coefficients become few and small with n: what is not so at first may be so later.
        ("not monotone(four, k = n)", "all n", Word::Open),
        ("monotone(four, k = n)", "all n", Word::Fails),
        ("gibbs(four, k = n) > 1", "all n", Word::Open),
        // The greatest value is beside z = 1, and so are the 17 zeros of a derivative.
        ("modulus_upper(beside, k = n) = 2", "n = 12..20", Word::Fails),
        ("modulus_upper(beside, k = n) > 2", "n = 12..20", Word::Holds),
        ("modulus_upper(beside, k = n) = 2", "all n >= 15", Word::Fails),
        // Only the greatest value is known to stay.
        ("riesz_lower(spline, k = n) < 1", "all n", Word::Open),
        ("modulus_lower(spline, k = n) = 0", "all n", Word::Open),
        ("smoothness(ternary, k = n) = n - 1", "all n >= 3", Word::Holds),
        ("arity(ternary, k = n) = 3", "all n", Word::Holds),
        ("reproduction(hs, k = n) = 3", "all n >= 4", Word::Holds),
        ("reproduction(hs, k = n) = n - 1", "all n >= 1", Word::Fails),
        ("support(hs, k = n) = n + 2", "all n >= 1", Word::Holds),
        ("sum_rules(hs, k = n) = n", "all n >= 1", Word::Holds),
        // The smoothness of these grows less than by 1 with each n.
        ("smoothness(hs, k = n) = n - 2", "all n >= 3", Word::Fails),
        ("smoothness(hs, k = n) >= n - 9", "all n >= 3", Word::Open),
        ("smoothness(four, k = n) = n", "all n", Word::Holds),
        ("hoelder(four, k = n) = n + 1", "all n", Word::Holds),
        ("reproduction(four, k = n) = 3", "all n >= 1", Word::Fails),
        // The coefficient n − 30 is 0 at n = 30 only, behind the values that are tried.
        ("support(vanish, k = n) = n + 2", "all n >= 2", Word::Open),
        ("support(vanish, k = n) = n + 2", "all n >= 31", Word::Holds),
        ("sum_rules(more, k = n) = n", "all n >= 2", Word::Open),
        // These are no masks of one arity, or no products.
        ("coefficient(spline, 0, k = n) = 1/2^n", "all n", Word::Open),
        ("sum_rules() = 2*n + 1", "all n", Word::Holds),
        ("sum_rules() = 2*n", "all n", Word::Fails),
        ("smoothness() = 2*n - 1", "all n", Word::Holds),
    ] {
        let own = "scheme = 'spline:k=2*n'\n";
        let found = verdict(FAMILIES, &format!("{own}states = '{text}'\nfor = '{of}'\n"));
        assert_eq!(found, word, "{text} for {of}");
    }
}

#[test]
fn families_stand_beside_other_indices_and_other_schemes() {
    let found =
        |text: &str, of: &str| verdict(FAMILIES, &format!("states = '{text}'\nfor = {of}\n"));
    let of = "['i = 1..3', 'all n']";
    assert_eq!(found("i*sum_rules(spline, k = n) >= i*(n + 1)", of), Word::Holds);
    assert_eq!(found("sum_rules(spline, k = n) > sum_rules(chaikin)", "'all n >= 3'"), Word::Holds);
    assert_eq!(found("sum_rules(spline, k = n) > sum_rules(chaikin)", "'all n >= 2'"), Word::Fails);
    let both = "smoothness(spline, k = n) = smoothness(ternary, k = n)";
    assert_eq!(found(both, "'all n'"), Word::Holds);
    assert_eq!(found("sum_rules(spline, k = n) + m > n", "['all m', 'all n']"), Word::Open);
}
