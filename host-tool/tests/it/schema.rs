//! The published JSON Schemas.

use crate::command_line::{calib, schemas, text};
use std::collections::BTreeMap;
use std::path::Path;

fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let entries = entries.map(|entry| entry.expect("an entry").path());
    entries
        .map(|path| {
            let name = path.file_name().expect("a name").to_string_lossy();
            let content = std::fs::read_to_string(&path).expect("text");
            (name.into_owned(), content)
        })
        .collect()
}

#[test]
fn what_is_published_is_generated_from_the_types() {
    let directory = tempfile::tempdir().expect("directory");
    let output = calib(directory.path(), &["schema", "now"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let (now, published) = (files(&directory.path().join("now")), files(&schemas()));
    for (name, schema) in &now {
        let hint = "write it with `calib schema docs/schema`";
        assert_eq!(published.get(name), Some(schema), "{name}: {hint}");
    }
    assert_eq!(now.len(), published.len(), "docs/schema has more files");
}
