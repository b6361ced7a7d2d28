//! Inputs to begin with: everything a good host and a good device say.

use super::frames::{Whole, framed};
use calib_core::point::{ExcitationKind, PointResult, PointSpec};
use calib_core::point_state::Reason;
use calib_core::settings::Settings;
use calib_core::stored_list::{Band, Base, ListTerms, Rule, StoredList};
use calib_protocol::capture::CapturePart;
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{Refusal, Request, Response, RunSpec};
use calib_protocol::record::{self, Record, RecordHead, RunLabels};
use calib_protocol::update::UpdateStep;
use serde::Serialize;

/// A seed of a fuzz target.
pub struct Seed {
    /// Name of the target.
    pub target: &'static str,
    /// File name.
    pub name: String,
    /// Content.
    pub bytes: Vec<u8>,
}

/// Seeds of the targets for a link and its records.
pub(super) fn seeds() -> Vec<Seed> {
    let requests = requests();
    let mut seeds = Vec::new();
    for target in ["frames", "commands"] {
        for (index, request) in requests.iter().enumerate() {
            let sequence = 0x0100 + index as u16;
            let message = message(request);
            seeds.push(Seed {
                target,
                name: format!("request-{index:02}"),
                bytes: framed(&Whole { sequence, message }),
            });
        }
    }
    for (index, answer) in answers().iter().enumerate() {
        // An odd byte in front: the message of a good frame.
        let mut bytes = vec![1];
        bytes.extend(message(answer));
        seeds.push(Seed {
            target: "client",
            name: format!("answer-{index:02}"),
            bytes,
        });
    }
    seeds.push(Seed {
        target: "records",
        name: "record".to_owned(),
        bytes: record(),
    });
    seeds
}

fn message(message: &impl Serialize) -> Vec<u8> {
    let mut buffer = vec![0; 1 << 13];
    // Longer than any message.
    let length = postcard::to_slice(message, &mut buffer).map_or(0, |used| used.len());
    buffer.truncate(length);
    buffer
}

fn spec() -> PointSpec {
    PointSpec {
        frequency_hz: 160.0,
        acceleration_rms_ms2: 10.0,
    }
}

fn requests() -> Vec<Request> {
    let run = RunSpec {
        points: [spec(), spec()].into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    };
    vec![
        Request::Info,
        Request::Status,
        Request::Point { index: 1 },
        Request::Start(run),
        Request::Stop,
        Request::Records { from: 1 },
        Request::ReadRecord { id: 1, offset: 300 },
        Request::SettingsRead,
        Request::SettingsWrite(Settings::field_calibrator().into()),
        Request::Reset,
        Request::Release { through: 1 },
        Request::Capture { pairs: 300 },
        Request::ReadCapture { offset: 256 },
        Request::SelfTest,
        Request::StopRun { record_id: 1 },
        Request::Key,
        Request::MakeKey,
        Request::Image,
        Request::Update(UpdateStep::Block {
            offset: 1024,
            data: heapless::Vec::from_slice(&[0x5A; 64]).unwrap_or_default(),
        }),
        Request::List { place: 0 },
        Request::ChangeLists(ListChange::Store(list())),
        Request::Clock {
            unix_time_s: 1_795_269_900,
        },
    ]
}

/// A list of one point with its tolerance.
pub(super) fn list() -> StoredList {
    let band = Band::everywhere(Base::Nominal, 0.05);
    StoredList {
        terms: ListTerms {
            name: "field".try_into().unwrap_or_default(),
            nominal_v_per_ms2: 0.0102,
            unit: "mV/g".try_into().unwrap_or_default(),
            rule: Rule::GuardBand,
            bands: [band].into_iter().collect(),
        },
        points: [spec()].into_iter().collect(),
    }
}

fn answers() -> Vec<Response> {
    let result = PointResult::refused(spec(), None, Reason::Clipped);
    let record = record();
    let data = record.iter().copied().take(200).collect();
    vec![
        Response::Point {
            index: 0,
            result: Some(result),
        },
        Response::Started { record_id: 1 },
        Response::Done,
        Response::Records {
            records: record::inspect(&record)
                .into_iter()
                .map(|(s, _)| s)
                .collect(),
            more: false,
        },
        Response::RecordData {
            id: 1,
            offset: 0,
            total: record.len() as u32,
            data,
        },
        Response::Settings(Settings::field_calibrator()),
        Response::Refused(Refusal::Busy),
        Response::CaptureData(CapturePart {
            first: 500,
            total: 3,
            taken: 3,
            offset: 1,
            data: [0, 0x80, 1, 0x80, 0, 0x80, 2, 0x80].into_iter().collect(),
        }),
        Response::List(Some(KeptList {
            list: list(),
            chosen: true,
        })),
    ]
}

/// A record of two points.
pub(super) fn record() -> Vec<u8> {
    let result = PointResult::refused(spec(), None, Reason::NotSettled);
    let record = Record {
        head: RecordHead {
            id: 1,
            sample_rate_hz: 50_000.0,
            ..RecordHead::BLANK
        },
        settings: Settings::field_calibrator(),
        complete: true,
        points: [result, result].into_iter().collect(),
        ..Record::BLANK
    };
    let mut bytes = vec![0; 1 << 13];
    // Longer than a record of two points.
    let length = record::encode(&record, &mut bytes).unwrap_or_default();
    bytes.truncate(length);
    bytes
}
