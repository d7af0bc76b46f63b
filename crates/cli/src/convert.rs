//! `levalab convert`: a design in other units.

use crate::failure::Failure;
use crate::input;
use levalab_format::{Edit, LengthUnit, SpeedUnit, Unit};
use levalab_words::Language;

/// What to convert, and to what.
#[derive(clap::Args)]
pub struct Options {
    /// Design file.
    file: String,
    /// Unit of every length.
    #[arg(long, required_unless_present = "speed", value_parser = length_unit)]
    unit: Option<LengthUnit>,
    /// Unit of the speed of a cam that turns.
    #[arg(long, value_parser = speed_unit)]
    speed: Option<SpeedUnit>,
    /// Keep the numbers and change the unit alone: another cam.
    #[arg(long)]
    relabel: bool,
}

/// The design file of the same cam in the other unit, or of another cam with the same numbers.
pub fn run(options: &Options, language: Language) -> Result<String, Failure> {
    let design = input::design(&options.file, language)?;
    let units = [options.unit.map(Unit::Length), options.speed.map(Unit::Speed)];
    let edit = |unit| if options.relabel { Edit::Relabel { unit } } else { Edit::Convert { unit } };
    let edits: Vec<Edit> = units.into_iter().flatten().map(edit).collect();
    let edited = design.edited(&edits).map_err(|error| Failure::design(&error, &options.file, language))?;
    Ok(edited.to_json())
}

fn length_unit(text: &str) -> Result<LengthUnit, String> {
    let known = LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == text);
    known.ok_or_else(|| choices(&LengthUnit::ALL.map(LengthUnit::symbol)))
}

fn speed_unit(text: &str) -> Result<SpeedUnit, String> {
    let symbol = |unit: SpeedUnit| unit.symbol(LengthUnit::default());
    let known = SpeedUnit::ALL.into_iter().find(|&unit| symbol(unit) == text);
    known.ok_or_else(|| choices(&SpeedUnit::ALL.map(symbol)))
}

fn choices(units: &[&str]) -> String {
    format!("one of {}", units.join(", "))
}
