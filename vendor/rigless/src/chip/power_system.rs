// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A spacecraft power system on a CAN bus: [`PowerSystem`], a CSP node that answers housekeeping,
//! time, output switching and a ground watchdog, from the solar inputs and the battery the board
//! hands it. It matches what Ex-Alta 2's flight software expects of its power system at CSP node 4.
//!
//! No manufacturer document is used. The wire format comes from two public sources. One is the code
//! in the flight software that talks to the power system, which the tables call "the client"
//! (`ex2_hal/eps/hardware_interface/source/eps.c` and `eps.h` in AlbertaSat's `ex2_obc_software`).
//! The other is the command list in the team's ground station (`src/system.py` in their
//! `ex2_ground_station_software`). Where neither says, the table marks the row as an assumption.
//!
//! **The solar inputs.** Each of the three MPPT inputs is a converter's input side: the voltage
//! and current a panel string delivers at its maximum power point, about 14.4 V on Ex-Alta 2. The
//! battery's current is sensed on its own and never worked out from the inputs, so the converters'
//! efficiency is the world's to apply.
//!
//! **On the wire.** Every request and every reply is a CSP 1.x packet in CFP frames, through
//! [`csp::Interface`]. The first byte of a request is its command, and a reply starts with the
//! same command and a status byte, 0 for success. All numbers are little-endian.
//!
//! | Behavior | Source | Test |
//! |---|---|---|
//! | Node address 4 | the client's `EPS_ADDRESS` in `main/config_exalta2.h`, and the route table in `main/main.c` | `a_request_for_another_node_is_not_answered` |
//! | A request with the CRC32 flag and a trailer that doesn't match gets no answer | libcsp 1.6 `csp_route.c`, `csp_route_security_check`, which discards it | `nothing_answers_a_port_nobody_listens_on_or_a_request_with_a_flag_it_doesnt_take` |
//! | A request with HMAC, XTEA or RDP set is dropped | libcsp 1.6 `csp_route.c`, `csp_route_check_options`, which discards each when it's built without it. That the unit is built without them is an assumption, since the client never sets them toward node 4 | `nothing_answers_a_port_nobody_listens_on_or_a_request_with_a_flag_it_doesnt_take` |
//! | A request to a port nothing listens on is dropped | libcsp 1.6 `csp_route.c`, `csp_route_work`, which frees a packet no socket takes | `nothing_answers_a_port_nobody_listens_on_or_a_request_with_a_flag_it_doesnt_take` |
//! | A reply carries the request's CRC32 flag, so a request without a CRC32 gets a reply without one | libcsp 1.6 `csp_route_work`, which gives a connection the flags of the packet that opened it | `nothing_answers_a_port_nobody_listens_on_or_a_request_with_a_flag_it_doesnt_take` |
//! | Port 7 command 0: 244 bytes, the fields of `eps_instantaneous_telemetry` in order, packed, `cmd` 0 and `status` 0 | the client's `eps_refresh_instantaneous_telemetry`, with `IS_SN0072_EPS` 0 for the Ex-Alta 2 build | `the_instantaneous_reply_is_244_bytes_with_every_field_where_the_client_reads_it` |
//! | Port 7 command 1: 32 bytes, the fields of `eps_startup_telemetry`, `cmd` 1 | `eps_refresh_startup_telemetry` | `the_startup_reply_is_32_bytes` |
//! | Telemetry: the time as an IEEE double of seconds, the uptime, boot count, ground watchdog time left and expiries, the MPPT voltages, the battery voltage, the solar current as the sum of the MPPT inputs' currents on the panel side, the battery current split into in and out, the output status, the four battery temperatures at 9 to 12 and the battery mode | the client's field comments. How the board's quantities map to them is an assumption | `the_instantaneous_reply_is_244_bytes_with_every_field_where_the_client_reads_it`, `the_battery_current_splits_into_in_and_out` |
//! | Telemetry fields no signal feeds read 0: the panel currents, the output currents, the converter voltages and state, the fault status and counts, the on and off deltas, the other temperatures, the MPPT and heater modes and the ping watchdog counts | assumption: nothing says what a healthy unit reads | `the_instantaneous_reply_is_244_bytes_with_every_field_where_the_client_reads_it` |
//! | Startup fields: the time, the reset reason register (`0x0C80_0000` after power on, `0x1400_0000` after a software reset) and the boot count. The rest read 0 | `determine_eps_last_reset_reason` in `housekeeping_to_beacon.c` for the two register values. The rest is an assumption | `the_startup_reply_is_32_bytes`, `a_soft_reboot_counts_a_boot_and_changes_the_reset_reason` |
//! | Battery mode: 0 critical, 1 safe, 2 normal, 3 full, from the battery voltage against three thresholds, with no hysteresis | the client's `eps_mode` and its field comment. The thresholds, their defaults and the absence of hysteresis are assumptions | `the_mode_follows_the_battery_voltage` |
//! | Port 8 command 0: the time, as `cmd`, `status` and a 32-bit Unix time. Command 1 with a 32-bit time sets it, replies `cmd` and `status`, and the time counts on from there. The time starts at 0 | the client's `eps_get_unix_time` and `eps_set_unix_time`. The start is an assumption | `the_time_is_set_and_counts_on` |
//! | Port 14 command 0: channel (1 to 18), state (0 off, 1 on) and a 16-bit delay in seconds. The reply is `cmd` and a status. A delay holds the switch until it's over | the client's `eps_set_pwr_chnl`, which sends `00 08 00 00 00` to turn the UHF channel off and `00 08 01 00 00` to turn it on | `the_boot_commands_switch_channel_8`, `a_delay_holds_the_switch_until_it_is_over` |
//! | Port 14 command 1: a 32-bit mask of the 18 outputs, bit n for channel n+1 | the ground station's `ALL_OUTPUT_CONTROL`. Bit n for channel n+1 matches the client's `eps_get_pwr_chnl` | `a_mask_sets_every_output_at_once` |
//! | Output status in telemetry: bit n is channel n+1 | the client's `eps_get_pwr_chnl`, which reads `outputStatus >> (channel - 1)` | `the_boot_commands_switch_channel_8` |
//! | Every output is on at power on | assumption: nothing says, and the client's watchdogs skip a channel that's off | `the_outputs_start_on` |
//! | A channel past 18, a state past 1 or a mask past 18 bits is refused with status -1 | assumption: nothing gives the codes | `a_command_it_cannot_take_is_refused` |
//! | Port 14 commands 2 to 7 and 9 (MPPT setpoints and modes, the battery heater, the normal battery outputs) are refused with status -1 | the ground station sends them. Nothing models the converters or the heater | `a_command_it_cannot_take_is_refused` |
//! | Port 16 ground watchdog: command 0 with a 16-bit key reloads it, 1 replies the seconds left, 2 with a key clears the reset mark, 3 replies whether a reset has been marked since | the ground station's `GROUND_STATION_WDT`. No source gives the key, so any key is taken | `the_watchdog_commands_answer_and_reload` |
//! | When the watchdog runs out, every output that's on goes off for a while and then comes back, the expiry count goes up, the reset mark is set and the watchdog counts again from the start. The timeout defaults to 48 hours and the off time to 1 second | assumption: nothing gives either. Cycling the outputs is an assumption too, since a ground watchdog exists to recover a spacecraft that stopped answering, and turning its loads off and on is the one thing a power system can do toward that | `the_watchdog_power_cycles_the_outputs`, `a_command_during_the_power_cycle_wins` |
//! | A board sets the watchdog's timeout with [`PowerSystem::set_watchdog`], and a new timeout counts from the instant it's set. The same timeout again changes nothing | assumption: the unit's operator configures it, and no source gives how | `a_new_watchdog_timeout_counts_from_the_instant_it_is_set` |
//! | The unit's own supply, the battery through the spacecraft's separation switch: while it's cut every output is off, every timer and every reply owed is dropped and the unit answers nothing. When it comes back the unit starts as built, with every output on, the time at 0, the watchdog counting afresh with no count and no mark, a boot counted and the reset reason a power on's | assumption: nothing says how the unit starts | `separation_powers_the_unit_and_its_outputs` |
//! | Port 15 command 1 with the key 17767 hard resets: a reboot that also clears the watchdog count and mark. Another key is refused | the ground station's `EPS_RESET` for the port, the command and the key. It says only "Resets the config", so clearing the watchdog count and mark is an assumption | `a_hard_reset_clears_the_watchdog_count` |
//! | Port 4 command 128 with the key `0x0007_8007` or `0x8007_8007` soft reboots: a boot is counted, the uptime restarts, the outputs return to power on, the delays are forgotten and the watchdog reloads | the ground station's `REBOOT`, with both keys from its text, which gives nothing else. The outputs returning to power on, the delays being forgotten and the watchdog reloading are assumptions | `a_soft_reboot_counts_a_boot_and_changes_the_reset_reason` |
//! | Port 9 commands 0, 1 and 2 (active, main and fallback configuration) with a 16-bit id and a type: id 0 type 0 gives 4 in one byte, id 136 type 2 gives 500 in two. Any other id is refused. The width a type has is an assumption | the ground station's `test_eps.py`, which expects those two | `the_configuration_gives_the_two_values_the_ground_station_expects` |
//! | Port 1 ping: the data comes back | the ground station's `CSP` service, and CSP's own echo | `a_ping_comes_back` |
//! | A reply goes out as the request's last frame is heard, with no delay | assumption: no source gives the latency | `a_request_is_answered_as_its_last_frame_is_heard` |
//! | Replies go back to the packet's source node | assumption: the route table isn't known | `a_reply_goes_back_to_the_packets_source` |
//! | A reply is offered again until some node acknowledges it | ISO 11898-1, through [`Peer`] | `an_unacknowledged_reply_is_offered_again` |
//! | Timers arm on the first frame the chip hears, or when its part restarts | the seam gives the chip no call when it's hung | `the_timers_arm_on_the_first_frame` |
//! | Snapshot | everything the chip keeps, the timers and the event that wakes it among them | `a_snapshot_mid_reply_keeps_the_reply_owed`, `a_snapshot_keeps_the_timers_and_the_wake` |
//! | Each output is a supply the controller carries to the part, [`Peer::supplies`], bit n for channel n+1, so a board can run it to the chip it powers | the client's `eps_get_pwr_chnl` for the numbering | `the_radio_is_dead_while_channel_8_is_off_and_starts_from_power_on_when_it_returns` |
//!
//! **Left out.**
//!
//! | Left out | Why |
//! |---|---|
//! | Gating the board's other chips by the output switches | The outputs are recorded and exposed. Powering a chip off belongs to the board |
//! | The solar panels, the converters, the output currents and the faults | The board's edge carries three MPPT inputs and a battery. Nothing else is sensed |
//! | A critical battery switching outputs off | Nothing says which |
//! | The telemetry period command (port 7, command 255) and the other commands | The client never sends them. They're refused with status -1 |
//! | The firmware update service (port 11), the logger and the rest of the ground station's ports | The client never sends them, and nothing models the update |

