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

#[test]
fn a_link_is_opened_as_mail_readers_and_chat_programs_leave_it() {
    let link = said(&["link", &file_of("9RT")]);
    let link = link.trim();
    let json = said(&["open", link]);
    for mangled in [
        format!("<https://example.org/cams/?{link}>"),
        format!("https://example.org/cams/#{}", link.replace('.', "%2E")),
        format!("https://example.org/cams/%23{link}"),
        format!("see {}", format_args!("https://example.org/#{}&fbclid=1 there", link.replace('_', "\\_"))),
        format!("https://example.org/#{}\r\n{}", &link[..30], &link[30..]),
    ] {
        assert_eq!(text(&with_input(&["open", "-"], mangled.as_bytes()).stdout), json, "{mangled}");
    }
    let nothing = with_input(&["open", "-"], b"https://example.org/cams/?lang=es");
    check_refusal(&nothing, 65, "levalab: link: The link is empty.");
}

#[test]
fn a_long_table_is_shared_by_a_link_of_version_2() {
    let design = testing::long_design(&mut Random::new(3));
    let link = with_input(&["link", "-"], design.to_json().as_bytes());
    assert!(text(&link.stdout).starts_with("2."));
    assert_eq!(Design::from_bytes(&with_input(&["open", "-"], &link.stdout).stdout), Ok(design));
}

#[test]
fn a_file_of_a_newer_version_is_said_to_be_newer() {
    let newer = said(&["open", said(&["link", &file_of("9RT")]).trim()]).replace("levalab/1", "levalab/3");
    let refused = with_input(&["check", "-"], newer.as_bytes());
    check_refusal(&refused, 65, "levalab: -: format: The file is \"levalab/3\", made by a newer version of LevaLab.");
}
