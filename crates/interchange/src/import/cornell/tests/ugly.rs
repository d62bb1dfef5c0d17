//! Files that are no scene: each is told with its place, and none takes long.

use std::fmt::Write as _;

use super::super::surface::MOST_GROUPS;
use super::{BALL, read, refuses, with};

#[test]
fn what_is_no_xml_is_told_with_its_place() {
    refuses("", &["1:1: expected the element scene, found no element"]);
    refuses("scene", &["1:1: expected XML"]);
    refuses("<scene>", &["1:8: expected the file's elements to be closed, found its end"]);
    refuses(&BALL[..BALL.len() - 4], &["6:"]);
    refuses(BALL.replace("</camera>", "</image>"), &["3:39: expected XML"]);
    refuses(BALL.replace("type=\"Sphere\"", "type=Sphere"), &["5:17: expected XML"]);
    refuses(BALL.replace("Sphere\"", "Sphere\" type=\"Box\""), &["5:26: expected XML"]);
    refuses("<Scenes/>", &["1:1: Scenes: expected the element scene"]);
    refuses(b"\xff\xfe<\0s\0", &["1:1: expected UTF-8 text"]);
    refuses(b"<scene>\n<!-- \xe4 --></scene>", &["2:6: expected UTF-8 text, found the byte 0xe4"]);
    refuses(b"<scene>\x01</scene>", &["1:8: expected XML"]);
    assert!(read(format!("\u{feff}{BALL}")).is_ok(), "a byte order mark");
    for end in (0..BALL.len() - "</scene>\n".len()).step_by(7) {
        assert!(read(&BALL[..end]).is_err(), "cut off at {end}");
    }
}

#[test]
fn entities_do_not_grow() {
    let mut bomb = "<!DOCTYPE scene [<!ENTITY a0 \"1 1 1\">".to_owned();
    for i in 1..40 {
        let before = format!("&a{};", i - 1).repeat(10);
        write!(bomb, "<!ENTITY a{i} \"{before}\">").unwrap();
    }
    bomb += "]><scene><image>&a39;</image></scene>";
    refuses(&bomb, &["1:1: expected no document type declaration"]);
    let file = "<!DOCTYPE s [<!ENTITY f SYSTEM \"file:///etc/passwd\">]><scene>&f;</scene>";
    refuses(file, &["expected no document type declaration"]);
    refuses(BALL.replace("4 3", "&nothing;"), &["4:10: expected XML"]);
    assert!(read(BALL.replace("4 3", "&#52; 3")).is_ok(), "a character is no entity");
}

#[test]
fn elements_crowded_with_attributes_are_a_clear_error() {
    let with = |count: usize| {
        let attributes: Vec<_> = (0..count).map(|k| format!(" a{k}='>'")).collect();
        let attributes = attributes.concat();
        BALL.replace("<scene>", &format!("<!-- = < --><scene{attributes}>"))
    };
    refuses(with(65), &["expected an element of at most 64 attributes"]);
    refuses(with(1_000_000), &["expected an element of at most 64 attributes"]);
    assert_eq!(read(with(64)).unwrap().lost.len(), 64);
}

#[test]
fn a_million_elements_in_each_other_are_a_clear_error() {
    const MILLION: usize = 1_000_000;
    let deep = |open: &str, close: &str| {
        let inside = open.repeat(MILLION) + &close.repeat(MILLION);
        BALL.replace("</scene>", &format!("{inside}</scene>"))
    };
    let imported = read(deep("<a>", "</a>")).unwrap();
    assert_eq!(imported.lost.len(), 1, "one unknown element with all that is in it");
    refuses("<scene>".repeat(MILLION), &["expected the file's elements to be closed"]);
    // As short as a group can be, as there are so many.
    let groups = BALL.replace("</scene>", &"<surface type='Group'>".repeat(700_000));
    refuses(groups, &["expected the file's elements to be closed"]);
    let depth = 400_000;
    let inside = "<surface type='group'>".repeat(depth) + &"</surface>".repeat(depth);
    let groups = BALL.replace("</scene>", &format!("{inside}</scene>"));
    refuses(groups, &[&format!("surface: expected at most {MOST_GROUPS} groups in each other")]);
    refuses("<scene>".to_owned() + &"<a/>".repeat(2 * MILLION), &["expected at most 2000000"]);
    refuses(" ".repeat(17 << 20), &["expected XML of at most"]);
}

