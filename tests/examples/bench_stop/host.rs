//! The server of the page, and what is put in the way of a stop.

use calib_tests::rigged::Fault;
use calib_tests::served::Served;
use serde_json::Value;
use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Pause before what was closed is opened again.
const AGAIN: Duration = Duration::from_secs(1);
/// Longest wait for an answer.
const PATIENCE: Duration = Duration::from_secs(30);

/// The server under attack.
pub(crate) struct Host {
    _served: Served,
    /// Where its page is, and where its stops.
    pub(crate) page: String,
    pub(crate) stops: String,
}

impl Host {
    pub(crate) fn start(folder: &Path, device: &str) -> Result<Self, Fault> {
        let served = Served::start(folder, &["--device", device])?;
        let page = served.url.trim_start_matches("http://").to_owned();
        let page = page.split('/').next().ok_or("no host")?.to_owned();
        let mut host = Self {
            _served: served,
            page,
            stops: String::new(),
        };
        let port = host.state()?["stop_port"].as_u64().ok_or("no port")?;
        host.stops = format!("127.0.0.1:{port}");
        Ok(host)
    }

    pub(crate) fn state(&self) -> Result<Value, Fault> {
        Ok(serde_json::from_str(
            &self.ask(&self.page, "GET /api/state", "")?.1,
        )?)
    }

    /// Status and body of a request over a connection of its own.
    pub(crate) fn ask(&self, host: &str, line: &str, body: &str) -> Result<(u16, String), Fault> {
        let mut stream = TcpStream::connect(host)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        let length = body.len();
        let request = format!(
            "{line} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\nContent-Type: application/json\r\n\
             Content-Length: {length}\r\n\r\n{body}"
        );
        stream.write_all(request.as_bytes())?;
        let mut answer = String::new();
        stream.read_to_string(&mut answer)?;
        let status = answer.split(' ').nth(1).ok_or("no status")?.parse()?;
        let body = answer.split_once("\r\n\r\n").map_or("", |(_, body)| body);
        Ok((status, body.to_owned()))
    }

    /// A page that was opened, and whose browser reads nothing any more.
    fn sleeping_page(&self) -> Result<TcpStream, Fault> {
        let mut stream = TcpStream::connect(&self.page)?;
        let host = &self.page;
        let request = format!(
            "GET /api/live HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nConnection: Upgrade\r\n\
             Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n\
             Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
        );
        stream.write_all(request.as_bytes())?;
        let mut answer = [0; 12];
        stream.read_exact(&mut answer)?;
        match &answer == b"HTTP/1.1 101" {
            true => Ok(stream),
            false => Err("the server opens no channel".into()),
        }
    }
}

/// Obstacles, in the way as long as this is kept.
#[derive(Default)]
pub(crate) struct Obstacles {
    connections: Vec<TcpStream>,
    logbook: Option<rusqlite::Connection>,
    work: Work,
}

impl Obstacles {
    pub(crate) fn pages(&mut self, host: &Host, count: usize) -> Result<(), Fault> {
        for _ in 0..count {
            self.connections.push(host.sleeping_page()?);
        }
        Ok(())
    }

    /// Half of them on each port; what the server closes is opened again a second later.
    pub(crate) fn idle(&mut self, host: &Host, count: usize) -> Result<(), Fault> {
        let mut idle = Vec::new();
        for number in 0..count {
            let to = [&host.page, &host.stops][number % 2].clone();
            idle.push((TcpStream::connect(&to)?, to));
        }
        self.work.begin(move |ended| {
            while !ended.load(Ordering::Relaxed) {
                std::thread::sleep(AGAIN);
                for (stream, to) in &mut idle {
                    if is_closed(stream)
                        && let Ok(new) = TcpStream::connect(&*to)
                    {
                        *stream = new;
                    }
                }
            }
        });
        Ok(())
    }

    pub(crate) fn lock(&mut self, logbook: &Path) -> Result<(), Fault> {
        let connection = rusqlite::Connection::open(logbook)?;
        connection.execute_batch("BEGIN EXCLUSIVE")?;
        self.logbook = Some(connection);
        Ok(())
    }

    /// Twice as many threads as there are cores, that never rest.
    pub(crate) fn load(&mut self) {
        let cores = std::thread::available_parallelism().map_or(2, usize::from);
        for _ in 0..2 * cores {
            self.work.begin(|ended| {
                while !ended.load(Ordering::Relaxed) {
                    std::hint::spin_loop();
                }
            });
        }
    }
}

/// Whether the server has closed it.
fn is_closed(stream: &TcpStream) -> bool {
    let looked = stream
        .set_nonblocking(true)
        .and_then(|()| stream.peek(&mut [0]));
    !matches!(looked, Err(error) if error.kind() == ErrorKind::WouldBlock)
}

/// Threads that go on until it is dropped.
#[derive(Default)]
struct Work(Arc<AtomicBool>);

impl Work {
    fn begin(&self, work: impl FnOnce(&AtomicBool) + Send + 'static) {
        let ended = Arc::clone(&self.0);
        std::thread::spawn(move || work(&ended));
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}
