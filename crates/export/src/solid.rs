//! The cam as a solid: profile and bore, extruded.

use crate::curves::{Role, curves, room};
use crate::shaft::positive;
use crate::{Refusal, Shaft, Step, Subject};
use levalab_core::{Closure, FindingKind, Point};
use levalab_format::CamStudy;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use std::collections::HashSet;
use std::f64::consts::TAU;

/// A corner, mm. Rounded to what the file holds before anything is made of it, so that neighbours share it to the bit.
pub(crate) type Corner = [f32; 3];

/// Triangles whose corners run counter-clockwise as seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Solid {
    pub triangles: Vec<[Corner; 3]>,
}

/// How far the disc of a grooved cam goes beyond its groove, as a part of the groove's greatest radius.
const RIM: f64 = 0.15;

/// Extrudes the cams from z = 0 up, a second one above the first with as much room between them as they are thick; measures in the
/// unit of the design. A groove is half as deep as its disc is thick.
///
/// # Errors
/// When a measure is not positive, there is no room for the shaft, or the profile is undercut or crosses itself.
pub(crate) fn solid(subject: &Subject, step: Step, thickness: f64, shaft: Option<Shaft>) -> Result<Solid, Refusal> {
    positive("thickness", thickness)?;
    subject.cams().try_for_each(sound)?;
    let curves = curves(subject, step, None);
    if let Some(shaft) = shaft {
        shaft.check(subject, room(&curves))?;
    }
    let mm = subject.millimetres();
    let thick = (thickness * mm) as f32;
    let bore = shaft.map(|shaft| ring(&shaft.outline(), mm, false));
    let outer = curves.iter().find(|curve| curve.role == Role::Outer);
    let mut solid = Solid { triangles: Vec::new() };
    for profile in curves.iter().filter(|curve| curve.role == Role::Profile) {
        let profile_ring = ring(&profile.part(subject), mm, true);
        let low = if profile.second { 2.0 * thick } else { 0.0 };
        let made = match outer {
            Some(outer) => solid.groove(&profile_ring, &ring(outer.points(), mm, true), bore.as_ref(), thick),
            None => {
                let rings: Vec<Ring> = [profile_ring].into_iter().chain(bore.clone()).collect();
                solid.extrude(&rings, low, low + thick)
            }
        };
        made.ok_or(Refusal::NotSolid { why: None })?;
    }
    Ok(solid)
}

/// Refuses a cam whose profile bounds nothing.
fn sound(cam: &CamStudy) -> Result<(), Refusal> {
    let broken = |kind: &FindingKind| {
        let cut = matches!(kind, FindingKind::Undercut | FindingKind::ConcaveFlat | FindingKind::SelfCrossing);
        cut || cam.cam().closure == Closure::Groove && *kind == FindingKind::GrooveUndercut
    };
    let found = cam.analysis().findings.iter().map(|finding| finding.kind).find(broken);
    found.map_or(Ok(()), |kind| Err(Refusal::NotSolid { why: Some(kind) }))
}

/// A closed line in the plane, mm.
type Ring = Vec<[f32; 2]>;

/// The points as the file holds them, each once, the solid on their left.
fn ring(points: &[Point], mm: f64, outer: bool) -> Ring {
    let mut ring: Ring = points.iter().map(|point| [(point.re * mm) as f32, (point.im * mm) as f32]).collect();
    ring.dedup();
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    if (area(&ring) > 0.0) != outer {
        ring.reverse();
    }
    ring
}

/// The area inside, negative when the points run clockwise.
fn area(ring: &Ring) -> f64 {
    let next = ring.iter().cycle().skip(1);
    let cross = |(a, b): (&[f32; 2], &[f32; 2])| f64::from(a[0]) * f64::from(b[1]) - f64::from(b[0]) * f64::from(a[1]);
    ring.iter().zip(next).map(cross).sum::<f64>() / 2.0
}

impl Solid {
    /// Two lids and the walls between them; nothing when the rings meet.
    fn extrude(&mut self, rings: &[Ring], low: f32, high: f32) -> Option<()> {
        self.lid(rings, high, true)?;
        self.lid(rings, low, false)?;
        rings.iter().for_each(|ring| self.wall(ring, low, high));
        Some(())
    }

