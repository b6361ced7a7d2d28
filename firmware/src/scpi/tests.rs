//! Lines as a controller sends them, through the link.

use super::Console;
use crate::command::{Instrument, RecordPage, RecordPart};
use crate::link;
use calib_core::point::PointResult;
use calib_core::point_state::{PointState, Reason};
use calib_core::self_test::{Check, Line, MAX_LINES};
use calib_core::settings::Settings;
use calib_core::stored_list::{Band, Base, ListTerms, Rule, StoredList, StoredLists};
use calib_protocol::capture::CapturePart;
use calib_protocol::frame::{self, Frame, MAX_FRAME};
use calib_protocol::health::{Defect, Defects, Health};
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{
    Info, RECORD_CHUNK, Refusal, Request, Response, RunSpec, RunState, SettingsChange, Status,
};
use calib_protocol::record::{RecordKind, RecordSummary};
use calib_protocol::signature::DeviceKey;
use calib_protocol::update::{RunningImage, UpdateStep};
use core::pin::pin;
use core::task::{Context, Poll, Waker};

/// A link with its console.
struct Link {
    link: link::Link,
    console: Console,
}

impl Link {
    fn new() -> Self {
        Self {
            link: link::Link::new(),
            console: Console::new(),
        }
    }
    fn forget(&mut self) {
        self.link.forget(&mut self.console);
    }
}

/// Bytes of a record: every value there is, LF and zero among them.
fn stored(id: u32) -> Vec<u8> {
    let length = if id == 1 { 1500 } else { 9000 };
    (0..length)
        .map(|place: u32| (place * 7 + id) as u8)
        .collect()
}

/// Measures 0.01 V/(m/s2) at once; its run is over when a test says so.
#[derive(Default)]
struct Rigged {
    spec: Option<RunSpec>,
    running: bool,
    refused: Option<Reason>,
    records: u32,
    other_host: bool,
    defects: Defects,
    /// The drive is not heard on the chip.
    deaf: bool,
    key: Option<DeviceKey>,
    lists: StoredLists,
    hand_gone: bool,
}

