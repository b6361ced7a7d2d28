//! `calib points`: lists of points by clause 5.

use super::Context;
use super::number::finite;
use calib_host::Result;
use calib_metrology::lists::{self, ListPoint};
use clap::{Args, Subcommand};
use std::fmt::Write;

/// `calib points preferred`, `calib points linearity` and `calib points resonance`.
#[derive(Debug, Args)]
pub(crate) struct Points {
    #[command(subcommand)]
    list: List,
}

#[derive(Debug, Subcommand)]
enum List {
    /// Preferred frequencies, the reference point first (5.1, 5.3).
    Preferred {
        /// Lowest frequency, Hz.
        #[arg(long, default_value_t = 20.0, value_parser = finite::<f64>)]
        from: f64,
        /// Highest frequency, Hz.
        #[arg(long, default_value_t = 5000.0, value_parser = finite::<f64>)]
        to: f64,
        /// Points, at least six; default every preferred frequency.
        #[arg(long)]
        count: Option<usize>,
        /// Acceleration, m/s2 r.m.s.
        #[arg(long, default_value_t = 10.0, value_parser = finite::<f64>)]
        acceleration: f64,
    },
    /// One frequency, several levels.
    Linearity {
        /// Frequency, Hz.
        #[arg(long, default_value_t = 160.0, value_parser = finite::<f64>)]
        frequency: f64,
        /// Lowest level, m/s2 r.m.s.
        #[arg(long, default_value_t = 1.0, value_parser = finite::<f64>)]
        from: f64,
        /// Highest level, m/s2 r.m.s.
        #[arg(long, default_value_t = 50.0, value_parser = finite::<f64>)]
        to: f64,
    },
    /// Many frequencies for a search of resonances, the reference point first.
    Resonance {
        /// Lowest frequency, Hz.
        #[arg(long, default_value_t = 1000.0, value_parser = finite::<f64>)]
        from: f64,
        /// Highest frequency, Hz.
        #[arg(long, default_value_t = 10_000.0, value_parser = finite::<f64>)]
        to: f64,
        /// Points an octave, at least twelve.
        #[arg(long, default_value_t = 24)]
        per_octave: u32,
        /// Acceleration, m/s2 r.m.s.
        #[arg(long, default_value_t = 10.0, value_parser = finite::<f64>)]
        acceleration: f64,
    },
}

impl Points {
    /// Prints a list as CSV, or as JSON.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let list = match self.list {
            List::Preferred {
                from,
                to,
                count,
                acceleration,
            } => lists::preferred(from, to, count, acceleration)?,
            List::Linearity {
                frequency,
                from,
                to,
            } => lists::linearity(frequency, from, to)?,
            List::Resonance {
                from,
                to,
                per_octave,
                acceleration,
            } => lists::resonance(from, to, per_octave, acceleration)?,
        };
        context.print(&list, || csv(&list))
    }
}

fn csv(list: &[ListPoint]) -> String {
    let mut text = String::from("frequency_hz,acceleration_rms_ms2\n");
    for point in list {
        let _ = writeln!(
            text,
            "{},{}",
            point.frequency_hz, point.acceleration_rms_ms2
        );
    }
    text
}
