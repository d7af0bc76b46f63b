//! Random numbers from a seed, with few decimals or with all of them.

/// A small generator of random numbers (SplitMix64), the same on every machine.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// A generator that always gives the same numbers for the same seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Sixty-four random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 up to but not including `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }

    /// A number in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// True once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// A copy of one of several.
    pub fn any<T: Copy>(&mut self, from: &[T]) -> T {
        *self.pick(from)
    }

    /// One of several.
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }
}

/// How many decimals the numbers of a design have; all of them when none is said.
#[derive(Clone, Copy)]
pub(super) struct Decimals(Option<i32>);

impl Decimals {
    pub fn pick(random: &mut Random) -> Self {
        Self(*random.pick(&[Some(0), Some(0), Some(1), Some(2), Some(6), None]))
    }

    pub fn round(self, value: f64) -> f64 {
        match self.0 {
            Some(decimals) if value.abs() > 10_f64.powi(1 - decimals) => {
                let scale = 10_f64.powi(decimals);
                (value * scale).round() / scale
            }
            _ => value,
        }
    }
}

/// A difference of decimals without what binary rounding leaves behind.
pub(super) fn tidy(value: f64) -> f64 {
    let rounded = (value * 1e9).round() / 1e9;
    if (rounded - value).abs() < 1e-12 { rounded } else { value }
}
