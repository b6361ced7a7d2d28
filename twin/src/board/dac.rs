//! DAC1: the drive signal, of the channel the board has it on.
//!
//! RM0433 Rev 9, chapter 26. A write to a data holding register reaches the output at once without a
//! trigger (`TEN` clear), or at the next trigger `TSEL` selects: software, or TIM6's trigger output.
//! With `DMAEN` each trigger that moved a value asks for the next one; a trigger that finds the last
//! request unserved sets `DMAUDR`, and requests stop until it is cleared (section 26.4.8).
//! The output register keeps its value while the channel is off: a channel enabled before anything
//! was loaded puts code 0, full negative drive, on the pin. While it is off the pin floats and the
//! output stage's bias network holds mid-scale.
//!
//! Left out: the other channel (its registers store), wave generation, calibration, sample and hold, each
//! told to the run. `MODE` 3 leaves the pin floating; it and 1 reach ADC2 on the chip (`flaws`).

use rigless::device::{Device, DeviceContext, Level, RegisterFile};
use rigless::soc::stm32h743::generated::dac::{Register, cr, mcr, sr, swtrgr};
use rigless::time::VirtualNanos;

use super::analog::{Analog, Pins};
use super::flaws::{Flaws, State};
use super::request_lines::{DAC_CHANNELS, RequestLines};
use crate::rig_port::DRIVE_MID_CODE;

/// Request lines on which a software trigger of either channel wakes the DMA.
pub(super) const SOFTWARE_REQUESTS: [usize; 2] = [0, 1];
/// The instance's name, as listeners see it.
pub(super) const NAME: &str = "DAC";
const UNDERRUN_LINE: usize = 0;

/// The fields of channel 2 lie so many bits above those of channel 1, which the masks here are of.
const CHANNEL_BITS: u32 = 16;
/// Both channels' data holding registers, right and left aligned and of 8 bits, and output registers.
const HOLDING: [[Register; 3]; 2] = [
    [Register::Dhr12r1, Register::Dhr12l1, Register::Dhr8r1],
    [Register::Dhr12r2, Register::Dhr12l2, Register::Dhr8r2],
];
const OUTPUT: [Register; 2] = [Register::Dor1, Register::Dor2];

/// `TSEL` of a software trigger and of TIM6's (RM0433 Rev 9, table 225).
const SOFTWARE: u64 = 0;
/// Code that stands for an invalid output: no drive code is worse.
const INVALID_CODE: u16 = 4095;
const TIM6_TRGO: u64 = 5;

/// The model's state beside the registers.
#[derive(Debug)]
pub(super) struct Dac {
    /// Channel that is wired: 0 or 1.
    channel: usize,
    analog: Analog,
    flaws: Flaws,
    lines: RequestLines,
    /// Its data holding register, whatever the alignment it was written in.
    holding: u16,
    /// A DMA request stands.
    pending: bool,
    /// Something was loaded since the reset.
    loaded: bool,
    /// The output is invalid until the next reset.
    spoiled: bool,
}

rigless::store!(Dac {
    values: [holding, pending, loaded, spoiled],
    parts: [],
    built: [channel, analog, flaws, lines],
});

/// Stage between the output register and the pin.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutputStage {
    on_pin: bool,
    /// It reaches the converters on the chip.
    on_chip: bool,
    buffered: bool,
    spoiled: bool,
}

impl Dac {
    pub(super) fn new(channel: usize, analog: Analog, flaws: Flaws, lines: RequestLines) -> Self {
        Self {
            channel,
            analog,
            flaws,
            lines,
            holding: 0,
            pending: false,
            loaded: false,
            spoiled: false,
        }
    }

    /// Value of a register for the wired channel, as if it were channel 1.
    fn own(&self, registers: &RegisterFile, register: Register) -> u64 {
        registers.get(register) >> self.shift()
    }

    fn shift(&self) -> u32 {
        CHANNEL_BITS * self.channel as u32
    }

