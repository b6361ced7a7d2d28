//! How many connections there are, and for how long: one that asks for nothing makes room for one that may.
//!
//! | limit | value | against |
//! |---|---|---|
//! | connections at a time | [`MOST`] | files running out; the oldest that is asking for nothing makes room, whatever it was answered before |
//! | time to ask for something, and to ask again | [`PATIENCE`] | connections that only wait |
//! | time to send what was announced, until when nothing was asked for | [`PATIENCE`], [`LONGEST`] | requests that never end |
//! | threads for files and documents | [`WORKERS`] | a locked logbook |

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::http::{Request, StatusCode};
use axum::response::IntoResponse;
use hyper::body::Incoming;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::collections::VecDeque;
use std::io;
use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::task::{JoinHandle, yield_now};

/// Connections held at a time: pages of a whole laboratory, and far below what a process may open.
const MOST: usize = 128;
/// Time a connection has for the head of a request.
const PATIENCE: Duration = Duration::from_secs(5);
/// Bytes of a request's body, far above what a page sends.
const LONGEST: usize = 64 * 1024;
/// Threads that may wait for a disk.
const WORKERS: usize = 8;
/// Pause after the system refused a connection: there are too many open files.
const REFUSED: Duration = Duration::from_millis(10);

/// A connection that is held.
struct Held {
    /// A request of it is being answered, or it is the channel of a page.
    is_used: Arc<AtomicBool>,
    task: JoinHandle<()>,
}

/// Answers requests by `app` on a thread of its own, until `end`.
pub(super) fn serve(
    listener: TcpListener,
    app: Router,
    end: impl Future<Output = ()>,
) -> io::Result<()> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .max_blocking_threads(WORKERS)
        .build()?;
    let served = runtime.block_on(async {
        let listener = tokio::net::TcpListener::from_std(listener)?;
        tokio::select! {
            never = accept(listener, app) => never,
            () = end => Ok(()),
        }
    });
    // A document that is being made is waited for by nobody.
    runtime.shutdown_background();
    served
}

async fn accept(listener: tokio::net::TcpListener, app: Router) -> io::Result<()> {
    let mut held = VecDeque::new();
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            make_room(&mut held);
            tokio::time::sleep(REFUSED).await;
            continue;
        };
        held.retain(|held: &Held| !held.task.is_finished());
        if held.len() >= MOST && !make_room(&mut held) {
            continue;
        }
        let is_used = Arc::new(AtomicBool::new(false));
        let task = tokio::spawn(answer(stream, app.clone(), Arc::clone(&is_used)));
        held.push_back(Held { is_used, task });
        // In a flood of connections those that are there have their turn too.
        yield_now().await;
    }
}

/// Ends the oldest connection that asks for nothing; false when all do.
fn make_room(held: &mut VecDeque<Held>) -> bool {
    let idle = |held: &Held| !held.is_used.load(Ordering::Relaxed);
    let Some(oldest) = held.iter().position(idle) else {
        return false;
    };
    if let Some(oldest) = held.remove(oldest) {
        oldest.task.abort();
    }
    true
}

/// A request with all of its body: who announces one and does not send it asks for nothing.
async fn whole(request: Request<Incoming>) -> Result<Request<Body>, StatusCode> {
    let (head, body) = request.into_parts();
    match tokio::time::timeout(PATIENCE, to_bytes(Body::new(body), LONGEST)).await {
        Ok(Ok(body)) => Ok(Request::from_parts(head, Body::from(body))),
        Ok(Err(_)) => Err(StatusCode::PAYLOAD_TOO_LARGE),
        Err(_) => Err(StatusCode::REQUEST_TIMEOUT),
    }
}

async fn answer(stream: TcpStream, app: Router, is_used: Arc<AtomicBool>) {
    // An answer is small: waiting for more would only delay it.
    let _ = stream.set_nodelay(true);
    let service = service_fn(|request: Request<Incoming>| {
        let (app, is_used) = (app.clone(), Arc::clone(&is_used));
        async move {
            let request = match whole(request).await {
                Ok(request) => request,
                Err(refused) => return Ok(refused.into_response()),
            };
            is_used.store(true, Ordering::Relaxed);
            let answer = TowerToHyperService::new(app).call(request).await;
            let Ok(answer) = answer;
            let is_channel = answer.status() == StatusCode::SWITCHING_PROTOCOLS;
            is_used.store(is_channel, Ordering::Relaxed);
            Ok::<_, std::convert::Infallible>(answer)
        }
    });
    let connection = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(PATIENCE)
        .serve_connection(TokioIo::new(stream), service);
    // A host that goes, or asks nothing, is nobody's failure.
    let _ = connection.with_upgrades().await;
}
