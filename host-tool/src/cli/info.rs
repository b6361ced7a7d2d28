//! `calib info`: who is at the other end.

use super::Context;
use calib_core::self_test::BROWN_OUT_LEVEL;
use calib_host::Result;
use calib_output::InfoView;
use calib_protocol::message::Info as DeviceInfo;
use clap::Args;

/// `calib info`.
#[derive(Debug, Args)]
pub(crate) struct Info {}

impl Info {
    /// Prints identity and health of the calibrator.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = context.connect()?;
        let (info, health) = (client.info()?, client.health()?);
        let image = client.image()?;
        let view = InfoView::new(&info, health.as_ref(), image.as_ref());
        context.print(&view, || text(&info, &view))
    }
}

/// In words, with what the number is not.
fn temperature(processor_c: Option<f32>) -> String {
    match processor_c {
        Some(value) => {
            format!("{value:.0} degrees Celsius inside the processor, within some kelvin")
        }
        None => "not read".to_owned(),
    }
}

fn brown_out(level: u8) -> String {
    match level == BROWN_OUT_LEVEL {
        true => format!("level {level}"),
        false => {
            format!("level {level}, to be {BROWN_OUT_LEVEL}: docs/hardware.md, Brown-out level")
        }
    }
}

fn image(view: &InfoView) -> String {
    match &view.image {
        Some(image) => format!("slot {}, {}", image.slot, image.text()),
        None => "not checked by a loader".to_owned(),
    }
}

fn text(info: &DeviceInfo, view: &InfoView) -> String {
    let mut lines = vec![
        format!("serial number  {}", info.serial),
        format!(
            "firmware       {} ({})",
            info.firmware_version, info.git_hash
        ),
        format!("image          {}", image(view)),
        format!("protocol       {}", info.protocol_version),
        format!("sample rate    {} Hz per channel", info.sample_rate_hz),
        format!("records        {}", info.records),
        format!(
            "last start     {:?}, {} s ago",
            info.reset_cause,
            info.uptime_ms / 1000
        ),
        format!(
            "stack          {} bytes left at its deepest",
            info.stack_unused_bytes
        ),
        format!(
            "temperature    {}",
            temperature(info.instrument_temperature_c)
        ),
    ];
    if let Some(panic) = &info.last_panic {
        lines.push(format!("last panic     {panic}"));
    }
    lines.extend(view.deadlines.iter().map(|deadline| {
        format!(
            "{:<14} {:.3} ms at most, {:.1} allowed",
            deadline.work.replace('_', " "),
            1e3 * deadline.longest_s,
            1e3 * deadline.allowed_s
        )
    }));
    if let Some(deviation_rel) = view.timebase_deviation_rel {
        let ppm = 1e6 * deviation_rel;
        lines.push(format!("timebase       {ppm:+.0} ppm against the USB host"));
    }
    if let Some(level) = view.brown_out_level {
        lines.push(format!("brown-out      {}", brown_out(level)));
    }
    lines.extend(
        view.option_byte_texts
            .iter()
            .map(|text| format!("option byte    {text}")),
    );
    lines.extend(
        view.defect_texts
            .iter()
            .map(|text| format!("degraded       {text}")),
    );
    lines.extend(
        view.restarts
            .iter()
            .map(|text| format!("restart        {text}")),
    );
    lines.join("\n")
}
