//! A calibrator in memory: the rules of the protocol, without any physics.

use calib_core::channel_ratio::ChannelRatio;
use calib_core::point::PointResult;
use calib_core::point_state::{PointState, Reason};
use calib_core::self_test::{Check, Line, MAX_LINES};
use calib_core::settings::{
    Example, InputScale, Limits, Method, PointInfluences, ReferenceCalibration, ReferencePoint,
    Settings,
};
use calib_core::stored_list::{NoPlace, StoredLists};
use calib_core::tone::Tone;
use calib_protocol::capture::{CAPTURE_CHUNK_PAIRS, CapturePart, MAX_CAPTURE_PAIRS};
use calib_protocol::frame::{Frame, FrameError, MAX_FRAME, PROTOCOL_VERSION, Receiver, encode};
use calib_protocol::health::Health;
use calib_protocol::lists::KeptList;
use calib_protocol::message::{
    Info, RECORD_CHUNK, Refusal, Request, ResetCause, Response, RunSpec, RunState, Status,
};
use calib_protocol::record::{self, Record, RecordHead, RecordKind, RecordSummary, RunLabels};
use calib_protocol::signature::DeviceKey;
use calib_protocol::stored_point::as_stored;
use calib_record::sample;
use std::collections::BTreeMap;

/// Looks at the status while a point is measured.
const LOOKS_PER_POINT: u16 = 3;

pub(crate) struct Device {
    pub(crate) records: BTreeMap<u32, Vec<u8>>,
    pub(crate) settings: Settings,
    /// The supply its self-test finds, V.
    pub(crate) supply_v: f32,
    pub(crate) protocol_version: u16,
    /// Answers everything with this, if set.
    pub(crate) refusal: Option<Refusal>,
    /// The board loses its run at this look at the status.
    pub(crate) reset_at_look: Option<u16>,
    /// The device under test gives no signal at these frequencies, Hz.
    pub(crate) silent_hz: Vec<f32>,
    /// The flash is broken: runs end in `Failed`.
    pub(crate) flash_broken: bool,
    /// Every run is another mounting, whose sensitivity is larger by this part.
    pub(crate) remounting_rel: f32,
    pub(crate) requests: Vec<Request>,
    pub(crate) starts: u32,
    receiver: Receiver,
    run: Option<Run>,
    last_start: Option<(u16, u32, u32)>,
    /// Pairs asked for, and looks at them so far.
    capture: Option<(u16, u16)>,
    /// Another host asks for a capture at this look at one.
    pub(crate) other_capture_at_look: Option<u16>,
    /// Captures do not grow.
    pub(crate) clock_stands: bool,
    /// Looks before a capture is whole.
    pub(crate) looks_per_capture: u16,
    /// The key that signs its records, as it says.
    pub(crate) key: Option<DeviceKey>,
    /// The lists it keeps, with a hand always on its button.
    pub(crate) lists: StoredLists,
}

/// Running number of the first pair of any capture.
pub(crate) const FIRST_PAIR: u64 = 7_000_000_000;

/// The pair at this place: a rising reference, a falling device under test.
pub(crate) fn codes(index: u16) -> [u16; 2] {
    [index, 50_000 - index]
}

struct Run {
    id: u32,
    spec: RunSpec,
    looks: u16,
    state: RunState,
}

impl Device {
    pub(crate) fn new() -> Self {
        Self {
            records: BTreeMap::new(),
            settings: settings(),
            supply_v: 3.3,
            protocol_version: PROTOCOL_VERSION,
            refusal: None,
            reset_at_look: None,
            silent_hz: Vec::new(),
            flash_broken: false,
            remounting_rel: 0.0,
            requests: Vec::new(),
            starts: 0,
            receiver: Receiver::new(),
            run: None,
            last_start: None,
            capture: None,
            other_capture_at_look: None,
            clock_stands: false,
            looks_per_capture: 3,
            key: None,
            lists: StoredLists::NONE,
        }
    }

    /// A device that holds one record of `points` points under `id`.
    pub(crate) fn with_record(id: u32, points: u16) -> Self {
        let mut device = Self::new();
        device.store(record(id, points));
        device
    }

    pub(crate) fn store(&mut self, record: Record) {
        self.records.insert(record.head.id, sample::bytes(&record));
    }

