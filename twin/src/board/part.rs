//! The STM32H743ZI as this board needs it: the emulator's part with our own models in it.
//!
//! A part is a bus, which decodes an address to a slot, and a model for a slot. Ours is the
//! emulator's, on our own bus ([`memory_map`]), with TIM3, TIM6, DAC, ADC1, ADC2, their common block,
//! DMA1, DMAMUX1, the flash interface, SYSCFG and IWDG answered by the models next door.

mod at_once;
mod stretch;

use rigless::device::{Device, ErasedDevice, ResetCause};
use rigless::emulator::{Checked, Memory};
use rigless::mcu::{Mcu, Operate};
use rigless::soc::stm32h743::Stm32h743;
use rigless::soc::stm32h743::generated::pwr::csr1;
use rigless::soc::stm32h743::generated::{EXTI, dbgmcu, exti, flash, pwr, rcc, rtc};
use rigless::soc::stm32h743::peripherals::dbg::KEPT_BY_A_SYSTEM_RESET;
use rigless::soc::stm32h743::peripherals::flash::OptionBytes;
use rigless::soc::{Bus, Error, Layout, Width};
use rigless::time::VirtualNanos;

use super::adc::{self, Common, Converter, SharedPair};
use super::check_bits::{self, Met};
use super::dac::Dac;
use super::dma1::Dma1;
use super::dmamux::Dmamux;
use super::flash::{CutOff, FlashWatch, SET_UP, WatchedFlash, bank_of, nth_word};
use super::flaws::{Flaws, Lasting};
use super::input_pin;
use super::iwdg::Iwdg;
use super::memory_map;
use super::overdrive::WatchedSyscfg;
use super::pins::{Pins, SUPPLY_MV};
use super::request_lines::RequestLines;
use super::schematic::{Pin, Schematic};
use super::tim3::{self, Tim3};
use super::tim6::{self, Tim6};
use super::usb::UsbWindow;

/// Bit of the voltage detector in the registers of EXTI lines 0 to 31.
const DETECTOR_LINE: u64 = 1 << 16;
/// Place of ADC3 among the emulator's converters.
const ADC3: usize = 2;

/// Our own models, and how a slot finds its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Own {
    Tim3,
    Tim6,
    Dac,
    Dmamux,
    Dma1,
    Converter(usize),
    Common,
    Flash,
    Iwdg,
    Syscfg,
    Usb,
}

const OWN: [(&str, Own); 11] = [
    (tim3::NAME, Own::Tim3),
    (tim6::NAME, Own::Tim6),
    (super::dac::NAME, Own::Dac),
    (super::dmamux::NAME, Own::Dmamux),
    (super::dma1::NAME, Own::Dma1),
    ("ADC1", Own::Converter(0)),
    ("ADC2", Own::Converter(1)),
    (adc::NAME, Own::Common),
    ("Flash", Own::Flash),
    ("IWDG", Own::Iwdg),
    ("SYSCFG", Own::Syscfg),
];

/// The part, out of reset, with the board's crystal, rail and serial line on its pins.
#[derive(Debug)]
pub struct Part {
    /// The emulator's part. Its bus is ours.
    pub(super) base: Stm32h743,
    tim3: Tim3,
    tim6: Tim6,
    dac: Dac,
    dmamux: Dmamux,
    dma1: Dma1,
    converters: [Converter; 2],
    common: Common,
    flash: WatchedFlash,
    iwdg: Iwdg,
    syscfg: WatchedSyscfg,
    usb: UsbWindow,
    usb_slot: usize,
    pins: Pins,
    own: Box<[Option<Own>]>,
    serial_slot: usize,
    slots: SampleSlots,
    /// Ports of the inputs' pins and of the dither's, and whether one was used since the converters were told
    /// of it.
    pin_ports: [usize; 3],
    ports_used: bool,
    /// ADC3 is the emulator's; it is told how warm the part is.
    adc3_slot: usize,
    /// The rail the board gives the part.
    supply_mv: u32,
}

/// Where on the bus the instances are that a sample passes.
#[derive(Debug, Clone, Copy)]
struct SampleSlots {
    tim6: usize,
    dac: usize,
    common: usize,
    dma1: usize,
}

rigless::store!(Part {
    values: [supply_mv, ports_used],
    parts: [
        base, tim3, tim6, dac, dmamux, dma1, converters, common, flash, iwdg, syscfg, usb, pins,
    ],
    built: [usb_slot, own, serial_slot, adc3_slot, slots, pin_ports],
});

