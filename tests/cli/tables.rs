//! Tables as CSV and as LaTeX.

use super::written;

#[test]
fn constants_as_csv() {
    let csv = written(["constants", "chaikin", "-c", "2", "--forward", "--format", "csv"]);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "direction,quantity,c,exact,decimal");
    assert!(lines.contains(&"1,contraction,2,1/4,0.25"), "{csv}");
    assert!(lines.contains(&"1,norm_forward,1,1,1"), "{csv}");
    let sound = written(["constants", "chaikin", "-c", "2", "--format", "csv"]);
    let kept: Vec<&str> = lines.into_iter().filter(|line| !line.contains("_forward")).collect();
    assert_eq!(sound.lines().collect::<Vec<&str>>(), kept);
    let surface = written(["constants", "chaikin x four-point", "-c", "1", "--format", "csv"]);
    assert!(surface.contains("\nsurface,delta,,"), "{surface}");
    let ring = written(["constants", "doo-sabin:n=4", "-c", "1", "--format", "csv"]);
    assert!(ring.contains("\ncontraction,1,1/2,0.5\n"), "{ring}");
}

#[test]
fn cells_as_csv() {
    let csv = written(["audit", "examples/my-paper.toml", "--format", "csv"]);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "id,printed,exact,decimal,verdict");
    assert_eq!(lines.len(), 13);
    assert_eq!(lines[3], "doe2026-corner:table-1:1:3,0.66,2/3,0.66666666666666667,rounding");
}

#[test]
fn tables_as_latex() {
    let latex = written(["constants", "chaikin", "-c", "2", "--forward", "--format", "latex"]);
    for part in [
        "% chaikin\n",
        "\\begin{tabular}{rrrrr}\n\\toprule\n",
        "$c$ & $T_{c}$ & $\\Lambda_{c}$ & $T_{c}$ forward & $\\Lambda_{c}$ forward \\\\\n\\midrule\n",
        "2 & 0.25 & 1 & 0.25 & 1 \\\\\n\\bottomrule\n\\end{tabular}\n",
    ] {
        assert!(latex.contains(part), "no {part} in {latex}");
    }
    let audit = written(["audit", "examples/my-paper.toml", "--format", "latex"]);
    assert!(
        audit.contains(" & 0.60 $\\checkmark$ & 0.50 $\\checkmark$ & 0.66 $\\approx$ \\\\"),
        "{audit}"
    );
    let bare = audit.lines().filter(|line| !line.starts_with('%'));
    assert!(!bare.into_iter().any(|line| line.contains(['✓', 'ε'])), "{audit}");
}
