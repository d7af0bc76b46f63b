//! What forms are built from: laws, followers and units, straight from the lists of this crate and of the core.

use levalab_core::law::{Arguments, Group, LAWS, Law};
use levalab_core::{FOLLOWERS, FollowerKind, MAX_SEGMENTS, MAX_SIDES, Parameter, Quantity, sharpest_base_radius};
use serde::Serialize;
use serde_json::Value;

use crate::{
    BreadthGenerator, CamKind, FIRST_EXAMPLE, LengthUnit, SpeedUnit, data_entry, limits, motion_and_contact, unsuited,
};

/// Everything a form can offer.
#[derive(Serialize)]
pub struct Catalogue {
    laws: Vec<LawEntry>,
    followers: Vec<FollowerEntry>,
    kinds: Vec<KindEntry>,
    generators: [&'static str; 3],
    polygons: Vec<Polygon>,
    length_units: Vec<&'static str>,
    speed_units: Vec<&'static str>,
    /// The design that the page opens with.
    first: Value,
    limits: Limits,
}

#[derive(Serialize)]
struct LawEntry {
    id: &'static str,
    group: &'static str,
    moves: bool,
    parameters: Vec<ParameterEntry>,
    thumbnail: Vec<f64>,
    free: Option<FreeEntry>,
}

/// The field that a free law is made from, and what it starts with over β = 1 from 0 to 1.
#[derive(Serialize)]
struct FreeEntry {
    key: &'static str,
    first: Value,
}

#[derive(Serialize)]
struct FollowerEntry {
    id: &'static str,
    motion: &'static str,
    contact: &'static str,
    parameters: Vec<ParameterEntry>,
}

/// A kind of cam, with the followers that have a place on it.
#[derive(Serialize)]
struct KindEntry {
    id: &'static str,
    followers: Vec<&'static str>,
}

#[derive(Serialize)]
struct ParameterEntry {
    key: &'static str,
    symbol: &'static str,
    quantity: &'static str,
    default: Option<f64>,
    optional: bool,
}

#[derive(Serialize)]
struct Limits {
    segments: usize,
    title: usize,
    link: usize,
}

/// Gathers it.
impl Default for Catalogue {
    fn default() -> Self {
        Self {
            laws: LAWS.iter().map(|law| LawEntry::of(law)).collect(),
            followers: FOLLOWERS.iter().map(|kind| FollowerEntry::of(kind)).collect(),
            kinds: CamKind::WORDS.map(KindEntry::of).into(),
            generators: BreadthGenerator::WORDS,
            polygons: (3..=MAX_SIDES).step_by(2).map(Polygon::of).collect(),
            length_units: LengthUnit::ALL.map(LengthUnit::symbol).into(),
            speed_units: SpeedUnit::ALL.map(|unit| unit.symbol(LengthUnit::default())).into(),
            first: serde_json::from_str(FIRST_EXAMPLE).unwrap_or_default(),
            limits: Limits { segments: MAX_SEGMENTS, title: limits::MAX_TITLE, link: limits::MAX_LINK_MADE },
        }
    }
}

impl LawEntry {
    fn of(law: &Law) -> Self {
        let group = match law.group {
            Group::Basic => "basic",
            Group::Standard => "standard",
            Group::Half => "half",
            Group::Matched => "matched",
            Group::Free => "free",
        };
        Self {
            id: law.id,
            group,
            moves: !law.is_dwell(),
            parameters: law.parameters.iter().map(ParameterEntry::of).collect(),
            thumbnail: thumbnail(law),
            free: data_entry(&law.first_data(1.0, 0.0, 1.0)).map(|(key, first)| FreeEntry { key, first }),
        }
    }
}

/// A polygon of arcs, with the least base radius for a breadth of 1.
#[derive(Serialize)]
struct Polygon {
    sides: u32,
    least: f64,
}

impl Polygon {
    fn of(sides: u32) -> Self {
        Self { sides, least: sharpest_base_radius(sides, 1.0) }
    }
}

impl KindEntry {
    fn of(id: &'static str) -> Self {
        let suited = FOLLOWERS.iter().filter(|follower| unsuited(id, follower).is_none());
        Self { id, followers: suited.map(|follower| follower.id).collect() }
    }
}

impl FollowerEntry {
    fn of(kind: &FollowerKind) -> Self {
        let (motion, contact) = motion_and_contact(kind);
        Self { id: kind.id, motion, contact, parameters: kind.parameters.iter().map(ParameterEntry::of).collect() }
    }
}

impl ParameterEntry {
    fn of(parameter: &Parameter) -> Self {
        let (quantity, scale) = match parameter.quantity {
            Quantity::Length => ("length", 1.0),
            Quantity::Angle => ("angle", 1_f64.to_degrees()),
            Quantity::Ratio => ("ratio", 1.0),
            Quantity::Span => ("span", 1.0),
            Quantity::Height => ("height", 1.0),
        };
        let default = parameter.default.map(|value| value * scale);
        Self { key: parameter.key, symbol: parameter.symbol, quantity, default, optional: parameter.optional }
    }
}

/// Acceleration at 49 even steps of a unit rise, scaled to ±1, in hundredths: it is drawn as large as a word.
fn thumbnail(law: &Law) -> Vec<f64> {
    const STEPS: usize = 48;
    let arguments = Arguments { parameters: law.default_parameters(), falling: false, beta: 1.0 };
    let Ok(pieces) = law.unit(arguments) else { return Vec::new() };
    let at = |x: f64| pieces.iter().find(|piece| x < piece.until).or(pieces.last()).map_or(0.0, |piece| piece.at(x).a);
    let values: Vec<f64> = (0..=STEPS).map(|i| at(i as f64 / STEPS as f64)).collect();
    let peak = values.iter().fold(0.0_f64, |peak, value| peak.max(value.abs()));
    // Rounding shows as noise where the acceleration is nothing at all.
    let scaled = |value: &f64| if peak < 1e-9 { 0.0 } else { (value / peak * 100.0).round() / 100.0 + 0.0 };
    values.iter().map(scaled).collect()
}
