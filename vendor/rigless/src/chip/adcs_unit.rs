// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! An attitude determination and control unit on a serial line, speaking the CubeADCS UART protocol:
//! [`Unit`], which answers telecommands, keeps what they set, and answers telemetry requests with
//! frames of exactly the length each one has, filled from the attitude, the orbit, the field, the
//! sun and the GPS time the world hands it. It keeps its modes, takes manual magnetorquer and wheel
//! commands, runs B-dot detumbling and Y-Thomson spin on its magnetorquers, Y-momentum and
//! three-axis nadir and Sun pointing on its wheels, propagates the element set the ground uploads
//! with its own SGP4, and matches Ex-Alta 2's attitude unit as its flight software's driver talks
//! to it.
//!
//! **A frame.** `1F 7F`, an ID and its data, then `1F FF`. A `1F` inside is sent twice. An ID under
//! 128 is a telecommand, which the unit answers with `1F 7F`, the ID, an error code and `1F FF`, 0
//! for none. Three telecommands get no answer: reset, run selected program and initiate download
//! burst. An ID of 128 or more is a telemetry request, which the unit answers with `1F 7F`, the ID,
//! the telemetry and `1F FF`. Numbers in telemetry are little-endian.
//!
//! **What the world hands it.** The board hands the unit its position and velocity in the Earth's
//! frame, the GPS time the run starts from, the attitude as Shuster's quaternion that takes inertial
//! coordinates to body ones, scalar first, the body's angular rate, the magnetic field and the
//! sun's direction on the body's axes, whether the spacecraft is in the Earth's shadow, and the
//! count of GPS satellites its receiver tracks. Until the ground uploads an element set, the unit's
//! estimates are those quantities, so what it reports is the truth in its own units and frames.
//! Once it has one, its orbit is SGP4's and its attitude what its sensors fix against that orbit,
//! so both leave the truth as the element set ages. The inertial frame turns with the Earth by
//! the mean sidereal angle alone. The orbit frame has `z` to the Earth's center, `y` against the
//! orbit's normal and `x` completing it, and the attitude angles are roll, pitch and yaw of the
//! body from it, turned yaw first.
//!
//! **Where the facts come from.** This is an independent model. It is not affiliated with or
//! endorsed by AlbertaSat or CubeSpace. No CubeSpace document was used. The IDs, the lengths, the
//! field layouts and the scales are read from what Ex-Alta 2's flight software sends and parses:
//! `ex2_hal/adcs/equipment_handler/src/adcs_io.c`, `adcs_handler.c` and `inc/adcs_types.h` in
//! AlbertaSat's public `ex2_obc_software`, `HAL_ADCS_getHK` in
//! `ex2_hal/adcs/hardware_interface/source/adcs.c`, and the ADCS watchdog in
//! `ex2_system/source/diagnostic/diagnostic.c`. What the unit does with them, every default and
//! every rule about when it answers what, is this model's own.
//!
//! **The controllers.** While the run mode is the 1 Hz loop (1), the unit runs its controller once a
//! second on the field it measures, the field the measurements (191) report, and drives the
//! magnetorquers with the dipole it asks for, a duty of 1000 thousandths being 0.2 A·m² on each axis.
//! Detumbling (control mode 1) is B-dot, `m = −k_d Ḃ`, with `Ḃ` the change in the measured field
//! over the last second. It turns the field's motion through the body against itself, which takes
//! the body's rate away (Markley and Crassidis, *Fundamentals of Spacecraft Attitude Determination
//! and Control*, Springer 2014, Section 7.5). Y-Thomson (control mode 2) spins the body about `y`
//! at the reference rate `ω_ref` and damps the other two axes. Damping is the same B-dot, taken on
//! the field as a frame turning with the body's `y` rate sees it, `Ḃ + ω_y ŷ × B`, so it leaves the
//! spin alone. The spin is the cross-product law of the same section, `m = B × τ / |B|²` for the
//! torque `τ = k_s I_yy (ω_ref − ω_y) ŷ`. The gains, the reference rate and `I_yy` are what the
//! ground uploads in the detumbling configuration (38) and the inertia (41), and
//! [`DEFAULT_CONTROL`] until it does.
//!
//! **The orbit and the estimate.** The SGP4 orbit (45) is an element set's mean elements and epoch.
//! The unit propagates it with the crate's own SGP4 at the GPS time its receiver gives, so its
//! orbit leaves the truth by however far the element set's model and the real orbit drift apart.
//! Once a second the loop fixes the attitude by TRIAD: the nadir its nadir sensor measures, held
//! exactly, and the Sun its Sun sensor measures, against the nadir SGP4 puts it at and the Sun's
//! direction by the U.S. Naval Observatory's "Approximate Solar Coordinates". In the Earth's shadow
//! the second vector is the orbit's normal as the last estimate turned by the rate sensors puts it
//! on the body, so the nadir keeps roll and pitch and the rate sensors carry yaw. TRIAD is Black's
//! (1964), as Shuster and Oh write it ("Three-axis attitude determination from vector
//! observations", Journal of Guidance and Control 4(1), 1981).
//!
//! **The wheel controllers.** Each runs once a second on that estimate and commands the wheels a
//! speed in rpm, the change held to a 1 mN·m motor and the speed to ±8000 rpm. Nadir pointing (5)
//! holds the orbit frame turned by the commanded angles (15). Sun pointing (6) holds the Sun facet
//! the reaction wheel configuration (40) names on the Sun, with the axis after it as near the orbit
//! frame's `y` as it goes. Both are quaternion feedback with the body's gyroscopic torque and the
//! magnetorquers' own taken out:
//!
//! `τ = −J (k_p 2q_v + k_d δω) + ω × (J ω + h) − m × B`
//!
//! Here `q_v` is the error quaternion's vector and `δω` the rate against the target's. The
//! magnetorquers dump the wheels toward the bias momentum by the cross-product law,
//! `m = B × τ_d / |B|²` for `τ_d = −k (h − h_bias)`. Y-momentum (3 initial, 4 steady) spins the
//! `y` wheel to the momentum the Y-momentum configuration (39) sets and damps the body's turning
//! against the orbit frame by B-dot. It also steers the total momentum, `J ω + h`, to the one it
//! has turning with the orbit, which takes roll and yaw out. Steady Y-momentum adds pitch on the
//! `y` wheel. Markley and Crassidis cover these laws in their attitude control chapter. The book
//! wasn't on hand to name the sections, so none is cited here.
//!
//! | Behavior | Source | Test |
//! |---|---|---|
//! | Framing: `1F 7F` opens, `1F FF` closes, `1F 1F` is a `1F`, and anything else after a `1F` drops the frame. So does a frame past 174 bytes, the longest telecommand with its ID | `send_uart_telecommand` and `request_uart_telemetry` | `an_escaped_byte_inside_a_frame_is_one_byte`, `a_frame_past_the_longest_telecommand_is_dropped` |
//! | Telecommand reply: `1F 7F`, the ID, the error and `1F FF`. The error is 0 taken, 1 an ID it doesn't know, 2 the wrong length and 3 a parameter out of range: a mode past its range, a boot index other than 1, or a reset without the magic number 0x5A. Reset, run program and download burst get none | `send_uart_telecommand`, which reads six bytes and takes the fourth, `ADCS_returnState` for the codes, `ADCS_set_boot_index` and `ADCS_reset` for the values they send, and `send_uart_telecommand_no_reply` for `ADCS_reset`, `ADCS_run_selected_program` and `ADCS_initiate_download_burst` | `a_telecommand_is_answered_with_its_error`, `the_modes_are_kept_and_refused_past_their_range`, `the_three_telecommands_with_no_reply_get_none`, `the_boot_status_answers_the_watchdog`, `a_reset_without_its_magic_number_does_nothing` |
//! | Telemetry reply: `1F 7F`, the ID, exactly the length the ID has with each `1F` sent twice, and `1F FF`. An ID it doesn't know gets no data | `request_uart_telemetry`, which reads to `1F FF` and makes each doubled `1F` one | `every_telemetry_id_answers_its_exact_length` |
//! | Lengths: [`TELECOMMANDS`] and [`TELEMETRY`], each of the 70 telecommand IDs and 56 telemetry IDs the driver uses | The length each `ADCS_set_` and `ADCS_get_` function of `adcs_handler.c` sends or reads | `every_telemetry_id_answers_its_exact_length`, `a_telecommand_is_answered_with_its_error` |
//! | SGP4 orbit (45): eight little-endian `f64`s, inclination, eccentricity, right ascension, argument of perigee, B*, mean motion in revolutions a day, mean anomaly, and the epoch as `YYDDD.DDDDDDDD` UTC. One SGP4 can't carry, a deep-space period, an eccentricity outside `[0, 1)`, a value that isn't a number or an epoch day outside 1 to 366, is refused with error 3 | `ADCS_set_sgp4_orbit_params`, which sends each `f64` low byte first, and `adcs_sgp4`'s field order and units | `an_orbit_sgp4_cannot_carry_is_refused`, `the_configurations_read_back` |
//! | SGP4: Spacetrack Report No. 3 Section 6, with AIAA 2006-6753's constants (Table 2), small-eccentricity drag (Table 1) and Kepler's equation (Section VI.E), near-Earth sets only | Hoots and Roehrich 1980, Vallado and others 2006 | `near_earth_sets_match_the_reference_ephemerides` in `chip::sgp4` |
//! | The orbit estimate: with an element set, the state (190) and the position (150) report SGP4's orbit at the receiver's GPS time, and the receiver's fix before one | This model's | `an_uploaded_orbit_says_where_the_state_puts_the_spacecraft`, `the_estimate_drifts_as_the_element_set_ages` |
//! | The attitude estimate: TRIAD of the measured nadir and Sun against SGP4's nadir and the Sun's model, once a second while the 1 Hz loop runs, the orbit's normal and the rate sensors standing in for the Sun in shadow. The state (190) reports it against the estimated orbit frame | Black's TRIAD as Shuster and Oh write it, the USNO's approximate solar coordinates | `the_estimate_drifts_as_the_element_set_ages`, `the_sun_crosses_the_equator_at_the_equinox_and_tops_out_at_the_solstice` |
//! | Wheel controllers: Y-momentum initial (3) and steady (4), nadir pointing (5) and Sun pointing (6) drive [`Unit::wheel_speeds`] and [`Unit::magnetorquers`] once a second while the 1 Hz loop runs. A wheel's change is held to 1 mN·m for the second and its speed to ±8000 rpm, the range AlbertaSat's ground software documents for wheel speed (17). Actuator (192) and the measurements (191) read the speeds | Y-momentum's numbers, 3 and 4, are `commissioning_initial_y_momentum_activation`'s in `adcs_binary_test.c`. No public source numbers nadir and Sun pointing, so 5 and 6 are this model's | `a_wheel_mode_drives_the_wheels`, `nadir_pointing_holds_the_orbit_frame`, `nadir_pointing_holds_the_commanded_angles`, `sun_pointing_holds_the_x_face_on_the_sun`, `y_momentum_holds_the_orbit_frame` |
//! | Pointing accuracy: nadir and Sun pointing hold the body within 0.25° of the target, Sun pointing's facet on the Sun likewise, in sunlight and shadow, with an element set a few hours old. Steady Y-momentum holds pitch within 0.5° and roll and yaw within 5°. An older element set adds its own error, the along-track miss over the orbit's radius, about 0.01° a kilometer | This model's, from its own flight under the gravity gradient | `nadir_pointing_holds_the_orbit_frame`, `sun_pointing_holds_the_x_face_on_the_sun`, `y_momentum_holds_the_orbit_frame` |
//! | Wheel settings: Y-momentum configuration (39) is the momentum steering gain in 1/s, the nutation damping B-dot gain, the pitch gains in 1/s² and 1/s, and the `y` wheel's momentum in N·m·s. Reaction wheel configuration (40) is the pointing gains in 1/s² and 1/s, the bias momentum in N·m·s, then the Sun facet in the last byte's low seven bits, 0 to 5 for `+x`, `+y`, `+z`, `−x`, `−y` and `−z`. Inertia (41) gives the whole tensor. A gain that isn't a number or a facet past 5 is refused with error 3. Until they're set the unit uses [`DEFAULT_POINTING`] | `ADCS_set_ywheel_config` and `ADCS_set_rwheel_config`, which send each `f32` low byte first, `ywheel_ctrl_config` and `rwheel_ctrl_config` for the order. The facet's numbering is this model's | `the_ground_s_wheel_settings_set_the_pointing` |
//! | Modes: run mode (10) takes 0 to 3, control mode (13) 0 to 15 and estimation mode (14) 0 to 7, and the state (190) reports them with the SGP4 mode (31). A mode past its range is refused and the old one stays | `ADCS_set_enabled_state`, `ADCS_set_attitude_ctrl_mode`, `ADCS_set_attitude_estimate_mode` and their ranges, `ADCS_set_ASGP4_rune_mode`, `ADCS_get_current_state` | `the_modes_are_kept_and_refused_past_their_range`, `what_a_telecommand_sets_reads_back` |
//! | Kept settings: cache (3), SRAM scrub size (8), time save (9), power (11), commanded angles (15) and inertial reference (34) read back in 131, 134, 145, 197, 199 and 238 | The `ADCS_set_` and `ADCS_get_` pairs of cache, SRAM scrub size, unix time save, power control, attitude angle and inertial reference | `what_a_telecommand_sets_reads_back` |
//! | Configurations: camera sensors (25), system (30), SGP4 orbit (45), track target (55) and the three logs (104 to 106) read back in 203, 225, 207, 200, 235, 236 and 237, each telemetry the telecommand's parameters from its first byte | Each `ADCS_get_` function parses byte n where its `ADCS_set_` twin writes byte n+1 | `the_configurations_read_back` |
//! | Manual actuators: magnetorquer output (16), in thousandths of full duty, and wheel speed (17), in rpm, drive [`Unit::magnetorquers`] and [`Unit::wheel_speeds`] while the run mode isn't 0 and the control mode is none (0), and read zero otherwise. Actuator (192) reads what they drive | `ADCS_set_magnetorquer_output`, `ADCS_set_wheel_speed` and the control mode none they ask for, `ADCS_get_actuator` | `manual_commands_drive_while_the_loop_runs_with_no_control` |
//! | Controllers: while the run mode is the 1 Hz loop (1), detumbling (control mode 1) and Y-Thomson (2) drive [`Unit::magnetorquers`] once a second, a full duty of 1000 thousandths being 0.2 A·m² and each axis held to it. The first second after a controller starts has no `Ḃ` and drives nothing. Actuator (192) reads what they drive. A control mode past Sun pointing (6), or a run mode other than the 1 Hz loop, drives nothing | The run mode's 1 Hz loop in `ADCS_set_enabled_state`, the modes' numbers in `DETUMBLING_MODE` and `Y_THOMSON_MODE` of `adcs_binary_test.h`. The laws are Markley and Crassidis Section 7.5's B-dot and cross-product laws | `detumbling_is_b_dot_once_a_second`, `y_thomson_spins_the_body_about_y`, `detumbling_takes_a_tumble_away`, `a_controller_drives_while_its_loop_runs` |
//! | Controller settings: detumbling configuration (38) is the spin gain `k_s` in 1/s, the damping gain `k_d` in A·m²·s/T, both little-endian `f32`, the reference rate in thousandths of a degree a second as an `i16`, and the fast B-dot gain. Inertia (41) is six little-endian `f32`s in kg·m², `I_xx`, `I_yy`, `I_zz`, then the products. A value that isn't a finite number is refused with error 3 and the old setting stays. Until they're set the unit uses [`DEFAULT_CONTROL`] | `ADCS_set_detumble_config`, which swaps each `f32` to little-endian on the big-endian part and scales the rate by 1000, and `ADCS_set_MoI_mat`, which sends each `f32` low byte first | `the_ground_s_gains_and_inertia_set_the_controllers`, `a_setting_that_is_not_a_number_is_refused` |
//! | Boot and program status (129): reset cause and boot cause 0, the boots since power on, program index 1 and firmware 7.2. Boot index (130) reads program index 1 and a boot status of 0. Boot index (100) takes 1, the only index the flight software sends, and refuses any other. Bootloader state (132) counts the seconds since the unit started | `ADCS_get_boot_program_stat`, which the OBC's ADCS watchdog asks for, `ADCS_set_boot_index`, `ADCS_get_boot_index` and `ADCS_get_bootloader_state` | `the_boot_status_answers_the_watchdog` |
//! | Power | When its supply goes the unit forgets what a reset clears and its resets since power on, and drops a frame it was hearing and the replies it hadn't sent. It starts as it does at power on when the supply comes back. What the board hands it stays | assumption: no public document says what the unit outlives | `power_on_forgets_what_the_unit_kept` |
//! | Clock: set unix time (2) sets it, and it counts on with the run. Unix time (140) reads it, seconds then milliseconds | `ADCS_set_unix_t` and `ADCS_get_unix_t` | `the_clock_counts_on_from_what_was_set` |
//! | Counters: comms status (144) counts the telecommands and telemetry requests taken, and the acknowledge (240) is the last telecommand, processed, and its error | `ADCS_get_comms_stat` and `ADCS_get_TC_ack` | `what_a_telecommand_sets_reads_back`, `housekeeping_reads_the_world_in_its_order` |
//! | State (190): modes, then the attitude angles at 0.01°, the orbit-referenced quaternion's vector at 0.0001, the rate at 0.01°/s, the inertial position at 0.25 km and velocity at 0.25 m/s, latitude, longitude at 0.01° and altitude at 0.01 km, and the Earth-frame position in kilometers | `ADCS_get_current_state` | `the_state_reports_the_world`, `a_turn_of_the_body_reads_as_its_angles_and_nadir`, `housekeeping_reads_the_world_in_its_order` |
//! | Measurements (191): the field at 0.01 µT, the coarse and fine sun at 0.0001 and zero in shadow, the nadir at 0.0001 and the rate at 0.01°/s, all on the body's axes, then the wheels' speed in rpm as ideal wheels at the speed they're driven at, which is what the board's outputs carry | `ADCS_get_measurements` | `the_measurements_report_the_world`, `a_turn_of_the_body_reads_as_its_angles_and_nadir`, `housekeeping_reads_the_world_in_its_order`, `manual_commands_drive_while_the_loop_runs_with_no_control` |
//! | Estimation (193): the modeled field and sun as the measurements read them, and every bias, innovation, error and covariance zero | `ADCS_get_estimation` | `the_estimation_and_the_raw_gps_report_the_world` |
//! | Raw GPS (210): solution status 0, the satellites tracked and used, the GPS week and milliseconds into it, each axis's Earth-frame position in meters and velocity in meters a second, and deviations of zero | `ADCS_get_raw_GPS` | `the_estimation_and_the_raw_gps_report_the_world` |
//! | Position (150): latitude, longitude at 0.01° and altitude at 0.01 km | `ADCS_get_sat_pos_LLH` | `the_state_reports_the_world`, `housekeeping_reads_the_world_in_its_order` |
//! | Power and temperature (195): a bench's control 3.3 V 50 mA, 5 V 20 mA, battery 10 mA, the processor at 25 °C, both magnetometers at 22 °C and the rate sensors at 25 °C. Once the board sets the unit's temperature with [`Unit::set_temperature`], the processor, both magnetometers and the rate sensors read it instead, the processor and the rate sensors in whole degrees and the magnetometers in tenths | `ADCS_get_power_temp` for the scales | `every_telemetry_id_answers_its_exact_length`, `housekeeping_reads_the_world_in_its_order`, `the_temperatures_read_what_the_board_sets` |
//! | Node (128): node type 10, interface 1, firmware 7.2, and the seconds and milliseconds since the unit last started | `ADCS_get_node_identification` | `the_clock_counts_on_from_what_was_set` |
//! | Reset (1), with the magic number 0x5A: every setting, command, counter and the clock back to how the unit starts, and one more boot | `ADCS_reset` | `the_three_telecommands_with_no_reply_get_none`, `the_boot_status_answers_the_watchdog`, `a_reset_without_its_magic_number_does_nothing` |
//! | Every other telemetry: its exact length in zeros, which is a healthy unit with nothing to report | Each `ADCS_get_` function's length | `every_telemetry_id_answers_its_exact_length` |
//! | Snapshot: everything it keeps | not applicable | `a_snapshot_keeps_a_frame_half_heard` |
//!
//! **Left out.**
//!
//! | Behavior | Reason |
//! |---|---|
//! | Estimation modes and the estimation configuration (27) | The estimate is the same TRIAD in every estimation mode, and the configuration is kept and read by nothing. With no element set the estimates are the truth |
//! | Sensor noise and biases | Every sensor reads the world exactly, to its telemetry's resolution, so the estimate's error is the orbit's and the Sun model's alone |
//! | The field model in estimation (193) | The unit has no field model, so the modeled field reads the measured one |
//! | Control modes past Sun pointing, the tracking controller (54, 55), the inertial reference (34) and the fast B-dot gain | The unit models modes 1 to 6. The rest are kept and read by no controller |
//! | The reaction wheel configuration's auto-transit bit, and the control mode's timeout | Kept and read by nothing. A mode stays until a telecommand changes it |
//! | SGP4's deep-space part and ASGP4 | An element set with a period of 225 minutes or more is refused, and the ASGP4 mode (31) is kept and read by nothing |
//! | The triggered loop (run mode 2) and simulation (3) | No controller runs in either |
//! | Measuring the field with the magnetorquers off | The board's field carries nothing of the magnetorquers' own, so the unit measures and drives in the same instant |
//! | Star trackers, cameras and raw sensors measured | They read zero in the measurements (191), and the raw sensors (194), star tracker (211) and second magnetometer (215) read zero. The flight software gives no scale for the raw counts |
//! | Wheel dynamics | The unit takes a wheel to be at the speed it commands. The plant's own speed loop gets it there |
//! | The magnetorquers' on-time in actuator (192) | It reads the duty as magnetorquer output (16) sent it, since the flight software gives no conversion between the two. The flight software decodes that slot as on-time in seconds ×10, so housekeeping shows 2.5 s for a duty of 250 |
//! | The full configuration (206) | It's made of the configuration telecommands' parameters in an order the flight software doesn't give, so it reads zero |
//! | The file system, download bursts and uploads | The unit has no files, so a burst sends nothing |
//! | Reply latency | A reply is on the line as the request's last byte arrives |

