//! Health: what does not work, and what the instrument went through.
//!
//! | id | section | fields |
//! |---|---|---|
//! | 1 | defects | one bit for each, u32 |
//! | 2 | restarts | count u8, then a text for each |
//! | 3 | deadlines | count u8, then for each: work u8, longest f32, allowed f32, microseconds |
//! | 4 | timebase | how much faster the clock is than the USB host's frames (option of f32, ppm) |
//! | 5 | option bytes | `FLASH_OPTSR_CUR` (option of u32) |
//!
//! A host asks for it beside [`Info`](crate::message::Info), whose fields are fixed: what is learnt of
//! the instrument later is a section more ([`crate::sections`]).

use crate::error::RecordError;
use crate::sections::{Fields, Read, fill, find, needed, section};
use calib_core::self_test::OptionBytes;
use heapless::{String, Vec};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Restarts in a row, without a minute of life, after which one more is not tried.
pub const MAX_RESTARTS: usize = 3;

/// Id of all sections where they are one themselves.
const HEALTH: u8 = 1;
const DEFECTS: u8 = 1;
const RESTARTS: u8 = 2;
const DEADLINES: u8 = 3;
const TIMEBASE: u8 = 4;
const OPTION_BYTES: u8 = 5;

/// Most deadlines that are told. Releases with fewer read the first 8.
pub const MAX_DEADLINES: usize = 24;

/// Difference between clock and USB frames from which one of them is wrong, ppm: a host may be off by
/// 500 (USB 2.0, 7.1.11), a crystal by 50.
pub const TIMEBASE_LIMIT_PPM: f32 = 550.0;

/// Something of the instrument that does not work. While there is one, no run is started.
///
/// The number is that of its bit, and one less than how often the red lamp blinks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Defect {
    /// The record area cannot be read or repaired: nothing could be stored.
    Archive = 0,
    /// The settings stored last cannot be read: those in force are not the instrument's own.
    Settings = 1,
    /// A converter of the measurement does not answer.
    Converters = 2,
    /// There is no clock at OSC_IN: every frequency is that of the internal oscillator, within some percent.
    Clock = 3,
    /// It restarted [`MAX_RESTARTS`] times in a row, and leaves out what it did not survive.
    Restarts = 4,
}

impl Defect {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 5] = [
        Self::Archive,
        Self::Settings,
        Self::Converters,
        Self::Clock,
        Self::Restarts,
    ];

    /// The defect in words.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Archive => "its record area cannot be read",
            Self::Settings => "its stored settings cannot be read",
            Self::Converters => "a converter does not answer",
            Self::Clock => "there is no clock at OSC_IN",
            Self::Restarts => {
                "it restarted three times in a row and leaves out what it did not survive"
            }
        }
    }

    /// Its remedy.
    pub const fn remedy(self) -> &'static str {
        match self {
            Self::Archive => "switch it off and on; if that does not help, the flash is worn out",
            Self::Settings => {
                "write the settings anew with a hand on the button: `calib settings --write`"
            }
            Self::Converters => {
                "switch it off and on; if that does not help, the board must be replaced"
            }
            Self::Clock => {
                "power the ST-LINK too, which makes the clock, or fit a crystal (docs/hardware.md)"
            }
            Self::Restarts => {
                "report why it restarted; a reset by the host, or holding the button for three seconds, tries again"
            }
        }
    }
}

/// Defects of an instrument: any number of [`Defect`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Defects(u32);

impl Defects {
    /// All is well.
    pub const NONE: Self = Self(0);

    /// With `defect`.
    #[must_use]
    pub const fn with(self, defect: Defect) -> Self {
        Self(self.0 | 1 << defect as u8)
    }

    /// Without `defect`.
    #[must_use]
    pub const fn without(self, defect: Defect) -> Self {
        Self(self.0 & !(1 << defect as u8))
    }

    /// Whether `defect` is among them.
    pub const fn has(self, defect: Defect) -> bool {
        self.0 & 1 << defect as u8 != 0
    }

    /// Whether all is well. What a newer release knows and this one does not counts too.
    pub const fn is_none(self) -> bool {
        self.0 == 0
    }

    /// Those this release has a name for.
    pub fn iter(self) -> impl Iterator<Item = Defect> {
        Defect::ALL
            .into_iter()
            .filter(move |defect| self.has(*defect))
    }
}

/// Work that must be done in time: blocks, turns of tasks and interrupts, each with all that interrupts it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Work {
    /// A block of samples is taken from the DMA.
    Acquire = 0,
    /// A block of the drive is made.
    Drive = 1,
    /// A block is evaluated.
    Evaluate = 2,
    /// All the measuring task does about a block: orders, evaluation, the result of a point.
    MeasureTask = 3,
    /// A turn of the task that takes blocks from the DMA.
    AcquireTask = 4,
    /// A turn of the task that makes the drive.
    DriveTask = 5,
    /// A turn of the task of the serial port.
    SerialTask = 6,
    /// A turn of the task of the USB port.
    UsbTask = 7,
    /// A turn of the task that looks after button, lamps and watchdog.
    SuperviseTask = 8,
    /// A turn of the task that reads and writes records.
    StoreTask = 9,
    /// A turn of the task that reads temperature and supply.
    SensorTask = 10,
    /// A turn of the task that compares the clock with the USB host's.
    TimebaseTask = 11,
    /// Interrupt of a DMA stream.
    DmaInterrupt = 12,
    /// Interrupt of the USB port.
    UsbInterrupt = 13,
    /// Interrupt of the serial port.
    UartInterrupt = 14,
}

