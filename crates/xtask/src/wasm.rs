//! The machine room of the page: Rust to wasm, its JavaScript glue, and the optimiser, into `web/pkg/`. There are two modules: what
//! every visit loads, once cut down to what the first picture runs and once whole, and what is loaded when somebody wants a file.

use std::{
    collections::HashSet,
    env,
    ffi::{OsStr, OsString},
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use anyhow::{Context, Result, ensure};
use wasm_bindgen_cli_support::Bindgen;

use crate::{
    constants::{self, Constants},
    cutting, library, names,
    process::{self, run, told},
    project,
    setup::{self, WASM, WasmCompiler},
};

/// How much work goes into the module.
#[derive(Clone, Copy, PartialEq)]
pub enum Build {
    /// Soon ready: for trying out changes.
    Quick,
    /// What is shipped: whole-program optimised, then by wasm-opt.
    Shipped,
}

impl Build {
    fn profile(self) -> &'static str {
        match self {
            Build::Quick => "quick",
            Build::Shipped => "release",
        }
    }
}

/// What rustc emits, and every browser since 2021 reads; wasm-opt refuses or invents features without being told.
const FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
];

/// The crates that become modules, each by itself: what one asks of a crate below must not swell the other.
const MODULES: [&str; 2] = [PAGE, EXPORTS];

/// The module that every visit loads.
const PAGE: &str = "levalab-wasm";

/// Its file, whole.
pub const WHOLE: &str = "levalab_wasm_bg.wasm";

/// The file of what the first picture runs of it.
pub const FIRST: &str = "levalab_first.wasm";

/// The module whose libraries write numbers by their `Debug` form, which must not be taken from them.
const EXPORTS: &str = "levalab-export-wasm";

/// Part of the stamp: raise it when the steps below change what they write.
const RECIPE: &str = "6";

/// What makes the module smaller when the standard library is built from source with it: a panic stops at once instead of
/// making a sentence that nobody reads, and carries neither places nor the `Debug` forms of values.
/// Only small functions are copied into their callers, which is faster as well: V8 takes long functions less well.
const SMALL_FLAGS: [&str; 5] = [
    "-Zunstable-options",
    "-Cpanic=immediate-abort",
    "-Zlocation-detail=none",
    "-Zfmt-debug=none",
    "-Cllvm-args=-inline-threshold=30",
];

/// The standard library's own choice of small code; its sines and copies stay fast. The core costs a fortieth of its speed so, and
/// is a tenth smaller.
const SMALL_ARGUMENTS: [&str; 5] = [
    "-Zbuild-std-features=optimize_for_size",
    "--config",
    "profile.release.package.compiler_builtins.opt-level=3",
    "--config",
    "profile.release.package.levalab-core.opt-level=2",
];

/// The folder of the generated module.
pub fn package() -> PathBuf {
    project::path("web/pkg")
}

/// Brings `web/pkg/` up to date; quick when nothing changed.
pub fn build(build: Build) -> Result<()> {
    library::write(&package())?;
    MODULES.iter().try_for_each(|name| build_module(name, build))
}

fn build_module(name: &str, build: Build) -> Result<()> {
    let module = compile(name, build)?;
    let stamp = stamp(&module, build)?;
    let stamp_file = package().join(format!(".{name}.stamp"));
    if fs::read_to_string(&stamp_file).is_ok_and(|found| found == stamp) {
        return Ok(());
    }
    if build == Build::Shipped {
        setup::node_modules()?;
    }
    told("writing web/pkg", || write_package(name, &module, build))?;
    fs::write(&stamp_file, stamp).with_context(|| stamp_file.display().to_string())
}

/// The module as it comes from the compiler: made small when it is shipped and the compiler can.
fn compile(name: &str, build: Build) -> Result<PathBuf> {
    let compiler = setup::wasm_compiler()?;
    if build == Build::Shipped && name != EXPORTS && setup::library_sources(&compiler) {
        match compile_with(name, &compiler, build, true) {
            Ok(module) => return Ok(module),
            Err(error) => eprintln!("· {error:#}: once more with the standard library as it comes, a tenth larger"),
        }
    }
    compile_with(name, &compiler, build, false)
}

