//! Reference values as a function of MATLAB and Octave that tests.

use super::header::Header;
use super::values::{Group, OracleValues, Value};
use super::write::header_lines;
use crate::diagnostic::wrapped;
use crate::mesh::one_line;
use std::fmt::Write as _;

/// The greatest length of a name in MATLAB, `namelengthmax`.
const LONGEST_NAME: usize = 63;

/// How many characters a line of help has.
const HELP_WIDTH: usize = 90;

/// The values as a file of MATLAB, which runs in Octave too: a function that returns them, each
/// as the nearest double, and that tests an implementation if it gets one. The function is
/// called [`matlab_name`], and the file has to be called so too.
///
/// Arrays count from 1 there: `values.mask(alpha + 1, j + 1)`. Control points of several
/// coordinates have one point in each row.
///
/// ```
/// use subcert::oracle::{Boundary, Control, OracleRequest, reference_values, to_matlab};
/// use subcert::scheme::parse_scheme;
///
/// let request = OracleRequest {
///     scheme: "chaikin".to_owned(),
///     max_block: 1,
///     control: Control::seeded_polygon(1, 4),
///     level: 1,
///     boundary: Boundary::Closed,
/// };
/// let file = to_matlab(&reference_values(&parse_scheme("chaikin")?, &request)?);
/// assert!(file.starts_with("function values = oracle_chaikin(refine, ulps)\n"));
/// assert!(file.contains("  values.mask = [\n    0.75 0.25\n    0.25 0.75\n  ];\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn to_matlab(values: &OracleValues) -> String {
    let name = matlab_name(&values.header.scheme);
    let arrays = arrays(&values.groups);
    let mut text = format!("function values = {name}(refine, ulps)\n");
    help(&mut text, &name, &values.header, &arrays);
    for array in &arrays {
        array.write(&mut text, &array.name, "[", "]", |value| value.f64.clone());
        if array.name == "refined" {
            let quoted = |value: &Value| format!("'{}'", value.exact);
            array.write(&mut text, "refined_exact", "{", "}", quoted);
        }
    }
    let _ = write!(text, "{}", test(values.header.level));
    text
}

/// The name of the function of a scheme: `oracle_` and the scheme, with an underscore for each
/// run of characters that names may not have, up to 63 characters.
///
/// ```
/// use subcert::oracle::matlab_name;
///
/// assert_eq!(matlab_name("four-point:w=1/16"), "oracle_four_point_w_1_16");
/// ```
#[must_use]
pub fn matlab_name(scheme: &str) -> String {
    let mut name = "oracle".to_owned();
    for part in scheme.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty()) {
        name.push('_');
        name.push_str(part);
    }
    name.truncate(LONGEST_NAME);
    name
}

/// Groups that make one array: one group, or the coordinates of points side by side.
pub(super) struct Array<'a> {
    pub(super) name: String,
    pub(super) columns: Vec<&'a Group>,
}

/// The arrays of all groups. `control-1` and `control-2` are columns of `control`.
pub(super) fn arrays(groups: &[Group]) -> Vec<Array<'_>> {
    let mut arrays: Vec<Array<'_>> = Vec::new();
    for group in groups {
        let quantity = match group.quantity.rsplit_once('-') {
            Some((quantity, number)) if number.bytes().all(|b| b.is_ascii_digit()) => quantity,
            _ => &group.quantity,
        };
        let name = quantity.replace('-', "_");
        match arrays.iter_mut().find(|array| array.name == name) {
            Some(array) => array.columns.push(group),
            None => arrays.push(Array { name, columns: vec![group] }),
        }
    }
    arrays
}

impl Array<'_> {
    /// The rows of the array.
    pub(super) fn rows(&self) -> impl Iterator<Item = Vec<&Value>> {
        let first = self.columns[0];
        let width = if first.shape.len() == 2 { first.shape[1] } else { 1 };
        (0..first.values.len() / width.max(1)).map(move |row| {
            self.columns.iter().flat_map(|group| &group.values[row * width..][..width]).collect()
        })
    }

    /// The assignment: one row of the array on each line.
    fn write(
        &self,
        text: &mut String,
        name: &str,
        open: &str,
        close: &str,
        shown: impl Fn(&Value) -> String,
    ) {
        let _ = writeln!(text, "  values.{name} = {open}");
        for row in self.rows() {
            let entries: Vec<String> = row.into_iter().map(&shown).collect();
            let _ = writeln!(text, "    {}", entries.join(" "));
        }
        let _ = writeln!(text, "  {close};");
    }
}

fn help(text: &mut String, name: &str, header: &Header, arrays: &[Array<'_>]) {
    let upper = name.to_uppercase();
    let mut paragraph = |indent: usize, line: &str| {
        for line in wrapped(&one_line(line), HELP_WIDTH, indent, false) {
            let _ = writeln!(text, "{}", format!("%{:indent$}{line}", "").trim_end());
        }
    };
    paragraph(0, &format!("{upper} Reference values of subdivision, and a test against them."));
    paragraph(3, &format!("This file has to be called {name}.m. It runs in MATLAB and in Octave."));
    paragraph(3, "");
    paragraph(
        3,
        &format!(
            "{upper}(REFINE) tests an implementation: it calls REFINED = REFINE(CONTROL, LEVEL) and \
             stops with an error if some value is more than 4 units in the last place (eps) from \
             the right double. {upper}(REFINE, ULPS) allows ULPS of them."
        ),
    );
    paragraph(
        3,
        &format!(
            "VALUES = {upper}() returns the exact values, each rounded to the nearest double, and \
             refined_exact, which has them as text. Arrays count from 1 where the formulas count \
             from 0: a[alpha][j] is mask(alpha + 1, j + 1)."
        ),
    );
    paragraph(3, "");
    for array in arrays {
        paragraph(5, &format!("{}: {}", array.name, array.columns[0].about));
    }
    paragraph(3, "");
    for (key, value) in header_lines(header) {
        if key != "columns" {
            paragraph(5, &format!("{key}: {value}"));
        }
    }
}

/// The part of the function that tests.
fn test(level: u32) -> String {
    format!(
        "
  if nargin < 1
    return
  end
  if nargin < 2
    ulps = 4;
  end
  found = refine(values.control, {level});
  expected = values.refined;
  if ~isequal(size(found), size(expected))
    error('subcert:size', 'the refined points are %s, and should be %s', ...
      mat2str(size(found)), mat2str(size(expected)));
  end
  distance = abs(found - expected) ./ eps(expected);
  wrong = find(~(distance <= ulps));
  if ~isempty(wrong)
    first = wrong(1);
    [row, column] = ind2sub(size(expected), first);
    error('subcert:value', ['%d of %d values are not within %g ulps\\n' ...
      '  the first:  refined(%d, %d)\\n  exact       %s\\n  nearest     %.17g\\n' ...
      '  found       %.17g\\n  distance    %g ulps'], numel(wrong), numel(expected), ulps, ...
      row, column, values.refined_exact{{first}}, expected(first), found(first), distance(first));
  end
  if nargout == 0
    fprintf('%d values agree within %g ulps\\n', numel(expected), ulps);
    clear values
  end
end
"
    )
}
