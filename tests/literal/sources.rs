//! Numbers are what the program holds, or the source is refused: each text as a compiler or interpreter of its language reads it.

use super::read;
use subcert::literal::Language::{self, C, JavaScript, Matlab, Python, Rust, Shader};
use subcert::literal::Precision::{Double, Single};

/// What is held, in doubles, or words of the error.
pub(super) type Expected = Result<&'static [f64], &'static str>;

pub(super) const TWO: Expected = Ok(&[0.5, 0.25]);
pub(super) const ONE: Expected = Ok(&[0.5]);
const CALL: Expected = Err("is not computed");
pub(super) const CHANGED: Expected = Err("is changed here");
pub(super) const MAY_BE: Expected = Err("may be changed");
const UNEVEN: Expected = Err("do not have equally many numbers");
pub(super) const CONDITIONAL: Expected = Err("a conditional of the preprocessor");

const TEXTS: &[(Language, &str, Expected)] = &[
    // Lines that are joined, and comments and texts that hide what looks like code.
    (C, "double table[] = { .5, // a \\\n 7,\n .25 };", Err("this comment ends with")),
    (C, "double table[] = { .5, // a \\  \n 7,\n .25 };", Err("this comment ends with")),
    (Shader, "// a \\\nfloat table = .5;", Err("this comment ends with")),
    (C, "// a \\\n// b\ndouble table[] = { .5, // \\\n\n .25 };", TWO),
    (JavaScript, "const table = [.5, // a \\\n .25];", TWO),
    (Rust, "const table: [f64; 2] = [0.5, // \\\n 0.25];", TWO),
    (C, "double table[] = { .5, \\\n .25 };", Err("joins two lines")),
    (C, "#define A /* \n double table = 7; */ 3\ndouble table = .5;", ONE),
    (C, "#define A 1 \\\n double table = 7;\ndouble table = .5;", Err("may be changed")),
    (C, "#error don't\ndouble table = .5; // don't", ONE),
    (C, "x = R\"(\" double table = 7; )\"; double table = .5;", ONE),
    (C, "x = LR\"a( )\" double table = 7; \" )a\"; double table = .5;", ONE),
    (C, "x = \"/*\"; double table = .5; y = \"*/\";", ONE),
    (C, "x = '\"'; double table = .5; y = '\"';", ONE),
    (Rust, "/* /* */ const table: f64 = 7.; */ const table: f64 = 0.5;", ONE),
    (Rust, "x = r#\"\" const table: f64 = 7.; \"#; const table: f64 = 0.5;", ONE),
    (Rust, "fn f<'a>(r#x: &'a u8) {} const table: f64 = 0.5;", ONE),
    (JavaScript, "x = `a${`b` + '}'} const table = 7`\nconst table = .5", Err("may be changed")),
    (JavaScript, "x = y.split(/[/'\"]/); const table = .5; z = /'/", ONE),
    (JavaScript, "x = 'a\nconst table = .5 // '", Err("has no end")),
    (Python, "x = '''a' table = 7 '''\ntable = .5 # '", ONE),
    // What makes other numbers.
    (Python, "table = np.cumsum([.5, .25])", CALL),
    (Python, "table = np.flip([.5, .25])", CALL),
    (Python, "table = np.int32([.5, .25])", CALL),
    (Python, "table = max(.5, .25),", CALL),
    (Python, "table = np.array([.5, .25], np.float16)", Err("`float16`")),
    (Python, "table = np.array([.5, .25], dtype=int)", Err("does not hold this number")),
    (Python, "table = np.array([5, 2], dtype=int)", Ok(&[5.0, 2.0])),
    (Python, "table = np.array([.5, .25], dtype=np.float64)", TWO),
    (Python, "table = np.asarray([[.5], [.25]], 'f8',)", TWO),
    (Python, "table = np.array([.5, .25], dtype=object)", Err("dtype=np.float64")),
    (Python, "table = np.array([.5, .25], np.float64, order='F')", Err("only its type")),
    (Python, "table = np.array([.5], [.25])", Err("dtype=np.float64")),
    (Python, "table = np.array([.5, .25], dtype=np.float64", Err("only its type")),
    (Python, "table = np.asarray(((.5, .25),),)", TWO),
    (Python, "table = numpy.array(list([.5, .25]))", TWO),
    (Python, "table = {.5, .25, .5}", Err("have no order")),
    (C, "double table[] = { pow(2.0, -1.0), .25 };", CALL),
    (C, "double table[] = { max(.5, .25), .25 };", CALL),
    (C, "double table[] = { (.5, .25), .25 };", Err("the last one alone")),
    (C, "double table = (int)0.5;", Err("`int` is no number")),
    (C, "auto table = std::vector{.5, .25};", TWO),
    (C, "float4 table = make_float4(.5f, .25f, .5f, 0);", Ok(&[0.5, 0.25, 0.5, 0.0])),
    (C, "float2 table = make_float4(.5f, .25f);", Err("2 numbers, where 4")),
    (Shader, "const vec3 table = normalize(vec3(3.0, 4.0, 0.0));", CALL),
    (Shader, "const vec3 table = vec3(vec4(1, 2, 3, 4));", Err("4 numbers, where 3")),
    (Shader, "const mat2 table = mat2(vec2(.5, .25), vec2(0, 1));", Ok(&[0.5, 0.25, 0., 1.])),
    (JavaScript, "const table = new Set([.5, .5]);", CALL),
    (JavaScript, "const table = new Float64Array(2, 3);", Err("one list in it only")),
    (JavaScript, "const table = Object.freeze(Array.of(.5, .25))", TWO),
    (JavaScript, "const table = Float64Array.of(.5, .25)", TWO),
    (JavaScript, "const table = Array.from([.5, .25], f)", Err("one list in it only")),
    (Rust, "static table: [f64; 2] = scaled![0.5, 0.25];", CALL),
    (Rust, "let table = vec![0.5, 0.25];", TWO),
    // Lines that go on.
    (JavaScript, "const table = 5.5\n % 2;", Err("`%`")),
    (JavaScript, "const table = [.5, .25]\n .reverse();", Err("`.`")),
    (JavaScript, "const table = [.5, .25]\n [1];", Err("`[`")),
    (JavaScript, "const table = [.5, .25]\n (1);", Err("`(`")),
    (JavaScript, "const table = .5\n ? 1 : 2", Err("`?`")),
    (JavaScript, "const table = .5\n in x", Err("`in`")),
    (JavaScript, "const table = .5\n `x`", Err("`x`")),
    (JavaScript, "const table = 1 -\n .5", ONE),
    (JavaScript, "let table = .5\n++i\nlet x = 1", ONE),
    (JavaScript, "const table = [.5, .25]\nconst x = 1\n{ y() }", TWO),
    (Python, "table = 1 - \\\n .5", ONE),
    (Python, "table = \\\n [.5, .25] # \\\n\nx = 3", TWO),
    (Python, "f(table=.5\n % 2)", Err("`%`")),
    (Python, "f(x, table=.5,\n y=2)", ONE),
    (Python, "table = .5, .25", TWO),
    (Python, "x, table = 7, .25", Err("no value is assigned")),
    // Commas and brackets without numbers.
    (JavaScript, "const table = [.5,,.25]", Err("before this comma")),
    (JavaScript, "const table = [,.5, .25]", Err("before this comma")),
    (C, "double table[] = { .5, .25,, };", Err("before this comma")),
    (C, "double table[2][1] = { {}, {.5} };", Err("without a number")),
    (C, "double table[3] = {};", Err("without a number")),
    (C, "double table[] = { [1] = .5, [0] = .25 };", Err("where a comma is expected")),
    (C, "struct { double a, b; } table = { .a = .5, .b = .25 };", Err("is no number")),
    // Lists of different lengths, and what is not written.
    (C, "double table[2][2] = { {.5, 0}, {.25} };", UNEVEN),
    (C, "double table[2][2] = { {.5, 0}, .25, 0 };", UNEVEN),
    (Python, "table = [[.5], [.25, 0]]", UNEVEN),
    (JavaScript, "const table = [.5, [.25]]", UNEVEN),
    (C, "double table[3] = { .5, .25 };", Err("is declared with 3 numbers, and 2 are written")),
    (C, "#define N 3\ndouble table[N] = { .5, .25 };", Err("is declared with 3 numbers")),
    (C, "double table[][2] = { {.5}, {.25} };", Err("is declared with 4 numbers")),
    (C, "std::array<double, 3> table = { .5, .25 };", Err("is declared with 3 numbers")),
    (C, "double table[2][1] = { {.5}, {.25,}, };", TWO),
    (C, "double table[1 + 1] = { .5, .25 };", TWO),
    // What is compiled.
    (C, "#if 0\ndouble table = .5;\n#endif", CONDITIONAL),
    (C, "#ifdef A\nint x;\n#else\ndouble table = .5;\n#endif", CONDITIONAL),
    (Shader, "#version 450\n# if A\n#if B\n#endif\nfloat table = .5;\n#endif", CONDITIONAL),
    (C, "#ifdef A\nfloat\n#else\ndouble\n#endif\ntable = .5;", CONDITIONAL),
    (C, "double table[] = { .5,\n#if 1\n .25\n#endif\n};", Err("a line for the preprocessor")),
    (C, "#ifndef H\n#define H\n#ifdef A\n#endif\ndouble table = .5;\n#endif", ONE),
    (C, "#pragma once\n#if !defined(H)\n#define H 1\ndouble table = .5;\n#endif", ONE),
    (C, "int x;\n#ifndef H\n#define H\ndouble table = .5;\n#endif", CONDITIONAL),
    // What has the name, and what is done with it.
    (Python, "if x in table:\n    y = 7\ntable = .5", ONE),
    (Python, "while x < table: y = 7", Err("no value is assigned")),
    (Python, "table = [.5, .25]\ntable[0] *= 3", Err("is changed here")),
    (Python, "table = [.5, .25]\ntable.sort()", Err("is changed here")),
    (Python, "if x == table: y = 7\nfor x in self.table: y = 7\ntable = .5", ONE),
    (Python, "class A:\n  self.table = .5\n  table **= 2", Err("is changed here")),
    (C, "double table = .5; f() { table += 1; }", Err("is changed here")),
    (C, "table.x = .5;", Err("no value is assigned")),
    (JavaScript, "switch (x) { case table: y = .5 }", Err("no value is assigned")),
    // Types.
    (C, "static const int table[2] = { 0.5, 0.25 };", Err("does not hold this number")),
    (C, "unsigned char table[] = { 255, 256 };", Err("does not hold this number")),
    (C, "unsigned table[] = { 2, -1 };", Err("does not hold this number")),
    (C, "static const int table[2] = { 4, -6 };", Ok(&[4.0, -6.0])),
    (Shader, "const ivec2 table = ivec2(1.5, 2);", Err("does not hold this number")),
    (JavaScript, "const table = new Uint8Array([1, 256])", Err("does not hold this number")),
    (C, "half table[2] = { .5, .25 };", Err("no type of numbers with 32 or 64 bits")),
    (Shader, "mediump float table = .5;", Err("no type of numbers with 32 or 64 bits")),
    (C, "long double table = .5;", Err("pass through")),
    (Shader, "const dvec2 table = dvec2(vec2(.5, .25));", Err("pass through")),
    (C, "#define double float\ndouble table = .5;", Err("is a macro")),
];

