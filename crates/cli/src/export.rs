//! `levalab export`: a cam as a file for another program.

use crate::failure::{Failure, shown};
use crate::{input, output};
use clap::builder::PossibleValuesParser;
use clap::{Args, ValueEnum};
use levalab_export::{DiagramChoice, Format, Keyway, Order, Refusal, Separator, Subject, Table};
use levalab_words::Language;
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(Args)]
pub struct Options {
    /// Design file.
    file: String,
    /// Kind of file to write.
    #[arg(long)]
    to: To,
    /// File to write, or - for standard output.
    #[arg(short, long)]
    output: String,
    /// Degrees between rows of a table (1 unless told otherwise) or points of a curve (0.5).
    #[arg(long, allow_negative_numbers = true)]
    step: Option<f64>,
    /// CSV: which table.
    #[arg(long, default_value = Table::Everything.name(), value_parser = PossibleValuesParser::new(Table::ALL.map(Table::name)))]
    table: String,
    /// CSV: what parts cells; a semicolon goes with the decimal comma. As in the language unless told otherwise.
    #[arg(long)]
    separator: Option<Parting>,
    /// SVG and PNG: a diagram instead of the cam.
    #[arg(long, value_parser = PossibleValuesParser::new(DiagramChoice::all().into_iter().map(DiagramChoice::name)))]
    diagram: Option<String>,
    /// SVG and PNG: derivatives by time and not by angle; what an application gives, against time.
    #[arg(long)]
    per_second: bool,
    /// PNG: width in pixels.
    #[arg(long, default_value_t = 1600, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    width: u32,
    /// STL: thickness of the cam, in the unit of the design; a third of the base radius (a sixth of the length of a cam that travels) unless told otherwise.
    #[arg(long, allow_negative_numbers = true)]
    thickness: Option<f64>,
    /// STL, DXF, SVG, PNG: diameter of the hole for the shaft.
    #[arg(long, allow_negative_numbers = true)]
    bore: Option<f64>,
    /// Keyway in the wall of the bore, width x depth, such as 8x3.3.
    #[arg(long, requires = "bore", allow_hyphen_values = true, value_parser = keyway)]
    keyway: Option<(f64, f64)>,
}

#[derive(Clone, Copy, ValueEnum)]
enum To {
    /// A table for spreadsheets.
    Csv,
    /// A workbook with every table.
    Xlsx,
    /// Curves for CAD.
    Dxf,
    /// A drawing.
    Svg,
    /// A picture.
    Png,
    /// A solid for printing.
    Stl,
}

#[derive(Clone, Copy, ValueEnum)]
enum Parting {
    /// And a decimal point.
    Comma,
    /// And a decimal comma.
    Semicolon,
}

/// Writes the file.
pub fn run(options: &Options, language: Language) -> Result<ExitCode, Failure> {
    let study = input::study(&options.file, 1, language)?;
    let subject = Subject { study: &study, language };
    if options.output != "-" && is_same_file(&options.file, &options.output) {
        let said = match language {
            Language::En => "It is the design file itself, which would be lost.",
            Language::Es => "Es el propio archivo de diseño, que se perdería.",
        };
        return Err(Failure::usage(format!("--output: {}: {said}", shown(&options.output))));
    }
    let refused = |refusal: Refusal| Failure::export(&refusal, &options.file, language);
    let bytes = options.order().make(&subject).map_err(refused)?;
    if options.output == "-" {
        output::write_bytes(&bytes, language)?;
    } else {
        fs::write(&options.output, bytes).map_err(|_| Failure::unwritable(&options.output, language))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// True when two names lead to one file, by whatever links.
fn is_same_file(one: &str, other: &str) -> bool {
    let (Ok(one), Ok(other)) = (fs::canonicalize(one), fs::canonicalize(other)) else { return false };
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let place = |path: &PathBuf| fs::metadata(path).map(|data| (data.dev(), data.ino())).ok();
        if place(&one).is_some() && place(&one) == place(&other) {
            return true;
        }
    }
    one == other
}

impl Options {
    fn order(&self) -> Order {
        Order {
            step: self.step,
            table: Table::by_name(&self.table).unwrap_or(Table::Everything),
            separator: self.separator.map(|parting| match parting {
                Parting::Comma => Separator::Comma,
                Parting::Semicolon => Separator::Semicolon,
            }),
            diagram: self.diagram.as_deref().and_then(DiagramChoice::by_name),
            per_second: self.per_second,
            width: self.width,
            thickness: self.thickness,
            bore: self.bore,
            keyway: self.keyway.map(|(width, depth)| Keyway { width, depth }),
            ..Order::of(self.to.into())
        }
    }
}

impl From<To> for Format {
    fn from(to: To) -> Self {
        match to {
            To::Csv => Self::Csv,
            To::Xlsx => Self::Xlsx,
            To::Dxf => Self::Dxf,
            To::Svg => Self::Svg,
            To::Png => Self::Png,
            To::Stl => Self::Stl,
        }
    }
}

/// Width and depth of a keyway.
fn keyway(text: &str) -> Result<(f64, f64), String> {
    let measures = text.split_once(['x', 'X', '×']);
    let number = |text: &str| text.trim().parse::<f64>().ok();
    measures
        .and_then(|(width, depth)| Some((number(width)?, number(depth)?)))
        .ok_or_else(|| "a keyway is width x depth, such as 8x3.3".to_owned())
}
