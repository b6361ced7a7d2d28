//! The command layer: one answer to every whole frame, and no change that no
//! whole frame of the session's holder asks for.

use super::frames::{Whole, framed, whole_frames};
use calib_core::point::PointResult;
use calib_core::self_test::{Line, MAX_LINES};
use calib_core::settings::Settings;
use calib_firmware::capture::Capture;
use calib_firmware::command::{Instrument, RecordPage, RecordPart};
use calib_firmware::link::{Aftermath, Link};
use calib_firmware::scpi::Console;
use calib_firmware::session::{LinkName, Session};
use calib_protocol::capture::CapturePart;
use calib_protocol::frame::{Frame, PROTOCOL_VERSION};
use calib_protocol::health::Health;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Info, Refusal, Request, Response, RunSpec, SettingsChange, Status};
use calib_protocol::signature::DeviceKey;
use calib_protocol::update::{RunningImage, UpdateStep};
use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

/// Numbers of the requests that change something (docs/protocol.md).
const START: u32 = 3;
const STOP: u32 = 4;
const STOP_RUN: u32 = 15;
const RESET: u32 = 9;
const RELEASE: u32 = 10;
const CAPTURE: u32 = 11;
const UPDATE: u32 = 19;

/// Feeds `data` to a link whose host holds the session, and to one whose host
/// does not.
pub fn commands(data: &[u8]) {
    let (lines, binary) = lines_and_frames(data);
    let asked = whole_frames(&binary);
    for holder in [LinkName::Serial, LinkName::Usb] {
        let mut instrument = Notes::held_by(holder);
        let before = instrument.settings.clone();
        let answered = instrument.hear(data);
        let sequences: Vec<u16> = asked.iter().map(|whole| whole.sequence).collect();
        assert_eq!(answered, sequences, "one answer each");
        let changes = instrument.changes;
        let stopping = count(&asked, STOP)
            + count(&asked, STOP_RUN)
            + words(&lines, b"ABOR")
            + words(&lines, b"*RST");
        assert!(instrument.stops <= stopping, "a stop nobody asked for");
        if holder == LinkName::Serial {
            let asked_for = |number| count(&asked, number);
            let by_lines = ["INIT", "READ", "MEAS"].map(|word| words(&lines, word.as_bytes()));
            assert!(changes.starts <= asked_for(START) + by_lines.iter().sum::<usize>());
            assert_eq!(
                (changes.writes, changes.keys, changes.lists),
                (0, 0, 0),
                "nobody holds the button"
            );
            assert!(changes.resets <= asked_for(RESET));
            assert!(changes.releases <= asked_for(RELEASE));
            assert!(changes.captures <= asked_for(CAPTURE));
            assert!(changes.updates <= asked_for(UPDATE));
        } else {
            assert_eq!(
                changes,
                Changes::default(),
                "the other host holds the session"
            );
        }
        assert_eq!(instrument.settings, before);
        assert_eq!(instrument.settings.validate(), Ok(()));
        instrument.expect_info();
    }
}

/// Messages a link finds in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heard {
    /// Frames that were answered.
    pub answers: usize,
    /// Stops, by frames or by lines.
    pub stops: usize,
}

/// Answers of the firmware's own link and command layer to bytes from a host that does not hold the
/// session.
pub fn heard(data: &[u8]) -> Heard {
    let mut instrument = Notes::held_by(LinkName::Usb);
    let answers = instrument.hear(data).len();
    let stops = instrument.stops;
    Heard { answers, stops }
}

/// Parts what a host sent as docs/scpi.md does: after a frame or a line, text up
/// to a line feed is a line, and everything else is for frames.
fn lines_and_frames(data: &[u8]) -> (Vec<&[u8]>, Vec<u8>) {
    let (mut lines, mut binary) = (Vec::new(), Vec::new());
    let mut rest = data;
    while let Some(first) = rest.first() {
        let is_text = matches!(first, b' '..=b'~' | b'\t' | b'\r' | b'\n');
        let end = rest.iter().position(|byte| b"\0\n".contains(byte));
        if let (true, Some(at)) = (is_text, end)
            && rest[at] == b'\n'
        {
            lines.push(&rest[..=at]);
            rest = &rest[at + 1..];
            continue;
        }
        let mut taken = past_frame(rest);
        if is_text && whole_frames(&rest[..taken]).is_empty() {
            // No line and no frame: its zero begins the next frame.
            taken += past_frame(&rest[taken..]);
        }
        binary.extend_from_slice(&rest[..taken]);
        rest = &rest[taken..];
    }
    (lines, binary)
}

