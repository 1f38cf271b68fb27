//! Selection of windows.

use regdef::model::WindowId;

use super::write::Writer;
use super::{Context, access, literal};
use crate::text;

pub(super) fn emit(context: &Context<'_>, out: &mut Writer) {
    for index in 0..context.model.windows.len() {
        one(context, out, WindowId(index));
    }
}

fn one(context: &Context<'_>, out: &mut Writer, id: WindowId) {
    let window = &context.model.windows[id.0];
    let selector = context.model.register(window.select.register);
    let field = context.names.field(window.select);
    let path = context.model.field_path(window.select);
    let value = literal::decimal(window.value, selector.width);
    let mut paragraphs = vec![
        format!("Window {}: {}", window.name, text::sentence(&window.doc)),
        format!(
            "Selects it in {path} with one read and one store. Its registers are the member {} of the window; \
             an interrupt that uses another window in between has to restore this one.",
            window.ident.upper
        ),
    ];
    paragraphs.push(text::cites(&window.cites));
    let (true, Some(target)) = (selector.capabilities.modify.is_ok(), access::target(context, window.select.register))
    else {
        paragraphs[1] = format!("Selected by {value} in {path}, which has to be written as a whole.");
        out.comment(&paragraphs);
        return;
    };
    out.comment(&paragraphs);
    let stem = context.names.register(window.select.register).to_ascii_lowercase();
    let body = format!("{stem}_modify({}, {field}_Msk, {field}_SET({value}));", target.arguments);
    let name = format!("{}_select_{}_window", context.lower, window.ident.upper.to_ascii_lowercase());
    out.function(&format!("void {name}({})", target.parameters), &[body]);
    out.blank();
}