use std::collections::{BTreeMap, VecDeque};
use std::ops::RangeInclusive;

use crate::chip::Timeline;
use crate::chip::earth::{
    EARTH_RATE, Geodetic, GpsTime, atan2, days_to_year, inertial, nearest, nearest_i16, sin_cos,
};
use crate::chip::sgp4::{Elements, Sgp4};
use crate::chip::uart::Peer;
use crate::snapshot::store;
use crate::soc::{Access, FieldSpec};
use crate::time::{EventId, VirtualNanos};

const ESCAPE: u8 = 0x1F;
const START: u8 = 0x7F;
const END: u8 = 0xFF;
/// The first telemetry ID.
const TELEMETRY_IDS: u8 = 128;
/// The longest frame the unit takes, system configuration (30) with its ID.
const LONGEST_FRAME: usize = 174;

/// What a telecommand's error says.
const TAKEN: u8 = 0;
const UNKNOWN: u8 = 1;
const WRONG_LENGTH: u8 = 2;
const INVALID: u8 = 3;

/// The telecommands that get no reply: reset, run selected program, initiate download burst.
const SILENT: [u8; 3] = [1, 101, 119];
const RESET: u8 = 1;
const SET_TIME: u8 = 2;
const RUN_MODE: u8 = 10;
const CONTROL_MODE: u8 = 13;
const ESTIMATION_MODE: u8 = 14;
const MAGNETORQUERS: u8 = 16;
const WHEEL_SPEEDS: u8 = 17;
const ANGLES: u8 = 15;
const SGP4_MODE: u8 = 31;
const DETUMBLE_SETTINGS: u8 = 38;
const Y_WHEEL_SETTINGS: u8 = 39;
const WHEEL_SETTINGS: u8 = 40;
const INERTIA: u8 = 41;
const ORBIT: u8 = 45;
const BOOT_INDEX: u8 = 100;