use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::chip::can::{Offer, Peer};
use crate::chip::csp::{self, Heard, Interface, Node, Packet, Port};
use crate::chip::round;
use crate::snapshot::store;
use crate::time::{EventId, NANOS_PER_SECOND, VirtualNanos};

/// The node the power system answers at.
pub const ADDRESS: Node = Node::new(4).expect("a node of five bits");

/// The ports the power system listens on.
pub mod port {
    use crate::chip::csp::Port;

    const fn port(number: u8) -> Port {
        Port::new(number).expect("a port of six bits")
    }

    /// CSP's echo.
    pub const PING: Port = port(1);
    /// The soft reboot.
    pub const REBOOT: Port = port(4);
    /// Telemetry.
    pub const TELEMETRY: Port = port(7);
    /// The time.
    pub const TIME: Port = port(8);
    /// The configuration.
    pub const CONFIGURATION: Port = port(9);
    /// Output switching.
    pub const OUTPUTS: Port = port(14);
    /// The hard reset.
    pub const RESET: Port = port(15);
    /// The ground watchdog.
    pub const WATCHDOG: Port = port(16);
}

/// How many outputs the power system switches.
pub const OUTPUTS: u8 = 18;
/// The bytes of the instantaneous telemetry reply.
pub const INSTANTANEOUS_BYTES: usize = 244;
/// The bytes of the startup telemetry reply.
pub const STARTUP_BYTES: usize = 32;

