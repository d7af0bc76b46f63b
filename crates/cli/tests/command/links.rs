//! The share link: out of a design and back, by argument and by pipe.

use crate::run::{check_refusal, file_of, said, text, with_input};
use levalab_format::testing::{self, Random};
use levalab_format::{Design, EXAMPLES};

#[test]
fn link_and_open_give_the_file_back() {
    for (name, json) in EXAMPLES {
        let link = said(&["link", &file_of(name)]);
        assert_eq!(text(&with_input(&["open", "-"], link.as_bytes()).stdout), *json);
        for pasted in [link.trim().to_owned(), format!("#{}", link.trim()), format!("https://example.org/#{link}")] {
            assert_eq!(said(&["open", &pasted]), *json);
        }
    }
}

#[test]
fn any_design_survives_the_pipeline() {
    let mut random = Random::new(7);
    for _ in 0..10 {
        let design = testing::design(&mut random);
        let link = with_input(&["link", "-"], design.to_json().as_bytes());
        if !link.status.success() {
            check_refusal(&link, 65, "levalab: -: The link would have");
            continue;
        }
        let opened = with_input(&["open", "-"], &link.stdout);
        assert_eq!(Design::from_bytes(&opened.stdout), Ok(design));
    }
}
