//! Closing the loop: the named effect in the emulated rig, under the shipping firmware.
//!
//! The rig of the dataset is simulated in time, with the nominal values the diagnosis fitted, once
//! as it is and once with the effect. The firmware measures points of the dataset on both, and its
//! records are compared with what was measured.

use super::compared::{Compared, by_observable, overall};
use super::known::Known;
use super::measured::{Condition, Row, conditions};
use super::recorded::{Setting, record, under};
use crate::emulated::{EmulatedBoard, settings_for};
use crate::{Error, Result};
use calib_core::point::PointSpec;
use calib_core::settings::Settings;
use calib_gap::{Answer, Cause, Confirmation, Verdict};
use calib_link::Client;
use calib_link::session;
use calib_twin::dataset::{Nominal, Point};
use calib_twin::effects::{ActiveEffect, CalibratorAction, Effect, EffectError};
use calib_twin::rig::Rig;
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::path::Path;

/// Blocks averaged at each point: enough for a comparison in per cent, and, with captures, for one
/// to be taken while the level is held.
const BLOCKS: u16 = 3;
const BLOCKS_WITH_CAPTURE: u16 = 10;

/// Adds the most probable cause of `answer` to the emulated rig of the dataset in `folder`, and
/// compares. Nothing to confirm gives `None`.
///
/// # Errors
/// [`Error::Input`] for a dataset of an oscillator, one without levels, or without a firmware image;
/// those of the link.
pub fn confirm(folder: &Path, answer: &Answer) -> Result<Option<Confirmation>> {
    let claimed = answer.causes.first().filter(|c| !c.effects.is_empty());
    let Some(cause) = claimed.filter(|_| !matches!(answer.verdict, Verdict::NoGap | Verdict::Data))
    else {
        return Ok(None);
    };
    let mut nominal = Known::load(folder)?.nominal;
    take_fitted(&mut nominal, answer);
    let effects = cause
        .effects
        .iter()
        .map(|id| effect(id, cause))
        .collect::<Result<Vec<_>>>()?;
    let runs: Vec<(Condition, bool)> = conditions(folder, &nominal)?
        .into_iter()
        .flat_map(|condition| [(condition.clone(), false), (condition, true)])
        .collect();
    let emulated: Vec<Vec<Option<Point>>> = runs
        .par_iter()
        .map(|(condition, with_effect)| {
            let effects = if *with_effect {
                effects.clone()
            } else {
                Vec::new()
            };
            emulate(&nominal, condition, effects)
        })
        .collect::<Result<_>>()?;
    let mut rows = Vec::new();
    let mut refused = 0;
    for (pair, (condition, _)) in emulated.chunks(2).zip(runs.iter().step_by(2)) {
        let both = pair[0].iter().zip(&pair[1]);
        for (measured, (before, after)) in condition.rows.iter().zip(both) {
            match (before, after) {
                (Some(before), Some(after)) => rows.push(Compared {
                    measured,
                    before,
                    after,
                }),
                _ => refused += 1,
            }
        }
    }
    let by_observable = by_observable(&rows);
    Ok(Some(Confirmation {
        effects: effects.iter().map(ToString::to_string).collect(),
        gap: overall(&by_observable),
        by_observable,
        refused,
    }))
}

/// Nominal values as the diagnosis fitted them within their uncertainties.
fn take_fitted(nominal: &mut Nominal, answer: &Answer) {
    let exciter = &mut nominal.exciter;
    for (name, quantity) in [
        ("moving_mass_kg", &mut exciter.moving_mass_kg),
        ("stiffness_n_per_m", &mut exciter.stiffness_n_per_m),
        ("damping_ns_per_m", &mut exciter.damping_ns_per_m),
        ("force_factor_n_per_a", &mut exciter.force_factor_n_per_a),
        ("coil_resistance_ohm", &mut exciter.coil_resistance_ohm),
        ("coil_inductance_h", &mut exciter.coil_inductance_h),
    ] {
        if let Some(fitted) = answer.nominal_parameters.get(name) {
            quantity.value = fitted.value;
        }
    }
}

