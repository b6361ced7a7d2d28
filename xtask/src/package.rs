//! One file to install: the tool with the image inside, as a Debian package, as a tar, and for Windows.

use crate::packages::{as_root, needs};
use crate::sbom::{self, Product};
use crate::shell::{VERSION, cargo, empty, root, run, said, tar_of, target_dir};
use crate::{demo, elf, origin, update, wheel, windows, wine};
use anyhow::{Context, Result, bail};
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Largest file to download, bytes.
const LARGEST: u64 = 40_000_000;
/// Largest wheel, which zip packs less tightly, bytes; indexes of packages take 100 MB.
const LARGEST_WHEEL: u64 = 60_000_000;

/// Builds `dist/`; with `--check`, also builds the image twice, installs and uses the package in an
/// empty Debian, and uses the program for Windows under wine.
pub(crate) fn build(arguments: &[String]) -> Result<()> {
    let check = match arguments {
        [] => false,
        [flag] if flag == "--check" => true,
        other => bail!("./run package [--check], not {}", other.join(" ")),
    };
    needs("dpkg-deb", "dpkg")?;
    needs("dpkg-shlibdeps", "dpkg-dev")?;
    let image = elf::build()?;
    if check {
        origin::check(&image, elf::build_elsewhere)?;
    }
    let for_windows = windows::build(&image)?;
    let tool = tool_with(&image)?;
    let stage = target_dir().join("package");
    lay_out(&tool, &stage)?;
    let dist = root().join("dist");
    empty(&dist)?;
    let [of_tool, of_image] = materials(&stage, &image, &dist)?;
    let package = debian_package(&stage, &dist)?;
    let tar = tar(&stage, &dist)?;
    let mut files = vec![package, tar, firmware(&dist)?, of_tool, of_image];
    files.push(wheel::build(Some(&image), &wheel::interpreter()?, &dist)?);
    let wheel = files.len() - 1;
    if let Some(folder) = &for_windows {
        files.push(windows::archive(folder, &dist)?);
    }
    list(&dist, &files)?;
    if check {
        used_in_an_empty_root(&files[0])?;
        wheel::used_in_an_empty_environment(&files[wheel])?;
        for_windows.map_or(Ok(()), |folder| wine::check(&folder, &tool))?;
    }
    Ok(())
}

fn tool_with(image: &Path) -> Result<PathBuf> {
    eprintln!("building the host tool with the image inside ...");
    let mut build = cargo("build");
    build.args(["--release", "--workspace", "--bin", "calib"]);
    run(build.env("CALIB_EMBED_IMAGE", image))?;
    Ok(demo::tool())
}

/// The files as they will lie below `/`.
fn lay_out(tool: &Path, stage: &Path) -> Result<()> {
    empty(stage)?;
    let folder = |path: &str| -> Result<PathBuf> {
        let folder = stage.join(path);
        fs::create_dir_all(&folder)?;
        Ok(folder)
    };
    let program = folder("usr/bin")?.join("calib");
    run(Command::new("strip").arg("-o").arg(&program).arg(tool))?;
    let pages = folder("usr/share/man/man1")?;
    run(Command::new(&program)
        .args(["--quiet", "man", "--out"])
        .arg(&pages))?;
    for page in fs::read_dir(&pages)? {
        run(Command::new("gzip").arg("-9n").arg(page?.path()))?;
    }
    for (shell, place, name) in [
        ("bash", "usr/share/bash-completion/completions", "calib"),
        ("zsh", "usr/share/zsh/vendor-completions", "_calib"),
        ("fish", "usr/share/fish/vendor_completions.d", "calib.fish"),
    ] {
        let script = Command::new(&program)
            .args(["completions", shell])
            .output()?;
        fs::write(folder(place)?.join(name), script.stdout)?;
    }
    let packaging = root().join("host-tool/packaging");
    let copy = |from: PathBuf, place: &str| -> Result<()> {
        let name = from.file_name().unwrap_or_default().to_owned();
        fs::copy(&from, folder(place)?.join(name)).with_context(|| from.display().to_string())?;
        Ok(())
    };
    copy(packaging.join("70-calib.rules"), "usr/lib/udev/rules.d")?;
    copy(packaging.join("calib.desktop"), "usr/share/applications")?;
    copy(packaging.join("copyright"), "usr/share/doc/calib")?;
    for text in ["CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"] {
        copy(root().join(text), "usr/share/doc/calib")?;
    }
    Ok(())
}

fn debian_package(stage: &Path, dist: &Path) -> Result<PathBuf> {
    let architecture = said(Command::new("dpkg").arg("--print-architecture"))?;
    let control = format!(
        "Package: calib\nVersion: {VERSION}\nArchitecture: {architecture}\n\
         Maintainer: the calib developers <calib@localhost>\nInstalled-Size: {size}\n\
         Depends: {depends}\nSuggests: xdg-utils\nSection: science\nPriority: optional\n\
         Description: field vibration calibrator after ISO 16063-21\n \
         Measures accelerometers with the calibrator, or with an emulated one whose\n \
         firmware is inside, keeps the logbook, writes certificates, and says why\n \
         reality differs from a simulation.\n",
        size = said(Command::new("du").args(["-sk", "."]).current_dir(stage))?.replace("\t.", ""),
        depends = depends(stage)?,
    );
    let folder = stage.join("DEBIAN");
    fs::create_dir_all(&folder)?;
    fs::write(folder.join("control"), control)?;
    let file = dist.join(format!("calib_{VERSION}_{architecture}.deb"));
    let mut build = Command::new("dpkg-deb");
    run(build
        .args(["--root-owner-group", "--build"])
        .args([stage, &file]))?;
    fs::remove_dir_all(folder)?;
    Ok(file)
}

