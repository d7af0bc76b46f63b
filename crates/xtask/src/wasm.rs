//! The modules of the page: Rust to wasm, the generated JavaScript, and the optimiser, into `web/pkg/`.
//!
//! Every visit loads the page's own module. The others are crates of their own, loaded when their work is asked for.

use std::{
    env,
    ffi::{OsStr, OsString},
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use anyhow::{Context, Result};
use wasm_bindgen_cli_support::Bindgen;

use crate::{
    library,
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

/// A crate that becomes a module of the page.
#[derive(Clone, Copy, PartialEq)]
pub struct Module {
    /// The crate.
    package: &'static str,
    /// True for a module that is compiled together with a standard library made for small code.
    small: bool,
    /// True for a module that the single-file page carries.
    pub inline: bool,
}

/// The module of the main screen, which every visit loads.
pub const PAGE: Module = Module { package: "levalab-wasm", small: true, inline: true };

/// The worked solution, the joining of requirements and the tournament, loaded on demand.
pub const WORKSHOP: Module = Module { package: "levalab-workshop-wasm", small: true, inline: true };

/// The files for other programs, loaded on demand. Its libraries write numbers by their `Debug` form, which the small
/// standard library leaves out.
pub const EXPORTS: Module = Module { package: "levalab-export-wasm", small: false, inline: false };

/// All modules, each compiled by itself: what one asks of a crate below it does not swell another.
pub const MODULES: [Module; 3] = [PAGE, WORKSHOP, EXPORTS];

impl Module {
    /// The generated JavaScript.
    pub fn glue(self) -> String {
        format!("{}.js", self.stem())
    }

    /// The module itself.
    pub fn file(self) -> String {
        format!("{}_bg.wasm", self.stem())
    }

    /// The name of the crate in the names of its files, by which the page asks for the module.
    pub fn stem(self) -> String {
        self.package.replace('-', "_")
    }
}

/// Part of the stamp: raise it when the steps below change what they write.
const RECIPE: &str = "7";

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

/// Brings all of `web/pkg/` up to date; quick when nothing changed.
pub fn build(build: Build) -> Result<()> {
    build_only(&MODULES, build)
}

/// Brings the lists and some modules in `web/pkg/` up to date.
pub fn build_only(modules: &[Module], build: Build) -> Result<()> {
    library::write(&package())?;
    modules.iter().try_for_each(|module| build_module(*module, build))
}

fn build_module(module: Module, build: Build) -> Result<()> {
    let compiled = compile(module, build)?;
    let stamp = stamp(&compiled, build)?;
    let stamp_file = package().join(format!(".{}.stamp", module.package));
    if fs::read_to_string(&stamp_file).is_ok_and(|found| found == stamp) {
        return Ok(());
    }
    if build == Build::Shipped {
        setup::node_modules()?;
    }
    told("writing web/pkg", || write_package(module, &compiled, build))?;
    fs::write(&stamp_file, stamp).with_context(|| stamp_file.display().to_string())
}

/// The module as the compiler writes it: made small when it is shipped and the compiler can.
fn compile(module: Module, build: Build) -> Result<PathBuf> {
    let compiler = setup::wasm_compiler()?;
    if build == Build::Shipped && module.small && setup::library_sources(&compiler) {
        match compile_with(module, &compiler, build, true) {
            Ok(compiled) => return Ok(compiled),
            Err(error) => eprintln!("· {error:#}: once more with the standard library as it comes, a tenth larger"),
        }
    }
    compile_with(module, &compiler, build, false)
}

fn compile_with(module: Module, compiler: &WasmCompiler, build: Build, small: bool) -> Result<PathBuf> {
    let target = project::target()?;
    // Other flags, so another folder: no module throws away what another has compiled.
    let target = if module.small { target } else { target.join("exports") };
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
        .args(["--package", module.package, "--lib", "--target", WASM, "--profile", build.profile()])
        .arg("--target-dir")
        .arg(&target)
        .args(SMALL_ARGUMENTS.iter().filter(|_| small))
        .env("CARGO_ENCODED_RUSTFLAGS", flags(small));
    told(&format!("compiling {} for the page", module.package), || run(&mut command))?;
    Ok(target.join(WASM).join(build.profile()).join(module.stem() + ".wasm"))
}

/// The crates that become modules, as cargo's arguments.
pub fn packages() -> impl Iterator<Item = &'static str> {
    MODULES.iter().flat_map(|module| ["--package", module.package])
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

/// Compiler flags that keep this machine's folders out of the shipped file, and those that make it small.
fn flags(small: bool) -> OsString {
    let sources = dependency_folders().into_iter().chain([project::root().to_path_buf()]);
    let mut flags: Vec<OsString> = SMALL_FLAGS.iter().filter(|_| small).map(OsString::from).collect();
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
    Ok(format!("{RECIPE} {} {} {:08x}", build.profile(), bytes.len(), checksum.sum()))
}

/// Writes the glue and the module beside their places, then moves them in, so that no half-written file is ever served.
fn write_package(module: Module, compiled: &Path, build: Build) -> Result<()> {
    let fresh = project::target()?.join("pkg");
    if fresh.exists() {
        fs::remove_dir_all(&fresh).context("target/pkg")?;
    }
    write_glue(module, compiled, &fresh)?;
    if build == Build::Shipped {
        optimise(&fresh.join(module.file()))?;
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

fn write_glue(module: Module, compiled: &Path, folder: &Path) -> Result<()> {
    let bytes = fs::read(compiled).with_context(|| compiled.display().to_string())?;
    let mut bindgen = Bindgen::new();
    bindgen.input_bytes(&module.stem(), bytes).web(true)?.typescript(true).omit_default_module_path(false);
    bindgen.remove_name_section(true).remove_producers_section(true);
    bindgen.generate(folder).context("wasm-bindgen")
}

/// Optimises a file in its place.
fn optimise(module: &Path) -> Result<()> {
    let mut command = process::node([project::npm_tool("binaryen/bin/wasm-opt")]);
    command.arg("-Oz").args(FEATURES).args(["--strip-producers", "--strip-target-features"]);
    command.arg(module).arg("-o").arg(module);
    run(&mut command)
}
