//! The page's server: a calibration, stops, a lost link, two pages, strangers.

use crate::alone;
use crate::command_line::{calib, schemas, serve as serve_device, text};
use crate::device::Device;
use calib_output::conforms::conforms;
use calib_protocol::frame::Frame;
use calib_protocol::message::Request;
use rusqlite::Connection;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// `calib serve` as a process of its own.
struct Server {
    process: Child,
    url: String,
    host: String,
    stop_port: u64,
}

impl Server {
    fn start(folder: &Path, listen: &str, arguments: &[&str]) -> Self {
        // Fewer open files than a flood has connections.
        let mut process = alone("sh", folder)
            .args([
                "-c",
                "ulimit -n 512; exec \"$0\" \"$@\"",
                env!("CARGO_BIN_EXE_calib"),
            ])
            .args(["serve", "--quiet", "--listen", listen])
            .args(arguments)
            .env("CALIB_LOGBOOK", folder.join("logbook.sqlite"))
            .stdout(Stdio::piped())
            .spawn()
            .expect("calib starts");
        let mut url = String::new();
        let mut output = BufReader::new(process.stdout.take().expect("piped"));
        output.read_line(&mut url).expect("an address");
        let url = url.trim().to_owned();
        let host = url.trim_start_matches("http://").split('/').next();
        let host = host.expect("a host").replace("0.0.0.0", "127.0.0.1");
        let mut server = Self {
            process,
            url,
            host,
            stop_port: 0,
        };
        if listen == LOOPBACK {
            server.stop_port = server.state()["stop_port"].as_u64().expect("a port");
        }
        server
    }

    /// Status and body of a request with these headers.
    fn ask(&self, line: &str, headers: &str, body: &str) -> (u16, String) {
        exchange(&self.host, line, headers, body)
    }

    fn get(&self, path: &str) -> (u16, String) {
        self.ask(
            &format!("GET {path}"),
            &format!("Host: {}\r\n", self.host),
            "",
        )
    }

    fn post(&self, path: &str, body: &Value) -> u16 {
        let headers = format!("Host: {}\r\nContent-Type: application/json\r\n", self.host);
        self.ask(&format!("POST {path}"), &headers, &body.to_string())
            .0
    }

    /// Has a certificate issued.
    fn issue(&self, path: &str) -> (u16, String) {
        let headers = format!("Host: {}\r\nContent-Type: application/json\r\n", self.host);
        self.ask(&format!("POST {path}"), &headers, "{}")
    }

    /// A file that is given out.
    fn issued(&self, path: &str) -> Vec<u8> {
        let headers = format!("Host: {}\r\nContent-Type: application/json\r\n", self.host);
        let (status, body) = exchange_bytes(&self.host, &format!("POST {path}"), &headers, "{}");
        assert_eq!(status, 200, "{}", text(&body));
        body
    }

    fn state(&self) -> Value {
        let (status, body) = self.get("/api/state");
        assert_eq!(status, 200, "{body}");
        let state = serde_json::from_str(&body).expect("JSON");
        conforms_to("page-state", &state);
        state
    }

    /// Waits until the view fulfils this.
    fn until(&self, what: &str, is: impl Fn(&Value) -> bool) -> Value {
        let begun = Instant::now();
        loop {
            let state = self.state();
            if is(&state) {
                return state;
            }
            assert!(begun.elapsed() < Duration::from_secs(20), "{what}: {state}");
            std::thread::sleep(Duration::from_millis(30));
        }
    }

    fn connected(&self) {
        self.until("connected", |view| view["link"] == "connected");
    }

    /// A page's channel.
    fn page(&self) -> Page {
        let stream = TcpStream::connect(&self.host).expect("it listens");
        stream
            .set_read_timeout(Some(Duration::from_secs(20)))
            .expect("a timeout");
        let address = format!("ws://{}/api/live", self.host);
        let (page, _) = tungstenite::client(address, stream).expect("a channel");
        page
    }

    /// A stop on the port that takes nothing else: status, body, and how long it took.
    fn stop(&self, body: &Value) -> (u16, String, Duration) {
        let (name, _) = self.host.rsplit_once(':').expect("a port");
        let host = format!("{name}:{}", self.stop_port);
        let headers = format!("Host: {host}\r\n");
        let begun = Instant::now();
        let (status, said) = exchange(&host, "POST /api/stop", &headers, &body.to_string());
        (status, said, begun.elapsed())
    }
}

/// One request over a connection of its own.
fn exchange(host: &str, line: &str, headers: &str, body: &str) -> (u16, String) {
    let (status, body) = exchange_bytes(host, line, headers, body);
    (status, text(&body))
}