impl Part {
    /// A part after power-on with `pins` connected.
    ///
    /// # Errors
    ///
    /// A mistake in [`memory_map`]: nothing a caller can cause.
    pub(super) fn new(pins: Pins) -> Result<Self, Error> {
        let mut base = Stm32h743::new()?;
        *base.bus_mut() = memory_map::bus(pins.faults.is_clocked())?;
        let (usb_slot, usb) = UsbWindow::add_to(base.bus_mut(), pins.usb.clone())?;
        let mut own = vec![None; base.bus().slots().len()].into_boxed_slice();
        own[usb_slot] = Some(Own::Usb);
        for (instance, model) in OWN {
            own[base.bus().slot(instance)?] = Some(model);
        }
        let pair = SharedPair::new(
            pins.analog.clone(),
            pins.flaws.clone(),
            pins.schematic.drive_channel,
            pins.schematic.input_channels,
            pins.schematic.converters_halve_their_clock(),
        );
        let lines = RequestLines::new();
        let slots = SampleSlots {
            tim6: base.bus().slot(tim6::NAME)?,
            dac: base.bus().slot(super::dac::NAME)?,
            common: base.bus().slot(adc::NAME)?,
            dma1: base.bus().slot(super::dma1::NAME)?,
        };
        let port = |pin: Pin| base.bus().slot_of(&pin.instance()).unwrap_or(usize::MAX);
        let mut part = Self {
            pin_ports: pins.schematic.sampled_pins().map(port),
            ports_used: true,
            serial_slot: base.bus().slot(pins.schematic.serial_name())?,
            adc3_slot: base.bus().slot("ADC3")?,
            supply_mv: SUPPLY_MV,
            base,
            tim3: Tim3::silent(),
            tim6: Tim6::new(),
            dac: Dac::new(
                pins.schematic.drive_channel,
                pins.analog.clone(),
                pins.flaws.clone(),
                lines.clone(),
            ),
            dmamux: Dmamux::new(lines.clone()),
            dma1: Dma1::new(lines.clone(), pins.flash.clone()),
            converters: [
                Converter::new(0, pair.clone(), pins.faults.clone()),
                Converter::new(1, pair.clone(), pins.faults.clone()),
            ],
            common: Common::new(pair, lines),
            flash: WatchedFlash::new(pins.flash.clone()),
            iwdg: Iwdg::new(),
            syscfg: WatchedSyscfg::default(),
            usb,
            usb_slot,
            pins,
            own,
            slots,
        };
        part.fit();
        part.set_options(SET_UP);
        part.suffer();
        part.check()?;
        Ok(part)
    }

    /// Levels the board puts on the pins.
    fn fit(&mut self) {
        self.base
            .rcc
            .attach_crystals(self.pins.schematic.clock_hz, 0);
        self.base.set_supply(SUPPLY_MV);
        self.base.set_analog_supply(SUPPLY_MV);
        self.base.usart[self.pins.schematic.serial].attach(self.pins.serial.clone());
        for converter in &mut self.base.adc {
            converter.set_reference(SUPPLY_MV);
        }
    }

    /// Hands to `fresh` what even a loss of the supply leaves alone: option bytes, and the levels
    /// outside on the pins.
    fn inherit_lasting(&mut self, fresh: &mut Self) {
        fresh.set_options(self.options());
        fresh.common.inherit_silicon(&self.common);
        for (fresh, old) in fresh.base.gpio.iter_mut().zip(&mut self.base.gpio) {
            *fresh = std::mem::take(old);
            Device::reset(fresh);
        }
    }

    /// The option bytes in force.
    pub(super) fn options(&self) -> OptionBytes {
        self.flash.inner.committed_options()
    }

    /// Others are in force from now on.
    pub(super) fn set_options(&mut self, options: OptionBytes) {
        if let Some(slot) = self.base.bus().slot_of("Flash") {
            let registers = self.base.bus_mut().slot_mut(slot).registers_mut();
            self.flash.inner.keep_options(options, registers);
        }
    }

    /// The flash interface shows what was read, and that its check bits did not fit.
    fn latch(&mut self, word: u64, met: Met) {
        if let (Some(bank), Some(slot)) = (bank_of(word), self.base.bus().slot_of("Flash")) {
            let registers = self.base.bus_mut().slot_mut(slot).registers_mut();
            check_bits::latch(bank, nth_word(bank, word), met, registers);
        }
    }

