//! A verdict with its sentences, as the page and the command line write it.

use crate::report::{DesignFinding, level_name};
use crate::{DesignCure, Edit};
use levalab_catalogue::finding_label;
use levalab_core::Level;
use serde::Serialize;

/// The verdict on a cam, or on both of a pair.
#[derive(Clone, Debug, Serialize)]
pub struct ToldVerdict<F> {
    /// Its word.
    pub level: &'static str,
    /// It in a sentence.
    pub headline: String,
    /// Which cam of a pair the headline is about, 1 or 2, where that is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cam: Option<u8>,
    /// What is wrong.
    pub findings: Vec<F>,
}

/// Something wrong with a cam; its numbers are those of [`DesignFinding`].
#[derive(Clone, Debug, Serialize)]
pub struct ToldFinding {
    /// Which cam of a pair it is about, 1 or 2, where that is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cam: Option<u8>,
    code: &'static str,
    severity: &'static str,
    theta: f64,
    interval: Option<[f64; 2]>,
    places: Vec<f64>,
    value: Option<f64>,
    limit: Option<f64>,
    message: String,
    /// The sentence with derivatives with respect to time, where it is given and differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message_by_time: Option<String>,
}

/// A cure: a sentence and what it changes.
#[derive(Clone, Debug, Serialize)]
pub struct ToldCure {
    message: String,
    edits: Vec<Edit>,
}

impl<F> ToldVerdict<F> {
    /// The verdict on a cam.
    #[must_use]
    pub fn new(level: Level, headline: String, findings: Vec<F>) -> Self {
        Self { level: level_name(level), headline, cam: None, findings }
    }
}

impl ToldFinding {
    /// A finding with its sentence.
    #[must_use]
    pub fn new(finding: &DesignFinding, message: String) -> Self {
        Self {
            cam: None,
            code: finding_label(finding.kind).id,
            severity: level_name(finding.level),
            theta: finding.theta,
            interval: finding.interval,
            places: finding.places.clone(),
            value: finding.value,
            limit: finding.limit,
            message,
            message_by_time: None,
        }
    }
}

impl ToldCure {
    /// A cure with its sentence.
    #[must_use]
    pub fn new(cure: DesignCure, message: String) -> Self {
        Self { message, edits: cure.edits }
    }
}
