//! What a golden's file may be: proofs that an edited, an outdated and a large
//! one are each told.
#![allow(clippy::unwrap_used)]

use conformance::{SQUARE, Scratch};
use harness::bless::Blessed;
use harness::check::Check;
use harness::encode::EncodedImage;
use harness::golden::{from_png, to_png};
use harness::repack::Repacked;
use harness::store;
use harness::verdict::Outcome;
use tracer::Size;

/// The verdict on a blessed fixture, `a`, after some damage.
#[track_caller]
fn check(damage: impl FnOnce(&Scratch), verdict: &str) {
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    damage(&scratch);
    assert_eq!(scratch.verdicts(), [("a".to_owned(), verdict)]);
}

fn outcome(scratch: &Scratch) -> Outcome {
    let selection = scratch.suite().select(&[]).unwrap();
    harness::run::run(scratch.suite(), &selection, &|_| ()).unwrap().remove(0)
}

fn bless(scratch: &Scratch) -> Blessed {
    let selection = scratch.suite().select(&[]).unwrap();
    harness::bless::bless(scratch.suite(), &selection, false).unwrap().remove(0).1
}

fn repack(scratch: &Scratch) -> Repacked {
    harness::repack::repack(scratch.suite(), &["a".to_owned()], &|_| ()).remove(0).1
}

/// The bytes of a golden's text chunk.
fn text_chunk(bytes: &[u8]) -> &[u8] {
    let at = bytes.windows(4).position(|w| w == b"tEXt").unwrap() - 4;
    let length = u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    &bytes[at..at + length + 12]
}

/// Another picture under the golden's own note, as a program leaves it that
/// edits a picture and keeps its text.
fn doctor(s: &Scratch, paint: impl Fn(&EncodedImage) -> EncodedImage) {
    // A PNG's signature and header take so many bytes.
    const HEAD: usize = 33;
    let golden = s.golden("a");
    let painted = to_png(&paint(&from_png(&golden).unwrap().picture), None).unwrap();
    let bytes = [&painted[..HEAD], text_chunk(&golden), &painted[HEAD..]].concat();
    s.set_golden("a", &bytes);
}

#[test]
fn a_golden_edited_under_its_own_note_is_tampered_with() {
    let same = |p: &EncodedImage| p.clone();
    check(|s| doctor(s, same), "match");
    let speck = |p: &EncodedImage| {
        EncodedImage::from_fn(p.size(), |x, y| {
            let [r, g, b] = p.get(x, y).unwrap();
            [r ^ u8::from((x, y) == (3, 2)), g, b]
        })
    };
    check(|s| doctor(s, speck), "tampered_golden");
    // Nor do limits that allow the change, or a size that does not.
    let limits = "check: (limits: (max_abs: 9, reason: \"a test\"),";
    let within = SQUARE.replace("check: (", limits);
    let lenient = |s: &Scratch| {
        s.set_fixture("a", &within);
        doctor(s, speck);
    };
    check(lenient, "tampered_golden");
    let cropped = |p: &EncodedImage| {
        EncodedImage::from_fn(Size { width: 16, height: 11 }, |x, y| p.get(x, y).unwrap())
    };
    check(|s| doctor(s, cropped), "tampered_golden");
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    doctor(&scratch, speck);
    assert!(matches!(repack(&scratch), Repacked::Refused(_)));
    bless(&scratch);
    assert_eq!(scratch.verdicts()[0].1, "match");
}