/// One request whose answer may be no text.
fn exchange_bytes(host: &str, line: &str, headers: &str, body: &str) -> (u16, Vec<u8>) {
    let mut stream = TcpStream::connect(host).expect("it listens");
    stream
        .set_read_timeout(Some(Duration::from_secs(20)))
        .expect("a timeout");
    let length = body.len();
    let request = format!(
        "{line} HTTP/1.1\r\nConnection: close\r\nContent-Length: {length}\r\n{headers}\r\n{body}"
    );
    stream.write_all(request.as_bytes()).expect("sent");
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).expect("an answer");
    let end = answer.windows(4).position(|four| four == b"\r\n\r\n");
    let (head, body) = answer.split_at(end.expect("a body") + 4);
    let head = text(head);
    let status = head.split(' ').nth(1).expect("a status");
    (status.parse().expect("a number"), body.to_vec())
}

type Page = tungstenite::WebSocket<TcpStream>;

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// The page is given what is published.
fn conforms_to(name: &str, document: &Value) {
    let schema = std::fs::read(schemas().join(format!("{name}.json"))).expect("a schema");
    let schema = serde_json::from_slice(&schema).expect("JSON");
    conforms(document, &schema).expect("as in its schema");
}

const LOOPBACK: &str = "127.0.0.1:0";

fn has_ended(view: &Value) -> bool {
    view["run"]["running"] == false
}

/// The next view of a channel that fulfils this.
fn next_view(page: &mut Page, is: impl Fn(&Value) -> bool) -> Value {
    loop {
        let mut said = next_message(page);
        if said["view"].is_object() && is(&said["view"]) {
            return said["view"].take();
        }
    }
}

fn next_message(page: &mut Page) -> Value {
    let said = page.read().expect("a message").into_text().expect("text");
    serde_json::from_str(&said).expect("JSON")
}

#[test]
fn a_calibration_is_started_watched_by_two_pages_and_certified() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, device) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &[]);
    for (path, words) in [
        ("/", "STOP"),
        ("/live.js", "WebSocket"),
        ("/style.css", "#stop"),
    ] {
        let (status, body) = server.get(path);
        assert!(status == 200 && body.contains(words), "{path}");
    }
    assert_eq!(server.state()["link"], "none");
    assert_eq!(
        server.post("/api/connect", &json!({ "device": device })),
        202
    );
    server.connected();
    let (mut one, mut other) = (server.page(), server.page());
    let run = json!({ "dut_serial": "D'1", "operator": "N.", "frequencies_hz": [80, 160, 315] });
    assert_eq!(server.post("/api/run", &run), 202);
    // Both pages see it run, and end with the same.
    next_view(&mut one, |view| view["run"]["running"] == true);
    let kept = |view: &Value| has_ended(view) && view["run"]["logbook_record"] == 1;
    let views = [next_view(&mut one, kept), next_view(&mut other, kept)];
    assert_eq!(views[0], views[1]);
    let ended = &views[0]["run"];
    assert_eq!(ended["ended"], "finished");
    let points = ended["points"].as_array().expect("points");
    assert_eq!(points.len(), 3);
    assert_eq!(points[1]["frequency_hz"], 160.0);
    assert_eq!(ended["logbook_record"], 1);
    let (status, page) = server.get("/api/certificate/html");
    assert!(
        status == 200 && page.contains("D&#x27;1") || page.contains("D'1"),
        "{status}"
    );
    assert_eq!(server.issue("/api/certificate/exe").0, 400);
    let (status, why) = server.get("/api/certificate/html?issued=tomorrow");
    assert!(status == 400 && why.contains("issued"), "{why}");
    // The first run made the logbook, and records in it have certificates too. One
    // that was viewed is not issued, one that was downloaded is.
    assert_eq!(server.get("/api/records/1/certificate/html").1, page);
    let issued = || {
        let logbook = calib_logbook::Logbook::open(&folder.path().join("logbook.sqlite"));
        logbook
            .expect("a logbook")
            .certificates()
            .expect("a list")
            .len()
    };
    // An image on another site's page can ask for any address: nothing is issued by that.
    for format in ["json", "pdf", "csv"] {
        let path = format!("/api/records/1/certificate/{format}");
        assert_eq!(server.get(&path).0, 405);
    }
    assert_eq!(issued(), 0);
    let (status, json) = server.issue("/api/records/1/certificate/json");
    assert!(status == 200 && json.contains("sensitivity"), "{json}");
    assert_eq!(issued(), 1);
    let chain = |json: &str| -> Value {
        let json: Value = serde_json::from_str(json).expect("JSON");
        conforms_to("certificate-file", &json);
        json["record_chain"].clone()
    };
    assert_eq!(chain(&json), "first");
    amended_once(&server);
    assert_eq!(server.issue("/api/records/2/certificate/json").0, 400);
    let (status, why) = server.issue("/api/certificate/dcc");
    assert!(status == 400 && why.contains("country"), "{why}");
    let (_, waveforms) = server.get("/api/waveforms");
    let waveforms: Value = serde_json::from_str(&waveforms).expect("JSON");
    conforms_to("page-waveforms", &waveforms);
    assert_eq!(waveforms["number"], views[0]["waveforms"]);
    let (_, records) = server.get("/api/records");
    let records: Value = serde_json::from_str(&records).expect("JSON");
    assert_eq!(records[0]["dut_serial"], "D'1");
    let assurance: Value = serde_json::from_str(&server.get("/api/assurance").1).expect("JSON");
    assert_eq!(assurance["standards"], json!([]));
    let (status, report) = server.get("/api/assurance/report");
    assert_eq!(status, 200);
    assert!(report.contains("There is no check standard"), "{report}");
    let history = server.get("/api/history/D'1").1;
    assert!(history.contains("\"frequency_hz\":160"), "{history}");
    // The logbook has the record before the next one.
    assert_eq!(server.post("/api/run", &run), 202);
    next_view(&mut one, |view| view["run"]["logbook_record"] == 2);
    let (_, json) = server.issue("/api/records/2/certificate/json");
    assert_eq!(chain(&json), "verified");
    // The tool asks the same of the same logbook, though nothing lies beside the file. Before, it said nothing of a
    // record whose neighbours only the logbook has.
    let tool = |arguments: &[&str]| {
        let output = calib(
            folder.path(),
            &[arguments, &["--logbook", "logbook.sqlite"]].concat(),
        );
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    tool(&["logbook", "get", "2", "--out", "alone/two.calibrec"]);
    let file = tool(&["certificate", "alone/two.calibrec", "--format", "json"]);
    let written = std::fs::read_to_string(folder.path().join(file.trim())).expect("written");
    assert_eq!(written, json);
}

