//! Samples made many at a time while the core sleeps: as if each had been made alone.

use rigless::mcu::{Mcu, Operate};
use rigless::soc::stm32h743::generated::adc3::Register as Adc;
use rigless::soc::stm32h743::generated::adc3_common::Register as Pair;
use rigless::soc::stm32h743::generated::dac::Register as Dac;
use rigless::soc::stm32h743::generated::dma1::Register as Dma;
use rigless::soc::stm32h743::generated::tim6::Register as Tim;
use rigless::soc::stm32h743::generated::{
    ADC1, ADC2, ADC12_COMMON, DAC, DMA1, DMAMUX1, TIM6, dmamux1,
};
use rigless::soc::{Layout, Peripheral};
use rigless::time::VirtualNanos;

use super::{RAM, Rigged, converters};

/// Where the drive's ring is, and how long each ring is, in items.
const DRIVE_AT: usize = 2048;
/// Interrupt lines of the DMA's first two streams.
const LINES: [u16; 2] = [11, 12];
const TICK_NS: u64 = 20_000;

/// Rings of drive and pairs under way: a length in items for each.
fn playing(drive: u64, pairs: u64) -> Rigged {
    let mut rigged = Rigged::new();
    converters::enable(&mut rigged);
    for place in 0..drive as usize {
        let code = (2048 + 7 * place as u16).to_le_bytes();
        rigged.ram.0[DRIVE_AT + 2 * place..][..2].copy_from_slice(&code);
    }
    rigged.write(&DMAMUX1, dmamux1::Register::DmamuxC0cr, 9);
    rigged.write(&DMAMUX1, dmamux1::Register::DmamuxC1cr, 67);
    rigged.write(&DMA1, Dma::S0par, ADC12_COMMON.base + 0xC);
    rigged.write(&DMA1, Dma::S0m0ar, RAM);
    rigged.write(&DMA1, Dma::S0ndtr, pairs);
    rigged.write(&DMA1, Dma::S1par, DAC.base + 8);
    rigged.write(&DMA1, Dma::S1m0ar, RAM + DRIVE_AT as u64);
    rigged.write(&DMA1, Dma::S1ndtr, drive);
    // Circular, memory increment, half and full interrupts, enabled; words in, halfwords out.
    let both = 1 << 8 | 1 << 10 | 0b11 << 3 | 1;
    rigged.write(&DMA1, Dma::S0cr, both | 0b10 << 11 | 0b10 << 13);
    rigged.write(&DMA1, Dma::S1cr, both | 0b01 << 6 | 0b01 << 11 | 0b01 << 13);
    rigged.write(&DAC, Dac::Dhr12r1, 2048);
    rigged.write(&DAC, Dac::Cr, 1 | 1 << 1 | 5 << 2 | 1 << 12);
    converters::start(&mut rigged);
    rigged
}

impl Rigged {
    /// Sleeps for `ns`, as the run lets a core that waits; answers when each of the lines changed.
    fn sleep(&mut self, ns: u64) -> Vec<(u64, u16, bool)> {
        let (until, mut changes) = (self.now + ns, Vec::new());
        let mut due = self.part.next_event();
        while let Some(next) = due.filter(|next| next.0 <= until) {
            let limit = VirtualNanos(until + 1);
            let come_to = self.part.pass(next, limit, &mut self.ram);
            self.now = come_to.0.clamp(next.0, until);
            if come_to < limit {
                changes.extend(self.stop());
            }
            due = self.part.next_event();
        }
        self.now = until;
        changes
    }

    /// As `run`, with a stop at each event.
    fn wake(&mut self, ns: u64) -> Vec<(u64, u16, bool)> {
        let (until, mut changes) = (self.now + ns, Vec::new());
        while let Some(next) = self.part.next_event().filter(|next| next.0 <= until) {
            self.now = next.0;
            changes.extend(self.stop());
        }
        self.now = until;
        changes
    }

    fn stop(&mut self) -> Vec<(u64, u16, bool)> {
        let now = VirtualNanos(self.now);
        self.part.advance_to(now);
        self.part.poll(now);
        self.settle();
        let mut changes = self.part.drain_interrupts();
        changes.retain(|change| LINES.contains(&change.interrupt));
        // All of one instant are there before the core looks.
        changes.sort_by_key(|change| change.interrupt);
        let high = |level| level == rigless::device::Level::High;
        let changes = changes.into_iter();
        changes
            .map(|change| (self.now, change.interrupt, high(change.level)))
            .collect()
    }

