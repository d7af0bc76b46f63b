//! What each kind of edit leaves of a design.

use super::*;
use crate::testing::{self, Random};
use crate::{EXAMPLES, SegmentDesign, example};
use levalab_core::law::Data;
use levalab_core::{FOLLOWERS, LAWS};
use serde_json::json;

fn nine() -> Design {
    let rises = [10, 0, -10, 0, 10, 0, -10, 0];
    let segment = |rise: i32| match rise {
        0 => json!({ "law": "dwell", "beta": 40 }),
        _ => json!({ "law": "cycloidal", "beta": 50, "rise": rise }),
    };
    with_segments(&rises.map(segment))
}

fn with_segments(segments: &[Value]) -> Design {
    let mut file = example("9RT").expect("9RT").to_value();
    file["segments"] = segments.into();
    Design::draft(&file).expect("a design file")
}

fn made(design: &Design, edit: Edit) -> Design {
    let told = format!("{edit:?}");
    apply(design, &[edit]).unwrap_or_else(|error| panic!("{told}: {error}"))
}

fn refusal(design: &Design, edit: Edit) -> DesignError {
    apply(design, &[edit]).expect_err("refused")
}

fn is_closed(design: &Design) -> bool {
    let outline = design.outline();
    (outline.left, outline.open) == (0.0, 0.0)
}

fn told(segment: &SegmentDesign) -> (&'static str, f64, f64) {
    (segment.law.id, segment.beta, segment.rise)
}

fn law(id: &str) -> &'static Law {
    Law::by_id(id).expect(id)
}

#[test]
fn what_is_left_of_the_turn_is_told_without_the_noise_of_sums() {
    assert_eq!(nine().outline().left, 0.0);
    let seventh = json!({ "law": "dwell", "beta": 360.0 / 7.0 });
    assert_eq!(with_segments(&vec![seventh.clone(); 7]).outline().left, 0.0);
    assert_eq!(with_segments(&vec![seventh; 6]).outline().left, 51.4285714286);
}

#[test]
fn each_way_to_complete_the_turn_completes_it() {
    let short = made(&nine(), Edit::Delete { segments: vec![7] });
    for completion in [Completion::Dwell, Completion::Stretch, Completion::Spread] {
        let after = made(&short, Edit::Complete(completion));
        assert!(is_closed(&after) && after.cam().is_ok(), "{completion:?}");
        assert_eq!(refusal(&nine(), Edit::Complete(Completion::Dwell)).problem, EditRefusal::NothingLeft.into());
    }
    let mut open = nine();
    open.segments.truncate(6);
    open.segments.push(SegmentDesign { beta: 30.0, ..open.segments[1].clone() });
    let after = made(&open, Edit::Complete(Completion::Return));
    assert!(is_closed(&after));
    assert_eq!(after.segments.last().map(told), Some(("cycloidal", 60.0, -10.0)));
}

#[test]
fn a_turn_that_is_too_long_is_spread_or_shortened() {
    let long = made(&nine(), Edit::Duplicate { segment: 1 });
    assert_eq!((long.outline().left, long.outline().stretches), (-40.0, false));
    assert_eq!(refusal(&long, Edit::Complete(Completion::Stretch)).problem, EditRefusal::LastTooShort.into());
    assert_eq!(made(&long, Edit::Complete(Completion::Spread)).outline().left, 0.0);
}

#[test]
fn slivers_survive_a_spread() {
    let mut slivers = nine();
    for k in [0, 1, 6, 7] {
        slivers.segments[k].beta = 0.001;
    }
    let after = made(&slivers, Edit::Complete(Completion::Spread));
    assert!(after.cam().is_ok(), "{:?}", after.segments);
}

#[test]
fn the_last_move_closes_the_height() {
    let open = made(&nine(), Edit::set(Path::from("segments").join(4).join("rise"), 7.3));
    assert_eq!(open.outline().open, -2.7);
    let after = made(&open, Edit::Complete(Completion::Close));
    assert_eq!(after.segments[6].rise, -7.3);
    assert!(is_closed(&after));
    let points = json!({ "law": "table", "beta": 50, "points": [[0, 10], [25, 6], [50, 1]] });
    let mut list: Vec<Value> = nine().to_value()["segments"].as_array().expect("a list").clone();
    list[6] = points;
    let after = made(&with_segments(&list), Edit::Complete(Completion::Close));
    assert!(matches!(&after.segments[6].data, Data::Points(points) if points[2] == [50.0, 0.0]));
}