/// The run mode whose loop runs the controllers once a second.
const LOOP_AT_1_HZ: u8 = 1;
const DETUMBLING: u8 = 1;
const Y_THOMSON: u8 = 2;
const Y_MOMENTUM_START: u8 = 3;
const Y_MOMENTUM: u8 = 4;
/// Three-axis nadir and Sun pointing on the wheels. No public source numbers them, so these are
/// this model's.
const NADIR_POINTING: u8 = 5;
const SUN_POINTING: u8 = 6;
/// The controllers' period, the 1 Hz loop's.
const CONTROL_PERIOD: u64 = 1_000_000_000;
const CONTROL_PERIOD_SECONDS: f64 = 1.0;
/// Each magnetorquer's dipole at a full duty of 1000 thousandths, in A·m².
// ceiling: no public document gives Ex-Alta 2's magnetorquers' dipole, so it's a 3U's typical rod
const FULL_DUTY_DIPOLE: f64 = 0.2;
const FULL_DUTY: f64 = 1000.0;
/// Each wheel's inertia about its axis in kg·m², the most torque its motor gives in N·m, and the
/// fastest it's commanded, the ±8000 rpm AlbertaSat's ground software documents for wheel speed (17).
// ceiling: no public document gives Ex-Alta 2's wheels' inertia or torque, so they're a small wheel's
const WHEEL_INERTIA: f64 = 2e-5;
const WHEEL_TORQUE: f64 = 1e-3;
const WHEEL_RPM: f64 = 8000.0;
const RPM_PER_RADIAN_SECOND: f64 = 60.0 / std::f64::consts::TAU;
/// How fast the magnetorquers take the wheels' momentum away from its bias, per second.
const DUMPING_GAIN: f64 = 0.002;
/// The least angle between the nadir and the Sun at which the two fix an attitude, 5°, as its sine.
const SHARPEST: f64 = 0.087_155_742_747_658_17;

/// What the controllers act with: the gains, the spin's reference rate and the inertia about `y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Control {
    /// The spin gain `k_s`, in 1/s.
    pub spin_gain: f64,
    /// The damping gain `k_d`, in A·m²·s/T.
    pub damping_gain: f64,
    /// The Y-Thomson spin's reference rate, in degrees a second.
    pub spin_rate: f64,
    /// The body's moment of inertia about `y`, in kg·m².
    pub inertia_yy: f64,
}

/// What the controllers act with until the ground sets them. The damping gain takes a 3U's tumble of
/// 10°/s about each axis to under 1°/s in under an orbit at 500 km, saturating the magnetorquers at
/// first. The inertia is a 3U's of 4 kg about a long axis. They're this model's, since no public
/// document gives Ex-Alta 2's.
pub const DEFAULT_CONTROL: Control = Control {
    spin_gain: 0.01,
    damping_gain: 50_000.0,
    spin_rate: 2.0,
    inertia_yy: 0.035,
};

/// What the wheel controllers act with: the Y-momentum configuration (39), the reaction wheel
/// configuration (40) and the inertia (41).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pointing {
    /// Y-momentum's gain on the total momentum through the magnetorquers, in 1/s.
    pub y_control_gain: f64,
    /// Y-momentum's nutation damping, a B-dot gain in A·m²·s/T.
    pub y_damping_gain: f64,
    /// Y-momentum's pitch gain on the `y` wheel, in 1/s².
    pub y_proportional_gain: f64,
    /// Y-momentum's pitch rate gain on the `y` wheel, in 1/s.
    pub y_derivative_gain: f64,
    /// The `y` wheel's momentum Y-momentum holds, in N·m·s.
    pub y_momentum: f64,
    /// Three-axis pointing's gain on the attitude, in 1/s².
    pub proportional_gain: f64,
    /// Three-axis pointing's gain on the rate, in 1/s.
    pub derivative_gain: f64,
    /// The `y` wheel's momentum three-axis pointing dumps toward, in N·m·s.
    pub bias_momentum: f64,
    /// The face Sun pointing turns to the Sun: 0 to 5 for `+x`, `+y`, `+z`, `−x`, `−y` and `−z`.
    pub sun_facet: u8,
    /// The inertia tensor, in kg·m².
    pub inertia: [[f64; 3]; 3],
}

/// What the wheel controllers act with until the ground sets it, this model's own. Pointing's gains
/// give a natural frequency of 0.1 rad/s, critically damped, with the inertia of
/// [`DEFAULT_CONTROL`]'s 3U. Y-momentum holds 4 mN·m·s, about 1900 rpm, along the orbit's normal.
pub const DEFAULT_POINTING: Pointing = Pointing {
    y_control_gain: 0.002,
    y_damping_gain: 5000.0,
    y_proportional_gain: 0.01,
    y_derivative_gain: 0.2,
    y_momentum: -0.004,
    proportional_gain: 0.01,
    derivative_gain: 0.2,
    bias_momentum: 0.0,
    sun_facet: 0,
    inertia: [[0.035, 0.0, 0.0], [0.0, 0.035, 0.0], [0.0, 0.0, 0.007]],
};

/// The values each telecommand with a range takes: the modes as the driver's
/// `ADCS_set_enabled_state`, `ADCS_set_attitude_ctrl_mode` and `ADCS_set_attitude_estimate_mode`
/// give their ranges, the one program index `ADCS_set_boot_index` sends, and the magic number
/// `ADCS_reset` sends.
const PARAMETER_RANGES: [(u8, RangeInclusive<u8>); 5] = [
    (RUN_MODE, 0..=3),
    (CONTROL_MODE, 0..=15),
    (ESTIMATION_MODE, 0..=7),
    (BOOT_INDEX, PROGRAM..=PROGRAM),
    (RESET, MAGIC..=MAGIC),
];
const MAGIC: u8 = 0x5A;
/// The reaction wheel configuration's last byte: the Sun facet below the auto-transit bit.
const FACET: u8 = 0x7F;
const CONTROL_NONE: u8 = 0;
const PROGRAM: u8 = 1;

/// Each telecommand's ID and the lengths it takes with its ID.
pub const TELECOMMANDS: &[(u8, &[usize])] = &[
    (1, &[2]),
    (2, &[7]),
    (3, &[2]),
    (4, &[1]),
    (5, &[1]),
    (6, &[1]),
    (7, &[1, 2]),
    (8, &[3]),
    (9, &[3]),
    (10, &[2]),
    (11, &[4]),
    (12, &[2]),
    (13, &[4]),
    (14, &[2]),
    (15, &[7]),
    (16, &[7]),
    (17, &[7]),
    (18, &[1]),
    (19, &[128]),
    (21, &[4]),
    (22, &[5]),
    (23, &[11]),
    (24, &[22]),
    (25, &[113]),
    (27, &[32]),
    (28, &[31]),
    (29, &[97]),
    (30, &[174]),
    (31, &[2]),
    (32, &[1]),
    (33, &[2]),
    (34, &[7]),
    (36, &[31]),
    (37, &[54]),
    (38, &[15]),
    (39, &[21]),
    (40, &[14]),
    (41, &[25]),
    (45, &[65]),
    (54, &[14]),
    (55, &[13]),
    (56, &[2]),
    (57, &[4]),
    (63, &[1]),
    (64, &[1]),
    (80, &[3]),
    (100, &[2]),
    (101, &[1]),
    (102, &[2]),
    (103, &[3]),
    (104, &[13, 14]),
    (105, &[13, 14]),
    (106, &[13, 14]),
    (108, &[4]),
    (112, &[9]),
    (113, &[1]),
    (114, &[3]),
    (115, &[22]),
    (116, &[8]),
    (117, &[1]),
    (118, &[1]),
    (119, &[3]),
    (120, &[17]),
    (121, &[17]),
    (122, &[17]),
    (123, &[17]),
    (124, &[17]),
    (125, &[17]),
    (126, &[17]),
    (127, &[17]),
];

/// Each telemetry ID and the bytes of data it answers. Two of a driver's requests share 233, one
/// reading a byte and one two, and it answers the shorter so the other's buffer isn't overrun.
pub const TELEMETRY: &[(u8, usize)] = &[
    (128, 8),
    (129, 6),
    (130, 2),
    (131, 1),
    (132, 6),
    (133, 3),
    (134, 2),
    (135, 1),
    (140, 6),
    (141, 6),
    (142, 6),
    (143, 6),
    (144, 6),
    (145, 2),
    (150, 6),
    (190, 54),
    (191, 72),
    (192, 12),
    (193, 42),
    (194, 34),
    (195, 38),
    (196, 8),
    (197, 3),
    (199, 6),
    (200, 12),
    (203, 112),
    (206, 504),
    (207, 64),
    (210, 36),
    (211, 54),
    (215, 6),
    (220, 3),
    (225, 173),
    (228, 33),
    (232, 8),
    (233, 1),
    (234, 1),
    (235, 13),
    (236, 13),
    (237, 12),
    (238, 6),
    (240, 4),
    (241, 22),
    (242, 5),
    (243, 12),
    (244, 1),
    (245, 1),
    (246, 2),
    (247, 16),
    (248, 16),
    (249, 16),
    (250, 16),
    (251, 16),
    (252, 16),
    (253, 16),
    (254, 16),
];

/// Telemetry that reads back a telecommand's parameters: the telemetry, then the telecommand.
const READ_BACK: [(u8, u8); 13] = [
    (131, 3),
    (134, 8),
    (145, 9),
    (197, 11),
    (199, 15),
    (200, 55),
    (203, 25),
    (207, 45),
    (225, 30),
    (235, 104),
    (236, 105),
    (237, 106),
    (238, 34),
];

mod telemetry {
    pub(super) const NODE: u8 = 128;
    pub(super) const BOOT: u8 = 129;
    pub(super) const BOOT_INDEX: u8 = 130;
    pub(super) const BOOTLOADER: u8 = 132;
    pub(super) const UNIX_TIME: u8 = 140;
    pub(super) const COMMS: u8 = 144;
    pub(super) const POSITION: u8 = 150;
    pub(super) const STATE: u8 = 190;
    pub(super) const MEASUREMENTS: u8 = 191;
    pub(super) const ACTUATOR: u8 = 192;
    pub(super) const ESTIMATION: u8 = 193;
    pub(super) const POWER: u8 = 195;
    pub(super) const RAW_GPS: u8 = 210;
    pub(super) const ACKNOWLEDGE: u8 = 240;
}

/// The modes at the start of the state (190), little-endian.
mod state {
    use super::{Access, FieldSpec};

    pub(super) const ESTIMATION: FieldSpec = FieldSpec::new("ESTIMATION", 0, 4, Access::ReadOnly);
    pub(super) const CONTROL: FieldSpec = FieldSpec::new("CONTROL", 4, 4, Access::ReadOnly);
    pub(super) const RUN: FieldSpec = FieldSpec::new("RUN", 8, 2, Access::ReadOnly);
    pub(super) const SGP4: FieldSpec = FieldSpec::new("SGP4", 10, 2, Access::ReadOnly);
}

/// What the unit says it is.
// ceiling: no public document gives the node type or the firmware's version, so they're this model's
const NODE_TYPE: u8 = 10;
const INTERFACE: u8 = 1;
const FIRMWARE: [u8; 2] = [7, 2];
/// Power and temperature as raw words: control 3.3 V at 50 mA, 5 V at 20 mA and battery at 10 mA,
/// 0.48828125 mA a count, then the processor at 25 °C, both magnetometers at 22 °C a tenth a count,
/// and the three rate sensors at 25 °C.
const POWER: [(usize, u16); 9] = [
    (8, 102),
    (10, 41),
    (12, 20),
    (26, 25),
    (28, 220),
    (30, 220),
    (32, 25),
    (34, 25),
    (36, 25),
];

/// Where power and temperature (195) puts the processor's temperature, both magnetometers' and the
/// three rate sensors', in `ADCS_get_power_temp`'s order.
const TEMPERATURES: [usize; 6] = [26, 28, 30, 32, 34, 36];

/// Scales: the world's units into the telemetry's counts.
const DEGREES_PER_RADIAN: f64 = 180.0 / std::f64::consts::PI;
const CENTIDEGREES: f64 = 100.0;
const UNIT_PER_BILLIONTH: f64 = 1e-9;
const VECTOR_COUNTS: f64 = 10_000.0;
const MILLIDEGREES_PER_COUNT: i64 = 10;
const NANOTESLA_PER_COUNT: i64 = 10;
const METERS_PER_POSITION_COUNT: f64 = 250.0;
const VELOCITY_COUNTS_PER_METER_SECOND: f64 = 4.0;
const METERS_PER_KILOMETER: f64 = 1000.0;
const ALTITUDE_COUNTS_PER_KILOMETER: f64 = 100.0;
const CENTIMETERS_PER_METER: f64 = 100.0;
const MILLIMETERS_PER_METER: f64 = 1000.0;
const NANOS_PER_MILLI: u64 = 1_000_000;
const TESLA_PER_FIELD_COUNT: f64 = 1e-8;
const MILLIS_PER_UNIT: f64 = 1000.0;
const MILLIS_PER_SECOND: u64 = 1000;