/// A mistake in an issued certificate is put right on the page: looked at, then issued under another number.
fn amended_once(server: &Server) {
    let issued = |server: &Server| -> Value {
        serde_json::from_str(&server.get("/api/certificates").1).expect("JSON")
    };
    let old = issued(server)[0]["certificate"].clone();
    let old = old.as_str().expect("a number");
    let query = format!("replaces={old}&reason=customer&customer=B.%20Ltd");
    let (status, page) = server.get(&format!("/api/amended/html?{query}"));
    assert!(status == 200 && page.contains("B. Ltd"), "{status} {page}");
    assert_eq!(server.get(&format!("/api/amended/json?{query}")).0, 405);
    assert_eq!(issued(server)[0]["replaced_by"], Value::Null);
    let (status, new) = server.issue(&format!("/api/amended/json?{query}"));
    assert_eq!(status, 200, "{new}");
    let new: Value = serde_json::from_str(&new).expect("JSON");
    assert_eq!(new["certificate"], format!("{old}-A1"));
    assert_eq!(new["replaces"]["certificate"], old);
    assert_eq!(issued(server)[0]["replaced_by"], new["certificate"]);
    let (status, why) = server.issue(&format!("/api/amended/json?replaces={old}&reason="));
    assert!(status == 400 && why.contains("reason"), "{why}");
}

#[test]
fn a_stop_ends_a_run_and_one_while_idle_reaches_the_calibrator_too() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let run = json!({ "set_acceleration_rms_ms2": 5 });
    assert_eq!(server.post("/api/run", &run), 202);
    server.until("running", |view| view["run"]["status"].is_object());
    // A second page cannot begin another one meanwhile.
    assert_eq!(server.post("/api/run", &run), 409);
    let begun = Instant::now();
    assert_eq!(server.post("/api/stop", &json!({})), 200);
    let view = server.until("stopped", has_ended);
    // One look a tenth of a second, and what a loaded computer takes.
    assert!(begun.elapsed() < Duration::from_secs(3));
    assert_eq!(view["run"]["ended"], "stopped, the exciter is silent");
    assert!(view["run"]["points"].as_array().expect("points").len() < 28);
    device.lock().expect("device").requests.clear();
    server.post("/api/stop", &json!({}));
    let begun = Instant::now();
    while !device
        .lock()
        .expect("device")
        .requests
        .contains(&Request::Stop)
    {
        assert!(begun.elapsed() < Duration::from_secs(5), "idle stop");
        std::thread::sleep(Duration::from_millis(20));
    }
    // And the next run is not stopped by any of them.
    server.post("/api/run", &json!({ "frequencies_hz": [160] }));
    let view = server.until("finished", |view| {
        view["run"]["number"] == 2 && has_ended(view)
    });
    assert_eq!(view["run"]["ended"], "finished");
}

