//! What the machine must have: found, installed where that is possible, else said exactly.

use std::{
    env, fs,
    path::{Path, PathBuf},
    sync::OnceLock,
};

use anyhow::{Context, Result, bail, ensure};

use crate::{
    process::{self, output, run_told},
    project,
};

/// The page's target triple.
pub const WASM: &str = "wasm32-unknown-unknown";

/// The oldest Node that all the development tools accept.
const NODE: (u32, u32) = (20, 19);

/// Which compiler builds for the page.
#[derive(Clone)]
pub enum WasmCompiler {
    /// The one that runs us: it has the target's standard library.
    Same,
    /// Debian's own, with the standard library built from source; the linker comes from either.
    Debian {
        /// `rust-lld` or `wasm-ld`.
        linker: PathBuf,
    },
}

/// Makes sure something here compiles for the page: as it is, by rustup, or by Debian's packages. Looked up once.
pub fn wasm_compiler() -> Result<WasmCompiler> {
    static FOUND: OnceLock<WasmCompiler> = OnceLock::new();
    match FOUND.get() {
        Some(found) => Ok(found.clone()),
        None => find_wasm_compiler().map(|found| FOUND.get_or_init(|| found).clone()),
    }
}

fn find_wasm_compiler() -> Result<WasmCompiler> {
    let sysroot = sysroot()?;
    let library = sysroot.join("lib/rustlib").join(WASM);
    if library.is_dir() {
        return Ok(WasmCompiler::Same);
    }
    let mut rustup = process::program("rustup", ["target", "add", WASM]);
    let added = run_told(&format!("adding the Rust target {WASM} by rustup"), &mut rustup);
    if added.is_ok() && library.is_dir() {
        return Ok(WasmCompiler::Same);
    }
    debian_compiler(&sysroot).with_context(|| {
        format!("this Rust cannot compile for the page: run `rustup target add {WASM}`, or on Debian `apt-get install rustc-web cargo-web rust-web-src lld`")
    })
}

/// Whether the standard library's source is there, or could be fetched: the shipped module is smaller when built with it.
pub fn library_sources(compiler: &WasmCompiler) -> bool {
    let Ok(sysroot) = sysroot() else { return false };
    let source = sysroot.join("lib/rustlib/src/rust/library/Cargo.lock");
    if source.is_file() || matches!(compiler, WasmCompiler::Debian { .. }) {
        return true;
    }
    let mut rustup = process::program("rustup", ["component", "add", "rust-src"]);
    run_told("adding the standard library's source by rustup, for a smaller module", &mut rustup).is_ok()
        && source.is_file()
}

/// Where the compiler that runs us lies.
pub fn sysroot() -> Result<PathBuf> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let path = output(&mut process::program(rustc, ["--print", "sysroot"])).context("rustc did not run")?;
    Ok(path.into())
}

fn debian_compiler(sysroot: &Path) -> Result<WasmCompiler> {
    let packages = ["rustc-web", "cargo-web", "rust-web-src"];
    if !packages.into_iter().all(debian_has) {
        apt_install(&packages)?;
    }
    let own = sysroot.join("lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld");
    let linker = if own.is_file() {
        own
    } else {
        if process::find("wasm-ld").is_none() {
            apt_install(&["lld"])?;
        }
        process::find("wasm-ld").context("no wasm-ld")?
    };
    eprintln!("· compiling for the page with Debian's rustc, linking with {}", linker.display());
    Ok(WasmCompiler::Debian { linker })
}

fn debian_has(package: &str) -> bool {
    output(&mut process::program("dpkg-query", ["--show", "--showformat=${Status}", package]))
        .is_some_and(|status| status == "install ok installed")
}

/// Installs Debian packages when we may: as root, where apt-get is.
fn apt_install(packages: &[&str]) -> Result<()> {
    let root = output(&mut process::program("id", ["-u"])).is_some_and(|id| id == "0");
    if !root || process::find("apt-get").is_none() {
        bail!("not root on Debian, so nothing was installed");
    }
    let mut update = process::program("apt-get", ["update", "--quiet=2"]);
    run_told("refreshing Debian's package lists", &mut update)?;
    let mut install = process::program("apt-get", ["install", "--yes", "--quiet=2", "--no-install-recommends"]);
    install.args(packages).env("DEBIAN_FRONTEND", "noninteractive");
    run_told(&format!("installing {} by apt-get", packages.join(" ")), &mut install)
}

