//! The Python package: one wheel for every Python from 3.9 on, with the module, its sources and its types inside.
//!
//! The module is built by the same cargo call as everything else, so that no dependency is compiled for it alone;
//! `pip install ./python` builds it with maturin instead, where there is a Rust compiler.

use crate::python;
use crate::shell::{VERSION, cargo, empty, root, run, target_dir};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Interface that every Python from 3.9 on has.
const INTERFACE: &str = "cp39-abi3";

/// Builds the module; with an image, that is inside.
fn module(image: Option<&Path>) -> Result<PathBuf> {
    eprintln!("building the Python module ...");
    let mut build = cargo("build");
    build.args(["--release", "--workspace", "--lib"]);
    if let Some(image) = image {
        build.env("CALIB_EMBED_IMAGE", image);
    }
    run(&mut build)?;
    Ok(target_dir().join("release").join("lib_calib.so"))
}

/// Builds the wheel into a folder.
pub(crate) fn build(image: Option<&Path>, interpreter: &Path, into: &Path) -> Result<PathBuf> {
    let module = module(image)?;
    let stage = target_dir().join("wheel");
    lay_out(&module, &stage)?;
    let before = wheels(into)?;
    for old in before {
        fs::remove_file(old)?;
    }
    fs::create_dir_all(into)?;
    let mut pack = Command::new(interpreter);
    pack.args(["-m", "wheel", "pack", "--dest-dir"]).arg(into);
    run(pack.arg(&stage))?;
    let wheel = wheels(into)?.pop();
    wheel.context("`wheel pack` made no wheel")
}

fn wheels(folder: &Path) -> Result<Vec<PathBuf>> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let entries = fs::read_dir(folder)?.flatten().map(|entry| entry.path());
    Ok(entries
        .filter(|path| path.extension().is_some_and(|is| is == "whl"))
        .collect())
}

/// The files as they will lie in `site-packages`.
fn lay_out(module: &Path, stage: &Path) -> Result<()> {
    empty(stage)?;
    let package = stage.join("calib");
    copy_sources(&root().join("python/calib"), &package)?;
    let file = package.join("_calib.abi3.so");
    run(Command::new("strip")
        .args(["--strip-unneeded", "-o"])
        .args([&file, module]))?;
    let about = stage.join(format!("calib-{VERSION}.dist-info"));
    let licences = about.join("licenses");
    fs::create_dir_all(&licences)?;
    for text in ["LICENSE-MIT", "LICENSE-APACHE"] {
        fs::copy(root().join(text), licences.join(text))?;
    }
    fs::write(about.join("METADATA"), metadata()?)?;
    let tag = format!("{INTERFACE}-linux_{}", std::env::consts::ARCH);
    let wheel = format!(
        "Wheel-Version: 1.0\nGenerator: calib {VERSION}\nRoot-Is-Purelib: false\nTag: {tag}\n"
    );
    Ok(fs::write(about.join("WHEEL"), wheel)?)
}

fn copy_sources(from: &Path, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)?.flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let extension = path.extension().and_then(|is| is.to_str());
        match extension {
            _ if path.is_dir() && name != "__pycache__" => copy_sources(&path, &to.join(&name))?,
            Some("py" | "pyi" | "typed") => fs::copy(&path, to.join(&name)).map(drop)?,
            _ => {}
        }
    }
    Ok(())
}

/// Content of `pyproject.toml`, in the form of core metadata 2.4.
fn metadata() -> Result<String> {
    let folder = root().join("python");
    let project: toml::Table = toml::from_str(&fs::read_to_string(folder.join("pyproject.toml"))?)?;
    let project = project
        .get("project")
        .context("pyproject.toml has no project")?;
    let said = |key: &str| -> Result<String> {
        let value = project.get(key).and_then(toml::Value::as_str);
        Ok(value
            .with_context(|| format!("pyproject.toml states no {key}"))?
            .to_owned())
    };
    let mut text = format!(
        "Metadata-Version: 2.4\nName: {}\nVersion: {VERSION}\nSummary: {}\nLicense-Expression: {}\nRequires-Python: {}\n",
        said("name")?,
        said("description")?,
        said("license")?,
        said("requires-python")?,
    );
    let list = |value: Option<&toml::Value>| -> Vec<String> {
        let items = value.and_then(toml::Value::as_array).into_iter().flatten();
        items
            .filter_map(|item| Some(item.as_str()?.to_owned()))
            .collect()
    };
    for classifier in list(project.get("classifiers")) {
        text += &format!("Classifier: {classifier}\n");
    }
    let extras = project.get("optional-dependencies");
    for (extra, packages) in extras.and_then(toml::Value::as_table).into_iter().flatten() {
        text += &format!("Provides-Extra: {extra}\n");
        for package in list(Some(packages)) {
            text += &format!("Requires-Dist: {package}; extra == \"{extra}\"\n");
        }
    }
    let readme = fs::read_to_string(folder.join(said("readme")?))?;
    text += &format!("Description-Content-Type: text/markdown\n\n{readme}");
    Ok(text)
}

/// The tests of the package with pytest, in the environment of the tests: of the wheel, as a user installs it.
pub(crate) fn tests(interpreter: &Path, image: &Path) -> Result<Command> {
    installed(interpreter)?;
    python::with_spark(interpreter)?;
    let mut tests = Command::new(interpreter);
    tests.args(["-m", "pytest", "--quiet", "-p", "no:cacheprovider"]);
    // A process for each core: most of a test is one calibrator or one diagnosis.
    tests.args(["--numprocesses", "auto"]);
    tests.arg(root().join("python/tests"));
    tests.env("CALIB_FIRMWARE_ELF", image);
    tests.env("CALIB_TOOL", crate::demo::tool());
    tests.current_dir(target_dir());
    Ok(tests)
}

/// Builds the wheel and installs it into the environment of the tests.
pub(crate) fn installed(interpreter: &Path) -> Result<()> {
    let wheel = build(None, interpreter, &target_dir().join("wheels"))?;
    install(interpreter, &wheel)
}

fn install(interpreter: &Path, wheel: &Path) -> Result<()> {
    let mut pip = Command::new(interpreter);
    pip.args([
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]);
    pip.args(["--no-index", "--no-deps", "--force-reinstall"]);
    run(pip.arg(wheel))
}

/// Installs the wheel into an environment that has nothing else, and calibrates and diagnoses there.
pub(crate) fn used_in_an_empty_environment(wheel: &Path) -> Result<()> {
    let folder = target_dir().join("wheel-alone");
    empty(&folder)?;
    let begun = std::time::Instant::now();
    run(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
    let interpreter = folder.join("bin/python3");
    install(&interpreter, wheel)?;
    let mut first = Command::new(&interpreter);
    // Nothing of this computer helps.
    first.env_clear().env("HOME", &folder).current_dir(&folder);
    run(first.arg(root().join("python/examples/first.py")))?;
    println!(
        "wheel: installed, calibrated and diagnosed in an empty environment in {:.0} s",
        begun.elapsed().as_secs_f64()
    );
    Ok(())
}

/// The environment whose tools pack a wheel.
pub(crate) fn interpreter() -> Result<PathBuf> {
    python::interpreter()?.context("a Python is missing: the wheel is packed with it")
}