/// What the world does to the unit's sensors.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct World {
    epoch: GpsTime,
    position: [i32; 3],
    velocity: [i32; 3],
    attitude: [i32; 4],
    rate: [i32; 3],
    field: [i32; 3],
    sun: [i32; 3],
    eclipse: bool,
    #[serde(default)]
    satellites: u8,
    /// The unit's temperature in hundredths of a degree, or `None` for the bench's.
    #[serde(default)]
    temperature: Option<i16>,
}

/// What the unit keeps, which a reset clears.
#[derive(Debug, Clone, Default, PartialEq, serde::Serialize, serde::Deserialize)]
struct Kept {
    /// Each telecommand's last parameters, by its ID.
    parameters: BTreeMap<u8, Vec<u8>>,
    /// The unix time last set in milliseconds, and the run's nanoseconds when it was.
    clock: Option<(u64, u64)>,
    /// The run's nanoseconds when the unit last started.
    started: u64,
    telecommands: u16,
    telemetry: u16,
    /// The last telecommand and its error.
    acknowledged: Option<(u8, u8)>,
    /// The field the controller measured at its last step, in counts of 10 nT.
    #[serde(default)]
    field: Option<[i32; 3]>,
    /// The magnetorquers' duty the controller drives, in thousandths.
    #[serde(default)]
    torquers: [i16; 3],
    /// The wheels' speed a controller drives, in rpm.
    #[serde(default)]
    wheels: [f64; 3],
    /// The attitude the unit estimates from its orbit model, Shuster's quaternion, scalar first.
    #[serde(default)]
    estimate: Option<[f64; 4]>,
}

/// A frame as it arrives.
#[derive(Debug, Clone, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Heard {
    open: bool,
    escaped: bool,
    data: Vec<u8>,
}

impl Heard {
    /// Keeps `byte` of an open frame, and drops the frame once it's longer than any the unit takes.
    fn keep(&mut self, byte: u8) {
        if self.data.len() == LONGEST_FRAME {
            self.open = false;
            self.data.clear();
        } else {
            self.data.push(byte);
        }
    }
}

/// An attitude unit on the far end of a serial line.
#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
pub struct Unit {
    world: World,
    kept: Kept,
    /// The resets since power on, which a reset doesn't clear.
    #[serde(default)]
    resets: u16,
    heard: Heard,
    pending: VecDeque<u8>,
    /// The controller's next step, while one runs.
    #[serde(default)]
    tick: Option<EventId>,
}

impl Unit {
    /// A unit just started, in a world of nothing until the board hands it one.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The GPS time the run's clock starts from: `time_of_week` milliseconds into GPS week `week`.
    pub fn set_epoch(&mut self, week: u16, time_of_week: u32) {
        self.world.epoch = GpsTime::from_week(week, time_of_week);
    }

    /// Where the spacecraft is, in centimeters in the Earth's frame.
    pub fn set_position(&mut self, centimeters: [i32; 3]) {
        self.world.position = centimeters;
    }

    /// How fast it moves, in millimeters a second in the Earth's frame.
    pub fn set_velocity(&mut self, millimeters_a_second: [i32; 3]) {
        self.world.velocity = millimeters_a_second;
    }

    /// Its attitude: Shuster's quaternion that takes inertial coordinates to body ones, scalar first,
    /// in billionths, the same four numbers as Hamilton's that turns the body's axes onto the
    /// inertial ones.
    pub fn set_attitude(&mut self, billionths: [i32; 4]) {
        self.world.attitude = billionths;
    }

    /// Its angular rate about each body axis, in thousandths of a degree a second.
    pub fn set_rate(&mut self, millidegrees_a_second: [i32; 3]) {
        self.world.rate = millidegrees_a_second;
    }

    /// The magnetic field along each body axis, in nanotesla.
    pub fn set_field(&mut self, nanotesla: [i32; 3]) {
        self.world.field = nanotesla;
    }

    /// The direction of the sun on the body's axes, a unit vector in billionths, and whether the
    /// Earth is in the way.
    pub fn set_sun(&mut self, billionths: [i32; 3], eclipse: bool) {
        self.world.sun = billionths;
        self.world.eclipse = eclipse;
    }

    /// How many GPS satellites the unit's receiver tracks.
    pub fn set_satellites(&mut self, count: u8) {
        self.world.satellites = count;
    }

    /// The unit's temperature, in hundredths of a degree Celsius, which its processor, both
    /// magnetometers and the rate sensors read from now on.
    pub fn set_temperature(&mut self, hundredths: i16) {
        self.world.temperature = Some(hundredths);
    }

    /// The magnetorquers' duty on each axis in thousandths: as magnetorquer output (16) commanded it
    /// while the loop runs and the control mode is none, as the controller drives it while the 1 Hz
    /// loop runs detumbling or Y-Thomson, and zero otherwise.
    #[must_use]
    pub fn magnetorquers(&self) -> [i16; 3] {
        if self.controlling() {
            self.kept.torquers
        } else {
            self.manual(MAGNETORQUERS)
        }
    }

    /// What the controllers act with: the ground's detumbling configuration (38) and inertia (41),
    /// and [`DEFAULT_CONTROL`] for any it hasn't set.
    #[must_use]
    pub fn control(&self) -> Control {
        let mut control = DEFAULT_CONTROL;
        if let Some(settings) = self.kept.parameters.get(&DETUMBLE_SETTINGS) {
            control.spin_gain = f32_at(settings, 0);
            control.damping_gain = f32_at(settings, 4);
            control.spin_rate =
                f64::from(i16::from_le_bytes([settings[8], settings[9]])) / MILLIS_PER_UNIT;
        }
        if let Some(inertia) = self.kept.parameters.get(&INERTIA) {
            control.inertia_yy = f32_at(inertia, 4);
        }
        control
    }

    /// What the wheel controllers act with: the ground's Y-momentum configuration (39), reaction
    /// wheel configuration (40) and inertia (41), and [`DEFAULT_POINTING`] for any it hasn't set.
    #[must_use]
    pub fn pointing(&self) -> Pointing {
        let mut pointing = DEFAULT_POINTING;
        if let Some(settings) = self.kept.parameters.get(&Y_WHEEL_SETTINGS) {
            pointing.y_control_gain = f32_at(settings, 0);
            pointing.y_damping_gain = f32_at(settings, 4);
            pointing.y_proportional_gain = f32_at(settings, 8);
            pointing.y_derivative_gain = f32_at(settings, 12);
            pointing.y_momentum = f32_at(settings, 16);
        }
        if let Some(settings) = self.kept.parameters.get(&WHEEL_SETTINGS) {
            pointing.proportional_gain = f32_at(settings, 0);
            pointing.derivative_gain = f32_at(settings, 4);
            pointing.bias_momentum = f32_at(settings, 8);
            pointing.sun_facet = settings[12] & FACET;
        }
        if let Some(inertia) = self.kept.parameters.get(&INERTIA) {
            let [xx, yy, zz, xy, xz, yz] = [0, 4, 8, 12, 16, 20].map(|at| f32_at(inertia, at));
            pointing.inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        }
        pointing
    }

    /// Whether a controller drives the actuators: the 1 Hz loop running one of the modeled modes.
    fn controlling(&self) -> bool {
        self.setting(RUN_MODE) == LOOP_AT_1_HZ
            && (DETUMBLING..=SUN_POINTING).contains(&self.setting(CONTROL_MODE))
    }

    /// Whether the control mode is one of the wheels'.
    fn wheeling(&self) -> bool {
        self.controlling() && self.setting(CONTROL_MODE) >= Y_MOMENTUM_START
    }

    /// Schedules the loop's next step while the 1 Hz loop runs. A controller that isn't running
    /// forgets what it measured and drove, so it starts afresh, and the estimate goes with the loop.
    fn keep_time(&mut self, context: &mut Timeline<'_, '_>) {
        if !self.controlling() {
            self.kept.field = None;
            self.kept.torquers = [0; 3];
            self.kept.wheels = [0.0; 3];
        }
        if self.setting(RUN_MODE) != LOOP_AT_1_HZ {
            self.kept.estimate = None;
        } else if self.tick.is_none() {
            let next = VirtualNanos(context.now().0 + CONTROL_PERIOD);
            self.tick = Some(context.schedule(next));
        }
    }

    /// One step of the loop: the estimate, then the controller.
    fn step(&mut self, now: VirtualNanos) {
        self.estimate(now);
        if !self.controlling() {
            return;
        }
        let field = self
            .world
            .field
            .map(|nanotesla| counts(nanotesla, NANOTESLA_PER_COUNT));
        let previous = self.kept.field.replace(field);
        let tesla = field.map(|count| f64::from(count) * TESLA_PER_FIELD_COUNT);
        let changing = previous.map(|previous| -> [f64; 3] {
            std::array::from_fn(|axis| {
                f64::from(field[axis] - previous[axis]) * TESLA_PER_FIELD_COUNT
                    / CONTROL_PERIOD_SECONDS
            })
        });
        match self.setting(CONTROL_MODE) {
            DETUMBLING | Y_THOMSON => {
                self.kept.wheels = [0.0; 3];
                if let Some(changing) = changing {
                    self.thomson(tesla, changing);
                }
            }
            Y_MOMENTUM_START | Y_MOMENTUM => self.momentum(now, tesla, changing),
            mode => self.point(now, mode, tesla),
        }
    }

    /// Detumbling and Y-Thomson on the field `tesla` and its change over the last second.
    fn thomson(&mut self, tesla: [f64; 3], changing: [f64; 3]) {
        let control = self.control();
        let dipole = if self.setting(CONTROL_MODE) == Y_THOMSON {
            let spin = f64::from(counts(self.world.rate[1], MILLIDEGREES_PER_COUNT))
                / CENTIDEGREES
                / DEGREES_PER_RADIAN;
            let reference = control.spin_rate / DEGREES_PER_RADIAN;
            let spinning = add(changing, cross([0.0, spin, 0.0], tesla));
            let torque = control.spin_gain * control.inertia_yy * (reference - spin);
            let spin_dipole = cross_product_law(tesla, [0.0, torque, 0.0]);
            std::array::from_fn(|axis| spin_dipole[axis] - control.damping_gain * spinning[axis])
        } else {
            changing.map(|part| -control.damping_gain * part)
        };
        self.drive_torquers(dipole, tesla);
    }

    /// Y-momentum: the `y` wheel spun to its momentum and the `x` and `z` wheels stopped. The
    /// magnetorquers damp the body's turning against the orbit frame's, B-dot on the field as a frame
    /// turning with the orbit sees it, and by the cross-product law steer the total momentum, body
    /// and wheels, to the one it has with `y` against the orbit's normal and turning with the orbit,
    /// which takes roll and yaw out and dumps the `y` wheel toward its momentum. The steady mode
    /// adds pitch on the `y` wheel.
    fn momentum(&mut self, now: VirtualNanos, tesla: [f64; 3], changing: Option<[f64; 3]>) {
        let pointing = self.pointing();
        let known = self.knowledge(now);
        let rate = self.rate();
        let inertia = pointing.inertia;
        let orbiting = multiply(&known.to_body, known.orbit_rate());
        let momentum = self.wheel_momentum();
        let along = multiply(&known.to_body, known.orbit_frame()[1]);
        let spin = dot(orbiting, orbiting).sqrt();
        let wanted = along.map(|part| part * (pointing.y_momentum - inertia[1][1] * spin));
        let excess = sub(add(multiply(&inertia, rate), momentum), wanted);
        let damping = changing.map_or([0.0; 3], |changing| {
            add(changing, cross(orbiting, tesla)).map(|part| -pointing.y_damping_gain * part)
        });
        let steering = cross_product_law(tesla, excess.map(|part| -pointing.y_control_gain * part));
        let applied = self.drive_torquers(add(damping, steering), tesla);
        let steady = self.setting(CONTROL_MODE) == Y_MOMENTUM;
        let reach = WHEEL_TORQUE * CONTROL_PERIOD_SECONDS;
        let target = [0.0, pointing.y_momentum, 0.0];
        let torque: [f64; 3] = std::array::from_fn(|axis| {
            if axis == 1 && steady {
                let body_from_orbit =
                    multiply_matrices(&known.to_body, &transpose(&known.orbit_frame()));
                let pitch = euler(&body_from_orbit)[1];
                -inertia[1][1]
                    * (pointing.y_proportional_gain * pitch
                        + pointing.y_derivative_gain * (rate[1] - orbiting[1]))
                    - applied[1]
            } else {
                (momentum[axis] - target[axis]).clamp(-reach, reach) / CONTROL_PERIOD_SECONDS
            }
        });
        self.drive_wheels(torque);
    }

