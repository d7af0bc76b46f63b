//! The page on this machine: builds it, serves exactly its own files, and rebuilds when Rust changes.

use std::{
    env, fs,
    io::{self, BufRead, BufReader, Read, Write},
    net::{SocketAddr, TcpListener, TcpStream},
    path::{Component, Path, PathBuf},
    sync::{Condvar, Mutex, PoisonError},
    thread,
    time::{Duration, SystemTime},
};

use anyhow::{Context, Result};
use walkdir::WalkDir;

use crate::{
    process, project, theory,
    wasm::{self, Build},
};

/// Where and how to serve.
#[derive(clap::Args)]
pub struct Options {
    /// Port on 127.0.0.1; 0 takes any free one. Without it 8080, or any free one when that is taken.
    #[arg(long)]
    port: Option<u16>,
    /// Do not open the page in the browser.
    #[arg(long)]
    no_open: bool,
    /// Serve the module as it is shipped, which takes longer to build.
    #[arg(long)]
    release: bool,
}

/// The longest head of a request that is read.
const LONGEST_HEAD: u64 = 16 * 1024;

/// How long a browser may keep a connection open before it asks for something.
const PATIENCE: Duration = Duration::from_secs(20);

/// How often the Rust sources are looked at.
const WATCH: Duration = Duration::from_secs(1);

/// Serves until stopped.
pub fn run(options: &Options) -> Result<()> {
    let build = if options.release { Build::Shipped } else { Build::Quick };
    wasm::build_only(&[wasm::PAGE], build)?;
    let listener = listen(options.port)?;
    announce(listener.local_addr().context("no address")?, options.no_open);
    thread::spawn(move || {
        // A thread for each connection, and each connection for one answer: no request ever waits for another.
        for connection in listener.incoming().flatten() {
            thread::spawn(move || drop(answer(connection)));
        }
    });
    let seen = newest();
    report(build_all(build));
    ON_DEMAND.arrived();
    watch(build, seen)
}

/// The modules and pages that the page loads on demand: they are built while the page is already open.
static ON_DEMAND: OnDemand = OnDemand { built: Mutex::new(false), changed: Condvar::new() };

/// Whether the files of the parts on demand have been built once.
struct OnDemand {
    built: Mutex<bool>,
    changed: Condvar,
}

impl OnDemand {
    /// The folders that hold them.
    const FOLDERS: [&str; 2] = ["/web/pkg/", "/web/theory/"];

    fn arrived(&self) {
        *self.built.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.changed.notify_all();
    }

    /// Returns when the build is over, at once for an address outside of [`Self::FOLDERS`].
    fn wait_for(&self, url: &str) {
        if Self::FOLDERS.iter().any(|folder| url.starts_with(folder)) {
            let built = self.built.lock().unwrap_or_else(PoisonError::into_inner);
            drop(self.changed.wait_while(built, |built| !*built));
        }
    }
}

fn build_all(build: Build) -> Result<()> {
    wasm::build(build)?;
    theory::build()
}

fn report(built: Result<()>) {
    match built {
        Ok(()) => println!("ready: every part of the page is built (reload to see a change)"),
        Err(error) => eprintln!("{error:#}"),
    }
}

fn listen(port: Option<u16>) -> Result<TcpListener> {
    let on = |port| TcpListener::bind(SocketAddr::from(([127, 0, 0, 1], port))).with_context(|| format!("port {port}"));
    match port {
        Some(port) => on(port),
        None => on(8080).or_else(|_| on(0)),
    }
}

fn announce(address: SocketAddr, quiet: bool) {
    let url = format!("http://{address}/");
    println!("LevaLab is at {url} (Ctrl+C ends)");
    let display = cfg!(any(windows, target_os = "macos"))
        || ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| env::var_os(name).is_some());
    if quiet || !display {
        return;
    }
    let (program, first): (_, &[&str]) = if cfg!(windows) {
        ("cmd", &["/c", "start", ""])
    } else if cfg!(target_os = "macos") {
        ("open", &[])
    } else {
        ("xdg-open", &[])
    };
    let mut open = process::program(program, first);
    // No browser to open is no reason to stop: the address is printed above.
    drop(open.arg(url).spawn());
}

