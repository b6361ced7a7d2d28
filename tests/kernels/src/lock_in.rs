//! Correlation by crate `idsp`: both channels demodulated by one oscillator.

use crate::PAIRS;
use calib_core::tone::Tone;
use core::num::Wrapping;
use dsp_fixedpoint::Q32;
use dsp_process::SplitProcess;
use idsp::{Complex, Lockin, Lowpass, LowpassState};

/// An oscillator and two lock-ins with a first-order low-pass, the shortest the
/// crate has. A measurement would take one of second order.
pub(crate) struct LockIn {
    phase: Wrapping<i32>,
    step: Wrapping<i32>,
    filter: Lockin<Lowpass<1>>,
    state: [[LowpassState<1>; 2]; 2],
}

impl LockIn {
    /// A lock-in at `tone` with a corner at a thousandth of the Nyquist rate.
    pub(crate) fn new(tone: Tone) -> Self {
        let turns = f64::from(tone.cycles) / f64::from(tone.period_samples);
        // k = pi 2^31 f0 / fn by the crate's docs.
        let gains = [(core::f64::consts::PI * 2_147_483_648.0 * 1.0e-3) as i32];
        Self {
            phase: Wrapping(0),
            step: Wrapping((turns * 4_294_967_296.0) as i32),
            filter: Lockin(Lowpass(gains)),
            state: Default::default(),
        }
    }
}

/// Demodulates a buffer; the last values of both channels.
#[unsafe(no_mangle)]
#[inline(never)]
pub(crate) fn kernel_lock_in(lock_in: &mut LockIn, pairs: &[u32; PAIRS]) -> [Complex<i32>; 2] {
    let mut last = [Complex::new(0, 0); 2];
    let [reference, dut] = &mut lock_in.state;
    for &pair in pairs {
        let signed = pair ^ 0x8000_8000;
        let oscillator = Complex::<i32>::from_angle(lock_in.phase);
        let oscillator = Complex::<Q32<32>>::from_bits(oscillator);
        lock_in.phase += lock_in.step;
        let samples = [(signed << 16) as i32, (signed & 0xFFFF_0000) as i32];
        last = [
            lock_in.filter.process(reference, (samples[0], oscillator)),
            lock_in.filter.process(dut, (samples[1], oscillator)),
        ];
    }
    last
}