    /// Three-axis pointing on the wheels: quaternion feedback on the attitude and the rate against
    /// the target's, with the body's gyroscopic torque and the magnetorquers' own taken out, while
    /// the magnetorquers dump the wheels' momentum toward the bias.
    fn point(&mut self, now: VirtualNanos, mode: u8, tesla: [f64; 3]) {
        let pointing = self.pointing();
        let known = self.knowledge(now);
        let (target, turning) = if mode == NADIR_POINTING {
            let angles = self.angles();
            (
                multiply_matrices(&euler_matrix(angles), &known.orbit_frame()),
                known.orbit_rate(),
            )
        } else {
            let facet = usize::from(pointing.sun_facet % 6);
            let mut face = [0.0; 3];
            face[facet % 3] = if facet < 3 { 1.0 } else { -1.0 };
            let mut beside = [0.0; 3];
            beside[(facet + 1) % 3] = 1.0;
            (
                triad(face, beside, known.sun, known.orbit_frame()[1]),
                [0.0; 3],
            )
        };
        let error = quaternion(&multiply_matrices(&known.to_body, &transpose(&target)));
        let angle = [2.0 * error[1], 2.0 * error[2], 2.0 * error[3]];
        let rate = self.rate();
        let mismatch = sub(rate, multiply(&known.to_body, turning));
        let momentum = self.wheel_momentum();
        let excess = sub(momentum, [0.0, pointing.bias_momentum, 0.0]);
        let applied = self.drive_torquers(
            cross_product_law(tesla, excess.map(|part| -DUMPING_GAIN * part)),
            tesla,
        );
        let inertia = pointing.inertia;
        let feedback = multiply(
            &inertia,
            std::array::from_fn(|axis| {
                -pointing.proportional_gain * angle[axis]
                    - pointing.derivative_gain * mismatch[axis]
            }),
        );
        let gyroscopic = cross(rate, add(multiply(&inertia, rate), momentum));
        self.drive_wheels(sub(add(feedback, gyroscopic), applied));
    }

    /// Drives the magnetorquers at `dipole` in A·m², each axis held to a full duty, and gives the
    /// torque the dipole they drive puts on the body in `tesla`.
    fn drive_torquers(&mut self, dipole: [f64; 3], tesla: [f64; 3]) -> [f64; 3] {
        self.kept.torquers = dipole.map(|moment| {
            let duty =
                nearest((moment / FULL_DUTY_DIPOLE * FULL_DUTY).clamp(-FULL_DUTY, FULL_DUTY));
            i16::try_from(duty).expect("held to a full duty")
        });
        let driven = self
            .kept
            .torquers
            .map(|duty| f64::from(duty) / FULL_DUTY * FULL_DUTY_DIPOLE);
        cross(driven, tesla)
    }

    /// Commands the wheels to put `torque` in N·m on the body over the next second, each wheel's
    /// change held to its motor's torque and its speed to the fastest it's commanded.
    fn drive_wheels(&mut self, torque: [f64; 3]) {
        let reach = WHEEL_TORQUE * CONTROL_PERIOD_SECONDS;
        let most = WHEEL_RPM / RPM_PER_RADIAN_SECOND * WHEEL_INERTIA;
        let momentum = self.wheel_momentum();
        self.kept.wheels = std::array::from_fn(|axis| {
            let change = (-torque[axis] * CONTROL_PERIOD_SECONDS).clamp(-reach, reach);
            (momentum[axis] + change).clamp(-most, most) / WHEEL_INERTIA * RPM_PER_RADIAN_SECOND
        });
    }

    /// The momentum in the wheels the controller drives, in N·m·s.
    fn wheel_momentum(&self) -> [f64; 3] {
        self.kept
            .wheels
            .map(|rpm| rpm / RPM_PER_RADIAN_SECOND * WHEEL_INERTIA)
    }

    /// The body's rate its rate sensors measure, in radians a second.
    fn rate(&self) -> [f64; 3] {
        self.world
            .rate
            .map(|millidegrees| f64::from(millidegrees) / MILLIS_PER_UNIT / DEGREES_PER_RADIAN)
    }

    /// The commanded attitude angles (15), roll, pitch and yaw in radians, zero until set.
    fn angles(&self) -> [f64; 3] {
        self.kept
            .parameters
            .get(&ANGLES)
            .map_or([0.0; 3], |angles| {
                std::array::from_fn(|axis| {
                    f64::from(i16::from_le_bytes([angles[2 * axis], angles[2 * axis + 1]]))
                        / CENTIDEGREES
                        / DEGREES_PER_RADIAN
                })
            })
    }

    /// The orbit the ground uploaded (45) as SGP4 has it, and its epoch in UTC seconds since 1970.
    fn orbit_model(&self) -> Option<(Sgp4, f64)> {
        self.kept
            .parameters
            .get(&ORBIT)
            .and_then(|parameters| orbit_model(parameters))
    }

    /// Where the uploaded orbit puts the spacecraft at `now`, inertial meters and meters a second, at
    /// the GPS time the unit's receiver gives.
    fn modeled_orbit(&self, now: VirtualNanos) -> Option<([f64; 3], [f64; 3])> {
        let (model, epoch) = self.orbit_model()?;
        let (seconds, nanos) = self.world.epoch.plus(now.0).unix();
        let whole = f64::from(u32::try_from(seconds).unwrap_or(u32::MAX));
        let minutes = (whole - epoch + f64::from(u32::try_from(nanos).unwrap_or(0)) * 1e-9) / 60.0;
        let (position, velocity) = model.propagate(minutes)?;
        Some((
            position.map(|km| km * METERS_PER_KILOMETER),
            velocity.map(|km| km * METERS_PER_KILOMETER),
        ))
    }

    /// The attitude estimate's step: with an uploaded orbit, the nadir and the Sun the sensors
    /// measure against where the orbit and the Sun's model put them, by TRIAD with the nadir first.
    /// In the Earth's shadow it's TRIAD of the nadir and the orbit's normal, the normal as the last
    /// estimate turned by the rate sensors' second puts it on the body, so the nadir holds roll and
    /// pitch and the rate sensors carry yaw. With no last estimate it starts from the truth, and
    /// with the nadir and the Sun within 5° of each other it keeps the turned estimate as it is.
    fn estimate(&mut self, now: VirtualNanos) {
        let Some((position, velocity)) = self.modeled_orbit(now) else {
            self.kept.estimate = None;
            return;
        };
        let sensed = Sensed::new(&self.world, now);
        let nadir = unit(position.map(|meters| -meters));
        let reference = if self.world.eclipse {
            unit(cross(position, velocity))
        } else {
            self.world.epoch.plus(now.0).sun()
        };
        let turned = self.kept.estimate.map(|estimate| {
            let rate = self.rate();
            multiply_matrices(
                &turn(rate.map(|part| part * CONTROL_PERIOD_SECONDS)),
                &attitude_matrix(estimate),
            )
        });
        let seen = if self.world.eclipse {
            turned.map(|turned| multiply(&turned, reference))
        } else {
            Some(sensed.sun)
        };
        let fixed = seen
            .filter(|seen| {
                let across = cross(sensed.nadir, *seen);
                dot(across, across).sqrt() > SHARPEST
            })
            .map(|seen| triad(sensed.nadir, seen, nadir, reference));
        self.kept.estimate = Some(quaternion(&fixed.or(turned).unwrap_or(sensed.to_body)));
    }

    /// What the unit knows at `now`: with an uploaded orbit, that orbit and the attitude estimated
    /// from it, and without one, the receiver's orbit and the truth.
    fn knowledge(&self, now: VirtualNanos) -> Knowledge {
        let sensed = Sensed::new(&self.world, now);
        let modeled = self.modeled_orbit(now);
        let (position, velocity) = modeled.unwrap_or((sensed.position, sensed.velocity));
        let to_body = match (modeled, self.kept.estimate) {
            (Some(_), Some(estimate)) => attitude_matrix(estimate),
            _ => sensed.to_body,
        };
        Knowledge {
            to_body,
            position,
            velocity,
            sun: self.world.epoch.plus(now.0).sun(),
        }
    }

    /// The wheels' speed on each axis in rpm: as a wheel controller drives it, as wheel speed (17)
    /// commanded it while the loop runs and the control mode is none, and zero otherwise.
    #[must_use]
    pub fn wheel_speeds(&self) -> [i16; 3] {
        if self.wheeling() {
            self.kept
                .wheels
                .map(|rpm| i16::try_from(nearest(rpm)).expect("held to the fastest commanded"))
        } else {
            self.manual(WHEEL_SPEEDS)
        }
    }

    fn manual(&self, id: u8) -> [i16; 3] {
        let driving = self.setting(RUN_MODE) != 0 && self.setting(CONTROL_MODE) == CONTROL_NONE;
        match self.kept.parameters.get(&id) {
            Some(parameters) if driving => std::array::from_fn(|axis| {
                i16::from_le_bytes([parameters[2 * axis], parameters[2 * axis + 1]])
            }),
            _ => [0; 3],
        }
    }

    /// Takes one byte of a frame.
    fn hear(&mut self, byte: u8, context: &mut Timeline<'_, '_>) {
        let heard = &mut self.heard;
        if !heard.escaped {
            if byte == ESCAPE {
                heard.escaped = true;
            } else if heard.open {
                heard.keep(byte);
            }
            return;
        }
        heard.escaped = false;
        match byte {
            START => {
                heard.open = true;
                heard.data.clear();
            }
            ESCAPE if heard.open => heard.keep(ESCAPE),
            END if heard.open => {
                heard.open = false;
                let frame = std::mem::take(&mut heard.data);
                self.answer(&frame, context);
            }
            _ => heard.open = false,
        }
    }

    fn answer(&mut self, frame: &[u8], context: &mut Timeline<'_, '_>) {
        let Some((&id, parameters)) = frame.split_first() else {
            return;
        };
        let now = context.now();
        if id >= TELEMETRY_IDS {
            self.kept.telemetry = self.kept.telemetry.wrapping_add(1);
            let data = self.telemetry(id, now);
            self.pending.extend([ESCAPE, START, id]);
            for byte in data {
                self.pending.push_back(byte);
                if byte == ESCAPE {
                    self.pending.push_back(ESCAPE);
                }
            }
            self.pending.extend([ESCAPE, END]);
            return;
        }
        let error = match TELECOMMANDS.iter().find(|&&(known, _)| known == id) {
            None => UNKNOWN,
            Some((_, lengths)) if !lengths.contains(&frame.len()) => WRONG_LENGTH,
            Some(_) if out_of_range(id, parameters) => INVALID,
            Some(_) => {
                self.take(id, parameters, now);
                self.keep_time(context);
                TAKEN
            }
        };
        if !SILENT.contains(&id) {
            self.kept.telecommands = self.kept.telecommands.wrapping_add(1);
            self.kept.acknowledged = Some((id, error));
            self.pending.extend([ESCAPE, START, id, error, ESCAPE, END]);
        }
    }

    /// What a telecommand taken does.
    fn take(&mut self, id: u8, parameters: &[u8], now: VirtualNanos) {
        match (id, parameters) {
            (RESET, _) => {
                self.resets = self.resets.wrapping_add(1);
                self.kept = Kept {
                    started: now.0,
                    ..Kept::default()
                };
            }
            (SET_TIME, &[a, b, c, d, low, high]) => {
                let seconds = u64::from(u32::from_le_bytes([a, b, c, d]));
                let millis = u64::from(u16::from_le_bytes([low, high]));
                self.kept.clock = Some((seconds * MILLIS_PER_SECOND + millis, now.0));
            }
            _ => {
                self.kept.parameters.insert(id, parameters.to_vec());
            }
        }
    }

    /// The first parameter telecommand `id` last set, or zero.
    fn setting(&self, id: u8) -> u8 {
        self.kept
            .parameters
            .get(&id)
            .and_then(|parameters| parameters.first().copied())
            .unwrap_or(0)
    }

    /// The unix time at `now` in milliseconds, counting from zero at the start until it's set.
    fn unix_millis(&self, now: VirtualNanos) -> u64 {
        let (set, at) = self.kept.clock.unwrap_or((0, self.kept.started));
        set + now.0.saturating_sub(at) / NANOS_PER_MILLI
    }