fn compile_with(name: &str, compiler: &WasmCompiler, build: Build, small: bool) -> Result<PathBuf> {
    let target = project::target()?;
    // Other flags, so another folder: neither module throws away what the other has compiled.
    let target = if name == EXPORTS { target.join("exports") } else { target };
    let (mut command, target) = match compiler {
        WasmCompiler::Same if small => {
            let mut command = process::cargo(["build", BUILD_STD]);
            command.env("RUSTC_BOOTSTRAP", "1");
            (command, target)
        }
        WasmCompiler::Same => (process::cargo(["build"]), target),
        // Another compiler, so another folder: neither throws away the other's work.
        WasmCompiler::Debian { linker } => (debian_cargo("build", linker), target.join("debian")),
    };
    command
        .args(["--package", name, "--lib", "--target", WASM, "--profile", build.profile()])
        .arg("--target-dir")
        .arg(&target)
        .args(SMALL_ARGUMENTS.iter().filter(|_| small))
        .env("CARGO_ENCODED_RUSTFLAGS", flags(small, cut_down(name, build)));
    told(&format!("compiling {name} for the page"), || run(&mut command))?;
    Ok(target.join(WASM).join(build.profile()).join(file_stem(name) + ".wasm"))
}

/// The name of a crate in the names of its files.
fn file_stem(name: &str) -> String {
    name.replace('-', "_")
}

/// The crates that become modules, as cargo's arguments.
pub fn packages() -> impl Iterator<Item = &'static str> {
    MODULES.iter().flat_map(|name| ["--package", name])
}

/// Looks for compiler warnings in the page's modules with Debian's compiler.
pub fn debian_check(linker: &Path) -> Result<Command> {
    let mut command = debian_cargo("check", linker);
    command.args(packages()).args(["--target", WASM, "--target-dir"]).arg(project::target()?.join("debian"));
    command.env("CARGO_ENCODED_RUSTFLAGS", "--deny=warnings");
    Ok(command)
}

/// Builds the standard library along with us.
const BUILD_STD: &str = "-Zbuild-std=std,panic_abort";

/// Debian's cargo and rustc, told to build the standard library as well.
fn debian_cargo(task: &str, linker: &Path) -> Command {
    let mut command = process::program("/usr/bin/cargo", [task, BUILD_STD]);
    command
        .env("RUSTC", "/usr/bin/rustc")
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker)
        .env_remove("CARGO")
        .env_remove("RUSTUP_TOOLCHAIN");
    command
}

/// True for a module of which the page first loads what the first picture runs.
fn cut_down(name: &str, build: Build) -> bool {
    name == PAGE && build == Build::Shipped
}

/// Compiler flags that keep this machine's folders out of the shipped file, and those that make it small.
fn flags(small: bool, listed: bool) -> OsString {
    let sources = dependency_folders().into_iter().chain([project::root().to_path_buf()]);
    let mut flags: Vec<OsString> = SMALL_FLAGS.iter().filter(|_| small).map(OsString::from).collect();
    flags.extend(constants::FLAGS.iter().filter(|_| listed).map(OsString::from));
    for folder in sources {
        let mut flag = OsString::from("--remap-path-prefix=");
        flag.push(folder);
        flag.push("=.");
        flags.push(flag);
    }
    flags.join(OsStr::new("\u{1f}"))
}

/// Where cargo unpacks the crates we depend on.
fn dependency_folders() -> Vec<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(env::home_dir()?.join(".cargo")));
    let Some(home) = home else { return Vec::new() };
    let Ok(entries) = fs::read_dir(home.join("registry/src")) else {
        return Vec::new();
    };
    let mut folders: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    folders.sort();
    folders
}

