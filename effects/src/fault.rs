//! Faults on site.
//!
//! Faults are given like effects, in the list `faults` of a rig file. They act on the rig in time
//! only: no steady state has them. `at_s` counts from the instant the rig was connected.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &AMPLIFIER_GAIN,
    &AMPLIFIER_OFF,
    &AMPLIFIER_RAIL,
    &ARMATURE_STOP,
    &CABLE_INTERMITTENT,
    &COIL_OPEN,
    &COIL_SHORT,
    &DUT_FALLS_OFF,
    &IEPE_OPEN,
    &IEPE_SHORT,
    &INSTRUMENT_TEMPERATURE,
    &TRANSDUCER_DEAD,
    &TRANSDUCER_FADING,
    &TRANSDUCER_SATURATED,
];

const AT_S: Parameter = Parameter::linear("at_s", "s", [0.0, 1e6], 0.0);
const CHANNEL: Parameter = Parameter::switch("channel", "0 or 1", 1.0);
/// Supplies of 20 to 30 V leave a jump of about half of that; coupling forgets it in seconds.
const IEPE: &[Parameter] = &[
    CHANNEL,
    AT_S,
    Parameter::linear("jump_v", "V", [0.0, 30.0], 12.0).on_site(5.0, 20.0),
    Parameter::linear("decay_s", "s", [1e-3, 100.0], 1.0).on_site(0.1, 10.0),
];

/// A power amplifier whose gain is wrong: another range (a decade or less), a failed feedback.
pub static AMPLIFIER_GAIN: Entry = Entry {
    id: "amplifier_gain",
    stage: Stage::Amplifier,
    formula: "coil voltage times factor from at_s on",
    parameters: &[
        AT_S,
        Parameter::linear("factor", "1", [0.0, 10.0], 2.0).on_site(0.1, 10.0),
    ],
    plain: "the power amplifier has another gain",
    ..Entry::FAULT
};

/// A power amplifier that switches off.
pub static AMPLIFIER_OFF: Entry = Entry {
    id: "amplifier_off",
    stage: Stage::Amplifier,
    formula: "coil voltage 0 from at_s on",
    parameters: &[AT_S],
    plain: "the power amplifier is off",
    ..Entry::FAULT
};

/// A power amplifier that loses its supply: its output saturates.
pub static AMPLIFIER_RAIL: Entry = Entry {
    id: "amplifier_rail",
    stage: Stage::Amplifier,
    formula: "coil voltage saturates at a threshold from at_s on",
    parameters: &[
        AT_S,
        Parameter::linear("threshold_v", "V", [0.0, 100.0], 0.5).on_site(0.05, 10.0),
    ],
    plain: "the power amplifier loses its supply",
    ..Entry::FAULT
};

/// An armature that strikes its stop: a weak spring, a wrong payload, too much travel. Stops of
/// portable exciters sit at 0.2 to 10 mm.
pub static ARMATURE_STOP: Entry = Entry {
    id: "armature_stop",
    stage: Stage::Exciter,
    formula: "travel ends at a stop, velocity comes back with restitution",
    parameters: &[
        Parameter::linear("travel_m", "m", [1e-6, 1.0], 5e-4).on_site(2e-4, 0.01),
        Parameter::linear("restitution", "1", [0.0, 1.0], 0.4),
    ],
    plain: "the table strikes its stop",
    ..Entry::FAULT
};

/// A cable with a loose contact that vibration opens and closes.
pub static CABLE_INTERMITTENT: Entry = Entry {
    id: "cable_intermittent",
    stage: Stage::Conditioning,
    formula: "signal interrupted rate_hz times a second from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::linear("rate_hz", "Hz", [0.1, 1e4], 30.0).on_site(0.5, 500.0),
        Parameter::linear("open_fraction", "1", [0.0, 1.0], 0.3).on_site(1e-3, 0.5),
    ],
    plain: "a cable has a loose contact",
    ..Entry::FAULT
};

/// A broken coil or plug: no current, and the armature swings freely.
pub static COIL_OPEN: Entry = Entry {
    id: "coil_open",
    stage: Stage::Exciter,
    formula: "no current, no force from at_s on",
    parameters: &[AT_S],
    plain: "the coil or its plug is broken",
    ..Entry::FAULT
};

/// A short circuit at the exciter's terminals: the amplifier limits, the coil sees no voltage.
pub static COIL_SHORT: Entry = Entry {
    id: "coil_short",
    stage: Stage::Exciter,
    formula: "coil voltage 0 from at_s on, the coil brakes through its own resistance",
    parameters: &[AT_S],
    plain: "the shaker's terminals are short-circuited",
    ..Entry::FAULT
};

/// A device under test that falls off: the moving mass changes, its signal ends.
pub static DUT_FALLS_OFF: Entry = Entry {
    id: "dut_falls_off",
    stage: Stage::Mount,
    formula: "payload gone and its signal 0 from at_s on",
    parameters: &[AT_S],
    plain: "the device under test falls off",
    ..Entry::FAULT
};

/// An IEPE cable that opens: the supply's compliance voltage takes the bias's place.
pub static IEPE_OPEN: Entry = Entry {
    id: "iepe_open",
    stage: Stage::Conditioning,
    formula: "signal gone at at_s, bias jumps up and decays",
    parameters: IEPE,
    plain: "the cable of a transducer is open",
    ..Entry::FAULT
};

/// An IEPE cable with a short circuit: the bias falls to zero.
pub static IEPE_SHORT: Entry = Entry {
    id: "iepe_short",
    stage: Stage::Conditioning,
    formula: "signal gone at at_s, bias jumps down and decays",
    parameters: IEPE,
    plain: "the cable of a transducer is short-circuited",
    ..Entry::FAULT
};

/// An instrument in the sun, or out of a cold van: its processor takes another temperature.
pub static INSTRUMENT_TEMPERATURE: Entry = Entry {
    id: "instrument_temperature",
    stage: Stage::Environment,
    formula: "the processor is at celsius from at_s on",
    parameters: &[
        AT_S,
        Parameter::linear("celsius", "degrees Celsius", [-100.0, 200.0], 100.0)
            .on_site(-30.0, 110.0),
    ],
    plain: "the instrument is too hot or too cold",
    ..Entry::FAULT
};

/// A transducer that gives nothing any more.
pub static TRANSDUCER_DEAD: Entry = Entry {
    id: "transducer_dead",
    stage: Stage::Reference,
    formula: "signal 0 from at_s on",
    parameters: &[CHANNEL, AT_S],
    plain: "a transducer gives nothing any more",
    ..Entry::FAULT
};

/// A transducer whose sensitivity changes fast: a leak of charge, a crack, a mount that lets go.
pub static TRANSDUCER_FADING: Entry = Entry {
    id: "transducer_fading",
    stage: Stage::Reference,
    formula: "sensitivity 1 + per_s t from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::linear("per_s", "1/s", [-100.0, 100.0], -0.2).on_site(-1.0, 1.0),
    ],
    plain: "a transducer's sensitivity changes fast",
    ..Entry::FAULT
};

/// A transducer or its amplifier driven beyond its range, far from the converter's.
pub static TRANSDUCER_SATURATED: Entry = Entry {
    id: "transducer_saturated",
    stage: Stage::Conditioning,
    formula: "signal saturates at threshold_v from at_s on",
    parameters: &[
        CHANNEL,
        AT_S,
        Parameter::linear("threshold_v", "V", [1e-6, 10.0], 0.1).on_site(0.02, 5.0),
    ],
    plain: "a transducer is driven beyond its range",
    ..Entry::FAULT
};