#[test]
fn an_inserted_segment_leaves_a_good_program_good() {
    for at in 0..=8 {
        let after = made(&nine(), Edit::Insert { at, from: at.min(7) });
        assert_eq!(after.segments.len(), 9);
        assert!(after.cam().is_ok(), "at {at}");
    }
    let short = made(&nine(), Edit::Delete { segments: vec![7] });
    assert_eq!(told(&made(&short, Edit::Insert { at: 0, from: 0 }).segments[0]), ("dwell", 40.0, 0.0));
}

#[test]
fn moving_a_segment_keeps_all_the_others_in_order() {
    let design = nine();
    let after = made(&design, Edit::Move { from: 2, to: 5 });
    let kept = [0, 1, 3, 4, 5, 2, 6, 7].map(|k| design.segments[k].clone());
    assert_eq!(after.segments, kept);
}

#[test]
fn several_segments_go_at_once_and_never_all_of_them() {
    let design = nine();
    let after = made(&design, Edit::Delete { segments: vec![6, 1, 1, 2] });
    assert_eq!(after.segments, [0, 3, 4, 5, 7].map(|k| design.segments[k].clone()));
    let all = refusal(&design, Edit::Delete { segments: (0..8).collect() });
    assert_eq!(all.problem, ProgramRefusal::NoSegments.into());
    let none = refusal(&design, Edit::Delete { segments: vec![3, 8] });
    assert_eq!(
        (none.path.to_string().as_str(), none.problem),
        ("segments[8]", EditRefusal::NoItem { found: 8, count: 8 }.into())
    );
}

#[test]
fn a_law_that_moves_gets_a_rise_that_closes_the_program() {
    let mut design = nine();
    design.segments[6] = dwell(50.0);
    let after = made(&design, Edit::Law { segment: 6, law: law("scca") });
    assert_eq!((told(&after.segments[6]), after.segments[6].parameters), (("scca", 50.0, -10.0), [0.25, 0.25, 0.0]));
    let back = made(&after, Edit::Law { segment: 6, law: law("dwell") });
    assert_eq!(back.segments[6], dwell(50.0));
}

#[test]
fn another_law_leaves_any_good_program_closed() {
    let mut random = Random::new(7);
    for _ in 0..400 {
        let design = testing::design(&mut random);
        let Some(segment) = design.segments.len().checked_sub(1).map(|last| random.below(last + 1)) else { continue };
        let other = LAWS[random.below(LAWS.len())];
        if other.is_dwell() || design.segments[segment].law.is_dwell() {
            continue;
        }
        let heights = design.outline().heights;
        if heights[segment] == heights[segment + 1] {
            continue;
        }
        let after = made(&design, Edit::Law { segment, law: other });
        assert!(is_closed(&after), "{}: {} {:?}\n{}", other.id, segment, after.outline(), design.to_json());
        let lift = design.outline().lift;
        for (before, now) in heights.iter().zip(after.outline().heights) {
            assert!((before - now).abs() <= 1e-9 * lift, "{}: {before} {now}", other.id);
        }
    }
}

#[test]
fn parameters_and_data_that_both_laws_have_are_kept() {
    let mut design = made(&nine(), Edit::Law { segment: 0, law: law("scca") });
    design.segments[0].parameters = [0.3, 0.2, 0.0];
    let skewed = made(&design, Edit::Law { segment: 0, law: law("skewed-scca") });
    assert!(skewed.segments[0].parameters.contains(&0.3) && skewed.cam().is_ok());
    let free = made(&nine(), Edit::Law { segment: 0, law: law("polynomial") });
    let spline = made(&free, Edit::Law { segment: 0, law: law("bspline") });
    assert_eq!(free.segments[0].data, spline.segments[0].data);
}

#[test]
fn data_within_a_segment_keep_their_places_when_it_is_stretched() {
    let free = made(&nine(), Edit::Law { segment: 0, law: law("polynomial") });
    let after = made(&free, Edit::Beta { segment: 0, value: 100.0 });
    let ends = |design: &Design| -> Vec<f64> {
        design.segments[0].data.conditions().expect("conditions").iter().map(|condition| condition.at).collect()
    };
    assert_eq!(ends(&after), ends(&free).iter().map(|at| 2.0 * at).collect::<Vec<_>>());
}

