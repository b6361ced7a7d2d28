//! DMA1 beside the emulator's own controller, which knows every mode: in direct mode nobody can tell
//! them apart.

use rigless::device::{Device, DeviceContext, Level, RegisterFile, RequestChange};
use rigless::mcu::{Operate, Single};
use rigless::soc::stm32h743::generated::DMA1;
use rigless::soc::stm32h743::generated::dma1::Register;
use rigless::soc::stm32h743::peripherals::dma::{DMA1_FIRST_CHANNEL, Dma};
use rigless::soc::{Layout, Width};
use rigless::time::VirtualNanos;

use super::super::dma1::{Dma1, STREAMS};
use super::super::dmamux;
use super::super::flash::FlashWatch;
use super::super::memory_map;
use super::super::request_lines::{DAC_CHANNELS, RequestLines};
use super::{RAM, Ram};

/// A register without a side effect, for a peripheral's side: DAC's `DHR12R1` as a plain store.
const PERIPHERAL: u64 = 0x4000_7408;
const NOW: VirtualNanos = VirtualNanos(0);
/// Steps of the script; each stream ends, goes round and is stopped dozens of times.
const STEPS: usize = 4000;

/// One of the two controllers on a bus of its own.
struct Rigged<D> {
    single: Single<D>,
    ram: Ram,
}

impl<D: Device<Register = Register> + 'static> Rigged<D> {
    fn new(model: D) -> Self {
        let builder = memory_map::builder();
        let bytes = (0..4096)
            .map(|at: usize| (at * 7 + at / 256) as u8)
            .collect();
        Self {
            single: Single::new(builder, "DMA1", model).unwrap(),
            ram: Ram(bytes),
        }
    }

    fn write(&mut self, register: Register, value: u64) {
        let address = DMA1.base + u64::from(register.spec().offset);
        self.single.write(NOW, address, Width::W32, value).unwrap();
    }

    fn drive(&mut self, act: impl FnOnce(&mut D, &mut RegisterFile, &mut DeviceContext<'_>)) {
        self.single.drive(NOW, act);
    }

    /// Every register, the peripheral's, and the interrupts raised and lowered since.
    fn look(&mut self) -> (Vec<u64>, String) {
        self.single.settle(&mut self.ram).unwrap();
        let addresses = Register::ALL.map(|register| DMA1.base + u64::from(register.spec().offset));
        let registers = addresses.into_iter().chain([PERIPHERAL]);
        let values = registers
            .map(|address| self.single.read(NOW, address, Width::W32).unwrap())
            .collect();
        (values, format!("{:?}", self.single.drain_interrupts()))
    }
}

fn request(stream: usize, level: Level) -> RequestChange {
    RequestChange {
        instance: dmamux::NAME,
        request: stream,
        level,
    }
}

/// A write the script makes to a register of `stream`.
fn drawn(stream: usize, draw: &mut impl FnMut(u64) -> u64) -> (Register, u64) {
    let row = |row: usize| Register::ALL[4 + 6 * stream + row];
    match draw(8) {
        0 => (row(1), 1 + draw(9)),
        1 => (
            row(2),
            [PERIPHERAL, PERIPHERAL, 0x2000_0000][draw(3) as usize],
        ),
        2 => (row(3), RAM + 64 * stream as u64 + 4 * draw(4)),
        3 => (row(5), draw(2) << 7),
        4 => (Register::Lifcr, draw(1 << 28)),
        5 => (Register::Hifcr, draw(1 << 28)),
        // Enables and disables, with each direction, width, step and set of interrupts.
        _ => {
            let (interrupts, direction) = (draw(16) << 1, draw(2) << 6);
            let (circular, steps) = (draw(2) << 8, draw(2) << 10);
            let widths = (draw(3) << 11) | (draw(3) << 13);
            (
                row(0),
                draw(2) | interrupts | direction | circular | steps | widths,
            )
        }
    }
}

#[test]
fn both_controllers_move_the_same() {
    let lines = RequestLines::new();
    let mut ours = Rigged::new(Dma1::new(lines.clone(), FlashWatch::default()));
    let mut theirs = Rigged::new(Dma::new(DMA1_FIRST_CHANNEL));
    let mut state = 1_u64;
    let mut draw = |below: u64| {
        // Numerical Recipes' linear congruence, upper bits.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    for step in 0..STEPS {
        let stream = draw(STREAMS as u64) as usize;
        if draw(3) > 0 {
            // A peripheral lowers its line at the access that serves it.
            lines.select(stream, DAC_CHANNELS[0]);
            lines.drive(DAC_CHANNELS[0], true);
            ours.drive(|model, registers, context| {
                model.on_request(request(stream, Level::High), registers, context);
            });
            lines.drive(DAC_CHANNELS[0], false);
            for level in [Level::High, Level::Low] {
                theirs.drive(|model, registers, context| {
                    model.on_request(request(stream, level), registers, context);
                });
            }
        } else {
            let (register, value) = drawn(stream, &mut draw);
            ours.write(register, value);
            theirs.write(register, value);
        }
        assert_eq!(ours.look(), theirs.look(), "after step {step}");
        assert_eq!(ours.ram.0, theirs.ram.0, "memory after step {step}");
    }
}