/// The golden with a note of version 1, which has no digest of the picture.
fn with_note_of_version_1(s: &Scratch, paint: impl Fn(&EncodedImage) -> EncodedImage) {
    let golden = from_png(&s.golden("a")).unwrap();
    let note = golden.provenance.unwrap();
    let text = format!(r#"{{"schema":1,"scene":"{}","assets":"{}"}}"#, note.scene, note.assets);
    set_golden_with_note(s, &paint(&golden.picture), text);
}

fn set_golden_with_note(s: &Scratch, picture: &EncodedImage, text: String) {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.size().width, picture.size().height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.add_text_chunk("goldray".to_owned(), text).unwrap();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(picture.bytes()).unwrap();
    writer.finish().unwrap();
    s.set_golden("a", &bytes);
}

#[test]
fn a_note_of_version_1_is_stale_until_repacked_and_only_a_match_is() {
    let scratch = Scratch::blessed(&[("a", SQUARE)]);
    let golden = scratch.golden("a");
    with_note_of_version_1(&scratch, EncodedImage::clone);
    let outcome = outcome(&scratch);
    assert_eq!(outcome.verdict.id(), "stale_golden");
    assert!(outcome.findings[0].contains("bless --repack"), "{:?}", outcome.findings);
    assert!(matches!(repack(&scratch), Repacked::Written { .. }));
    assert_eq!(scratch.golden("a"), golden, "the golden of today, to the byte");
    with_note_of_version_1(&scratch, |p| {
        EncodedImage::from_fn(p.size(), |x, y| p.get(x, y / 2).unwrap())
    });
    assert!(matches!(&repack(&scratch), Repacked::Refused(why) if why.contains("differs")));
}

#[test]
fn a_note_of_a_later_version_is_left_to_the_goldray_that_wrote_it() {
    for rest in [r#","scene":"a","assets":"b","picture":"c""#, r#","pictures":["c"]"#] {
        let scratch = Scratch::blessed(&[("a", SQUARE)]);
        let picture = from_png(&scratch.golden("a")).unwrap().picture;
        set_golden_with_note(&scratch, &picture, format!(r#"{{"schema":3{rest}}}"#));
        let golden = scratch.golden("a");
        let outcome = outcome(&scratch);
        assert_eq!((outcome.verdict.id(), outcome.remedy()), ("stale_golden", None));
        let why = "the golden's note is of version 3, expected at most 2: a newer goldray wrote \
                   it, use that one";
        assert_eq!(outcome.findings, [why, "the picture is the same"]);
        assert_eq!(bless(&scratch), Blessed::Refused(vec![why.to_owned()]));
        assert!(matches!(repack(&scratch), Repacked::Refused(said) if said.contains(why)));
        assert_eq!(scratch.golden("a"), golden);
    }
}

/// Colors all over, which compress badly.
const COLORFUL: &str = r"(
    version: 1,
    image: (640, 480),
    camera: Parallel(view_point: (0, 0, 5), view_width: 4, view_height: 3),
    show: Normals,
    objects: [Sphere(center: (0, 0, 0), radius: 1.9)],
)";

#[test]
fn a_large_golden_needs_a_reason_and_a_reason_a_large_golden() {
    let large = |text: &str| text.replace("objects:", "check: (large: \"a test\"), objects:");
    let reasoned = large(COLORFUL);
    let scratch = Scratch::blessed(&[("a", &reasoned)]);
    assert_eq!(scratch.verdicts()[0].1, "match");
    let bytes = scratch.golden("a").len();
    assert!(bytes > Check::MAX_FILE_BYTES, "{bytes}");
    scratch.set_fixture("a", COLORFUL);
    let outcome = outcome(&scratch);
    assert_eq!(outcome.verdict.id(), "golden_file_size");
    let said = outcome.findings.concat();
    assert!(said.contains(&format!("takes {bytes} bytes, expected at most 20480")), "{said}");
    store::remove(&scratch.suite().golden_path("a")).unwrap();
    assert!(matches!(bless(&scratch), Blessed::Refused(_)));
    assert_eq!(scratch.verdicts()[0].1, "missing_golden");

    let small = "check: (large: \"a test\", expect:";
    check(|s| s.set_fixture("a", &SQUARE.replace("check: (expect:", small)), "golden_file_size");
    check(
        |s| s.set_fixture("a", &SQUARE.replace("check: (expect:", "check: (large: \" \", expect:")),
        "render_refused",
    );
    let scratch = Scratch::blessed(&[("a", &SQUARE.replace("check: (expect:", small))]);
    assert_eq!(scratch.verdicts()[0].1, "missing_golden", "refused at once");
}
