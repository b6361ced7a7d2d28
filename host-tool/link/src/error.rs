//! Failures of a link, of the protocol, and refusals by the device: three kinds
//! that ask for three different actions.

use calib_protocol::frame::PROTOCOL_VERSION;
use calib_protocol::health::{Defect, Defects};
use calib_protocol::message::Refusal;
use std::path::Path;

/// Result of an operation on a calibrator.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Errors between this computer and a calibrator.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Bytes do not get through to the calibrator.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// The calibrator and this program do not understand each other.
    #[error(transparent)]
    Protocol(#[from] ProtocolError),
    /// The calibrator understood and declined.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A stop was asked for before the run began; it did not begin.
    #[error("stopped before it began; the exciter is silent")]
    Stopped,
    /// A file, an input or a request is not usable.
    #[error(transparent)]
    Files(#[from] calib_files::Error),
}

impl Error {
    /// [`calib_files::Error::file`].
    pub fn file(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        calib_files::Error::file(action, path, source).into()
    }

    /// [`calib_files::Error::input`].
    pub fn input(
        place: impl Into<String>,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        calib_files::Error::input(place, problem, hint).into()
    }

    /// Remedy, if the message does not state it already.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::Link(error) => Some(error.hint()),
            Self::Protocol(error) => Some(error.hint()),
            Self::Refused(error) => Some(error.hint()),
            Self::Stopped => None,
            Self::Files(error) => error.hint(),
        }
    }

    /// Exit code of a program that ends with this error: 3 link, 4 protocol,
    /// 5 refused, 7 stopped, else [`calib_files::Error::exit_code`].
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Link(_) => 3,
            Self::Protocol(_) => 4,
            Self::Refused(_) => 5,
            Self::Stopped => 7,
            Self::Files(error) => error.exit_code(),
        }
    }
}

/// Bytes do not get through.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// The port or connection cannot be opened.
    #[error("cannot open {address}: {source}")]
    Open {
        /// Address as given.
        address: String,
        /// Error of the operating system.
        source: std::io::Error,
        /// Remedy.
        hint: String,
    },
    /// The connection broke.
    #[error("the connection to {address} is gone: {source}")]
    Closed {
        /// Address as given.
        address: String,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// A stop was sent, and the calibrator did not confirm it in time.
    #[error("NOT STOPPED: {address} did not confirm the stop: {source}")]
    StopUnconfirmed {
        /// Address as given.
        address: String,
        /// Error that came instead.
        source: Box<LinkError>,
    },
    /// Not a single byte came back.
    #[error("no answer from {address} after {attempts} attempts")]
    NoAnswer {
        /// Address as given.
        address: String,
        /// Requests sent.
        attempts: u32,
    },
    /// Bytes came back, but never a frame.
    #[error("{address} sends something else than a calibrator's answers ({bytes} bytes)")]
    NotACalibrator {
        /// Address as given.
        address: String,
        /// Bytes received.
        bytes: usize,
    },
    /// Frames came back, but each answers an earlier request or had only begun: a link or a computer that is slow.
    #[error("every answer from {address} came too late ({late} answers in {attempts} attempts)")]
    Late {
        /// Address as given.
        address: String,
        /// Answers to earlier requests, and those that had begun.
        late: u32,
        /// Requests sent.
        attempts: u32,
    },
    /// Frames came back, but the checksum failed each time.
    #[error("every answer from {address} came damaged ({damaged} frames in {attempts} attempts)")]
    Damaged {
        /// Address as given.
        address: String,
        /// Frames with a wrong checksum.
        damaged: u32,
        /// Requests sent.
        attempts: u32,
    },
}

