//! Writes the pages: `levalab-theory FOLDER`, with labels and drawings as JSON on standard input. `levalab-theory followers` prints
//! the followers and their symbols, from which the drawings are made.

use levalab_core::{FOLLOWERS, FollowerKind, Motion};
use levalab_theory::{Assets, pages};
use serde_json::json;
use std::collections::BTreeMap;
use std::{env, fs, io, path::PathBuf, process::ExitCode};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("levalab-theory: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let folder = env::args_os().nth(1).map(PathBuf::from).ok_or("name the folder to write into")?;
    if folder.as_os_str() == "followers" {
        println!("{}", followers());
        return Ok(());
    }
    let given: serde_json::Value = serde_json::from_reader(io::stdin().lock()).map_err(|error| error.to_string())?;
    let texts = |value: &serde_json::Value| {
        let entries = value.as_object().into_iter().flatten();
        entries.filter_map(|(key, text)| Some((key.clone(), text.as_str()?.to_owned()))).collect::<BTreeMap<_, _>>()
    };
    let languages = given["labels"].as_object().into_iter().flatten();
    let assets = Assets {
        labels: languages.map(|(tag, labels)| (tag.clone(), texts(labels))).collect(),
        drawings: texts(&given["drawings"]),
    };
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    for (name, text) in pages(&assets) {
        fs::write(folder.join(&name), text).map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(())
}

fn followers() -> serde_json::Value {
    let entry = |kind: &&FollowerKind| {
        let motion = if kind.motion == Motion::Oscillating { "oscillating" } else { "translating" };
        let parameters =
            kind.parameters.iter().map(|parameter| json!({ "key": parameter.key, "symbol": parameter.symbol }));
        json!({ "id": kind.id, "motion": motion, "parameters": parameters.collect::<Vec<_>>() })
    };
    FOLLOWERS.iter().map(entry).collect()
}