/// Before, every sensitivity was refused: "invalid type: map, expected f64".
#[test]
fn sensors_of_every_kind_are_registered_and_measured_in_their_unit() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let register = |sensor: &Value| server.post("/api/sensors", sensor);
    let charge = json!({
        "serial": "C1", "sensitivity": 1, "unit": "pC/(m/s2) at 10 mV/pC +-0.5%", "tolerance": "5",
        "range": 500.5, "iepe": false
    });
    assert_eq!(register(&charge), 200);
    let velocity = json!({ "serial": "V1", "sensitivity": 4.5, "unit": "mV/(mm/s)" });
    assert_eq!(register(&velocity), 200);
    for wrong in [
        json!({ "serial": "X", "sensitivity": "much" }),
        json!({ "serial": "X", "unit": "pC/g" }),
        json!({ "serial": "C1", "sensitivity": 1 }),
        json!({ "sensitivity": 1 }),
    ] {
        assert_eq!(register(&wrong), 400, "{wrong}");
    }
    let sensors: Value = serde_json::from_str(&server.get("/api/sensors").1).expect("JSON");
    let of = |serial: &str| {
        let all = sensors.as_array().expect("a list");
        all.iter()
            .find(|sensor| sensor["serial"] == serial)
            .expect(serial)
            .clone()
    };
    assert_eq!(
        (&of("C1")["sensitivity"], &of("V1")["sensitivity"]),
        (&json!(1.0), &json!(4.5))
    );
    assert_eq!(of("V1")["sensitivity_v_per_ms2"], Value::Null);
    // The device measures 10 mV/(m/s2): 1 pC/(m/s2) through 10 mV/pC.
    let run = json!({ "sensor": "C1", "frequencies_hz": [160] });
    assert_eq!(server.post("/api/run", &run), 202);
    let view = server.until("ended", has_ended);
    assert_eq!(view["run"]["unit"], "pC/(m/s2)");
    let own = view["run"]["points"][0]["in_unit"]["sensitivity"]
        .as_f64()
        .expect("a number");
    assert!((own - 1.0).abs() < 1e-6, "{own}");
    let records: Value = serde_json::from_str(&server.get("/api/records").1).expect("JSON");
    assert_eq!(records[0]["unit"], "pC/(m/s2)");
    let judged: Value = serde_json::from_str(&server.get("/api/judged").1).expect("JSON");
    assert_eq!(judged["conformity_statement"]["conformity"], "pass");
}

#[test]
fn a_list_that_cannot_be_measured_names_its_points_and_moves_nothing() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    // The reference is calibrated to 20 kHz; 10 m/s2 at 6 Hz need 9.95 mm of 5.
    let run = json!({ "frequencies_hz": [160, 30000, 6] });
    assert_eq!(server.post("/api/run", &run), 202);
    let view = server.until("ended", has_ended);
    let run = &view["run"];
    let ended = run["ended"].as_str().expect("words");
    assert!(ended.starts_with("nothing was moved"), "{ended}");
    let impossible = run["impossible"].as_array().expect("reasons");
    let of = |reason: &str| {
        let found = impossible
            .iter()
            .find(|refused| refused["reason"] == reason);
        found.map(|refused| refused["frequencies_hz"].clone())
    };
    assert_eq!(of("frequency_unavailable"), Some(json!([30000.0])));
    assert_eq!(of("displacement_limit"), Some(json!([6.0])));
    let starts = device.lock().expect("device").starts;
    assert_eq!(starts, 0);
}

/// The point is over in three looks, in which half of the samples come. Before, they were thrown away then, and the
/// page had no waveforms.
#[test]
fn a_run_that_ends_before_its_samples_are_here_has_waveforms() {
    let folder = tempfile::tempdir().expect("folder");
    let mut device = Device::new();
    device.looks_per_capture = 1;
    let (_, address) = serve_device(device);
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let run = json!({ "frequencies_hz": [160] });
    assert_eq!(server.post("/api/run", &run), 202);
    let view = server.until("ended", has_ended);
    assert_eq!(view["waveforms"], 1);
    let drawn: Value = serde_json::from_str(&server.get("/api/waveforms").1).expect("JSON");
    assert_eq!(drawn["frequency_hz"], 160.0);
    assert!(
        drawn["spectrum"]
            .as_array()
            .is_some_and(|lines| lines.len() > 100),
        "{drawn}"
    );
}

/// Before: the page sent frequencies again at the level of its form, and showed and certified those alone.
#[test]
fn a_retry_measures_what_has_no_result_and_both_runs_are_one_calibration() {
    let folder = tempfile::tempdir().expect("folder");
    let mut dead = Device::new();
    dead.silent_hz = vec![160.0, 315.0];
    let (device, address) = serve_device(dead);
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let of_form = json!({
        "dut_serial": "S1", "frequencies_hz": [80, 160, 315, 630], "set_acceleration_rms_ms2": 5
    });
    assert_eq!(server.post("/api/run", &of_form), 202);
    let first = server.until("ended", has_ended);
    assert_eq!(first["run"]["unit"], "mV/(m/s2)");
    device.lock().expect("device").silent_hz.clear();
    assert_eq!(server.post("/api/run", &json!({ "retry": true })), 202);
    let view = server.until("both", |view| view["run"]["number"] == 2 && has_ended(view));
    let points = view["run"]["points"].as_array().expect("points");
    assert_eq!(points.len(), 4);
    assert!(
        points.iter().all(|point| point["state"] == "valid"),
        "{points:?}"
    );
    let last = device
        .lock()
        .expect("device")
        .requests
        .iter()
        .rev()
        .find_map(|request| match request {
            Request::Start(spec) => Some(spec.clone()),
            _ => None,
        });
    let spec = last.expect("a start");
    let again: Vec<(f32, f32)> = spec
        .points
        .iter()
        .map(|p| (p.frequency_hz, p.acceleration_rms_ms2))
        .collect();
    assert_eq!(again, [(160.0, 5.0), (315.0, 5.0)]);
    assert_eq!(spec.labels.dut_serial.as_str(), "S1");
    let judged: Value = serde_json::from_str(&server.get("/api/judged").1).expect("JSON");
    assert_eq!(judged["points"].as_array().expect("points").len(), 4);
    let (status, certificate) = server.issue("/api/certificate/json");
    assert_eq!(status, 200, "{certificate}");
    let certificate: Value = serde_json::from_str(&certificate).expect("JSON");
    assert_eq!(certificate["points"].as_array().expect("points").len(), 4);
    assert!(certificate["calibration"]["retried"].is_string());
    // Nothing is left.
    assert_eq!(server.post("/api/run", &json!({ "retry": true })), 400);
}