const STATUS_REFUSED: u8 = 0xFF;
const HARD_RESET_KEY: u16 = 17_767;
const REBOOT_KEYS: [u32; 2] = [0x0007_8007, 0x8007_8007];
const REBOOT_COMMAND: u8 = 128;
const RESET_REASON_POWER_ON: u32 = 0x0C80_0000;
const RESET_REASON_SOFTWARE: u32 = 0x1400_0000;
const KNOWN_CONFIGURATION: [ConfigurationValue; 2] = [
    ConfigurationValue {
        id: 0,
        kind: 0,
        value: 4,
    },
    ConfigurationValue {
        id: 136,
        kind: 2,
        value: 500,
    },
];
const NANOS_PER_MILLISECOND: u64 = NANOS_PER_SECOND / 1_000;

struct ConfigurationValue {
    id: u16,
    kind: u8,
    value: u16,
}

/// The battery's state, which sets what the power system lets the spacecraft do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[repr(u8)]
pub enum Mode {
    /// Below the critical threshold.
    Critical = 0,
    /// Below the safe threshold.
    Safe = 1,
    /// Between the safe and the full threshold.
    Normal = 2,
    /// At or above the full threshold.
    Full = 3,
}

/// What the power system is configured with. Every one is an assumption, since no source gives
/// them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Parameters {
    /// Below this battery voltage, in millivolts, the mode is critical.
    pub critical_below: u16,
    /// Below this, the mode is safe.
    pub safe_below: u16,
    /// At or above this, the mode is full.
    pub full_from: u16,
    /// How long the ground watchdog counts before it runs out.
    pub watchdog: VirtualNanos,
    /// How long the outputs stay off when the watchdog runs out.
    pub power_cycle: VirtualNanos,
    /// The outputs that are on at power on and after a reboot, bit n for channel n+1.
    pub outputs: u32,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            critical_below: 6_400,
            safe_below: 6_900,
            full_from: 8_100,
            watchdog: VirtualNanos(48 * 3_600 * NANOS_PER_SECOND),
            power_cycle: VirtualNanos(NANOS_PER_SECOND),
            outputs: ALL_OUTPUTS,
        }
    }
}

