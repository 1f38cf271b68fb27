//! Characters that do not belong into a description, or that YAML's versions take for different things.

use crate::diagnostic::{Code, Diagnostic, Findings, Spot};

/// Reports what is wrong with the characters; `true` if the text can be read as YAML.
pub(super) fn check(text: &str, findings: &mut Findings) -> bool {
    if let Some(at) = text.find('\r') {
        let (what, how) = match text[at..].starts_with("\r\n") {
            true => ("CRLF", "`dos2unix`"),
            false => ("CR", "`mac2unix`"),
        };
        findings.push(
            Diagnostic::new(Code::CrLf, Spot::Bytes(at..at), format!("the lines end with {what}"))
                .label("the first one")
                .help(format!("convert the file to LF line ends, as {how} does")),
        );
    }
    let mut fine = true;
    for (at, letter) in text.char_indices() {
        let spot = || Spot::Bytes(at..at + letter.len_utf8());
        let code = u32::from(letter);
        match letter {
            // These end a line in YAML 1.1 and are plain characters in YAML 1.2: the file would have two meanings.
            '\u{85}' | '\u{2028}' | '\u{2029}' => findings.push(
                Diagnostic::new(
                    Code::BadCharacter,
                    spot(),
                    format!("U+{code:04X} ends a line for some readers of YAML only"),
                )
                .label("here")
                .help("replace it by a line end or a space"),
            ),
            '\u{feff}' if at > 0 => findings.push(
                Diagnostic::new(Code::BadCharacter, spot(), "a byte order mark stands inside the text")
                    .label("here, invisibly")
                    .help("remove it; it is left over from joining files"),
            ),
            _ if letter.is_control() && !matches!(letter, '\n' | '\r' | '\t') => findings.push(
                Diagnostic::new(Code::BadCharacter, spot(), format!("the control character U+{code:04X} is not text"))
                    .label("here, invisibly")
                    .help("remove it"),
            ),
            '\u{fffe}' | '\u{ffff}' => findings.push(
                Diagnostic::new(Code::BadCharacter, spot(), format!("U+{code:04X} is not a character"))
                    .help("remove it"),
            ),
            _ => continue,
        }
        fine = false;
    }
    fine
}