/// A link that can be cut: bytes to and from a device, until it is.
struct Cable {
    address: String,
    ends: Arc<Mutex<Vec<TcpStream>>>,
}

impl Cable {
    fn to(device: &str) -> Self {
        let listener = TcpListener::bind(LOOPBACK).expect("a port");
        let address = format!("tcp:{}", listener.local_addr().expect("address"));
        let ends = Arc::new(Mutex::new(Vec::new()));
        let (held, device) = (
            Arc::clone(&ends),
            device.trim_start_matches("tcp:").to_owned(),
        );
        std::thread::spawn(move || {
            for near in listener.incoming().map_while(Result::ok) {
                let far = TcpStream::connect(&device).expect("the device");
                let mut held = held.lock().expect("ends");
                for (from, to) in [(&near, &far), (&far, &near)] {
                    let mut from = from.try_clone().expect("a copy");
                    let mut to = to.try_clone().expect("a copy");
                    std::thread::spawn(move || std::io::copy(&mut from, &mut to));
                }
                held.extend([near, far]);
            }
        });
        Self { address, ends }
    }

    fn cut(&self) {
        for end in self.ends.lock().expect("ends").drain(..) {
            let _ = end.shutdown(Shutdown::Both);
        }
    }
}

#[test]
fn a_run_is_followed_to_its_end_after_the_link_broke() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve_device(Device::new());
    let cable = Cable::to(&address);
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &cable.address]);
    server.connected();
    let mut page = server.page();
    server.post(
        "/api/run",
        &json!({ "frequencies_hz": [80, 160, 250, 315] }),
    );
    next_view(&mut page, |view| view["run"]["status"].is_object());
    cable.cut();
    let lost = next_view(&mut page, |view| view["link"] == "lost");
    assert_eq!(lost["run"]["running"], true, "it goes on without us");
    let trouble = lost["trouble"].as_str().expect("words");
    assert!(trouble.contains("is gone"), "{trouble}");
    let ended = next_view(&mut page, has_ended);
    assert_eq!(ended["run"]["ended"], "finished");
    assert_eq!(ended["run"]["points"].as_array().expect("points").len(), 4);
    assert_eq!(ended["trouble"], Value::Null);
    assert_eq!(device.lock().expect("device").starts, 1);
}

/// Requests that a page of another site makes a browser send, with the headers the browser adds.
#[test]
fn other_sites_reach_nothing() {
    let folder = tempfile::tempdir().expect("folder");
    let server = Server::start(folder.path(), LOOPBACK, &[]);
    let own = format!(
        "Host: {}\r\nContent-Type: application/json\r\n",
        server.host
    );
    let evil = "Origin: http://evil.example\r\nSec-Fetch-Site: cross-site\r\n";
    let neighbour = "Sec-Fetch-Site: same-site\r\n";
    for told in [evil, neighbour, "Origin: null\r\n"] {
        let headers = format!("{own}{told}");
        for line in [
            "GET /api/state",
            "GET /api/live",
            "POST /api/run",
            "POST /api/stop",
        ] {
            assert_eq!(server.ask(line, &headers, "{}").0, 403, "{line} {told}");
        }
    }
    // A link to the page on another site works, and shows nothing by itself.
    let link = format!("{own}Sec-Fetch-Site: cross-site\r\n");
    assert_eq!(server.ask("GET /", &link, "").0, 200);
    let port = format!("127.0.0.1:{}", server.stop_port);
    let stop = |told: &str| {
        exchange(
            &port,
            "POST /api/stop",
            &format!("Host: {port}\r\n{told}"),
            "{}",
        )
        .0
    };
    assert_eq!(stop(evil), 403);
    assert_eq!(
        stop("Origin: http://127.0.0.1:9\r\nSec-Fetch-Site: same-site\r\n"),
        403
    );
    let page = format!(
        "Origin: http://{}\r\nSec-Fetch-Site: same-site\r\n",
        server.host
    );
    assert_eq!(
        stop(&page),
        504,
        "let in; there is no calibrator to confirm it"
    );
    assert_eq!(
        exchange(&port, "GET /api/state", &format!("Host: {port}\r\n"), "").0,
        404
    );
}

