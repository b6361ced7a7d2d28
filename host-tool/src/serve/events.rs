//! The stream of changes (server-sent events).
//!
//! Each event is the whole view, so that a page which was asleep, or opened late,
//! or lost its connection, is right with the next one.

use super::view::Shared;
use axum::response::sse::{Event, KeepAlive, Sse};
use calib_output::json;
use futures_util::{Stream, stream};
use std::convert::Infallible;
use std::time::Duration;

/// Least time between two events: what an eye follows, and no load for a tablet.
const PAUSE: Duration = Duration::from_millis(100);

pub(super) fn stream(shared: Shared) -> Sse<impl Stream<Item = Result<Event, Infallible>>> {
    let mut changes = shared.changes();
    // The first event says how things are.
    changes.mark_changed();
    let events = stream::unfold((shared, changes), |(shared, mut changes)| async move {
        changes.changed().await.ok()?;
        tokio::time::sleep(PAUSE).await;
        changes.mark_unchanged();
        let view = json::line(&shared.snapshot()).ok()?;
        Some((
            Ok(Event::default().data(view.trim_end())),
            (shared, changes),
        ))
    });
    Sse::new(events).keep_alive(KeepAlive::default())
}
