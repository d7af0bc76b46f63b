//! A drawing as pixels.

use crate::Refusal;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use std::sync::Arc;

/// Widest and highest picture, pixels.
const WIDEST: u32 = 10_000;

/// An SVG drawing as PNG, so many pixels wide (10 000 at most), on white. The type is always the same, whatever the machine has.
///
/// # Errors
/// When it is no drawing.
pub fn png(svg: &str, width: u32) -> Result<Vec<u8>, Refusal> {
    let failed = |said: String| Refusal::Failed { said };
    let width = width.clamp(1, WIDEST);
    let options = Options { fontdb: Arc::new(fonts()), font_family: FAMILY.to_owned(), ..Options::default() };
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(error.to_string()))?;
    let scale = width as f32 / tree.size().width();
    let height = ((tree.size().height() * scale).ceil() as u32).clamp(1, WIDEST);
    let mut picture = Pixmap::new(width, height).ok_or_else(|| failed("size".to_owned()))?;
    picture.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut picture.as_mut());
    picture.encode_png().map_err(|error| failed(error.to_string()))
}

const FAMILY: &str = "Ubuntu";

fn fonts() -> fontdb::Database {
    let mut fonts = fontdb::Database::new();
    for data in [epaint_default_fonts::UBUNTU_LIGHT, epaint_default_fonts::HACK_REGULAR] {
        fonts.load_font_data(data.to_vec());
    }
    fonts.set_sans_serif_family(FAMILY);
    fonts
}