/// A port that takes a connection, and what is said on it, and never says a word.
fn mute() -> (TcpListener, String) {
    let listener = TcpListener::bind(LOOPBACK).expect("a port");
    let address = format!("tcp:{}", listener.local_addr().expect("address"));
    (listener, address)
}

#[test]
fn of_starts_that_come_together_one_is_taken() {
    let folder = tempfile::tempdir().expect("folder");
    let (_held, address) = mute();
    let server = Server::start(folder.path(), LOOPBACK, &[]);
    server.post("/api/connect", &json!({ "device": address }));
    let run = json!({ "frequencies_hz": [160] });
    let post = || server.post("/api/run", &run);
    let mut taken = std::thread::scope(|scope| {
        let posts: Vec<_> = (0..8).map(|_| scope.spawn(post)).collect();
        let answers = posts
            .into_iter()
            .map(|post| post.join().expect("an answer"));
        answers.collect::<Vec<_>>()
    });
    taken.sort_unstable();
    assert_eq!(taken, [202, 409, 409, 409, 409, 409, 409, 409]);
    assert_eq!(
        server.post("/api/connect", &json!({ "device": "tcp:127.0.0.1:1" })),
        409
    );
}

#[test]
fn a_stop_that_comes_late_does_not_end_the_next_run() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    server.post("/api/run", &json!({ "frequencies_hz": [160] }));
    server.until("the first", has_ended);
    server.post("/api/run", &json!({}));
    server.until("the second", |view| {
        view["run"]["number"] == 2 && view["run"]["status"].is_object()
    });
    let (status, said, _) = server.stop(&json!({ "run": 1 }));
    assert_eq!(status, 409);
    assert!(
        said.contains("run 2") && said.contains("STOP again"),
        "{said}"
    );
    let mut page = server.page();
    page.send(tungstenite::Message::text(r#"{"run":1,"id":7}"#))
        .expect("sent");
    let answer = loop {
        let said = next_message(&mut page);
        if said["stop_answer"].is_object() {
            break said["stop_answer"].clone();
        }
    };
    assert_eq!(answer["id"], 7);
    assert!(answer["why"].as_str().expect("words").contains("run 2"));
    let stops = |request: &Request| matches!(request, Request::Stop | Request::StopRun { .. });
    assert!(!device.lock().expect("device").requests.iter().any(stops));
    // The right number ends it, and the calibrator's word is waited for.
    assert_eq!(server.stop(&json!({ "run": 2 })).0, 200);
    let view = server.until("stopped", has_ended);
    assert_eq!(view["stop"]["run"], 2);
    assert_eq!(view["stop"]["state"], "confirmed");
}

#[test]
fn a_stop_that_nobody_confirms_is_an_alarm_after_200_ms() {
    let folder = tempfile::tempdir().expect("folder");
    let (listener, address) = mute();
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    let (mut device, _) = listener.accept().expect("the tool");
    let (status, said, took) = server.stop(&json!({}));
    assert_eq!(status, 504);
    assert!(
        said.contains("did not confirm the stop within 200 ms"),
        "{said}"
    );
    // The fifth of a second, and what a loaded computer takes.
    assert!(took >= Duration::from_millis(200), "{took:?}");
    assert!(took < Duration::from_millis(1200), "{took:?}");
    assert_eq!(server.state()["stop"]["state"], "unconfirmed");
    // It was on its way at once, ahead of the answer that never came.
    device
        .set_read_timeout(Some(Duration::from_secs(5)))
        .expect("a timeout");
    let mut receiver = calib_protocol::frame::Receiver::new();
    let mut is_stop = |byte: &u8| {
        let whole = receiver.push(*byte).and_then(|raw| Frame::check(raw).ok());
        whole.is_some_and(|frame| frame.message() == Ok(Request::Stop))
    };
    let mut part = [0; 256];
    loop {
        let count = device.read(&mut part).expect("bytes");
        assert!(count > 0, "it is not sent");
        if part[..count].iter().any(&mut is_stop) {
            return;
        }
    }
}

/// A calibrator that answers late: the alarm is raised, and taken back with the time it took. Before, nothing was
/// told of what came between 200 and 500 ms.
#[test]
fn a_stop_that_is_confirmed_late_is_an_alarm_first_and_taken_back() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let busy = device.lock().expect("device");
    let (status, said, _) = server.stop(&json!({}));
    assert_eq!(status, 504, "{said}");
    assert_eq!(server.state()["stop"]["state"], "unconfirmed");
    drop(busy);
    let view = server.until("confirmed", |view| view["stop"]["state"] == "confirmed");
    let after_s = view["stop"]["after_s"].as_f64().expect("a time");
    assert!(after_s >= 0.2, "{after_s}");

    // The tool, by itself.
    drop(server);
    let (begun, waits) = std::sync::mpsc::channel();
    let busy = std::thread::spawn(move || {
        let _busy = device.lock().expect("device");
        begun.send(()).expect("heard");
        std::thread::sleep(Duration::from_millis(400));
    });
    waits.recv().expect("begun");
    let output = calib(folder.path(), &["--device", &address, "stop", "--quiet"]);
    busy.join().expect("no panic");
    let said = text(&output.stderr);
    assert!(output.status.success(), "{said}");
    let alarm = said.find("NOT STOPPED: no confirmation within 200 ms");
    assert!(alarm < said.find("stopped after 0."), "{said}");
    assert!(alarm.is_some(), "{said}");
}

