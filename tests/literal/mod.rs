//! Tables of numbers in the source files of programs.

mod laws;
mod phases;
mod refused;
mod sources;

use subcert::diagnostic::{Diagnostic, SourceText};
use subcert::exact::{Rational, parse_rational};
use subcert::literal::{Language, LiteralTable, Precision, Written, read_literals};

fn read(language: Language, text: &str, shape: &[usize]) -> Result<LiteralTable, Diagnostic> {
    read_literals(&SourceText::new("source", text), language, "table", shape)
}

fn held(language: Language, text: &str, shape: &[usize], precision: Precision) -> Vec<f64> {
    let table = read(language, text, shape).unwrap_or_else(|error| panic!("{error}"));
    table.entries.iter().map(|entry| entry.held(precision)).collect()
}

fn number(text: &str) -> Rational {
    parse_rational(text).expect("a number")
}

/// The same six numbers in each language, as programs write them.
#[test]
fn every_language() {
    let expected = [1.0, -0.25, 0.5, 100.0, 0.0, 3.0];
    for (language, text) in [
        (
            Language::C,
            "// table = {9};\n#define tables 7\nstatic float const table[2][3] = {\n  { 1.0f, -.25F, 5e-1f, }, // \
             table = 3\n  { +1.E2f, 0x0, /* } */ 3 },\n};\nfloat after = table[0];",
        ),
        (Language::C, "double table[2][3]{{1.,-0.25,0.5},{1'00.,0.,3u}};"),
        (
            Language::C,
            "std::array<std::array<double, 3>, 2> const table = {{ {{1, -.25, .5}}, {{100, 0, 3}} }};",
        ),
        (
            Language::Shader,
            "const vec3 table[2] = vec3[2](vec3(1, -0.25, .5), vec3(1e2, 0., 3.0f));\nvoid main() {}",
        ),
        (Language::Shader, "static float table[6] = float[](1, -0.25, .5, 100lf, 0, 3);"),
        (
            Language::JavaScript,
            "const text = 'table = [1]', table = [\n [1, -0.25, .5], [1_00, 0, 3]\n]\nfor (;;) {}",
        ),
        (
            Language::Python,
            "\"\"\"table = [1]\"\"\"\ntable: list = np.array([[1, -0.25, .5],  # table = 1\n [1e2, 0., 3]])\nx = table[0][1]",
        ),
        (Language::Python, "table = np.array([[1, -0.25, .5], [1e2, 0., 3]])"),
        (Language::Hlsl, "static const float2x3 table = float2x3(1, -0.25, .5f, 100.0, 0, 3u);"),
        (
            Language::Wgsl,
            "/* a /* table = 1; */ b */ const table = array(vec3(1, -0.25, .5), vec3(1e2f, 0., 3),);",
        ),
        (
            Language::Wgsl,
            "var<private> table: array<vec3<f32>, 2> = array<vec3<f32>, 2>(vec3<f32>(1, -0.25, .5), vec3f(1e2, 0., 3));",
        ),
        (
            Language::Matlab,
            "%{\ntable = 1\n%}\ns = 'it''s % '; table = [1 -0.25, .5 % table = 2\n 1d2 3-3 ... (\n +3]; x = table(2)\n",
        ),
        (Language::Matlab, "if x, table = {1 -0.25 .5; 100, 0, (4 -1)}, end"),
        (
            Language::Rust,
            "/* a /* table = [1]; */ b */ pub static table: &'static [[f32; 3]; 2] = \
             &[[1.0, -0.25, 0.5_f32], [1_00., 0.0, 3.]];",
        ),
    ] {
        assert_eq!(held(language, text, &[2, 3], Precision::Single), expected, "{text}");
        assert_eq!(held(language, text, &[6], Precision::Double), expected, "{text}");
    }
}

#[test]
fn one_number() {
    assert_eq!(held(Language::C, "float table = 0.1;", &[], Precision::Double), [0.1]);
    assert_eq!(held(Language::Python, "table = 0.1\nx = 2", &[], Precision::Double), [0.1]);
    let table = read(Language::C, "\n\nfloat a, table = 0.1f, b = 2;", &[]).expect("a number");
    assert_eq!(table.entries[0].line(), 3);
    let (digits, places) = (Some(1), Some(1));
    assert_eq!(
        table.entries[0].written(),
        Written::Literal { value: number("1/10"), digits, places }
    );
}

