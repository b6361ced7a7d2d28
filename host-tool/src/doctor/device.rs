//! The calibrator's own answers: link, versions, health.

use super::finding::{Finding, State};
use crate::{Device, Error, Result};
use calib_core::self_test::BROWN_OUT_LEVEL;
use calib_link::Client;
use calib_protocol::frame::PROTOCOL_VERSION;
use calib_protocol::health::{Defect, Health, TIMEBASE_LIMIT_PPM};
use calib_protocol::message::Info;
use calib_record::origin::is_emulated;
use std::time::Duration;

/// Requests of the link check: a bad cable shows within them.
const REQUESTS: u32 = 20;

pub(super) fn check(address: &Device) -> Vec<Finding> {
    match ask(address) {
        Ok(Answers {
            info,
            health: parts,
            repetitions,
        }) => {
            let defects = parts.iter().flat_map(|health| health.defects.iter());
            [
                link(address, repetitions),
                kind(&info),
                versions(&info),
                health(&info),
            ]
            .into_iter()
            .chain(defects.map(defect))
            .chain(parts.as_ref().and_then(timebase))
            .chain(option_bytes(parts.as_ref()))
            .collect()
        }
        Err(error) => vec![unreachable(&error)],
    }
}

struct Answers {
    info: Info,
    /// None from a release that does not say.
    health: Option<Health>,
    repetitions: u64,
}

fn ask(address: &Device) -> Result<Answers> {
    let mut client = Client::new(address.open()?);
    let (info, health) = (client.info()?, client.health()?);
    for _ in 0..REQUESTS {
        client.status()?;
        client.wait(Duration::from_millis(5))?;
    }
    Ok(Answers {
        info,
        health,
        repetitions: client.repetitions(),
    })
}

fn unreachable(error: &Error) -> Finding {
    let check = match error {
        Error::Calibrator(calib_link::Error::Protocol(_)) => "versions",
        _ => "link",
    };
    Finding::new(check, State::Failed, error.to_string())
        .with_remedy(error.hint().unwrap_or_default())
}

fn link(address: &Device, repetitions: u64) -> Finding {
    match repetitions {
        0 => Finding::new(
            "link",
            State::Good,
            format!("{address} answered {} of {} requests", REQUESTS, REQUESTS),
        ),
        count => Finding::new(
            "link",
            State::Warning,
            format!("{address}: {count} of {REQUESTS} requests had to be repeated"),
        )
        .with_remedy("check the cable, and keep it away from the power amplifier"),
    }
}

/// Emulated or real, by the serial number.
fn kind(info: &Info) -> Finding {
    let said = match is_emulated(&info.serial) {
        true => "emulated: what it measures is simulated, and certificates say so",
        false => "a real calibrator, by its serial number",
    };
    Finding::new("kind", State::Good, format!("{}: {said}", info.serial))
}

fn versions(info: &Info) -> Finding {
    let text = format!(
        "firmware {} ({}), protocol {}; this tool {}, protocol {PROTOCOL_VERSION}",
        info.firmware_version,
        info.git_hash,
        info.protocol_version,
        env!("CARGO_PKG_VERSION"),
    );
    match info.firmware_version.as_str() == env!("CARGO_PKG_VERSION") {
        true => Finding::new("versions", State::Good, text),
        false => Finding::new("versions", State::Warning, text)
            .with_remedy("they understand each other; one release for both is better"),
    }
}

fn health(info: &Info) -> Finding {
    match &info.last_panic {
        None => Finding::new(
            "health",
            State::Good,
            format!(
                "{} records, last start by {:?}",
                info.records, info.reset_cause
            ),
        ),
        Some(panic) => Finding::new("health", State::Warning, format!("last panic: {panic}"))
            .with_remedy("report it, with the firmware version; the next record carries it too"),
    }
}

/// The clock beside that of a USB host, if there is one.
fn timebase(health: &Health) -> Option<Finding> {
    let ppm = health.timebase_ppm?;
    let text =
        format!("its clock is {ppm:+.0} ppm beside the USB host's, {TIMEBASE_LIMIT_PPM} allowed");
    Some(match ppm.abs() <= TIMEBASE_LIMIT_PPM {
        true => Finding::new("timebase", State::Good, text),
        false => Finding::new("timebase", State::Warning, text).with_remedy(
            "ask it from another computer: if that says the same, fit a crystal (docs/hardware.md)",
        ),
    })
}

/// Findings about the option bytes, set on the bench.
fn option_bytes(health: Option<&Health>) -> Vec<Finding> {
    let Some(options) = health.and_then(|health| health.option_bytes) else {
        return Vec::new();
    };
    let level = options.brown_out_level();
    let brown_out = match level == BROWN_OUT_LEVEL {
        true => Finding::new("brown-out", State::Good, format!("level {level}")),
        false => Finding::new(
            "brown-out",
            State::Warning,
            format!("level {level} and not {BROWN_OUT_LEVEL}: it may write its flash with too little supply"),
        )
        .with_remedy(
            "set it once, with the exciter unplugged: `./run brown-out` (docs/hardware.md, Brown-out level)",
        ),
    };
    let others = options.deviations().map(|deviation| {
        Finding::new("options", State::Warning, deviation.text())
            .with_remedy("set it back with STM32CubeProgrammer, records downloaded first")
    });
    std::iter::once(brown_out).chain(others).collect()
}

/// Something does not work: nothing is measured until it does.
fn defect(defect: Defect) -> Finding {
    Finding::new("degraded", State::Failed, defect.text()).with_remedy(defect.remedy())
}
