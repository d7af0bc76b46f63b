//! What somebody wants exported, as the command line and the page both ask for it.

use crate::{
    CamDrawing, DiagramChoice, Keyway, Refusal, Separator, Shaft, Step, Subject, Table, cam_svg, csv, diagram_svg, dxf,
    stl, xlsx,
};

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table for spreadsheets.
    Csv,
    /// A workbook with every table.
    Xlsx,
    /// Curves for CAD.
    Dxf,
    /// A drawing.
    Svg,
    /// A picture.
    #[cfg(feature = "png")]
    Png,
    /// A solid for printing.
    Stl,
}

/// A file that is wanted. What is not given is as usual; lengths are in the unit of the design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// What kind of file.
    pub format: Format,
    /// Degrees between rows of a table, or points of a curve.
    pub step: Option<f64>,
    /// CSV: which table.
    pub table: Table,
    /// CSV: what parts cells; that of the language when not given.
    pub separator: Option<Separator>,
    /// Drawings: a diagram instead of the cam.
    pub diagram: Option<DiagramChoice>,
    /// Diagrams: derivatives by time.
    pub per_second: bool,
    /// Drawings: the paper that the cam has to fit on, mm, and then with a line to check the printer by.
    pub room: Option<[f64; 2]>,
    /// Pictures: width, pixels.
    pub width: u32,
    /// Solids: thickness.
    pub thickness: Option<f64>,
    /// Diameter of the hole for the shaft.
    pub bore: Option<f64>,
    /// The slot in its wall.
    pub keyway: Option<Keyway>,
}

/// Thickness of a cam, as a part of its base radius, when nothing is said about it.
const THICKNESS: f64 = 1.0 / 3.0;

impl Order {
    /// A file of that kind, with everything as usual.
    #[must_use]
    pub fn of(format: Format) -> Self {
        Self {
            format,
            step: None,
            table: Table::Everything,
            separator: None,
            diagram: None,
            per_second: false,
            room: None,
            width: 1600,
            thickness: None,
            bore: None,
            keyway: None,
        }
    }

    /// Makes the file.
    ///
    /// # Errors
    /// When something of the order makes no sense for this cam.
    pub fn make(&self, subject: &Subject) -> Result<Vec<u8>, Refusal> {
        let step = |usual| self.step.map_or(Ok(usual), Step::of_degrees);
        let shaft = self.bore.map(|bore| Shaft { bore, keyway: self.keyway });
        Ok(match self.format {
            Format::Csv => {
                let separator = self.separator.unwrap_or_else(|| Separator::of(subject.language));
                csv(subject, self.table, step(Step::OF_TABLES)?, separator).into_bytes()
            }
            Format::Xlsx => xlsx(subject, step(Step::OF_TABLES)?)?,
            Format::Dxf => dxf(subject, step(Step::OF_CURVES)?, shaft)?,
            Format::Svg => self.drawing(subject, shaft)?.into_bytes(),
            #[cfg(feature = "png")]
            Format::Png => crate::png(&self.drawing(subject, shaft)?, self.width)?,
            Format::Stl => {
                let thickness = self.thickness.unwrap_or(THICKNESS * subject.size());
                stl(subject, step(Step::OF_CURVES)?, thickness, shaft)?
            }
        })
    }

    fn drawing(&self, subject: &Subject, shaft: Option<Shaft>) -> Result<String, Refusal> {
        match self.diagram {
            Some(choice) => diagram_svg(subject, choice, self.per_second),
            None => cam_svg(subject, &CamDrawing { room: self.room, check: self.room.is_some(), shaft }),
        }
    }
}
