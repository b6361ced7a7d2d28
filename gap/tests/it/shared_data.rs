//! Measured data that are not part of the repository.

use std::path::PathBuf;

/// Folder of a dataset below `../shared/data`; `None`, with a word on standard error, where there is none.
///
/// # Panics
/// If the data are missing and the environment says `CI=true`.
pub(crate) fn dataset(name: &str) -> Option<PathBuf> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folder = root.join("../../shared/data").join(name);
    if folder.join("rig.toml").is_file() {
        return Some(folder);
    }
    assert!(
        std::env::var("CI").as_deref() != Ok("true"),
        "{} is missing",
        folder.display()
    );
    eprintln!("{} is missing: nothing is tested on it", folder.display());
    None
}