impl Work {
    /// All of it, in the order of the numbers.
    pub const ALL: [Self; 15] = [
        Self::Acquire,
        Self::Drive,
        Self::Evaluate,
        Self::MeasureTask,
        Self::AcquireTask,
        Self::DriveTask,
        Self::SerialTask,
        Self::UsbTask,
        Self::SuperviseTask,
        Self::StoreTask,
        Self::SensorTask,
        Self::TimebaseTask,
        Self::DmaInterrupt,
        Self::UsbInterrupt,
        Self::UartInterrupt,
    ];
}

/// How long a piece of work took at most since the start, and how long it may take.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deadline {
    /// Number of a [`Work`]; what a newer release watches is none.
    pub work: u8,
    /// Longest so far, microseconds; 0 before it was done once.
    pub longest_us: f32,
    /// Time allowed, microseconds.
    pub allowed_us: f32,
}

/// How the instrument is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Health {
    /// Its defects.
    pub defects: Defects,
    /// Why it restarted, each time within a minute of the one before, oldest first.
    pub restarts: Vec<String<160>, MAX_RESTARTS>,
    /// Work that must be done in time.
    pub deadlines: Vec<Deadline, MAX_DEADLINES>,
    /// How much faster the instrument's clock is than the frames of the USB host, ppm; none without
    /// a host, and in the first seconds.
    pub timebase_ppm: Option<f32>,
    /// Option bytes of its processor; none from a release that does not say.
    pub option_bytes: Option<OptionBytes>,
}

/// The sections.
struct InSections<'a>(&'a Health);

impl Serialize for InSections<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let health = self.0;
        (
            section(DEFECTS, health.defects),
            section(RESTARTS, &health.restarts),
            section(DEADLINES, &health.deadlines),
            section(TIMEBASE, health.timebase_ppm),
            section(OPTION_BYTES, health.option_bytes),
        )
            .serialize(serializer)
    }
}

fn read(sections: &[u8]) -> Result<Health, RecordError> {
    let mut health = Health {
        defects: needed(sections, DEFECTS)?.take()?,
        ..Health::default()
    };
    read_list(needed(sections, RESTARTS)?, &mut health.restarts)?;
    if let Some((_, list)) = find(sections, DEADLINES, 1)? {
        read_list(Fields(list), &mut health.deadlines)?;
    }
    fill(sections, TIMEBASE, &mut health.timebase_ppm)?;
    fill(sections, OPTION_BYTES, &mut health.option_bytes)?;
    Ok(health)
}

/// A list, as far as there is room.
fn read_list<'a, T: Deserialize<'a>, const N: usize>(
    mut fields: Fields<'a>,
    list: &mut Vec<T, N>,
) -> Result<(), RecordError> {
    let count: usize = fields.take()?;
    for _ in 0..count.min(N) {
        // As many as there is room for.
        let _ = list.push(fields.take()?);
    }
    Ok(())
}

impl Serialize for Health {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        section(HEALTH, InSections(self)).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Health {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (_, _, sections) = Read::deserialize(deserializer)?;
        read(sections).map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(health: &Health) -> std::vec::Vec<u8> {
        let mut bytes = vec![0; 1024];
        let length = postcard::to_slice(health, &mut bytes).expect("fits").len();
        bytes.truncate(length);
        bytes
    }

    fn ill() -> Health {
        let restart = |text: &str| text.try_into().expect("short");
        Health {
            defects: Defects::NONE.with(Defect::Clock).with(Defect::Archive),
            restarts: [restart("hard fault"), restart("watchdog")]
                .into_iter()
                .collect(),
            deadlines: [(0, 12.5), (2, 4_000.0)]
                .map(|(work, longest_us)| Deadline {
                    work,
                    longest_us,
                    allowed_us: 10_000.0,
                })
                .into_iter()
                .collect(),
            timebase_ppm: Some(-3.5),
            option_bytes: Some(OptionBytes(0x0006_AAFC)),
        }
    }

    #[test]
    fn reading_inverts_writing() {
        for health in [Health::default(), ill()] {
            assert_eq!(postcard::from_bytes(&written(&health)), Ok(health));
        }
    }

    #[test]
    fn what_a_newer_release_adds_is_passed_over() {
        // A defect nobody knows here, and a section behind those that are.
        let mut sections = written(&ill()).split_off(3);
        sections[3] |= 0x40;
        sections.extend([99, 1, 2, 7, 7]);
        let message = section(HEALTH, 0_u8);
        let mut bytes = vec![message.id, message.version];
        bytes.push(sections.len() as u8);
        bytes.extend(sections);
        let health: Health = postcard::from_bytes(&bytes).expect("sections");
        assert_eq!(health.restarts, ill().restarts);
        assert!(health.defects.iter().eq([Defect::Archive, Defect::Clock]));
        assert_ne!(health.defects, ill().defects);
    }

    #[test]
    fn all_work_stands_at_its_number_and_there_is_room_for_it() {
        for (index, work) in Work::ALL.into_iter().enumerate() {
            assert_eq!(work as usize, index);
        }
        assert!(Work::ALL.len() <= MAX_DEADLINES);
    }

    #[test]
    fn defects_come_and_go_one_by_one() {
        for defect in Defect::ALL {
            let one = Defects::NONE.with(defect);
            assert!(one.has(defect) && !one.is_none());
            assert!(one.iter().eq([defect]));
            assert!(one.without(defect).is_none());
        }
    }
}
