//! Breaking text into lines.

/// How many characters a text takes in a line.
#[must_use]
pub fn width_of(text: &str) -> usize {
    text.chars().count()
}

/// Breaks a text into lines of at most `width` − `indent` characters, so that each can be indented
/// by `indent`. A longer word has a line of its own; with `cut`, it is cut.
#[must_use]
pub fn wrapped(text: &str, width: usize, indent: usize, cut: bool) -> Vec<String> {
    let width = width.saturating_sub(indent).max(1);
    text.split('\n').flat_map(|paragraph| fill(paragraph.split(' '), width, cut)).collect()
}

/// Breaks these words into lines of at most `width` characters.
pub fn fill<'t>(words: impl Iterator<Item = &'t str>, width: usize, cut: bool) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in words {
        if !line.is_empty() && width_of(&line) + 1 + width_of(word) > width {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
        while cut && width_of(&line) > width {
            let at = line.char_indices().nth(width).map_or(line.len(), |(at, _)| at);
            let rest = line.split_off(at);
            lines.push(std::mem::replace(&mut line, rest));
        }
    }
    lines.push(line);
    lines
}
