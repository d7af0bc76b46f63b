//! Where cam and follower touch, and how the profile bends there.

use super::{Body, Drive, Element, Follower, Point};
use crate::Svaj;

/// Least |P′|² that is divided by, so that a pitch curve that stands still for an instant gives numbers and not NaN.
const STILL: f64 = 1e-200;

/// Least turning of the normal a radian of cam that is divided by, when a swinging face keeps pace with the cam.
const STALLED: f64 = 1e-12;

/// The contact at one instant, in the fixed frame: origin at the cam's centre, follower on top.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Point of contact.
    pub point: Point,
    /// Trace point: centre of the roller or of the arc, edge of the knife; the point of contact for a flat face.
    pub trace: Point,
    /// Unit normal of the profile, out of the cam.
    pub normal: Point,
    /// φ, radians: from the follower's direction of motion to the normal, positive in the rise of a radial follower.
    pub pressure_angle: f64,
    /// How the profile bends: κp, curvature of the pitch curve, for a disc; ρ, radius of curvature, for a flat face. Of the
    /// two it is the one that stays finite over a whole turn.
    pub bend: f64,
    /// Distance that tells where the contact is on a flat face: from the follower's axis, + to the right, when it
    /// translates; from the foot of the pivot along the face when it swings. Zero for a disc.
    pub reach: f64,
    /// Tangential velocity of the follower's body over the cam, length per radian: sliding, or rolling for a roller.
    pub sliding: f64,
    /// 1 + σ·ds/dθ for a swinging face, which must not lag behind the cam; 1 for all others.
    pub lead: f64,
}

impl Follower {
    /// The contact when the follower's motion is `motion`, its derivatives with respect to θ.
    ///
    /// * A disc about F rolls or slides on the offset of the pitch curve P = F·e^(−iσθ): ρp = −σ·|P′|³/(P′ × P″), ρ = ρp − Rf.
    ///   Translating, tan φ = (v − σe)/(s₀ + s) with s₀ = √(Rp² − e²); and with e = 0 and h = Rp + s,
    ///   ρp = (h² + v²)^(3/2)/(h² + 2v² − h·a).
    /// * A face touches the envelope of its line: ρ = p + d²p/dα², p its distance from the cam's centre and α the angle of its normal
    ///   in the cam. Translating with γ = 0, ρ = Rb + s + a, the contact lies at σ·v from the axis, and φ = 0.
    ///
    /// They are the formulas of Norton, *Cam Design and Manufacturing Handbook*, ch. 7, in one form for every follower and both senses of
    /// rotation. Nothing gives way or has clearance.
    #[must_use]
    #[inline]
    pub fn contact(&self, motion: Svaj) -> Contact {
        let motion = self.reversed.map_or(motion, |top| Svaj::new(top, 0.0, 0.0, 0.0) - motion);
        match self.element {
            Element::Disc { centre, radius } => self.disc_contact(centre, radius, motion),
            Element::Face { normal, point } => self.face_contact(normal, point, motion),
        }
    }

    /// ρ of the profile from [`Contact::bend`], a length, convex positive: 1/κp − Rf for a disc, `bend` itself for a face. Infinite where
    /// the pitch curve is straight.
    #[must_use]
    #[inline]
    pub fn profile_radius(&self, bend: f64) -> f64 {
        match self.element {
            Element::Disc { radius, .. } => 1.0 / bend - radius,
            Element::Face { .. } => bend,
        }
    }

    /// A smooth measure that is positive where the profile runs forward, zero at a cusp and negative where it is undercut:
    /// 1 − Rf·κp for a disc, ρ/Rb for a face. It is a pure number.
    #[must_use]
    #[inline]
    pub fn regularity(&self, bend: f64) -> f64 {
        match self.element {
            Element::Disc { radius, .. } => 1.0 - radius * bend,
            Element::Face { .. } => bend / self.base_radius,
        }
    }

    /// First idea: the profile is the pitch curve offset inwards by the radius of the disc.
    ///
    /// With F the trace point and P = F·e^(−iσθ) the pitch curve, W = F + iσF′ points along the outward normal and
    /// |W| = |P′|; κp = −σ·(P′ × P″)/|P′|³, positive when convex. On a cam that travels P = F + θ, W = i(1 + F′).
    #[inline]
    fn disc_contact(&self, centre: Point, radius: f64, motion: Svaj) -> Contact {
        let sigma = self.rotation.sigma();
        let (trace, first, second) = self.body.carry(centre, motion);
        let (w, p2) = match self.drive {
            Drive::Turns => (trace + times_i(first) * sigma, second - times_i(first) * (2.0 * sigma) - trace),
            Drive::Travels => (times_i(first + 1.0), second),
        };
        let per_speed = 1.0 / w.norm_sqr().max(STILL).sqrt();
        let normal = w * per_speed;
        let p1 = times_i(w) * -sigma;
        // Adding 0 makes 0 of −0, so that what is straight has the radius +∞.
        let bend = -sigma * cross(p1, p2) * per_speed * per_speed * per_speed + 0.0;
        let point = trace - normal * radius;
        let (lever, velocity) = self.body.lever_and_velocity(trace, point, motion.v);
        Contact {
            point,
            trace,
            normal,
            pressure_angle: sigma * angle_between(lever * self.advance(), normal),
            bend,
            reach: 0.0,
            sliding: dot(velocity - self.cam_velocity(point), times_i(normal)),
            lead: 1.0,
        }
    }

