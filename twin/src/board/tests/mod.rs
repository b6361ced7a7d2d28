//! The models, driven register by register as a driver does, without a core.

mod arithmetic;
mod converters;
mod dither;
mod dma;
mod drive;
mod flash;
mod panel;
mod sample_clock;
mod stretches;
mod supply;
mod temperature;
mod watchdog;

use std::sync::{Arc, Mutex};

use rigless::device::ResetCause;
use rigless::emulator::{Error, Memory};
use rigless::mcu::{Mcu, Operate};
use rigless::soc::stm32h743::generated::{self, rcc};
use rigless::soc::{Layout, Peripheral, Width};
use rigless::time::VirtualNanos;

use super::{Analog, Part, Pins, Schematic};
use crate::rig_port::{Dither, INPUT_CHANNELS, RigPort};

/// Log of a recording rig: each stretch of constant drive, and when it was sampled.
#[derive(Debug, Default)]
struct Told {
    holds: Vec<(u16, u64)>,
    samples: u16,
    dither: Option<Dither>,
}

/// A rig that writes down what it is told and gives codes that count the samples.
struct Recorder(Arc<Mutex<Told>>);

impl RigPort for Recorder {
    fn hold(&mut self, drive_code: u16, duration_ns: u64) {
        let mut told = self.0.lock().unwrap();
        told.holds.push((drive_code, duration_ns));
    }

    fn set_dither(&mut self, dither: Option<Dither>) {
        self.0.lock().unwrap().dither = dither;
    }

    fn sample(&mut self) -> [u16; INPUT_CHANNELS] {
        let mut told = self.0.lock().unwrap();
        told.samples += 1;
        [0x1000 + told.samples, 0x2000 + told.samples]
    }
}

/// RAM for the DMA: AXI SRAM's first kilobytes. Whatever else is read is erased flash.
struct Ram(Vec<u8>);

const RAM: u64 = 0x2400_0000;

impl Memory for Ram {
    fn read(&mut self, address: u64, width: Width) -> Result<u64, Error> {
        if address < RAM {
            return Ok(width.mask());
        }
        let at = (address - RAM) as usize;
        let bytes = &self.0[at..at + width.bytes() as usize];
        Ok(bytes
            .iter()
            .rev()
            .fold(0, |value, byte| value << 8 | u64::from(*byte)))
    }

    fn write(&mut self, address: u64, width: Width, value: u64) -> Result<(), Error> {
        let at = (address - RAM) as usize;
        let bytes = value.to_le_bytes();
        self.0[at..at + width.bytes() as usize].copy_from_slice(&bytes[..width.bytes() as usize]);
        Ok(())
    }
}

/// A part alone, with every clock this board's drivers enable.
struct Rigged {
    part: Part,
    ram: Ram,
    now: u64,
    told: Arc<Mutex<Told>>,
    analog: Analog,
    restarts: Vec<ResetCause>,
}

impl Rigged {
    fn new() -> Self {
        Self::on(Schematic::nucleo_h743zi2())
    }

    fn on(schematic: Schematic) -> Self {
        let told = Arc::new(Mutex::new(Told::default()));
        let pins = Pins::new(Arc::new(schematic), Box::new(Recorder(told.clone())));
        let analog = pins.analog.clone();
        let part = Part::new(pins).unwrap();
        let mut rigged = Self {
            part,
            ram: Ram(vec![0; 4096]),
            now: 0,
            told,
            analog,
            restarts: Vec::new(),
        };
        rigged.enable_clocks();
        rigged
    }

    /// DMA1, ADC1/2, TIM3, TIM6, DAC1 and the ports, the converters on `per_ck`, which is the 64 MHz HSI.
    fn enable_clocks(&mut self) {
        use rcc::Register;
        for (register, value) in [
            (Register::Ahb1enr, 1 | 1 << 5),
            (Register::Apb1lenr, 1 << 1 | 1 << 4 | 1 << 29),
            (Register::Ahb4enr, 0x7FF),
            (Register::D3ccipr, 0b10 << 16),
        ] {
            self.write(&generated::RCC, register, value);
        }
    }

    fn write<L: Layout>(&mut self, instance: &Peripheral, register: L, value: u64) {
        let address = instance.base + u64::from(register.spec().offset);
        let at = VirtualNanos(self.now);
        self.part.write(at, address, Width::W32, value).unwrap();
        self.settle();
    }

    fn read<L: Layout>(&mut self, instance: &Peripheral, register: L) -> u64 {
        let address = instance.base + u64::from(register.spec().offset);
        let value = self.part.read(VirtualNanos(self.now), address, Width::W32);
        self.settle();
        value.unwrap()
    }

    /// Runs the part for `ns`, event by event.
    fn run(&mut self, ns: u64) {
        let until = self.now + ns;
        while let Some(next) = self.part.next_event().filter(|next| next.0 <= until) {
            self.now = next.0;
            self.part.advance_to(next);
            self.part.poll(next);
            self.settle();
        }
        self.now = until;
    }

    fn settle(&mut self) {
        let refused = self.part.settle(&mut self.ram).unwrap();
        assert!(refused.is_empty(), "the bus refused {refused:?}");
        if let Some(cause) = self.part.take_reset_request() {
            self.restarts.push(cause);
            self.part.reset(VirtualNanos(self.now), cause);
        }
    }

    /// Levels of interrupt `line` since the last call, oldest first.
    fn interrupts(&mut self, line: u16) -> Vec<bool> {
        let changes = self.part.drain_interrupts().into_iter();
        changes
            .filter(|change| change.interrupt == line)
            .map(|change| change.level == rigless::device::Level::High)
            .collect()
    }

    /// Starts TIM6 at `ticks` of its 64 MHz clock per update, update as trigger output.
    fn start_sample_clock(&mut self, ticks: u64) {
        use generated::tim6::Register;
        self.write(&generated::TIM6, Register::Arr, ticks - 1);
        self.write(&generated::TIM6, Register::Cr2, 0b010 << 4);
        self.write(&generated::TIM6, Register::Cr1, 1);
    }

    fn told(&self) -> std::sync::MutexGuard<'_, Told> {
        self.told.lock().unwrap()
    }
}
