//! The section `t` of a link of version 2: long tables of points, as whole numbers at their decimal step, differences of these, and
//! deflate.
//!
//! The bytes before deflate are, for each table in the order of the segments, the number of points and two columns, places and
//! heights. A column is a byte (the decimals, plus 32 for third differences) and the differences. Numbers are written seven bits a
//! byte, the lowest first, the eighth bit set when more follow; differences are doubled, those below zero made −2·d − 1.

use super::base_62::{from_base_62, to_base_62};
use crate::decimal::{DECIMALS, Decimal};
use crate::limits::{MAX_INFLATED, MAX_INFLATION};
use levalab_core::law::{Data, MAX_POINTS};
use miniz_oxide::deflate::core::create_comp_flags_from_zip_params;
use miniz_oxide::deflate::core::{CompressionStrategy, CompressorOxide, TDEFLFlush, TDEFLStatus, compress};
use miniz_oxide::inflate::TINFLStatus;
use miniz_oxide::inflate::core::{DecompressorOxide, decompress, inflate_flags};

/// Tables of more points are in the section, shorter ones with their segment, where they can be read.
const MAX_SHORT_TABLE: usize = 16;

/// Orders of differences that a column may be written in.
const ORDERS: [u32; 2] = [2, 3];

/// What the first byte of a column of third differences adds to its decimals.
const THIRD: u8 = 32;

/// Deflate's greatest effort: the tables of a link are a few kilobytes.
const LEVEL: i32 = 10;

/// Window bits that stand for deflate without a header.
const RAW: i32 = 0;

type Points = Vec<[f64; 2]>;

/// True for a table that is in the section: a long one whose numbers are decimals of 18 places at most.
pub(super) fn is_packed(points: &[[f64; 2]]) -> bool {
    points.len() > MAX_SHORT_TABLE && points.iter().flatten().all(|&value| Decimal::of(value).to_f64() == value)
}

/// The tables of a design's segments as the bytes that are deflated; empty when there are none.
pub(super) fn bytes_of<'a>(data: impl Iterator<Item = &'a Data>) -> Vec<u8> {
    let mut bytes = Vec::new();
    for data in data {
        if let Data::Points(points) = data
            && is_packed(points)
        {
            write_number(&mut bytes, points.len() as u128);
            write_column(&mut bytes, points.iter().map(|point| point[0]));
            write_column(&mut bytes, points.iter().map(|point| point[1]));
        }
    }
    bytes
}

/// The body of the section: the bytes deflated and in base 62.
pub(super) fn pack(bytes: &[u8]) -> String {
    let mut packed = deflate(bytes, CompressionStrategy::Default);
    if bytes.len() > MAX_INFLATION * packed.len() {
        // So even a table that is opened as a bomb would be: packed less, it has its place in a link.
        packed = deflate(bytes, CompressionStrategy::HuffmanOnly);
    }
    to_base_62(&packed)
}

/// The bytes that the body of a section stands for; `None` when it is broken, or unpacks to more than a link may hold.
pub(super) fn unpack(body: &str) -> Option<Vec<u8>> {
    let packed = from_base_62(body)?;
    let mut bytes = vec![0; MAX_INFLATED.min(MAX_INFLATION * packed.len())];
    let flags = inflate_flags::TINFL_FLAG_USING_NON_WRAPPING_OUTPUT_BUF;
    let (status, read, written) = decompress(&mut DecompressorOxide::new(), &packed, &mut bytes, 0, flags);
    bytes.truncate(written);
    (status == TINFLStatus::Done && read == packed.len()).then_some(bytes)
}

/// The tables that the bytes stand for.
pub(super) fn tables_of(bytes: &[u8]) -> Option<Vec<Points>> {
    let mut rest = bytes;
    let mut tables = Vec::new();
    while !rest.is_empty() {
        let count = usize::try_from(read_number(&mut rest)?).ok().filter(|&count| count <= MAX_POINTS)?;
        let places = read_column(&mut rest, count)?;
        let heights = read_column(&mut rest, count)?;
        tables.push(places.into_iter().zip(heights).map(|(at, s)| [at, s]).collect());
    }
    Some(tables)
}

fn deflate(bytes: &[u8], strategy: CompressionStrategy) -> Vec<u8> {
    let flags = create_comp_flags_from_zip_params(LEVEL, RAW, strategy as i32);
    // Deflate adds a few bytes to each block that it cannot make smaller.
    let mut packed = vec![0; 2 * bytes.len() + 64];
    let (status, _, written) = compress(&mut CompressorOxide::new(flags), bytes, &mut packed, TDEFLFlush::Finish);
    debug_assert!(status == TDEFLStatus::Done);
    packed.truncate(written);
    packed
}