    /// Second idea: the profile is the envelope of the face.
    ///
    /// With n the normal at angle α in the cam's frame and p the support, the contact is p·n + q·(i·n), q = dp/dα, and
    /// ρ = p + d²p/dα².
    #[inline]
    fn face_contact(&self, normal: Point, point: Point, motion: Svaj) -> Contact {
        let sigma = self.rotation.sigma();
        let Svaj { s, v, a, .. } = motion;
        let (n, support, support1, support2, alpha1, alpha2) = match self.body {
            Body::Slide => {
                let lift = normal.im;
                (normal, dot(point, normal) + s * lift, v * lift, a * lift, -sigma, 0.0)
            }
            Body::Swing { pivot } => {
                let n = normal * Point::from_polar(1.0, -s);
                let (along, across) = (dot(pivot, n), dot(pivot, times_i(n)));
                let offset = dot(point - pivot, normal);
                (n, offset + along, -v * across, -a * across - v * v * along, -sigma - v, -a)
            }
        };
        let alpha1 = if alpha1.abs() < STALLED { STALLED.copysign(alpha1) } else { alpha1 };
        let q = support1 / alpha1;
        let q1 = (support2 * alpha1 - support1 * alpha2) / (alpha1 * alpha1);
        let tangent = times_i(n);
        let touch = n * support + tangent * q;
        let (lever, velocity) = self.body.lever_and_velocity(touch, touch, v);
        let advance = self.advance();
        Contact {
            point: touch,
            trace: touch,
            normal: n,
            pressure_angle: sigma * angle_between(lever * advance, n),
            bend: support + q1 / alpha1,
            reach: match self.body {
                Body::Slide => touch.re,
                Body::Swing { pivot } => dot(touch - pivot, tangent) * advance,
            },
            sliding: dot(velocity - self.cam_velocity(touch), tangent),
            lead: -sigma * alpha1,
        }
    }

    /// +1 when the element moves off its cam as the follower's body moves forward; −1 for a second element across the shaft.
    #[inline]
    pub(crate) fn advance(&self) -> f64 {
        if self.reversed.is_some() { -1.0 } else { 1.0 }
    }

    /// Velocity of the cam's own point at `point`, length per radian (or per length of travel).
    #[inline]
    fn cam_velocity(&self, point: Point) -> Point {
        match self.drive {
            Drive::Turns => times_i(point) * self.rotation.sigma(),
            Drive::Travels => Point::new(-1.0, 0.0),
        }
    }
}

impl Body {
    /// A point of the follower at displacement *s*, with its first two derivatives with respect to θ.
    #[inline]
    fn carry(&self, at_rest: Point, motion: Svaj) -> (Point, Point, Point) {
        let Svaj { s, v, a, .. } = motion;
        match *self {
            Self::Slide => (Point::new(at_rest.re, at_rest.im + s), Point::new(0.0, v), Point::new(0.0, a)),
            Self::Swing { pivot } => {
                let arm = (at_rest - pivot) * Point::from_polar(1.0, -s);
                (pivot + arm, times_i(arm) * -v, times_i(arm) * -a - arm * (v * v))
            }
        }
    }

    /// Direction in which positive *s* carries `trace` (any length), and velocity of the body at `point` per radian.
    #[inline]
    fn lever_and_velocity(&self, trace: Point, point: Point, v: f64) -> (Point, Point) {
        match *self {
            Self::Slide => (Point::new(0.0, 1.0), Point::new(0.0, v)),
            Self::Swing { pivot } => (times_i(pivot - trace), times_i(pivot - point) * v),
        }
    }
}

#[inline]
fn times_i(z: Point) -> Point {
    Point::new(-z.im, z.re)
}

#[inline]
fn dot(a: Point, b: Point) -> f64 {
    a.re * b.re + a.im * b.im
}

#[inline]
fn cross(a: Point, b: Point) -> f64 {
    a.re * b.im - a.im * b.re
}

/// Angle from `a` to `b`, counter-clockwise, in (−π, π].
#[inline]
fn angle_between(a: Point, b: Point) -> f64 {
    let (sine, cosine) = (cross(a, b), dot(a, b));
    // Nearly every contact is within a right angle, where the plain arctangent is the quicker.
    if cosine > 0.0 { (sine / cosine).atan() } else { sine.atan2(cosine) }
}
