//! The program for Windows, used as a user would, on a computer without Windows.

use crate::packages::needs;
use crate::shell::{empty, run, said, target_dir};
use crate::windows::COMPILER;
use anyhow::{Context, Result, bail, ensure};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

/// Where Debian has wine; it puts only a script of the whole of it into the path.
const WINE: &str = "/usr/lib/wine/wine64";
const SERVER: &str = "/usr/lib/wine/wineserver64";

/// Rust asks this library for random numbers. Windows has it since 7, wine since 8.18; Debian 12 has 8.0.
const RANDOM: &str = "\
#include <windows.h>
#include <ntsecapi.h>
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE to, SIZE_T size) { return RtlGenRandom(to, (ULONG)size); }
";

/// Particulars that a certificate in every format needs.
const LABORATORY: &str = "\
[laboratory]
name = \"Example Calibration Ltd\"
city = \"Exampletown\"
country = \"GB\"
";

/// Calibrates with the program in `folder`, over a serial port too, serves the page, and compares certificates
/// with those of `tool`, this computer's own, byte by byte.
pub(crate) fn check(folder: &Path, tool: &Path) -> Result<()> {
    needs(WINE, "wine64")?;
    let wine = Wine::begin(folder, tool)?;
    let outcome = wine.a_day();
    // Programs wait for its end, and so would whoever waits for this one.
    let _ = wine.server().arg("--kill").status();
    outcome
}

struct Wine<'a> {
    /// Here it works.
    desk: PathBuf,
    tool: &'a Path,
}

/// One of the two programs, told something.
type By<'a> = fn(&Wine<'a>, &[&str]) -> Command;

/// A program that runs until it is dropped.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Running {
    /// Starts it and waits for the first line it prints.
    fn start(command: &mut Command) -> Result<(Self, String)> {
        let mut child = command.stdout(Stdio::piped()).spawn()?;
        let said = child.stdout.take().context("its output is not piped")?;
        let running = Self(child);
        let mut line = String::new();
        BufReader::new(said).read_line(&mut line)?;
        Ok((running, line.trim().to_owned()))
    }
}

impl<'a> Wine<'a> {
    fn begin(folder: &Path, tool: &'a Path) -> Result<Self> {
        let desk = target_dir().join("wine");
        empty(&desk)?;
        let wine = Self { desk, tool };
        fs::copy(folder.join("calib.exe"), wine.desk.join("calib.exe"))?;
        fs::write(wine.desk.join("laboratory.toml"), LABORATORY)?;
        fs::write(wine.desk.join("points.csv"), "frequency_hz\n160\n")?;
        fs::write(wine.desk.join("random.c"), RANDOM)?;
        let mut compile = Command::new(COMPILER);
        compile.current_dir(&wine.desk);
        run(compile
            .args(["-shared", "-O1", "-o", "bcryptprimitives.dll"])
            .args(["random.c", "-ladvapi32"]))?;
        Ok(wine)
    }

    fn prefix(&self) -> PathBuf {
        self.desk.join("prefix")
    }

    fn server(&self) -> Command {
        let mut server = Command::new(SERVER);
        server.env("WINEPREFIX", self.prefix());
        server
    }

    /// The program for Windows.
    fn calib(&self, arguments: &[&str]) -> Command {
        eprintln!("wine: calib {}", arguments.join(" "));
        let mut calib = self.at_the_desk(Path::new(WINE));
        calib.arg("calib.exe").args(arguments);
        calib
    }

    /// This computer's own.
    fn own(&self, arguments: &[&str]) -> Command {
        let mut calib = self.at_the_desk(self.tool);
        calib.args(arguments);
        calib
    }

    /// A program that works at the desk and is told nothing else.
    fn at_the_desk(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        command.current_dir(&self.desk).env_clear();
        command
            .env("PATH", "/usr/bin:/bin")
            .env("HOME", &self.desk)
            .env("WINEPREFIX", self.prefix())
            .env("WINEDEBUG", "-all");
        command
    }

    fn a_day(&self) -> Result<()> {
        let version = said(&mut self.calib(&["--version"]))?;
        ensure!(
            version == said(&mut self.own(&["--version"]))?,
            "it is {version}"
        );
        run(&mut self.calib(&["demo", "--out", "demo"]))?;
        let same = self.same_certificates()?;
        self.over_a_serial_port()?;
        self.over_a_socket()?;
        self.page()?;
        println!(
            "used under wine: demo, serial port, socket and page; {same} files of a certificate have the same bytes"
        );
        Ok(())
    }

    /// Certificates of one record, of both programs. Returns how many files they are.
    fn same_certificates(&self) -> Result<usize> {
        let record = fs::read_dir(self.desk.join("demo"))?
            .filter_map(|file| file.ok()?.file_name().into_string().ok())
            .find(|name| name.ends_with(".calibrec"));
        let record = format!("demo/{}", record.context("the demo left no record")?);
        let formats = "pdf,dcc,html,csv,json,uff";
        for (out, certificate) in [("windows", Self::calib as By<'a>), ("own", Self::own)] {
            let asked = ["certificate", &record, "--laboratory", "laboratory.toml"];
            let out = ["--format", formats, "--out", out];
            run(&mut certificate(self, &[asked, out].concat()))?;
        }
        let mut same = 0;
        for file in fs::read_dir(self.desk.join("own"))? {
            let file = file?;
            let theirs = fs::read(self.desk.join("windows").join(file.file_name()))?;
            let name = file.file_name();
            ensure!(
                fs::read(file.path())? == theirs,
                "{} differs",
                name.display()
            );
            same += 1;
        }
        ensure!(same == formats.split(',').count(), "{same} files");
        Ok(same)
    }

    /// COM7 is a pseudo terminal with an emulated calibrator behind.
    fn over_a_serial_port(&self) -> Result<()> {
        let (_calibrator, terminal) = Running::start(&mut self.own(&["emulate", "--pty"]))?;
        std::os::unix::fs::symlink(terminal, self.prefix().join("dosdevices/com7"))?;
        run(&mut self.calib(&["--device", "COM7", "run", "--points", "points.csv"]))
    }

    fn over_a_socket(&self) -> Result<()> {
        let (_calibrator, address) = Running::start(&mut self.calib(&["emulate", "--tcp", "0"]))?;
        run(&mut self.own(&["--device", &address, "info"]))
    }

    fn page(&self) -> Result<()> {
        let (_server, address) = Running::start(&mut self.calib(&[
            "--device",
            "emulated",
            "serve",
            "--no-browser",
            "--listen",
            "127.0.0.1:0",
        ]))?;
        let host = address
            .strip_prefix("http://")
            .context("no address of a page")?;
        let host = host.trim_end_matches('/');
        let mut page = String::new();
        let mut connection = TcpStream::connect(host).with_context(|| address.clone())?;
        write!(
            connection,
            "GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"
        )?;
        connection.read_to_string(&mut page)?;
        if !(page.starts_with("HTTP/1.1 200") && page.contains("</html>")) {
            bail!("the page is none: {page}");
        }
        Ok(())
    }
}