impl Instrument for Rigged {
    fn admit(&mut self, request: &Request) -> Result<(), Refusal> {
        match request {
            Request::Start(_) if self.other_host => Err(Refusal::OtherHost),
            _ => Ok(()),
        }
    }
    fn info(&mut self) -> Info {
        Info {
            protocol_version: frame::PROTOCOL_VERSION,
            firmware_version: "1.2.3".try_into().expect("short"),
            git_hash: "0".try_into().expect("short"),
            serial: "A7".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            ..Info::default()
        }
    }
    fn health(&mut self) -> Health {
        Health {
            defects: self.defects,
            ..Health::default()
        }
    }
    fn status(&mut self) -> Status {
        Status {
            state: match self.running {
                true => RunState::Measuring,
                false => RunState::Finished,
            },
            points: 1,
            blocks: 5,
            ..Status::IDLE
        }
    }
    fn point(&mut self, index: u16) -> Option<PointResult> {
        let spec = *self.spec.as_ref()?.points.get(usize::from(index))?;
        let mut result = PointResult::refused(spec, None, Reason::Clipped);
        result.state = self.refused.map_or(PointState::Valid, PointState::Refused);
        result.sensitivity_v_per_ms2 = 0.01;
        result.expanded_uncertainty_rel = 0.008;
        result.phase_rad = core::f32::consts::FRAC_PI_2;
        Some(result)
    }
    async fn start(&mut self, spec: RunSpec) -> Result<u32, Refusal> {
        if !self.defects.is_none() {
            return Err(Refusal::Degraded(self.defects));
        }
        self.running = true;
        self.spec = Some(spec);
        Ok(1)
    }
    async fn stop(&mut self) -> Result<(), Refusal> {
        self.running = false;
        Ok(())
    }
    async fn stop_run(&mut self, _: u32) -> Result<(), Refusal> {
        unreachable!("no line asks for that")
    }
    async fn records(&mut self, from: u32) -> Result<RecordPage, Refusal> {
        let records = (from.max(1)..=self.records)
            .take(16)
            .map(|id| RecordSummary {
                id,
                bytes: 1000,
                unix_time_s: 0,
                dut_serial: heapless::String::new(),
                points: 1,
                refused: 0,
                sha256: [0; 32],
                kind: RecordKind::Calibration,
            });
        Ok(RecordPage {
            records: records.collect(),
            more: from.max(1) + 16 <= self.records,
        })
    }
    async fn read_record(&mut self, id: u32, offset: u32) -> Result<RecordPart, Refusal> {
        let record = stored(id);
        match record.get(offset as usize..) {
            Some(left) if (1..=self.records).contains(&id) => Ok(RecordPart {
                total: record.len() as u32,
                data: left.iter().copied().take(RECORD_CHUNK).collect(),
            }),
            Some(_) => Err(Refusal::RecordNotFound),
            None => Err(Refusal::OffsetOutOfRange),
        }
    }
    async fn release(&mut self, _: u32) -> Result<(), Refusal> {
        Ok(())
    }
    fn settings(&mut self) -> Settings {
        Settings::field_calibrator()
    }
    async fn self_test(&mut self) -> Result<heapless::Vec<Line, MAX_LINES>, Refusal> {
        if self.running {
            return Err(Refusal::Busy);
        }
        let line = |check, value| Line {
            check,
            value: Some(value),
            lower: None,
            upper: Some(1.0),
        };
        let drive = if self.deaf { 2.0 } else { 1.0 };
        let lines = [
            line(Check::Supply, 1.0),
            line(Check::DriveGain, drive),
            line(Check::LastStart, 2.0 * drive),
        ];
        Ok(lines
            .into_iter()
            .take(if self.deaf { 3 } else { 2 })
            .collect())
    }
    fn button_held(&mut self) -> bool {
        !self.hand_gone
    }
    async fn key(&mut self) -> Result<Option<DeviceKey>, Refusal> {
        Ok(self.key)
    }
    async fn make_key(&mut self) -> Result<(), Refusal> {
        unreachable!("no line asks for that")
    }
    async fn change_settings(&mut self, _: &SettingsChange) -> Result<(), Refusal> {
        unreachable!("no line asks for that")
    }
    fn image(&mut self) -> Option<RunningImage> {
        None
    }
    fn update(&mut self, _: &UpdateStep, _: bool) -> Result<(), Refusal> {
        unreachable!("no line asks for that")
    }
    async fn list(&mut self, place: u8) -> Result<Option<KeptList>, Refusal> {
        let list = self.lists.all().get(usize::from(place));
        Ok(list.map(|list| KeptList {
            list: list.clone(),
            chosen: self.lists.chosen() == Some(list),
        }))
    }
    async fn change_lists(&mut self, change: &ListChange, held: bool) -> Result<(), Refusal> {
        match held {
            true => change
                .carry_out(&mut self.lists)
                .map_err(|_| Refusal::ListUnknown),
            false => Err(Refusal::ButtonNotHeld),
        }
    }
    fn tell_time(&mut self, _: u64) {
        unreachable!("no line tells the time")
    }
    fn capture(&mut self, _: u16) -> Result<(), Refusal> {
        Ok(())
    }
    fn read_capture(&mut self, _: u16) -> Result<CapturePart, Refusal> {
        Err(Refusal::NotCaptured)
    }
}

/// Sends bytes and returns all that comes back; nothing here ever waits.
fn send(link: &mut Link, rigged: &mut Rigged, bytes: &[u8]) -> Vec<u8> {
    let mut heard = Vec::new();
    for byte in bytes {
        let future = pin!(link.link.push(*byte, &mut link.console, rigged));
        match future.poll(&mut Context::from_waker(Waker::noop())) {
            Poll::Ready(Some((answer, _))) => heard.extend_from_slice(answer),
            Poll::Ready(None) => {}
            Poll::Pending => panic!("nothing here waits"),
        }
    }
    heard
}

