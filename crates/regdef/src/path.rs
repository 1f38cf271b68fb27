//! Places in a description, by the keys that lead there.

use std::fmt;

/// The keys from the top of a file to a node, joined with `/`: `registers/CCCR/fields/NISO/bits`.
///
/// A list item is addressed by its index. A `/` or `~` inside a key is written `~1` or `~0`, as in a JSON pointer.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct Path(String);

impl Path {
    /// The top of the file.
    #[must_use]
    pub const fn root() -> Self {
        Self(String::new())
    }

    /// The node under a key.
    #[must_use]
    pub fn key(&self, key: impl AsRef<str>) -> Self {
        let escaped = key.as_ref().replace('~', "~0").replace('/', "~1");
        Self(format!("{}/{escaped}", self.0))
    }

    /// The item of a list.
    #[must_use]
    pub fn index(&self, index: usize) -> Self {
        self.key(index.to_string())
    }

    /// The node that holds this one; the root for a top-level key.
    #[must_use]
    pub fn parent(&self) -> Self {
        Self(self.0.rsplit_once('/').map_or(String::new(), |(parent, _)| parent.to_owned()))
    }

    /// The last key; empty for the root.
    #[must_use]
    pub fn last(&self) -> String {
        unescape(self.0.rsplit('/').next().unwrap_or_default())
    }

    /// The keys from the top to the node.
    pub fn keys(&self) -> impl Iterator<Item = String> {
        self.0.split('/').skip(1).map(unescape)
    }

    /// A path from a JSON pointer.
    #[must_use]
    pub fn from_pointer(pointer: &str) -> Self {
        Self(pointer.to_owned())
    }
}

fn unescape(key: &str) -> String {
    key.replace("~1", "/").replace("~0", "~")
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.strip_prefix('/').unwrap_or(&self.0))
    }
}

#[cfg(test)]
mod tests {
    use super::Path;

    #[test]
    fn keys_may_hold_the_separator_and_may_be_empty() {
        let path = Path::root().key("a/b").key("~1").key("").index(3);
        assert_eq!(path.to_string(), "a~1b/~01//3");
        assert_eq!(path.keys().collect::<Vec<_>>(), ["a/b", "~1", "", "3"]);
        assert_eq!(path.parent().parent().last(), "~1");
        assert_ne!(Path::root().key(""), Path::root());
        assert_eq!(Path::root().key("").parent(), Path::root());
        assert_eq!(Path::from_pointer("/a~1b/~01//3"), path);
    }
}
