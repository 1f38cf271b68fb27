//! Generated files: compared, then written whole or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use anstyle::{AnsiColor, Style};
use similar::TextDiff;

use crate::project;

/// What became of a file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Status {
    Unchanged,
    Written,
    Stale,
    Different,
    Missing,
}

impl Status {
    fn shown(self) -> (&'static str, Style) {
        match self {
            Self::Unchanged => ("unchanged", Style::new().dimmed()),
            Self::Written => ("written", AnsiColor::Green.on_default()),
            Self::Stale => ("stale", AnsiColor::Yellow.on_default()),
            Self::Different => ("different", AnsiColor::Red.on_default()),
            Self::Missing => ("missing", AnsiColor::Red.on_default()),
        }
    }
}

/// The files of one run.
pub struct Artefacts {
    check: bool,
    files: BTreeMap<PathBuf, (Status, String)>,
}

impl Artefacts {
    /// With `check`, nothing is written.
    pub fn new(check: bool) -> Self {
        Self { check, files: BTreeMap::new() }
    }

    /// Compares a file with what it should be, and writes it unless it is unchanged.
    pub fn file(&mut self, path: &Path, content: &str) -> Result<(), String> {
        let present = match fs::read_to_string(path) {
            Ok(text) => Some(text),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
            Err(error) => return Err(format!("{}: {error}", project::shown(path))),
        };
        let mut difference = String::new();
        let status = match present {
            Some(text) if text == content => Status::Unchanged,
            Some(text) if self.check => {
                difference = diff(path, &text, content);
                Status::Different
            }
            None if self.check => Status::Missing,
            _ => {
                write(path, content)?;
                Status::Written
            }
        };
        self.files.insert(path.to_owned(), (status, difference));
        Ok(())
    }

    /// Finds files in a folder of generated files that are generated no more, and removes them.
    pub fn sweep(&mut self, folder: &Path) -> Result<(), String> {
        let Ok(entries) = fs::read_dir(folder) else { return Ok(()) };
        for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
            if path.is_dir() {
                self.sweep(&path)?;
            } else if !self.files.contains_key(&path) {
                if !self.check {
                    fs::remove_file(&path).map_err(|error| format!("{}: {error}", project::shown(&path)))?;
                }
                self.files.insert(path, (Status::Stale, String::new()));
            }
        }
        Ok(())
    }

    fn count(&self, wanted: Status) -> usize {
        self.files.values().filter(|(status, _)| *status == wanted).count()
    }

    /// How many files became what, in one line.
    pub fn counts(&self) -> String {
        let parts: Vec<_> = [Status::Written, Status::Unchanged, Status::Stale, Status::Different, Status::Missing]
            .into_iter()
            .filter(|status| self.count(*status) > 0)
            .map(|status| format!("{} {}", self.count(status), status.shown().0))
            .collect();
        format!("{} files: {}", self.files.len(), parts.join(", "))
    }

    /// Prints the table; `false` if a check found something.
    pub fn summary(&self) -> bool {
        for (_, difference) in self.files.values() {
            anstream::print!("{difference}");
        }
        let width = self.files.keys().map(|path| project::shown(path).len()).max().unwrap_or(0);
        for (path, (status, _)) in &self.files {
            let (text, style) = status.shown();
            let note = match (status, self.check) {
                (Status::Stale, false) => " (removed)",
                (Status::Stale, true) => " (generated no more)",
                _ => "",
            };
            anstream::println!("{:width$}  {style}{text}{style:#}{note}", project::shown(path));
        }
        anstream::println!("{}", self.counts());
        let good = !self.check || self.count(Status::Unchanged) == self.files.len();
        if !good {
            anstream::println!("run `cargo xtask codegen` and commit what it writes");
        }
        good
    }
}

/// Writes to a temporary file in the same folder and renames it, so that no one ever sees half a file.
fn write(path: &Path, content: &str) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", project::shown(path));
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder).map_err(failed)?;
    let mut file = tempfile::NamedTempFile::new_in(folder).map_err(failed)?;
    file.write_all(content.as_bytes()).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    #[cfg(unix)]
    {
        // A temporary file is private; a generated file is not.
        use std::os::unix::fs::PermissionsExt;
        file.as_file().set_permissions(fs::Permissions::from_mode(0o644)).map_err(failed)?;
    }
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
}

/// A unified diff from what is there to what should be, cut where it gets long.
fn diff(path: &Path, present: &str, wanted: &str) -> String {
    const MOST_LINES: usize = 60;
    let name = project::shown(path);
    let text = TextDiff::from_lines(present, wanted)
        .unified_diff()
        .context_radius(2)
        .header(&format!("{name} (as it is)"), &format!("{name} (as generated)"))
        .to_string();
    let (added, removed) = (AnsiColor::Green.on_default(), AnsiColor::Red.on_default());
    let total = text.lines().count();
    let mut out = String::new();
    for line in text.lines().take(MOST_LINES) {
        let style = match line.chars().next() {
            Some('+') => added,
            Some('-') => removed,
            _ => Style::new(),
        };
        out += &format!("{style}{line}{style:#}\n");
    }
    if total > MOST_LINES {
        out += &format!("... and {} more lines\n", total - MOST_LINES);
    }
    out + "\n"
}
