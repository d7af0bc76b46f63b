//! Binary STL for printers and CAM, in millimetres.

use crate::solid::solid;
use crate::{Refusal, Shaft, Step, Subject};
use stl_io::{Normal, Triangle, Vertex};

/// The cam as a solid from z = 0 to its thickness, centre at the origin. STL knows no units: what reads it takes millimetres for
/// granted, and so they are, whatever the unit of the design. Thickness and shaft are in the unit of the design.
///
/// # Errors
/// When a measure is not positive, there is no room for the shaft, or the profile is undercut or crosses itself.
pub fn stl(subject: &Subject, step: Step, thickness: f64, shaft: Option<Shaft>) -> Result<Vec<u8>, Refusal> {
    let solid = solid(subject, step, thickness, shaft)?;
    let mut bytes = Vec::new();
    let facets =
        solid.triangles.iter().map(|corners| Triangle { normal: normal(corners), vertices: corners.map(Vertex::new) });
    stl_io::write_stl(&mut bytes, facets).map_err(|error| Refusal::Failed { said: error.to_string() })?;
    Ok(bytes)
}

/// Out of the solid, length 1; zero for a triangle without an area, as the format allows.
fn normal([a, b, c]: &[[f32; 3]; 3]) -> Normal {
    let from_a = |p: &[f32; 3]| [0, 1, 2].map(|k| f64::from(p[k]) - f64::from(a[k]));
    let (u, v) = (from_a(b), from_a(c));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = n.iter().map(|part| part * part).sum::<f64>().sqrt();
    Normal::new(n.map(|part| if length > 0.0 { (part / length) as f32 } else { 0.0 }))
}
