//! The measuring core on the twin's plant, without a board between: the same
//! samples, commands and delays as on the instrument, thousands of points in
//! the time an emulated board takes for a few.

use calib_core::aperture::Aperture;
use calib_core::broadband::PeriodMemory;
use calib_core::closing::Closing;
use calib_core::converter::Converters;
use calib_core::correlation::FoldMemory;
use calib_core::output::{Command, Output};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::PointState;
use calib_core::sequence::{Sampling, Sequencer};
use calib_core::settings::Settings;
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::{Conversions, DRIVE_MID_CODE, Dither, RigPort};

const RATE_HZ: f32 = 50_000.0;
const PERIOD_NS: u64 = 20_000;
/// Pairs of a block, and codes of a half of the output's ring, as in the firmware.
const BLOCK: usize = 500;
/// How the part's converters are set.
#[derive(Clone, Copy, Debug)]
pub struct Acquisition {
    /// At each trigger.
    pub conversions: Conversions,
    /// Frequency of the square wave on the dither's pin, Hz; 0 for none.
    pub dither_hz: f64,
    /// The drive converter has its buffer before the pin.
    pub drive_buffer: bool,
}

impl Acquisition {
    /// As the firmware sets them on the board with 240 MHz buses: 8 conversions of 41 cycles of 30 MHz
    /// each, 32.5 of them connected to the pin, and a period of the dither as long as all of them.
    pub const SHIPPING: Self = Self {
        conversions: Conversions {
            count: 8,
            apart_ps: 1_366_667,
            sampling_ns: 1_084,
        },
        dither_hz: 30.0e6 / (8.0 * 41.0),
        drive_buffer: false,
    };

    fn dither(self) -> Option<Dither> {
        (self.dither_hz > 0.0).then_some(Dither {
            frequency_hz: self.dither_hz,
            phase: 0.1,
        })
    }

    fn aperture(self) -> Aperture {
        Aperture {
            conversions: self.conversions.count as u16,
            apart_s: self.conversions.apart_ps as f32 * 1.0e-12,
        }
    }
}

/// A point that takes longer never ends.
const LONGEST_S: f32 = 60.0;

/// Measures the points of one run on a rig at rest, also behind one that would
/// end a run; the last is missing when it does not end within a minute.
pub fn measure(rig: &Rig, settings: &Settings, specs: &[PointSpec]) -> Vec<PointResult> {
    measure_by(Acquisition::SHIPPING, rig, settings, specs)
}

/// As [`measure`], each point held for all of its blocks.
pub fn measure_held(rig: &Rig, settings: &Settings, specs: &[PointSpec]) -> Vec<PointResult> {
    let (mut fold, mut period) = (FoldMemory::new(), PeriodMemory::new());
    let mut calibrator =
        Calibrator::new(Acquisition::SHIPPING, rig, settings, &mut fold, &mut period);
    calibrator.sequencer.start_run(settings.clone(), true);
    calibrator.run(specs)
}

/// As [`measure`], and how the run was closed, as the instrument does it.
pub fn measure_closed(
    rig: &Rig,
    settings: &Settings,
    specs: &[PointSpec],
) -> (Vec<PointResult>, Closing) {
    let (mut fold, mut period) = (FoldMemory::new(), PeriodMemory::new());
    let mut calibrator =
        Calibrator::new(Acquisition::SHIPPING, rig, settings, &mut fold, &mut period);
    let results = calibrator.run(specs);
    let ended = |result: &PointResult| match result.state {
        PointState::Refused(reason) => reason.ends_run(),
        PointState::Valid => false,
    };
    let first = results
        .iter()
        .find(|result| result.state == PointState::Valid);
    let closing = match first {
        Some(first) if specs.len() > 1 && !results.iter().any(ended) => {
            let again = calibrator.measure(first.spec);
            again.map_or(Closing::None, |again| Closing::new(first, &again))
        }
        _ => Closing::None,
    };
    (results, closing)
}

/// As [`measure`], with converters set otherwise than the firmware sets them.
pub fn measure_by(
    acquisition: Acquisition,
    rig: &Rig,
    settings: &Settings,
    specs: &[PointSpec],
) -> Vec<PointResult> {
    let (mut fold, mut period) = (FoldMemory::new(), PeriodMemory::new());
    Calibrator::new(acquisition, rig, settings, &mut fold, &mut period).run(specs)
}

struct Calibrator<'m> {
    sequencer: Sequencer<'m>,
    output: Output<'m>,
    plant: Plant,
    /// Codes played next, and those queued behind.
    ring: [[u16; BLOCK]; 2],
}

impl<'m> Calibrator<'m> {
    fn new(
        acquisition: Acquisition,
        rig: &Rig,
        settings: &Settings,
        fold: &'m mut FoldMemory,
        period: &'m mut PeriodMemory,
    ) -> Self {
        let sampling = Sampling {
            input: Converters::FIELD.input,
            sample_rate_hz: RATE_HZ,
            aperture: acquisition.aperture(),
            latency_samples: BLOCK as u32 + 2,
            rest_samples: BLOCK as u32,
        };
        let mut calibrator = Self {
            sequencer: Sequencer::new(fold, sampling, settings.clone()),
            output: Output::new(
                period,
                Converters::FIELD.drive,
                settings.drive_full_scale_peak_v,
                1,
            ),
            plant: Plant::new(rig),
            ring: [[DRIVE_MID_CODE; BLOCK]; 2],
        };
        calibrator.plant.set_conversions(acquisition.conversions);
        calibrator.plant.set_drive_buffer(acquisition.drive_buffer);
        calibrator.plant.set_dither(acquisition.dither());
        calibrator.sequencer.start_run(settings.clone(), false);
        calibrator
    }