#[test]
fn conditions_come_go_and_stay_in_order() {
    let free = made(&nine(), Edit::Law { segment: 0, law: law("polynomial") });
    let count = |design: &Design| design.segments[0].data.conditions().expect("conditions").len();
    let more = made(&free, Edit::AddCondition { segment: 0 });
    let added = *more.segments[0].data.conditions().expect("conditions").iter().find(|c| c.at == 25.0).expect("added");
    assert_eq!((count(&more), added.value), (count(&free) + 1, 5.0), "at the height of the curve");
    assert!(more.cam().is_ok());
    let moved = made(&more, Edit::MoveConditions { segment: 0, from: 25.0, to: 20.0 });
    let set = made(&moved, Edit::Condition { segment: 0, at: 20.0, order: 0, value: 4.0 });
    assert_eq!(count(&set), count(&more));
    assert_eq!(made(&set, Edit::DropConditions { segment: 0, at: 20.0, order: None }), free);
    assert_eq!(refusal(&free, Edit::AddCondition { segment: 2 }).problem, EditRefusal::NoConditions.into());
}

#[test]
fn a_formula_that_begins_to_name_l_gets_the_rise_of_its_segment() {
    let formula = made(&nine(), Edit::Law { segment: 0, law: law("formula") });
    assert!(formula.cam().is_ok());
    let plain = made(&formula, Edit::Formula { segment: 0, text: "10x^3(10 − 15x + 6x²)".to_owned() });
    assert_eq!((plain.segments[0].rise, is_closed(&plain)), (0.0, true), "{:?}", plain.outline());
    let again = made(&plain, Edit::Formula { segment: 0, text: "L x".to_owned() });
    assert_eq!(again.segments[0].rise, 10.0);
    let by_path = |text: &str| made(&plain, Edit::set(Path::from("segments").join(0).join("expression"), text));
    assert_eq!(by_path("L x"), again);
}

#[test]
fn a_value_goes_where_its_path_says() {
    let design = nine();
    let place = |key: &str| Path::from("segments").join(2).join(key);
    let edits = [Edit::set(["cam", "base_radius"], 43.3), Edit::set(place("law"), "polynomial-4-5-6-7")];
    let after = apply(&design, &edits).expect("possible");
    assert_eq!((after.base_radius, after.segments[2].law.id), (43.3, "polynomial-4-5-6-7"));
    assert_eq!(made(&design, Edit::set("notation", "norton")).notation.word(), "norton");
    for (edit, path) in [
        (Edit::set(["cam", "size"], 1), "cam.size"),
        (Edit::set(["cam", "base_radius"], "wide"), "cam.base_radius"),
        (Edit::set(["cam", "base_radius", "more"], 1), "cam.base_radius"),
        (Edit::set(Path::from("segments").join(9).join("beta"), 1), "segments[9]"),
        (Edit::set(Path::from("segments").join(1).join("rise"), 5), "segments[1].rise"),
        (Edit::set(Path::from("segments").join(0).join("law"), "dwell"), "segments[0].rise"),
        (Edit::Clear { path: ["cam", "base_radius"].into() }, "cam.base_radius"),
        (Edit::Clear { path: "conjugate".into() }, "conjugate"),
    ] {
        assert_eq!(refusal(&design, edit.clone()).path.to_string(), path, "{edit:?}");
    }
}

#[test]
fn an_edit_that_is_refused_changes_nothing_and_says_what_the_design_lacks() {
    let design = nine();
    let edits = [Edit::set(["cam", "base_radius"], 50), Edit::set("segments", Vec::<Value>::new())];
    assert!(apply(&design, &edits).is_ok(), "a design that is being worked on need not be a cam");
    let error = design.edited(&edits).expect_err("no cam");
    assert_eq!((error.path.to_string().as_str(), error.problem), ("segments", ProgramRefusal::NoSegments.into()));
    let error = design.edited(&[Edit::set(["cam", "base_radius"], -5)]).expect_err("no cam");
    assert_eq!(error.path.to_string(), "cam.base_radius");
}