/// How many bytes up to and with the first zero after the leading ones.
fn past_frame(data: &[u8]) -> usize {
    let ends = |pair: &[u8]| pair[0] != 0 && pair[1] == 0;
    let end = data.windows(2).position(ends);
    end.map_or(data.len(), |at| at + 2)
}

/// How often lines hold `word`, in letters of any case.
fn words(lines: &[&[u8]], word: &[u8]) -> usize {
    let parts = lines.iter().flat_map(|line| line.windows(word.len()));
    parts.filter(|part| part.eq_ignore_ascii_case(word)).count()
}

fn count(asked: &[Whole], number: u32) -> usize {
    let first = |whole: &&Whole| number_of(&whole.message) == Some(number);
    asked.iter().filter(first).count()
}

/// The number a message begins with: seven bits a byte, lowest first. A number written longer than
/// it need be is read as well.
fn number_of(message: &[u8]) -> Option<u32> {
    let last = message.iter().take(5).position(|byte| *byte < 0x80)?;
    let bytes = message.iter().take(last + 1).rev();
    Some(bytes.fold(0, |number, byte| (number << 7) | u32::from(byte & 0x7F)))
}

/// How often something was changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Changes {
    starts: usize,
    writes: usize,
    keys: usize,
    resets: usize,
    releases: usize,
    captures: usize,
    updates: usize,
    lists: usize,
}

/// An instrument that does nothing and notes everything.
struct Notes {
    link: Link,
    console: Console,
    session: Session,
    settings: Settings,
    hand_on_button: bool,
    changes: Changes,
    /// Anyone may stop: this is no change that only the holder may ask for.
    stops: usize,
    capture: Box<Capture>,
}

impl Notes {
    /// An instrument on its serial line, the session held by `holder`.
    fn held_by(holder: LinkName) -> Self {
        let mut session = Session::free();
        // A free session is granted.
        let _ = session.admit(holder, &Request::Reset, 0);
        Self {
            link: Link::new(),
            console: Console::new(),
            session,
            settings: Settings::field_calibrator(),
            hand_on_button: false,
            changes: Changes::default(),
            stops: 0,
            capture: Box::default(),
        }
    }

    /// Takes bytes, then a zero; the sequence numbers of the answers.
    fn hear(&mut self, data: &[u8]) -> Vec<u16> {
        let mut link = std::mem::take(&mut self.link);
        let mut console = std::mem::take(&mut self.console);
        let mut answered = Vec::new();
        for byte in data.iter().chain(&[0]) {
            let Some((answer, aftermath)) = now(link.push(*byte, &mut console, self)) else {
                continue;
            };
            if answer.ends_with(b"\n") {
                // The answer to a line; a frame ends with a zero.
                continue;
            }
            let mut raw = answer[..answer.len() - 1].to_vec();
            let frame = Frame::check(&mut raw).expect("answers are whole");
            let response = frame.message::<Response>().expect("answers are readable");
            assert!(
                aftermath == Aftermath::None || response == Response::Done,
                "{response:?}"
            );
            self.changes.resets += usize::from(aftermath == Aftermath::Reset);
            answered.push(frame.sequence);
        }
        self.link = link;
        self.console = console;
        answered
    }

    /// After all that, a request is answered.
    fn expect_info(&mut self) {
        let request = Whole {
            sequence: 0xABCD,
            message: vec![0],
        };
        assert_eq!(self.hear(&framed(&request)), [0xABCD]);
    }
}

/// Identity of a pretended calibrator.
pub fn info() -> Info {
    Info {
        protocol_version: PROTOCOL_VERSION,
        sample_rate_hz: 50_000.0,
        ..Info::default()
    }
}

/// The result of a future that never waits.
fn now<T>(future: impl Future<Output = T>) -> T {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(result) => result,
        Poll::Pending => panic!("nothing here waits"),
    }
}

impl Instrument for Notes {
    fn admit(&mut self, request: &Request) -> Result<(), Refusal> {
        self.session.admit(LinkName::Serial, request, 1)
    }

    fn info(&mut self) -> Info {
        info()
    }

    fn health(&mut self) -> Health {
        Health::default()
    }

    fn status(&mut self) -> Status {
        Status::IDLE
    }

    fn point(&mut self, _: u16) -> Option<PointResult> {
        None
    }

    async fn start(&mut self, spec: RunSpec) -> Result<u32, Refusal> {
        for point in &spec.points {
            assert!(point.frequency_hz > 0.0 && point.frequency_hz.is_finite());
            assert!(point.acceleration_rms_ms2 > 0.0 && point.acceleration_rms_ms2.is_finite());
        }
        assert!(!spec.points.is_empty());
        self.changes.starts += 1;
        Ok(1)
    }

    async fn stop(&mut self) -> Result<(), Refusal> {
        self.stops += 1;
        Ok(())
    }