fn line(link: &mut Link, rigged: &mut Rigged, line: &str) -> String {
    let heard = send(link, rigged, format!("{line}\n").as_bytes());
    String::from_utf8(heard).expect("text")
}

/// Answer once the run is over, or before it.
fn waited(link: &mut Link, rigged: &mut Rigged) -> String {
    let future = pin!(link.link.poll(&mut link.console, rigged));
    match future.poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(answer) => {
            String::from_utf8(answer.unwrap_or_default().to_vec()).expect("text")
        }
        Poll::Pending => panic!("nothing here waits"),
    }
}

fn frame_of(request: &Request, sequence: u16) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    let length = frame::encode(sequence, request, &mut buffer).expect("fits");
    buffer.truncate(length);
    buffer
}

/// The answers among bytes that came back.
fn responses(heard: &[u8]) -> Vec<Response> {
    let frames = heard.split_inclusive(|byte| *byte == 0);
    let read = |bytes: &[u8]| {
        let mut bytes = bytes.strip_suffix(&[0]).expect("an end").to_vec();
        let frame = Frame::check(&mut bytes).expect("whole");
        frame.message().expect("a response")
    };
    frames.map(read).collect()
}

#[test]
fn a_point_is_measured_by_text_alone() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    let mut say = |rigged: &mut Rigged, text: &str| line(&mut link, rigged, text);
    let b = &mut rigged;
    assert_eq!(
        say(b, "*IDN?"),
        "calib,Field Vibration Calibrator,A7,1.2.3\n"
    );
    assert_eq!(say(b, "*RST;*CLS"), "");
    // The second header goes on where the first one was; the third is none.
    assert_eq!(say(b, "CONF:FREQ?;ACC?;PHAS?"), "1.6E2;1E1;\n");
    assert_eq!(say(b, "SYST:ERR?"), "-113,\"Undefined header\"\n");
    assert_eq!(say(b, "CONF:FREQ 0.25 kHz; CONF:ACC 50\r"), "");
    assert_eq!(say(b, "conf:freq?;conf:acceleration?"), "2.5E2;5E1\n");
    assert_eq!(say(b, "FETC:SENS?"), "9.91E37\n", "nothing measured yet");
    assert!(say(b, "SYST:ERR?").starts_with("-230,"));
    assert_eq!(say(b, "INIT"), "");
    let point = b.spec.as_ref().expect("a run").points[0];
    assert_eq!(
        (point.frequency_hz, point.acceleration_rms_ms2),
        (250.0, 50.0)
    );
    assert_eq!(
        say(b, "INIT;SYST:ERR?"),
        "-213,\"Init ignored;a run is going on\"\n"
    );
    b.running = false;
    assert_eq!(say(b, "*OPC?;FETC:SENS?;PHAS?"), "1;1E-2;9E1\n");
    // 0.8 % of 0.01.
    let both = say(b, "FETC:UNC?;:FETC:STAT?");
    let (uncertainty, state) = both.split_once(';').expect("two answers");
    let uncertainty: f32 = uncertainty.parse().expect("a number");
    // Three roundings of f32.
    assert!((uncertainty / 8e-5 - 1.0).abs() < 2e-7, "{uncertainty}");
    assert_eq!(state, "VALID\n");
    b.refused = Some(Reason::Clipped);
    assert_eq!(say(b, "FETC:STAT?;FETC:SENS?"), "REFUSED,Clipped;9.91E37\n");
    // PHAS? was a command error (32), the refused point one of the device (8), the
    // ignored start and the stale result of execution (16).
    assert_eq!(say(b, "*ESR?;*ESR?"), "56;0\n");
    b.other_host = true;
    assert!(say(b, "*CLS;INIT;SYST:ERR?").starts_with("-203,"));
    assert_eq!(say(b, "*TST?;SYST:VERS?"), "0;1999.0\n");
    assert_eq!(say(b, "CONF:ACC 10;FETC:SENS?"), "9.91E37\n", "stale now");
}