    /// Hands to `fresh` what a system reset leaves alone: RM0433 Rev 9, sections 8.4.2, 46.3.10 and
    /// 60.5.8, and the far ends of the serial ports.
    fn inherit(&mut self, fresh: &mut Self, cause: ResetCause) {
        std::mem::swap(&mut fresh.base.rcc, &mut self.base.rcc);
        Device::reset(&mut fresh.base.rcc);
        std::mem::swap(&mut fresh.base.pwr, &mut self.base.pwr);
        Device::reset(&mut fresh.base.pwr);
        let flags = self.register(rcc::Register::Rsr, "RCC");
        let (clocks, registers) = fresh.base.clocks();
        clocks.restarted(cause, flags, registers);
        for (fresh, old) in fresh.base.usart.iter_mut().zip(&mut self.base.usart) {
            fresh.inherit(old);
        }
        for register in KEPT_BY_A_SYSTEM_RESET {
            let kept = self.register::<dbgmcu::Register>(register, "DBGMCU");
            fresh.set_register(register, "DBGMCU", kept);
        }
        for register in rtc::Register::ALL {
            if register != rtc::Register::RtcWpr {
                let kept = self.register(register, "RTC");
                fresh.set_register(register, "RTC", kept);
            }
        }
    }

    /// How fast its core is.
    pub(super) fn instructions_per_s(&self) -> u64 {
        self.pins.instructions_per_s
    }

    /// The board around the part.
    pub(super) fn schematic(&self) -> &Schematic {
        &self.pins.schematic
    }

    /// Has what is broken show in a part that was just made, or broke just now. Converters look for
    /// themselves, and whether there is a clock decides how a part is made.
    pub(super) fn suffer(&mut self) {
        let protected = match self.pins.faults.flash_is_protected() {
            true => 0,
            false => OptionBytes::FACTORY.word(flash::Register::WpsnCur2r),
        };
        self.set_register(flash::Register::WpsnCur2r, "Flash", protected);
    }

    /// Faults of the part.
    pub(super) fn faults(&self) -> &Lasting {
        &self.pins.faults
    }

    /// Since when the regulator's overdrive has been on.
    pub(super) fn overdrive_since(&self) -> Option<VirtualNanos> {
        self.syscfg.overdrive_since()
    }

    pub(super) fn register<L: rigless::soc::Layout>(&self, register: L, instance: &str) -> u64 {
        memory_map::value(self.base.bus(), register, instance)
    }

    /// Flaws of the converters.
    pub(super) fn flaws(&self) -> &Flaws {
        &self.pins.flaws
    }

    /// The supply of the converters alone becomes `millivolts`, until the next reset.
    pub(super) fn set_converter_supply(&mut self, millivolts: u32) {
        self.base.adc[ADC3].set_reference(millivolts);
    }

    /// The pair of converters, for its faults.
    pub(super) fn converters(&mut self) -> &mut Common {
        &mut self.common
    }

    /// TIM6's trigger output pulses at `at`: both converters hear it, then the DMA what they ask for.
    fn sample(&mut self, at: VirtualNanos) {
        self.trigger_converters(at);
        let (registers, mut context) = self.base.bus_mut().drive(at, self.slots.dma1);
        self.dma1.serve(registers, &mut context);
    }

    fn trigger_converters(&mut self, at: VirtualNanos) {
        if std::mem::take(&mut self.ports_used) {
            let (bus, schematic) = (self.base.bus(), &self.pins.schematic);
            let connected = input_pin::dither_is_connected(bus, schematic);
            self.common.set_pulls(input_pin::pulls(bus, schematic));
            self.pins.analog.connect_dither(connected, at);
        }
        if let Some(wave) = self.tim3.take_change() {
            self.pins.analog.play_dither(wave, at);
        }
        let bus = self.base.bus_mut();
        let (registers, mut context) = bus.drive(at, self.slots.dac);
        self.dac.on_tim6(registers, &mut context);
        let (registers, mut context) = bus.drive(at, self.slots.common);
        self.common.on_tim6(registers, &mut context);
    }

    fn poll_slot(&mut self, slot: usize, now: VirtualNanos) {
        let (bus, model) = self.split(slot);
        if let Some(model) = model {
            let (registers, mut context) = bus.drive(now, slot);
            model.poll(registers, &mut context);
        }
    }

    /// The rail becomes `millivolts`. Where that is below the level of the voltage detector, its edge
    /// reaches the interrupt controller (RM0433 Rev 9, sections 6.5.3 and 20.4, line 16), which the
    /// emulator's models leave out.
    pub(crate) fn set_supply(&mut self, at: VirtualNanos, millivolts: u32) {
        let below = |part: &Self| csr1::PVDO.is_set(part.register(pwr::Register::Csr1, "PWR"));
        let before = below(self);
        self.supply_mv = millivolts;
        self.base.set_supply(millivolts);
        let rising = self.register(exti::Register::Rtsr1, "EXTI") & DETECTOR_LINE != 0;
        if !before && below(self) && rising {
            let address = EXTI.base + u64::from(exti::Register::Swier1.spec().offset);
            // Refused only where there is no such register.
            self.write(at, address, Width::W32, DETECTOR_LINE).ok();
        }
    }

