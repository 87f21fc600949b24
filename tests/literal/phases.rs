//! What a compiler does before it reads words, and words that need more than their letters.

use super::sources::{CHANGED, CONDITIONAL, Expected, MAY_BE, ONE, TWO, check};
use subcert::literal::Language::{self, C, JavaScript, Matlab, Python, Rust};

const OTHER: Expected = Err("two signs that stand for another one");
const REMOVED: Expected = Err("is removed here");
const LINES: Expected = Err("ends lines in some languages");
const SIZE: Expected = Err("a size that is no formula of integers");
const OF_COMPILER: Expected = Err("a conditional of the compiler");

const TEXTS: &[(Language, &str, Expected)] = &[
    // Comments are blanks before lines are for the preprocessor, and `%:` is `#`.
    (C, "#define W .5\n/* a */ #undef W\n#define W .25\ndouble table = W;", REMOVED),
    (C, "#define W .5\n#undef /* a */ W\n#define W .25\ndouble table = W;", REMOVED),
    (C, "#define W .5\n%:undef W\n%:define W .25\ndouble table = W;", REMOVED),
    (C, "# /* a */ if 0\ndouble table = .5;\n#endif", CONDITIONAL),
    (C, "/* a\n */ #if 0\ndouble table = .5;\n#endif", CONDITIONAL),
    (C, "%:if 0\ndouble table = .5;\n%:endif", CONDITIONAL),
    (C, "\u{feff}#if 0\ndouble table = .5;\n#endif", CONDITIONAL),
    (C, "#i\\\nf 0\ndouble table = .5;\n#endif", Err("joins two parts of a word")),
    (C, "#if defined(H) /* ! */\n#define H\n#endif\ndouble table = .5;", ONE),
    (C, "#if defined(H) /* ! */\n#define H\ndouble table = .5;\n#endif", CONDITIONAL),
    (C, "int x; /*\n*/ #if 0\ndouble table = .5;", ONE),
    (C, "#define B 1'000 /* it's\ndouble table = .25;\n*/\ndouble table = .5;", ONE),
    (C, "#define B '\\'' /* it's\ndouble table = .25;\n*/\ndouble table = .5;", ONE),
    (C, "double table[] = <% .5, .25 %>;", OTHER),
    (C, "double table[] = {.5, .25}; f() { table<:0:> = 3; }", OTHER),
    (C, "std::vector<::X> x; double table[] = {.5, .25};", TWO),
    (C, "#define G(x) x##le\ndouble table[] = {.5, .25}; f() { G(tab)[0] = 3; }", MAY_BE),
    (C, "#define floor(x) x = 3\ndouble table[] = {.5, .25}; f() { y = floor(table[0]); }", MAY_BE),
    (C, "T &floor(T &x); double table[] = {.5, .25}; f() { y = floor(table[0]); }", MAY_BE),
    (C, "double table[] = {.5, .25}; f() { y = x * floor(table[0]); z = a & floor(b); }", TWO),
    (C, "if constexpr (a) { f(); } else { const double table = .5; }", OF_COMPILER),
    (C, "if constexpr (a) { f(); } const double table = .5;", ONE),
    (Rust, "#[cfg(any())]\nconst table: [f64; 2] = [0.5, 0.25];", OF_COMPILER),
    (Rust, "#[cfg(test)] mod a { fn f() {} const table: f64 = 0.5; }", OF_COMPILER),
    (Rust, "#![cfg(test)] fn f() {} const table: f64 = 0.5;", OF_COMPILER),
    (Rust, "cfg_if! { if #[cfg(a)] { } else { const table: f64 = 0.5; } }", OF_COMPILER),
    (Rust, "#[cfg(test)] mod a { x! {} }\nconst table: f64 = 0.5;", ONE),
    // `/` and `'` depend on what stands before them.
    (JavaScript, "let table=[.5,.25];let i=4;let j=i++/2;table[0]=3;let k=j/2;", Err("2 places")),
    (JavaScript, "let table=[.5,.25];if(a)/\"/.test(s);table[0]++;/\"/.test(s);", CHANGED),
    (JavaScript, "let table=[.5,.25];for(x of/['\"]/.exec(s))table[0]++;let y=\"'\"", CHANGED),
    (JavaScript, "let table=[.5,.25]; x = (a)/b; y = c.if(a)/\"/\".length; z = d.of/2/1", TWO),
    (JavaScript, "let table=[.5,.25]; x = {}\n/2/1", Err("divides or begins")),
    (JavaScript, "let table=[.5,.25]; t\\u0061ble[0] = 3", Err("`\\u`")),
    (Matlab, "table = [.5, .25];\na = x.'; table(1) = 9; b = y.';", CHANGED),
    (Matlab, "table = [.5, .25];\na = x''; table(1) = 9; b = y';", CHANGED),
    (Matlab, "table = [.5, .25];\na = x '; table(1) = 9; b = y ';", Err("transposes or begins")),
    (Matlab, "table = [.5, .25];\na = {x 'table(1) = 9;'};\nif x\n'table(1) = 9;'\nend", TWO),
    (Matlab, "table = [.5\n- .25]", Ok(&[0.5, -0.25])),
    (Matlab, "table = [.5 ...\n- .25, .25]", TWO_OF_ROW),
    (Python, "table = (.5, .25)\r# a\rtable = (3, 3)\r", LINES),
    (C, "double table[] = {.5, .25}; // a\rtable[0] = 3;\n", LINES),
    (JavaScript, "const table = .5; // a\u{2028}table = 3", LINES),
    (Python, "table = (.5, .25) # a\u{2028}table = 3", TWO),
    (Python, "\u{ff54}able = 3\ntable = .5", Err("ASCII")),
    // Sizes.
    (C, "enum { N = 4 };\ndouble table[N] = {.5, .25};", SIZE),
    (C, "double table[2*2] = {.5, .25};", Err("is declared with 4 numbers")),
    (C, "double table[0x4] = {.5, .25};", Err("is declared with 4 numbers")),
    (C, "double table[4u] = {.5, .25};", Err("is declared with 4 numbers")),
    (C, "std::array<double, 0x4> table = {.5, .25};", Err("is declared with 4 numbers")),
    (C, "double table[][4] = {.5, .25};", Err("is declared with 4 numbers")),
    (C, "double table[][2] = {.5, .25};", TWO),
    (C, "#define N (M + 1)\n#define M 1\ndouble table[N] = {.5, .25};", TWO),
    (C, "#ifdef A\n#define N 4\n#endif\ndouble table[N] = {.5, .25};", CONDITIONAL),
    // What gets the table too, and names with a meaning of their own.
    (Python, "v = table = [.5, .25]", Err("is given to something else")),
    (Python, "f(table=[.5, .25])", Err("is given to something else")),
    (Python, "def f(table=[.5, .25]): pass", TWO),
    (Python, "def array(x): return x\ntable = array((.5, .25))", Err("a meaning of its own")),
    (Python, "from numpy import array\ntable = array((.5, .25))", TWO),
    (Python, "table = [.5, .25]\ntry: import os, table\nexcept E: pass", CHANGED),
    (Python, "table = [.5, .25]\nfrom x import (y, table)", CHANGED),
    (Python, "table = [.5, .25]\nwith x as (y, table): pass", CHANGED),
    (Python, "table = np.array([.5, .25])\ns = np.s_[:1]\nx = table[s]", MAY_BE),
    (Python, "table = [.5, .25]\nfor i in range(2): x = table[i] + table[i - 1]", TWO),
];

const TWO_OF_ROW: Expected = Ok(&[0.25, 0.25]);

#[test]
fn as_a_compiler_reads_it() {
    for (language, text, expected) in TEXTS {
        check(*language, text, expected);
    }
}

/// The value of a sum is computed by a recursion, which has a cap.
#[test]
fn long_sums() {
    for count in [1_001, 100_000] {
        let text = format!("double table = {};", vec!["0.5"; count].join("+"));
        let read = super::read(C, &text, &[]);
        assert_eq!(read.is_ok(), count == 1_001, "{count}");
    }
    let text = format!("double table[{}] = {{.5}};", vec!["1"; 100_000].join("+"));
    assert!(super::read(C, &text, &[]).is_err());
}