#[test]
fn the_self_test_answers_with_the_first_line_that_fails() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "*TST?"), "0\n");
    rigged.deaf = true;
    // docs/scpi.md: the gain of the drive is line 7.
    assert_eq!(line(&mut link, &mut rigged, "*TST?"), "7\n");
    rigged.running = true;
    let answer = line(&mut link, &mut rigged, "*TST?;SYST:ERR?");
    assert!(answer.starts_with("-1;-213,"), "{answer}");
}

#[test]
fn the_end_of_a_run_is_waited_for_and_stop_gets_through() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "INIT;*OPC?"), "");
    assert!(link.console.awaits_end());
    assert_eq!(waited(&mut link, &mut rigged), "");
    line(&mut link, &mut rigged, "ABOR");
    assert!(!rigged.running);
    assert_eq!(waited(&mut link, &mut rigged), "1\n");
    assert!(!link.console.awaits_end());
    assert_eq!(waited(&mut link, &mut rigged), "");
    // Without a question only the register knows.
    line(&mut link, &mut rigged, "*CLS;INIT;*OPC");
    assert_eq!(line(&mut link, &mut rigged, "*ESR?"), "0\n");
    rigged.running = false;
    assert_eq!(line(&mut link, &mut rigged, "*ESR?"), "1\n");
}

#[test]
fn what_follows_a_wait_is_answered_after_it() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    for (text, at_once, then) in [
        // Before, what followed a question that waited was lost.
        ("INIT;*OPC?;FETC:SENS?", "", "1;1E-2\n"),
        ("INIT;*WAI;FETC:PHAS?", "", "9E1\n"),
        ("READ:SENS?", "", "1E-2\n"),
        ("MEAS:PHAS? 0.25 kHz, 50", "", "9E1\n"),
        ("MEAS:STAT? ,10", "", "VALID\n"),
        (
            "SYST:VERS?;MEAS:SENS?;PHAS?;:CONF:FREQ?",
            "1999.0",
            ";1E-2;9E1;2.5E2\n",
        ),
        ("CONF:ACC 20;INIT;*WAI;:CONF:ACC?", "", "2E1\n"),
        ("INIT;*WAI", "", ""),
    ] {
        assert_eq!(line(&mut link, &mut rigged, text), at_once, "{text}");
        assert!(rigged.running, "{text}");
        assert_eq!(waited(&mut link, &mut rigged), "", "{text}");
        rigged.running = false;
        assert_eq!(waited(&mut link, &mut rigged), then, "{text}");
    }
    let spec = rigged.spec.clone().expect("a run");
    assert_eq!(spec.points[0].frequency_hz, 250.0);
    assert_eq!(line(&mut link, &mut rigged, "READ?"), "");
    rigged.running = false;
    let all = waited(&mut link, &mut rigged);
    let words: Vec<&str> = all.trim().split(',').collect();
    assert_eq!((words[0], words[1], words[3]), ("1E-2", "9E1", "VALID"));
    assert_eq!(line(&mut link, &mut rigged, "SYST:ERR:COUN?"), "0\n");
    // A line at a time waits.
    line(&mut link, &mut rigged, "READ:SENS?");
    line(&mut link, &mut rigged, "*OPC?");
    rigged.running = false;
    assert_eq!(waited(&mut link, &mut rigged), "1\n");
    assert!(line(&mut link, &mut rigged, "SYST:ERR?").starts_with("-410,"));
}

