//! Actions from outside.

use super::effect::Effect;
use crate::model::AmbientMotion;
use calib_effects::environment;

pub(super) static EFFECTS: &[Effect] = &[Effect::new(
    &environment::AMBIENT_VIBRATION,
    |values, _conditions, model| {
        model.ambient = AmbientMotion {
            broadband_rms_ms2: values[0],
            tone_rms_ms2: values[1],
            tone_hz: values[2],
        };
    },
)];
