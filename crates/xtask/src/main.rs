//! `cargo xtask serve | test | dist | bench | soak`: everything that builds, runs and checks LevaLab.

fn main() -> anyhow::Result<()> {
    Ok(())
}