    /// TIM6's trigger output pulses.
    pub(super) fn on_tim6(
        &mut self,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        if cr::TSEL1.get(self.own(registers, Register::Cr)) == TIM6_TRGO {
            self.trigger(registers, context);
        }
    }

    /// Moves the holding register to the output.
    fn load(&self, registers: &mut RegisterFile, context: &DeviceContext<'_>) {
        registers.set(OUTPUT[self.channel], u64::from(self.holding));
        self.drive_pin(registers, context);
    }

    fn drive_pin(&self, registers: &RegisterFile, context: &DeviceContext<'_>) {
        let held = registers.get(OUTPUT[self.channel]) as u16;
        let stage = self.stage(registers);
        let (mut pins, mut flaws) = (self.analog.lock(), self.flaws.lock());
        pins.buffer_drive(stage.buffered, context.now());
        stage.put(held, &mut flaws, &mut pins, context.now());
    }

    /// Stage behind the output register.
    pub(super) fn stage(&self, registers: &RegisterFile) -> OutputStage {
        let enabled = cr::EN1.is_set(self.own(registers, Register::Cr));
        // Modes 0 to 2 reach the pin, 1 and 3 the converters on the chip; 2 and 3 are those without the
        // buffer; bit 2 selects sample and hold.
        let mode = mcr::MODE1.get(self.own(registers, Register::Mcr)) & 0b11;
        OutputStage {
            on_pin: enabled && mode != 0b11,
            on_chip: enabled && mode & 1 == 1,
            buffered: mode != 0b10,
            spoiled: self.spoiled,
        }
    }

    /// Where the next value of a stream of triggers by TIM6 is written, and the line it is asked for on, while
    /// triggers lead to nothing else.
    pub(super) fn streams(&self, registers: &RegisterFile) -> Option<(Register, usize)> {
        let control = self.own(registers, Register::Cr);
        let on = [&cr::EN1, &cr::TEN1, &cr::DMAEN1];
        let asks = on.iter().all(|field| field.is_set(control))
            && cr::TSEL1.get(control) == TIM6_TRGO
            && !self.pending
            && !sr::DMAUDR1.is_set(self.own(registers, Register::Sr));
        asks.then_some((HOLDING[self.channel][0], DAC_CHANNELS[self.channel]))
    }

    /// Code that the next trigger moves to the output.
    pub(super) fn holding(&self) -> u16 {
        self.holding
    }

    /// Takes a value of the stream, written to the register of [`streams`](Self::streams).
    pub(super) fn take(&mut self, code: u64) {
        self.loaded = true;
        self.holding = (code & 0xFFF) as u16;
    }

    /// ES0392, 2.11.1, revision V: a mode other than 0 for a channel that is off and was never loaded
    /// makes its output invalid.
    fn spoil(&mut self, registers: &RegisterFile) {
        let off = !cr::EN1.is_set(self.own(registers, Register::Cr));
        let mode = mcr::MODE1.get(self.own(registers, Register::Mcr));
        self.spoiled |= off && mode != 0 && !self.loaded;
    }

    fn trigger(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let control = self.own(registers, Register::Cr);
        if !cr::EN1.is_set(control) || !cr::TEN1.is_set(control) {
            return;
        }
        self.load(registers, context);
        if !cr::DMAEN1.is_set(control) || sr::DMAUDR1.is_set(self.own(registers, Register::Sr)) {
            return;
        }
        if self.pending {
            let status = registers.get(Register::Sr) | sr::DMAUDR1.mask() << self.shift();
            registers.set(Register::Sr, status);
            self.drive_interrupt(registers, context);
        } else {
            self.pending = true;
            self.lines.drive(DAC_CHANNELS[self.channel], true);
        }
    }

    fn withdraw(&mut self) {
        self.pending = false;
        self.lines.drive(DAC_CHANNELS[self.channel], false);
    }