    fn run(&mut self, specs: &[PointSpec]) -> Vec<PointResult> {
        specs.iter().map_while(|spec| self.measure(*spec)).collect()
    }

    fn measure(&mut self, spec: PointSpec) -> Option<PointResult> {
        self.sequencer.start_point(spec);
        let blocks = (LONGEST_S * RATE_HZ) as usize / BLOCK;
        (0..blocks).find_map(|_| self.block())
    }

    /// Queues a block behind the one that was queued, plays that, and takes its samples.
    fn block(&mut self) -> Option<PointResult> {
        self.queue();
        let plant = &mut self.plant;
        let pairs = self.ring[0].map(|code| {
            plant.hold(code, PERIOD_NS);
            let [reference, dut] = plant.sample().map(u32::from);
            dut << 16 | reference
        });
        self.sequencer.feed(&pairs)
    }

    fn queue(&mut self) {
        self.ring[0] = self.ring[1];
        match self.sequencer.command() {
            Command::Mute => {
                self.output.mute();
                self.ring[0] = [DRIVE_MID_CODE; BLOCK];
            }
            command => self.output.apply(command),
        }
        self.output.fill(&mut self.ring[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::deviation;
    use crate::rigged::{point, reference_point, true_certificate};
    use calib_twin::rig::Rig;

    /// Fields of machines beside the tone, in the device's channel, that beat with it too slowly for three blocks: these
    /// may all fall on one flank or crest. A point that ends early for it is not outside of U.
    #[test]
    fn no_beat_hides_in_a_point_that_ends_early() {
        let (mut early, mut greatest) = (0, 0.0_f64);
        for beat_hz in [0.15, 0.25, 0.4, 0.7, 1.0, 1.3] {
            for pickup_v in [1.0e-4, 2.0e-4, 4.0e-4, 8.0e-4, 2.0e-3] {
                let (rig, settings) = beside(160.0 + beat_hz, pickup_v);
                let list = [point(160.0, 10.0); 8];
                let results = measure(&rig, &settings, &list);
                let ended = |result: &&PointResult| {
                    result.state == PointState::Valid && result.blocks < settings.blocks
                };
                for result in results.iter().filter(ended) {
                    let off = deviation(result, &rig, RATE_HZ).magnitude_rel.abs();
                    early += 1;
                    greatest = greatest.max(off / f64::from(result.expanded_uncertainty_rel));
                }
            }
        }
        println!("{early} ended early, at most {greatest:.2} of U");
        assert!(early > 10 && greatest < 0.3, "{early} {greatest}");
    }

    /// A contact that opens at instants of its own takes as much of the amplitude as it leaves of the power: U
    /// covers it where the point is not refused, and sound rigs have next to nothing.
    #[test]
    fn a_contact_that_opens_is_within_u() {
        let list = [point(80.0, 3.0), point(630.0, 3.0)];
        let settings = Settings::field_calibrator();
        let (mut stated, mut greatest) = (0, 0.0_f64);
        for (rate_hz, open_fraction) in [
            (24.0, 0.005),
            (24.0, 0.02),
            (131.0, 0.02),
            (131.0, 0.05),
            (480.0, 0.01),
        ] {
            for channel in [0, 1] {
                let mut rig = Rig::standard();
                let fault = format!(
                    "cable_intermittent=channel:{channel},at_s:0,rate_hz:{rate_hz},open_fraction:{open_fraction}"
                );
                rig.faults.push(fault.parse().expect("a fault"));
                for result in measure(&rig, &settings, &list) {
                    if result.state == PointState::Valid {
                        let off = deviation(&result, &rig, RATE_HZ).magnitude_rel.abs();
                        stated += 1;
                        greatest = greatest.max(off / f64::from(result.expanded_uncertainty_rel));
                    }
                }
            }
        }
        println!("{stated} stated, at most {greatest:.2} of U");
        assert!(stated > 4 && greatest < 1.0, "{stated} {greatest}");
        for result in measure(&Rig::standard(), &settings, &list) {
            assert!(result.dropout_rel < 1.0e-3, "{}", result.dropout_rel);
        }
    }

    /// Ideal converters, the reference as it is, and a line of this frequency and r.m.s. size.
    fn beside(line_hz: f64, pickup_v: f64) -> (Rig, Settings) {
        let mut rig = Rig::standard();
        (rig.converter.errors, rig.converter.dither_peak_v) = (0.0, 0.0);
        rig.surroundings.mains_hz = line_hz;
        let mut settings = Settings::field_calibrator();
        settings.point_influences.converter_step_v = 0.0;
        settings.reference.points = true_certificate(&rig).iter().map(reference_point).collect();
        let field = format!("mains_pickup=pickup_v:{pickup_v},second_v:0,third_v:0");
        rig.effects.push(field.parse().expect("an effect"));
        (rig, settings)
    }
}
