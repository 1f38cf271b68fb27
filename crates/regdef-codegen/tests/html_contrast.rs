//! The colours of the style sheet are far enough apart to read (WCAG 2, level AA), in both themes.

use std::collections::HashMap;

const STYLE: &str = include_str!("../templates/html/site.css");

/// The colours of the block that starts with a selector.
fn colours(start: &str) -> HashMap<String, [f64; 3]> {
    let block = STYLE.split_once(start).unwrap_or_else(|| panic!("{start} is missing")).1;
    let block = block.split_once('}').expect("the block ends").0;
    let mut all = HashMap::new();
    for part in block.split(';') {
        let Some((name, value)) = part.trim().split_once(": #") else { continue };
        let channel =
            |at: usize| f64::from(u8::from_str_radix(&value[at..at + 2], 16).expect("six hexadecimal digits")) / 255.0;
        all.insert(name.trim_start_matches("--").to_owned(), [channel(0), channel(2), channel(4)]);
    }
    all
}

fn luminance(colour: [f64; 3]) -> f64 {
    let linear = colour.map(|c| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) });
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn text_can_be_read_on_every_ground_it_stands_on() {
    let kinds = ["rw", "ro", "wo", "w1c", "w0c", "w1s", "rwhc", "rwh", "wclr"];
    let mut pairs: Vec<(&str, &str)> = kinds.iter().map(|&ground| ("text", ground)).collect();
    for text in ["text", "dim", "link", "bad", "ok", "warn"] {
        pairs.extend([(text, "bg"), (text, "panel")]);
    }
    pairs.extend([("bad", "bad-bg"), ("warn", "warn-bg"), ("ext", "ext-bg"), ("text", "warn-bg"), ("link", "warn-bg")]);
    pairs.extend([
        ("text", "bad-bg"),
        ("link", "bad-bg"),
        ("text", "hit"),
        ("dim", "hit"),
        ("bg", "accent"),
        ("dim", "rw"),
    ]);
    for theme in [":root {", ":root[data-theme=\"dark\"] {"] {
        let colours = colours(theme);
        for (text, ground) in &pairs {
            let ratio = contrast(colours[*text], colours[*ground]);
            assert!(ratio >= 4.5, "{theme} {text} on {ground}: {ratio:.2}");
        }
        // Lines that carry meaning, such as the frames of fields, need 3:1.
        let ratio = contrast(colours["line-strong"], colours["bg"]);
        assert!(ratio >= 3.0, "{theme} line-strong: {ratio:.2}");
    }
}

#[test]
fn both_ways_to_the_dark_theme_give_the_same_colours() {
    assert_eq!(colours(":root[data-theme=\"dark\"] {"), colours(":root:not([data-theme=\"light\"]) {"));
}