    fn drive_interrupt(&self, registers: &RegisterFile, context: &mut DeviceContext<'_>) {
        let enabled = cr::DMAUDRIE1.is_set(self.own(registers, Register::Cr));
        let flag = sr::DMAUDR1.is_set(self.own(registers, Register::Sr));
        context.interrupt(UNDERRUN_LINE, Level::from(enabled && flag));
    }

    fn hold(&mut self, code: u64, registers: &mut RegisterFile, context: &DeviceContext<'_>) {
        self.take(code);
        self.withdraw();
        if !cr::TEN1.is_set(self.own(registers, Register::Cr)) {
            self.load(registers, context);
        }
    }

    fn control_written(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        let control = self.own(registers, Register::Cr);
        if cr::WAVE1.get(control) != 0 || cr::CEN1.is_set(control) {
            context.tell("CR", "wave generation and calibration are not modelled");
        }
        let other = CHANNEL_BITS * (1 - self.channel) as u32;
        if cr::EN1.is_set(registers.get(Register::Cr) >> other) {
            context.tell(
                "CR",
                "this channel is not wired on this board and not modelled",
            );
        }
        if !cr::DMAEN1.is_set(control) {
            self.withdraw();
        }
        self.drive_interrupt(registers, context);
        self.drive_pin(registers, context);
    }
}

impl OutputStage {
    /// The pins have been told whether there is a buffer.
    pub(super) fn is_set(self, pins: &Pins) -> bool {
        pins.buffers_drive() == self.buffered
    }

    /// The output register holds `held` from `now` on.
    pub(super) fn put(self, held: u16, flaws: &mut State, pins: &mut Pins, now: VirtualNanos) {
        let output = flaws.dac(if self.spoiled { INVALID_CODE } else { held });
        flaws.connect(self.on_chip.then_some(output));
        pins.drive(if self.on_pin { output } else { DRIVE_MID_CODE }, now);
    }
}

impl Device for Dac {
    type Register = Register;

    fn write(
        &mut self,
        register: Register,
        value: u64,
        registers: &mut RegisterFile,
        context: &mut DeviceContext<'_>,
    ) {
        match register {
            Register::Cr => self.control_written(registers, context),
            Register::Mcr => {
                if cr::EN1.is_set(self.own(registers, Register::Cr)) {
                    context.tell("MCR", "a mode is written while the channel is on");
                }
                self.spoil(registers);
                self.drive_pin(registers, context);
            }
            Register::Swtrgr if swtrgr::SWTRIG1.is_set(value >> self.channel) => {
                if cr::TSEL1.get(self.own(registers, Register::Cr)) == SOFTWARE {
                    self.trigger(registers, context);
                    if self.pending {
                        context.request(SOFTWARE_REQUESTS[self.channel], Level::High);
                    }
                }
            }
            Register::Dhr12rd => self.hold(value >> self.shift(), registers, context),
            Register::Dhr12ld => self.hold(value >> self.shift() >> 4, registers, context),
            Register::Dhr8rd => {
                self.hold(value >> (self.shift() / 2) << 4, registers, context);
            }
            Register::Sr => {
                // rc_w1, section 26.7.14.
                let kept = !value & sr::DMAUDR1.mask() << self.shift();
                registers.set(Register::Sr, kept & registers.get(Register::Sr));
                self.drive_interrupt(registers, context);
            }
            _ => match HOLDING[self.channel]
                .iter()
                .position(|own| *own == register)
            {
                Some(0) => self.hold(value, registers, context),
                Some(1) => self.hold(value >> 4, registers, context),
                Some(_) => self.hold(value << 4, registers, context),
                None => {}
            },
        }
    }

    fn reset(&mut self) {
        self.holding = 0;
        (self.loaded, self.spoiled) = (false, false);
        self.withdraw();
    }

    fn reset_line(&mut self, registers: &mut RegisterFile, context: &mut DeviceContext<'_>) {
        self.withdraw();
        self.holding = 0;
        (self.loaded, self.spoiled) = (false, false);
        self.drive_pin(registers, context);
    }
}