    /// Cuts the supply of the part, or gives it back, when the run goes on.
    pub(crate) fn power(&mut self, at: VirtualNanos, on: bool) {
        let slot = self.serial_slot;
        let (_, mut context) = self.base.bus_mut().drive(at, slot);
        context.request_power(on);
    }

    /// The operation on the record flash that a cut at `at` would cut.
    pub(crate) fn flash_under_way(&self, at: VirtualNanos) -> Option<CutOff> {
        let (operation, progress) = self.pins.flash.any_under_way(at)?;
        Some(CutOff {
            operation,
            progress,
            at,
        })
    }

    /// Operations on the flash, and its poisoned words.
    pub(super) fn flash_watch(&self) -> FlashWatch {
        self.pins.flash.clone()
    }

    pub(super) fn set_register<L: rigless::soc::Layout>(
        &mut self,
        register: L,
        instance: &str,
        value: u64,
    ) {
        if let Some(slot) = self.base.bus().slot_of(instance) {
            let bus = self.base.bus_mut();
            bus.slot_mut(slot).registers_mut().set(register, value);
        }
    }
}

impl Mcu for Part {
    fn bus(&self) -> &Bus {
        self.base.bus()
    }

    fn bus_mut(&mut self) -> &mut Bus {
        self.base.bus_mut()
    }

    /// A system reset, or a power-on reset that keeps nothing but what never needs the supply.
    fn reset(&mut self, at: VirtualNanos, cause: ResetCause) {
        let Ok(mut fresh) = Self::new(self.pins.clone()) else {
            unreachable!("a part that was built once is built again from the same tables");
        };
        self.inherit_lasting(&mut fresh);
        if cause != ResetCause::PowerOn {
            self.inherit(&mut fresh, cause);
        }
        fresh.supply_mv = self.supply_mv;
        fresh.base.set_supply(self.supply_mv);
        self.pins.flash.cut(at);
        fresh.suffer();
        self.pins.write_buffer.on_reset(at);
        self.pins.usb.part_reset();
        // The drive's pin floats from here on, until a firmware enables the converter again.
        let analog = self.pins.analog.clone();
        analog.drive(crate::rig_port::DRIVE_MID_CODE, at);
        *self = fresh;
    }

    fn poll(&mut self, now: VirtualNanos) {
        if let Some(at) = self.tim6.take_pulse() {
            self.sample(at);
        }
        // Two instances have something outside that speaks on its own, and this is called at every
        // stop: ask them only when it has.
        if self.pins.serial.is_sending() {
            let errors = self.base.usart[self.pins.schematic.serial].errors_mut();
            self.pins.serial.garble(errors);
            self.poll_slot(self.serial_slot, now);
        }
        if self.pins.usb.has_news() {
            self.poll_slot(self.usb_slot, now);
        }
    }

    fn pass(
        &mut self,
        now: VirtualNanos,
        limit: VirtualNanos,
        memory: &mut dyn Memory,
    ) -> VirtualNanos {
        self.sample_at_once(now, limit, memory)
    }

    fn read_checked(
        &mut self,
        _at: VirtualNanos,
        address: u64,
        _report: bool,
        _memory: &mut dyn Memory,
    ) -> Option<Checked> {
        let (word, met) = self.pins.flash.note_load(address)?;
        self.latch(word, met);
        // What is mended is read like any other word.
        (met == Met::Poisoned).then_some(Checked::Uncorrectable)
    }

    fn mismatched_words(&mut self) -> Option<Vec<u64>> {
        self.pins.flash.take_change()
    }

    fn split(&mut self, slot: usize) -> (&mut Bus, Option<&mut dyn ErasedDevice>) {
        self.ports_used |= self.pin_ports.contains(&slot);
        if slot == self.adc3_slot {
            let rig_c = self.pins.analog.processor_centi_c();
            let centi_c = self.flaws().processor_centi_c().unwrap_or(rig_c);
            self.base.adc[ADC3].set_temperature(centi_c);
        }
        let Some(own) = self.own.get(slot).copied().flatten() else {
            return self.base.split(slot);
        };
        if let Own::Flash = own {
            for (word, met) in self.pins.flash.take_met_by_dma() {
                self.latch(word, met);
            }
        }
        let model: &mut dyn ErasedDevice = match own {
            Own::Tim3 => &mut self.tim3,
            Own::Tim6 => &mut self.tim6,
            Own::Dac => &mut self.dac,
            Own::Dmamux => &mut self.dmamux,
            Own::Dma1 => &mut self.dma1,
            Own::Converter(nth) => &mut self.converters[nth],
            Own::Common => &mut self.common,
            Own::Flash => &mut self.flash,
            Own::Iwdg => &mut self.iwdg,
            Own::Syscfg => &mut self.syscfg,
            Own::Usb => &mut self.usb,
        };
        (self.base.bus_mut(), Some(model))
    }
}