#[test]
fn a_measurement_that_cannot_begin_is_answered_at_once() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    for (text, code) in [
        ("MEAS:SENS? 30 kHz", "-222"),
        ("MEAS:SENS? 250,2000", "-222"),
        ("MEAS:SENS? 160,10,5", "-108"),
    ] {
        assert_eq!(line(&mut link, &mut rigged, text), "9.91E37\n", "{text}");
        assert!(rigged.spec.is_none(), "{text}");
        let errors = line(&mut link, &mut rigged, "SYST:ERR?;ERR?");
        assert!(errors.starts_with(&format!("{code},")), "{errors}");
        assert!(errors.contains("-230,"), "{errors}");
        assert_eq!(
            line(&mut link, &mut rigged, "CONF:FREQ?"),
            "1.6E2\n",
            "{text}"
        );
    }
    line(&mut link, &mut rigged, "INIT");
    let answer = line(&mut link, &mut rigged, "READ?;SYST:ERR?");
    assert!(
        answer.starts_with("9.91E37,9.91E37,9.91E37,NONE;-213,"),
        "{answer}"
    );
    rigged.running = false;
    rigged.other_host = true;
    let answer = line(&mut link, &mut rigged, "*CLS;READ:STAT?;SYST:ERR?");
    assert!(answer.starts_with("NONE;-203,"), "{answer}");
}

#[test]
fn the_status_byte_sums_up_what_its_masks_let_through() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    let mut say = |text: &str| line(&mut link, &mut rigged, text);
    assert_eq!(say("*STB?;*ESE?;*SRE?;*ESR?"), "0;0;0;128\n", "power on");
    // Bit 6 has no mask; what is no whole number is rounded.
    assert_eq!(say("*SRE 255;*SRE?;*ESE 3.6;*ESE?"), "191;4\n");
    assert_eq!(say("*SRE 32;*ESE 32;*STB?"), "0\n");
    // Unknown questions have an empty answer, so that nobody waits for one; the queue says why.
    assert_eq!(say("NO:SUCH?"), "\n");
    assert_eq!(say("*CLS;NO:SUCH?;SYST:VERS?;NOR:THIS?"), ";1999.0;\n");
    say("*CLS;NO:SUCH?");
    // Error waits (4), event (32), and the summary (64).
    assert_eq!(say("*STB?;SYST:ERR:COUN?"), "100;1\n");
    assert!(say("SYST:ERR?").starts_with("-113,"));
    assert_eq!(say("*STB?"), "96\n");
    assert_eq!(say("*ESR?;*STB?;SYST:ERR:COUN?"), "32;0;0\n");
    say("NO:SUCH?");
    assert_eq!(say("*CLS;*STB?;*ESE?;*SRE?"), "0;32;32\n", "masks stay");
}

#[test]
fn the_key_is_told_as_people_and_as_programs_compare_it() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "SYST:KEY?"), "\"\",\"\",0\n");
    let public = core::array::from_fn(|index| index as u8);
    rigged.key = Some(DeviceKey { public, since: 7 });
    let whole = "000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f";
    assert_eq!(
        line(&mut link, &mut rigged, "SYST:KEY?"),
        format!("\"0001 0203 0405 0607\",\"{whole}\",7\n")
    );
}