/// A column in the order of differences whose digits are fewest.
fn write_column(bytes: &mut Vec<u8>, values: impl Iterator<Item = f64>) {
    let exact: Vec<Decimal> = values.map(Decimal::of).collect();
    let decimals = exact.iter().map(|value| value.places()).max().unwrap_or(0);
    let steps: Vec<i128> = exact.iter().map(|value| value.in_steps(decimals)).collect();
    let [second, third] = ORDERS.map(|order| differences(&steps, order));
    let digits = |column: &[u128]| column.iter().map(|number| u128::BITS - number.leading_zeros()).sum::<u32>();
    let (third_is_shorter, first) = (digits(&third) < digits(&second), decimals as u8);
    bytes.push(if third_is_shorter { first + THIRD } else { first });
    for number in if third_is_shorter { third } else { second } {
        write_number(bytes, number);
    }
}

fn read_column(bytes: &mut &[u8], count: usize) -> Option<Vec<f64>> {
    let (&first, rest) = bytes.split_first()?;
    *bytes = rest;
    let (order, decimals) = if first < THIRD { (ORDERS[0], first) } else { (ORDERS[1], first - THIRD) };
    let decimals = i32::from(decimals);
    if decimals > DECIMALS {
        return None;
    }
    let mut steps = Vec::new();
    for _ in 0..count {
        let number = read_number(bytes)?;
        let half = (number >> 1) as i128;
        steps.push(if number & 1 == 0 { half } else { -half - 1 });
    }
    for _ in 0..order {
        let mut sum = 0_i128;
        for step in &mut steps {
            sum = sum.checked_add(*step)?;
            *step = sum;
        }
    }
    Some(steps.into_iter().map(|steps| Decimal::of_steps(steps, decimals).to_f64()).collect())
}

/// Differences of an order, as numbers without a sign; the numbers before the first count as zero.
fn differences(steps: &[i128], order: u32) -> Vec<u128> {
    let mut column = steps.to_vec();
    for _ in 0..order {
        let mut before = 0;
        for step in &mut column {
            (*step, before) = (step.saturating_sub(before), *step);
        }
    }
    column
        .into_iter()
        .map(|step| if step < 0 { (step.unsigned_abs() << 1) - 1 } else { step.unsigned_abs() << 1 })
        .collect()
}

