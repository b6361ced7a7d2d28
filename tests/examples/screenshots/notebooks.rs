//! Notebooks of the Python package, executed and shown as a reader sees them.

use crate::keep;
use calib_tests::browser::Browser;
use calib_tests::rigged::Fault;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A notebook, its picture, how high that is, and from which cell on.
const SHOWN: [(&str, &str, u32, usize); 3] = [
    ("first_calibration", "notebook-calibration.png", 880, 3),
    ("own_model", "notebook-model.png", 860, 5),
    ("fleet_state", "notebook-fleet.png", 820, 2),
];

/// A picture of each into `folder`.
pub(crate) fn pictures(page: &Browser, folder: &Path) -> Result<(), Fault> {
    let work = tempfile::tempdir()?;
    for (name, picture, height, cell) in SHOWN {
        let html = executed(name, work.path())?;
        page.screen(960, height, 1.0, false)?;
        page.open(&format!("file://{}", html.display()))?;
        page.value(&format!(
            "document.querySelectorAll('.jp-Cell')[{cell}].scrollIntoView()"
        ))?;
        keep(page, &folder.join(picture))?;
    }
    Ok(())
}

/// The page of a notebook after every cell of it, by nbconvert; nothing of it asks a network.
fn executed(name: &str, work: &Path) -> Result<PathBuf, Fault> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let file = format!("{name}.ipynb");
    std::fs::copy(root.join("python/examples").join(&file), work.join(&file))?;
    let interpreter = std::env::var_os("CALIB_PYTHON").ok_or("CALIB_PYTHON is not set")?;
    let from_networks = [
        "mathjax_url",
        "require_js_url",
        "jquery_url",
        "mermaid_js_url",
    ];
    let status = Command::new(interpreter)
        .args(["-m", "nbconvert", "--log-level=WARN", "--to", "html"])
        .args(["--execute", &file])
        .args(from_networks.map(|script| format!("--HTMLExporter.{script}=")))
        .env("PYTHONPATH", root.canonicalize()?)
        .current_dir(work)
        .stdout(Stdio::null())
        .status()?;
    match status.success() {
        true => Ok(work.join(name).with_extension("html")),
        false => Err(format!("nbconvert {file}: {status}").into()),
    }
}
