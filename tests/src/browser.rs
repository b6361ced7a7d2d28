//! A browser without a screen, driven by WebDriver.
//!
//! Debian's Chromium and its driver; `./run test` installs them and names the
//! driver in `CALIB_CHROMEDRIVER`.

use crate::rigged::Fault;
use fantoccini::elements::Element;
use fantoccini::wd::{Capabilities, WebDriverCompatibleCommand};
use fantoccini::{Client, ClientBuilder, Locator};
use hyper_util::client::legacy::connect::HttpConnector;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tokio::runtime::Runtime;

/// Longest wait for something to appear on a page.
const PATIENCE: Duration = Duration::from_secs(40);

/// Keeps Chromium to the page under test: no sandbox, which root cannot have,
/// no shared memory, of which containers have little, and nothing asked of anybody on a
/// network.
const FLAGS: [&str; 9] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// The driver to test with; `None`, after saying so, when there is none. In CI that
/// is a failure.
pub fn driver() -> Option<PathBuf> {
    let driver = std::env::var_os("CALIB_CHROMEDRIVER").map(PathBuf::from);
    if driver.is_none() {
        assert!(
            std::env::var_os("CI").is_none(),
            "CALIB_CHROMEDRIVER is not set"
        );
        println!("CALIB_CHROMEDRIVER is not set: the page is tried in no browser");
    }
    driver
}

/// The script of axe-core, which `./run test` installs with the Python packages; `None`, after saying so, when
/// it is not there. In CI that is a failure.
pub fn axe() -> Option<PathBuf> {
    let python = std::env::var_os("CALIB_PYTHON").map(PathBuf::from);
    let library = python.and_then(|python| Some(python.parent()?.parent()?.join("lib")));
    let versions = library
        .into_iter()
        .flat_map(std::fs::read_dir)
        .flatten()
        .flatten();
    let script = versions
        .map(|version| {
            let packages = version.path().join("site-packages");
            packages.join("axe_playwright_python/axe.min.js")
        })
        .find(|script| script.exists());
    if script.is_none() {
        assert!(std::env::var_os("CI").is_none(), "there is no axe-core");
        println!("there is no axe-core: nobody looks whether the page can be used by everybody");
    }
    script
}

/// One browser with an empty profile; closed when it is dropped.
pub struct Browser {
    runtime: Runtime,
    client: Client,
    process: Child,
    folder: tempfile::TempDir,
}

impl Browser {
    /// Starts the driver, and a browser by it.
    ///
    /// # Errors
    /// One of them does not start.
    pub fn start(driver: &Path) -> Result<Self, Fault> {
        let folder = tempfile::tempdir()?;
        let mut process = Command::new(driver)
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()?;
        let connected = port(&mut process).and_then(|port| {
            let mut builder = ClientBuilder::new(HttpConnector::new());
            builder.capabilities(capabilities(folder.path()));
            let address = format!("http://127.0.0.1:{port}");
            Ok(runtime.block_on(builder.connect(&address))?)
        });
        match connected {
            Ok(client) => Ok(Self {
                runtime,
                client,
                process,
                folder,
            }),
            Err(fault) => {
                let _ = process.kill();
                let _ = process.wait();
                Err(fault)
            }
        }
    }

    /// Where downloads go.
    pub fn downloads(&self) -> PathBuf {
        self.folder.path().join("downloads")
    }

    /// Makes the screen this large, in pixels of the page; `scale` device pixels
    /// are one of them.
    ///
    /// # Errors
    /// The browser refuses.
    pub fn screen(&self, width: u32, height: u32, scale: f64, phone: bool) -> Result<(), Fault> {
        self.protocol(
            "Emulation.setDeviceMetricsOverride",
            json!({ "width": width, "height": height, "deviceScaleFactor": scale, "mobile": phone }),
        )?;
        Ok(())
    }

    /// A command of Chromium's own protocol, for what WebDriver has none.
    ///
    /// # Errors
    /// The browser refuses.
    pub fn protocol(&self, command: &str, parameters: Value) -> Result<Value, Fault> {
        let command = Protocol(json!({ "cmd": command, "params": parameters }));
        Ok(self.runtime.block_on(self.client.issue_cmd(command))?)
    }

