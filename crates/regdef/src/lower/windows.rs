//! Windows and reserved ranges.

use super::Lowering;
use crate::diagnostic::{Code, Diagnostic, Spot};
use crate::model::{FieldRef, Ident, ReservedRange, Window, WindowId};
use crate::path::Path;

/// Most windows: a field of 6 bits selects no more.
const MAX_WINDOWS: usize = 64;

/// Most reserved ranges.
const MAX_RANGES: usize = 4096;

impl Lowering<'_> {
    pub(super) fn window_names(&mut self) {
        let text = self.text;
        for (index, name) in text.windows.keys().enumerate() {
            self.window_names.insert(name.clone(), WindowId(index));
        }
    }

    pub(super) fn window_ref(&mut self, name: &str, at: &Path) -> Option<WindowId> {
        if let Some(id) = self.window_names.get(name) {
            return Some(*id);
        }
        let hint = self.hint(name, self.text.windows.keys().map(String::as_str), "unknown window");
        self.find(
            Diagnostic::new(Code::UnknownReference, Spot::Value(at.clone()), format!("there is no window `{name}`"))
                .label(hint)
                .help("declare it under `windows` with the field that selects it"),
        );
        None
    }

    pub(super) fn windows(&mut self) {
        let text = self.text;
        if text.windows.len() > MAX_WINDOWS {
            let title = format!("{} windows are more than the {MAX_WINDOWS} that a field selects", text.windows.len());
            self.find(Diagnostic::new(Code::OutOfRange, Spot::Key(Path::root().key("windows")), title));
            self.out.windows_known = false;
            return;
        }
        for (name, window) in &text.windows {
            let at = Path::root().key("windows").key(name);
            self.check_identifier(name, &at);
            let cites = self.cite(window.cite.as_ref(), &at);
            let Some(select) = self.field_ref(&window.select, &at.key("select")) else {
                self.findings.amend(&Spot::Value(at.key("select")), |finding| {
                    finding.code = Code::WindowWithoutSelector;
                    finding.title = format!("the window `{name}` has no field that selects it: {}", finding.title);
                });
                self.out.windows_known = false;
                continue;
            };
            self.selector(name, window.value.0, select, &at);
            self.out.model.windows.push(Window {
                name: name.clone(),
                ident: Ident::new(name),
                select,
                value: window.value.0,
                doc: window.doc.clone(),
                cites,
            });
        }
    }

    /// The field and the value that select a window tell it from the others.
    fn selector(&mut self, name: &str, value: u64, select: FieldRef, at: &Path) {
        let model = &self.out.model;
        let path = model.field_path(select);
        let capacity = model.field(select).capacity();
        let register = model.register(select.register);
        let hidden = register.window.is_some().then(|| self.out.registers[select.register.0].path.key("window"));
        let repeated = register.dim.is_some() || register.cluster.is_some() || model.field(select).lanes.is_some();
        let same = model.windows.iter().find(|w| w.select == select && w.value == value).map(|w| w.name.clone());
        let other = model.windows.iter().find(|w| w.select != select).map(|w| (w.name.clone(), w.select));
        let other = other.map(|(name, select)| (name, model.field_path(select)));
        if value > capacity {
            self.find(
                Diagnostic::new(
                    Code::OutOfRange,
                    Spot::Value(at.key("value")),
                    format!("`{path}` cannot hold {value}"),
                )
                .label(format!("has to be at most {capacity}")),
            );
        }
        let no_selector =
            |at: Path, title: String| Diagnostic::new(Code::WindowWithoutSelector, Spot::Value(at), title);
        if let Some(hidden) = hidden {
            self.find(
                no_selector(at.key("select"), format!("`{path}` cannot select a window, because it is in one itself"))
                    .also(Spot::Value(hidden), "its register is visible in this window only")
                    .help("the selecting field has to be visible in all windows; leave `window` out at its register"),
            );
        }
        if repeated {
            self.find(
                no_selector(at.key("select"), format!("`{path}` cannot select a window, because it is repeated"))
                    .help("name a field that exists once"),
            );
        }
        if let Some(same) = same {
            self.find(
                no_selector(
                    at.key("value"),
                    format!("the windows `{same}` and `{name}` are selected by the same value"),
                )
                .also(Spot::Value(Path::root().key("windows").key(&same).key("value")), format!("`{same}`"))
                .help("nothing tells the two apart; correct one value, or make one window of them"),
            );
        }
        if let Some((other, field)) = other {
            self.find(
                no_selector(
                    at.key("select"),
                    format!("the windows `{other}` and `{name}` are selected by different fields"),
                )
                .also(Spot::Value(Path::root().key("windows").key(&other).key("select")), format!("`{field}`"))
                .help("with two fields, both windows could be open at once; all windows share one field"),
            );
        }
    }

    pub(super) fn reserved(&mut self) {
        let text = self.text;
        if text.reserved.len() > MAX_RANGES {
            let title = format!("{} reserved ranges; {MAX_RANGES} is the most", text.reserved.len());
            self.find(Diagnostic::new(Code::OutOfRange, Spot::Key(Path::root().key("reserved")), title));
        }
        for (index, range) in text.reserved.iter().enumerate().take(MAX_RANGES) {
            let at = Path::root().key("reserved").index(index);
            let cites = self.cite(range.cite.as_ref(), &at);
            if range.from > range.to {
                self.find(
                    Diagnostic::new(Code::BadRange, Spot::Value(at.key("to")), "the range ends before it starts")
                        .also(Spot::Value(at.key("from")), "its start")
                        .help("`to` is the last byte of the range, included"),
                );
                continue;
            }
            let window = range.window.as_ref().and_then(|name| self.window_ref(name, &at.key("window")));
            let sets = range.sets.as_ref().and_then(|field| self.field_ref(field, &at.key("sets")));
            let (from, to) = (self.address(range.from, &at.key("from")), self.address(range.to, &at.key("to")));
            self.out.reserved.push((from, at));
            self.out.model.reserved.push(ReservedRange {
                from,
                to,
                window,
                reads: range.reads.map(|v| v.0),
                sets,
                doc: range.doc.clone().unwrap_or_default(),
                cites,
            });
        }
        self.out.model.reserved.sort_by_key(|r| r.from);
        self.out.reserved.sort_by_key(|r| r.0);
    }
}