    /// The data telemetry `id` answers at `now`.
    fn telemetry(&self, id: u8, now: VirtualNanos) -> Vec<u8> {
        let length = TELEMETRY
            .iter()
            .find(|&&(known, _)| known == id)
            .map_or(0, |&(_, length)| length);
        let mut data = vec![0; length];
        if let Some(&(_, command)) = READ_BACK.iter().find(|&&(known, _)| known == id)
            && let Some(parameters) = self.kept.parameters.get(&command)
        {
            let count = parameters.len().min(length);
            data[..count].copy_from_slice(&parameters[..count]);
        }
        match id {
            telemetry::NODE => {
                let running = now.0.saturating_sub(self.kept.started) / NANOS_PER_MILLI;
                data[..4].copy_from_slice(&[NODE_TYPE, INTERFACE, FIRMWARE[0], FIRMWARE[1]]);
                put_u16(&mut data, 4, running / MILLIS_PER_SECOND);
                put_u16(&mut data, 6, running % MILLIS_PER_SECOND);
            }
            telemetry::BOOT => {
                put_u16(&mut data, 1, u64::from(self.resets) + 1);
                data[3] = PROGRAM;
                data[4..6].copy_from_slice(&FIRMWARE);
            }
            telemetry::BOOT_INDEX => data[0] = PROGRAM,
            telemetry::BOOTLOADER => {
                let running = now.0.saturating_sub(self.kept.started) / NANOS_PER_MILLI;
                put_u16(&mut data, 0, running / MILLIS_PER_SECOND);
            }
            telemetry::ACTUATOR => {
                put_counts(&mut data, 0, self.magnetorquers().map(i32::from));
                put_counts(&mut data, 6, self.wheel_speeds().map(i32::from));
            }
            telemetry::ESTIMATION => Estimate::new(self, now).estimation(&mut data),
            telemetry::RAW_GPS => self.raw_gps(&mut data, now),
            telemetry::UNIX_TIME => {
                let millis = self.unix_millis(now);
                let seconds = u32::try_from(millis / MILLIS_PER_SECOND).unwrap_or(u32::MAX);
                data[..4].copy_from_slice(&seconds.to_le_bytes());
                put_u16(&mut data, 4, millis % MILLIS_PER_SECOND);
            }
            telemetry::COMMS => {
                data[..2].copy_from_slice(&self.kept.telecommands.to_le_bytes());
                data[2..4].copy_from_slice(&self.kept.telemetry.to_le_bytes());
            }
            telemetry::ACKNOWLEDGE => {
                if let Some((command, error)) = self.kept.acknowledged {
                    data[..3].copy_from_slice(&[command, 1, error]);
                }
            }
            telemetry::POWER => {
                for (offset, word) in POWER {
                    data[offset..offset + 2].copy_from_slice(&word.to_le_bytes());
                }
                if let Some(hundredths) = self.world.temperature {
                    let degrees = f64::from(hundredths) / 100.0;
                    let whole = nearest_i16(degrees).to_le_bytes();
                    let tenths = nearest_i16(degrees * 10.0).to_le_bytes();
                    for (offset, word) in TEMPERATURES
                        .iter()
                        .zip([whole, tenths, tenths, whole, whole, whole])
                    {
                        data[*offset..*offset + 2].copy_from_slice(&word);
                    }
                }
            }
            telemetry::POSITION => {
                Estimate::new(self, now).position(&mut data, 0);
            }
            telemetry::STATE => self.state(&mut data, now),
            telemetry::MEASUREMENTS => {
                Estimate::new(self, now).measurements(&mut data);
                put_counts(&mut data, 30, self.wheel_speeds().map(i32::from));
            }
            _ => {}
        }
        data
    }

    fn raw_gps(&self, data: &mut [u8], now: VirtualNanos) {
        let world = &self.world;
        data[1] = world.satellites;
        data[2] = world.satellites;
        let (week, time_of_week) = world.epoch.plus(now.0).week();
        put_u16(data, 6, week);
        data[8..12].copy_from_slice(
            &u32::try_from(time_of_week)
                .expect("a week's milliseconds")
                .to_le_bytes(),
        );
        for axis in 0..3 {
            let at = 12 + 6 * axis;
            let meters = nearest(f64::from(world.position[axis]) / CENTIMETERS_PER_METER);
            data[at..at + 4].copy_from_slice(
                &i32::try_from(meters)
                    .expect("a hundredth of an i32")
                    .to_le_bytes(),
            );
            let speed = nearest_i16(f64::from(world.velocity[axis]) / MILLIMETERS_PER_METER);
            data[at + 4..at + 6].copy_from_slice(&speed.to_le_bytes());
        }
    }

    /// The state (190) at `now`.
    fn state(&self, data: &mut [u8], now: VirtualNanos) {
        let modes = [
            (&state::ESTIMATION, ESTIMATION_MODE),
            (&state::CONTROL, CONTROL_MODE),
            (&state::RUN, RUN_MODE),
            (&state::SGP4, SGP4_MODE),
        ]
        .iter()
        .fold(0, |word, (field, command)| {
            field.set(word, u64::from(self.setting(*command)))
        });
        data[..2].copy_from_slice(
            &u16::try_from(modes)
                .expect("two bytes of modes")
                .to_le_bytes(),
        );
        let estimate = Estimate::new(self, now);
        put_vector(
            data,
            12,
            estimate
                .angles
                .map(|angle| angle * DEGREES_PER_RADIAN * CENTIDEGREES),
        );
        put_vector(
            data,
            18,
            estimate.quaternion.map(|part| part * VECTOR_COUNTS),
        );
        put_counts(data, 24, estimate.rate);
        put_vector(
            data,
            30,
            estimate
                .position
                .map(|meters| meters / METERS_PER_POSITION_COUNT),
        );
        put_vector(
            data,
            36,
            estimate
                .velocity
                .map(|speed| speed * VELOCITY_COUNTS_PER_METER_SECOND),
        );
        estimate.position(data, 42);
        put_vector(
            data,
            48,
            estimate.ecef.map(|meters| meters / METERS_PER_KILOMETER),
        );
    }
}

store!(Unit);

impl Peer for Unit {
    fn receive(&mut self, word: u16, context: &mut Timeline<'_, '_>) {
        self.hear(
            u8::try_from(word & 0xFF).expect("masked to a byte"),
            context,
        );
    }

    fn on_event(&mut self, event: EventId, context: &mut Timeline<'_, '_>) {
        if self.tick != Some(event) {
            return;
        }
        self.tick = None;
        if self.setting(RUN_MODE) == LOOP_AT_1_HZ {
            self.step(context.now());
        }
        self.keep_time(context);
    }

    fn restarted(&mut self, context: &mut Timeline<'_, '_>) {
        self.tick = None;
        self.keep_time(context);
    }

    fn power_changed(&mut self, _on: bool, context: &mut Timeline<'_, '_>) {
        self.kept = Kept {
            started: context.now().0,
            ..Kept::default()
        };
        self.resets = 0;
        self.heard = Heard::default();
        self.pending.clear();
        self.tick = None;
    }

    fn transmit(&mut self, _now: VirtualNanos) -> Option<u16> {
        self.pending.pop_front().map(u16::from)
    }
}

/// What the world puts in front of the unit's sensors at an instant, in its frames.
struct Sensed {
    ecef: [f64; 3],
    /// Inertial position in meters and velocity in meters a second, the GPS receiver's.
    position: [f64; 3],
    velocity: [f64; 3],
    /// The attitude matrix, inertial to body.
    to_body: [[f64; 3]; 3],
    /// The nadir and the Sun on the body's axes.
    nadir: [f64; 3],
    sun: [f64; 3],
    /// The sidereal angle that turns the Earth's frame into the inertial one.
    angle: f64,
}

impl Sensed {
    fn new(world: &World, now: VirtualNanos) -> Self {
        let ecef = world
            .position
            .map(|centimeters| f64::from(centimeters) / CENTIMETERS_PER_METER);
        let moving = world
            .velocity
            .map(|millimeters| f64::from(millimeters) / MILLIMETERS_PER_METER);
        let angle = world.epoch.plus(now.0).sidereal_angle();
        let position = inertial(ecef, angle);
        let turning = [-EARTH_RATE * ecef[1], EARTH_RATE * ecef[0], 0.0];
        let velocity = inertial(add(moving, turning), angle);
        let to_body = attitude_matrix(
            world
                .attitude
                .map(|part| f64::from(part) * UNIT_PER_BILLIONTH),
        );
        Self {
            ecef,
            position,
            velocity,
            to_body,
            nadir: multiply(&to_body, unit(position.map(|meters| -meters))),
            sun: world.sun.map(|part| f64::from(part) * UNIT_PER_BILLIONTH),
            angle,
        }
    }
}

/// What the unit knows at a step, in the inertial frame.
struct Knowledge {
    /// The attitude matrix, inertial to body.
    to_body: [[f64; 3]; 3],
    /// Meters, and meters a second.
    position: [f64; 3],
    velocity: [f64; 3],
    /// The unit vector to the Sun.
    sun: [f64; 3],
}

impl Knowledge {
    /// The orbit frame's axes as the rows of the matrix that takes inertial coordinates to it: `x`
    /// completing it, `y` against the orbit's normal and `z` to the Earth's center.
    fn orbit_frame(&self) -> [[f64; 3]; 3] {
        orbit_frame(self.position, self.velocity)
    }

    /// The orbit frame's turning, `r × v / |r|²`, in radians a second.
    fn orbit_rate(&self) -> [f64; 3] {
        let square = dot(self.position, self.position);
        cross(self.position, self.velocity).map(|part| part / square)
    }
}

fn orbit_frame(position: [f64; 3], velocity: [f64; 3]) -> [[f64; 3]; 3] {
    let down = unit(position.map(|meters| -meters));
    let against_normal = unit(cross(velocity, position));
    [cross(against_normal, down), against_normal, down]
}

/// What the unit reports at an instant: with an uploaded orbit, that orbit and the attitude it
/// estimates, and the truth without one.
struct Estimate {
    place: Geodetic,
    ecef: [f64; 3],
    /// Inertial position in meters and velocity in meters a second.
    position: [f64; 3],
    velocity: [f64; 3],
    /// Roll, pitch and yaw from the orbit frame, in radians.
    angles: [f64; 3],
    /// The vector part of the quaternion from the orbit frame to the body.
    quaternion: [f64; 3],
    /// The nadir and the sun its sensors measure on the body's axes, and the field in its counts.
    nadir: [f64; 3],
    sun: [f64; 3],
    field: [i32; 3],
    rate: [i32; 3],
}

impl Estimate {
    fn new(unit: &Unit, now: VirtualNanos) -> Self {
        let world = &unit.world;
        let sensed = Sensed::new(world, now);
        let modeled = unit.modeled_orbit(now);
        let (position, velocity) = modeled.unwrap_or((sensed.position, sensed.velocity));
        let ecef = if modeled.is_some() {
            inertial(position, -sensed.angle)
        } else {
            sensed.ecef
        };
        let to_body = match (modeled, unit.kept.estimate) {
            (Some(_), Some(estimate)) => attitude_matrix(estimate),
            _ => sensed.to_body,
        };
        let body_from_orbit =
            multiply_matrices(&to_body, &transpose(&orbit_frame(position, velocity)));
        let lit = !world.eclipse;
        let [_, x, y, z] = quaternion(&body_from_orbit);
        Self {
            place: Geodetic::from_ecef(ecef),
            ecef,
            position,
            velocity,
            angles: euler(&body_from_orbit),
            quaternion: [x, y, z],
            nadir: sensed.nadir,
            sun: if lit { sensed.sun } else { [0.0; 3] },
            field: world
                .field
                .map(|nanotesla| counts(nanotesla, NANOTESLA_PER_COUNT)),
            rate: world.rate.map(|rate| counts(rate, MILLIDEGREES_PER_COUNT)),
        }
    }

    /// Latitude and longitude at 0.01° and the altitude at 0.01 km, from `offset`.
    fn position(&self, data: &mut [u8], offset: usize) {
        let [latitude, longitude] = [self.place.latitude, self.place.longitude]
            .map(|angle| nearest_i16(angle * DEGREES_PER_RADIAN * CENTIDEGREES));
        data[offset..offset + 2].copy_from_slice(&latitude.to_le_bytes());
        data[offset + 2..offset + 4].copy_from_slice(&longitude.to_le_bytes());
        let altitude =
            nearest(self.place.height / METERS_PER_KILOMETER * ALTITUDE_COUNTS_PER_KILOMETER);
        put_u16(data, offset + 4, u64::try_from(altitude).unwrap_or(0));
    }

    fn estimation(&self, data: &mut [u8]) {
        put_counts(data, 0, self.field);
        put_vector(data, 6, self.sun.map(|part| part * VECTOR_COUNTS));
    }

    /// The measurements (191).
    fn measurements(&self, data: &mut [u8]) {
        put_counts(data, 0, self.field);
        put_vector(data, 6, self.sun.map(|part| part * VECTOR_COUNTS));
        put_vector(data, 12, self.sun.map(|part| part * VECTOR_COUNTS));
        put_vector(data, 18, self.nadir.map(|part| part * VECTOR_COUNTS));
        put_counts(data, 24, self.rate);
    }
}

