//! The HTML reference: one static site over all controllers that works without a server or a network.
//!
//! One page per register, one per kind of everything else, in a folder per controller; style, script and search
//! index stand once in `assets/`. Addresses are made from the manual's names and stay the same when a description
//! grows: `m_can/cccr.html#niso`.

mod access;
mod book;
mod decode;
mod diagram;
mod field;
mod interrupts;
mod messages;
mod overview;
mod register;
mod search;
mod sections;
mod text;
mod timing;
mod xref;

use minijinja::{Environment, UndefinedBehavior, Value, context, syntax::SyntaxConfig, value::merge_maps};
use regdef::model::{Model, RegisterId};

use crate::{OutputFile, language};
use book::{Book, label};
use xref::Xref;

/// Renders the site over some controllers.
#[must_use]
pub fn site(models: &[&Model]) -> Vec<OutputFile> {
    let books: Vec<_> = models.iter().map(|model| Book::new(model)).collect();
    let mut site = Site { templates: templates(), books: &books, files: Vec::new() };
    site.asset("site.css", include_str!("../templates/html/site.css"));
    site.asset("site.js", include_str!("../templates/html/site.js"));
    site.asset("decode.js", include_str!("../templates/html/decode.js"));
    site.asset("search.js", &search::index(&books, &language::search_entries()));
    let cards: Vec<Value> = books.iter().map(overview::card).collect();
    site.page("index.html", "index.html", "Register reference", context! { cards });
    let language = language::view();
    site.page("language.html", "language.html", "The description language", context! { language });
    for book in &books {
        site.controller(book);
    }
    site.files
}

struct Site<'a> {
    templates: Environment<'static>,
    books: &'a [Book<'a>],
    files: Vec<OutputFile>,
}

impl Site<'_> {
    fn asset(&mut self, name: &str, content: &str) {
        self.files.push(OutputFile { path: format!("assets/{name}"), content: content.to_owned() });
    }

    fn page(&mut self, path: &str, template: &str, title: &str, more: Value) {
        let controllers: Vec<_> =
            self.books.iter().map(|b| context! { id => b.folder(), title => b.model.title.clone() }).collect();
        let root = if path.contains('/') { "../" } else { "" };
        let here = path.rsplit('/').next();
        let defaults = context! { nav => (), controller => () };
        // What stands last wins.
        let page = merge_maps([defaults, more, context! { root, here, page_title => title, controllers }]);
        let template = self.templates.get_template(template).expect("the template is one of those added below");
        let content =
            template.render(page).expect("a template uses only what its page gives it; the tests render every page");
        self.files.push(OutputFile { path: path.to_owned(), content });
    }

    fn controller(&mut self, book: &Book<'_>) {
        let xref = Xref::new(book);
        let nav = overview::navigation(book);
        let controller = book.folder();
        let folder = book.folder().to_owned();
        let mut page = |file: &str, template: &str, title: &str, more: Value| {
            let crumbs = overview::crumbs(book, title);
            let full = format!("{title} – {}", book.model.title);
            let more = context! { nav => nav.clone(), controller, crumbs, heading => title, ..more };
            self.page(&format!("{folder}/{file}"), template, &full, more);
        };
        page("index.html", "overview.html", "Overview", context! { view => overview::view(book, &xref) });
        for index in 0..book.model.registers.len() {
            let id = RegisterId(index);
            let name = label(book.model, book.model.register(id));
            let neighbours = overview::neighbours(book, id);
            let more = context! { r => register::view(book, &xref, id), neighbours };
            page(&book.register(id), "register.html", &name, more);
        }
        for (file, title, _) in overview::pages(book.model) {
            let items = match file {
                "interrupts.html" => interrupts::view(book),
                "messages.html" => messages::messages(book, &xref),
                "memory.html" => messages::memory(book),
                "enums.html" => sections::enums(book, &xref),
                "conditions.html" => sections::conditions(book, &xref),
                "effects.html" => sections::effects(book),
                "joined.html" => sections::joined(book, &xref),
                "chips.html" => sections::chips(book),
                "conflicts.html" => sections::conflicts(book),
                "choices.html" => sections::choices(book),
                _ => book.model.bit_timing.as_ref().map_or(Value::from(()), |timing| timing::view(book, timing)),
            };
            page(file, file, title, context! { items });
        }
    }
}

macro_rules! add_templates {
    ($env:ident, $($name:literal),* $(,)?) => {
        $($env.add_template($name, include_str!(concat!("../templates/html/", $name))).expect(concat!($name, " is well-formed"));)*
    };
}

fn templates() -> Environment<'static> {
    let mut env = Environment::new();
    env.set_undefined_behavior(UndefinedBehavior::Strict);
    env.set_syntax(
        SyntaxConfig::builder()
            .trim_blocks(true)
            .lstrip_blocks(true)
            .build()
            .expect("the delimiters are the usual ones"),
    );
    // Every template is a page, so everything it puts out is escaped.
    env.set_auto_escape_callback(|_| minijinja::AutoEscape::Html);
    env.add_filter("code", |text: &str| text::safe(text::code(text)));
    add_templates!(
        env,
        "page.html",
        "macros.html",
        "index.html",
        "overview.html",
        "register.html",
        "interrupts.html",
        "messages.html",
        "memory.html",
        "timing.html",
        "enums.html",
        "conditions.html",
        "effects.html",
        "joined.html",
        "chips.html",
        "conflicts.html",
        "choices.html",
        "language.html",
    );
    env
}