/// What is done with a table `table` of 1/2 and 1/4 behind its declaration; with `const` in C, where that is read.
const USES: &[(Language, &str, Expected)] = &[
    (C, "table[0]++;", CHANGED),
    (C, "--table[0];", CHANGED),
    (C, "if (x) ++(table[0]);", CHANGED),
    (C, "(table[1]) *= 2;", CHANGED),
    (C, "table[1] <<= 2;", CHANGED),
    (C, "this->table[0] ++;", CHANGED),
    (C, "table[0].x = 2;", CHANGED),
    (C, "table[1] = 2;", Err("in 2 places")),
    (C, "double table[2] = {1, 2};", Err("in 2 places")),
    (C, "swap(table[0], table[1]);", MAY_BE),
    (C, "std::reverse(table, table + 2);", MAY_BE),
    (C, "memcpy(table, x, 16);", MAY_BE),
    (C, "double *p = table;", MAY_BE),
    (C, "double *p = &table[0], &r = x;", MAY_BE),
    (C, "double &r = table[0];", MAY_BE),
    (C, "double &r{table[0]};", MAY_BE),
    (C, "std::cin >> table[0] >> table[1];", MAY_BE),
    (C, "for (auto& x : table) x = 1;", MAY_BE),
    (C, "double *f() { return table; }", MAY_BE),
    (C, "1[table] = 3;", MAY_BE),
    (C, "(x ? table[0] : table[1]) = 3;", MAY_BE),
    (C, "\n#define BUMP table[0]++\n", Err("may be changed where this is used")),
    (C, "void fabs(double &x); fabs(table[0]);", MAY_BE),
    (C, "extern double table[2];", MAY_BE),
    (C, "y = x*table[1] + (float)table[0]; z[i] = table[0]; y += table[1];", TWO),
    (C, "n = sizeof(table)/sizeof table[0]; f(table[0] + 1); y = fabs(table[1]);", TWO),
    (C, "if (a && table[0] >= b) y = {table[0], float(table[1])}; cout << table[0];", TWO),
    (Shader, "vec2 y = vec2(table[0], table[1]);", TWO),
    (Shader, "change(table[0]);", MAY_BE),
    (JavaScript, "table[0]++", CHANGED),
    (JavaScript, "table.push(1)", CHANGED),
    (JavaScript, ";[table[0], x] = [1, 2]", CHANGED),
    (JavaScript, "for (table[0] of x) {}", CHANGED),
    (JavaScript, "table.length = 0", CHANGED),
    (JavaScript, "delete table[0]", CHANGED),
    (JavaScript, "const x = table", MAY_BE),
    (JavaScript, "change(table)", MAY_BE),
    (JavaScript, "x = `${table.push(1)}`", MAY_BE),
    (JavaScript, "x = table[0] + f(table[1], table.length); for (const y of table) {}", TWO),
    (JavaScript, "console.log([...table], `table`); module.exports = { table }", TWO),
    (Python, "table[0] = 1", Err("in 2 places")),
    (Python, "table += [1]", CHANGED),
    (Python, "x, table[0] = 1, 2", CHANGED),
    (Python, "(x, \n table) = 1, 2", CHANGED),
    (Python, "for i, table in x: pass", CHANGED),
    (Python, "del table[0]", CHANGED),
    (Python, "import x as table", CHANGED),
    (Python, "table.reverse()", CHANGED),
    (Python, "with x as table: pass", CHANGED),
    (Python, "x = table", MAY_BE),
    (Python, "x = table[:1]", MAY_BE),
    (Python, "np.dot(x, y, table)", MAY_BE),
    (Python, "np.add(x, y, out=table)", MAY_BE),
    (Python, "x = f'{table.pop}'", MAY_BE),
    (Python, "def len(x): x[0] = 1\nlen(table)", MAY_BE),
    (Python, "x = table[0]; y = f(table[1], k=1); z = len(table) + np.dot(x, table)", TWO),
    (Python, "for x in table: y[int(table[0])] = x", TWO),
    (Rust, "f(&mut table);", MAY_BE),
    (Rust, "table.swap(0, 1);", CHANGED),
    (Rust, "swap!(table[0], table[1]);", MAY_BE),
    (Rust, "let x = f(&table) + table[0]; println!(\"{}\", table[1]);", TWO),
    (Matlab, "table(2) = 5;", CHANGED),
    (Matlab, "[x, table] = f();", CHANGED),
    (Matlab, "for table = 1:2, end", CHANGED),
    (Matlab, "y = f(table) + table(1)*table(2);", TWO),
];