#[test]
fn numbers_that_are_none_are_refused_and_change_nothing() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    for (text, code) in [
        ("CONF:FREQ", "-109"),
        ("CONF:FREQ x", "-104"),
        ("CONF:FREQ 5 V", "-104"),
        ("CONF:FREQ -5", "-222"),
        ("CONF:FREQ 1E99", "-222"),
        ("CONF:ACC NAN", "-222"),
        // Above 0.45 of 50 kS/s; a period of more than 12 000 samples; above 200 m/s2 peak, the limit.
        ("CONF:FREQ 30 kHz", "-222"),
        ("CONF:FREQ 1", "-222"),
        ("CONF:ACC 150", "-222"),
        ("*ESE", "-109"),
        ("*ESE 256", "-222"),
        ("*ESE -1", "-222"),
        ("*SRE X", "-104"),
        ("READ? 5", "-108"),
        ("CONF:ACC 1 KHZ", "-104"),
        ("INIT 5", "-108"),
        ("NONSENSE", "-113"),
    ] {
        assert_eq!(line(&mut link, &mut rigged, text).trim(), "");
        let error = line(&mut link, &mut rigged, "SYST:ERR?");
        assert!(error.starts_with(&format!("{code},")), "{text}: {error}");
    }
    let both = line(&mut link, &mut rigged, "CONF:FREQ?;CONF:ACC?;SYST:ERR?");
    assert_eq!(both, "1.6E2;1E1;0,\"No error\"\n");
    for _ in 0..20 {
        line(&mut link, &mut rigged, "X");
    }
    let errors: Vec<String> = (0..9)
        .map(|_| line(&mut link, &mut rigged, "SYST:ERR?"))
        .collect();
    assert!(
        errors[7].starts_with("-350,") && errors[8].starts_with("0,"),
        "{errors:?}"
    );
    let long = "A".repeat(1000);
    assert_eq!(line(&mut link, &mut rigged, &long), "");
    assert!(line(&mut link, &mut rigged, "SYST:ERR?").starts_with("-363,"));
}

#[test]
fn every_record_that_has_room_is_in_the_catalogue() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "MMEM:CAT?"), "0,0\n");
    rigged.records = 40;
    let list = line(&mut link, &mut rigged, "MMEM:CAT?");
    assert!(list.starts_with("40000,0,\"1,BIN,1000\",\"2,BIN"), "{list}");
    assert_eq!(list.matches("BIN").count(), 40);
    rigged.records = 550;
    let list = line(&mut link, &mut rigged, "MMEM:CAT?");
    assert!(
        list.ends_with("\"\n") && list.len() <= MAX_FRAME,
        "whole entries"
    );
    assert!(line(&mut link, &mut rigged, "SYST:ERR?").starts_with("-223,"));
}

#[test]
fn text_and_frames_take_turns_on_one_link() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    // Every sequence number: the first byte of a frame takes every value.
    for sequence in 0..300 {
        let mut bytes = vec![0];
        bytes.extend(frame_of(&Request::Info, sequence));
        let heard = send(&mut link, &mut rigged, &bytes);
        assert!(
            matches!(responses(&heard)[..], [Response::Info(_)]),
            "{sequence}"
        );
        assert_eq!(line(&mut link, &mut rigged, "SYST:VERS?"), "1999.0\n");
    }
}

#[test]
fn a_lost_byte_costs_one_repetition_at_most() {
    let mut request = vec![0];
    request.extend(frame_of(&Request::Status, 0x2A2A));
    for lost in 0..request.len() {
        let (mut link, mut rigged) = (Link::new(), Rigged::default());
        let mut damaged = request.clone();
        damaged.remove(lost);
        let first = send(&mut link, &mut rigged, &damaged);
        let second = send(&mut link, &mut rigged, &request);
        let count = responses(&first).len() + responses(&second).len();
        assert!(count >= 1, "byte {lost}");
        link.forget();
        assert_eq!(
            line(&mut link, &mut rigged, "SYST:VERS?"),
            "1999.0\n",
            "byte {lost}"
        );
    }
}

#[test]
fn a_link_that_was_left_is_found_idle() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert!(!link.link.is_receiving());
    send(&mut link, &mut rigged, &[0, 7, 7]);
    assert!(link.link.is_receiving());
    link.forget();
    assert!(!link.link.is_receiving());
    assert_eq!(line(&mut link, &mut rigged, "SYST:VERS?"), "1999.0\n");
}

