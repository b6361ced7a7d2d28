//! Causes and stages in words that need no training.

use crate::axis::Axis;

/// What an effect is, as the end of "the simulation does not know that ...".
pub(super) fn effect(id: &str) -> Option<&'static str> {
    let at = EFFECTS.iter().find(|(name, _)| *name == id)?;
    Some(at.1)
}

/// What a stage is.
pub(super) fn stage(name: &str) -> &'static str {
    match name {
        "dut" => "the device under test",
        "reference" => "the reference transducer",
        "mount" => "the way the device is mounted",
        "conditioning" => "the electronics between transducer and converter",
        "digitiser" => "the converter to numbers",
        "exciter" => "the shaker",
        "amplifier" => "the power amplifier",
        "environment" => "the surroundings",
        _ => "the oscillator",
    }
}

/// What an observable is.
pub(super) fn observable(name: &str) -> &'static str {
    match name {
        "ratio" => "the ratio of the two transducers",
        "drive" => "the motion per coil voltage",
        "current" => "the coil current",
        "ref_harmonics" => "the distortion of the reference signal",
        "dut_harmonics" => "the distortion of the device's signal",
        "dc" => "the mean of the signals",
        "noise" => "the noise",
        _ => "the output",
    }
}

/// A range of a condition.
pub(super) fn range(axis: Axis, from: f64, to: f64) -> String {
    let (words, unit) = match axis {
        Axis::Frequency => ("at frequencies", "Hz"),
        Axis::Level | Axis::InverseLevel => ("at levels", "m/s\u{b2}"),
        Axis::Travel => ("at a travel", "m"),
        Axis::Time => ("over time,", "s"),
        Axis::Payload => ("with the payload,", "kg"),
        Axis::Temperature => ("with temperature,", "K above the reference"),
        Axis::Rotation => ("with the rotation,", "\u{b0}"),
        Axis::CoilVoltage => ("at coil voltages", "V"),
        Axis::Amplitude => ("amplitude", ""),
    };
    let (from, to) = (super::short(from), super::short(to));
    format!("{words} from {from} to {to}\u{a0}{unit}")
}

const EFFECTS: [(&str, &str); 52] = [
    (
        "dut_resonance",
        "the device under test has a resonance that already shows in this range",
    ),
    (
        "reference_resonance",
        "the reference transducer has a resonance that already shows in this range",
    ),
    (
        "mount_compliance",
        "the mount gives way like a spring under the device",
    ),
    (
        "relative_motion",
        "reference and device do not move quite alike at high frequency",
    ),
    (
        "transverse_motion",
        "the table also moves sideways, and the device feels it",
    ),
    (
        "base_strain",
        "bending of the mounting surface strains the device",
    ),
    (
        "gravity_tilt",
        "the table tilts as it travels, so that gravity leaks into the signal",
    ),
    (
        "loose_mount",
        "the device lifts off its mount at high level",
    ),
    (
        "dut_frequency_slope",
        "the device's sensitivity falls slowly with frequency",
    ),
    (
        "dut_level_nonlinearity",
        "the device's sensitivity depends on the level",
    ),
    (
        "dut_temperature",
        "the device's sensitivity changes with temperature",
    ),
    (
        "reference_temperature",
        "the reference's sensitivity changes with temperature",
    ),
    ("reference_drift", "the reference drifts with time"),
    ("dut_drift", "the device drifts with time"),
    (
        "dut_highpass",
        "the device's electronics cut off low frequencies",
    ),
    (
        "reference_highpass",
        "the reference's electronics cut off low frequencies",
    ),
    (
        "dut_lowpass_1",
        "the device's electronics cut off high frequencies",
    ),
    (
        "dut_lowpass_2",
        "a filter of the device's electronics cuts off high frequencies",
    ),
    (
        "averaging_window",
        "the device averages over a short time before it reports",
    ),
    ("crosstalk", "one channel leaks into the other"),
    ("mains_pickup", "the mains gets into the device's signal"),
    (
        "channel_skew",
        "the two channels are not sampled at the same instant",
    ),
    ("sampling_jitter", "the instants of sampling scatter"),
    (
        "clock_offset",
        "the two channels run on clocks that drift apart",
    ),
    ("adc_cubic", "a converter is curved, alike to both sides"),
    ("adc_quadratic", "a converter is curved to one side"),
    (
        "adc_dead_zone",
        "a converter does not see the smallest signals",
    ),
    ("adc_clipping", "a converter is overdriven at large signals"),
    (
        "suspension_cubic",
        "the spring that carries the table stiffens as it is deflected",
    ),
    (
        "suspension_asymmetry",
        "the spring that carries the table is stiffer to one side",
    ),
    (
        "force_factor_droop",
        "the motor loses force as the coil leaves the magnet's gap",
    ),
    (
        "coulomb_friction",
        "something rubs against the moving table",
    ),
    (
        "mechanical_damping",
        "the table is damped differently from what is stated",
    ),
    (
        "back_emf",
        "the voltage induced in the coil differs from what is stated",
    ),
    (
        "lossy_inductance",
        "the coil loses energy in the iron around it",
    ),
    ("coil_heating", "the coil warms up as it works"),
    ("armature_mode", "the table itself bends at high frequency"),
    (
        "payload_mass",
        "the mass on the table differs from what is stated",
    ),
    (
        "amplifier_clipping",
        "the power amplifier is overdriven at large signals",
    ),
    (
        "amplifier_even_order",
        "the power amplifier is curved to one side",
    ),
    (
        "amplifier_gain_drift",
        "the power amplifier's gain drifts with time",
    ),
    ("ambient_vibration", "the floor vibrates"),
    (
        "cubic_stiffness",
        "the spring stiffens alike to both sides as it is deflected",
    ),
    ("quadratic_stiffness", "the spring is stiffer to one side"),
    ("quadratic_damping", "the damping grows with speed"),
    ("cubic_damping", "the damping grows steeply with speed"),
    ("input_delay", "the input acts with a delay"),
    ("input_saturation", "the input is cut at large values"),
    ("output_highpass", "the output loses its slow part"),
    ("dead_zone", "the spring has play"),
    ("second_mode", "a second part vibrates along"),
    (
        "hysteresis",
        "the spring yields, and pulls less on the way back",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_effect_that_can_be_named_has_plain_words() {
        let named = crate::effects::list().into_iter().map(|about| about.id);
        for id in named.chain(crate::oscillator::names()) {
            assert!(effect(id).is_some(), "{id}");
        }
    }
}
