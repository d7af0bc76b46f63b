//! Edits as JSON, and paths and assignments as the command line writes them.

use super::{Completion, Edit, Left, Unit};
use crate::application::TargetsBy;
use crate::fields::{Field, Object};
use crate::kind::BreadthGenerator;
use crate::limits::MAX_SEGMENTS;
use crate::write::number;
use crate::{CamKind, DataRefusal, Design, DesignError, LengthUnit, Path, PathPart, Problem, SpeedUnit};
use levalab_core::application::APPLICATIONS;
use levalab_core::{FOLLOWERS, LAWS};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// Most edits in a list: more than a program has numbers.
const MAX_EDITS: usize = 1024;

/// Deepest path: more than a design has levels.
const MAX_STEPS: usize = 16;

/// The words for the changes of structure.
const OPS: [&str; 27] = [
    "clear",
    "insert",
    "duplicate",
    "delete",
    "move",
    "law",
    "beta",
    "fill-with-dwell",
    "fill-with-return",
    "stretch-last",
    "spread",
    "close",
    "scale",
    "condition",
    "add-condition",
    "move-conditions",
    "drop-conditions",
    "formula",
    "follower",
    "kind",
    "generator",
    "pair",
    "application",
    "targets-by",
    "convert",
    "relabel",
    "new",
];

/// The words for the ties of a second cam.
const TIES: [&str; 3] = ["distance", "angle", "base_radius"];

impl Edit {
    /// The edits of an object, or of a list of them.
    ///
    /// # Errors
    /// Says where a value is no edit, and why.
    pub fn list(value: &Value) -> Result<Vec<Self>, DesignError> {
        let root = Path::from("edits");
        match value {
            Value::Array(items) if items.len() > MAX_EDITS => {
                let problem = DataRefusal::WrongCount { found: items.len(), min: 1, max: MAX_EDITS };
                Err(DesignError::at(root, problem))
            }
            Value::Array(items) => {
                let each = items.iter().enumerate().map(|(k, item)| read(&Object::any(item, root.join(k))?));
                each.collect()
            }
            one => Ok(vec![read(&Object::any(one, root.join(0))?)?]),
        }
    }

    /// The edit of an assignment such as `cam.base_radius=36`; nothing after the sign takes the field away. What is no JSON is a
    /// text, so that words need no quotes.
    ///
    /// # Errors
    /// When there is no sign, or what stands before it is no path.
    pub fn assignment(text: &str) -> Result<Self, DesignError> {
        let no_path = || DesignError::at("edits", Problem::NoAssignment { found: text.to_owned() });
        let (place, value) = text.split_once('=').ok_or_else(no_path)?;
        let path = Path::read(place.trim()).ok_or_else(no_path)?;
        let value = value.trim();
        if value.is_empty() {
            return Ok(Self::Clear { path });
        }
        // These are texts, whatever they look like, unless they stand in quotes.
        let is_text = matches!(path.field(), Some("title" | "expression")) && !value.starts_with('"');
        let parsed = if is_text { None } else { crate::json::parse(value).ok() };
        let value = parsed.unwrap_or_else(|| Value::String(value.to_owned()));
        Ok(Self::Set { path, value })
    }
}

impl Path {
    /// The path of a text such as `segments[2].beta`; `None` if it is none.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let mut parts = Vec::new();
        for step in text.split('.') {
            let (key, indices) = step.split_at(step.find('[').unwrap_or(step.len()));
            let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
            if key.is_empty() || !key.chars().all(plain) {
                return None;
            }
            parts.push(PathPart::Key(key.to_owned()));
            for index in indices.split_inclusive(']') {
                let index = index.strip_prefix('[')?.strip_suffix(']')?;
                parts.push(PathPart::Index(index.parse().ok()?));
            }
        }
        Some(Self(parts))
    }
}

