//! One link's lines of text: collected, carried out, answered.

use super::session::{Answer, Session};
use super::{Answering, MAX_LINE};
use crate::command::Instrument;

/// The line being received, and what its sender has configured.
pub struct Console {
    line: heapless::String<MAX_LINE>,
    overlong: bool,
    session: Session,
}

impl Default for Console {
    fn default() -> Self {
        Self::new()
    }
}

impl Console {
    /// A console on which nothing came yet.
    pub const fn new() -> Self {
        Self {
            line: heapless::String::new(),
            overlong: false,
            session: Session::new(),
        }
    }

    /// Forgets a line begun.
    pub(crate) fn forget(&mut self) {
        self.line.clear();
        self.overlong = false;
    }

    /// Takes a byte of a line. Anything but ASCII makes the line unreadable.
    pub(crate) fn push(&mut self, byte: u8) {
        let letter = if byte.is_ascii() { byte } else { b'?' };
        self.overlong |= self.line.push(char::from(letter)).is_err();
    }

    /// Carries the line out and returns the length of the answer in `buffer`.
    pub(crate) async fn end(
        &mut self,
        instrument: &mut impl Instrument,
        buffer: &mut [u8],
    ) -> Option<usize> {
        let line = core::mem::take(&mut self.line);
        if core::mem::take(&mut self.overlong) {
            self.session.overrun();
            return None;
        }
        let mut out = Text { buffer, length: 0 };
        let answer = self.session.line(&line, instrument, &mut out).await;
        out.to_be_sent(answer)
    }

    /// True while a line waits for the end of a run: call [`Self::poll`] now and then.
    pub fn awaits_end(&self) -> bool {
        self.session.waits()
    }

    /// Goes on with a line that waits, once the run is over, and returns the length of the answer in `buffer`.
    pub(crate) async fn poll(
        &mut self,
        instrument: &mut impl Instrument,
        buffer: &mut [u8],
    ) -> Option<usize> {
        let mut out = Text { buffer, length: 0 };
        let answer = self.session.resume(instrument, &mut out).await;
        out.to_be_sent(answer)
    }
}

/// Text into a buffer; what has no room is refused and leaves one byte for LF.
struct Text<'a> {
    buffer: &'a mut [u8],
    length: usize,
}

impl Text<'_> {
    /// Bytes of an answer or of its beginning.
    fn to_be_sent(&self, answer: Answer) -> Option<usize> {
        (answer != Answer::None && self.length > 0).then_some(self.length)
    }
}

impl Text<'_> {
    /// Writes bytes up to a place in the buffer.
    fn write(&mut self, bytes: &[u8], room: usize) -> core::fmt::Result {
        let end = self.length + bytes.len();
        let place = self.buffer.get_mut(self.length..end);
        let place = place.filter(|_| end <= room).ok_or(core::fmt::Error)?;
        place.copy_from_slice(bytes);
        self.length = end;
        Ok(())
    }
}

impl core::fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        let room = self.buffer.len() - usize::from(text != "\n");
        self.write(text.as_bytes(), room)
    }
}

impl Answering for Text<'_> {
    fn write_bytes(&mut self, bytes: &[u8]) -> core::fmt::Result {
        self.write(bytes, self.buffer.len() - 1)
    }

    fn room(&self) -> usize {
        (self.buffer.len() - 1).saturating_sub(self.length)
    }
}
