//! Prints as JSON what forms are built from: laws, followers, kinds of cam, units and limits. The page keeps it as a script.

fn main() -> serde_json::Result<()> {
    println!("{}", serde_json::to_string(&levalab_format::Catalogue::default())?);
    Ok(())
}