fn read(edit: &Object) -> Result<Edit, DesignError> {
    if !edit.has("op") {
        edit.only(&["path", "value"])?;
        let value = edit.required("value")?.value.clone();
        return Ok(Edit::Set { path: read_path(&edit.required("path")?)?, value });
    }
    let op = OPS[edit.word("op", &OPS)?];
    let only = |fields: &[&'static str]| edit.only(&[&["op"], fields].concat());
    let index = |key: &str| edit.required(key).and_then(|field| read_index(&field));
    let number = |key: &str| edit.required(key).and_then(|field| field.number());
    Ok(match op {
        "clear" => {
            only(&["path"])?;
            Edit::Clear { path: read_path(&edit.required("path")?)? }
        }
        "insert" => {
            only(&["at", "from"])?;
            let at = index("at")?;
            Edit::Insert { at, from: if edit.has("from") { index("from")? } else { at.saturating_sub(1) } }
        }
        "duplicate" => {
            only(&["segment"])?;
            Edit::Duplicate { segment: index("segment")? }
        }
        "delete" => {
            only(&["segments"])?;
            let list = edit.required("segments")?;
            let segments = list.items(MAX_SEGMENTS)?.map(|item| read_index(&item)).collect::<Result<_, _>>()?;
            Edit::Delete { segments }
        }
        "move" => {
            only(&["from", "to"])?;
            Edit::Move { from: index("from")?, to: index("to")? }
        }
        "law" => {
            only(&["segment", "law"])?;
            let ids: Vec<&'static str> = LAWS.iter().map(|law| law.id).collect();
            Edit::Law { segment: index("segment")?, law: LAWS[edit.word("law", &ids)?] }
        }
        "beta" => {
            only(&["segment", "value"])?;
            Edit::Beta { segment: index("segment")?, value: number("value")? }
        }
        "scale" => {
            only(&["factor"])?;
            Edit::Scale { factor: number("factor")? }
        }
        "condition" => {
            only(&["segment", "at", "order", "value"])?;
            let order = read_order(&edit.required("order")?)?;
            Edit::Condition { segment: index("segment")?, at: number("at")?, order, value: number("value")? }
        }
        "add-condition" => {
            only(&["segment"])?;
            Edit::AddCondition { segment: index("segment")? }
        }
        "move-conditions" => {
            only(&["segment", "from", "to"])?;
            Edit::MoveConditions { segment: index("segment")?, from: number("from")?, to: number("to")? }
        }
        "drop-conditions" => {
            only(&["segment", "at", "order"])?;
            let order = edit.optional("order").map(|field| read_order(&field)).transpose()?;
            Edit::DropConditions { segment: index("segment")?, at: number("at")?, order }
        }
        "formula" => {
            only(&["segment", "text"])?;
            Edit::Formula { segment: index("segment")?, text: edit.required("text")?.text()? }
        }
        "follower" => {
            only(&["follower"])?;
            let ids: Vec<&'static str> = FOLLOWERS.iter().map(|kind| kind.id).collect();
            Edit::Follower { kind: FOLLOWERS[edit.word("follower", &ids)?] }
        }
        "kind" => {
            only(&["kind", "before", "after"])?;
            let kind = CamKind::WORDS[edit.word("kind", &CamKind::WORDS)?];
            let design = |key: &str| edit.required(key).and_then(|field| Design::draft(field.value));
            let back = match edit.has("before") || edit.has("after") {
                true => Some(Box::new(Left { before: design("before")?, after: design("after")? })),
                false => None,
            };
            Edit::Kind { kind, back }
        }
        "generator" => {
            only(&["generator", "sides"])?;
            let generator = BreadthGenerator::WORDS[edit.word("generator", &BreadthGenerator::WORDS)?];
            let sides = edit.optional("sides").map(|field| crate::read::read_sides(&field)).transpose()?;
            Edit::Generator { generator, sides }
        }
        "pair" => {
            only(&["tie", "value"])?;
            let value = edit.optional("value").map(|field| field.number()).transpose()?;
            Edit::Pair { tie: TIES[edit.word("tie", &TIES)?], value }
        }
        "application" => {
            only(&["application"])?;
            let ids: Vec<&'static str> = APPLICATIONS.iter().map(|application| application.id).collect();
            let kind = if edit.has("application") { Some(APPLICATIONS[edit.word("application", &ids)?]) } else { None };
            Edit::Application { kind }
        }
        "targets-by" => {
            only(&["by"])?;
            let time = edit.word("by", &TargetsBy::WORDS)? == 1;
            Edit::TargetsBy { by: if time { TargetsBy::Time } else { TargetsBy::Theta } }
        }
        "convert" => {
            only(&["unit"])?;
            Edit::Convert { unit: read_unit(edit)? }
        }
        "relabel" => {
            only(&["unit"])?;
            Edit::Relabel { unit: read_unit(edit)? }
        }
        "new" => {
            only(&[])?;
            Edit::New
        }
        completion => {
            only(&[])?;
            Edit::Complete(COMPLETIONS.iter().find(|(word, _)| *word == completion).map_or(Completion::Dwell, |c| c.1))
        }
    })
}

/// The ways to complete a program, with their words.
const COMPLETIONS: [(&str, Completion); 5] = [
    ("fill-with-dwell", Completion::Dwell),
    ("fill-with-return", Completion::Return),
    ("stretch-last", Completion::Stretch),
    ("spread", Completion::Spread),
    ("close", Completion::Close),
];

fn read_path(field: &Field) -> Result<Path, DesignError> {
    let part = |item: Field| match item.value {
        Value::String(key) => Ok(PathPart::Key(key.clone())),
        _ => read_index(&item).map(PathPart::Index),
    };
    Ok(Path(field.items(MAX_STEPS)?.map(part).collect::<Result<_, _>>()?))
}

/// A place in a list, from 0.
fn read_index(field: &Field) -> Result<usize, DesignError> {
    let found = field.number()?;
    let whole = found.fract() == 0.0 && (0.0..=f64::from(u16::MAX)).contains(&found);
    if whole { Ok(found as usize) } else { Err(DesignError::at(field.path.clone(), Problem::NoIndex { found })) }
}

fn read_order(field: &Field) -> Result<u8, DesignError> {
    let found = field.number()?;
    if [0.0, 1.0, 2.0, 3.0].contains(&found) {
        return Ok(found as u8);
    }
    Err(DesignError::at(field.path.clone(), DataRefusal::WrongOrder { found }))
}

fn read_unit(edit: &Object) -> Result<Unit, DesignError> {
    let lengths = LengthUnit::ALL.map(LengthUnit::symbol);
    let speeds = SpeedUnit::ALL.map(|unit| unit.symbol(LengthUnit::default()));
    let index = edit.word("unit", &[lengths.as_slice(), &speeds].concat())?;
    Ok(match LengthUnit::ALL.get(index) {
        Some(&unit) => Unit::Length(unit),
        None => Unit::Speed(SpeedUnit::ALL[index - lengths.len()]),
    })
}

impl Unit {
    fn symbol(self) -> &'static str {
        match self {
            Self::Length(unit) => unit.symbol(),
            Self::Speed(unit) => unit.symbol(LengthUnit::default()),
        }
    }
}