fn key(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("signing/test-keys")
        .join(name)
}

/// Before, a certificate of the page was never signed, and left an entry that nobody had signed.
#[test]
fn what_the_page_gives_out_is_signed_and_so_is_the_journal() {
    let folder = tempfile::tempdir().expect("folder");
    let at = folder.path();
    std::fs::write(at.join("password"), "test\n").expect("written");
    std::fs::write(at.join("house.toml"), "[laboratory]\ncountry = 'DE'\n").expect("written");
    let (_, address) = serve_device(Device::new());
    let usual = ["--device", &address, "--laboratory", "house.toml"];
    let seal = key("p256.p12");
    let seal = [
        "--sign",
        seal.to_str().expect("UTF-8"),
        "--password-file",
        "password",
    ];
    let server = Server::start(at, LOOPBACK, &[&usual[..], &seal].concat());
    server.connected();
    assert_eq!(
        server.state()["signer"],
        "CN=Test seal P-256,O=Beispiel Kalibrierung GmbH,C=DE"
    );
    assert_eq!(
        server.post("/api/run", &json!({ "frequencies_hz": [160] })),
        202
    );
    server.until("kept", |view| view["run"]["logbook_record"] == 1);
    let known = calib_signing::Certificate::read(&key("p256.pem")).expect("certificate");
    let now = jiff::Timestamp::now();
    let logbook = || calib_logbook::Logbook::open(&at.join("logbook.sqlite")).expect("a logbook");
    // The last is the first once more: the same file, and no other signature.
    for path in [
        "certificate/pdf",
        "certificate/dcc",
        "records/1/certificate/pdf",
    ] {
        let file = server.issued(&format!("/api/{path}"));
        let kind = calib_signing::Kind::of(&file).expect("PDF or DCC");
        let signature = calib_signing::verify(kind, &file).expect(path);
        assert!(signature.is_of(&known, now), "{path}");
        let issued = logbook().issued_as(&file).expect("read").expect("entered");
        assert_eq!(
            issued.signed.last().expect("one").signed_by,
            signature.by.subject()
        );
        assert_eq!(server.state()["unsigned_entries"], 0, "{path}");
    }
    let forms: Vec<_> = logbook().certificates().expect("read");
    let forms: Vec<_> = forms.iter().map(|c| (&*c.format, c.signed.len())).collect();
    assert_eq!(forms, [("pdf", 1), ("dcc", 1)]);
    let problems = [logbook().inspect(), logbook().inspect_seals(&known)];
    assert!(
        problems
            .iter()
            .all(|found| found.as_ref().is_ok_and(Vec::is_empty)),
        "{problems:?}"
    );
    let (all, signed) = logbook().signed_entries().expect("read");
    assert!(all == signed && all > 0, "{signed} of {all}");

    // Without a key it says so, and how much waits.
    drop(server);
    let server = Server::start(at, LOOPBACK, &usual);
    assert_eq!(server.state()["signer"], Value::Null);
    server.issued("/api/records/1/certificate/json");
    assert_eq!(server.state()["unsigned_entries"], 1);
}

/// A server that is connected, and whose logbook another program holds until the second is dropped.
fn with_a_locked_logbook(folder: &Path) -> (Server, Connection) {
    let (_, address) = serve_device(Device::new());
    let server = Server::start(folder, LOOPBACK, &["--device", &address]);
    server.connected();
    let logbook = Connection::open(folder.join("logbook.sqlite")).expect("a file");
    logbook.execute_batch("BEGIN EXCLUSIVE").expect("locked");
    (server, logbook)
}

/// Connections that ask for nothing, more than the server may have open files; a logbook that is locked.
#[test]
fn a_flood_and_a_locked_logbook_are_in_no_stop_s_way() {
    let folder = tempfile::tempdir().expect("folder");
    let (server, _lock) = with_a_locked_logbook(folder.path());
    let port = format!("127.0.0.1:{}", server.stop_port);
    let idle = |to: &str| TcpStream::connect(to).expect("it listens");
    let _flood: Vec<_> = (0..300)
        .flat_map(|_| [idle(&server.host), idle(&port)])
        .collect();
    let start = json!({ "sensor": "x", "frequencies_hz": [160] });
    std::thread::scope(|scope| {
        // It waits for the logbook.
        scope.spawn(|| server.post("/api/run", &start));
        let (status, said, took) = server.stop(&json!({}));
        assert_eq!(status, 200, "{said}");
        // The promise is half a second; the rest is for a loaded computer.
        assert!(took < Duration::from_millis(1500), "{took:?}");
        assert_eq!(server.get("/").0, 200);
    });
}

