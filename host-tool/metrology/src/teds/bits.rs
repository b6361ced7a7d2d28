//! Numbers of a few bits, and the standard's compressed real numbers.

use super::error::TedsError;

/// Bits of a TEDS, lowest bit of each byte first.
pub(super) struct Bits<'a> {
    bytes: &'a [u8],
    position: usize,
}

impl<'a> Bits<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, position: 0 }
    }

    /// An unsigned number of up to 32 bits.
    pub(super) fn number(&mut self, bits: usize) -> Result<u32, TedsError> {
        let mut number = 0;
        for place in 0..bits {
            let at = self.position + place;
            let byte = self.bytes.get(at / 8).ok_or(TedsError::Short)?;
            number |= u32::from(byte >> (at % 8) & 1) << place;
        }
        self.position += bits;
        Ok(number)
    }

    pub(super) fn flag(&mut self) -> Result<bool, TedsError> {
        Ok(self.number(1)? == 1)
    }

    /// ConRelRes: `start (1 + 2 tolerance)^code`; all ones is "not stated".
    pub(super) fn relative(
        &mut self,
        bits: usize,
        start: f64,
        tolerance: f64,
    ) -> Result<Option<f64>, TedsError> {
        let code = self.number(bits)?;
        Ok((code != ones(bits)).then(|| start * (1.0 + 2.0 * tolerance).powf(f64::from(code))))
    }

    /// ConRes: `start + step code`; all ones is "not stated".
    pub(super) fn linear(
        &mut self,
        bits: usize,
        start: f64,
        step: f64,
    ) -> Result<Option<f64>, TedsError> {
        let code = self.number(bits)?;
        Ok((code != ones(bits)).then(|| start + step * f64::from(code)))
    }

    /// Letters of five bits: 0 is a space, 1 is A.
    pub(super) fn letters(&mut self, count: usize) -> Result<String, TedsError> {
        let mut text = String::new();
        for _ in 0..count {
            text.push(match self.number(5)? {
                code @ 1..=26 => char::from(b'A' + code as u8 - 1),
                _ => ' ',
            });
        }
        Ok(text.trim().to_owned())
    }
}

fn ones(bits: usize) -> u32 {
    (1 << bits) - 1
}