/// Names the module's bytes and what is done with them.
fn stamp(module: &Path, build: Build) -> Result<String> {
    let bytes = fs::read(module).with_context(|| module.display().to_string())?;
    let mut checksum = flate2::Crc::new();
    checksum.update(&bytes);
    // What is cut out of it.
    checksum.update(include_bytes!("first-picture.js"));
    Ok(format!("{RECIPE} {} {} {:08x}", build.profile(), bytes.len(), checksum.sum()))
}

/// Writes the glue and the module beside their places, then moves them in, so that no half-written file is ever served.
fn write_package(name: &str, module: &Path, build: Build) -> Result<()> {
    let fresh = project::target()?.join("pkg");
    if fresh.exists() {
        fs::remove_dir_all(&fresh).context("target/pkg")?;
    }
    let linked = fs::read(module).with_context(|| module.display().to_string())?;
    let constants = cut_down(name, build).then(|| Constants::of(&linked)).transpose()?;
    let stem = file_stem(name);
    let named = constants.is_some();
    write_glue(&stem, if named { constants::without_lists(&linked)? } else { linked }, named, &fresh)?;
    let glue = fresh.join(format!("{stem}.js"));
    let module = fresh.join(format!("{stem}_bg.wasm"));
    if build == Build::Shipped {
        let (short, renamed) = names::shorten(&fs::read_to_string(&glue)?, &fs::read(&module)?)?;
        fs::write(&glue, short)?;
        fs::write(&module, renamed)?;
        optimise(&module, named)?;
    }
    if name == PAGE {
        cut(&glue, &module, constants.as_ref())?;
    }
    let package = package();
    fs::create_dir_all(&package).context("web/pkg")?;
    for entry in fs::read_dir(&fresh)? {
        let entry = entry?;
        let place = package.join(entry.file_name());
        fs::rename(entry.path(), &place).with_context(|| place.display().to_string())?;
    }
    Ok(())
}

/// Writes what the first picture needs of a module beside it, whose constants are joined again; of one whose constants are not told apart,
/// what it needs is all.
fn cut(glue: &Path, module: &Path, constants: Option<&Constants>) -> Result<()> {
    let first = module.with_file_name(FIRST);
    let Some(constants) = constants else {
        fs::copy(module, first)?;
        return Ok(());
    };
    let whole = fs::read(module)?;
    fs::write(module, cutting::joined(&whole)?)?;
    fs::write(&first, cutting::first(&whole, &entered(glue, &whole)?, constants)?)?;
    optimise(&first, false)
}

/// The numbers of the stretches of code that the first picture enters.
fn entered(glue: &Path, whole: &[u8]) -> Result<HashSet<usize>> {
    let watched = glue.with_extension("watched");
    // Node takes it for a module by its ending alone.
    let script = glue.with_extension("mjs");
    fs::write(&watched, cutting::watched(whole)?)?;
    fs::copy(glue, &script)?;
    let mut picture = process::node([Path::new("crates/xtask/src/first-picture.js"), &script, &watched]);
    let output = picture.stderr(Stdio::inherit()).output().context("node did not start")?;
    ensure!(output.status.success(), "the first picture could not be drawn");
    fs::remove_file(watched)?;
    fs::remove_file(script)?;
    serde_json::from_slice(&output.stdout).context("first-picture.js printed no JSON")
}

fn write_glue(stem: &str, module: Vec<u8>, named: bool, folder: &Path) -> Result<()> {
    let mut bindgen = Bindgen::new();
    bindgen.input_bytes(stem, module).web(true)?.typescript(true).omit_default_module_path(false);
    bindgen.remove_name_section(!named).remove_producers_section(true);
    bindgen.generate(folder).context("wasm-bindgen")
}

/// Optimises a file in its place; `named` functions keep their names.
fn optimise(module: &Path, named: bool) -> Result<()> {
    let mut command = process::node([project::npm_tool("binaryen/bin/wasm-opt")]);
    command.arg("-Oz").args(FEATURES).args(["--strip-producers", "--strip-target-features"]);
    command.args(["--debuginfo"].iter().filter(|_| named));
    command.arg(module).arg("-o").arg(module);
    run(&mut command)
}