#[test]
fn as_many_groups_as_are_allowed_make_a_scene() {
    let nested = |depth: usize| {
        "<surface type=\"Group\"><rotate>1 2 3</rotate>".repeat(depth)
            + "<surface type=\"Sphere\"><shader type=\"Normal\"/></surface>"
            + &"</surface>".repeat(depth)
    };
    with(&nested(MOST_GROUPS)).unwrap().text("a.xml").unwrap();
    let problems = with(&nested(MOST_GROUPS + 1)).unwrap_err();
    assert!(problems[0].message.contains("groups in each other"), "{problems:?}");
}

#[test]
fn malformed_numbers_are_told_all_at_once() {
    #[track_caller]
    fn check(more: &str, expected: &[&str]) {
        refuses(BALL.replace("</scene>", &format!("{more}</scene>")), expected);
    }
    let surface = "<surface type=\"Sphere\"><center>1 2</center><radius>big</radius></surface>";
    check(surface, &["center: expected 3 numbers, found \"1 2\"", "radius: expected a number"]);
    check("<exposure>NaN</exposure>", &["6:1: exposure: expected a finite number, found \"NaN\""]);
    check("<exposure>1e999</exposure>", &["expected a finite number, found \"1e999\""]);
    check("<exposure/>", &["exposure: expected a number, found \"\""]);
    check("<exposure>-1</exposure>", &["exposure: `exposure`: expected"]);
    check("<backColor>1 1 1 1</backColor>", &["backColor: expected 3 numbers"]);
    check("<backColor>1,1,1</backColor>", &["found \"1,1,1\""]);
    check("<backColor>1 1 -1</backColor>", &["backColor: `background`"]);
    check("<light><position>1 2 1e400</position></light>", &["position: expected a finite"]);
    check("<light><intensity>-1 0 0</intensity></light>", &["light: `intensity`"]);
    check("<surface type=\"Sphere\"><radius>-1</radius></surface>", &["surface: `radius`"]);
    check("<surface type=\"Sphere\"><radius>0</radius></surface>", &["surface: `radius`"]);
    check(
        "<surface type=\"Box\"><minPt>1 1 1</minPt><maxPt>0 2 2</maxPt></surface>",
        &["surface: `"],
    );
    check("<surface/>", &["surface: expected surface type=\"...\""]);
    check(
        "<surface type=\"Plane\"/>",
        &["expected an element point", "expected an element normal"],
    );
    check(
        "<surface type=\"Triangle\"><a>1 2 3</a><v1>1 2 x</v1></surface>",
        &[
            "6:1: surface: expected an element c or v2, found none",
            "6:38: v1: expected a number, found \"x\"",
        ],
    );
    check("<surface type=\"Group\"><scale>0 1 1</scale></surface>", &["scale: `"]);
    check("<surface type=\"Mesh\"/>", &["expected an element data"]);
    check(
        "<surface type=\"Sphere\"><shader type=\"Phong\"><exponent>0</exponent></shader></surface>",
        &["shader: `exponent`"],
    );
    check("<shader name=\"a\" type=\"Constant\"/>", &["expected an element color"]);
    refuses(BALL.replace("4 3", "4"), &["4:3: image: expected 2 numbers, found \"4\""]);
    refuses(BALL.replace("4 3", "0 3"), &["4:3: image: `"]);
    refuses(BALL.replace("4 3", "-4 3"), &["image: expected two whole numbers"]);
    refuses(BALL.replace("4 3", "4.5 3"), &["image: expected two whole numbers"]);
    refuses(BALL.replace("4 3", "999999 3"), &["image: `"]);
    refuses(BALL.replace("0 0 5", "0 0"), &["3:11: viewPoint: expected 3 numbers"]);
    refuses(BALL.replace("<image>4 3</image>", ""), &["expected an element image"]);
    let lens = "<camera><viewDir>0 1 0</viewDir></camera>";
    let camera = "<camera><viewPoint>0 0 5</viewPoint></camera>";
    refuses(BALL.replace(camera, lens), &["3:3: camera: `"]);
    refuses(BALL.replace(camera, ""), &["expected an element camera"]);
    refuses(BALL.replace("<camera>", "<camera type=\"Fisheye\">"), &["camera: expected the type"]);
    let many = "<exposure>x</exposure>".repeat(1_500);
    let problems = with(&format!("<a>{many}</a>{}", "<surface/>".repeat(1_500))).unwrap_err();
    assert_eq!(problems.len(), 1_001);
    assert_eq!(problems[1_000].message, "500 further problems are not listed");
}
