// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The PCAL9538A, an 8-bit I/O expander on an I2C bus: eight pins each an input or an output, an
//! interrupt on any input that changes, and the Agile I/O registers, drive strength, input latches,
//! pull resistors, an interrupt mask and status, and push-pull or open-drain outputs.
//!
//! Written against NXP's PCAL9538A product data sheet, revision 4.0, 28 August 2026. Every section,
//! table and figure below is that document's.
//!
//! **Pins are levels the board and the chip drive.** [`Pcal9538a::drive`] is what the board puts on a
//! pin, or `None` when it lets go, [`Pcal9538a::output`] is what the chip's output stage drives, and
//! [`Pcal9538a::level`] is the level on the pin with both and the pull resistors. [`Pcal9538a::int`] is
//! the `INT` pin with its pull-up, and [`Pcal9538a::set_reset`] the `RESET` pin. Nothing here keeps
//! time, so a change takes effect at the call. A chip on this seam has no line of its own back to the
//! part, so the board carries `INT` to whatever it wired the pin to.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The address | `1110 0`, then `A1` and `A0` as the board ties them. Nothing else is acknowledged | 6.1 figure 6, 6.3 table 5 | `it_answers_at_the_address_a1_and_a0_select` |
//! | Power-up defaults | The output port, configuration, drive strength, pull selection and mask registers all ones, the rest zero, and the input port "The externally applied logic level", so every pin is an input with interrupts masked | 6.2 table 4, 6.6, 2 | `the_registers_read_their_power_up_defaults` |
//! | The command byte | The first byte after a write start "is stored in the Pointer register" and names the register. "There is no limitation on the number of data bytes sent in one write transmission", and each lands in that register | 6.2, 7.1, figures 9 and 10 | `a_write_lands_in_the_register_its_command_byte_names_and_more_bytes_land_there_too` |
//! | The read | After a restart "Data from the register defined by the command byte" follows, as many bytes as the master reads, each from that register again. A read with no command byte uses the last | 7.2, figures 11 and 12 | `a_read_repeats_the_register_its_command_byte_names` |
//! | Input port, `00h` | "reflects the incoming logic levels of the pins, regardless of whether the pin is defined as an input or an output". Read only | 6.4.1 table 6 | `the_input_port_reads_every_pin_whatever_its_direction` |
//! | Output port, `01h` | Drives the pins the configuration makes outputs. "reads from this register reflect the value that was written to this register, not the actual pin value" | 6.4.2 table 7, 6.5 | `the_output_port_drives_the_pins_configured_as_outputs` |
//! | Polarity inversion, `02h` | Inverts the input port's bit for a pin "defined as inputs" | 6.4.3 table 8 | `polarity_inversion_inverts_the_inputs_only` |
//! | Configuration, `03h` | 1 is "a high-impedance input" and 0 an output | 6.4.4 table 9 | `the_output_port_drives_the_pins_configured_as_outputs` |
//! | Output drive strength, `40h` and `41h` | Two bits a pin, kept and read back | 6.4.5 tables 10 and 11 | `the_drive_strength_registers_keep_what_is_written` |
//! | The interrupt | "Any rising or falling edge of the port inputs in the Input mode generates an interrupt", cleared "when data on the port is changed to the original setting or when data is read from the port". `INT` is open drain, active low | 6.8, 1 | `an_input_change_asserts_int_until_a_port_read_or_its_return` |
//! | Input latch, `42h` | A latched input's change is "loaded into the corresponding bit of the input port register" and the interrupt holds until the read even if the pin returns, as the P4 example of 6.4.6 runs | 6.4.6 table 12, figure 13 | `a_latched_input_holds_its_change_until_the_port_is_read` |
//! | Changing the latch | "The interrupt is not cleared if the input latch register changes from latched to non-latched configuration", and the read then gives the pin's level, or the latched level for a pin turned latched | 6.4.6 | `changing_the_latch_keeps_an_interrupt_and_reads_as_6_4_6_says` |
//! | Pull resistors, `43h` and `44h` | Enabled, a pin nothing else drives is pulled up by a 1 and down by a 0 | 6.4.7 table 13, 6.4.8 table 14 | `the_pull_resistors_set_a_floating_pin` |
//! | Interrupt mask, `45h` | A masked input's change doesn't assert `INT`, and masking or unmasking an input that's already the source deasserts or asserts it | 6.4.9 table 15 | `the_mask_gates_int_and_the_status_register` |
//! | Interrupt status, `46h` | A 1 for each input that's a source, 0 where masked. Read only | 6.4.10 table 16 | `the_mask_gates_int_and_the_status_register` |
//! | Output port configuration, `4Fh` | `ODEN0` makes every output open drain, which releases a 1 | 6.4.11 table 17, 6.5 figure 8 | `an_open_drain_output_releases_a_one` |
//! | Outputs and interrupts | "A pin configured as an output cannot cause an interrupt", and turning an output into an input whose level doesn't match the input port register can | 6.8 | `an_output_causes_no_interrupt_and_turning_it_input_can` |
//! | `RESET` | "The PCAL9538A registers and I2C-bus/SMBus state machine are changed to their default state once RESET is LOW", "holding the registers and I2C-bus state machine in their default state until the RESET input is once again HIGH". High, it changes nothing | 6.7, 1 | `the_reset_pin_restores_the_defaults_and_holds_the_chip_off_the_bus`, `a_reset_pin_held_high_keeps_the_registers` |
//! | Command bytes table 4 doesn't list | Acknowledged, read zero and take no write | 6.2 table 4 | `an_unlisted_command_byte_reads_zero_and_takes_no_write` |
//! | Determinism | The same accesses at the same instants give the same bytes, and a chip restored from its saved state goes on as the original does | Not a datasheet behavior | `the_same_accesses_give_the_same_bytes_and_a_restored_chip_goes_on_alike` |
//!
//! # What the model leaves out
//!
//! | Departure | Reason |
//! |---|---|
//! | A pin the part drives at the instant it changes | `INT` is answered when a board asks. A chip on this seam reaches no line of the part's |
//! | The interrupt's timing | `tv(INT)` and `trst(INT)` of table 25 are 1 µs at most. A change asserts `INT` and a read clears it at the call |
//! | The bus while `RESET` is low | Section 1 holds "the I2C-bus state machine in their default state" and doesn't say whether the chip acknowledges its address meanwhile. The model doesn't |
//! | The `RESET` timing | `tw(rst)`, `trec(rst)` and `trst` of table 24 are nanoseconds. A low resets at the call |
//! | Drive strength | 8.2 says it changes how much current a pin sources and sinks. The model has no current, so the registers are kept and change nothing |
//! | Contention | A board driving a pin the chip drives as a push-pull output isn't something the page describes. The chip's output wins |
//! | A pin nothing drives | With no pull resistor enabled, a floating pin keeps the last level it had, low at power-up |
//! | The pointer at power-up | The page doesn't give it. It starts at `00h`, the input port, which figure 12 reads with no command byte |
//! | How 6.2 decodes a command byte | It says two bits name the four basic registers and bit 6 with the low three the extended ones, which `4Fh` doesn't fit. The model answers table 4's codes exactly |
//! | `ODEN0`'s reserved bits | Table 17 marks bits 7 to 1 reserved. They read zero and keep nothing |
//! | The supply, power-on reset levels and glitches | 6.6, 8.4 and table 18 are the part's electrical side. The model starts powered |
//! | The I2C clock and the 12 V tolerance | 8.3 and table 23 are the bus's and the pins' electrical side. The seam carries bytes, not a clock |