    /// Takes a byte and returns what the device sends in return.
    pub(crate) fn byte(&mut self, byte: u8) -> Vec<u8> {
        let Some(raw) = self.receiver.push(byte) else {
            return Vec::new();
        };
        let mut raw = raw.to_vec();
        let Ok(frame) = Frame::check(&mut raw) else {
            return Vec::new();
        };
        let response = match frame.message() {
            Ok(request) => self.answer(frame.sequence, frame.checksum, request),
            Err(FrameError::Message) => Response::Refused(Refusal::Unknown),
            Err(_) => return Vec::new(),
        };
        let mut buffer = vec![0; MAX_FRAME];
        let length = encode(frame.sequence, &response, &mut buffer).expect("fits");
        buffer.truncate(length);
        buffer
    }

    fn answer(&mut self, sequence: u16, checksum: u32, request: Request) -> Response {
        self.requests.push(request.clone());
        if let Some(refusal) = self.refusal {
            return Response::Refused(refusal);
        }
        match request {
            Request::Info => Response::Info(self.info()),
            Request::Health => Response::Health(Health::default()),
            Request::Status => Response::Status(self.status()),
            Request::Point { index } => Response::Point {
                index,
                result: self.point(index),
            },
            Request::Start(spec) => self.start(sequence, checksum, spec),
            Request::Stop => {
                self.end(RunState::Stopped);
                Response::Done
            }
            Request::StopRun { record_id } => {
                if self.run.as_ref().is_some_and(|run| run.id == record_id) {
                    self.end(RunState::Stopped);
                }
                Response::Done
            }
            Request::Records { from } => self.list(from),
            Request::ReadRecord { id, offset } => self.read(id, offset),
            Request::SettingsRead => Response::Settings(self.settings.clone()),
            Request::SettingsWrite(change) => {
                self.settings = change.settings;
                Response::Done
            }
            Request::Reset => {
                self.run = None;
                Response::Done
            }
            // It never runs out of room.
            Request::Release { .. } => Response::Done,
            Request::Capture { pairs } => self.capture(pairs),
            Request::ReadCapture { offset } => self.read_capture(offset),
            Request::SelfTest => Response::SelfTest {
                lines: self.self_test(),
            },
            Request::Key | Request::MakeKey => Response::Key(self.key),
            // As an instrument without a loader.
            Request::Image => Response::Image(None),
            Request::Update(_) => Response::Refused(Refusal::NoLoader),
            Request::Clock { .. } => Response::Done,
            Request::List { place } => Response::List(self.list_at(place)),
            Request::ChangeLists(change) => match change.carry_out(&mut self.lists) {
                Ok(()) => Response::Done,
                Err(NoPlace::Unknown) => Response::Refused(Refusal::ListUnknown),
                Err(NoPlace::Full) => Response::Refused(Refusal::ListsFull),
            },
        }
    }

    fn list_at(&self, place: u8) -> Option<KeptList> {
        let list = self.lists.all().get(usize::from(place))?;
        Some(KeptList {
            list: list.clone(),
            chosen: self.lists.chosen() == Some(list),
        })
    }

    fn self_test(&self) -> heapless::Vec<Line, MAX_LINES> {
        let supply = Line {
            check: Check::Supply,
            value: Some(self.supply_v),
            lower: Some(3.1),
            upper: Some(3.5),
        };
        [supply].into_iter().collect()
    }

    fn info(&self) -> Info {
        Info {
            protocol_version: self.protocol_version,
            firmware_version: "0.1.0".try_into().expect("short"),
            git_hash: "0123abcd".try_into().expect("short"),
            serial: "MEM-1".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            reset_cause: ResetCause::PowerOn,
            last_panic: None,
            records: self.records.len() as u32,
            uptime_ms: 1234,
            stack_unused_bytes: 12_000,
            instrument_temperature_c: Some(48.0),
        }
    }

    fn start(&mut self, sequence: u16, checksum: u32, spec: RunSpec) -> Response {
        if let Some((of, sum, record_id)) = self.last_start
            && (of, sum) == (sequence, checksum)
        {
            return Response::Started { record_id };
        }
        if spec.points.is_empty() {
            return Response::Refused(Refusal::PointList);
        }
        let running = |run: &Run| run.state.is_exciting();
        if self.run.as_ref().is_some_and(running) {
            return Response::Refused(Refusal::Busy);
        }
        let id = self.records.keys().max().map_or(1, |last| last + 1);
        self.starts += 1;
        self.last_start = Some((sequence, checksum, id));
        self.run = Some(Run {
            id,
            spec,
            looks: 0,
            state: RunState::Settling,
        });
        Response::Started { record_id: id }
    }