/// A table that may be changed is refused, and one that its language keeps is not.
#[test]
fn what_is_done_with_a_table() {
    for (language, use_, expected) in USES {
        let (open, kept) = match language {
            C | Shader => ("double table[] = {.5, .25};", "const double table[] = {.5, .25};"),
            JavaScript => ("const table = [.5, .25]", "const table = Object.freeze([.5, .25])"),
            Python => ("table = [.5, .25]", "table = (.5, .25)"),
            Rust => ("let mut table = [0.5, 0.25];", "let table = [0.5, 0.25];"),
            _ => ("table = [.5 .25];", ""),
        };
        let text = format!("{open}\n{use_}\n");
        check(*language, &text, expected);
        if let (Err(words), false) = (expected, kept.is_empty()) {
            let expected = if words.starts_with("may be") { &TWO } else { expected };
            check(*language, &format!("{kept}\n{use_}\n"), expected);
        }
    }
}

#[test]
fn as_the_language_reads_it() {
    for (language, text, expected) in TEXTS {
        check(*language, text, expected);
    }
}

pub(super) fn check(language: Language, text: &str, expected: &Expected) {
    let shape = [expected.map_or(2, <[f64]>::len)];
    match (read(language, text, &shape), expected) {
        (Ok(table), Ok(numbers)) => {
            let held: Vec<f64> = table.entries.iter().map(|entry| entry.held(Double)).collect();
            assert_eq!(held, *numbers, "{text}");
        }
        (Err(error), Err(words)) => assert!(error.to_string().contains(words), "{text}: {error}"),
        (Ok(_), Err(_)) => panic!("accepted: {text}"),
        (Err(error), Ok(_)) => panic!("refused: {text}: {error}"),
    }
}