/// The named effect with its fitted values, as far as the twin knows them by name and allows them.
fn effect(id: &str, cause: &Cause) -> Result<ActiveEffect> {
    let fitted = cause.parameters.get(id);
    let known =
        Effect::<CalibratorAction>::named(id).map_or(&[][..], |effect| effect.entry.parameters);
    let values: Vec<String> = known
        .iter()
        .filter_map(|parameter| {
            let value = fitted?.get(parameter.name)?.value;
            let value = value.clamp(parameter.simulated[0], parameter.simulated[1]);
            Some(format!("{}:{value}", parameter.name))
        })
        .collect();
    let text = match values.as_slice() {
        [] => id.to_owned(),
        some => format!("{id}={}", some.join(",")),
    };
    text.parse().map_err(|error: EffectError| {
        Error::input(
            id,
            error.to_string(),
            "the twin has no such effect: leave --confirm out for this cause",
        )
    })
}

/// The firmware's records of one condition as rows; `None` where it refused.
fn emulate(
    nominal: &Nominal,
    condition: &Condition,
    effects: Vec<ActiveEffect>,
) -> Result<Vec<Option<Point>>> {
    let believed = believed_rig(nominal, &condition.setting);
    let known = Known::of(&believed);
    let mut rig = under(&believed, &condition.setting, nominal, condition.start_s);
    rig.effects = effects;
    let specs: Vec<PointSpec> = condition.rows.iter().map(Row::spec).collect();
    let board = EmulatedBoard::power_on(&rig)?;
    let mut client = Client::new(Box::new(board.link()));
    client.info()?;
    // The calibration of the reference as it is believed to be: what an effect does to it the
    // instrument cannot know.
    let settings = settings_for(&rig, client.settings()?, None);
    let settings = Settings {
        blocks: match condition.has_harmonics() {
            true => BLOCKS_WITH_CAPTURE,
            false => BLOCKS,
        },
        ..settings
    };
    board.set_up(&mut client, settings)?;
    let go_on = |_: &session::Progress<'_>, _: &[PointSpec]| ControlFlow::Continue(());
    let mut rows = record(
        &mut client,
        &known,
        &specs,
        &condition.setting,
        condition.start_s,
        condition.has_harmonics(),
        go_on,
    )?
    .rows;
    // A run that ends early has fewer.
    rows.resize(specs.len(), None);
    Ok(rows)
}

/// The rig a dataset believes in. What it does not state, such as filters, is that of the usual
/// rig; being known, it is taken out of the rows again.
fn believed_rig(nominal: &Nominal, setting: &Setting) -> Rig {
    let mut rig = Rig::standard();
    // Nobody believes in an error of his converters.
    (rig.converter.errors, rig.converter.dither_peak_v) = (0.0, 0.0);
    let exciter = &nominal.exciter;
    rig.exciter.moving_mass_kg = exciter.moving_mass_kg.value;
    rig.exciter.stiffness_n_per_m = exciter.stiffness_n_per_m.value;
    rig.exciter.damping_ns_per_m = exciter.damping_ns_per_m.value;
    rig.exciter.force_factor_n_per_a = exciter.force_factor_n_per_a.value;
    rig.exciter.coil_resistance_ohm = exciter.coil_resistance_ohm.value;
    rig.exciter.coil_inductance_h = exciter.coil_inductance_h.value;
    rig.exciter.payload_kg = setting.payload_kg;
    let reference = nominal.reference.sensitivity_v_per_ms2.value;
    let dut = nominal.dut.sensitivity_v_per_ms2.value;
    for (sensing, value) in [(&mut rig.reference, reference), (&mut rig.dut, dut)] {
        sensing.sensitivity_v_per_ms2 = value;
        sensing.conditioner_gain = 1.0;
    }
    rig.surroundings.mains_hz = nominal.environment.mains_hz;
    rig
}
