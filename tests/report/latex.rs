//! Errata as LaTeX documents. `.ci/latex.py` compiles them.

use subcert::report::{Block, Grid, Sheet};

#[test]
fn a_document_has_every_block_and_closes_what_it_opens() {
    let text = |text: &str| text.to_owned();
    let mut sheet = Sheet::default();
    sheet.heading(1, "Errata · A & B 2026");
    sheet.heading(2, "1. T_c · 50% of #1");
    sheet.text("a_b {c} \\d\n~e^f$");
    sheet.facts(vec![(text("ς_0"), text("[x] → y\n1 ≤ 2"))]);
    sheet.grid(Grid {
        header: vec![text("k"), text("1")],
        rows: vec![vec![text("w"), text("0.1 → 0.2\nopen")]],
        left_columns: 1,
    });
    sheet.grid(Grid {
        header: vec![text("theorem"), text("verdict")],
        rows: vec![vec![text("1"), text("a\nb")]],
        left_columns: 2,
    });
    assert_eq!(sheet.blocks.iter().filter(|block| matches!(block, Block::Grid(_))).count(), 2);
    let latex = sheet.to_latex_document();
    for part in [
        "\\documentclass{article}",
        "\\section*{Errata $\\cdot$ A \\& B 2026}",
        "\\subsection*{1. $T_{c}$ $\\cdot$ 50\\% of \\#1}",
        "$a_{b}$ \\{c\\} \\textbackslash{}d \\\\\n\\textasciitilde{}$e^{f}$\\$",
        "\\item[{$\\varsigma_{0}$}] {[x] $\\to$ y \\newline 1 $\\leq$ 2}",
        "$w$ & 0.1 $\\to$ 0.2 \\\\\n & open \\\\",
        "\\begin{longtable}{p{0.45\\linewidth}p{0.45\\linewidth}}",
        "1 & $a$ \\newline $b$ \\\\",
        "\\end{document}",
    ] {
        assert!(latex.contains(part), "no {part} in {latex}");
    }
    assert!(latex.is_ascii(), "{latex}");
    let opened = latex.matches("\\begin{").count();
    assert_eq!(opened, latex.matches("\\end{").count());
    // Without the escaped ones, braces are balanced everywhere.
    let bare = latex.replace("\\{", "").replace("\\}", "");
    let mut depth = 0_i32;
    for c in bare.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        assert!(depth >= 0, "{latex}");
    }
    assert_eq!(depth, 0);
}
