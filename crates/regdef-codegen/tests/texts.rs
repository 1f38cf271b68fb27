//! What the C, SVD and table emitters make of small descriptions, one per feature of the language.

mod common;

use common::features;
use regdef_codegen::{c, svd, table};

#[test]
fn c_headers() {
    for (name, model) in features() {
        insta::assert_snapshot!(format!("c__{name}"), c::header(&model));
    }
}

#[test]
fn svd_files() {
    for (name, model) in features() {
        let text = svd::svd(&model).unwrap_or_else(|error| panic!("{name}: {error}"));
        insta::assert_snapshot!(format!("svd__{name}"), text);
    }
}

#[test]
fn tables() {
    for (name, model) in features() {
        insta::assert_snapshot!(format!("csv__{name}"), table::csv(&model));
    }
}

#[test]
fn both_tables_have_the_same_rows() {
    for (name, model) in features() {
        let lines = table::csv(&model).lines().count() - 1;
        let json: serde_json::Value = serde_json::from_str(&table::json(&model)).expect("valid JSON");
        let rows = json["fields"].as_array().expect("a list of fields");
        assert_eq!(rows.len(), lines, "{name}");
        for row in rows {
            assert_eq!(row.as_object().map(serde_json::Map::len), Some(table::COLUMNS.len()), "{name}: {row}");
            assert!(table::COLUMNS.iter().all(|column| row.get(column).is_some()), "{name}: {row}");
        }
    }
}

#[test]
fn the_same_model_gives_the_same_bytes() {
    for ((name, one), (_, other)) in features().into_iter().zip(features()) {
        assert_eq!(c::header(&one), c::header(&other), "{name}");
        assert_eq!(svd::svd(&one).ok(), svd::svd(&other).ok(), "{name}");
        assert_eq!(table::json(&one), table::json(&other), "{name}");
    }
}