    /// Every look takes the run a step further.
    fn status(&mut self) -> Status {
        if let Some(run) = &mut self.run {
            run.looks += 1;
            let looks = run.looks;
            let ended = usize::from(looks / LOOKS_PER_POINT) >= run.spec.points.len();
            if self.reset_at_look == Some(looks) {
                self.run = None;
            } else if ended {
                self.end(RunState::Finished);
            }
        }
        let Some(run) = &self.run else {
            return Status::IDLE;
        };
        let point = (run.looks / LOOKS_PER_POINT).min(run.spec.points.len() as u16 - 1);
        let spec = run.spec.points[usize::from(point)];
        Status {
            state: run.state,
            point,
            points: run.spec.points.len() as u16,
            frequency_hz: spec.frequency_hz,
            target_rms_ms2: spec.acceleration_rms_ms2,
            acceleration_rms_ms2: spec.acceleration_rms_ms2,
            drive_peak_v: 1.0,
            block: run.looks % LOOKS_PER_POINT,
            blocks: LOOKS_PER_POINT,
            overruns: 0,
            samples: 1,
        }
    }

    /// Ends a run that is still going on.
    fn end(&mut self, state: RunState) {
        let Some(run) = &mut self.run else { return };
        if !run.state.is_exciting() {
            return;
        }
        if self.flash_broken {
            run.state = RunState::Failed;
            return;
        }
        run.state = state;
        let mut stored = record(run.id, 0);
        let before = self.records.get(&(run.id - 1));
        stored.head.previous_sha256 = before.map_or([0; 32], |bytes| record::digest(bytes));
        stored.head.labels = run.spec.labels.clone();
        stored.complete = state == RunState::Finished;
        let done = usize::from(run.looks / LOOKS_PER_POINT);
        for spec in run.spec.points.iter().take(done) {
            let point = mounted(
                self.remounting_rel * run.id as f32,
                measured(*spec, &self.silent_hz),
            );
            stored.points.push(point).expect("fits");
        }
        stored.untried = run.spec.points.iter().skip(done).copied().collect();
        self.store(stored);
    }

    fn point(&self, index: u16) -> Option<PointResult> {
        let run = self.run.as_ref()?;
        let done = (run.looks / LOOKS_PER_POINT) > index;
        let spec = run.spec.points.get(usize::from(index)).filter(|_| done)?;
        let rel = self.remounting_rel * run.id as f32;
        Some(mounted(rel, measured(*spec, &self.silent_hz)))
    }

    fn capture(&mut self, pairs: u16) -> Response {
        if !(1..=MAX_CAPTURE_PAIRS).contains(&pairs) {
            return Response::Refused(Refusal::CaptureLength);
        }
        self.capture = Some((pairs, 0));
        Response::Done
    }

    fn read_capture(&mut self, offset: u16) -> Response {
        let Some((total, looks)) = &mut self.capture else {
            return Response::Refused(Refusal::NotCaptured);
        };
        *looks += u16::from(!self.clock_stands);
        let other = self.other_capture_at_look.is_some_and(|at| at <= *looks);
        let whole = *looks >= self.looks_per_capture;
        let wanted = (offset..*total).take(if whole { CAPTURE_CHUNK_PAIRS } else { 0 });
        let data = wanted.flat_map(|index| codes(index).map(u16::to_le_bytes));
        Response::CaptureData(CapturePart {
            first: if whole {
                FIRST_PAIR + u64::from(other)
            } else {
                0
            },
            total: *total,
            taken: if whole { *total } else { 0 },
            offset,
            data: data.flatten().collect(),
        })
    }

    fn list(&self, from: u32) -> Response {
        let mut matching = self.records.range(from..);
        let records = matching.by_ref().take(16).map(|(id, bytes)| {
            let record = record::decode(bytes).expect("own record");
            RecordSummary {
                id: *id,
                bytes: bytes.len() as u32,
                unix_time_s: record.head.labels.unix_time_s,
                dut_serial: record.head.labels.dut_serial,
                points: record.points.len() as u16,
                refused: 0,
                sha256: record::digest(bytes),
                kind: RecordKind::Calibration,
            }
        });
        Response::Records {
            records: records.collect(),
            more: matching.next().is_some(),
        }
    }

    fn read(&self, id: u32, offset: u32) -> Response {
        let Some(bytes) = self.records.get(&id) else {
            return Response::Refused(Refusal::RecordNotFound);
        };
        let Some(rest) = bytes.get(offset as usize..) else {
            return Response::Refused(Refusal::OffsetOutOfRange);
        };
        let chunk = &rest[..rest.len().min(RECORD_CHUNK)];
        Response::RecordData {
            id,
            offset,
            total: bytes.len() as u32,
            data: chunk.try_into().expect("a chunk"),
        }
    }
}

