//! The image says who built it.

use calib_twin::runner::Firmware;
use std::path::{Path, PathBuf};

/// Folders of whoever builds, which no program for others may name.
fn folders_of_the_builder() -> Vec<PathBuf> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let named = ["CARGO_HOME", "CARGO_TARGET_DIR", "HOME", "PWD"];
    let named = named.into_iter().filter_map(std::env::var_os);
    let mut folders: Vec<PathBuf> = named.map(PathBuf::from).collect();
    folders.extend(workspace.map(Path::to_owned));
    // A home of `/` is in every path.
    folders.retain(|folder| folder.components().count() > 1);
    folders.extend(["root", "home", "Users"].map(|folder| PathBuf::from(format!("/{folder}/"))));
    folders
}

fn holds(image: &[u8], text: &str) -> bool {
    image
        .windows(text.len())
        .any(|part| part == text.as_bytes())
}

#[test]
fn no_folder_of_the_builder_is_in_the_image_and_places_still_have_names() {
    let image = Firmware::shipping().expect("an image");
    for folder in folders_of_the_builder() {
        let folder = folder.to_str().expect("a plain name");
        assert!(!holds(image.bytes(), folder), "{folder}");
    }
    // A panic tells its file below the repository, or below what was fetched.
    for place in [
        "firmware/src/main.rs",
        "calib-core/src/phase.rs",
        "registry/heapless-",
    ] {
        assert!(holds(image.bytes(), place), "{place}");
    }
}
