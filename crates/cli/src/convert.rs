//! `levalab convert`: a design in other units.

use crate::failure::Failure;
use crate::input;
use levalab_format::{LengthUnit, Speed, SpeedUnit};
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
    let mut design = input::design(&options.file, language)?;
    let refused = |error| Failure::design(&error, &options.file, language);
    if let Some(unit) = options.unit {
        design = if options.relabel { design.relabelled(unit) } else { design.in_unit(unit).map_err(refused)? };
    }
    if let Some(unit) = options.speed {
        let Speed { value, .. } = design.speed;
        design = design.in_speed_unit(unit).map_err(refused)?;
        if options.relabel {
            design.speed.value = value;
        }
    }
    Ok(design.to_json())
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
