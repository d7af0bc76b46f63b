//! The exports in the browser: converts, calls, copies out. A module of its own, so that a page that exports nothing does not load it.

use levalab_export::{DiagramChoice, Format, Keyway, Order, Refusal, Separator, Subject, Table};
use levalab_format::{DesignError, Study};
use levalab_words::Language;
use serde::Deserialize;
use serde_json::Value;
use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
import type { Design, ExportOrder, Exported, Language } from "../types.d.ts";
"#;

/// What the page orders: `ExportOrder` of `web/types.d.ts`.
#[derive(Deserialize)]
struct PageOrder {
    to: String,
    step: Option<f64>,
    table: Option<String>,
    separator: Option<String>,
    diagram: Option<String>,
    #[serde(default)]
    per_second: bool,
    room: Option<[f64; 2]>,
    thickness: Option<f64>,
    bore: Option<f64>,
    keyway: Option<[f64; 2]>,
}

/// A file of a design, or why there is none.
///
/// # Errors
/// When design or order is not a plain object of the right shape.
#[wasm_bindgen(unchecked_return_type = "Exported")]
pub fn make(
    #[wasm_bindgen(unchecked_param_type = "Design")] design: JsValue,
    #[wasm_bindgen(unchecked_param_type = "ExportOrder")] order: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Language")] words: &str,
) -> Result<JsValue, JsError> {
    let language = Language::from_tag(words).unwrap_or_default();
    let value: Value = serde_wasm_bindgen::from_value(design)?;
    let order = PageOrder::order(serde_wasm_bindgen::from_value(order)?)?;
    let answer = js_sys::Object::new();
    let (key, said) = match made(&value, &order, language) {
        Ok(bytes) => ("bytes", js_sys::Uint8Array::from(bytes.as_slice()).into()),
        Err(message) => ("error", JsValue::from_str(&message)),
    };
    js_sys::Reflect::set(&answer, &key.into(), &said).map_err(|_| JsError::new(key))?;
    Ok(answer.into())
}

fn made(value: &Value, order: &Order, language: Language) -> Result<Vec<u8>, String> {
    let wrong = |error: DesignError| levalab_words::design_error(language, &error);
    let study = Study::open(value, 1).map_err(wrong)?;
    let subject = Subject { study: &study, language };
    order.make(&subject).map_err(|refusal: Refusal| refusal.sentence(language))
}

impl PageOrder {
    fn order(self) -> Result<Order, JsError> {
        let format = match self.to.as_str() {
            "csv" => Format::Csv,
            "xlsx" => Format::Xlsx,
            "dxf" => Format::Dxf,
            "svg" => Format::Svg,
            "stl" => Format::Stl,
            other => return Err(JsError::new(other)),
        };
        Ok(Order {
            step: self.step,
            table: self.table.as_deref().and_then(Table::by_name).unwrap_or(Table::Everything),
            separator: self.separator.and_then(|word| match word.as_str() {
                "comma" => Some(Separator::Comma),
                "semicolon" => Some(Separator::Semicolon),
                _ => None,
            }),
            diagram: self.diagram.as_deref().and_then(DiagramChoice::by_name),
            per_second: self.per_second,
            room: self.room,
            thickness: self.thickness,
            bore: self.bore,
            keyway: self.keyway.map(|[width, depth]| Keyway { width, depth }),
            ..Order::of(format)
        })
    }
}
