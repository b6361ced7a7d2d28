//! `docs/protocol.md` says what the code does.

use calib_core::point::ExcitationKind;
use calib_core::point_state::Reason;
use calib_core::settings::{MAX_INFLUENCES, MAX_REFERENCE_POINTS, Settings};
use calib_core::stored_list::{MAX_BANDS, MAX_LIST_POINTS, MAX_LISTS};
use calib_protocol::capture::{CAPTURE_CHUNK_PAIRS, CapturePart, MAX_CAPTURE_PAIRS};
use calib_protocol::frame::{Frame, MAX_FRAME, MAX_MESSAGE, PROTOCOL_VERSION, encode};
use calib_protocol::health::{Defects, Health};
use calib_protocol::lists::ListChange;
use calib_protocol::message::{Info, RECORD_CHUNK, Refusal, Request, Response, RunSpec, Status};
use calib_protocol::record::{MAX_POINTS, RECORD_VERSION, RunLabels};
use calib_protocol::update::{UPDATE_CHUNK, UpdateStep};
use serde::Serialize;
use serde::de::DeserializeOwned;

const PAGE: &str = include_str!("../../docs/protocol.md");

/// The bytes behind `word` in each hex block of the page.
fn hex_lines(word: &str) -> Vec<Vec<u8>> {
    let bytes = |text: &str| -> Option<Vec<u8>> {
        let digits = text.split_whitespace();
        let byte = |digits| u8::from_str_radix(digits, 16).ok();
        digits.map(byte).collect()
    };
    let lines = PAGE.lines().filter_map(|line| line.strip_prefix(word));
    lines.filter_map(bytes).collect()
}

#[test]
fn the_frames_in_hex_are_what_is_sent() {
    let request = Request::ReadRecord {
        id: 300,
        offset: 1024,
    };
    let answer = Response::Refused(Refusal::RecordNotFound);
    let frames = hex_lines("frame     ");
    assert_eq!(frames, [frame(&request), frame(&answer)]);
    let parts = ["number    ", "message   ", "checksum  "].map(hex_lines);
    for (index, mut bytes) in frames.into_iter().enumerate() {
        bytes.pop();
        let read = Frame::check(&mut bytes).expect("whole");
        assert_eq!(parts[0][index], read.sequence.to_le_bytes());
        assert_eq!(parts[1][index], read.message);
        assert_eq!(parts[2][index], read.checksum.to_le_bytes());
    }
}

fn frame(message: &impl Serialize) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    let length = encode(0x0102, message, &mut buffer).expect("fits");
    buffer.truncate(length);
    buffer
}

/// Number of a variant on the wire, and its name in the code.
fn variant(message: &(impl Serialize + std::fmt::Debug)) -> (u8, String) {
    let mut bytes = [0; MAX_MESSAGE];
    let bytes = postcard::to_slice(message, &mut bytes).expect("fits");
    let text = format!("{message:?}");
    let name = text.split([' ', '(', '{']).next().unwrap_or_default();
    (bytes[0], name.to_owned())
}

/// Rows of the table whose second column is headed `what`.
fn rows(what: &str) -> Vec<(u8, String)> {
    let head = format!("| number | {what} |");
    let lines = PAGE.lines().skip_while(|line| !line.starts_with(&head));
    let rows = lines.skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|line| {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let number = cells[1].parse().expect("a number");
        (number, cells[2].trim_matches('`').to_owned())
    })
    .collect()
}