/// Reads one request and answers it.
fn answer(mut connection: TcpStream) -> io::Result<()> {
    connection.set_read_timeout(Some(PATIENCE))?;
    let mut head = BufReader::new(connection.try_clone()?.take(LONGEST_HEAD)).lines();
    let request = head.next().unwrap_or_else(|| Ok(String::new()))?;
    // The rest of the head says nothing that matters here, but it has to be read before the answer.
    for line in head {
        if line?.is_empty() {
            break;
        }
    }
    let asked = request.strip_prefix("GET ").and_then(|rest| rest.split(' ').next());
    let found = asked.and_then(|url| {
        found(url).or_else(|| {
            // A part that is asked for before it is built arrives when it is.
            ON_DEMAND.wait_for(url);
            found(url)
        })
    });
    let (status, media, bytes) = match found {
        Some((bytes, media)) => ("200 OK", media, bytes),
        None => ("404 Not Found", "text/plain; charset=utf-8", b"Not found\n".to_vec()),
    };
    let length = bytes.len();
    write!(
        connection,
        "HTTP/1.1 {status}\r\nContent-Type: {media}\r\nContent-Length: {length}\r\nCache-Control: no-cache\r\nConnection: close\r\n\r\n"
    )?;
    connection.write_all(&bytes)
}

/// The bytes behind a request, and their media type.
fn found(url: &str) -> Option<(Vec<u8>, &'static str)> {
    let file = file_of(url, project::root())?;
    Some((fs::read(&file).ok()?, media_type(&file)))
}

/// The file behind a request: `index.html` or something under `web/`, nothing hidden, nothing outside.
fn file_of(url: &str, root: &Path) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next()?.strip_prefix('/')?;
    // Names of the page's files need no escapes, so an escape is a stranger's.
    if path.contains(['%', '\\', ':', '\0']) {
        return None;
    }
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let plain = |part: Component| matches!(part, Component::Normal(name) if !name.to_string_lossy().starts_with('.'));
    if !path.components().all(plain) || !(path == Path::new("index.html") || path.starts_with("web")) {
        return None;
    }
    // A symbolic link must not lead outside either.
    let file = root.join(path).canonicalize().ok()?;
    (file.starts_with(root.canonicalize().ok()?) && file.is_file()).then_some(file)
}

fn media_type(file: &Path) -> &'static str {
    match file.extension().and_then(|extension| extension.to_str()) {
        Some("css") => "text/css; charset=utf-8",
        Some("html") => "text/html; charset=utf-8",
        Some("ico") => "image/x-icon",
        Some("js" | "mjs") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("png") => "image/png",
        Some("svg") => "image/svg+xml",
        Some("wasm") => "application/wasm",
        Some("webmanifest") => "application/manifest+json",
        Some("woff2") => "font/woff2",
        _ => "text/plain; charset=utf-8",
    }
}

/// Rebuilds after each change of a Rust file; a file that does not compile waits for the next change.
fn watch(build: Build, mut seen: Option<SystemTime>) -> ! {
    loop {
        thread::sleep(WATCH);
        let now = newest();
        if now == seen {
            continue;
        }
        seen = now;
        report(build_all(build));
    }
}

/// When a source of the page's module changed last.
fn newest() -> Option<SystemTime> {
    let sources = WalkDir::new(project::path("crates")).into_iter().flatten();
    let rust = sources
        .filter(|entry| entry.path().extension().is_some_and(|extension| extension == "rs" || extension == "toml"));
    rust.filter_map(|entry| entry.metadata().ok()?.modified().ok()).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn served(url: &str) -> Option<String> {
        let root = project::root().canonicalize().expect("the checkout exists");
        let file = file_of(url, &root)?;
        Some(file.strip_prefix(&root).expect("inside").to_string_lossy().into_owned())
    }

    #[test]
    fn the_page_is_served_at_the_root() {
        assert_eq!(served("/").as_deref(), Some("index.html"));
        assert_eq!(served("/?x=1").as_deref(), Some("index.html"));
    }

    #[test]
    fn nothing_but_the_page_is_served() {
        for url in [
            "/Cargo.toml",
            "/.git/config",
            "/web",
            "/web/",
            "/web/../Cargo.toml",
            "/web/%2e%2e/Cargo.toml",
            "/web/..%2fCargo.toml",
            "/web\\..\\Cargo.toml",
            "//etc/passwd",
            "/web//etc/passwd",
            "/web/pkg/.levalab-wasm.stamp",
            "/crates/xtask/src/main.rs",
            "web/main.js",
            "",
        ] {
            assert_eq!(served(url), None, "{url}");
        }
    }
}
