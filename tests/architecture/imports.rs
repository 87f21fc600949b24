//! Which module imports what from which other module: a reader of `use` declarations, and of the
//! paths elsewhere that begin with `crate`, `super`, `self` or a name that was imported, good enough for this
//! workspace.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{read_dir, read_to_string};
use std::path::Path;

/// The path of a module from the root of its crate: `["audit", "judge"]`.
pub type Module = Vec<String>;

/// The modules of a crate, and what each imports from others, by their names.
pub struct Imports {
    of: BTreeMap<Module, BTreeMap<Module, BTreeSet<String>>>,
}

/// What one file says.
#[derive(Default)]
struct Said {
    /// Paths that it uses.
    uses: Vec<Vec<String>>,
    /// The paths of the names that it exports again.
    exports: BTreeMap<String, Vec<String>>,
}

impl Imports {
    /// Those of the files in a folder; `name` is the crate's.
    pub fn read(folder: &Path, name: &str) -> Imports {
        let mut sources = BTreeMap::new();
        collect(folder, &Module::new(), &mut sources);
        Imports::of(&sources, name)
    }

    /// Those of modules with these sources.
    pub fn of(sources: &BTreeMap<Module, String>, name: &str) -> Imports {
        let said = |(module, source): (&Module, &String)| {
            let said = read(source, |path| absolute(path, module, sources, name));
            (module.clone(), said)
        };
        let said: BTreeMap<Module, Said> = sources.iter().map(said).collect();
        let mut of = BTreeMap::new();
        for (module, Said { uses, .. }) in &said {
            let imports: &mut BTreeMap<Module, BTreeSet<String>> =
                of.entry(module.clone()).or_default();
            for (owner, item) in uses.iter().map(|path| owner(path, &said)) {
                if owner != *module && sources.contains_key(&owner) {
                    imports.entry(owner).or_default().insert(item);
                }
            }
        }
        Imports { of }
    }

    /// Every module with what it imports from others.
    pub fn iter(&self) -> impl Iterator<Item = (&Module, &BTreeMap<Module, BTreeSet<String>>)> {
        self.of.iter()
    }

    /// The largest groups of modules that all import each other, at once or through others.
    pub fn circles(&self) -> Vec<BTreeSet<Module>> {
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            self.of.keys().map(|module| (module, self.reached(module))).collect();
        let mut circles: Vec<BTreeSet<Module>> = Vec::new();
        for (module, reach) in &reached {
            let known = circles.iter().any(|circle| circle.contains(*module));
            if reach.contains(module) && !known {
                let back = reach.iter().filter(|other| reached[*other].contains(module));
                circles.push(back.map(|other| (*other).clone()).collect());
            }
        }
        circles
    }

    /// The modules that one imports, at once or through others.
    fn reached(&self, module: &Module) -> BTreeSet<&Module> {
        let mut reached = BTreeSet::new();
        let mut waiting: Vec<&Module> = self.of[module].keys().collect();
        while let Some(next) = waiting.pop() {
            if reached.insert(next) {
                waiting.extend(self.of[next].keys());
            }
        }
        reached
    }

    /// The shortest circle through a module of a circle, in words.
    pub fn describe(&self, circle: &BTreeSet<Module>) -> String {
        let Some(first) = circle.first() else { return String::new() };
        let mut paths: Vec<Vec<&Module>> = vec![vec![first]];
        let mut met = BTreeSet::new();
        let shortest = loop {
            let mut longer = Vec::new();
            for path in &paths {
                for next in self.of[path[path.len() - 1]].keys() {
                    if met.insert(next) && circle.contains(next) {
                        longer.push([&path[..], &[next]].concat());
                    }
                }
            }
            if let Some(path) = longer.iter().find(|path| path[path.len() - 1] == first) {
                break path.clone();
            }
            assert!(!longer.is_empty(), "no circle");
            paths = longer;
        };
        let step = |pair: &[&Module]| {
            let items: Vec<&str> = self.of[pair[0]][pair[1]].iter().map(String::as_str).collect();
            format!("{} imports {} from {}", name(pair[0]), items.join(", "), name(pair[1]))
        };
        shortest.windows(2).map(step).collect::<Vec<String>>().join("; ")
    }
}

/// `audit::judge`.
pub fn name(module: &Module) -> String {
    if module.is_empty() { "the root".to_owned() } else { module.join("::") }
}

/// The sources of the files in a folder, by module, without those of other crates and of builds.
fn collect(folder: &Path, module: &Module, sources: &mut BTreeMap<Module, String>) {
    for entry in read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("a file").path();
        let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8");
        let mut inner = module.clone();
        if path.is_dir() || !["mod", "lib"].contains(&stem) {
            inner.push(stem.to_owned());
        }
        if path.join("Cargo.toml").exists() || stem == "build" {
            continue;
        }
        if path.is_dir() {
            collect(&path, &inner, sources);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            sources.insert(inner, read_to_string(&path).expect("a source"));
        }
    }
}

/// A path from the root of the crate, when it is one of the crate's own.
fn absolute(
    path: &[String],
    module: &Module,
    sources: &BTreeMap<Module, String>,
    name: &str,
) -> Option<Vec<String>> {
    let above = path.iter().take_while(|word| *word == "super").count();
    let (base, rest) = match path.first()?.as_str() {
        "crate" => (&[][..], &path[1..]),
        first if first == name => (&[][..], &path[1..]),
        "self" => (&module[..], &path[1..]),
        "super" => (&module[..module.len().checked_sub(above)?], &path[above..]),
        _ => (&module[..], path),
    };
    let absolute = [base, rest].concat();
    // A path that begins with a name is one of a module inside, or of something else.
    let inside = ["crate", "self", "super", name].contains(&path[0].as_str())
        || sources.contains_key(&absolute[..=module.len()]);
    inside.then_some(absolute)
}

