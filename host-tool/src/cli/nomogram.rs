//! `calib nomogram`: two quantities of a vibration give the others.

use super::Context;
use super::number::{finite, reachable};
use calib_files::file;
use calib_host::Result;
use calib_metrology::nomogram::{self, Amplitude, Known, Measure, RigLimits, nomogram_chart};
use calib_metrology::text::{significant, table};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `calib nomogram --frequency 160 --acceleration 10`.
#[derive(Debug, Args)]
pub(crate) struct Nomogram {
    /// Frequency, Hz.
    #[arg(long, value_parser = finite::<f64>)]
    frequency: Option<f64>,
    /// Acceleration, m/s2.
    #[arg(long, value_parser = finite::<f64>)]
    acceleration: Option<f64>,
    /// Velocity, m/s.
    #[arg(long, value_parser = finite::<f64>)]
    velocity: Option<f64>,
    /// Displacement, m.
    #[arg(long, value_parser = finite::<f64>)]
    displacement: Option<f64>,
    /// How the given amplitude is stated.
    #[arg(long = "as", value_enum, default_value_t = As::Rms)]
    measure: As,
    /// Write the chart here (SVG), beyond the rig's limits shaded.
    #[arg(long, value_name = "FILE.svg")]
    chart: Option<PathBuf>,
    /// Largest acceleration of the rig, m/s2 r.m.s.
    #[arg(long, default_value_t = RigLimits::default().acceleration_rms_ms2, value_parser = finite::<f64>)]
    rig_acceleration: f64,
    /// Largest velocity of the rig, m/s r.m.s.
    #[arg(long, default_value_t = RigLimits::default().velocity_rms_ms, value_parser = finite::<f64>)]
    rig_velocity: f64,
    /// Largest displacement of the rig, m peak.
    #[arg(long, default_value_t = RigLimits::default().displacement_peak_m, value_parser = finite::<f64>)]
    rig_displacement: f64,
}

/// How an amplitude is stated.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum As {
    /// Root mean square.
    Rms,
    /// Peak.
    Peak,
    /// Peak to peak.
    PeakToPeak,
}

impl Nomogram {
    /// Converts and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let known = Known {
            frequency_hz: self.frequency,
            acceleration_ms2: self.acceleration,
            velocity_ms: self.velocity,
            displacement_m: self.displacement,
        };
        let measure = match self.measure {
            As::Rms => Measure::Rms,
            As::Peak => Measure::Peak,
            As::PeakToPeak => Measure::PeakToPeak,
        };
        let vibration = nomogram::solve(&known, measure)?;
        reachable("the frequency", vibration.frequency_hz)?;
        let limits = RigLimits {
            acceleration_rms_ms2: self.rig_acceleration,
            velocity_rms_ms: self.rig_velocity,
            displacement_peak_m: self.rig_displacement,
        };
        if let Some(path) = &self.chart {
            file::replace(path, nomogram_chart(&vibration, &limits).as_bytes())?;
        }
        context.print(&vibration, || {
            let row = |name: &str, amplitude: &Amplitude| {
                vec![
                    name.to_owned(),
                    significant(amplitude.rms, 6),
                    significant(amplitude.peak, 6),
                    significant(amplitude.peak_to_peak, 6),
                ]
            };
            let rows = [
                row("acceleration / (m/s2)", &vibration.acceleration_ms2),
                row("velocity / (m/s)", &vibration.velocity_ms),
                row("displacement / m", &vibration.displacement_m),
            ];
            let beyond = vibration.velocity_ms.rms > limits.velocity_at(vibration.frequency_hz);
            format!(
                "At {} Hz\n\n{}{}",
                significant(vibration.frequency_hz, 6),
                table(&["quantity", "r.m.s.", "peak", "peak to peak"], &rows),
                match beyond {
                    true => "\n  Beyond the rig's limits.\n",
                    false => "",
                }
            )
        })
    }
}
