//! Serving a host over any byte stream.
//!
//! The stream is read until it holds a frame. A damaged frame is dropped: the
//! host asks again. A whole frame is answered with its own sequence number,
//! also when its message means nothing to this version.
//!
//! A host whose answer got lost sends its frame again. That is harmless for
//! every request but a start: the start last accepted is recognised by its
//! frame and answered again, not carried out again.
//!
//! Lines of text ([`crate::scpi`]) share the stream. The first byte tells: a host
//! of frames sends a zero before each, a line begins with a printable letter.
//!
//! | since the last end | next byte | then |
//! |---|---|---|
//! | nothing | printable, white space | a line, up to LF |
//! | nothing | zero, any other | a frame, up to a zero |
//! | a line | LF | the line is carried out |
//! | a line | zero | it was a frame whose zero got lost, or noise: its checksum decides |

use crate::command::{self, Instrument};
use crate::scpi::Console;
use calib_protocol::frame::{self, Frame, FrameError, MAX_FRAME, Receiver};
use calib_protocol::message::{Refusal, Request, Response};

/// Action a frame asked for beside its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aftermath {
    /// Nothing.
    None,
    /// The board is to be reset once the answer is on its way.
    Reset,
}

/// Bytes received since the last end of a frame or line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
enum Begun {
    Nothing = 0,
    /// Only zeros.
    Zeros = 1,
    Frame = 2,
    Line = 3,
}

/// Unit of input a byte completed.
enum End {
    Nothing,
    Frame,
    Line,
}

/// One link's memory: the frame being received and the one being sent.
pub struct Link {
    begun: Begun,
    receiver: Receiver,
    answer: [u8; MAX_FRAME],
    last_start: Start,
}

/// A start that was accepted: its frame, and the record it will have, which is
/// never number 0.
#[derive(Clone, Copy)]
struct Start {
    sequence: u16,
    checksum: u32,
    record_id: u32,
}

impl Start {
    /// None yet.
    const NONE: Self = Self {
        sequence: 0,
        checksum: 0,
        record_id: 0,
    };

    /// Whether a frame is the one of this start.
    fn is(&self, sequence: u16, checksum: u32) -> bool {
        self.record_id != 0 && (self.sequence, self.checksum) == (sequence, checksum)
    }
}

impl Default for Link {
    fn default() -> Self {
        Self::new()
    }
}

impl Link {
    /// A link on which nothing came yet: all zero, so that it may lie in
    /// memory that is cleared at the start.
    pub const fn new() -> Self {
        Self {
            begun: Begun::Nothing,
            receiver: Receiver::new(),
            answer: [0; MAX_FRAME],
            last_start: Start::NONE,
        }
    }

    /// Forgets a half-received frame or line, when bytes were lost or the host left.
    pub fn forget(&mut self, console: &mut Console) {
        self.receiver.clear();
        console.forget();
        self.begun = Begun::Nothing;
    }

    /// True in the middle of a frame or line: what does not go on soon never will.
    pub fn is_receiving(&self) -> bool {
        self.begun != Begun::Nothing
    }

    /// Takes one byte; at the end of a readable frame or line, carries it out and
    /// returns the bytes of the answer.
    pub async fn push(
        &mut self,
        byte: u8,
        console: &mut Console,
        instrument: &mut impl Instrument,
    ) -> Option<(&[u8], Aftermath)> {
        match self.take(byte, console) {
            End::Nothing => None,
            End::Frame => self.frame(instrument).await,
            End::Line => {
                let length = console.end(instrument, &mut self.answer).await?;
                Some((self.answer.get(..length)?, Aftermath::None))
            }
        }
    }

    /// The answer to a line that waited for the end of a run, or its beginning, once there is one.
    pub async fn poll(
        &mut self,
        console: &mut Console,
        instrument: &mut impl Instrument,
    ) -> Option<&[u8]> {
        let length = console.poll(instrument, &mut self.answer).await?;
        self.answer.get(..length)
    }

