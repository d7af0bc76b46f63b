//! How much a file weighs, on disk and over the wire.

use std::{fs, io::Write, path::Path};

use anyhow::{Context, Result};
use flate2::{Compression, write::GzEncoder};

/// Bytes of a file as it is and as web servers send it.
#[derive(Clone, Copy, Default)]
pub struct Size {
    /// As it is.
    pub raw: usize,
    /// Packed by [`gzip`].
    pub gzip: usize,
}

impl Size {
    /// Weighs a file.
    pub fn of(file: &Path) -> Result<Size> {
        let bytes = fs::read(file).with_context(|| file.display().to_string())?;
        Ok(Size { raw: bytes.len(), gzip: gzip(&bytes)?.len() })
    }

    /// Both together.
    pub fn plus(self, other: Size) -> Size {
        Size { raw: self.raw + other.raw, gzip: self.gzip + other.gzip }
    }
}

/// As web servers send it, level 9.
pub fn gzip(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}

/// `12.3 KB`, of 1,000 bytes each.
pub fn kilobytes(bytes: usize) -> String {
    let hundreds = (bytes + 50) / 100;
    format!("{}.{} KB", hundreds / 10, hundreds % 10)
}