/// The module that a path leads to, where names that are exported again are followed, and the name
/// there: `*` for the module itself.
fn owner(path: &[String], said: &BTreeMap<Module, Said>) -> (Module, String) {
    let mut path = path.to_vec();
    // No chain of exports is longer.
    for _ in 0..16 {
        let length = (0..=path.len()).rev().find(|length| said.contains_key(&path[..*length]));
        let (module, rest) = path.split_at(length.unwrap_or(0));
        match rest.first().and_then(|item| said.get(module)?.exports.get(item)) {
            Some(exported) => path = [&exported[..], &rest[1..]].concat(),
            None => return (module.to_vec(), rest.first().map_or("*", String::as_str).to_owned()),
        }
    }
    panic!("the exports of {} have no end", path.join("::"))
}

/// The paths of a source that `absolute` knows.
fn read(source: &str, absolute: impl Fn(&[String]) -> Option<Vec<String>>) -> Said {
    let words = words(source);
    let word = |place: usize| words.get(place).map_or("", String::as_str);
    let mut said = Said::default();
    // What the imported names stand for.
    let mut known: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut place = 0;
    while place < words.len() {
        if word(place) == "use" && word(place + 1) != "<" {
            let public = place > 0 && [")", "pub"].contains(&word(place - 1));
            let end = (place..words.len()).find(|end| word(*end) == ";").unwrap_or(words.len());
            for (mut path, new_name) in tree(&words[place + 1..end]) {
                if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
                    path.pop();
                }
                if let Some(path) = absolute(&path) {
                    let name = new_name.or_else(|| path.last().cloned()).unwrap_or_default();
                    if public {
                        said.exports.insert(name, path);
                    } else {
                        known.insert(name, path.clone());
                        said.uses.push(path);
                    }
                }
            }
            place = end;
        } else if word(place) == "in" && place > 0 && word(place - 1) == "(" {
            // The path of `pub(in path)` is no import.
            place = (place..words.len()).find(|end| word(*end) == ")").unwrap_or(words.len());
        } else if word(place + 1) == "::" && (place == 0 || word(place - 1) != "::") {
            let first = word(place);
            let imported = known.get(first);
            let mut path = imported.cloned().unwrap_or_else(|| vec![first.to_owned()]);
            let from_root = imported.is_some();
            while word(place + 1) == "::" && is_name(word(place + 2)) {
                path.push(word(place + 2).to_owned());
                place += 2;
            }
            if from_root {
                said.uses.push(path);
            } else if path.len() > 1 {
                said.uses.extend(absolute(&path));
            }
        }
        place += 1;
    }
    said
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The paths of a `use` declaration, each with the name that it gets where that is a new one.
fn tree(words: &[String]) -> Vec<(Vec<String>, Option<String>)> {
    let open = words.iter().position(|word| word == "{").unwrap_or(words.len());
    let names = words[..open].iter().filter(|word| is_name(word) || *word == "*");
    let mut path: Vec<String> = names.cloned().collect();
    if open == words.len() {
        let new_name = if words.iter().any(|word| word == "as") { path.pop() } else { None };
        path.retain(|word| word != "as");
        return if path.is_empty() { Vec::new() } else { vec![(path, new_name)] };
    }
    let mut depth = 0;
    let inner = &words[open + 1..words.len() - 1];
    let parts = inner.split(|word| {
        depth += i32::from(word == "{") - i32::from(word == "}");
        depth == 0 && word == ","
    });
    let paths = parts.flat_map(tree);
    paths.map(|(rest, name)| ([&path[..], &rest].concat(), name)).collect()
}

/// The names and signs of a source, without comments and literals.
fn words(source: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = source;
    while let Some(c) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(length) = literal(rest) {
            length
        } else if c.is_alphanumeric() || c == '_' {
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            let end = end.unwrap_or(rest.len());
            words.push(rest[..end].to_owned());
            end
        } else {
            let length = if rest.starts_with("::") { 2 } else { c.len_utf8() };
            if !c.is_whitespace() {
                words.push(rest[..length].to_owned());
            }
            length
        };
        rest = &rest[length..];
    }
    words
}

/// The length of the literal of a text or of a character that a source begins with.
fn literal(rest: &str) -> Option<usize> {
    if let Some(raw) = rest.strip_prefix('r') {
        let hashes = raw.len() - raw.trim_start_matches('#').len();
        if raw[hashes..].starts_with('"') {
            let close = format!("\"{}", "#".repeat(hashes));
            let start = 1 + hashes + 1;
            return Some(start + rest[start..].find(&close)? + close.len());
        }
    }
    let quote = rest.chars().next().filter(|c| ['"', '\''].contains(c))?;
    // A lifetime begins as a character does, and has no second quote where that would be.
    let mut inside = rest.char_indices().skip(1);
    while let Some((at, c)) = inside.next() {
        if c == '\\' {
            inside.next();
        } else if c == quote {
            return Some(at + 1);
        }
        let first = at == 1 && c != '\\';
        if quote == '\'' && first && !rest[at + c.len_utf8()..].starts_with('\'') {
            return None;
        }
    }
    None
}