impl Edit {
    /// The word for a change of structure; none for the value at a path.
    fn op(&self) -> Option<&'static str> {
        Some(match self {
            Self::Set { .. } => return None,
            Self::Clear { .. } => "clear",
            Self::Insert { .. } => "insert",
            Self::Duplicate { .. } => "duplicate",
            Self::Delete { .. } => "delete",
            Self::Move { .. } => "move",
            Self::Law { .. } => "law",
            Self::Beta { .. } => "beta",
            Self::Complete(completion) => {
                COMPLETIONS.iter().find(|(_, other)| other == completion).map_or("spread", |(word, _)| word)
            }
            Self::Scale { .. } => "scale",
            Self::Condition { .. } => "condition",
            Self::AddCondition { .. } => "add-condition",
            Self::MoveConditions { .. } => "move-conditions",
            Self::DropConditions { .. } => "drop-conditions",
            Self::Formula { .. } => "formula",
            Self::Follower { .. } => "follower",
            Self::Kind { .. } => "kind",
            Self::Generator { .. } => "generator",
            Self::Pair { .. } => "pair",
            Self::Application { .. } => "application",
            Self::TargetsBy { .. } => "targets-by",
            Self::Convert { .. } => "convert",
            Self::Relabel { .. } => "relabel",
            Self::New => "new",
        })
    }

    /// What goes with the word, in order.
    fn fields(&self) -> Vec<(&'static str, Value)> {
        let path_of = |path: &Path| serde_json::to_value(&path.0).unwrap_or_default();
        let optional = |key, value: Option<Value>| value.map(|value| (key, value));
        match *self {
            Self::Set { ref path, ref value } => vec![("path", path_of(path)), ("value", value.clone())],
            Self::Clear { ref path } => vec![("path", path_of(path))],
            Self::Insert { at, from } => vec![("at", at.into()), ("from", from.into())],
            Self::Duplicate { segment } | Self::AddCondition { segment } => vec![("segment", segment.into())],
            Self::Delete { ref segments } => vec![("segments", segments.clone().into())],
            Self::Move { from, to } => vec![("from", from.into()), ("to", to.into())],
            Self::Law { segment, law } => vec![("segment", segment.into()), ("law", law.id.into())],
            Self::Beta { segment, value } => vec![("segment", segment.into()), ("value", number(value))],
            Self::Scale { factor } => vec![("factor", number(factor))],
            Self::Condition { segment, at, order, value } => {
                vec![("segment", segment.into()), ("at", number(at)), ("order", order.into()), ("value", number(value))]
            }
            Self::MoveConditions { segment, from, to } => {
                vec![("segment", segment.into()), ("from", number(from)), ("to", number(to))]
            }
            Self::DropConditions { segment, at, order } => {
                let order = optional("order", order.map(Value::from));
                [("segment", segment.into()), ("at", number(at))].into_iter().chain(order).collect()
            }
            Self::Formula { segment, ref text } => vec![("segment", segment.into()), ("text", text.as_str().into())],
            Self::Follower { kind } => vec![("follower", kind.id.into())],
            Self::Kind { kind, ref back } => {
                let designs =
                    back.iter().flat_map(|left| [("before", left.before.to_value()), ("after", left.after.to_value())]);
                [("kind", kind.into())].into_iter().chain(designs).collect()
            }
            Self::Generator { generator, sides } => {
                let sides = optional("sides", sides.map(Value::from));
                [("generator", generator.into())].into_iter().chain(sides).collect()
            }
            Self::Pair { tie, value } => {
                let value = optional("value", value.map(number));
                [("tie", tie.into())].into_iter().chain(value).collect()
            }
            Self::Application { kind } => {
                optional("application", kind.map(|application| application.id.into())).into_iter().collect()
            }
            Self::TargetsBy { by } => vec![("by", by.word().into())],
            Self::Convert { unit } | Self::Relabel { unit } => vec![("unit", unit.symbol().into())],
            Self::Complete(_) | Self::New => Vec::new(),
        }
    }
}