    /// Faults of this page for those who use it by keyboard, by ear or with little sight: each rule of
    /// axe-core that is broken, with the places.
    ///
    /// # Errors
    /// axe-core, or the page, fails.
    pub fn violations(&self, axe: &Path) -> Result<Vec<String>, Fault> {
        let axe = std::fs::read_to_string(axe)?;
        self.protocol("Runtime.evaluate", json!({ "expression": axe }))?;
        let run = "axe.run(document).then((found) => found.violations.map((rule) => rule.id + ' (' + rule.impact + '): '
            + rule.nodes.map((node) => node.target + ' ' + node.any.concat(node.all).map((one) => one.message)).join('; ')))";
        let ran = self.protocol(
            "Runtime.evaluate",
            json!({ "expression": run, "awaitPromise": true, "returnByValue": true }),
        )?;
        let found = ran["result"]["value"].as_array();
        let found = found.ok_or_else(|| format!("axe-core did not run: {ran}"))?;
        Ok(found.iter().map(ToString::to_string).collect())
    }

    /// Opens an address.
    ///
    /// # Errors
    /// It cannot be loaded.
    pub fn open(&self, url: &str) -> Result<(), Fault> {
        Ok(self.runtime.block_on(self.client.goto(url))?)
    }

    /// Opens an address in another tab, and goes on there. Returns the tab before.
    ///
    /// # Errors
    /// It cannot be loaded.
    pub fn open_tab(&self, url: &str) -> Result<Tab, Fault> {
        self.runtime.block_on(async {
            let before = self.client.window().await?;
            let new = self.client.new_window(true).await?;
            self.client.switch_to_window(new.handle).await?;
            self.client.goto(url).await?;
            Ok(Tab(before))
        })
    }

    /// Goes to a tab. Returns the tab before.
    ///
    /// # Errors
    /// It was closed.
    pub fn switch_to(&self, tab: Tab) -> Result<Tab, Fault> {
        self.runtime.block_on(async {
            let before = self.client.window().await?;
            self.client.switch_to_window(tab.0).await?;
            Ok(Tab(before))
        })
    }

    /// Touches what a CSS selector names, as a user would: it must be visible, and
    /// nothing may lie over it.
    ///
    /// # Errors
    /// There is none, or it cannot be touched.
    pub fn click(&self, selector: &str) -> Result<(), Fault> {
        let element = self.find(selector)?;
        Ok(self.runtime.block_on(element.click())?)
    }

    /// Types into a field, in place of what is there.
    ///
    /// # Errors
    /// There is no such field.
    pub fn fill(&self, selector: &str, text: &str) -> Result<(), Fault> {
        let field = self.find(selector)?;
        self.runtime.block_on(async {
            field.clear().await?;
            Ok(field.send_keys(text).await?)
        })
    }

    /// Chooses from a list by value.
    ///
    /// # Errors
    /// There is no such list, or no such value in it.
    pub fn choose(&self, selector: &str, value: &str) -> Result<(), Fault> {
        let list = self.find(selector)?;
        Ok(self.runtime.block_on(list.select_by_value(value))?)
    }

    /// The visible text of what a CSS selector names.
    ///
    /// # Errors
    /// There is none.
    pub fn text(&self, selector: &str) -> Result<String, Fault> {
        let element = self.find(selector)?;
        Ok(self.runtime.block_on(element.text())?)
    }

    fn find(&self, selector: &str) -> Result<Element, Fault> {
        let found = self
            .runtime
            .block_on(self.client.find(Locator::Css(selector)));
        found.map_err(|error| format!("{selector}: {error}").into())
    }

    /// Evaluates an expression of JavaScript on this page.
    ///
    /// # Errors
    /// It throws.
    pub fn value(&self, expression: &str) -> Result<Value, Fault> {
        let script = format!("return ({expression});");
        let value = self.runtime.block_on(self.client.execute(&script, vec![]));
        value.map_err(|error| format!("{expression}: {error}").into())
    }

    /// Waits until the text of what `selector` names contains `words`.
    ///
    /// # Errors
    /// It never does; with what is there instead.
    pub fn wait_for_text(&self, selector: &str, words: &str) -> Result<(), Fault> {
        let begun = Instant::now();
        loop {
            let text = self.text(selector)?;
            if text.contains(words) {
                return Ok(());
            }
            if begun.elapsed() > PATIENCE {
                return Err(format!("{selector} never says '{words}' but '{text}'").into());
            }
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Picture of the screen, as PNG.
    ///
    /// # Errors
    /// The browser refuses.
    pub fn screenshot(&self) -> Result<Vec<u8>, Fault> {
        Ok(self.runtime.block_on(self.client.screenshot())?)
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.runtime.block_on(self.client.clone().close());
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// A tab of the browser.
pub struct Tab(fantoccini::wd::WindowHandle);

/// The port the driver says it listens on.
fn port(process: &mut Child) -> Result<u16, Fault> {
    let output = process.stdout.take().ok_or("the driver says nothing")?;
    for line in BufReader::new(output).lines() {
        let line = line?;
        if let Some((_, port)) = line.split_once("successfully on port ") {
            return Ok(port.trim_end_matches('.').parse()?);
        }
    }
    Err("the driver did not start".into())
}

fn capabilities(folder: &Path) -> Capabilities {
    let mut arguments: Vec<String> = FLAGS.map(str::to_owned).to_vec();
    arguments.push(format!(
        "--user-data-dir={}",
        folder.join("profile").display()
    ));
    let downloads = folder.join("downloads");
    let preferences = json!({ "download.default_directory": downloads });
    let options = json!({ "args": arguments, "prefs": preferences });
    Capabilities::from_iter([("goog:chromeOptions".to_owned(), options)])
}

/// A command of Chromium's own protocol.
#[derive(Debug)]
struct Protocol(Value);

impl WebDriverCompatibleCommand for Protocol {
    fn endpoint(
        &self,
        base: &url::Url,
        session: Option<&str>,
    ) -> Result<url::Url, url::ParseError> {
        base.join(&format!(
            "session/{}/goog/cdp/execute",
            session.unwrap_or_default()
        ))
    }

    fn method_and_body(&self, _: &url::Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(self.0.to_string()))
    }
}