#[test]
fn the_table_lists_every_request_with_its_number() {
    let run = RunSpec {
        points: heapless::Vec::new(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    let settings = Settings::field_calibrator();
    let requests = [
        Request::Info,
        Request::Status,
        Request::Point { index: 0 },
        Request::Start(run),
        Request::Stop,
        Request::Records { from: 0 },
        Request::ReadRecord { id: 0, offset: 0 },
        Request::SettingsRead,
        Request::SettingsWrite(settings.into()),
        Request::Reset,
        Request::Release { through: 0 },
        Request::Capture { pairs: 0 },
        Request::ReadCapture { offset: 0 },
        Request::Health,
        Request::SelfTest,
        Request::StopRun { record_id: 0 },
        Request::Key,
        Request::MakeKey,
        Request::Image,
        Request::Update(UpdateStep::Finish),
        Request::List { place: 0 },
        Request::ChangeLists(ListChange::Choose {
            name: heapless::String::new(),
        }),
        Request::Clock { unix_time_s: 0 },
    ];
    assert_eq!(rows("request"), requests.each_ref().map(variant));
    expect_no_more::<Request>(requests.len());
}

#[test]
fn the_table_lists_every_answer_with_its_number() {
    let answers = [
        Response::Info(info()),
        Response::Status(Status::IDLE),
        Response::Point {
            index: 0,
            result: None,
        },
        Response::Started { record_id: 0 },
        Response::Done,
        Response::Records {
            records: heapless::Vec::new(),
            more: false,
        },
        Response::RecordData {
            id: 0,
            offset: 0,
            total: 0,
            data: heapless::Vec::new(),
        },
        Response::Settings(Settings::field_calibrator()),
        Response::Refused(Refusal::Busy),
        Response::CaptureData(CapturePart {
            first: 0,
            total: 0,
            taken: 0,
            offset: 0,
            data: heapless::Vec::new(),
        }),
        Response::Health(Health::default()),
        Response::SelfTest {
            lines: heapless::Vec::new(),
        },
        Response::Key(None),
        Response::Image(None),
        Response::List(None),
    ];
    assert_eq!(rows("answer"), answers.each_ref().map(variant));
    expect_no_more::<Response>(answers.len());
}

#[test]
fn the_table_lists_every_reason_with_its_number() {
    let reasons = [
        Refusal::Busy,
        Refusal::RecordNotFound,
        Refusal::OffsetOutOfRange,
        Refusal::StorageFull,
        Refusal::StorageFailed,
        Refusal::PointList,
        Refusal::Settings,
        Refusal::Unknown,
        Refusal::OtherHost,
        Refusal::CaptureLength,
        Refusal::NotCaptured,
        Refusal::CaptureBroken,
        Refusal::ButtonNotHeld,
        Refusal::TemperatureOutOfRange,
        Refusal::ChannelsNotAligned,
        Refusal::Degraded(Defects::NONE),
        Refusal::Conditions,
        Refusal::KeyExists,
        Refusal::NoRandomness,
        Refusal::NoLoader,
        Refusal::ImageSignature,
        Refusal::ImageNotForHere,
        Refusal::ImageOlder,
        Refusal::ImageOnTrial,
        Refusal::UpdateOrder,
        Refusal::ImageDamaged,
        Refusal::List,
        Refusal::ListsFull,
        Refusal::ListUnknown,
        Refusal::StillDriven,
        Refusal::PointImpossible {
            index: 2,
            reason: Reason::DisplacementLimit,
        },
    ];
    assert_eq!(rows("reason"), reasons.each_ref().map(variant));
    expect_no_more::<Refusal>(reasons.len());
}

/// Fails if there is a variant of this number, which the page would not have. Zeros are fields of any
/// kind.
fn expect_no_more<T: DeserializeOwned>(number: usize) {
    let mut bytes = [0; 10];
    bytes[0] = number as u8;
    assert!(postcard::from_bytes::<T>(&bytes).is_err(), "{number}");
}

fn info() -> Info {
    Info {
        protocol_version: PROTOCOL_VERSION,
        ..Info::default()
    }
}

#[test]
fn the_limits_and_versions_are_those_of_the_code() {
    for (what, limit) in [
        ("message", format!("{MAX_MESSAGE} bytes")),
        ("frame with its zero", format!("{MAX_FRAME} bytes")),
        ("points of a run", MAX_POINTS.to_string()),
        ("pairs of a capture", MAX_CAPTURE_PAIRS.to_string()),
        (
            "pairs of a capture in one answer",
            CAPTURE_CHUNK_PAIRS.to_string(),
        ),
        ("bytes of a record in one answer", RECORD_CHUNK.to_string()),
        ("bytes of an image in one block", UPDATE_CHUNK.to_string()),
        (
            "rows of the reference's table",
            MAX_REFERENCE_POINTS.to_string(),
        ),
        ("influence quantities", MAX_INFLUENCES.to_string()),
        ("lists kept", MAX_LISTS.to_string()),
        ("points of a list that is kept", MAX_LIST_POINTS.to_string()),
        ("bands of its tolerance", MAX_BANDS.to_string()),
    ] {
        let row = format!("| {what} | {limit} |");
        assert!(PAGE.contains(&row), "{row}");
    }
    assert!(PAGE.contains(&format!("`PROTOCOL_VERSION` ({PROTOCOL_VERSION})")));
    let files = format!("version ({RECORD_VERSION}) what lies in files");
    assert!(PAGE.contains(&files));
}