    /// Puts a byte where it belongs, and says what it ended.
    fn take(&mut self, byte: u8, console: &mut Console) -> End {
        if self.begun == Begun::Nothing {
            self.begun = match byte {
                b' '..=b'~' | b'\t' | b'\r' | b'\n' => Begun::Line,
                _ => Begun::Zeros,
            };
        }
        let whole = self.receiver.push(byte).is_some();
        match (self.begun, byte) {
            (Begun::Line, b'\n') => {
                self.receiver.clear();
                self.begun = Begun::Nothing;
                return End::Line;
            }
            (Begun::Line, 0) => {
                console.forget();
                // This zero may begin the next frame as well as end this one.
                self.begun = Begun::Zeros;
            }
            (Begun::Line, _) => console.push(byte),
            (Begun::Frame, 0) => self.begun = Begun::Nothing,
            (Begun::Zeros, 0) | (Begun::Nothing, _) => {}
            (Begun::Zeros | Begun::Frame, _) => self.begun = Begun::Frame,
        }
        match whole {
            true => End::Frame,
            false => End::Nothing,
        }
    }

    /// Carries out the frame that is whole in the receiver.
    async fn frame(&mut self, instrument: &mut impl Instrument) -> Option<(&[u8], Aftermath)> {
        let frame = Frame::check(self.receiver.whole()?).ok()?;
        // Its zero was its end and no beginning.
        self.begun = Begun::Nothing;
        let (sequence, checksum) = (frame.sequence, frame.checksum);
        let request = frame.message::<Request>();
        let resets = matches!(request, Ok(Request::Reset));
        let response = match request {
            Ok(_) if self.last_start.is(sequence, checksum) => Response::Started {
                record_id: self.last_start.record_id,
            },
            Ok(request) => command::answer(request, instrument).await,
            Err(_) => Response::Refused(Refusal::Unknown),
        };
        if let Response::Started { record_id } = response {
            self.last_start = Start {
                sequence,
                checksum,
                record_id,
            };
        }
        let aftermath = match response {
            Response::Done if resets => Aftermath::Reset,
            _ => Aftermath::None,
        };
        let length = encode(sequence, &response, &mut self.answer)?;
        Some((self.answer.get(..length)?, aftermath))
    }
}

