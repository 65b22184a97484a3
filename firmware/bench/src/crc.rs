//! CRC-32 as in PNG and zip files: polynomial 0x04C11DB7, bits reflected.

/// A checksum of RGB565 words, the low byte of each first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crc(u32);

impl Crc {
    pub(crate) const fn new() -> Self {
        Self(u32::MAX)
    }

    pub(crate) fn add(&mut self, words: &[u16]) {
        for byte in words.iter().flat_map(|word| word.to_le_bytes()) {
            let mut rest = self.0 ^ u32::from(byte);
            for _ in 0..8 {
                rest = (rest >> 1) ^ (0xEDB8_8320 * (rest & 1));
            }
            self.0 = rest;
        }
    }

    pub(crate) const fn value(self) -> u32 {
        !self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_check_value_is_the_published_one() {
        let mut crc = Crc::new();
        // Of "12345678": the usual "123456789" has no whole number of words.
        crc.add(&[0x3231, 0x3433, 0x3635, 0x3837]);
        assert_eq!(crc.value(), 0x9AE0_DAAF);
    }
}