    async fn stop_run(&mut self, _: u32) -> Result<(), Refusal> {
        self.stop().await
    }

    async fn records(&mut self, _: u32) -> Result<RecordPage, Refusal> {
        Ok(RecordPage::default())
    }

    async fn read_record(&mut self, _: u32, _: u32) -> Result<RecordPart, Refusal> {
        Err(Refusal::RecordNotFound)
    }

    async fn release(&mut self, _: u32) -> Result<(), Refusal> {
        self.changes.releases += 1;
        Ok(())
    }

    fn settings(&mut self) -> Settings {
        self.settings.clone()
    }

    async fn self_test(&mut self) -> Result<heapless::Vec<Line, MAX_LINES>, Refusal> {
        Ok(heapless::Vec::new())
    }

    fn button_held(&mut self) -> bool {
        self.hand_on_button
    }

    async fn key(&mut self) -> Result<Option<DeviceKey>, Refusal> {
        let public = [1; 32];
        let key = DeviceKey { public, since: 1 };
        Ok((self.changes.keys > 0).then_some(key))
    }

    async fn make_key(&mut self) -> Result<(), Refusal> {
        assert!(self.hand_on_button, "without a hand on the instrument");
        self.changes.keys += 1;
        Ok(())
    }

    async fn change_settings(&mut self, change: &SettingsChange) -> Result<(), Refusal> {
        assert!(self.hand_on_button, "without a hand on the instrument");
        self.changes.writes += 1;
        self.settings = change.settings.clone();
        Ok(())
    }

    fn image(&mut self) -> Option<RunningImage> {
        None
    }

    fn update(&mut self, _: &UpdateStep, older_allowed: bool) -> Result<(), Refusal> {
        assert!(self.hand_on_button || !older_allowed, "without a hand");
        self.changes.updates += 1;
        Ok(())
    }

    async fn list(&mut self, _: u8) -> Result<Option<KeptList>, Refusal> {
        Ok(None)
    }

    async fn change_lists(&mut self, change: &ListChange, held: bool) -> Result<(), Refusal> {
        assert!(change.is_usable());
        assert_eq!(held, self.hand_on_button);
        match held {
            true => self.changes.lists += 1,
            false => return Err(Refusal::ButtonNotHeld),
        }
        Ok(())
    }

    fn tell_time(&mut self, _: u64) {}

    fn capture(&mut self, pairs: u16) -> Result<(), Refusal> {
        self.capture.arm(pairs)?;
        self.capture.take(0, &[0x8000_8000; 500]);
        self.changes.captures += 1;
        Ok(())
    }

    fn read_capture(&mut self, offset: u16) -> Result<CapturePart, Refusal> {
        self.capture.part(offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hostile::seeds;
    use calib_protocol::frame::{MAX_FRAME, encode};

    /// Without this, a link that refuses everything would pass as well.
    #[test]
    fn the_seeds_make_each_change_once() {
        let seeds = seeds().into_iter();
        let all: Vec<u8> = seeds
            .filter(|seed| seed.target == "commands")
            // A zero first, as every host sends: it tells a frame from a line.
            .flat_map(|seed| [vec![0], seed.bytes].concat())
            .collect();
        let mut instrument = Notes::held_by(LinkName::Serial);
        instrument.hand_on_button = true;
        // The seed changes a setting.
        instrument.settings.blocks += 1;
        assert_eq!(instrument.hear(&all).len(), 22);
        let once = Changes {
            starts: 1,
            writes: 1,
            keys: 1,
            resets: 1,
            releases: 1,
            captures: 1,
            updates: 1,
            lists: 1,
        };
        assert_eq!(instrument.changes, once);
    }

    #[test]
    fn settings_change_under_a_hand_alone_and_once_for_a_repeated_frame() {
        let mut settings = Settings::field_calibrator();
        settings.limits.acceleration_peak_ms2 *= 2.0;
        let mut instrument = Notes::held_by(LinkName::Serial);
        let mut buffer = vec![0; MAX_FRAME];
        let request = Request::SettingsWrite(settings.clone().into());
        let length = encode(7, &request, &mut buffer).expect("fits");
        let frame = [&[0], &buffer[..length]].concat();
        instrument.hear(&frame);
        assert_eq!(instrument.changes, Changes::default());
        assert_eq!(instrument.settings, Settings::field_calibrator());
        instrument.hand_on_button = true;
        instrument.hear(&frame);
        assert_eq!(instrument.changes.writes, 1);
        assert_eq!(instrument.settings, settings);
        // The answer got lost, and the hand has gone: the same settings are there.
        instrument.hand_on_button = false;
        instrument.hear(&frame);
        assert_eq!(instrument.changes.writes, 1);
    }
}