    /// Everything a core or the rig can see of the samples.
    fn seen(&mut self) -> Vec<u64> {
        fn all<L: Layout>(rigged: &mut Rigged, of: &Peripheral, registers: &[L]) -> Vec<u64> {
            let each = registers.iter();
            each.map(|register| rigged.read(of, *register)).collect()
        }
        let dma = [
            Dma::Lisr,
            Dma::S0cr,
            Dma::S0ndtr,
            Dma::S0fcr,
            Dma::S1ndtr,
            Dma::S1fcr,
        ];
        let mut seen = [
            all(self, &DMA1, &dma),
            all(self, &DAC, &[Dac::Sr, Dac::Dor1, Dac::Dhr12r1]),
            all(self, &ADC1, &[Adc::Isr]),
            all(self, &ADC2, &[Adc::Isr]),
            all(self, &TIM6, &[Tim::Sr, Tim::Cnt]),
            all(self, &ADC12_COMMON, &[Pair::Csr, Pair::Cdr]),
        ]
        .concat();
        let silent = self.analog.silent_since();
        seen.extend([self.analog.samples(), u64::from(self.analog.drive_code())]);
        seen.extend(silent.map(|since| since.0));
        seen
    }
}

/// Rings that end within a stretch, at its end and far behind it; halves that are no whole number of items;
/// naps that end between samples, on one and one nanosecond before.
#[test]
fn a_stretch_of_samples_is_each_of_them() {
    for (drive, pairs) in [(100, 250), (33, 7), (2, 64), (129, 130), (500, 333), (1, 3)] {
        let mut each = playing(drive, pairs);
        let mut many = playing(drive, pairs);
        for ticks in [0, 1, 2, 3, 9, 63, 64, 65, 66, 200, 700] {
            for beside in [0, 1, TICK_NS - 1, 12_345] {
                let ns = ticks * TICK_NS + beside;
                assert_eq!(many.sleep(ns), each.wake(ns), "{drive} {pairs} {ns}");
                assert_eq!(many.seen(), each.seen(), "{drive} {pairs} {ns}");
            }
        }
        assert!(many.ram.0 == each.ram.0, "{drive} {pairs}: other memory");
        assert_eq!(many.told().holds, each.told().holds, "{drive} {pairs}");
    }
}

/// A stretch passes over no other consequence of a sample: an overrun, an interrupt of the converters, a shut
/// gate, pins that change.
#[test]
fn a_stretch_ends_where_a_sample_does_more() {
    type Change = fn(&mut Rigged);
    let changes: [Change; 6] = [
        |rigged| rigged.write(&ADC1, Adc::Ier, 1 << 3),
        |rigged| rigged.write(&DAC, Dac::Mcr, 0b10),
        |rigged| rigged.write(&DMA1, Dma::S0cr, 0),
        |rigged| rigged.write(&DMA1, Dma::S1cr, 0),
        |rigged| rigged.write(&ADC1, Adc::Sqr1, 3 << 6),
        |rigged| {
            use rigless::soc::stm32h743::generated::{RCC, rcc::Register};
            rigged.write(&RCC, Register::Ahb1enr, 1);
        },
    ];
    for (nth, change) in changes.into_iter().enumerate() {
        let mut each = playing(100, 250);
        let mut many = playing(100, 250);
        for rigged in [&mut each, &mut many] {
            rigged.wake(10 * TICK_NS);
            change(rigged);
        }
        assert_eq!(many.sleep(90 * TICK_NS), each.wake(90 * TICK_NS), "{nth}");
        for rigged in [&mut each, &mut many] {
            use rigless::soc::stm32h743::generated::{RCC, rcc::Register};
            rigged.write(&RCC, Register::Ahb1enr, 1 | 1 << 5);
        }
        assert_eq!(many.seen(), each.seen(), "{nth}");
        assert!(many.ram.0 == each.ram.0, "{nth}: other memory");
        assert_eq!(many.told().holds, each.told().holds, "{nth}");
    }
}