impl LinkError {
    /// Remedy.
    pub fn hint(&self) -> &str {
        match self {
            Self::Open { hint, .. } => hint,
            Self::Closed { .. } => {
                "plug the calibrator in again and repeat; a run in progress goes on without the host"
            }
            Self::StopUnconfirmed { .. } => {
                "use the button on the instrument, or the mute of the power amplifier"
            }
            Self::NoAnswer { .. } => {
                "is it powered, and is this its port? `calib devices` lists the ports"
            }
            Self::NotACalibrator { .. } => {
                "this is the port of another device: `calib devices` lists the ports"
            }
            Self::Late { .. } => {
                "the computer or the link is busy: close other programs, and repeat"
            }
            Self::Damaged { .. } => {
                "check the cable, or move it away from the power amplifier, and repeat"
            }
        }
    }
}

/// The peers do not understand each other.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProtocolError {
    /// The firmware speaks another version.
    #[error(
        "the calibrator speaks protocol version {device}, this tool speaks version {PROTOCOL_VERSION}"
    )]
    Version {
        /// Version of the firmware.
        device: u16,
    },
    /// An answer that does not belong to the request.
    #[error("the calibrator answered {request} with something else")]
    UnexpectedAnswer {
        /// Request in words.
        request: &'static str,
    },
}

impl ProtocolError {
    /// Remedy.
    pub fn hint(&self) -> &str {
        match self {
            Self::Version { device } if *device > PROTOCOL_VERSION => {
                "install the release of this tool that came with the firmware"
            }
            Self::Version { .. } => {
                "update the firmware: `./run program` in the source tree of this tool"
            }
            Self::UnexpectedAnswer { .. } => {
                "is another program using the same port? close it; if not, compare `calib info` with `calib version`"
            }
        }
    }
}

/// The calibrator understood and declined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the calibrator refused {request}: {}", reason(*.refusal))]
pub struct Refused {
    /// Request in words.
    pub request: &'static str,
    /// Its reason.
    pub refusal: Refusal,
}

fn reason(refusal: Refusal) -> String {
    let known = match refusal {
        Refusal::Degraded(defects) => return degraded(defects),
        Refusal::PointImpossible { index, reason } => {
            return format!(
                "point {} of the list: {reason}; nothing was moved",
                index + 1
            );
        }
        Refusal::Busy => "a run is going on, or it is busy with its flash",
        Refusal::RecordNotFound => "it has no record of this number",
        Refusal::OffsetOutOfRange => "the record or capture is shorter than that",
        Refusal::StorageFull => "its record area is full",
        Refusal::StorageFailed => "its flash reported an error",
        Refusal::PointList => "the point list is empty or holds a value that is no positive number",
        Refusal::Settings => "a setting is outside its range; nothing was changed",
        Refusal::Unknown => "it does not know this request",
        Refusal::OtherHost => "the host on its other link holds the session",
        Refusal::CaptureLength => "it has no room for so many sample pairs, or none were asked for",
        Refusal::NotCaptured => "nothing was captured since it was started",
        Refusal::CaptureBroken => "sample pairs were lost while it captured",
        Refusal::ButtonNotHeld => "this changes what results rest on, and its button is not held",
        Refusal::TemperatureOutOfRange => "it is too cold or too hot to measure",
        Refusal::ChannelsNotAligned => "its two channels are not of the same instants",
        Refusal::Conditions => "the temperature stated for the run cannot be true",
        Refusal::KeyExists => "it has a key, and keeps it",
        Refusal::NoRandomness => "its generator of random numbers gives none",
        Refusal::NoLoader => "it has no loader, which would start the new image",
        Refusal::ImageSignature => "the image was changed, or is not signed with the key it trusts",
        Refusal::ImageNotForHere => "the image is for another board",
        Refusal::ImageOlder => {
            "the image is older than the one that runs, and its button is not held"
        }
        Refusal::ImageOnTrial => "the image that runs is on trial and was not confirmed",
        Refusal::UpdateOrder => "the blocks of the image came out of order",
        Refusal::ImageDamaged => "what was written is not the image that was signed",
        Refusal::List => "the list cannot be measured or judged",
        Refusal::ListsFull => "there is no room for another list",
        Refusal::ListUnknown => "it has no list of this name",
        Refusal::StillDriven => "NOT STOPPED: its exciter is still driven",
        _ => "for a reason this tool does not know",
    };
    known.to_owned()
}