#[test]
fn another_follower_keeps_what_it_can_and_swings_about_as_far_as_it_rose() {
    let follower = |id: &str| Edit::Follower { kind: FollowerKind::by_id(id).expect(id) };
    let swings = made(&nine(), follower("oscillating-roller"));
    assert_eq!(
        swings.to_value()["follower"],
        json!({
            "motion": "oscillating", "contact": "roller", "roller_radius": 7, "arm": 65, "pivot_distance": 65, "pivot_angle": 0,
        })
    );
    assert_eq!((swings.segments[0].rise, is_closed(&swings)), (8.8, true));
    let slides = made(&swings, follower("translating-curved"));
    assert_eq!(
        slides.to_value()["follower"],
        json!({
            "motion": "translating", "contact": "curved", "face_radius": 7, "eccentricity": 0,
        })
    );
    assert_eq!((slides.segments[0].rise, is_closed(&slides)), (10.0, true));
}

#[test]
fn a_formula_stays_the_same_motion_when_the_follower_swings() {
    let formula = made(&nine(), Edit::Law { segment: 0, law: law("formula") });
    let constant = made(&formula, Edit::Formula { segment: 0, text: "10x^3(10 − 15x + 6x²)".to_owned() });
    let swings =
        made(&constant, Edit::Follower { kind: FollowerKind::by_id("oscillating-roller").expect("a follower") });
    assert!(is_closed(&swings), "{:?}", swings.outline());
    let [before, after] = [&constant, &swings].map(|design| design.cam().expect("a cam").program);
    let lever = 65.0;
    for k in 0..60 {
        let theta = f64::from(k) / 10.0;
        assert!((before.at(theta).s - lever * after.at(theta).s).abs() < 1e-9, "θ = {theta}");
    }
}

#[test]
fn any_follower_and_any_kind_leave_a_good_program_closed() {
    let mut random = Random::new(8);
    let (mut cams, mut all) = (0, 0);
    for _ in 0..400 {
        let design = testing::design(&mut random);
        let edit = if random.once_in(2) {
            Edit::Follower { kind: FOLLOWERS[random.below(FOLLOWERS.len())] }
        } else {
            Edit::Kind { kind: crate::CamKind::WORDS[random.below(4)], back: None }
        };
        let Ok(after) = apply(&design, std::slice::from_ref(&edit)) else {
            // An image of more than half of the segments that there may be, or a follower that the kind of cam does not have.
            let misses =
                matches!(&edit, Edit::Follower { kind } if crate::unsuited(design.kind.word(), kind).is_some());
            let long = 2 * design.segments.len() > crate::limits::MAX_SEGMENTS;
            assert!(misses || long, "{edit:?} of\n{}", design.to_json());
            continue;
        };
        assert!(is_closed(&after), "{edit:?} {:?} of\n{}\nto\n{}", after.outline(), design.to_json(), after.to_json());
        cams += usize::from(after.cam().is_ok());
        all += 1;
    }
    assert!(cams * 10 > all * 7, "{cams} of {all} are cams at once");
}

#[test]
fn a_cam_that_travels_is_bent_round_and_runs_back() {
    let file = json!({
        "format": "levalab/1", "cam": { "kind": "translating", "length": 100 }, "speed": { "value": 50, "unit": "mm/s" },
        "follower": { "motion": "translating", "contact": "roller", "roller_radius": 5 },
        "segments": [
            { "law": "half-cycloidal-start", "beta": 40, "rise": 8 },
            { "law": "table", "beta": 60, "points": [[0, 8], [30, 20], [60, 15]] },
        ],
    });
    let wedge = Design::from_value(&file).expect("a wedge");
    let round = made(&wedge, Edit::Kind { kind: "rotating", back: None });
    let cam = round.cam().expect("a cam");
    assert_eq!(round.segments.len(), 4);
    assert_eq!(round.segments[3].law.id, "half-cycloidal-end");
    let there = cam.program.at(1.0).s;
    let back = cam.program.at(std::f64::consts::TAU - 1.0).s;
    assert!((there - back).abs() < 1e-3 * there, "{there} {back}");
}

#[test]
fn a_kind_that_is_tried_and_left_gives_the_design_back() {
    let mut random = Random::new(10);
    for _ in 0..300 {
        let before = testing::design(&mut random);
        let kind = crate::CamKind::WORDS[random.below(4)];
        let Ok(after) = apply(&before, &[Edit::Kind { kind, back: None }]) else { continue };
        let left = || Some(Box::new(Left { before: before.clone(), after: after.clone() }));
        let home = before.kind.word();
        assert_eq!(
            made(&after, Edit::Kind { kind: home, back: left() }).to_json(),
            before.to_json(),
            "by way of {kind}"
        );
        let renamed = made(&after, Edit::set("title", "changed since"));
        let back = made(&renamed, Edit::Kind { kind: home, back: left() });
        assert_eq!((back.title.as_str(), &back.segments), ("changed since", &before.segments));
    }
}