/// Encodes an answer, or in its place a refusal if it were too long.
fn encode(sequence: u16, response: &Response, buffer: &mut [u8]) -> Option<usize> {
    match frame::encode(sequence, response, buffer) {
        Err(FrameError::TooLong) => {
            frame::encode(sequence, &Response::Refused(Refusal::Unknown), buffer).ok()
        }
        written => written.ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{RecordPage, RecordPart};
    use calib_core::point::{ExcitationKind, PointResult, PointSpec};
    use calib_core::self_test::{Line, MAX_LINES};
    use calib_core::settings::Settings;
    use calib_protocol::capture::CapturePart;
    use calib_protocol::health::Health;
    use calib_protocol::lists::{KeptList, ListChange};
    use calib_protocol::message::{Info, RunSpec, SettingsChange, Status};
    use calib_protocol::record::RunLabels;
    use calib_protocol::signature::DeviceKey;
    use calib_protocol::update::{RunningImage, UpdateStep};
    use core::future::Future;
    use core::pin::pin;
    use core::task::{Context, Poll, Waker};

    /// Accepts one start and is busy from then on.
    #[derive(Default)]
    struct Busy {
        starts: u32,
    }

    impl Instrument for Busy {
        fn admit(&mut self, request: &Request) -> Result<(), Refusal> {
            match request {
                Request::Reset if self.starts > 0 => Err(Refusal::OtherHost),
                _ => Ok(()),
            }
        }
        fn info(&mut self) -> Info {
            Info {
                protocol_version: frame::PROTOCOL_VERSION,
                sample_rate_hz: 50_000.0,
                ..Info::default()
            }
        }
        fn health(&mut self) -> Health {
            unreachable!("not asked here")
        }
        fn status(&mut self) -> Status {
            unreachable!("not asked here")
        }
        fn point(&mut self, _: u16) -> Option<PointResult> {
            None
        }
        async fn start(&mut self, _: RunSpec) -> Result<u32, Refusal> {
            self.starts += 1;
            match self.starts {
                1 => Ok(41),
                _ => Err(Refusal::Busy),
            }
        }
        async fn stop(&mut self) -> Result<(), Refusal> {
            Ok(())
        }
        async fn stop_run(&mut self, _: u32) -> Result<(), Refusal> {
            Ok(())
        }
        async fn records(&mut self, _: u32) -> Result<RecordPage, Refusal> {
            Ok(RecordPage::default())
        }
        async fn read_record(&mut self, _: u32, _: u32) -> Result<RecordPart, Refusal> {
            Err(Refusal::RecordNotFound)
        }
        async fn release(&mut self, _: u32) -> Result<(), Refusal> {
            Ok(())
        }
        fn settings(&mut self) -> Settings {
            Settings::field_calibrator()
        }
        fn capture(&mut self, _: u16) -> Result<(), Refusal> {
            Ok(())
        }
        fn read_capture(&mut self, _: u16) -> Result<CapturePart, Refusal> {
            Err(Refusal::NotCaptured)
        }
        async fn self_test(&mut self) -> Result<heapless::Vec<Line, MAX_LINES>, Refusal> {
            Ok(heapless::Vec::new())
        }
        fn button_held(&mut self) -> bool {
            false
        }
        async fn key(&mut self) -> Result<Option<DeviceKey>, Refusal> {
            Ok(None)
        }
        async fn make_key(&mut self) -> Result<(), Refusal> {
            unreachable!("nobody holds the button")
        }
        async fn change_settings(&mut self, _: &SettingsChange) -> Result<(), Refusal> {
            unreachable!("nobody holds the button")
        }
        fn image(&mut self) -> Option<RunningImage> {
            None
        }
        fn update(&mut self, _: &UpdateStep, _: bool) -> Result<(), Refusal> {
            Err(Refusal::NoLoader)
        }
        async fn list(&mut self, _: u8) -> Result<Option<KeptList>, Refusal> {
            Ok(None)
        }
        async fn change_lists(&mut self, _: &ListChange, _: bool) -> Result<(), Refusal> {
            unreachable!("nobody holds the button")
        }
        fn tell_time(&mut self, _: u64) {}
    }

    fn start() -> Request {
        let point = PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        };
        Request::Start(RunSpec {
            points: [point].into_iter().collect(),
            excitation: ExcitationKind::SingleSine,
            labels: RunLabels::default(),
        })
    }

    /// Sends a request and returns the answer; nothing here ever waits.
    fn ask(link: &mut Link, busy: &mut Busy, sequence: u16, request: &Request) -> Response {
        exchange(link, busy, sequence, request).0
    }

    fn exchange(
        link: &mut Link,
        busy: &mut Busy,
        sequence: u16,
        request: &Request,
    ) -> (Response, Aftermath) {
        let (mut buffer, mut console) = (vec![0; MAX_FRAME], Console::new());
        let length = frame::encode(sequence, request, &mut buffer).expect("fits");
        for byte in &buffer[..length] {
            let future = pin!(link.push(*byte, &mut console, busy));
            let polled = future.poll(&mut Context::from_waker(Waker::noop()));
            let Poll::Ready(answer) = polled else {
                panic!("nothing here waits");
            };
            if let Some((bytes, aftermath)) = answer {
                let mut bytes = bytes[..bytes.len() - 1].to_vec();
                let frame = Frame::check(&mut bytes).expect("whole");
                assert_eq!(frame.sequence, sequence);
                return (frame.message().expect("a response"), aftermath);
            }
        }
        panic!("a whole frame is answered");
    }

    #[test]
    fn a_repeated_start_is_answered_again_and_carried_out_once() {
        let (mut link, mut busy) = (Link::new(), Busy::default());
        let started = Response::Started { record_id: 41 };
        for _ in 0..3 {
            assert_eq!(ask(&mut link, &mut busy, 9, &start()), started);
        }
        assert_eq!(busy.starts, 1);
        // Another request in between changes nothing.
        ask(&mut link, &mut busy, 10, &Request::Stop);
        assert_eq!(ask(&mut link, &mut busy, 9, &start()), started);
        assert_eq!(busy.starts, 1);
    }

    #[test]
    fn only_a_reset_that_is_granted_resets() {
        let (mut link, mut busy) = (Link::new(), Busy::default());
        let granted = exchange(&mut link, &mut busy, 1, &Request::Reset);
        assert_eq!(granted, (Response::Done, Aftermath::Reset));
        ask(&mut link, &mut busy, 2, &start());
        let refused = exchange(&mut link, &mut busy, 3, &Request::Reset);
        let other = Response::Refused(Refusal::OtherHost);
        assert_eq!(refused, (other, Aftermath::None));
    }

    #[test]
    fn another_start_is_no_repetition() {
        let (mut link, mut busy) = (Link::new(), Busy::default());
        ask(&mut link, &mut busy, 9, &start());
        let refused = Response::Refused(Refusal::Busy);
        assert_eq!(ask(&mut link, &mut busy, 10, &start()), refused);
        assert_eq!(busy.starts, 2);
    }
}