/// Makes sure Node is there and the development packages are those of the lock file.
pub fn node_modules() -> Result<()> {
    check_node()?;
    let lock = fs::read(project::path("package-lock.json")).context("package-lock.json")?;
    let stamp = project::path("node_modules/.installed-lock.json");
    if fs::read(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    run_told(
        "installing the development packages by npm",
        &mut process::npm(["ci", "--no-progress", "--loglevel=error"]),
    )?;
    fs::write(&stamp, lock).with_context(|| stamp.display().to_string())
}

fn check_node() -> Result<()> {
    let wanted = format!(
        "Node.js {}.{} or newer with npm: install it from nodejs.org or your system's packages",
        NODE.0, NODE.1
    );
    let found = output(&mut process::node(["--version"]))
        .with_context(|| format!("no node in PATH. LevaLab's tests need {wanted}"))?;
    let mut numbers = found.trim_start_matches('v').split('.').map_while(|part| part.parse().ok());
    let version = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0));
    if version < NODE {
        bail!("node is {found}. LevaLab's tests need {wanted}");
    }
    output(&mut process::npm(["--version"]))
        .with_context(|| format!("no npm in PATH. LevaLab's tests need {wanted}"))?;
    Ok(())
}

/// A Chromium-family browser: named by `LEVALAB_BROWSER`, in PATH, in its usual place, or installed.
pub fn browser() -> Result<PathBuf> {
    if let Some(named) = env::var_os("LEVALAB_BROWSER") {
        let named = PathBuf::from(named);
        return if named.is_file() {
            Ok(named)
        } else {
            bail!("LEVALAB_BROWSER names {}, which is no file", named.display())
        };
    }
    if let Some(found) = find_browser() {
        return Ok(found);
    }
    let installed = apt_install(&["chromium"]);
    find_browser().map_or_else(
        || {
            installed.and_then(|()| bail!("chromium was installed but is not found")).context(
                "no Chrome, Chromium or Edge: install one (Debian: `apt-get install chromium`), or name its program in LEVALAB_BROWSER",
            )
        },
        Ok,
    )
}

fn find_browser() -> Option<PathBuf> {
    let names =
        ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge"];
    names.iter().find_map(|name| process::find(name)).or_else(|| usual_places().into_iter().find(|path| path.is_file()))
}

/// Firefox as its makers ship it: named by `LEVALAB_FIREFOX`, in PATH, in its usual place, or installed.
pub fn firefox() -> Result<PathBuf> {
    if let Some(named) = env::var_os("LEVALAB_FIREFOX") {
        let named = PathBuf::from(named);
        ensure!(named.is_file(), "LEVALAB_FIREFOX names {}, which is no file", named.display());
        return Ok(named);
    }
    if let Some(found) = find_firefox() {
        return Ok(found);
    }
    let installed = apt_install(&["firefox-esr"]);
    find_firefox().map_or_else(
        || {
            installed.and_then(|()| bail!("firefox-esr was installed but is not found")).context(
                "no Firefox: install it (Debian: `apt-get install firefox-esr`), or name its program in LEVALAB_FIREFOX",
            )
        },
        Ok,
    )
}

fn find_firefox() -> Option<PathBuf> {
    let mut places = vec![PathBuf::from("/Applications/Firefox.app/Contents/MacOS/firefox")];
    let programs = ["ProgramFiles", "ProgramFiles(x86)"].iter().filter_map(env::var_os);
    places.extend(programs.map(|base| Path::new(&base).join("Mozilla Firefox/firefox.exe")));
    let named = ["firefox", "firefox-esr"].iter().find_map(|name| process::find(name));
    named.or_else(|| places.into_iter().find(|path| path.is_file()))
}

fn usual_places() -> Vec<PathBuf> {
    let mac = ["Google Chrome", "Chromium", "Microsoft Edge"];
    let mut places: Vec<PathBuf> =
        mac.iter().map(|app| format!("/Applications/{app}.app/Contents/MacOS/{app}").into()).collect();
    places.extend(["/opt/google/chrome/chrome", "/snap/bin/chromium"].map(PathBuf::from));
    for variable in ["ProgramFiles", "ProgramFiles(x86)", "LocalAppData"] {
        if let Some(base) = env::var_os(variable) {
            let base = Path::new(&base);
            places.push(base.join("Google/Chrome/Application/chrome.exe"));
            places.push(base.join("Microsoft/Edge/Application/msedge.exe"));
        }
    }
    places
}
