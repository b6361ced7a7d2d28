//! Which host may change something: one link holds the session.
//!
//! | request | from the holder | from the other link |
//! |---|---|---|
//! | reading (`Info`, `Status`, `Point`, `Records`, `ReadRecord`, `SettingsRead`, `ReadCapture`, `Health`, `Key`, `Image`) | answered | answered |
//! | `Stop`, `StopRun` | carried out | carried out: anyone may silence the exciter |
//! | changing (`Start`, `SettingsWrite`, `Reset`, `Release`, `Capture`, `SelfTest`, `MakeKey`, `Update`) | carried out | refused |
//!
//! The first link that asks for a change takes the session. It keeps it while
//! it goes on asking for anything, and loses it after [`PATIENCE_MS`] of quiet
//! or when its host goes.

use calib_protocol::message::{Refusal, Request};

/// Quiet after which a session is free, milliseconds: twenty times the longest
/// pause a host makes between two questions about a run.
pub const PATIENCE_MS: u64 = 5_000;

/// A way to the calibrator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkName {
    /// USART3 at the ST-LINK.
    Serial,
    /// The USB connector of the part itself.
    Usb,
}

/// Who holds the session, and when it was last heard, ms since the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Session(Option<(LinkName, u64)>);

impl Session {
    /// A session nobody holds.
    pub const fn free() -> Self {
        Self(None)
    }

    /// Whether `link` may ask for this, `now_ms` since the start.
    ///
    /// # Errors
    /// [`Refusal::OtherHost`]: another link holds the session.
    pub fn admit(&mut self, link: LinkName, request: &Request, now_ms: u64) -> Result<(), Refusal> {
        let holder = self.holder(now_ms);
        let own = holder == Some(link);
        match changes(request) {
            true if holder.is_some() && !own => return Err(Refusal::OtherHost),
            changes if changes || own => self.0 = Some((link, now_ms)),
            _ => {}
        }
        Ok(())
    }

    /// The host of `link` has gone.
    pub fn leave(&mut self, link: LinkName) {
        self.0 = self.0.filter(|(holder, _)| *holder != link);
    }

    fn holder(&self, now_ms: u64) -> Option<LinkName> {
        let (link, heard_ms) = self.0?;
        (now_ms.saturating_sub(heard_ms) < PATIENCE_MS).then_some(link)
    }
}

/// Whether a request changes what the instrument does or keeps. Stopping does
/// too, and is everybody's right.
fn changes(request: &Request) -> bool {
    match request {
        Request::Start(_)
        | Request::SettingsWrite(_)
        | Request::Reset
        | Request::Release { .. }
        | Request::Capture { .. }
        | Request::SelfTest
        | Request::MakeKey
        | Request::Update(_)
        | Request::ChangeLists(_) => true,
        Request::Info
        | Request::Status
        | Request::Point { .. }
        | Request::Stop
        | Request::StopRun { .. }
        | Request::Records { .. }
        | Request::ReadRecord { .. }
        | Request::SettingsRead
        | Request::ReadCapture { .. }
        | Request::Health
        | Request::Key
        | Request::Image
        | Request::List { .. }
        | Request::Clock { .. } => false,
    }
}

#[cfg(test)]
mod tests {
    use super::LinkName::{Serial, Usb};
    use super::*;

    const CHANGE: Request = Request::Release { through: 1 };

    #[test]
    fn the_first_to_change_something_holds_the_session() {
        let mut session = Session::free();
        // Reading takes nothing.
        assert_eq!(session.admit(Usb, &Request::Info, 0), Ok(()));
        assert_eq!(session.admit(Serial, &CHANGE, 1), Ok(()));
        assert_eq!(session.admit(Usb, &CHANGE, 2), Err(Refusal::OtherHost));
        assert_eq!(session.admit(Serial, &CHANGE, 3), Ok(()));
    }

    #[test]
    fn anyone_may_read_and_stop() {
        let mut session = Session::free();
        assert_eq!(session.admit(Serial, &CHANGE, 0), Ok(()));
        let id = 1;
        for request in [
            Request::Info,
            Request::Status,
            Request::Point { index: 0 },
            Request::Records { from: 0 },
            Request::ReadRecord { id, offset: 0 },
            Request::SettingsRead,
            Request::ReadCapture { offset: 0 },
            Request::Health,
            Request::Image,
            Request::List { place: 0 },
            Request::Clock { unix_time_s: 1 },
            Request::Stop,
            Request::StopRun { record_id: 7 },
        ] {
            assert_eq!(session.admit(Usb, &request, 1), Ok(()), "{request:?}");
        }
    }

    #[test]
    fn any_word_of_the_holder_keeps_the_session_and_quiet_frees_it() {
        let mut session = Session::free();
        assert_eq!(session.admit(Serial, &CHANGE, 0), Ok(()));
        assert_eq!(session.admit(Serial, &Request::Status, 4_000), Ok(()));
        // The other's questions do not count as the holder's.
        assert_eq!(session.admit(Usb, &Request::Status, 8_000), Ok(()));
        let last = 4_000 + PATIENCE_MS - 1;
        assert_eq!(session.admit(Usb, &CHANGE, last), Err(Refusal::OtherHost));
        assert_eq!(session.admit(Usb, &CHANGE, last + 1), Ok(()));
        assert_eq!(
            session.admit(Serial, &CHANGE, last + 2),
            Err(Refusal::OtherHost)
        );
    }

    #[test]
    fn a_host_that_goes_frees_its_own_session_alone() {
        let mut session = Session::free();
        assert_eq!(session.admit(Usb, &CHANGE, 0), Ok(()));
        session.leave(Serial);
        assert_eq!(session.admit(Serial, &CHANGE, 1), Err(Refusal::OtherHost));
        session.leave(Usb);
        assert_eq!(session.admit(Serial, &CHANGE, 2), Ok(()));
    }
}