use crate::chip::Timeline;
use crate::chip::i2c::Peer;
use crate::device::Level;
use crate::snapshot::store;

/// 6.2 table 4: the command bytes.
const INPUT_PORT: u8 = 0x00;
const OUTPUT_PORT: u8 = 0x01;
const POLARITY_INVERSION: u8 = 0x02;
const CONFIGURATION: u8 = 0x03;
const OUTPUT_DRIVE_STRENGTH_0: u8 = 0x40;
const OUTPUT_DRIVE_STRENGTH_1: u8 = 0x41;
const INPUT_LATCH: u8 = 0x42;
const PULL_ENABLE: u8 = 0x43;
const PULL_SELECTION: u8 = 0x44;
const INTERRUPT_MASK: u8 = 0x45;
const INTERRUPT_STATUS: u8 = 0x46;
const OUTPUT_PORT_CONFIGURATION: u8 = 0x4F;

/// 6.4.11 table 17.
const ODEN0: u8 = 0x01;
/// 6.1 figure 6: `1110 0`, then `A1` and `A0`.
const ADDRESS_BASE: u8 = 0x70;
const A1: u8 = 0x02;
const A0: u8 = 0x01;
const PINS: u8 = 8;
const EVERY_PIN: u8 = 0xFF;

/// One of the port's eight pins, `P0` to `P7`.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
pub struct Pin(u8);

