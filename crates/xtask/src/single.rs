//! The page as one HTML file that opens from disk: scripts, styles, module and the pages of theory inside, under a policy of hashes.

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, ensure};
use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use sha2::{Digest, Sha256};

use crate::{
    html::{self, Kind, Load},
    poster::Poster,
    theory, wasm,
};

/// Its name in `dist/`.
pub const FILE: &str = "levalab.html";

/// What the page is made of.
pub struct Parts<'a> {
    /// `index.html` of the checkout.
    pub html: &'a str,
    /// What it loads.
    pub loads: &'a [Load],
    /// The first picture.
    pub poster: &'a Poster,
    /// Where the modules lie, each joined with all it imports.
    pub scripts: &'a Path,
    /// The packed folder, for everything else.
    pub packed: &'a Path,
    /// The folder of the pages of theory.
    pub theory: &'a Path,
}

impl Parts<'_> {
    /// The whole file.
    pub fn page(&self) -> Result<String> {
        let style = read(&self.packed.join("style.css"))?
            + &read(&self.packed.join("styles/help.css"))?
            + &read(&self.packed.join("styles/exports.css"))?;
        let reading = read(&self.packed.join("styles/theory.css"))?;
        let mut scripts = Vec::new();
        let mut bodies = String::new();
        let mut styled = false;
        for load in self.loads {
            match load.kind {
                Kind::Script => scripts.push(read(&self.packed.join(name(load)))?),
                Kind::Module => {
                    let script = read(&self.scripts.join(name(load)))?;
                    bodies += &format!("<script type=\"module\">{script}</script>\n  ");
                    scripts.push(script);
                }
                _ => {}
            }
        }
        let icon = fs::read(self.packed.join("icon.svg")).context("icon.svg")?;
        let icon = format!("<link rel=\"icon\" href=\"data:image/svg+xml;base64,{}\">", BASE64.encode(icon));
        let page = html::rewrite(self.html, self.loads, |load| match load.kind {
            Kind::Style(_) if !styled => {
                styled = true;
                // The second is for the pages of theory, which `web/single.js` puts in the place of the cam.
                format!("<style>{style}</style>\n    <style id=\"pages-style\" media=\"not all\">{reading}</style>")
            }
            Kind::Script => format!("<script{}>{}</script>", self.poster.known(), scripts[0]),
            Kind::Other if load.tag.contains("rel=\"icon\"") => icon.clone(),
            _ => String::new(),
        });
        let modules = modules()?;
        let pages = theory::packed(self.theory)?;
        let page = page.replacen("</body>", &format!("{pages}{modules}{bodies}</body>"), 1);
        let page = html::packed_as(&self.poster.fill(&page)?, "file");
        with_policy(&page, &scripts, &[style, reading])
    }
}

/// The modules that the page carries, each as text in a script of its own that does not run.
fn modules() -> Result<String> {
    let mut scripts = String::new();
    for module in wasm::MODULES.iter().filter(|module| module.inline) {
        let bytes = fs::read(wasm::package().join(module.file())).with_context(|| module.file())?;
        let (name, text) = (module.stem(), BASE64.encode(bytes));
        scripts += &format!("<script type=\"application/wasm;base64\" id=\"{name}\">{text}</script>\n  ");
    }
    Ok(scripts)
}

/// Its own scripts and styles by their hashes, and nothing from anywhere.
fn with_policy(page: &str, scripts: &[String], styles: &[String]) -> Result<String> {
    let hash = |text: &String| format!("'sha256-{}'", BASE64.encode(Sha256::digest(text)));
    let hashes = |texts: &[String]| texts.iter().map(hash).collect::<Vec<_>>().join(" ");
    let policy = format!(
        "default-src 'none'; script-src {} 'wasm-unsafe-eval'; style-src {}; img-src data: blob:; worker-src 'self'; base-uri 'none'; \
         form-action 'none'; require-trusted-types-for 'script'; trusted-types levalab-own levalab-worker",
        hashes(scripts),
        hashes(styles)
    );
    let start = page.find("content=\"default-src").context("index.html has no policy")? + "content=\"".len();
    let end = start + page[start..].find('"').context("the policy has no end")?;
    Ok(format!("{}{policy}{}", &page[..start], &page[end..]))
}

fn read(file: &Path) -> Result<String> {
    let text = fs::read_to_string(file).with_context(|| file.display().to_string())?;
    // A browser hashes what it reads, and it reads each kind of line end as "\n".
    let text = text.replace("\r\n", "\n");
    ensure!(!text.contains("</script") && !text.contains("</style"), "{}: its text would end its tag", file.display());
    Ok(text)
}

fn name(load: &Load) -> PathBuf {
    Path::new(&load.file).file_name().unwrap_or_default().into()
}