    /// A disc with a groove half as deep as it is thick.
    fn groove(&mut self, inner: &Ring, outer: &Ring, bore: Option<&Ring>, thick: f32) -> Option<()> {
        const SIDES: usize = 360;
        let reach = outer.iter().map(|[x, y]| f64::from(*x).hypot(f64::from(*y))).fold(0.0, f64::max);
        let around = |k: usize| Point::from_polar(reach * (1.0 + RIM), TAU * k as f64 / SIDES as f64);
        let disc = ring(&(0..SIDES).map(around).collect::<Vec<_>>(), 1.0, true);
        let floor = thick / 2.0;
        let hole = |ring: &Ring| ring.iter().rev().copied().collect::<Ring>();
        let bored = |ring: &Ring| [ring.clone()].into_iter().chain(bore.cloned()).collect::<Vec<_>>();
        self.lid(&bored(&disc), 0.0, false)?;
        self.lid(&[disc.clone(), hole(outer)], thick, true)?;
        self.lid(&[outer.clone(), hole(inner)], floor, true)?;
        self.lid(&bored(inner), thick, true)?;
        self.wall(&disc, 0.0, thick);
        self.wall(&hole(outer), floor, thick);
        self.wall(inner, floor, thick);
        if let Some(bore) = bore {
            self.wall(bore, 0.0, thick);
        }
        Some(())
    }

    /// What lies between the rings, seen from above or from below.
    fn lid(&mut self, rings: &[Ring], z: f32, up: bool) -> Option<()> {
        let at = |[x, y]: [f32; 2]| [x, y, z];
        let turned = |[a, b, c]: [[f32; 2]; 3]| if up { [at(a), at(b), at(c)] } else { [at(c), at(b), at(a)] };
        self.triangles.extend(flat(rings)?.into_iter().map(turned));
        Some(())
    }

    /// The wall over a ring, with the solid on the left of the ring.
    fn wall(&mut self, ring: &Ring, low: f32, high: f32) {
        let at = |[x, y]: [f32; 2], z: f32| [x, y, z];
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            self.triangles.push([at(*a, low), at(*b, low), at(*b, high)]);
            self.triangles.push([at(*a, low), at(*b, high), at(*a, high)]);
        }
    }
}

/// The triangles between the rings, counter-clockwise: a constrained Delaunay triangulation, which keeps every point, so that lid
/// and wall fit even where points lie on a straight line.
fn flat(rings: &[Ring]) -> Option<Vec<[[f32; 2]; 3]>> {
    let corners: Vec<[f32; 2]> = rings.iter().flatten().copied().collect();
    let vertices = corners.iter().map(|[x, y]| Point2::new(f64::from(*x), f64::from(*y))).collect();
    let mut edges = Vec::with_capacity(corners.len());
    let mut first = 0;
    for ring in rings {
        let count = ring.len();
        edges.extend((0..count).map(|k| [first + k, first + (k + 1) % count]));
        first += count;
    }
    let walls: HashSet<[usize; 2]> = edges.iter().copied().collect();
    let mut conflicts = 0;
    let mesh =
        ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(vertices, edges, |_| conflicts += 1).ok()?;
    if conflicts > 0 || mesh.num_vertices() != corners.len() {
        return None;
    }
    // From every wall inwards: the solid is on its left, and ends at the next wall.
    let mut inside = HashSet::new();
    let on_the_left = |edge: &spade::handles::DirectedEdgeHandle<_, _, _, _>| {
        walls.contains(&[edge.from().fix().index(), edge.to().fix().index()])
    };
    let starts = mesh.directed_edges().filter(on_the_left).filter_map(|edge| edge.face().as_inner());
    let mut waiting: Vec<_> = starts.map(|face| face.fix()).collect();
    while let Some(face) = waiting.pop() {
        if !inside.insert(face) {
            continue;
        }
        for edge in mesh.face(face).adjacent_edges() {
            if !edge.is_constraint_edge() {
                waiting.push(edge.rev().face().as_inner()?.fix());
            }
        }
    }
    let mut triangles: Vec<_> = inside.into_iter().collect();
    triangles.sort_unstable();
    let corner = |vertex: spade::handles::VertexHandle<_, _, _, _>| corners[vertex.fix().index()];
    Some(triangles.into_iter().map(|face| mesh.face(face).vertices().map(corner)).collect())
}