/// The type of the numbers, where the source says it.
#[test]
fn declared_types() {
    for (language, text, precision) in [
        (C, "static const float table[2] = { 1, 2 };", Some(Single)),
        (C, "for (int i, j[3] = {1, 2, 3}, table[] = {1, 2};;) {}", None),
        (C, "float f(int a, double table = 1) {}", Some(Double)),
        (C, "int f() { return 1; } double a[] = {1, 2}, table = 1;", Some(Double)),
        (C, "std::array<std::array<double, 2>, 1> table = {{1, 2}};", Some(Double)),
        (C, "alignas(double) const float table = 1;", Some(Single)),
        (C, "Scalar table[] = { 1, 2 };", None),
        (C, "auto table = 0.5f;", None),
        (C, "auto table = 0.1;", Some(Double)),
        (C, "float4 table = {1, 2, 3, 4};", Some(Single)),
        (C, "public: GLfloat table[2] PROGMEM = {1, 2};", Some(Single)),
        (C, "double[] table = new double[] {1, 2};", Some(Double)),
        (Shader, "const dmat2x3 table = dmat2x3(1, 2, 3, 4, 5, 6);", Some(Double)),
        (Shader, "const float table[] = float[2](1, 2);", Some(Single)),
        (JavaScript, "const table = [1, 2]", None),
        (JavaScript, "const table: Float32Array = new Float32Array([1, 2])", Some(Single)),
        (JavaScript, "const table: number[] = [1, 2]", None),
        (Python, "table: list[float] = [1, 2]", None),
        (Python, "table = np.float32([1, 2])", Some(Single)),
        (Rust, "const table: &'static [[f64; N as usize]; 1] = &[[1.0, 2.0]];", Some(Double)),
        (Rust, "let table = [1.0, 2.0];", None),
    ] {
        let shapes: [&[usize]; 4] = [&[], &[2], &[4], &[6]];
        let tables: Vec<_> = shapes.iter().map(|shape| read(language, text, shape)).collect();
        let Some(table) = tables.iter().find_map(|table| table.as_ref().ok()) else {
            panic!("{text}: {}", tables.into_iter().find_map(Result::err).expect("an error"));
        };
        assert_eq!(table.declared.clone().map(|(precision, _)| precision), precision, "{text}");
    }
}
