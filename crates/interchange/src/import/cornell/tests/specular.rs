//! Mirrors, glass and glaze of the course.

use scene::format::{Material, Shading};

use super::*;

/// The material of a shader in place, by a convention, with everything in it
/// read and said.
#[track_caller]
fn check(shading: Shading, shader: &str, expected: &Material, said: &str) {
    let text =
        BALL.replace("</scene>", &format!("<surface type=\"Sphere\">{shader}</surface></scene>"));
    let wishes = Wishes { shading: Some(shading), ..Wishes::default() };
    let source = Source { name: "a.xml", bytes: text.as_bytes() };
    let imported = import(source, &wishes, &NoAssets).unwrap();
    assert_eq!(imported.lost, [], "{shader}");
    assert_eq!(imported.scene.objects[1].material(), Some(expected), "{shader}");
    let chosen = imported.chosen.join("; ");
    assert!(chosen.contains(said), "{said} is not in: {chosen}");
    assert_eq!(imported.scene.bounces, if said.is_empty() { 5 } else { 11 }, "{shader}");
    imported.text("a.xml").unwrap();
}

const FRESNEL: &str = "Fresnel's equations, as in the course's years 2015 and 2017";
const SCHLICK: &str = "Schlick's law, as in the course's classic years";

#[test]
fn glass_refracts_as_its_year_has_it() {
    let glass = |ior, schlick| Material::Dielectric { ior, tint: [1.0; 3], schlick };
    let written = "<shader type='Glass'><refractiveIndex>1.5</refractiveIndex></shader>";
    check(Shading::Attenuated, written, &glass(1.5, false), FRESNEL);
    check(Shading::Radiometric, written, &glass(1.5, false), FRESNEL);
    check(Shading::Classic, written, &glass(1.5, true), SCHLICK);
    check(Shading::Classic, "<shader type='GLASS'/>", &glass(1.0, true), SCHLICK);
}

#[test]
fn a_glaze_is_over_what_is_lit() {
    let glazed = |schlick, diffuse, specular, exponent| Material::Glazed {
        ior: 1.25,
        schlick,
        diffuse,
        specular,
        exponent,
        texture: None,
    };
    let over = |substrate: &str| {
        format!("<shader type='Glazed'><refractiveIndex>1.25</refractiveIndex>{substrate}</shader>")
    };
    let color = Some([1.0, 0.5, 0.0]);
    let lambert =
        over("<substrate type='Lambertian'><diffuseColor>1 .5 0</diffuseColor></substrate>");
    check(Shading::Attenuated, &lambert, &glazed(false, color, [0.0; 3], 1.0), FRESNEL);
    check(Shading::Classic, &lambert, &glazed(true, color, [0.0; 3], 1.0), SCHLICK);
    let phong = over(
        "<substrate type='Phong'><diffuseColor>1 .5 0</diffuseColor><exponent>9</exponent>\
         <specularColor>0 0 1</specularColor></substrate>",
    );
    check(Shading::Attenuated, &phong, &glazed(false, color, [0.0, 0.0, 1.0], 9.0), FRESNEL);
    // By name, of a shader that stands after it.
    let text = "<shader name='a' type='Glazed'><refractiveIndex>1.25</refractiveIndex>\
                <substrate ref='b'/></shader><shader name='b' type='Lambertian'>\
                <diffuseColor>1 .5 0</diffuseColor></shader>";
    let scene = loses(text, &[]).scene;
    assert_eq!(scene.materials["a"], glazed(false, color, [0.0; 3], 1.0));
}

#[test]
fn what_a_glaze_cannot_be_over_is_lost() {
    let with_substrate = |substrate: &str| {
        format!(
            "<shader name='a' type='Glazed'><refractiveIndex>1.5</refractiveIndex>{substrate}</shader>"
        )
    };
    let over_constant = "<substrate type='Constant'><color>1 0 0</color></substrate>";
    let scene =
        loses(&with_substrate(over_constant), &["a glaze over Constant is not known"]).scene;
    let red = Material::Constant { color: [1.0, 0.0, 0.0], texture: None };
    assert_eq!(scene.materials["a"], red);
    loses(
        &with_substrate("<substrate type='Glass'/>"),
        &["substrate: a glaze over Glass is not known"],
    );
    let mirror = "<substrate type='Lambertian'><mirrorCoefficient>.5 .5 .5</mirrorCoefficient>\
                  </substrate>";
    loses(&with_substrate(mirror), &["a glaze over Lambertian is not known"]);
    let unknown = "<substrate type='CookTorrance'/>";
    loses(&with_substrate(unknown), &["what has this substrate is shown as plain Lambert"]);
    // One in another without end is not looked into.
    let deep = "<substrate type='Glazed'>".repeat(900) + &"</substrate>".repeat(900);
    loses(&with_substrate(&deep), &["a glaze over Glazed is not known"]);
    refuses(
        BALL.replace("</scene>", "<shader name='a' type='Glazed'/></scene>"),
        &[
            "6:1: shader: expected an element refractiveIndex, found none",
            "6:1: shader: expected an element substrate, found none",
        ],
    );
    for (index, found) in [("0", "`ior`"), ("-1", "`ior`"), ("glass", "found \"glass\"")] {
        let glass = format!("<refractiveIndex>{index}</refractiveIndex></shader></scene>");
        let glass = format!("<shader name='a' type='Glass'>{glass}");
        refuses(BALL.replace("</scene>", &glass), &[found]);
    }
}

#[test]
fn a_mirror_coefficient_grows() {
    let said = "grows along the surface by Schlick's law, as in the course's years 2018 and 2019";
    let whitted = |diffuse, specular, exponent| Material::Whitted {
        diffuse,
        specular,
        exponent,
        reflect: [0.25, 0.5, 0.0],
        transmit: [0.0; 3],
        ior: 1.0,
        schlick: true,
        texture: None,
    };
    let mirror = "<mirrorCoefficient>.25 .5 0</mirrorCoefficient>";
    let lambert = format!("<shader type='Lambertian'>{mirror}</shader>");
    check(Shading::Radiometric, &lambert, &whitted(None, [0.0; 3], 1.0), said);
    let phong = format!("<shader type='Phong'><exponent>4</exponent>{mirror}</shader>");
    check(Shading::Radiometric, &phong, &whitted(Some([1.0; 3]), [1.0; 3], 4.0), said);
    // None is asked for.
    let none = "<shader type='Lambertian'><mirrorCoefficient>0 0 0</mirrorCoefficient></shader>";
    let plain = Material::Lambert { diffuse: None, texture: None };
    check(Shading::Radiometric, none, &plain, "");
    let more = lambert.replace(".25 .5 0", "2 0 0").replace("<shader", "<shader name='a'");
    refuses(BALL.replace("</scene>", &format!("{more}</scene>")), &["`reflect`"]);
}