impl Serialize for Edit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        if let Some(op) = self.op() {
            map.serialize_entry("op", op)?;
        }
        for (key, value) in self.fields() {
            map.serialize_entry(key, &value)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_edit_comes_back_from_its_json() {
        let told = json!([
            { "path": ["cam", "base_radius"], "value": 36 },
            { "op": "clear", "path": ["segments", 2, "knots"] },
            { "op": "insert", "at": 3, "from": 2 },
            { "op": "duplicate", "segment": 1 },
            { "op": "delete", "segments": [1, 4] },
            { "op": "move", "from": 0, "to": 5 },
            { "op": "law", "segment": 2, "law": "cycloidal" },
            { "op": "beta", "segment": 2, "value": 41.5 },
            { "op": "fill-with-dwell" },
            { "op": "fill-with-return" },
            { "op": "stretch-last" },
            { "op": "spread" },
            { "op": "close" },
            { "op": "scale", "factor": 1.5 },
            { "op": "condition", "segment": 0, "at": 20, "order": 2, "value": -3 },
            { "op": "add-condition", "segment": 0 },
            { "op": "move-conditions", "segment": 0, "from": 20, "to": 25 },
            { "op": "drop-conditions", "segment": 0, "at": 20 },
            { "op": "drop-conditions", "segment": 0, "at": 20, "order": 1 },
            { "op": "formula", "segment": 0, "text": "s₀ + L x" },
            { "op": "follower", "follower": "oscillating-roller" },
            { "op": "kind", "kind": "grooved" },
            { "op": "generator", "generator": "circular-arc", "sides": 5 },
            { "op": "pair", "tie": "distance" },
            { "op": "pair", "tie": "angle", "value": 90 },
            { "op": "application" },
            { "op": "application", "application": "pump" },
            { "op": "targets-by", "by": "time" },
            { "op": "convert", "unit": "in" },
            { "op": "relabel", "unit": "rpm" },
            { "op": "new" },
        ]);
        let edits = Edit::list(&told).expect("edits");
        assert_eq!(serde_json::to_value(&edits).expect("JSON"), told);
        let words: std::collections::HashSet<_> = edits.iter().filter_map(Edit::op).collect();
        assert_eq!(words.len(), OPS.len(), "every word is in the list");
    }

    #[test]
    fn the_documentation_lists_every_edit_with_its_fields_and_its_examples_are_edits() {
        let page = include_str!("../../../../docs/edits.md");
        for op in OPS {
            assert!(page.contains(&format!("| `{op}` |")), "{op} is not told");
        }
        let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` | "));
        for (op, row) in rows.filter(|(op, _)| OPS.contains(op)) {
            let fields = row.split_once(" |").map_or("", |(fields, _)| fields.trim_start_matches('|'));
            let names: Vec<&str> = fields.split('`').skip(1).step_by(2).collect();
            let with = |name: &str| {
                let mut edit = json!({ "op": op });
                edit[name] = "?".into();
                Edit::list(&edit)
            };
            let unknown = |name: &str| {
                let error = with(name).err();
                error.is_some_and(|error| matches!(error.problem, Problem::UnknownField { .. }))
            };
            assert!(names.iter().all(|name| !unknown(name)), "{op} has not all of {names:?}");
            assert!(unknown("something"), "{op}");
        }
        let blocks: Vec<&str> = page.split("```json").skip(1).filter_map(|rest| rest.split("```").next()).collect();
        assert!(!blocks.is_empty());
        for block in blocks {
            Edit::from_bytes(block.as_bytes()).unwrap_or_else(|error| panic!("{error}: {block}"));
        }
    }

    #[test]
    fn what_is_no_edit_is_refused_at_its_place() {
        for (told, place) in [
            (json!({ "op": "fly" }), "edits[0].op"),
            (json!([{ "op": "spread" }, { "op": "law", "segment": 0, "law": "magic" }]), "edits[1].law"),
            (json!({ "op": "delete", "segments": [0.5] }), "edits[0].segments[0]"),
            (json!({ "op": "spread", "segment": 0 }), "edits[0].segment"),
            (json!({ "path": ["cam", -1], "value": 0 }), "edits[0].path[1]"),
            (json!({ "path": ["cam"] }), "edits[0].value"),
            (json!(7), "edits[0]"),
        ] {
            let error = Edit::list(&told).expect_err("no edit");
            assert_eq!(error.path.to_string(), place, "{told}");
        }
    }

    #[test]
    fn an_assignment_is_a_path_and_a_value() {
        let set = |text: &str| Edit::assignment(text).expect(text);
        assert_eq!(set("cam.base_radius=36"), Edit::set(["cam", "base_radius"], 36.0));
        assert_eq!(set("segments[2].beta = 40.5"), Edit::set(Path::from("segments").join(2).join("beta"), 40.5));
        assert_eq!(set("notation=norton"), Edit::set("notation", "norton"));
        assert_eq!(set("title=a = b"), Edit::set("title", "a = b"));
        assert_eq!(set("title=42"), Edit::set("title", "42"));
        assert_eq!(set("title=\"42\""), Edit::set("title", "42"));
        assert_eq!(set("conjugate="), Edit::Clear { path: "conjugate".into() });
        assert_eq!(
            set("segments[0].points[3][1]=2"),
            Edit::set(Path::from("segments").join(0).join("points").join(3).join(1), 2.0)
        );
        for text in ["cam.base_radius", "=3", "a..b=1", "segments[x]=1", "segments[1=1", "a b=1"] {
            assert!(Edit::assignment(text).is_err(), "{text}");
        }
    }
}