#[test]
fn a_degraded_instrument_says_what_does_not_work_and_measures_nothing() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "DIAG:DEF?"), "\"\"\n");
    rigged.defects = Defects::NONE.with(Defect::Clock).with(Defect::Archive);
    assert_eq!(
        line(&mut link, &mut rigged, "DIAG:DEF?"),
        "\"Archive,Clock\"\n"
    );
    assert_eq!(
        line(&mut link, &mut rigged, "INIT;SYST:ERR?"),
        "-240,\"Hardware error;see DIAG:DEF?\"\n"
    );
}

#[test]
fn lists_are_named_and_chosen_under_a_hand_alone() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    let mut ask = |rigged: &mut Rigged, text: &str| line(&mut link, rigged, text);
    assert_eq!(ask(&mut rigged, "LIST:CAT?;CHO?"), "\"\";\"\"\n");
    for name in ["pump 3", "field"] {
        let band = Band::everywhere(Base::Reference, 0.05);
        let list = StoredList {
            terms: ListTerms {
                name: name.try_into().expect("short"),
                rule: Rule::Simple,
                bands: [band].into_iter().collect(),
                ..ListTerms::NONE
            },
            points: heapless::Vec::new(),
        };
        rigged.lists.store(&list).expect("room");
    }
    assert_eq!(ask(&mut rigged, "LIST:CATalog?"), "\"pump 3\",\"field\"\n");
    assert_eq!(ask(&mut rigged, "LIST:CHOose \"field\""), "");
    assert_eq!(ask(&mut rigged, "list:choose?"), "\"field\"\n");
    rigged.hand_gone = true;
    for (wrong, code) in [
        ("LIST:CHO 'pump 3'", "-221,"),
        ("LIST:CHO", "-109,"),
        ("LIST:CHO field", "-104,"),
        ("LIST:CHO 'a name that is longer than any'", "-224,"),
    ] {
        assert_eq!(ask(&mut rigged, wrong), "", "{wrong}");
        let error = ask(&mut rigged, "SYST:ERR?");
        assert!(error.starts_with(code), "{wrong}: {error}");
    }
    rigged.hand_gone = false;
    assert_eq!(ask(&mut rigged, "LIST:CHO 'pump'"), "");
    assert!(ask(&mut rigged, "SYST:ERR?").starts_with("-224,"));
    assert_eq!(ask(&mut rigged, "LIST:CHO?"), "\"field\"\n");
    assert_eq!(ask(&mut rigged, "LIST:CHO '';CHO?"), "\"\"\n");
}

#[test]
fn a_list_is_measured_by_text_alone() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    assert_eq!(line(&mut link, &mut rigged, "CONF:LIST?"), "\n");
    assert_eq!(
        line(&mut link, &mut rigged, "CONF:LIST 160, 80, 0.5 kHz;ACC 20"),
        ""
    );
    assert_eq!(
        line(&mut link, &mut rigged, "CONF:LIST?"),
        "1.6E2,8E1,5E2\n"
    );
    assert_eq!(
        line(&mut link, &mut rigged, "FETC:LIST?;SYST:ERR?")
            .split(';')
            .count(),
        3
    );
    line(&mut link, &mut rigged, "*CLS");
    assert_eq!(
        line(&mut link, &mut rigged, "READ:LIST?"),
        "",
        "answered at its end"
    );
    let spec = rigged.spec.clone().expect("a run");
    let points: Vec<(f32, f32)> = spec
        .points
        .iter()
        .map(|point| (point.frequency_hz, point.acceleration_rms_ms2))
        .collect();
    assert_eq!(points, [(160.0, 20.0), (80.0, 20.0), (500.0, 20.0)]);
    rigged.running = false;
    let all = waited(&mut link, &mut rigged);
    let words: Vec<&str> = all.trim().split(',').collect();
    assert_eq!(words.len(), 15);
    assert_eq!(
        (words[0], words[1], words[2], words[4]),
        ("1.6E2", "1E-2", "9E1", "VALID")
    );
    assert_eq!((words[10], words[14]), ("5E2", "VALID"));
    // One point that was measured is no list, and a list no point.
    assert_eq!(line(&mut link, &mut rigged, "FETC:SENS?"), "9.91E37\n");
    rigged.refused = Some(Reason::Hum);
    let refused = line(&mut link, &mut rigged, "*CLS;FETC:LIST?");
    assert!(
        refused.ends_with("5E2,9.91E37,9.91E37,9.91E37,Hum\n"),
        "{refused}"
    );
    assert!(line(&mut link, &mut rigged, "SYST:ERR?").starts_with("-300,"));
    // Said anew and measured in one question.
    assert_eq!(line(&mut link, &mut rigged, "MEAS:LIST? 20,40"), "");
    assert_eq!(rigged.spec.as_ref().expect("a run").points.len(), 2);
    rigged.running = false;
    assert_eq!(waited(&mut link, &mut rigged).split(',').count(), 10);
}

