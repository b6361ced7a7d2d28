//! Bytes a receiver hears of a sender at another baud rate.
//!
//! Both are asynchronous: the sender puts ten bits of its own length on the line for each byte, and
//! the receiver looks at the line sixteen times in each of its own bits. At equal rates it hears what
//! was sent. At others it takes edges in the middle of a byte for the beginning of one.
//!
//! Source: RM0433 Rev 8, section 48.5.6: start bit detection, noise and framing errors with
//! oversampling by 16 and three samples per bit.

/// Looks at the line in a bit of the receiver.
const OVERSAMPLING: u64 = 16;
/// Bits of a byte on the line: start, eight data bits, stop.
const FRAME_BITS: u64 = 10;

/// A byte as it was heard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Heard {
    /// Its data bits.
    pub(super) byte: u8,
    /// Samples of one bit did not agree.
    pub(super) noise: bool,
    /// No stop bit where there should be one.
    pub(super) framing: bool,
}

/// Bytes sent one after the other, as levels over time.
struct Line<'a> {
    bytes: &'a [u8],
    sender_baud: u64,
    receiver_baud: u64,
}

impl Line<'_> {
    /// The level at the receiver's sample of this number: low is a start bit or a 0.
    fn is_high(&self, sample: u64) -> bool {
        let bit = sample * self.sender_baud / (OVERSAMPLING * self.receiver_baud);
        let Some(byte) = self.bytes.get((bit / FRAME_BITS) as usize) else {
            return true;
        };
        match bit % FRAME_BITS {
            0 => false,
            9 => true,
            place => byte >> (place - 1) & 1 == 1,
        }
    }

    /// Number of these samples, counted from `start`, that are low.
    fn low(&self, start: u64, samples: [u64; 3]) -> usize {
        let low = |sample: &&u64| !self.is_high(start + **sample);
        samples.iter().filter(low).count()
    }

    fn samples(&self) -> u64 {
        let bits = self.bytes.len() as u64 * FRAME_BITS;
        bits * OVERSAMPLING * self.receiver_baud / self.sender_baud
    }
}

/// Bytes a receiver at `receiver_baud` hears of `bytes` sent at `sender_baud` without a pause.
pub(super) fn heard(bytes: &[u8], sender_baud: u32, receiver_baud: u32) -> Vec<Heard> {
    let line = Line {
        bytes,
        sender_baud: u64::from(sender_baud),
        receiver_baud: u64::from(receiver_baud),
    };
    let mut all = Vec::new();
    let mut sample = 0;
    while sample < line.samples() {
        let falls = !line.is_high(sample) && (sample == 0 || line.is_high(sample - 1));
        let start = falls.then(|| starts(&line, sample)).flatten();
        let Some(noise) = start else {
            sample += 1;
            continue;
        };
        all.push(frame(&line, sample, noise));
        // The next start bit is looked for once the stop bit has been sampled.
        sample += (FRAME_BITS - 1) * OVERSAMPLING + 10;
    }
    all
}

/// Whether a falling edge begins a byte, and with noise: at least two of each three samples are low.
fn starts(line: &Line<'_>, edge: u64) -> Option<bool> {
    let low = [[2, 4, 6], [7, 8, 9]].map(|samples| line.low(edge, samples));
    let begins = low.iter().all(|low| *low >= 2);
    begins.then(|| low != [3, 3])
}

fn frame(line: &Line<'_>, edge: u64, mut noise: bool) -> Heard {
    let mut bit = |place: u64| {
        let low = line.low(edge + place * OVERSAMPLING, [7, 8, 9]);
        noise |= !matches!(low, 0 | 3);
        low < 2
    };
    let byte = (1..=8).fold(0, |byte, place| byte | u8::from(bit(place)) << (place - 1));
    let framing = !bit(9);
    Heard {
        byte,
        noise,
        framing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All bytes, several times in an order that repeats late.
    fn bytes() -> Vec<u8> {
        (0..4000_u32).map(|n| (n * n / 7 + n * 151) as u8).collect()
    }

    #[test]
    fn at_its_own_rate_and_two_percent_off_it_hears_what_was_sent() {
        // A receiver tolerates 3.75 % (RM0433, table 409, 8 bits, BRR[3:0] = 0).
        for sender in [115_200, 113_000, 117_400] {
            let heard = heard(&bytes(), sender, 115_200);
            let clean = heard.iter().all(|heard| !heard.noise && !heard.framing);
            assert!(clean, "{sender}");
            let heard: Vec<u8> = heard.iter().map(|heard| heard.byte).collect();
            assert_eq!(heard, bytes(), "{sender}");
        }
    }

    #[test]
    fn a_faster_sender_makes_noise_and_framing_errors() {
        let heard = heard(&bytes(), 3_000_000, 115_200);
        // 4000 bytes last as long as 153.6 at the receiver's rate.
        assert!((80..=153).contains(&heard.len()), "{}", heard.len());
        // A bit of the receiver spans 26 of the sender: its three samples, a bit of the sender and
        // more apart, agree one time in four, and all nine of a byte one time in 4^9.
        let noisy = heard.iter().filter(|heard| heard.noise).count();
        assert!(noisy * 10 > heard.len() * 9, "{noisy} of {}", heard.len());
        // A stop bit is one sample in two.
        let broken = heard.iter().filter(|heard| heard.framing).count();
        assert!(
            (heard.len() / 4..heard.len() * 3 / 4).contains(&broken),
            "{broken}"
        );
    }
}