impl Pin {
    /// The pin at `index`, 0 to 7.
    #[must_use]
    pub const fn new(index: u8) -> Option<Self> {
        if index < PINS {
            Some(Self(index))
        } else {
            None
        }
    }

    /// The pin's number, its bit in every register, 6.3 table 5.
    #[must_use]
    pub const fn index(self) -> u8 {
        self.0
    }

    fn mask(self) -> u8 {
        1 << self.0
    }

    fn all() -> impl Iterator<Item = Self> {
        (0..PINS).map(Self)
    }
}

/// The registers, as table 4 lists them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Registers {
    output: u8,
    polarity: u8,
    configuration: u8,
    drive: [u8; 2],
    latch: u8,
    pull_enable: u8,
    pull_selection: u8,
    mask: u8,
    open_drain: bool,
}

/// 6.2 table 4: the power-up defaults.
const DEFAULTS: Registers = Registers {
    output: EVERY_PIN,
    polarity: 0,
    configuration: EVERY_PIN,
    drive: [EVERY_PIN; 2],
    latch: 0,
    pull_enable: 0,
    pull_selection: EVERY_PIN,
    mask: EVERY_PIN,
    open_drain: false,
};

/// Where an I2C transaction is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
enum Phase {
    Idle,
    /// The next byte written is the command byte, 6.2.
    Command,
    /// The bytes written land in the register the command byte named, 7.1.
    Write,
    /// The bytes read come from it, 7.2.
    Read,
}

/// One PCAL9538A.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Pcal9538a {
    address: u8,
    registers: Registers,
    /// Each pin's level when the input port register was last read, 6.8's "original setting".
    snapshot: u8,
    /// The latched inputs whose change is held, and the levels that set them, 6.4.6.
    held: u8,
    captured: u8,
    /// What the board drives on each pin, if anything.
    driven: [Option<Level>; 8],
    /// The level each pin last had, which it keeps while nothing drives it.
    floating: u8,
    reset: Level,
    pointer: u8,
    phase: Phase,
}

impl Pcal9538a {
    /// A part at power-up with `A1` and `A0` tied as given, `RESET` high and nothing driving a pin.
    #[must_use]
    pub fn new(a1: Level, a0: Level) -> Self {
        let mut address = ADDRESS_BASE;
        if a1 == Level::High {
            address |= A1;
        }
        if a0 == Level::High {
            address |= A0;
        }
        let mut chip = Self {
            address,
            registers: DEFAULTS,
            snapshot: 0,
            held: 0,
            captured: 0,
            driven: [None; 8],
            floating: 0,
            reset: Level::High,
            pointer: INPUT_PORT,
            phase: Phase::Idle,
        };
        chip.restart();
        chip
    }

    /// What the board drives on `pin` from now on, or `None` when it lets go.
    pub fn drive(&mut self, pin: Pin, level: Option<Level>) {
        self.driven[usize::from(pin.index())] = level;
        self.settle();
    }

    /// What the chip's output stage drives on `pin`, or `None` when it drives nothing: an input, or an
    /// open-drain output at 1, 6.4.4 and 6.4.11.
    #[must_use]
    pub fn output(&self, pin: Pin) -> Option<Level> {
        let registers = &self.registers;
        if registers.configuration & pin.mask() != 0 {
            return None;
        }
        let high = registers.output & pin.mask() != 0;
        (!(registers.open_drain && high)).then_some(Level::from(high))
    }

    /// The level on `pin`: the chip's output if it drives one, else the board's, else the pull resistor
    /// if it's enabled, else the level the pin last had.
    #[must_use]
    pub fn level(&self, pin: Pin) -> Level {
        let mask = pin.mask();
        self.output(pin)
            .or(self.driven[usize::from(pin.index())])
            .or_else(|| {
                (self.registers.pull_enable & mask != 0)
                    .then(|| Level::from(self.registers.pull_selection & mask != 0))
            })
            .unwrap_or(Level::from(self.floating & mask != 0))
    }

    /// The level on `INT`, active low, with the pull-up its open drain needs, 6.8.
    #[must_use]
    pub fn int(&self) -> Level {
        Level::from(self.status() == 0)
    }

    /// The level on `RESET` from now on. Low resets every register and holds them and the bus there,
    /// 6.7.
    pub fn set_reset(&mut self, level: Level) {
        self.reset = level;
        if level == Level::Low {
            self.phase = Phase::Idle;
            self.restart();
        }
    }

    fn levels(&self) -> u8 {
        Pin::all()
            .filter(|&pin| self.level(pin) == Level::High)
            .fold(0, |levels, pin| levels | pin.mask())
    }