/// The shared libraries the program asks for, as packages with their versions.
fn depends(stage: &Path) -> Result<String> {
    let around = target_dir().join("package-depends");
    empty(&around)?;
    fs::create_dir_all(around.join("debian"))?;
    fs::write(
        around.join("debian/control"),
        "Source: calib\n\nPackage: calib\nArchitecture: any\n",
    )?;
    let mut ask = Command::new("dpkg-shlibdeps");
    let answer = said(
        ask.arg("-O")
            .arg(stage.join("usr/bin/calib"))
            .current_dir(&around),
    )?;
    let depends = answer.strip_prefix("shlibs:Depends=");
    Ok(depends
        .context("dpkg-shlibdeps names no packages")?
        .to_owned())
}

/// Packs the files for other Linux systems.
fn tar(stage: &Path, dist: &Path) -> Result<PathBuf> {
    let name = format!("calib-{VERSION}-{}-linux", std::env::consts::ARCH);
    let file = dist.join(format!("{name}.tar.xz"));
    run(tar_of(&file)
        .arg("--transform")
        .arg(format!("s,^usr,{name},"))
        .arg("-C")
        .arg(stage)
        .arg("usr"))?;
    Ok(file)
}

/// Lists of the parts of the program and the image.
fn materials(stage: &Path, image: &Path, dist: &Path) -> Result<[PathBuf; 2]> {
    let compiler = said(Command::new("rustc").arg("-vV"))?;
    let host = compiler
        .lines()
        .find_map(|line| line.strip_prefix("host: "));
    let tool = Product {
        name: "calib",
        kind: "application",
        package: "calib-host",
        target: host.context("rustc names no host")?,
        alone: false,
        file: &stage.join("usr/bin/calib"),
    };
    let firmware = Product {
        name: elf::PACKAGE,
        kind: "firmware",
        package: elf::PACKAGE,
        target: elf::TARGET,
        alone: true,
        file: image,
    };
    Ok([sbom::write(&tool, dist)?, sbom::write(&firmware, dist)?])
}

/// The update of the firmware.
fn firmware(dist: &Path) -> Result<PathBuf> {
    let built = update::build(None)?;
    let file = dist.join(built.file_name().unwrap_or_default());
    fs::copy(&built, &file).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(file)
}

/// `SHA256SUMS`, and the sizes.
fn list(dist: &Path, files: &[PathBuf]) -> Result<()> {
    let names: Vec<&OsStr> = files.iter().filter_map(|file| file.file_name()).collect();
    let sums = said(Command::new("sha256sum").args(&names).current_dir(dist))?;
    fs::write(dist.join("SHA256SUMS"), format!("{sums}\n"))?;
    for file in files {
        let bytes = fs::metadata(file)?.len();
        println!("{} {:.1} MB", file.display(), bytes as f64 / 1e6);
        let most = match file.extension().is_some_and(|is| is == "whl") {
            true => LARGEST_WHEEL,
            false => LARGEST,
        };
        if bytes > most {
            bail!("{} has more than {} MB", file.display(), most / 1_000_000);
        }
    }
    Ok(())
}

/// Installs the package in a Debian that has nothing else, and calibrates there.
fn used_in_an_empty_root(package: &Path) -> Result<()> {
    needs("debootstrap", "debootstrap")?;
    let release = fs::read_to_string("/etc/os-release")?;
    let codename = release
        .lines()
        .find_map(|line| line.strip_prefix("VERSION_CODENAME="));
    let empty_root = target_dir().join("package-root");
    let mut bootstrap = as_root("debootstrap");
    bootstrap.args(["--variant=minbase", codename.unwrap_or("stable")]);
    if !empty_root.join("usr/bin/apt-get").exists() {
        eprintln!("making an empty Debian ...");
        run(bootstrap.arg(&empty_root))?;
    }
    run(as_root("cp").arg(package).arg(empty_root.join("calib.deb")))?;
    for command in [
        "apt-get install --yes --quiet --allow-downgrades --reinstall /calib.deb",
        "calib --version",
        "calib demo --out /tmp/demo",
        "test -s /usr/lib/udev/rules.d/70-calib.rules",
        "test -s /usr/share/man/man1/calib-run.1.gz",
        "sh -c 'ls -l /tmp/demo/*.pdf'",
        "calib --device emulated info",
        "apt-get remove --yes --quiet calib",
        "sh -c '! command -v calib'",
    ] {
        eprintln!("empty root: {command}");
        let mut inside = as_root("chroot");
        // Nothing of this computer helps.
        inside.env_clear();
        inside
            .env("PATH", "/usr/sbin:/usr/bin:/sbin:/bin")
            .env("HOME", "/root");
        run(inside.arg(&empty_root).args(["sh", "-c", command]))?;
    }
    println!("installed, used and removed in an empty Debian");
    Ok(())
}
