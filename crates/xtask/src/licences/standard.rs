//! What is built in and has no place in `Cargo.lock`: the standard library of Rust, its notices after `COPYRIGHT-library.html`
//! and `compiler-builtins/LICENSE.txt` of Rust 1.95, without versions, since another compiler brings others.

use std::fs;

use anyhow::Result;
use regex::Regex;

use super::notice::Notice;
use crate::setup;

/// A part of the standard library: name, licence, and whose work it is.
struct Part(&'static str, &'static str, &'static [&'static str]);

const RUST: &str = "Copyright (c) The Rust Project Developers (see https://thanks.rust-lang.org)";
const ALEX_CRICHTON: &str = "Copyright (c) 2014 Alex Crichton";
const MICROSOFT: &str = "Copyright (c) Microsoft Corporation.";

const PARTS: [Part; 20] = [
    Part("alloc, core, std", "MIT", &[RUST]),
    Part("core: tables of Unicode", "Unicode-3.0", &["Copyright (c) 1991-2024 Unicode, Inc."]),
    Part("std: channels", "MIT", &["Copyright (c) 2019 The Crossbeam Project Developers", RUST]),
    Part("backtrace", "MIT", &[ALEX_CRICHTON, RUST]),
    // Beyond the MIT License it is under that of Apache with the exception of LLVM, which asks for no notice in a compiled program.
    Part(
        "compiler_builtins",
        "MIT",
        &[
            RUST,
            "Copyright (c) 2009-2016 by the contributors listed in CREDITS.TXT of LLVM's compiler-rt",
            "Copyright (c) 2018 Jorge Aparicio (libm)",
            "Copyright © 2005-2020 Rich Felker, et al. (musl libc)",
            "Copyright © 1993,2004 Sun Microsystems",
            "Copyright © 2003-2011 David Schultz",
            "Copyright © 2003-2009 Steven G. Kargl",
            "Copyright © 2003-2009 Bruce D. Evans",
            "Copyright © 2008 Stephen L. Moshier",
            "Copyright © 2017-2018 Arm Limited",
        ],
    ),
    Part("addr2line", "MIT", &["Copyright (c) 2016-2018 The gimli Developers"]),
    Part("adler2", "MIT", &["Copyright (C) Jonas Schievink <jonasschievink@gmail.com>"]),
    Part("cfg-if", "MIT", &[ALEX_CRICHTON]),
    Part("dlmalloc", "MIT", &[ALEX_CRICHTON]),
    Part("foldhash", "Zlib", &["Copyright (c) 2024 Orson Peters"]),
    Part("gimli", "MIT", &["Copyright (c) 2015 The Rust Project Developers"]),
    Part("hashbrown", "MIT", &["Copyright (c) 2016 Amanieu d'Antras"]),
    Part("libc", "MIT", &["Copyright (c) 2014-2020 The Rust Project Developers"]),
    Part("memchr", "MIT", &["Copyright (c) 2015 Andrew Gallant"]),
    Part(
        "miniz_oxide",
        "MIT",
        &[
            "Copyright 2013-2014 RAD Game Tools and Valve Software",
            "Copyright 2010-2014 Rich Geldreich and Tenacious Software LLC",
            "Copyright (c) 2017 Frommi",
            "Copyright (c) 2017-2024 oyvindln",
        ],
    ),
    Part("object", "MIT", &["Copyright (c) 2015 The Gimli Developers"]),
    Part("rustc-demangle", "MIT", &[ALEX_CRICHTON]),
    Part("windows-link", "MIT", &[MICROSOFT]),
    Part("windows-sys", "MIT", &[MICROSOFT]),
    Part("windows-targets", "MIT", &[MICROSOFT]),
];

/// Packages of the standard library that are no part of a program for the page, Linux, macOS or Windows: other systems, tests, its own build.
const ELSEWHERE: [&str; 16] = [
    "cc",
    "fortanix-sgx-abi",
    "getopts",
    "hermit-abi",
    "moto-rt",
    "r-efi",
    "r-efi-alloc",
    "rand",
    "rand_core",
    "rand_xorshift",
    "rustc-literal-escaper",
    "shlex",
    "unwinding",
    "vex-sdk",
    "wasi",
    "wit-bindgen",
];

/// The one development tool that leaves code of its own behind: a few lines that join modules. What wasm-bindgen writes is under the
/// notice of its package.
const ESBUILD: Part = Part("esbuild", "MIT", &["Copyright (c) 2020 Evan Wallace"]);

/// The notices of the standard library and of the tool, whose texts others have as well.
pub fn notices() -> impl Iterator<Item = Notice> {
    let library = PARTS.iter().map(|part| notice(part, "standard library of Rust"));
    library.chain([notice(&ESBUILD, "helpers in the page's scripts")])
}

fn notice(Part(name, licence, holders): &Part, place: &str) -> Notice {
    let holders = holders.iter().map(|&holder| holder.to_owned()).collect();
    Notice { package: format!("{name} ({place})"), licence, holders, text: None }
}

/// Packages that the compiler at hand lists for its standard library and that nothing here is known of. A compiler that comes without
/// that list has nothing to compare.
pub fn unknown_in_toolchain() -> Result<Vec<String>> {
    let list = setup::sysroot()?.join("share/doc/rust/COPYRIGHT-library.html");
    let Ok(list) = fs::read_to_string(list) else { return Ok(Vec::new()) };
    let heading = Regex::new(r"<h3>\W*([A-Za-z][\w-]*?)-\d[^<]*</h3>")?;
    let known = |name: &str| {
        let windows = name.starts_with("windows_");
        windows || ELSEWHERE.contains(&name) || PARTS.iter().any(|Part(part, ..)| *part == name)
    };
    let names = heading.captures_iter(&list).map(|found| found[1].to_owned());
    Ok(names
        .filter(|name| !known(name))
        .map(|name| format!("the standard library has a new package, {name}"))
        .collect())
}