    // 6.6 and 6.7: every register at its default, and the input port register at the pins' levels.
    fn restart(&mut self) {
        self.registers = DEFAULTS;
        self.held = 0;
        self.pointer = INPUT_PORT;
        self.snapshot = self.levels();
        self.settle();
    }

    // 6.4.6: a latched input whose level left the input port register's holds the level that left it.
    // A pin that floats keeps the level it had.
    fn settle(&mut self) {
        let levels = self.levels();
        self.floating = levels;
        if self.reset == Level::Low {
            self.snapshot = levels;
            return;
        }
        let latching = self.registers.configuration & self.registers.latch & !self.held;
        let changed = (levels ^ self.snapshot) & latching;
        self.held |= changed;
        self.captured = (self.captured & !changed) | (levels & changed);
    }

    // 6.8 and 6.4.6: each input that's a source, before the mask.
    fn sources(&self) -> u8 {
        ((self.levels() ^ self.snapshot) | self.held) & self.registers.configuration
    }

    // 6.4.10: the interrupt status register.
    fn status(&self) -> u8 {
        self.sources() & !self.registers.mask
    }

    // 6.4.1, 6.4.3 and 6.4.6: the input port register, which the read resets the interrupt with.
    fn read_input_port(&mut self) -> u8 {
        let registers = &self.registers;
        let latched = self.held & registers.latch;
        let word = (self.levels() & !latched) | (self.captured & latched);
        let word = word ^ (registers.polarity & registers.configuration);
        self.snapshot = self.levels();
        self.held = 0;
        self.settle();
        word
    }

    fn read_register(&mut self, register: u8) -> u8 {
        let registers = &self.registers;
        match register {
            INPUT_PORT => self.read_input_port(),
            OUTPUT_PORT => registers.output,
            POLARITY_INVERSION => registers.polarity,
            CONFIGURATION => registers.configuration,
            OUTPUT_DRIVE_STRENGTH_0 => registers.drive[0],
            OUTPUT_DRIVE_STRENGTH_1 => registers.drive[1],
            INPUT_LATCH => registers.latch,
            PULL_ENABLE => registers.pull_enable,
            PULL_SELECTION => registers.pull_selection,
            INTERRUPT_MASK => registers.mask,
            INTERRUPT_STATUS => self.status(),
            OUTPUT_PORT_CONFIGURATION if registers.open_drain => ODEN0,
            _ => 0,
        }
    }

    fn write_register(&mut self, register: u8, byte: u8) {
        let registers = &mut self.registers;
        match register {
            OUTPUT_PORT => registers.output = byte,
            POLARITY_INVERSION => registers.polarity = byte,
            CONFIGURATION => registers.configuration = byte,
            OUTPUT_DRIVE_STRENGTH_0 => registers.drive[0] = byte,
            OUTPUT_DRIVE_STRENGTH_1 => registers.drive[1] = byte,
            INPUT_LATCH => registers.latch = byte,
            PULL_ENABLE => registers.pull_enable = byte,
            PULL_SELECTION => registers.pull_selection = byte,
            INTERRUPT_MASK => registers.mask = byte,
            OUTPUT_PORT_CONFIGURATION => registers.open_drain = byte & ODEN0 != 0,
            _ => return,
        }
        self.settle();
    }
}

impl Peer for Pcal9538a {
    // 6.1 and 6.7: its own address, while `RESET` is high.
    fn start(&mut self, address: u8, read: bool, _context: &mut Timeline<'_, '_>) -> bool {
        if address != self.address || self.reset == Level::Low {
            self.phase = Phase::Idle;
            return false;
        }
        self.phase = if read { Phase::Read } else { Phase::Command };
        true
    }

    // 6.2 and 7.1: the command byte, then the data, each to the register it names.
    fn write(&mut self, byte: u8, _context: &mut Timeline<'_, '_>) -> bool {
        match self.phase {
            Phase::Command => {
                self.pointer = byte;
                self.phase = Phase::Write;
            }
            Phase::Write => self.write_register(self.pointer, byte),
            Phase::Read | Phase::Idle => return false,
        }
        true
    }

    // 7.2 and figure 12: the register the command byte names, again for each byte.
    fn read(&mut self, _last: bool, _context: &mut Timeline<'_, '_>) -> u8 {
        if self.phase != Phase::Read {
            return 0;
        }
        self.read_register(self.pointer)
    }

    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {
        self.phase = Phase::Idle;
    }
}

store!(Pcal9538a);