/// Shuster's attitude matrix of `quaternion`, scalar first: the rows are the body's axes in inertial
/// coordinates. It's normalized first, so a quaternion off by its rounding still turns.
fn attitude_matrix(quaternion: [f64; 4]) -> [[f64; 3]; 3] {
    let norm = quaternion
        .iter()
        .map(|part| part * part)
        .sum::<f64>()
        .sqrt();
    let [w, x, y, z] = if norm == 0.0 {
        [1.0, 0.0, 0.0, 0.0]
    } else {
        quaternion.map(|part| part / norm)
    };
    [
        [
            w * w + x * x - y * y - z * z,
            2.0 * (x * y + w * z),
            2.0 * (x * z - w * y),
        ],
        [
            2.0 * (x * y - w * z),
            w * w - x * x + y * y - z * z,
            2.0 * (y * z + w * x),
        ],
        [
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            w * w - x * x - y * y + z * z,
        ],
    ]
}

/// Roll, pitch and yaw of the 3-2-1 turn that is `matrix`.
fn euler(matrix: &[[f64; 3]; 3]) -> [f64; 3] {
    let roll = atan2(matrix[1][2], matrix[2][2]);
    let level = (matrix[0][0] * matrix[0][0] + matrix[0][1] * matrix[0][1]).sqrt();
    let pitch = atan2(-matrix[0][2], level);
    let yaw = atan2(matrix[0][1], matrix[0][0]);
    [roll, pitch, yaw]
}

/// The quaternion whose attitude matrix is `matrix`, scalar first and kept non-negative, by
/// Shepperd's method of the largest component.
fn quaternion(matrix: &[[f64; 3]; 3]) -> [f64; 4] {
    let trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    let candidates = [
        trace,
        matrix[0][0] - matrix[1][1] - matrix[2][2],
        matrix[1][1] - matrix[0][0] - matrix[2][2],
        matrix[2][2] - matrix[0][0] - matrix[1][1],
    ];
    let largest = (0..4)
        .reduce(|best, index| {
            if candidates[index] > candidates[best] {
                index
            } else {
                best
            }
        })
        .expect("four candidates");
    let twice = (1.0 + candidates[largest]).sqrt() * 2.0;
    let [w, x, y, z] = match largest {
        0 => [
            twice / 4.0,
            (matrix[1][2] - matrix[2][1]) / twice,
            (matrix[2][0] - matrix[0][2]) / twice,
            (matrix[0][1] - matrix[1][0]) / twice,
        ],
        1 => [
            (matrix[1][2] - matrix[2][1]) / twice,
            twice / 4.0,
            (matrix[0][1] + matrix[1][0]) / twice,
            (matrix[2][0] + matrix[0][2]) / twice,
        ],
        2 => [
            (matrix[2][0] - matrix[0][2]) / twice,
            (matrix[0][1] + matrix[1][0]) / twice,
            twice / 4.0,
            (matrix[1][2] + matrix[2][1]) / twice,
        ],
        _ => [
            (matrix[0][1] - matrix[1][0]) / twice,
            (matrix[2][0] + matrix[0][2]) / twice,
            (matrix[1][2] + matrix[2][1]) / twice,
            twice / 4.0,
        ],
    };
    let sign = if w < 0.0 { -1.0 } else { 1.0 };
    [w * sign, x * sign, y * sign, z * sign]
}

/// The attitude matrix TRIAD gives from two directions measured on the body's axes, `first` and
/// `second`, and the same two in the reference frame. The first is held exactly and the second
/// fixes the turn about it.
fn triad(
    first: [f64; 3],
    second: [f64; 3],
    first_reference: [f64; 3],
    second_reference: [f64; 3],
) -> [[f64; 3]; 3] {
    let frame = |a: [f64; 3], b: [f64; 3]| {
        let one = unit(a);
        let two = unit(cross(one, b));
        [one, two, cross(one, two)]
    };
    let body = frame(first, second);
    let reference = frame(first_reference, second_reference);
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..3).map(|k| body[k][row] * reference[k][column]).sum())
    })
}

/// The matrix of roll, pitch and yaw turned yaw first, the inverse of [`euler`].
fn euler_matrix([roll, pitch, yaw]: [f64; 3]) -> [[f64; 3]; 3] {
    let (sin_roll, cos_roll) = sin_cos(roll);
    let (sin_pitch, cos_pitch) = sin_cos(pitch);
    let (sin_yaw, cos_yaw) = sin_cos(yaw);
    let rolled = [
        [1.0, 0.0, 0.0],
        [0.0, cos_roll, sin_roll],
        [0.0, -sin_roll, cos_roll],
    ];
    let pitched = [
        [cos_pitch, 0.0, -sin_pitch],
        [0.0, 1.0, 0.0],
        [sin_pitch, 0.0, cos_pitch],
    ];
    let yawed = [
        [cos_yaw, sin_yaw, 0.0],
        [-sin_yaw, cos_yaw, 0.0],
        [0.0, 0.0, 1.0],
    ];
    multiply_matrices(&rolled, &multiply_matrices(&pitched, &yawed))
}

/// The matrix that takes a vector's coordinates on the body's axes to its coordinates once the body
/// has turned by `angle`, an axis times radians.
fn turn(angle: [f64; 3]) -> [[f64; 3]; 3] {
    let size = dot(angle, angle).sqrt();
    let axis = unit(angle);
    let (sine, cosine) = sin_cos(size);
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let along = (1.0 - cosine) * axis[row] * axis[column];
            let skew = match (row, column) {
                (0, 1) => axis[2],
                (1, 0) => -axis[2],
                (0, 2) => -axis[1],
                (2, 0) => axis[1],
                (1, 2) => axis[0],
                (2, 1) => -axis[0],
                _ => 0.0,
            };
            let diagonal = if row == column { cosine } else { 0.0 };
            diagonal + along + sine * skew
        })
    })
}

/// The dipole whose torque in `field` is `torque`'s part across the field, `B × τ / |B|²`.
fn cross_product_law(field: [f64; 3], torque: [f64; 3]) -> [f64; 3] {
    let strength = dot(field, field);
    if strength == 0.0 {
        [0.0; 3]
    } else {
        cross(field, torque).map(|part| part / strength)
    }
}

fn multiply_matrices(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..3).map(|k| a[row][k] * b[k][column]).sum())
    })
}

fn transpose(matrix: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[column][row]))
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(vector, vector).sqrt();
    if length == 0.0 {
        [0.0; 3]
    } else {
        vector.map(|part| part / length)
    }
}

fn multiply(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| dot(row, vector))
}

/// The SGP4 orbit (45) as SGP4 has it and its epoch in UTC seconds since 1970, or `None` for one it
/// can't carry. The parameters are eight little-endian `f64`s, inclination, eccentricity, right
/// ascension, argument of perigee, B*, mean motion, mean anomaly and epoch, the angles in degrees,
/// the mean motion in revolutions a day and the epoch as an element set writes it, `YYDDD.DDDDDDDD`.
fn orbit_model(parameters: &[u8]) -> Option<(Sgp4, f64)> {
    let value = |index: usize| {
        let at = 8 * index;
        f64::from_le_bytes(parameters[at..at + 8].try_into().expect("eight bytes"))
    };
    let values: [f64; 8] = std::array::from_fn(value);
    if !values.iter().all(|value| value.is_finite()) {
        return None;
    }
    let [
        inclination,
        eccentricity,
        node,
        perigee,
        bstar,
        mean_motion,
        mean_anomaly,
        epoch,
    ] = values;
    let year = (epoch / 1000.0).floor();
    let day = epoch - year * 1000.0;
    if !(0.0..100.0).contains(&year) || !(1.0..367.0).contains(&day) {
        return None;
    }
    let year = if year < 57.0 {
        2000.0 + year
    } else {
        1900.0 + year
    };
    let model = Sgp4::new(&Elements {
        inclination,
        eccentricity,
        node,
        perigee,
        bstar,
        mean_motion,
        mean_anomaly,
    })?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole year between 1957 and 2056"
    )]
    let january = days_to_year(year as u64);
    let seconds =
        (f64::from(u32::try_from(january).expect("a day count of years since 1970")) + day - 1.0)
            * 86_400.0;
    Some((model, seconds))
}

fn out_of_range(id: u8, parameters: &[u8]) -> bool {
    let not_a_number = |offsets: &[usize]| {
        offsets
            .iter()
            .any(|&offset| !f32::from_le_bytes(word_at(parameters, offset)).is_finite())
    };
    match id {
        DETUMBLE_SETTINGS => not_a_number(&[0, 4, 10]),
        INERTIA => not_a_number(&[0, 4, 8, 12, 16, 20]),
        Y_WHEEL_SETTINGS => not_a_number(&[0, 4, 8, 12, 16]),
        WHEEL_SETTINGS => not_a_number(&[0, 4, 8]) || parameters[12] & FACET > 5,
        ORBIT => orbit_model(parameters).is_none(),
        _ => PARAMETER_RANGES.iter().any(|(command, range)| {
            *command == id
                && parameters
                    .first()
                    .is_some_and(|value| !range.contains(value))
        }),
    }
}

/// The four bytes of `parameters` from `offset`.
fn word_at(parameters: &[u8], offset: usize) -> [u8; 4] {
    parameters[offset..offset + 4]
        .try_into()
        .expect("a length the telecommand's table checked")
}

/// The little-endian `f32` of `parameters` from `offset`.
fn f32_at(parameters: &[u8], offset: usize) -> f64 {
    f64::from(f32::from_le_bytes(word_at(parameters, offset)))
}

/// `value` in counts of `per_count`, to the nearest.
fn counts(value: i32, per_count: i64) -> i32 {
    i32::try_from(crate::chip::round(i64::from(value), per_count)).expect("a tenth of an i32")
}

/// `values` to their nearest counts, little-endian, from `offset`.
fn put_vector(data: &mut [u8], offset: usize, values: [f64; 3]) {
    put_counts(
        data,
        offset,
        values.map(|value| i32::from(nearest_i16(value))),
    );
}

/// `counts` held to sixteen bits, little-endian, from `offset`.
fn put_counts(data: &mut [u8], offset: usize, counts: [i32; 3]) {
    for (axis, count) in counts.into_iter().enumerate() {
        let at = offset + 2 * axis;
        data[at..at + 2].copy_from_slice(&crate::chip::saturate(i64::from(count)).to_le_bytes());
    }
}

/// `value` held to sixteen bits unsigned, little-endian, at `offset`.
fn put_u16(data: &mut [u8], offset: usize, value: u64) {
    let word = u16::try_from(value).unwrap_or(u16::MAX);
    data[offset..offset + 2].copy_from_slice(&word.to_le_bytes());
}

#[cfg(test)]
mod flight;

#[cfg(test)]
mod tests {
    use super::flight::{ELEMENTS, Flight};
    use super::*;
    use crate::device::{DeviceContext, Effects};
    use crate::snapshot;
    use crate::soc::Peripheral;

    const PERIPHERAL: Peripheral = Peripheral {
        name: "test",
        base: 0,
        size: 0,
        interrupts: &[],
        registers: &[],
    };

    fn feed(unit: &mut Unit, bytes: &[u8]) -> Vec<u16> {
        let mut effects = Effects::default();
        let mut context = DeviceContext::new(VirtualNanos(0), 0, PERIPHERAL, &mut effects);
        let mut timeline = Timeline::new(&mut context);
        for &byte in bytes {
            unit.receive(u16::from(byte), &mut timeline);
        }
        std::iter::from_fn(|| unit.transmit(VirtualNanos(0))).collect()
    }