pub(crate) fn settings() -> Settings {
    let point = |frequency_hz| ReferencePoint {
        frequency_hz,
        sensitivity_v_per_ms2: 0.01,
        phase_rad: 0.0,
        expanded_uncertainty_rel: 0.005,
        expanded_uncertainty_phase_rad: 0.01,
    };
    Settings {
        method: Method::Calibrator,
        example: Example::Example2,
        reference: ReferenceCalibration {
            serial: "REF-1".try_into().expect("short"),
            certificate: "C-1".try_into().expect("short"),
            calibrated_day: 20_000,
            due_day: 20_900,
            points: [5.0, 160.0, 20_000.0].into_iter().map(point).collect(),
        },
        reference_input: InputScale {
            volt_per_code: 1.5e-4,
        },
        dut_input: InputScale {
            volt_per_code: 1.5e-4,
        },
        drive_full_scale_peak_v: 10.0,
        limits: Limits {
            drive_peak_v: 10.0,
            acceleration_peak_ms2: 100.0,
            velocity_peak_ms: 1.0,
            displacement_peak_m: 0.005,
        },
        blocks: 5,
        influences: heapless::Vec::new(),
        point_influences: PointInfluences::NONE,
        channel_ratio: ChannelRatio::UNKNOWN,
        lease_s: 0,
    }
}

/// Result of a point.
fn measured(spec: calib_core::point::PointSpec, silent_hz: &[f32]) -> PointResult {
    match silent_hz.contains(&spec.frequency_hz) {
        true => as_stored(&PointResult::refused(spec, None, Reason::DutOpen)),
        false => result(spec.frequency_hz, spec.acceleration_rms_ms2),
    }
}

/// The point, larger by this part.
fn mounted(larger_rel: f32, mut point: PointResult) -> PointResult {
    point.sensitivity_v_per_ms2 *= 1.0 + larger_rel;
    point
}

/// A result as the firmware keeps it: what is stored comes back unchanged.
pub(crate) fn result(frequency_hz: f32, acceleration_rms_ms2: f32) -> PointResult {
    let spec = calib_core::point::PointSpec {
        frequency_hz,
        acceleration_rms_ms2,
    };
    let tone = Tone {
        cycles: 1,
        period_samples: 100,
    };
    as_stored(&PointResult {
        state: PointState::Valid,
        acceleration_rms_ms2,
        sensitivity_v_per_ms2: 0.01,
        phase_rad: 0.1,
        repeatability_rel: 1e-4,
        repeatability_phase_rad: 1e-4,
        blocks: 5,
        expanded_uncertainty_rel: 0.01,
        coverage_factor: 2.0,
        effective_degrees_of_freedom: f32::INFINITY,
        expanded_uncertainty_phase_rad: 0.02,
        distortion_reference_rel: 0.001,
        distortion_dut_rel: 0.001,
        signal_to_noise_reference_db: 80.0,
        signal_to_noise_dut_db: 80.0,
        amplitude_stability_rel: 1e-5,
        drive_peak_v: 1.0,
        settling_s: 0.5,
        overshoot_rel: 0.01,
        instrument_temperature_c: Some(48.25),
        ..PointResult::refused(spec, Some(tone), Reason::Stopped)
    })
}

/// A point that has none of its values in common with another, as in life: what points share is stored
/// once.
fn nth(n: u16) -> PointResult {
    let mut point = result(20.0 + f32::from(n), 10.0);
    let more = 1.0 + 0.02 * f32::from(n);
    point.phase_rad *= more;
    for value in [
        &mut point.repeatability_rel,
        &mut point.repeatability_phase_rad,
        &mut point.expanded_uncertainty_phase_rad,
        &mut point.distortion_reference_rel,
        &mut point.distortion_dut_rel,
        &mut point.signal_to_noise_reference_db,
        &mut point.signal_to_noise_dut_db,
        &mut point.amplitude_stability_rel,
        &mut point.drive_peak_v,
        &mut point.settling_s,
        &mut point.overshoot_rel,
    ] {
        *value *= more;
    }
    as_stored(&point)
}

/// [`record`] as it is read from what the device has stored.
pub(crate) fn read_back(id: u32, points: u16) -> Record {
    let device = Device::with_record(id, points);
    record::decode(&device.records[&id]).expect("own record")
}

pub(crate) fn record(id: u32, points: u16) -> Record {
    Record {
        head: RecordHead {
            id,
            instrument_serial: "MEM-1".try_into().expect("short"),
            firmware: "0.1.0 0123abcd".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            labels: RunLabels {
                unix_time_s: 1_795_269_900,
                dut_serial: "DUT'1".try_into().expect("short"),
                ..RunLabels::BLANK
            },
            ..RecordHead::BLANK
        },
        settings: settings(),
        complete: true,
        points: (0..points).map(nth).collect(),
        ..Record::BLANK
    }
}
