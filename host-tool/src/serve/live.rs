//! The one channel of each page: a WebSocket, which counts among no browser's six connections to a host.
//!
//! Each message to a page is the whole view, so that a page which was asleep, or opened late, or lost its
//! connection, is right with the next one. It comes at least every [`HEARTBEAT`]: a page that hears nothing
//! knows that it is cut off. From a page come stops alone.

use super::handle::Handle;
use super::stops::{Asked, NotStopped};
use axum::extract::ws::{Message, WebSocket};
use calib_output::json;
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};
use tokio::sync::mpsc::{UnboundedSender, unbounded_channel};

/// Least time between two views: what an eye follows, and no load for a tablet.
const PAUSE: Duration = Duration::from_millis(100);
/// Most time between two.
const HEARTBEAT: Duration = Duration::from_secs(1);
/// A page that takes nothing for so long is gone.
const PATIENCE: Duration = Duration::from_secs(5);
/// Longest message of a page.
pub(super) const LONGEST: usize = 256;

/// Message that a page sends.
#[derive(Deserialize)]
struct Stop {
    #[serde(flatten)]
    asked: Asked,
    /// Comes back with the answer.
    id: u32,
}

/// Message that a page is sent.
#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Said<'a, T> {
    View(&'a T),
    /// A stop was confirmed, or why it was not.
    StopAnswer {
        id: u32,
        why: Option<String>,
    },
}

/// Talks to one page until it goes.
pub(super) async fn talk(mut page: WebSocket, handle: Handle) {
    let mut changes = handle.shared.changes();
    // The first view says how things are.
    changes.mark_changed();
    let (answers, mut answered) = unbounded_channel();
    let mut beat = tokio::time::interval(PAUSE);
    let mut told = Instant::now();
    loop {
        let text = tokio::select! {
            heard = page.recv() => match heard {
                Some(Ok(Message::Text(text))) => {
                    heed(&handle, &text, &answers);
                    continue;
                }
                Some(Ok(Message::Binary(_) | Message::Ping(_) | Message::Pong(_))) => continue,
                Some(Ok(Message::Close(_)) | Err(_)) | None => return,
            },
            Some((id, why)) = answered.recv() => {
                json::line(&Said::<()>::StopAnswer { id, why })
            }
            _ = beat.tick() => {
                let is_same = matches!(changes.has_changed(), Ok(false));
                if is_same && told.elapsed() < HEARTBEAT {
                    continue;
                }
                changes.mark_unchanged();
                told = Instant::now();
                json::line(&Said::View(&handle.shared.snapshot()))
            }
        };
        let Ok(text) = text else { return };
        let sent = tokio::time::timeout(PATIENCE, page.send(Message::text(text))).await;
        if !matches!(sent, Ok(Ok(()))) {
            return;
        }
    }
}

/// Stops, and answers in its time; what is none of ours is passed over.
fn heed(handle: &Handle, text: &str, answers: &UnboundedSender<(u32, Option<String>)>) {
    let Ok(Stop { asked, id }) = serde_json::from_str(text) else {
        return;
    };
    let (handle, answers) = (handle.clone(), answers.clone());
    tokio::spawn(async move {
        let stopped = handle.stop(asked).await;
        // The page may have gone.
        let _ = answers.send((id, stopped.err().map(NotStopped::text)));
    });
}
