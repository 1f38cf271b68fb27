//! The reference of the description language, made from the types that define it.
//!
//! The keys, their types and what they mean come from the JSON schema of [`regdef::syntax::Description`], the
//! access codes and the diagnostics from their tables in `regdef`; only the introduction and the worked example
//! are written here.

mod schema;

use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value, context, syntax::SyntaxConfig};
use regdef::diagnostic::{Code, Severity};
use regdef::model::{AccessCode, Neutral};

use schema::TypeDoc;

/// The worked example: a complete description of a small controller.
pub const EXAMPLE: &str = include_str!("../templates/language/example.yaml");

/// The reference as Markdown.
#[must_use]
pub fn page() -> String {
    let mut env = Environment::new();
    env.set_undefined_behavior(UndefinedBehavior::Strict);
    env.set_auto_escape_callback(|_| AutoEscape::None);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build();
    env.set_syntax(syntax.expect("the delimiters are the usual ones"));
    env.add_filter("cell", |text: &str| text.replace('|', "\\|").replace('\n', " "));
    env.add_template("language.md", include_str!("../templates/language/language.md"))
        .expect("language.md is well-formed");
    let template = env.get_template("language.md").expect("added above");
    template
        .render(context! { language => view() })
        .expect("the template uses only what `view` gives; a test renders it")
}

/// What both forms of the reference show: plain text, nothing escaped.
pub(crate) fn view() -> Value {
    let neutral = |code: AccessCode| match code.neutral() {
        Neutral::AsRead => "what was read",
        Neutral::Zero => "0",
        Neutral::Ones => "1",
        Neutral::None => "none",
    };
    let yes = |is: bool| if is { "yes" } else { "no" };
    context! {
        example => EXAMPLE,
        types => schema::types().iter().map(TypeDoc::view).collect::<Vec<_>>(),
        access => AccessCode::ALL.into_iter().map(|code| context! {
            code => code.as_str(), meaning => code.meaning(), readable => yes(code.readable()),
            writable => yes(code.writable()),
            neutral => neutral(code),
        }).collect::<Vec<_>>(),
        diagnostics => Code::ALL.iter().map(|code| context! {
            code => code.as_str(), error => code.severity() == Severity::Error, meaning => code.explanation(),
        }).collect::<Vec<_>>(),
    }
}

/// Entries for the search of the site: name, address, text.
pub(crate) fn search_entries() -> Vec<(String, String, String)> {
    let mut all = vec![("Description language".to_owned(), "language.html".to_owned(), String::new())];
    for one in schema::types() {
        let url = format!("language.html#{}", one.anchor());
        for key in &one.keys {
            all.push((format!("{}.{}", one.name, key.name), format!("{url}.{}", key.name), key.doc.clone()));
        }
        all.push((one.name, url, one.doc));
    }
    for code in AccessCode::ALL {
        all.push((
            code.as_str().to_owned(),
            format!("language.html#access-{}", code.as_str()),
            code.meaning().to_owned(),
        ));
    }
    for code in Code::ALL {
        let url = format!("language.html#{}", code.as_str().to_ascii_lowercase());
        all.push((code.as_str().to_owned(), url, code.explanation().to_owned()));
    }
    all
}