const ALL_OUTPUTS: u32 = (1 << OUTPUTS) - 1;

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Action {
    DelayedSwitch { channel: u8, on: bool },
    EndPowerCycle,
    WatchdogRunsOut,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Timer {
    at: VirtualNanos,
    action: Action,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Battery {
    millivolts: u16,
    milliamps: i16,
    centi_celsius: i16,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct SolarInput {
    millivolts: u16,
    milliamps: u16,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct TimeSet {
    unix_seconds: u32,
    at: VirtualNanos,
}

struct LittleEndianFields(Vec<u8>);

impl LittleEndianFields {
    fn byte(&mut self, value: u8) -> &mut Self {
        self.0.push(value);
        self
    }

    fn short(&mut self, value: u16) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    fn word(&mut self, value: u32) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    fn double(&mut self, value: f64) -> &mut Self {
        self.0.extend(value.to_le_bytes());
        self
    }

    fn shorts(&mut self, values: impl IntoIterator<Item = u16>) -> &mut Self {
        values.into_iter().for_each(|value| {
            self.short(value);
        });
        self
    }

    fn zeros(&mut self, count: usize) -> &mut Self {
        self.0.resize(self.0.len() + count, 0);
        self
    }
}

/// A power system at CSP node 4.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct PowerSystem {
    link: Interface,
    parameters: Parameters,
    outbox: VecDeque<Offer>,
    solar: [SolarInput; 3],
    battery: Battery,
    outputs: u32,
    restore_after_power_cycle: Option<u32>,
    // Earliest first.
    timers: Vec<Timer>,
    expiries: u32,
    marked: bool,
    boots: u32,
    booted_at: VirtualNanos,
    reset_reason: u32,
    time_set: TimeSet,
    // Whether the unit's own supply is on.
    powered: bool,
    // ceiling: timers arm at the first frame the chip hears or when its part restarts; upgrade when
    // the seam calls a chip as it's hung, since a chip can only ask for an event from a call
    wake_event: Option<(EventId, VirtualNanos)>,
}

store!(PowerSystem);

impl Default for PowerSystem {
    fn default() -> Self {
        Self::new()
    }
}

impl PowerSystem {
    /// A power system just powered on, with the default [`Parameters`] and nothing sensed.
    #[must_use]
    pub fn new() -> Self {
        Self::with_parameters(Parameters::default())
    }

    /// A power system just powered on with `parameters`.
    ///
    /// # Panics
    ///
    /// On a zero watchdog or power cycle, which would fire again in the same instant forever, and
    /// on thresholds out of order, which leave a mode no voltage reaches.
    #[must_use]
    pub fn with_parameters(parameters: Parameters) -> Self {
        assert!(
            parameters.watchdog.0 > 0 && parameters.power_cycle.0 > 0,
            "a watchdog or a power cycle of no time fires forever"
        );
        assert!(
            parameters.critical_below <= parameters.safe_below
                && parameters.safe_below <= parameters.full_from,
            "the thresholds run critical, safe, full"
        );
        let mut system = Self {
            link: Interface::new(ADDRESS),
            parameters,
            outbox: VecDeque::new(),
            solar: [SolarInput::default(); 3],
            battery: Battery::default(),
            outputs: parameters.outputs & ALL_OUTPUTS,
            restore_after_power_cycle: None,
            timers: Vec::new(),
            expiries: 0,
            marked: false,
            boots: 1,
            booted_at: VirtualNanos(0),
            reset_reason: RESET_REASON_POWER_ON,
            time_set: TimeSet {
                unix_seconds: 0,
                at: VirtualNanos(0),
            },
            powered: true,
            wake_event: None,
        };
        system.set_timer(parameters.watchdog, Action::WatchdogRunsOut);
        system
    }

    /// The voltage in millivolts and the current in milliamps a panel string delivers into MPPT
    /// input `channel` (0 to 2), at the converter's input.
    ///
    /// # Panics
    ///
    /// On a channel past 2.
    pub fn set_solar(&mut self, channel: usize, millivolts: u16, milliamps: u16) {
        self.solar[channel] = SolarInput {
            millivolts,
            milliamps,
        };
    }

    /// The battery's voltage in millivolts, its current in milliamps (positive charging) and its
    /// temperature in hundredths of a degree Celsius.
    pub fn set_battery(&mut self, millivolts: u16, milliamps: i16, centi_celsius: i16) {
        self.battery = Battery {
            millivolts,
            milliamps,
            centi_celsius,
        };
    }

    /// The outputs that are on as of the last frame or event, bit n for channel n+1.
    #[must_use]
    pub fn outputs(&self) -> u32 {
        self.outputs
    }

    /// The battery mode the voltage gives.
    #[must_use]
    pub fn mode(&self) -> Mode {
        let volts = self.battery.millivolts;
        if volts < self.parameters.critical_below {
            Mode::Critical
        } else if volts < self.parameters.safe_below {
            Mode::Safe
        } else if volts >= self.parameters.full_from {
            Mode::Full
        } else {
            Mode::Normal
        }
    }

    /// How many times the ground watchdog has run out.
    #[must_use]
    pub fn expiries(&self) -> u32 {
        self.expiries
    }

    /// Sets how long the ground watchdog counts, from now. The timeout it already has changes
    /// nothing, and a unit without power takes it for when it's back.
    ///
    /// # Panics
    ///
    /// On a timeout of no time, which would run out again in the same instant forever.
    pub fn set_watchdog(&mut self, timeout: VirtualNanos, context: &mut Timeline<'_, '_>) {
        assert!(timeout.0 > 0, "a watchdog of no time fires forever");
        if timeout == self.parameters.watchdog {
            return;
        }
        self.parameters.watchdog = timeout;
        if self.powered {
            let now = context.now();
            self.run_timers_until(now);
            self.reload_watchdog(now);
            self.schedule_wake(context);
        }
    }

    fn set_timer(&mut self, at: VirtualNanos, action: Action) {
        let place = self.timers.partition_point(|timer| timer.at <= at);
        self.timers.insert(place, Timer { at, action });
    }

    fn reload_watchdog(&mut self, now: VirtualNanos) {
        self.timers
            .retain(|timer| timer.action != Action::WatchdogRunsOut);
        self.set_timer(
            VirtualNanos(now.0 + self.parameters.watchdog.0),
            Action::WatchdogRunsOut,
        );
    }

    fn run_timers_until(&mut self, now: VirtualNanos) {
        while self.timers.first().is_some_and(|timer| timer.at <= now) {
            let Timer { at, action } = self.timers.remove(0);
            match action {
                Action::DelayedSwitch { channel, on } => self.switch(channel, on),
                Action::EndPowerCycle => {
                    if let Some(mask) = self.restore_after_power_cycle.take() {
                        self.outputs |= mask;
                    }
                }
                Action::WatchdogRunsOut => {
                    self.expiries = self.expiries.wrapping_add(1);
                    self.marked = true;
                    self.restore_after_power_cycle =
                        Some(self.restore_after_power_cycle.unwrap_or(0) | self.outputs);
                    self.outputs = 0;
                    self.set_timer(
                        VirtualNanos(at.0 + self.parameters.power_cycle.0),
                        Action::EndPowerCycle,
                    );
                    self.set_timer(
                        VirtualNanos(at.0 + self.parameters.watchdog.0),
                        Action::WatchdogRunsOut,
                    );
                }
            }
        }
    }

    // A command during a power cycle changes what comes back too, so an output switched off stays
    // off.
    fn switch(&mut self, channel: u8, on: bool) {
        let bit = 1_u32 << (channel - 1);
        if on {
            self.outputs |= bit;
        } else {
            self.outputs &= !bit;
            if let Some(mask) = &mut self.restore_after_power_cycle {
                *mask &= !bit;
            }
        }
    }

    fn schedule_wake(&mut self, context: &mut Timeline<'_, '_>) {
        let Some(next) = self.timers.first().map(|timer| timer.at) else {
            return;
        };
        if self.wake_event.is_none_or(|(_, at)| at != next) {
            self.wake_event = Some((context.schedule(next), next));
        }
    }

    fn reboot(&mut self, now: VirtualNanos, reason: u32, hard: bool) {
        self.boots = self.boots.wrapping_add(1);
        self.booted_at = now;
        self.reset_reason = reason;
        self.outputs = self.parameters.outputs & ALL_OUTPUTS;
        self.restore_after_power_cycle = None;
        self.timers.clear();
        self.reload_watchdog(now);
        if hard {
            self.expiries = 0;
            self.marked = false;
        }
    }

    fn unix_seconds_and_millis(&self, now: VirtualNanos) -> (u32, u32) {
        let elapsed = now.0.saturating_sub(self.time_set.at.0);
        let seconds = u32::try_from(elapsed / NANOS_PER_SECOND % (1 << 32)).expect("below 2^32");
        let millis = u32::try_from(elapsed % NANOS_PER_SECOND / NANOS_PER_MILLISECOND)
            .expect("below a thousand");
        (self.time_set.unix_seconds.wrapping_add(seconds), millis)
    }

    fn watchdog_seconds_left(&self, now: VirtualNanos) -> u32 {
        let due = self
            .timers
            .iter()
            .find(|timer| timer.action == Action::WatchdogRunsOut)
            .map_or(now, |timer| timer.at);
        let left = due.0.saturating_sub(now.0).div_ceil(NANOS_PER_SECOND);
        u32::try_from(left).unwrap_or(u32::MAX)
    }

    fn reply_to(&mut self, service: Port, data: &[u8], now: VirtualNanos) -> Option<Vec<u8>> {
        if service == port::PING {
            return Some(data.to_vec());
        }
        let (&command, rest) = data.split_first()?;
        Some(match service {
            port::TELEMETRY => match command {
                0 => self.instantaneous_telemetry(now),
                1 => self.startup_telemetry(now),
                _ => vec![command, STATUS_REFUSED],
            },
            port::TIME => self.time_command(command, rest, now),
            port::OUTPUTS => self.outputs_command(command, rest, now),
            port::WATCHDOG => self.watchdog_command(command, rest, now),
            port::CONFIGURATION => Self::configuration_command(command, rest),
            port::RESET => {
                if command == 1 && leading_u16(rest) == Some(HARD_RESET_KEY) {
                    self.reboot(now, RESET_REASON_SOFTWARE, true);
                    vec![command, 0]
                } else {
                    vec![command, STATUS_REFUSED]
                }
            }
            port::REBOOT => {
                if command == REBOOT_COMMAND
                    && leading_u32(rest).is_some_and(|key| REBOOT_KEYS.contains(&key))
                {
                    self.reboot(now, RESET_REASON_SOFTWARE, false);
                    vec![command, 0]
                } else {
                    vec![command, STATUS_REFUSED]
                }
            }
            _ => return None,
        })
    }

    fn time_command(&mut self, command: u8, rest: &[u8], now: VirtualNanos) -> Vec<u8> {
        match (command, rest) {
            (0, _) => {
                let mut reply = vec![command, 0];
                reply.extend(self.unix_seconds_and_millis(now).0.to_le_bytes());
                reply
            }
            (1, &[first, second, third, fourth]) => {
                self.time_set = TimeSet {
                    unix_seconds: u32::from_le_bytes([first, second, third, fourth]),
                    at: now,
                };
                vec![command, 0]
            }
            _ => vec![command, STATUS_REFUSED],
        }
    }

    fn outputs_command(&mut self, command: u8, rest: &[u8], now: VirtualNanos) -> Vec<u8> {
        match (command, rest) {
            (0, &[channel, state, low, high]) if (1..=OUTPUTS).contains(&channel) && state < 2 => {
                let delay = u64::from(u16::from_le_bytes([low, high]));
                let on = state == 1;
                if delay == 0 {
                    self.switch(channel, on);
                } else {
                    self.set_timer(
                        VirtualNanos(now.0 + delay * NANOS_PER_SECOND),
                        Action::DelayedSwitch { channel, on },
                    );
                }
                vec![command, 0]
            }
            (1, &[first, second, third, fourth])
                if u32::from_le_bytes([first, second, third, fourth]) <= ALL_OUTPUTS =>
            {
                let mask = u32::from_le_bytes([first, second, third, fourth]);
                self.outputs = mask;
                if let Some(held) = &mut self.restore_after_power_cycle {
                    *held &= mask;
                }
                vec![command, 0]
            }
            _ => vec![command, STATUS_REFUSED],
        }
    }

    fn watchdog_command(&mut self, command: u8, rest: &[u8], now: VirtualNanos) -> Vec<u8> {
        match (command, leading_u16(rest)) {
            (0, Some(_)) => {
                self.reload_watchdog(now);
                vec![command, 0]
            }
            (1, _) => {
                let mut reply = vec![command, 0];
                reply.extend(self.watchdog_seconds_left(now).to_le_bytes());
                reply
            }
            (2, Some(_)) => {
                self.marked = false;
                vec![command, 0]
            }
            (3, _) => vec![command, 0, u8::from(self.marked)],
            _ => vec![command, STATUS_REFUSED],
        }
    }

    fn configuration_command(command: u8, rest: &[u8]) -> Vec<u8> {
        let &[id_low, id_high, kind] = rest else {
            return vec![command, STATUS_REFUSED];
        };
        let id = u16::from_le_bytes([id_low, id_high]);
        match KNOWN_CONFIGURATION
            .iter()
            .find(|known| command < 3 && known.id == id && known.kind == kind)
        {
            Some(known) if known.kind == 0 => vec![command, 0, kind, known.value.to_le_bytes()[0]],
            Some(known) => {
                let mut reply = vec![command, 0, kind];
                reply.extend(known.value.to_le_bytes());
                reply
            }
            None => vec![command, STATUS_REFUSED],
        }
    }

    fn instantaneous_telemetry(&self, now: VirtualNanos) -> Vec<u8> {
        let (seconds, millis) = self.unix_seconds_and_millis(now);
        let uptime = u32::try_from(now.0.saturating_sub(self.booted_at.0) / NANOS_PER_SECOND)
            .unwrap_or(u32::MAX);
        let milliamps = i32::from(self.battery.milliamps);
        let into_battery = u16::try_from(milliamps).unwrap_or(0);
        let out_of_battery = u16::try_from(-milliamps).unwrap_or(0);
        let solar_current = self
            .solar
            .iter()
            .fold(0_u16, |sum, input| sum.saturating_add(input.milliamps));
        let centi = self.battery.centi_celsius;
        let degrees = i8::try_from(round(i64::from(centi), 100)).unwrap_or(if centi < 0 {
            i8::MIN
        } else {
            i8::MAX
        });
        let mut fields = LittleEndianFields(Vec::with_capacity(INSTANTANEOUS_BYTES));
        fields
            .byte(0)
            .byte(0)
            .double(f64::from(seconds) + f64::from(millis) / 1000.0)
            .word(uptime)
            .word(self.boots)
            .word(self.watchdog_seconds_left(now))
            .word(self.expiries)
            .shorts(self.solar.iter().map(|input| input.millivolts))
            .short(0)
            .zeros(8 * 2)
            .short(self.battery.millivolts)
            .short(solar_current)
            .short(into_battery)
            .short(out_of_battery)
            .zeros(18 * 2 + 2 * 2 + 8 * 2 + 1)
            .word(self.outputs)
            .word(0)
            .short(0)
            .zeros(18 * 2 * 2 + 18);
        // Temperatures 9 to 12, counting from one, are the battery's, as the client's comment has it.
        let temperatures = (0..14).map(|index| {
            if (8..12).contains(&index) {
                degrees.to_le_bytes()[0]
            } else {
                0
            }
        });
        fields.0.extend(temperatures);
        fields
            .byte(self.mode() as u8)
            .byte(0)
            .byte(0)
            .byte(0)
            .short(0)
            .byte(0)
            .zeros(8);
        debug_assert_eq!(fields.0.len(), INSTANTANEOUS_BYTES);
        fields.0
    }

    fn startup_telemetry(&self, now: VirtualNanos) -> Vec<u8> {
        let (seconds, millis) = self.unix_seconds_and_millis(now);
        let mut fields = LittleEndianFields(Vec::with_capacity(STARTUP_BYTES));
        fields
            .byte(1)
            .byte(0)
            .double(f64::from(seconds) + f64::from(millis) / 1000.0)
            .word(self.reset_reason)
            .word(self.boots)
            .zeros(14);
        debug_assert_eq!(fields.0.len(), STARTUP_BYTES);
        fields.0
    }

    fn serve(&mut self, packet: &Packet, now: VirtualNanos) {
        let header = packet.header;
        let refused = csp::HMAC | csp::XTEA | csp::RDP;
        if header.destination != ADDRESS || header.flags & refused != 0 {
            return;
        }
        let Ok(data) = packet.opened() else {
            return;
        };
        let Some(reply) = self.reply_to(header.destination_port, data, now) else {
            return;
        };
        let mut answer = Packet {
            header: header.answer(0),
            data: reply,
        };
        if header.flags & csp::CRC32 != 0 {
            answer = answer.sealed();
        }
        let frames = self
            .link
            .send(&answer, header.source)
            .expect("a reply is far shorter than the longest packet");
        self.outbox.extend(frames.into_iter().map(|frame| Offer {
            since: now,
            frame,
            fault: None,
        }));
    }
}

fn leading_u16(bytes: &[u8]) -> Option<u16> {
    Some(u16::from_le_bytes(bytes.get(..2)?.try_into().ok()?))
}

fn leading_u32(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(..4)?.try_into().ok()?))
}

impl Peer for PowerSystem {
    fn receive(&mut self, frame: &crate::chip::can::Frame, context: &mut Timeline<'_, '_>) {
        let now = context.now();
        self.run_timers_until(now);
        if let Heard::Packet(packet) = self.link.hear(frame) {
            self.serve(&packet, now);
        }
        self.schedule_wake(context);
    }

    fn offer(&self) -> Option<Offer> {
        self.outbox.front().copied()
    }

    fn sent(&mut self, acknowledged: bool, _context: &mut Timeline<'_, '_>) {
        if acknowledged {
            self.outbox.pop_front();
        }
    }

    fn on_event(&mut self, event: EventId, context: &mut Timeline<'_, '_>) {
        if self.wake_event.is_none_or(|(held, _)| held != event) {
            return;
        }
        self.wake_event = None;
        self.run_timers_until(context.now());
        self.schedule_wake(context);
    }

    fn supplies(&self) -> u32 {
        self.outputs
    }

    fn restarted(&mut self, context: &mut Timeline<'_, '_>) {
        self.wake_event = None;
        self.run_timers_until(context.now());
        self.schedule_wake(context);
    }

    fn power_changed(&mut self, on: bool, context: &mut Timeline<'_, '_>) {
        let now = context.now();
        self.powered = on;
        self.outbox.clear();
        self.link = Interface::new(ADDRESS);
        self.timers.clear();
        self.restore_after_power_cycle = None;
        self.wake_event = None;
        if !on {
            self.outputs = 0;
            return;
        }
        self.reboot(now, RESET_REASON_POWER_ON, true);
        self.time_set = TimeSet {
            unix_seconds: 0,
            at: now,
        };
        self.schedule_wake(context);
    }
}