/// Connections that ask for what there is, or is not, and stay: more than the server holds.
#[test]
fn hosts_that_ask_politely_leave_room_for_a_stop() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let port = format!("127.0.0.1:{}", server.stop_port);
    let ask = |to: &String| {
        let mut stream = TcpStream::connect(to).expect("it listens");
        let request = format!("GET /page.js HTTP/1.1\r\nHost: {to}\r\n\r\n");
        stream.write_all(request.as_bytes()).expect("sent");
        let mut answer = [0; 12];
        // It may make room for the next before it has read the answer.
        let _ = stream.read(&mut answer);
        stream
    };
    let _flood: Vec<_> = (0..150).map(|_| [ask(&server.host), ask(&port)]).collect();
    let (status, said, took) = server.stop(&json!({}));
    assert_eq!(status, 200, "{said}");
    assert!(took < Duration::from_millis(1500), "{took:?}");
    assert_eq!(server.get("/").0, 200);
}

/// Requests that announce what they never send, more than the server holds, on both ports: before, each of them kept its
/// place, and a stop found none.
#[test]
fn requests_that_never_end_leave_room_for_a_stop() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, address) = serve_device(Device::new());
    let server = Server::start(folder.path(), LOOPBACK, &["--device", &address]);
    server.connected();
    let port = format!("127.0.0.1:{}", server.stop_port);
    let announce = |to: &String| {
        let mut stream = TcpStream::connect(to).expect("it listens");
        let request = format!(
            "POST /api/stop HTTP/1.1\r\nHost: {to}\r\nContent-Type: application/json\r\nContent-Length: 9\r\n\r\n"
        );
        stream.write_all(request.as_bytes()).expect("sent");
        stream
    };
    let mut flood: Vec<_> = (0..150)
        .map(|_| [announce(&server.host), announce(&port)])
        .collect();
    let (status, said, took) = server.stop(&json!({}));
    assert_eq!(status, 200, "{said}");
    assert!(took < Duration::from_millis(1500), "{took:?}");
    assert_eq!(server.get("/").0, 200);
    // One that is still there is told so, and may ask again.
    let [last, _] = flood.last_mut().expect("some");
    let mut answer = [0; 12];
    last.read_exact(&mut answer).expect("an answer");
    assert_eq!(&answer, b"HTTP/1.1 408");
}

/// A record measured while another program holds the logbook gets there.
#[test]
fn a_run_measured_while_the_logbook_is_locked_is_entered_later() {
    let folder = tempfile::tempdir().expect("folder");
    let (server, lock) = with_a_locked_logbook(folder.path());
    assert_eq!(
        server.post("/api/run", &json!({ "frequencies_hz": [160] })),
        202
    );
    let view = server.until("ended", |view| {
        has_ended(view) && view["trouble"].is_string()
    });
    assert_eq!(view["run"]["ended"], "finished");
    assert_eq!(view["run"]["logbook_record"], Value::Null);
    let trouble = view["trouble"].as_str().expect("words");
    assert!(trouble.contains("waits in"), "{trouble}");
    drop(lock);
    let view = server.until("entered", |view| view["run"]["logbook_record"] == 1);
    assert_eq!(view["trouble"], Value::Null);
}

#[test]
fn strangers_are_kept_out() {
    let folder = tempfile::tempdir().expect("folder");
    let server = Server::start(folder.path(), LOOPBACK, &[]);
    assert!(server.url.starts_with("http://127.0.0.1:") && !server.url.contains("token"));
    let evil = "Host: evil.example\r\n";
    assert_eq!(server.ask("GET /api/state", evil, "").0, 403);
    // What a form of another site can send.
    let form = format!("Host: {}\r\nContent-Type: text/plain\r\n", server.host);
    assert_eq!(server.ask("POST /api/run", &form, "{}").0, 415);
    assert_eq!(
        server.post("/api/run", &json!({ "set_acceleration_rms_ms2": -1 })),
        400
    );
    assert_eq!(
        server.post("/api/run", &json!({ "dut_serial": "x".repeat(99) })),
        400
    );

    let open = Server::start(folder.path(), "0.0.0.0:0", &[]);
    let (_, token) = open.url.split_once("?token=").expect("a token");
    assert_eq!(open.get("/").0, 403);
    assert_eq!(open.get("/page.js").0, 200);
    assert_eq!(open.get("/api/state?token=0").0, 403);
    assert_eq!(open.get(&format!("/api/state?token={token}")).0, 200);
    assert_eq!(open.post("/api/stop", &json!({})), 403);
    assert_eq!(
        open.post(&format!("/api/stop?token={token}"), &json!({})),
        504,
        "no calibrator confirms it"
    );
}