#[test]
fn a_list_that_cannot_be_is_refused_and_changes_nothing() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    let many = vec!["99"; 33].join(",");
    for (text, code) in [
        ("CONF:LIST 160,30 kHz", "-222,"),
        ("CONF:LIST 160,,80", "-109,"),
        ("CONF:LIST 160,x", "-104,"),
        (&format!("CONF:LIST {many}"), "-223,"),
        ("CONF:LIST", "-109,"),
        ("INIT:LIST", "-222,"),
    ] {
        assert_eq!(line(&mut link, &mut rigged, text), "", "{text}");
        let error = line(&mut link, &mut rigged, "SYST:ERR?");
        assert!(error.starts_with(code), "{text}: {error}");
        assert_eq!(line(&mut link, &mut rigged, "CONF:LIST?"), "\n", "{text}");
    }
    // 100 m/s2 at 20 Hz are more than the exciter's velocity: nothing moves.
    let answer = line(
        &mut link,
        &mut rigged,
        "CONF:ACC 100;:MEAS:LIST? 160,20;SYST:ERR?",
    );
    assert!(answer.contains("NONE;-222,"), "{answer}");
    assert!(rigged.spec.is_none());
}

#[test]
fn a_record_is_read_as_blocks() {
    let (mut link, mut rigged) = (Link::new(), Rigged::default());
    rigged.records = 2;
    let mut block = |link: &mut Link, text: &str| {
        let answer = send(link, &mut rigged, format!("{text}\n").as_bytes());
        assert_eq!(answer[..2], *b"#4", "{text}");
        let length: usize = String::from_utf8_lossy(&answer[2..6])
            .parse()
            .expect("digits");
        assert_eq!(
            (answer.len(), answer.last()),
            (6 + length + 1, Some(&b'\n')),
            "{text}"
        );
        answer[6..6 + length].to_vec()
    };
    assert_eq!(block(&mut link, "MMEM:DATA? 1"), stored(1));
    assert_eq!(block(&mut link, "MMEM:DATA? 1, 1400"), stored(1)[1400..]);
    assert_eq!(block(&mut link, "MMEM:DATA? 1,1500"), Vec::<u8>::new());
    // Longer than an answer: in pieces.
    let mut whole = Vec::new();
    loop {
        let piece = block(&mut link, &format!("MMEM:DATA? 2,{}", whole.len()));
        if piece.is_empty() {
            break;
        }
        whole.extend(piece);
    }
    assert_eq!(whole, stored(2));
    for (text, code) in [
        ("MMEM:DATA? 3", "-256,"),
        ("MMEM:DATA? 1,1501", "-256,"),
        ("MMEM:DATA?", "-109,"),
        ("MMEM:DATA? x", "-104,"),
        ("MMEM:DATA? 1,-1", "-104,"),
    ] {
        assert_eq!(line(&mut link, &mut rigged, text), "#10\n", "{text}");
        let error = line(&mut link, &mut rigged, "SYST:ERR?");
        assert!(error.starts_with(code), "{text}: {error}");
    }
}
