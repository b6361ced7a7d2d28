//! One link's lines of text: collected, carried out, answered.

use super::session::{Answer, Session, is_running};
use crate::command::Instrument;

/// Longest line, in bytes.
const MAX_LINE: usize = 256;

/// The line being received, and what its sender has configured.
pub struct Console {
    line: heapless::String<MAX_LINE>,
    overlong: bool,
    session: Session,
    awaits_end: bool,
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
            awaits_end: false,
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
        match self.session.line(&line, instrument, &mut out).await {
            Answer::None => None,
            Answer::Now => Some(out.length),
            Answer::OnceComplete => {
                self.awaits_end = true;
                None
            }
        }
    }

    /// True while a `*OPC?` waits for the end of a run: call [`Self::poll`] now and then.
    pub fn awaits_end(&self) -> bool {
        self.awaits_end
    }

    /// The answer to a waiting `*OPC?`, once the run is over.
    pub fn poll(&mut self, instrument: &mut impl Instrument) -> Option<&'static [u8]> {
        let over = self.awaits_end && !is_running(instrument);
        self.awaits_end &= !over;
        over.then_some(b"1\n")
    }
}

/// Text into a buffer; what has no room is refused and leaves one byte for LF.
struct Text<'a> {
    buffer: &'a mut [u8],
    length: usize,
}

impl core::fmt::Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        let end = self.length + text.len();
        let room = self.buffer.len() - usize::from(text != "\n");
        let place = self.buffer.get_mut(self.length..end);
        let place = place.filter(|_| end <= room).ok_or(core::fmt::Error)?;
        place.copy_from_slice(text.as_bytes());
        self.length = end;
        Ok(())
    }
}