    /// A rigid body of a 3U's inertia, turning in a field of 40 µT that turns about the inertial `y`
    /// axis twice an orbit of 5677 s, as a polar orbit's does, with the unit's magnetorquers as its
    /// only torque. Each second the unit measures the world, and its controller steps when its event
    /// comes. It starts at 10°/s about each axis and runs `seconds`, and gives the body's last rate in
    /// radians a second.
    fn fly(mode: u8, seconds: u32) -> [f64; 3] {
        const INERTIA: [f64; 3] = [0.035, 0.035, 0.007];
        const SUBSTEPS: u32 = 10;
        let field_at = |t: f64| {
            let angle = 2.0 * 2.0 * std::f64::consts::PI / 5677.0 * t;
            let (sin, cos) = sin_cos(angle);
            [40e-6 * cos * 0.958, 40e-6 * 0.287, 40e-6 * sin * 0.958]
        };
        // Hamilton's quaternion from body to inertial axes is Shuster's from inertial to body.
        let field_on_body = |state: &[f64; 7], t: f64| {
            let to_body = attitude_matrix([state[0], state[1], state[2], state[3]]);
            multiply(&to_body, field_at(t))
        };
        let derivative = |state: &[f64; 7], dipole: [f64; 3], t: f64| -> [f64; 7] {
            let [w, x, y, z] = [state[0], state[1], state[2], state[3]];
            let rate = [state[4], state[5], state[6]];
            let torque = cross(dipole, field_on_body(state, t));
            let momentum: [f64; 3] = std::array::from_fn(|axis| INERTIA[axis] * rate[axis]);
            let gyroscopic = cross(rate, momentum);
            let turning = |a: f64, b: f64, c: f64| 0.5 * (a * rate[0] + b * rate[1] + c * rate[2]);
            [
                turning(-x, -y, -z),
                turning(w, -z, y),
                turning(z, w, -x),
                turning(-y, x, w),
                (torque[0] - gyroscopic[0]) / INERTIA[0],
                (torque[1] - gyroscopic[1]) / INERTIA[1],
                (torque[2] - gyroscopic[2]) / INERTIA[2],
            ]
        };
        let tumble = 10.0 / DEGREES_PER_RADIAN;
        let mut state = [1.0, 0.0, 0.0, 0.0, tumble, tumble, tumble];
        let mut unit = Unit::new();
        let mut effects = Effects::default();
        let sense =
            |unit: &mut Unit, state: &[f64; 7], t: f64| {
                let field = field_on_body(state, t);
                unit.set_field(field.map(|tesla| i32::try_from(nearest(tesla * 1e9)).unwrap()));
                unit.set_rate([state[4], state[5], state[6]].map(|rate| {
                    i32::try_from(nearest(rate * DEGREES_PER_RADIAN * 1000.0)).unwrap()
                }));
            };
        sense(&mut unit, &state, 0.0);
        {
            let mut context = DeviceContext::new(VirtualNanos(0), 0, PERIPHERAL, &mut effects);
            let mut timeline = Timeline::new(&mut context);
            for byte in [ESCAPE, START, RUN_MODE, 1, ESCAPE, END]
                .into_iter()
                .chain([ESCAPE, START, CONTROL_MODE, mode, 0xFF, 0xFF, ESCAPE, END])
            {
                unit.receive(u16::from(byte), &mut timeline);
            }
        }
        let step = 1.0 / f64::from(SUBSTEPS);
        for second in 1..=seconds {
            let dipole = unit
                .magnetorquers()
                .map(|duty| f64::from(duty) / FULL_DUTY * FULL_DUTY_DIPOLE);
            for substep in 0..SUBSTEPS {
                let t = f64::from(second - 1) + f64::from(substep) * step;
                let along = |base: &[f64; 7], slope: &[f64; 7], by: f64| -> [f64; 7] {
                    std::array::from_fn(|i| base[i] + by * slope[i])
                };
                let k1 = derivative(&state, dipole, t);
                let k2 = derivative(&along(&state, &k1, step / 2.0), dipole, t + step / 2.0);
                let k3 = derivative(&along(&state, &k2, step / 2.0), dipole, t + step / 2.0);
                let k4 = derivative(&along(&state, &k3, step), dipole, t + step);
                state = std::array::from_fn(|i| {
                    state[i] + step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])
                });
                let norm = state[..4]
                    .iter()
                    .map(|part| part * part)
                    .sum::<f64>()
                    .sqrt();
                state[..4].iter_mut().for_each(|part| *part /= norm);
            }
            sense(&mut unit, &state, f64::from(second));
            let now = VirtualNanos(u64::from(second) * CONTROL_PERIOD);
            while let Some((event, _, at)) = effects.events.pop_due(now) {
                let mut context = DeviceContext::new(at, 0, PERIPHERAL, &mut effects);
                unit.on_event(event, &mut Timeline::new(&mut context));
            }
        }
        [state[4], state[5], state[6]]
    }

    fn degrees(rate: [f64; 3]) -> [f64; 3] {
        rate.map(|part| part * DEGREES_PER_RADIAN)
    }

    /// B-dot takes a tumble of 10°/s about each axis, 17°/s in all, to under 1°/s about each in an
    /// hour, at the default gain and with the magnetorquers saturating at first.
    #[test]
    #[cfg_attr(miri, ignore = "an hour's flight is beyond Miri")]
    fn detumbling_takes_a_tumble_away() {
        let rate = degrees(fly(DETUMBLING, 3600));
        assert!(rate.iter().all(|part| part.abs() < 1.0), "{rate:?} °/s");
    }

    /// Y-Thomson takes the same tumble to a spin about `y` within a tenth of its default 2°/s, with
    /// the other axes under half a degree a second, in an orbit and a half.
    #[test]
    #[cfg_attr(miri, ignore = "two hours' flight is beyond Miri")]
    fn y_thomson_settles_into_its_spin() {
        let rate = degrees(fly(Y_THOMSON, 8500));
        assert!((rate[1] - 2.0).abs() < 0.2, "{rate:?} °/s");
        assert!(rate[0].abs() < 0.5 && rate[2].abs() < 0.5, "{rate:?} °/s");
    }

    /// Flies `mode` for two orbits from a turn of 0.3°/s about each axis, the orbit uploaded as it
    /// is and the commanded angles `angles` in hundredths of a degree, and gives the largest error
    /// from `target` over the second orbit, in degrees.
    fn hold(mode: u8, angles: [i16; 3], target: impl Fn(&Flight) -> [[f64; 3]; 3]) -> f64 {
        const ORBIT_SECONDS: u32 = 5677;
        let turning = 0.3 / DEGREES_PER_RADIAN;
        let mut flight = Flight::new(&ELEMENTS, [turning; 3]);
        assert_eq!(flight.upload(&ELEMENTS), TAKEN);
        let angles: Vec<u8> = angles
            .iter()
            .flat_map(|angle| angle.to_le_bytes())
            .collect();
        assert_eq!(flight.send(ANGLES, &angles), TAKEN);
        assert_eq!(flight.send(CONTROL_MODE, &[mode, 0xFF, 0xFF]), TAKEN);
        let mut worst = 0.0_f64;
        while flight.seconds < 2 * ORBIT_SECONDS {
            flight.second();
            if flight.seconds > ORBIT_SECONDS {
                worst = worst.max(flight.off(&target(&flight)));
            }
        }
        worst
    }

    /// The accuracy the coverage table states for three-axis pointing, in degrees.
    const POINTING_ACCURACY: f64 = 0.25;

    fn nadir(flight: &Flight) -> [[f64; 3]; 3] {
        let (position, velocity) = flight.orbit();
        orbit_frame(position, velocity)
    }

    /// Nadir pointing takes a slow tumble to the orbit frame and holds it within its accuracy
    /// through sunlight and shadow, under the gravity gradient and its own dumping.
    #[test]
    #[cfg_attr(miri, ignore = "three hours' flight is beyond Miri")]
    fn nadir_pointing_holds_the_orbit_frame() {
        let worst = hold(NADIR_POINTING, [0; 3], nadir);
        assert!(worst < POINTING_ACCURACY, "{worst}°");
    }

    /// The commanded angles (15) turn nadir pointing's target from the orbit frame: here a pitch of
    /// 90°, which puts `x` up and `z` along the track.
    #[test]
    #[cfg_attr(miri, ignore = "three hours' flight is beyond Miri")]
    fn nadir_pointing_holds_the_commanded_angles() {
        let worst = hold(NADIR_POINTING, [0, 9000, 0], |flight| {
            multiply_matrices(
                &euler_matrix([0.0, std::f64::consts::FRAC_PI_2, 0.0]),
                &nadir(flight),
            )
        });
        assert!(worst < POINTING_ACCURACY, "{worst}°");
    }

    /// Sun pointing holds the `+x` face on the Sun, with `y` against the orbit's normal as near as
    /// it goes, within its accuracy.
    #[test]
    #[cfg_attr(miri, ignore = "three hours' flight is beyond Miri")]
    fn sun_pointing_holds_the_x_face_on_the_sun() {
        let worst = hold(SUN_POINTING, [0; 3], |flight| {
            let (sun, _) = flight.sun();
            triad([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], sun, nadir(flight)[1])
        });
        assert!(worst < POINTING_ACCURACY, "{worst}°");
    }

    /// Initial Y-momentum spins the `y` wheel up and steers the momentum onto the orbit's normal,
    /// and steady Y-momentum then holds pitch within half a degree and roll and yaw within 5°.
    #[test]
    #[cfg_attr(miri, ignore = "three hours' flight is beyond Miri")]
    fn y_momentum_holds_the_orbit_frame() {
        let turning = 0.3 / DEGREES_PER_RADIAN;
        let mut flight = Flight::new(&ELEMENTS, [turning; 3]);
        assert_eq!(flight.upload(&ELEMENTS), TAKEN);
        assert_eq!(
            flight.send(CONTROL_MODE, &[Y_MOMENTUM_START, 0xFF, 0xFF]),
            TAKEN
        );
        let mut worst = [0.0_f64; 3];
        while flight.seconds < 12_000 {
            if flight.seconds == 6000 {
                assert_eq!(flight.send(CONTROL_MODE, &[Y_MOMENTUM, 0xFF, 0xFF]), TAKEN);
            }
            flight.second();
            if flight.seconds > 9000 {
                let body_from_orbit = multiply_matrices(
                    &attitude_matrix(flight.attitude),
                    &transpose(&nadir(&flight)),
                );
                let angles = euler(&body_from_orbit).map(|angle| angle.abs() * DEGREES_PER_RADIAN);
                worst = std::array::from_fn(|axis| worst[axis].max(angles[axis]));
            }
        }
        assert!(
            worst[1] < 0.5 && worst[0] < 5.0 && worst[2] < 5.0,
            "{worst:?}°"
        );
        assert_eq!(flight.unit.wheel_speeds()[0], 0);
    }

    /// An orbit drag takes down, uploaded without its drag: the estimate leaves the truth as the
    /// element set ages, its position by kilometers in a day and its attitude with it, each looked
    /// at in sunlight.
    #[test]
    #[cfg_attr(miri, ignore = "a day's flight is beyond Miri")]
    fn the_estimate_drifts_as_the_element_set_ages() {
        let mut truth = ELEMENTS;
        truth.bstar = 1e-3;
        let mut flight = Flight::new(&truth, [0.0; 3]);
        assert_eq!(flight.upload(&ELEMENTS), TAKEN);
        assert_eq!(
            flight.send(CONTROL_MODE, &[NADIR_POINTING, 0xFF, 0xFF]),
            TAKEN
        );
        let mut drift = Vec::new();
        for hours in [2, 8, 24] {
            while flight.seconds < hours * 3600 || flight.sun().1 {
                flight.second();
            }
            let now = VirtualNanos(u64::from(flight.seconds) * CONTROL_PERIOD);
            let (modeled, _) = flight.unit.modeled_orbit(now).expect("an uploaded orbit");
            let (position, _) = flight.orbit();
            let apart = sub(modeled, position);
            let estimate = attitude_matrix(flight.unit.kept.estimate.expect("estimating"));
            drift.push((dot(apart, apart).sqrt(), flight.off(&estimate)));
        }
        assert!(
            drift.windows(2).all(|pair| pair[1].0 > 2.0 * pair[0].0),
            "{drift:?}"
        );
        assert!(drift[2].0 > 5000.0, "{drift:?}");
        assert!(drift[2].1 > 4.0 * drift[0].1, "{drift:?}");
    }

    #[test]
    fn a_snapshot_keeps_a_frame_half_heard() {
        let mut kept = Unit::new();
        feed(&mut kept, &[ESCAPE, START, RUN_MODE, 1, ESCAPE, END]);
        let request = [ESCAPE, START, telemetry::STATE, ESCAPE, END];
        feed(&mut kept, &request[..3]);
        let bytes = snapshot::stored(&kept).expect("the unit stores itself");
        let mut restored = Unit::new();
        snapshot::load(&mut restored, snapshot::keep(bytes.clone())).expect("and reads back");
        assert_eq!(snapshot::stored(&restored).expect("stores again"), bytes);
        let answer = feed(&mut kept, &request[3..]);
        assert_eq!(answer.len(), 5 + 54);
        assert_eq!(answer[4], 1, "the run mode set before");
        assert_eq!(feed(&mut restored, &request[3..]), answer);
    }
}
