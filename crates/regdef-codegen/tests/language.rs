//! The reference of the language: the worked example loads without a finding, and every link leads somewhere.

use regdef_codegen::language;

#[test]
fn the_worked_example_is_a_description_without_findings() {
    let loaded = regdef::load_str("example.yaml", language::EXAMPLE);
    assert!(loaded.findings.is_empty(), "{:#?}", loaded.findings);
    assert!(loaded.model.is_some());
}

#[test]
fn the_page_explains_every_code_and_key() {
    let page = language::page();
    for code in regdef::diagnostic::Code::ALL {
        assert!(page.contains(&format!("| `{}` | ", code.as_str())), "{} is missing", code.as_str());
    }
    for code in regdef::model::AccessCode::ALL {
        assert!(page.contains(&format!("| `{}` | ", code.as_str())), "{} is missing", code.as_str());
    }
    let schema = regdef::schema();
    let definitions =
        schema["$defs"].as_object().into_iter().flatten().filter(|(name, _)| !name.starts_with("OneOrMany"));
    let all = definitions.map(|(_, one)| one).chain([&schema]);
    for (key, _) in all.filter_map(|one| one["properties"].as_object()).flatten() {
        assert!(page.contains(&format!("| `{key}` | ")), "the key {key} is missing");
    }
}

#[test]
fn links_of_the_page_lead_to_its_anchors() {
    let page = language::page();
    let mut links = 0;
    for link in page.split("](#").skip(1) {
        let anchor = link.split(')').next().unwrap_or_default();
        assert!(page.contains(&format!("<a id=\"{anchor}\"></a>")), "#{anchor} leads nowhere");
        links += 1;
    }
    assert!(links > 100, "only {links} links were found");
}

#[test]
fn tables_have_as_many_cells_as_their_heads() {
    let mut cells = None;
    for line in language::page().lines() {
        if !line.starts_with('|') {
            cells = None;
            continue;
        }
        let count = line.replace("\\|", "").matches('|').count();
        assert_eq!(*cells.get_or_insert(count), count, "{line}");
    }
}