#[test]
fn half_a_turn_and_its_image_make_the_same_whole_turn() {
    let yoke = made(&nine(), Edit::Kind { kind: "constant-breadth", back: None });
    let half = made(&yoke, Edit::Generator { generator: "mirror", sides: None });
    let before = half.cam().expect("a yoke").program;
    let whole = made(&half, Edit::Kind { kind: "rotating", back: None });
    let after = whole.cam().expect("a cam").program;
    for k in 0..36 {
        let theta = f64::from(k) / 6.0;
        assert!((before.at(theta).s - after.at(theta).s).abs() < 1e-9, "θ = {theta}");
    }
    for generator in ["harmonic", "circular-arc", "mirror"] {
        let made = made(&yoke, Edit::Generator { generator, sides: Some(5) });
        assert!(made.cam().is_ok(), "{generator}");
    }
}

#[test]
fn a_second_cam_is_found_and_told_another_way() {
    let pair = made(&example("7CRT").expect("7CRT"), Edit::Clear { path: "conjugate".into() });
    let found = made(&pair, Edit::Pair { tie: "distance", value: None });
    assert!(found.cam().is_ok() && found.conjugate.is_some());
    let swings = example("2RO").expect("2RO");
    let Ok(by_angle) = apply(&swings, &[Edit::Pair { tie: "angle", value: None }]) else { return };
    let by_radius = made(&by_angle, Edit::Pair { tie: "base_radius", value: None });
    let second = |design: &Design| {
        let first = design.cam().expect("a cam");
        design.second(&first).expect("a pair").expect("a second").follower.base_radius()
    };
    assert!((second(&by_angle) - second(&by_radius)).abs() < 1e-9);
}

#[test]
fn heights_that_are_scaled_stay_closed() {
    let mut random = Random::new(9);
    for _ in 0..200 {
        let design = testing::design(&mut random);
        let factor = random.between(0.1, 9.0);
        let Ok(after) = apply(&design, &[Edit::Scale { factor }]) else {
            assert!(design.kind.generator().is_some(), "{}", design.to_json());
            continue;
        };
        let lift = design.outline().lift * factor;
        assert!((after.outline().lift - lift).abs() <= 1e-9 * lift, "{factor}: {}", design.to_json());
        assert!(design.breadth_travel().is_some() || is_closed(&after), "{factor}: {}", design.to_json());
    }
}

#[test]
fn a_unit_that_is_converted_and_back_gives_every_example_back() {
    for (name, _) in EXAMPLES {
        let design = example(name).expect(name);
        let inches = made(&design, Edit::Convert { unit: Unit::Length(LengthUnit::Inch) });
        assert_eq!(made(&inches, Edit::Convert { unit: Unit::Length(design.length_unit) }), design, "{name}");
    }
}

#[test]
fn a_new_design_is_a_cam_in_the_units_of_the_one_before() {
    for unit in LengthUnit::ALL {
        let design = made(&example("9RT").expect("9RT").relabelled(unit), Edit::New);
        assert!(design.cam().is_ok());
        assert_eq!((design.title.as_str(), design.length_unit, design.segments.len()), ("", unit, 1));
    }
    let metric = made(&nine(), Edit::New);
    assert_eq!((metric.base_radius, metric.values[0]), (40.0, 10.0));
}

#[test]
fn targets_by_time_are_the_same_points() {
    let pump = made(&nine(), Edit::Application { kind: levalab_core::application::APPLICATIONS.first().copied() });
    let aimed = made(&pump, Edit::set(["application", "targets"], json!([[90, 3], [180, 0]])));
    let timed = made(&aimed, Edit::TargetsBy { by: TargetsBy::Time });
    assert_eq!(timed.application.as_ref().map(|application| application.by), Some(TargetsBy::Time));
    let targets = |design: &Design| design.application.as_ref().expect("an application").targets.clone();
    for (before, after) in targets(&aimed).iter().zip(targets(&made(&timed, Edit::TargetsBy { by: TargetsBy::Theta })))
    {
        assert!((before[0] - after[0]).abs() < 1e-8 && before[1] == after[1], "{before:?} {after:?}");
    }
}
