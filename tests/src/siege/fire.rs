//! Ammunition of hostile hosts.

use crate::hostile::{Heard, Mutator, heard, seeds};
use calib_protocol::frame::{MAX_FRAME, encode};
use calib_protocol::message::Request;

/// A request as a host sends it: a zero before it, without which a frame may be taken for a line.
pub fn frame(sequence: u16, request: &Request) -> Vec<u8> {
    let mut buffer = vec![0; 1 + MAX_FRAME];
    // Any request of this version fits.
    let length = encode(sequence, request, &mut buffer[1..]).unwrap_or_default();
    buffer.truncate(1 + length);
    buffer
}

/// Mutated and replayed requests, the same each time.
pub struct Ammunition(Mutator);

impl Ammunition {
    /// A store of them; another number, another store.
    pub fn new(number: u64) -> Self {
        Self(Mutator::new(Self::heard(), number))
    }

    /// Frames of requests: what a host that replays has heard, but for those whose answers alone
    /// take the serial line longer than an answer may take.
    pub fn heard() -> Vec<Vec<u8>> {
        let seeds = seeds().into_iter();
        seeds
            .filter(|seed| seed.target == "commands" && seed.name != "request-07")
            .map(|seed| seed.bytes)
            .collect()
    }

    /// Inputs of so many bytes together of which the firmware's own link makes what is `allowed`.
    pub fn salvo(&mut self, length: usize, allowed: fn(Heard) -> bool) -> Vec<u8> {
        let mut salvo = Vec::new();
        while salvo.len() < length {
            // The zero before it ended a frame, or is the first of the next one: after the one a
            // line may begin, after the other none.
            let input = [&[0], self.0.next_input().as_slice(), &[0]].concat();
            if [&input[1..], &input].map(heard).into_iter().all(allowed) {
                salvo.extend_from_slice(&input[1..]);
            }
        }
        salvo
    }

    /// Anything but what stops a run, which any host may ask for.
    pub fn no_stop(&mut self, length: usize) -> Vec<u8> {
        self.salvo(length, |heard| heard.stops == 0)
    }

    /// Nothing that is answered.
    pub fn noise(&mut self, length: usize) -> Vec<u8> {
        self.salvo(length, |heard| heard.answers == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hostile::whole_frames;

    /// LF, an empty line, parts what a decoder of frames alone takes for one damaged frame. Such
    /// salvos ended the runs that were to go on.
    #[test]
    fn no_salvo_holds_a_stop_wherever_its_lines_end() {
        let stop = [b"\n", &frame(0x0104, &Request::Stop)[1..]].concat();
        assert_eq!(whole_frames(&stop), []);
        assert_eq!(heard(&stop).stops, 1);
        let mut fire = Ammunition::new(5);
        let salvos: Vec<u8> = (0..90).flat_map(|_| fire.no_stop(20_000)).collect();
        assert_eq!(heard(&salvos).stops, 0);
    }

    /// Request 10 in a frame of eight bytes without a zero begins with a tab and holds an LF.
    #[test]
    fn a_zero_before_it_tells_a_frame_from_a_line() {
        let release = frame(0x0101, &Request::Release { through: 9 });
        assert_eq!(release[1..5], [b'\t', 1, 1, b'\n']);
        assert_eq!(heard(&release[1..]).answers, 0);
        assert_eq!(heard(&release).answers, 1);
    }
}