/// The value of a macro, where it does not depend on the place at which it is used.
#[test]
fn macros() {
    for (text, value) in [
        ("#define other 2\n#define table 0.5\n", 0.5),
        (
            "#ifndef H\n#define H\n  # define table (1.0 / \\\n 4) // half\nx = table * 2;\n#endif",
            0.25,
        ),
        ("#define table -0.5f", -0.5),
        ("#define table (float)0.1", f64::from(0.1_f32)),
    ] {
        assert_eq!(held(Language::C, text, &[], Precision::Double), [value], "{text}");
    }
    let list = "#define table {0.5,\\\n 0.25}\n";
    assert_eq!(held(Language::Hlsl, list, &[2], Precision::Single), [0.5, 0.25]);
    for (text, words) in [
        ("#define table 1.0/4", "in no brackets"),
        ("#define table(x) 1.0", "has arguments"),
        ("#define table 1.0\n#undef table", "is removed"),
        ("#define table 1.0\n#define table 2.0", "in 2 places"),
        ("#define table 1.0\ndouble table = 2;", "in 2 places"),
        ("#ifdef A\n#define table 1.0\n#endif", "depends on a conditional"),
        ("#define table other", "`other` is no number"),
        ("#define table\n", "does not occur"),
        ("#define tables 1.0", "does not occur"),
    ] {
        let error = read(Language::C, text, &[]).expect_err(text);
        assert!(error.message.contains(words), "{text}: {}", error.message);
    }
}

/// Macros in a table are replaced by their values, as the preprocessor does: `-W` of `1.0/4 + 1` is −1/4 + 1.
#[test]
fn macros_in_a_table() {
    let text = "#define W0 0.5f\n#define OPEN 1.0/4 + 1\n#define DEEP W1\n# define W1 (3 * \\\n W0) // half\n\
                static const float table[] = {W0, -OPEN, 2*OPEN,\n DEEP, W0, 0.125f };\n#define W2 7\n";
    let found = read(Language::C, text, &[6]).expect("a table");
    let held: Vec<f64> = found.entries.iter().map(|one| one.held(Precision::Single)).collect();
    assert_eq!(held, [0.5, 0.75, 1.5, 1.5, 0.5, 0.125]);
    let texts: Vec<&str> = found.entries.iter().map(|one| &found.source.text[one.span()]).collect();
    assert_eq!(texts[..4], ["0.5f", "-1.0 / 4 + 1", "2*1.0 / 4 + 1", "( 3 * 0.5f )"]);
    let lines: Vec<usize> = found.entries.iter().map(subcert::literal::Entry::line).collect();
    assert_eq!(lines, [6, 6, 6, 7, 7, 7]);
    // In a macro that is a table the others may follow.
    let list = "#define table {A, B}\n#define A 0.5\n#define B 0.25\n";
    assert_eq!(self::held(Language::C, list, &[2], Precision::Single), [0.5, 0.25]);
    let table = "double table[1] = {W};\n";
    for (before, after, words) in [
        ("", "", "the name `W` is no number, and has no `#define`"),
        ("#define W\n", "", "has no value here, or has several"),
        ("#define W 1.0\n#define W 2.0\n", "", "has no value here, or has several"),
        ("#define W(x) 1.0\n", "", "has arguments"),
        ("#define W 1.0\n#undef W\n", "", "is removed"),
        ("#ifdef A\n#define W 1.0\n#endif\n", "", "depends on a conditional"),
        ("", "#define W 1.0\n", "is defined only after this place"),
        ("#define W W2\n", "", "the name `W2` is no number"),
        ("#define W W\n", "", "more than 16 deep"),
        ("#define W V + V\n#define V W + W\n", "", "more than 16 deep"),
    ] {
        let text = format!("{before}{table}{after}");
        let error = read(Language::C, &text, &[1]).expect_err(&text);
        assert!(error.message.contains(words), "{text}: {}", error.message);
    }
    // Other languages have no macros.
    let error = read(Language::JavaScript, "const table = [W];", &[1]).expect_err("a name");
    assert!(error.message.ends_with("the name `W` is no number"), "{}", error.message);
}

/// A literal of HLSL and WGSL may be rounded to a double first: where that gives another float, it depends on the compiler.
#[test]
fn what_a_compiler_rounds_twice() {
    use Language::{Hlsl, Wgsl};
    // Beside the middle of two floats, which is the nearest double.
    let tie = "1.00000005960464478";
    for (language, text, single) in [
        (Hlsl, "static const float table = 0.1;", Some(f64::from(0.1_f32))),
        (Hlsl, "static const float table = 1.0/3.0;", Some(f64::from(1.0_f32 / 3.0))),
        (Hlsl, "static const float table = 1/3;", Some(0.0)),
        (Hlsl, &format!("static const float table = {tie};"), None),
        (Hlsl, &format!("static const float table = {tie}f;"), Some(1.0 + f64::from(f32::EPSILON))),
        (Hlsl, &format!("static const float table = {tie} - 1.0f;"), None),
        (Wgsl, "const table = 0.1f;", Some(f64::from(0.1_f32))),
        (Wgsl, &format!("const table : f32 = f32({tie});"), None),
        (Wgsl, &format!("const table = {tie}f;"), None),
    ] {
        let table = read(language, text, &[]).expect(text);
        let depends = table.entries[0].depends_on_compiler(Precision::Single);
        assert_eq!(depends, single.is_none(), "{text}");
        if let Some(single) = single {
            let found = table.entries[0].held(Precision::Single);
            assert_eq!(found.to_bits(), single.to_bits(), "{text}");
        }
    }
    let double = read(Hlsl, "static const double table = 0.1;", &[]).expect("a number");
    assert!(double.entries[0].depends_on_compiler(Precision::Double));
    assert_eq!(held(Hlsl, "double table = 0.1L;", &[], Precision::Double), [0.1]);
    let c = read(Language::C, &format!("float table = {tie};"), &[]).expect("a number");
    assert!(!c.entries[0].depends_on_compiler(Precision::Single));
}