fn write_number(bytes: &mut Vec<u8>, mut number: u128) {
    while number > 0x7f {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

fn read_number(bytes: &mut &[u8]) -> Option<u128> {
    let mut number = 0_u128;
    for shift in (0..u128::BITS).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        let part = u128::from(byte & 0x7f);
        // Neither digits beyond the last that fits nor zeros in front: a number is written in one way.
        if (part << shift) >> shift != part || (byte == 0 && shift > 0) {
            return None;
        }
        number |= part << shift;
        if byte < 0x80 {
            return Some(number);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;
    use std::f64::consts::TAU;

    /// A rise and return of 25 at even places, with noise of a size, rounded to some decimals.
    fn measured(count: usize, noise: f64, decimals: i32) -> Points {
        let mut random = Random::new(361);
        let unit = 10_f64.powi(decimals);
        let point = |k: usize| {
            let x = k as f64 / (count - 1) as f64;
            let s = 12.5 * (1.0 - (TAU * x).cos()) + random.between(-noise, noise);
            [360.0 * k as f64 / (count - 1) as f64, (s * unit).round() / unit]
        };
        (0..count).map(point).collect()
    }

    fn body(points: &Points) -> String {
        pack(&bytes_of(std::iter::once(&Data::Points(points.clone()))))
    }

    fn opened(body: &str) -> Option<Vec<Points>> {
        tables_of(&unpack(body)?)
    }

    #[test]
    fn a_table_of_a_turn_in_degrees_takes_some_hundred_characters() {
        for (noise, decimals, limit) in [(0.0, 4, 360), (0.001, 4, 620), (0.001, 6, 1250)] {
            let points = measured(361, noise, decimals);
            let body = body(&points);
            assert!(body.len() <= limit, "{} characters with noise of {noise} at {decimals} decimals", body.len());
            assert_eq!(opened(&body), Some(vec![points]));
        }
    }

    #[test]
    fn the_example_of_the_documentation_is_written_so() {
        let squares = Data::Points((0..20).map(f64::from).map(|k| [k, k * k]).collect());
        let bytes = [vec![0x14], vec![0, 0, 2], vec![0; 18], vec![0x20, 0, 2, 2], vec![0; 17]].concat();
        assert_eq!(bytes_of(std::iter::once(&squares)), bytes);
    }

    #[test]
    fn tables_come_back_exactly() {
        let mut random = Random::new(7);
        for _ in 0..100 {
            let decimals = random.below(13) as i32;
            let unit = 10_f64.powi(decimals);
            let size = 10_f64.powi(random.below(6) as i32);
            let count = 17 + random.below(400);
            let mut number = || (random.between(-size, size) * unit).round() / unit;
            let points: Points = (0..count).map(|_| [number(), number()]).collect();
            assert!(is_packed(&points));
            assert_eq!(opened(&body(&points)), Some(vec![points]));
        }
    }

    #[test]
    fn numbers_that_are_no_decimals_of_18_places_stay_with_their_segment() {
        let mut points = measured(361, 0.0, 4);
        assert!(is_packed(&points) && !is_packed(&points[..16]) && is_packed(&points[..17]));
        points[5][1] = 1.0 / 3.0 * 1e-6;
        assert!(!is_packed(&points));
    }

    #[test]
    fn tables_that_hardly_change_are_packed_within_what_is_unpacked() {
        for points in [vec![[0.0, 0.0]; MAX_POINTS], (0..MAX_POINTS).map(|k| [k as f64, (k % 2) as f64]).collect()] {
            let data = [Data::Points(points.clone()), Data::Points(points.clone())];
            let bytes = bytes_of(data.iter());
            let body = pack(&bytes);
            assert_eq!(opened(&body), Some(vec![points.clone(), points]), "{} bytes in {body}", bytes.len());
        }
    }

    #[test]
    fn bombs_are_refused() {
        let small = vec![1_u8; 100];
        assert_eq!(unpack(&to_base_62(&deflate(&small, CompressionStrategy::Default))), Some(small));
        for size in [10_000, 1 << 16, (1 << 16) + 1, 1 << 20] {
            let bomb = deflate(&vec![0; size], CompressionStrategy::Default);
            assert!(size > MAX_INFLATION * bomb.len(), "{size} bytes are a bomb of {}", bomb.len());
            assert_eq!(unpack(&to_base_62(&bomb)), None, "{size} bytes");
        }
        // Within the ratio, and larger than anything in a link.
        let mut random = Random::new(3);
        let noise: Vec<u8> = (0..=MAX_INFLATED).map(|_| random.below(2) as u8).collect();
        assert_eq!(unpack(&to_base_62(&deflate(&noise, CompressionStrategy::Default))), None);
        assert!(unpack(&to_base_62(&deflate(&noise[1..], CompressionStrategy::Default))).is_some());
    }

    #[test]
    fn any_body_is_refused_or_unpacked_and_no_panic() {
        let mut random = Random::new(5);
        let good =
            deflate(&bytes_of(std::iter::once(&Data::Points(measured(200, 0.001, 4)))), CompressionStrategy::Default);
        for _ in 0..3_000 {
            let mut packed = good.clone();
            for _ in 0..=random.below(3) {
                let at = random.below(packed.len());
                match random.below(3) {
                    0 => packed[at] = random.bits() as u8,
                    1 => packed.truncate(at.max(1)),
                    _ => packed.insert(at, random.bits() as u8),
                }
            }
            if let Some(bytes) = unpack(&to_base_62(&packed)) {
                assert!(bytes.len() <= MAX_INFLATED && bytes.len() <= MAX_INFLATION * packed.len());
                let _ = tables_of(&bytes);
            }
        }
        for _ in 0..20_000 {
            let bytes: Vec<u8> = (0..random.below(60)).map(|_| random.bits() as u8).collect();
            if let Some(tables) = tables_of(&bytes) {
                assert!(tables.iter().flatten().flatten().all(|value| value.is_finite()), "{bytes:?}");
            }
        }
    }

    #[test]
    fn what_follows_the_packed_bytes_is_refused() {
        let mut packed = deflate(b"abc", CompressionStrategy::Default);
        assert_eq!(unpack(&to_base_62(&packed)).as_deref(), Some(b"abc".as_slice()));
        packed.push(0);
        assert_eq!(unpack(&to_base_62(&packed)), None);
    }
}
