//! What a file of TOML has, and how it is looked up.

/// A value of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Toml {
    /// A string.
    Text(String),
    /// `true` or `false`.
    Flag(bool),
    /// `[…]`, or the tables under `[[…]]`.
    List(Vec<Toml>),
    /// `{…}`, or the entries under `[…]`.
    Table(Table),
}

/// Keys with their values, in the order of the file.
type Table = Vec<(String, Toml)>;

impl Toml {
    /// Adds an item to the list of a key of a table.
    pub fn push(&mut self, key: &str, item: Toml) {
        let Toml::Table(table) = self else { return };
        match table.iter_mut().find(|(name, _)| name == key) {
            Some((_, Toml::List(list))) => list.push(item),
            Some(_) => {}
            None => table.push((key.to_owned(), Toml::List(vec![item]))),
        }
    }

    /// The value of a key of a table.
    pub fn get(&self, key: &str) -> Option<&Toml> {
        self.as_table().iter().find(|(name, _)| name == key).map(|(_, value)| value)
    }

    /// The string of a key.
    pub fn text(&self, key: &str) -> Option<&str> {
        self.get(key).and_then(Toml::as_text)
    }

    /// The string that this is.
    pub fn as_text(&self) -> Option<&str> {
        if let Toml::Text(text) = self { Some(text) } else { None }
    }

    /// The list that this is, or an empty one.
    pub fn as_list(&self) -> &[Toml] {
        if let Toml::List(list) = self { list } else { &[] }
    }

    /// The list of a key, or an empty one.
    pub fn list(&self, key: &str) -> &[Toml] {
        self.get(key).map_or(&[], Toml::as_list)
    }

    /// The strings in the list of a key.
    pub fn texts(&self, key: &str) -> impl Iterator<Item = &str> {
        self.list(key).iter().filter_map(Toml::as_text)
    }

    /// The text of a key, or the texts of its list.
    pub fn one_or_more(&self, key: &str) -> impl Iterator<Item = &str> {
        self.text(key).into_iter().chain(self.texts(key))
    }

    /// Whether a key is `true`.
    pub fn is_set(&self, key: &str) -> bool {
        self.get(key) == Some(&Toml::Flag(true))
    }

    /// The table that this is, or an empty one.
    pub fn as_table(&self) -> &[(String, Toml)] {
        if let Toml::Table(table) = self { table } else { &[] }
    }

    /// The entries of the table of a key. There are none without a table.
    pub fn entries(&self, key: &str) -> &[(String, Toml)] {
        self.get(key).map_or(&[], Toml::as_table)
    }

    /// The names of the entries of the table of a key.
    pub fn names(&self, key: &str) -> impl Iterator<Item = &str> {
        self.entries(key).iter().map(|(name, _)| name.as_str())
    }
}
