//! The computer's floating-point unit answers what the emulated one does, flags included.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rigless::cpu::singles::{self, Operation};

/// Random operands of each operation.
const DRAWS: u32 = 1_000_000;

/// `FPSCR.IXC`, the flag that a rounded result raises (DDI 0403E.b, A2.5.3).
const INEXACT: u32 = 1 << 4;
/// `FPSCR` in the default mode with no flag up and with the one; then `DN`, `FZ`, and the three other
/// rounding modes.
const MODES: [u32; 7] = [
    0,
    INEXACT,
    1 << 25,
    1 << 24,
    0b01 << 22,
    0b10 << 22,
    0b11 << 22,
];

/// Zeros, the ends of the denormals and of the normal numbers, ties and neighbours of one, powers that
/// overflow and underflow together, ends of the integers, infinities, NaNs of both kinds. Each with
/// either sign.
const SPECIAL: [u32; 32] = [
    0x0000_0000,
    0x0000_0001,
    0x0000_0002,
    0x0040_0000,
    0x007F_FFFF,
    0x0080_0000,
    0x0080_0001,
    0x00FF_FFFF,
    0x0100_0000,
    0x0100_0001,
    0x1F80_0000,
    0x2000_0000,
    0x3300_0000,
    0x3380_0000,
    0x3380_0001,
    0x3F00_0000,
    0x3F7F_FFFF,
    0x3F80_0000,
    0x3F80_0001,
    0x3FC0_0000,
    0x4000_0000,
    0x4040_0000,
    0x4B00_0001,
    0x4EFF_FFFF,
    0x4F00_0000,
    0x4F80_0000,
    0x5F00_0000,
    0x7F7F_FFFF,
    0x7F80_0000,
    0x7F80_0001,
    0x7FC0_0000,
    0x7FC0_1234,
];

fn operations() -> Vec<Operation> {
    use Operation::{
        Add, Compare, CompareRaising, Divide, FromFixed, Maximum, Minimum, Multiply, MultiplyAdd,
        SquareRoot, Subtract, ToFixed,
    };
    let mut operations = vec![
        Add,
        Subtract,
        Multiply,
        Divide,
        SquareRoot,
        MultiplyAdd,
        Compare,
        CompareRaising,
        Maximum,
        Minimum,
    ];
    for signed in [false, true] {
        for fraction_bits in [0, 15, 32] {
            operations.extend([false, true].map(|truncated| ToFixed {
                signed,
                fraction_bits,
                truncated,
            }));
            operations.extend([16, 32].map(|size| FromFixed {
                signed,
                fraction_bits: fraction_bits.min(size),
                size,
            }));
        }
    }
    operations
}

#[track_caller]
fn compare(operation: Operation, operands: [u32; 3], fpscr: u32) {
    assert_eq!(
        singles::host(operation, operands, fpscr),
        singles::software(operation, operands, fpscr),
        "{operation:?} of {operands:#010x?} with FPSCR {fpscr:#x}"
    );
}

/// Any bits; or a number within 32 binades of one, so that sums meet; or a special one.
fn operand(random: &mut ChaCha8Rng) -> u32 {
    let (bits, choice) = (random.next_u32(), random.next_u32());
    match choice % 8 {
        0 | 1 => bits,
        2 => SPECIAL[bits as usize % SPECIAL.len()] ^ (choice & 1 << 31),
        // Few bits of significand: exact results and ties.
        3 | 4 => (bits & 0x8070_0000) | (111 + (bits & 31)) << 23,
        _ => (bits & 0x807F_FFFF) | (111 + (choice >> 8 & 31)) << 23,
    }
}

#[test]
fn the_hosts_unit_answers_what_the_software_does_for_random_operands() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for operation in operations() {
        for draw in 0..DRAWS {
            let operands = std::array::from_fn(|_| operand(&mut random));
            // Mostly the mode that firmware runs in.
            let mode = match draw % 8 {
                7 => MODES[random.next_u32() as usize % MODES.len()],
                half => MODES[half as usize % 2],
            };
            compare(operation, operands, mode);
        }
    }
}

#[test]
fn the_hosts_unit_answers_what_the_software_does_for_special_operands() {
    let special = SPECIAL.map(|bits| [bits, bits | 1 << 31]);
    let special = special.as_flattened();
    for operation in operations() {
        for &a in special {
            for &b in special {
                // The third of a fused operation: every one of them too.
                let thirds = match operation {
                    Operation::MultiplyAdd => special,
                    _ => &special[..1],
                };
                for &c in thirds {
                    for mode in MODES {
                        compare(operation, [a, b, c], mode);
                    }
                }
            }
        }
    }
}