/// A literal of C without a suffix goes through a double; this one is then half-way between two floats.
#[test]
fn literals_are_rounded_as_the_language_does() {
    let text = "float table = 1.00000005960464478;";
    assert_eq!(held(Language::C, text, &[], Precision::Single), [1.0]);
    assert_eq!(
        held(Language::Shader, text, &[], Precision::Single),
        [1.0 + f64::from(f32::EPSILON)]
    );
    assert_eq!(
        held(Language::C, "float table = 0.1f;", &[], Precision::Double),
        [f64::from(0.1_f32)]
    );
    assert_eq!(held(Language::Rust, "table = 0.1;", &[], Precision::Single), [f64::from(0.1_f32)]);
    assert_eq!(held(Language::C, "x table = 0x1.8p-1f;", &[], Precision::Single), [0.75]);
    assert_eq!(held(Language::C, "x table = 1e400;", &[], Precision::Double), [f64::INFINITY]);
    assert_eq!(held(Language::C, "x table = 1e-60f;", &[], Precision::Single), [0.0]);
}

#[test]
fn formulas() {
    let sixth = |text, language| held(language, text, &[], Precision::Double);
    assert_eq!(sixth("x table = 1.0/6;", Language::C), [1.0 / 6.0]);
    assert_eq!(sixth("x table = 1.0f/6;", Language::C), [f64::from(1.0_f32 / 6.0)]);
    assert_eq!(sixth("x table = (float)1/6.f;", Language::C), [f64::from(1.0_f32 / 6.0)]);
    assert_eq!(sixth("x table = float(1)/6;", Language::Shader), [f64::from(1.0_f32 / 6.0)]);
    // Integers are divided as the language does.
    assert_eq!(sixth("x table = -7/6;", Language::C), [-1.0]);
    assert_eq!(sixth("table = 1/6", Language::Python), [1.0 / 6.0]);
    assert_eq!(sixth("let table = 2*(3 - -1)/6;", Language::JavaScript), [8.0 / 6.0]);
    let table = read(Language::C, "x table = 1.0/6 - 2;", &[]).expect("a number");
    let value = Some(number("-11/6"));
    assert_eq!(table.entries[0].written(), Written::Expression { value });
    let broken = read(Language::C, "x table = 1/0.0;", &[]).expect("a number");
    assert_eq!(broken.entries[0].written(), Written::Expression { value: None });
    assert!(broken.entries[0].held(Precision::Double).is_infinite());
}

/// As gcc, node and Python compute them.
#[test]
fn integers_have_the_types_of_the_language() {
    use Language::{C, JavaScript, Python, Shader};
    for (language, text, value) in [
        (C, "1u-2", 4_294_967_295.0),
        (C, "-1/2u", 2_147_483_647.0),
        (C, "0xFFFFFFFF + 1", 0.0),
        (C, "4294967295 + 1", 4_294_967_296.0),
        (C, "4000000000u + 4000000000u", 3_705_032_704.0),
        (C, "4000000000u + 4000000000", 8_000_000_000.0),
        (C, "-0x80000000", 2_147_483_648.0),
        (C, "-2147483648", -2_147_483_648.0),
        (C, "-1/2ul", 9_223_372_036_854_775_807.0),
        (C, "1u - 2.0", -1.0),
        (C, "-1u*1.0f", 4_294_967_296.0),
        (Shader, "1u-2u", 4_294_967_295.0),
        (JavaScript, "9007199254740993 - 9007199254740992", 0.0),
        (JavaScript, "9007199254740992 + 1 + 1 - 9007199254740992", 0.0),
        (Python, "9007199254740992 + 1 + 1 - 9007199254740992", 2.0),
        (Python, "100000000000000000000001/100000000000000000000000", 1.0),
        (Python, "9007199254740993/3", 3_002_399_751_580_331.0),
    ] {
        let text = format!("table = {text};");
        assert_eq!(held(language, &text, &[], Precision::Double), [value], "{language:?}: {text}");
    }
    // What the type makes of a literal is no literal with a sign.
    let turned = read(C, "x table = -1u;", &[]).expect("a number");
    let value = Some(number("4294967295"));
    assert_eq!(turned.entries[0].written(), Written::Expression { value });
}