/// The defects in words.
fn degraded(defects: Defects) -> String {
    let texts: Vec<&str> = defects.iter().map(Defect::text).collect();
    match texts.is_empty() {
        true => "something does not work that this tool does not know".to_owned(),
        false => texts.join("; "),
    }
}

impl Refused {
    /// True when a record is shorter than the offset asked for.
    pub(crate) fn is_offset(&self) -> bool {
        self.refusal == Refusal::OffsetOutOfRange
    }

    /// True when a hand on the button is all that is missing.
    pub fn wants_button(&self) -> bool {
        matches!(self.refusal, Refusal::ButtonNotHeld | Refusal::ImageOlder)
    }

    /// Remedy.
    pub fn hint(&self) -> &str {
        match self.refusal {
            Refusal::StillDriven => {
                "press the button on the instrument, or switch the exciter's amplifier off"
            }
            Refusal::ButtonNotHeld => {
                "hold the button on the instrument and repeat meanwhile; a press counts for a minute. \
                 The change is logged as a record"
            }
            Refusal::ImageOlder => "hold the button on the instrument and repeat meanwhile",
            Refusal::NoLoader => {
                "`./run commission` in the source tree puts one on the instrument, by its debug probe"
            }
            Refusal::ImageSignature => {
                "use the file as its maker released it; an instrument with a loader of the source tree \
                 takes images signed with the development key alone"
            }
            Refusal::ImageNotForHere => "use the file for its board",
            Refusal::ImageOnTrial => {
                "the same update again confirms it; switched on three times without, the instrument \
                 returns to the one before"
            }
            Refusal::UpdateOrder | Refusal::ImageDamaged => "update again; what ran runs on",
            Refusal::TemperatureOutOfRange => {
                "`calib info` shows its temperature: let it cool down or warm up, and repeat"
            }
            Refusal::ChannelsNotAligned => {
                "press its reset button; if that does not help, an input is held too firmly for the \
                 check, or the part is faulty: docs/hardware.md, Alignment"
            }
            Refusal::Degraded(defects) => {
                let first = defects.iter().next();
                first.map_or("`calib info` says more", Defect::remedy)
            }
            Refusal::Busy => {
                "wait for its end, or stop it: `calib stop`, or the button on the instrument"
            }
            Refusal::RecordNotFound => "`calib records` lists the stored records",
            Refusal::OffsetOutOfRange => "remove the .part file and download again",
            Refusal::StorageFull => {
                "download the records, then `calib release ID` lets those up to ID make room"
            }
            Refusal::StorageFailed => {
                "reset the instrument and repeat; if it happens again, the flash is worn out"
            }
            Refusal::PointList => "correct the point list",
            Refusal::PointImpossible { .. } => "take the point out of the list, or lower its level",
            Refusal::Conditions => "state -55 to 200 degrees Celsius, or none",
            Refusal::KeyExists => "`calib key` shows it, and enters it in the logbook",
            Refusal::NoRandomness => {
                "switch it off and on and repeat; if it happens again, have it serviced"
            }
            Refusal::Settings => {
                "correct the settings; docs/safety.md has the ceilings no setting passes"
            }
            Refusal::CaptureLength => "a capture has 1 to 16384 sample pairs",
            Refusal::NotCaptured => "was it reset? capture again",
            Refusal::CaptureBroken => "capture again",
            Refusal::List => {
                "it needs a name, points, a tolerance, and the nominal sensitivity it is stated of; a name \
                 has neither quotes nor semicolons"
            }
            Refusal::ListsFull => "remove one: `calib lists remove NAME`",
            Refusal::ListUnknown => "`calib lists` shows them",
            Refusal::OtherHost => {
                "end the program that uses the other port, wait five seconds and repeat"
            }
            _ => "compare `calib info` with `calib version`, and update the older one",
        }
    }
}
