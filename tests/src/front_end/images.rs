//! Effect of the images of a tone on the sensitivity.
//!
//! The held output has, beside the tone at `f`, images at `k fs + f`. What the reconstruction
//! filter leaves of them moves the table, what the anti-alias filter leaves of that is sampled, and
//! all of it falls exactly on the tone. The device under test and the reference differ there.

use super::ngspice::Row;
use calib_twin::Complex;
use calib_twin::oracle;
use calib_twin::rig::{Rig, Sensing};
use std::f64::consts::PI;

/// Rate of both converters, Hz.
pub const SAMPLE_RATE_HZ: f64 = 50e3;

/// Images that are added on either side: to 2 MHz.
const ORDERS: i32 = 39;

/// The step of `images.txt`, Hz.
const STEP_HZ: f64 = 1250.0;

/// A transfer function of the frequency in Hz.
pub type Transfer<'a> = Box<dyn Fn(f64) -> Complex<f64> + 'a>;

/// The two filters beside the converters.
pub struct Filters<'a> {
    /// As the table names them.
    pub name: String,
    /// Behind the drive converter.
    pub reconstruction: Transfer<'a>,
    /// Before each input converter.
    pub anti_alias: Transfer<'a>,
}

impl Filters<'_> {
    /// Butterworth low-passes of an order and a -3 dB corner in Hz.
    pub fn butterworth(name: &str, reconstruction: (u32, f64), anti_alias: (u32, f64)) -> Self {
        Self {
            name: name.to_owned(),
            reconstruction: Box::new(move |hz| butterworth(reconstruction, hz)),
            anti_alias: Box::new(move |hz| butterworth(anti_alias, hz)),
        }
    }

    /// Filters as ngspice computed them, at multiples of 1.25 kHz: `images.txt` of `response.cir`.
    pub fn circuit(rows: &[Row]) -> Filters<'_> {
        // From the drive converter's code to volts and from volts to the pin: what is constant cancels.
        let at = |path: usize| -> Transfer<'_> {
            Box::new(move |hz| {
                let index = (hz / STEP_HZ).round() as usize - 1;
                rows.get(index)
                    .map_or(Complex::ZERO, |row| row.values[path])
            })
        };
        Filters {
            name: "this circuit".into(),
            reconstruction: at(1),
            anti_alias: at(0),
        }
    }

    /// Attenuation of `image_hz` against `tone_hz` by each, dB.
    pub fn attenuation_db(&self, tone_hz: f64, image_hz: f64) -> [f64; 2] {
        [&self.reconstruction, &self.anti_alias]
            .map(|filter| 20.0 * (filter(tone_hz).norm() / filter(image_hz).norm()).log10())
    }
}

/// Response of a Butterworth low-pass of an order and corner, from its poles.
pub fn butterworth((order, corner_hz): (u32, f64), frequency_hz: f64) -> Complex<f64> {
    let pole = |index: u32| {
        let angle = PI / 2.0 + PI * f64::from(2 * index + 1) / f64::from(2 * order);
        Complex::from_polar(1.0, angle)
    };
    let factor = |pole: Complex<f64>| -pole / (Complex::new(0.0, frequency_hz / corner_hz) - pole);
    (0..order).map(pole).map(factor).product()
}

/// Exciter and device under test an image meets.
#[derive(Clone, Debug)]
pub struct Scene {
    /// As the table names it.
    pub name: &'static str,
    /// Whether the exciter gives the same acceleration per volt at the image as at the tone;
    /// otherwise it is the standard rig's, which falls by 24 dB from 10 to 40 kHz.
    pub flat_exciter: bool,
    /// Resonance of the device: the standard rig's, or with a quality of 30 on the image.
    pub on_resonance: bool,
}

impl Scene {
    fn device(&self, rig: &Rig, tone_hz: f64) -> Sensing {
        let mut device = rig.dut;
        if self.on_resonance {
            device.resonance_hz = SAMPLE_RATE_HZ - tone_hz;
            device.quality_factor = 30.0;
        }
        device
    }
}

/// Measured over true sensitivity, less one, for a tone at `tone_hz`.
///
/// # Equation
/// `F(D) S1 / (F(R) S2) - 1` with the fold `F(S) = sum over k of hold * reconstruction * exciter *
/// S * anti-alias` at `f + k fs`.
pub fn error(filters: &Filters<'_>, scene: &Scene, tone_hz: f64) -> Complex<f64> {
    let rig = Rig::standard();
    let device = scene.device(&rig, tone_hz);
    let excited = |hz: f64| {
        let angle = PI * hz / SAMPLE_RATE_HZ;
        let hold = Complex::from_polar(angle.sin() / angle, -angle);
        let exciter = match scene.flat_exciter {
            true => Complex::ONE,
            false => oracle::exciter_transfer(&rig, hz),
        };
        hold * exciter * (filters.reconstruction)(hz) * (filters.anti_alias)(hz)
    };
    let truth = |sensing: &Sensing| oracle::sensitivity(sensing, tone_hz);
    let seen =
        |sensing: &Sensing| fold(tone_hz, |hz| excited(hz) * oracle::sensitivity(sensing, hz));
    seen(&device) / seen(&rig.reference) * truth(&rig.reference) / truth(&device) - 1.0
}

/// The tone and its images, as the sampler adds them.
fn fold(tone_hz: f64, response: impl Fn(f64) -> Complex<f64>) -> Complex<f64> {
    let image = |order: i32| {
        let image_hz = tone_hz + f64::from(order) * SAMPLE_RATE_HZ;
        match image_hz < 0.0 {
            // A real system: H(-f) is the conjugate of H(f).
            true => response(-image_hz).conj(),
            false => response(image_hz),
        }
    };
    (-ORDERS..=ORDERS).map(image).sum()
}
