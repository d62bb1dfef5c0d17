//! `Geometry`: an OBJ file's vertices, and its faces by what they are made of.

use std::collections::BTreeMap;

use tracer::glam::DVec3;

use super::corner::{Corner, Counts};
use crate::import::Unreadable;
use crate::import::mesh::part::{LARGEST, MOST_ELEMENTS, Part, is_point};
use crate::import::mesh::tally::Tally;
use crate::import::mesh::unreadable;
use crate::import::mesh::words::{Place, Word};
use crate::polygon::{Cutter, Problem, off_plane};

/// The most meshes that a file may become.
const MOST_PARTS: usize = 10_000;

/// Triangles of one material that all have normals or all have none, and so with
/// texture coordinates.
#[derive(Debug, Default)]
struct Group {
    material: Option<usize>,
    faces: Vec<[u32; 3]>,
    normal_faces: Vec<[u32; 3]>,
    uv_faces: Vec<[u32; 3]>,
}

/// Polygons that are not flat.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Bent {
    pub(super) count: usize,
    pub(super) first: Place,
}

/// What is read so far.
#[derive(Debug, Default)]
pub(super) struct Geometry {
    positions: Vec<DVec3>,
    uvs: Vec<[f64; 2]>,
    normals: Vec<DVec3>,
    groups: Vec<Group>,
    numbers: BTreeMap<(Option<usize>, bool, bool), usize>,
    triangles: usize,
    cutter: Cutter,
    pub(super) bent: Bent,
    corners: Vec<Corner>,
    polygon: Vec<DVec3>,
}

impl Geometry {
    /// `v x y z`, and with a weight or a color, which are lost.
    pub(super) fn vertex(
        &mut self,
        keyword: &Word<'_>,
        given: &[Word<'_>],
        lost: &mut Tally,
    ) -> Result<(), Unreadable> {
        let [x, y, z, more @ ..] = given else {
            return Err(expected(keyword, "three numbers", given));
        };
        let more: Vec<f64> = more.iter().map(number).collect::<Result<_, _>>()?;
        match more[..] {
            // The weight of curves, which a polygon's corners have no use for.
            [] | [1.0] => {}
            [_] => lost.add(Some(keyword.place), "`v`", "weights other than 1 are left out"),
            [_, _, _] | [_, _, _, _] => {
                lost.add(Some(keyword.place), "`v`", "colors of vertices are left out");
            }
            _ => return Err(expected(keyword, "3, 4, 6 or 7 numbers", given)),
        }
        self.has_room(keyword)?;
        self.positions.push(point(keyword, [x, y, z])?);
        Ok(())
    }

    /// `vt u v w`, of which the last is not used.
    pub(super) fn uv(&mut self, keyword: &Word<'_>, given: &[Word<'_>]) -> Result<(), Unreadable> {
        self.has_room(keyword)?;
        let uv = match given {
            [u] => [number(u)?, 0.0],
            [u, v] => [number(u)?, number(v)?],
            [u, v, w] => {
                number(w)?;
                [number(u)?, number(v)?]
            }
            _ => return Err(expected(keyword, "one to three numbers", given)),
        };
        self.uvs.push(uv);
        Ok(())
    }

    /// `vn i j k`.
    pub(super) fn normal(
        &mut self,
        keyword: &Word<'_>,
        given: &[Word<'_>],
    ) -> Result<(), Unreadable> {
        self.has_room(keyword)?;
        let [x, y, z] = given else { return Err(expected(keyword, "three numbers", given)) };
        self.normals.push(point(keyword, [x, y, z])?);
        Ok(())
    }

    /// `f` and its corners; whether they have normals.
    pub(super) fn face(
        &mut self,
        keyword: &Word<'_>,
        given: &[Word<'_>],
        material: Option<usize>,
        lost: &mut Tally,
    ) -> Result<bool, Unreadable> {
        let counts = Counts {
            vertices: self.positions.len(),
            uvs: self.uvs.len(),
            normals: self.normals.len(),
        };
        self.corners.clear();
        for word in given {
            let corner = Corner::of(word.text, counts);
            self.corners.push(corner.map_err(|why| unreadable(word.place, why))?);
        }
        if given.len() < 3 {
            return Err(expected(keyword, "three corners or more", given));
        }
        let has = |of: fn(&Corner) -> bool, what: &str| {
            let with = self.corners.iter().filter(|corner| of(corner)).count();
            if with != 0 && with != self.corners.len() {
                let all = self.corners.len();
                let message = format!(
                    "expected {what} at all of a face's corners or at none, found them at \
                     {with} of {all}"
                );
                return Err(unreadable(keyword.place, message));
            }
            Ok(with > 0)
        };
        let has_normals = has(|corner| corner.normal.is_some(), "normals")?;
        let has_uvs = has(|corner| corner.uv.is_some(), "texture coordinates")?;
        self.polygon.clear();
        let place = |corner: &Corner| self.positions[corner.vertex as usize];
        self.polygon.extend(self.corners.iter().map(place));
        let triangles = match self.cutter.cut(&self.polygon) {
            Ok(triangles) => triangles,
            Err(problem @ Problem::TooMuchWork) => {
                let message = format!("expected polygons of few corners, this {}", problem.text());
                return Err(unreadable(keyword.place, message));
            }
            Err(problem) => {
                let what = format!("a polygon that {} is left out", problem.text());
                lost.add(Some(keyword.place), "`f`", what);
                return Ok(has_normals);
            }
        };
        self.note_whether_flat(keyword.place);
        self.triangles += triangles.len();
        self.has_room(keyword)?;
        let group = self.group(keyword, (material, has_normals, has_uvs))?;
        for triangle in triangles {
            let corners = triangle.map(|i| self.corners[i]);
            let group = &mut self.groups[group];
            group.faces.push(corners.map(|corner| corner.vertex));
            if has_normals {
                group.normal_faces.push(corners.map(|corner| corner.normal.unwrap_or_default()));
            }
            if has_uvs {
                group.uv_faces.push(corners.map(|corner| corner.uv.unwrap_or_default()));
            }
        }
        Ok(has_normals)
    }

    fn note_whether_flat(&mut self, place: Place) {
        /// Of a polygon's size; less than this is not seen.
        const FLAT: f64 = 1e-3;
        if self.polygon.len() > 3 && off_plane(&self.polygon) > FLAT {
            if self.bent.count == 0 {
                self.bent.first = place;
            }
            self.bent.count += 1;
        }
    }

    fn group(
        &mut self,
        keyword: &Word<'_>,
        key: (Option<usize>, bool, bool),
    ) -> Result<usize, Unreadable> {
        if let Some(&number) = self.numbers.get(&key) {
            return Ok(number);
        }
        let number = self.groups.len();
        if number >= MOST_PARTS {
            let message = format!("expected at most {MOST_PARTS} materials, found one more");
            return Err(unreadable(keyword.place, message));
        }
        self.groups.push(Group { material: key.0, ..Group::default() });
        self.numbers.insert(key, number);
        Ok(number)
    }

    fn has_room(&self, keyword: &Word<'_>) -> Result<(), Unreadable> {
        let corners = self.positions.len() + self.uvs.len() + self.normals.len();
        if corners + self.triangles < MOST_ELEMENTS {
            return Ok(());
        }
        let message = format!("expected at most {MOST_ELEMENTS} vertices and triangles together");
        Err(unreadable(keyword.place, message))
    }

    /// The meshes, each with what it has of the vertices, and the number of its
    /// material.
    pub(super) fn into_parts(self) -> Vec<(Part, Option<usize>)> {
        let mut numbers = <[Numbers; 3]>::default();
        let part = |group: Group| {
            let [v, t, n] = &mut numbers;
            let (vertices, faces) = v.renumber(&self.positions, &group.faces);
            let (uvs, uv_faces) = t.renumber(&self.uvs, &group.uv_faces);
            let (normals, normal_faces) = n.renumber(&self.normals, &group.normal_faces);
            let part = Part { vertices, faces, normals, normal_faces, uvs, uv_faces };
            (part, group.material)
        };
        self.groups.into_iter().map(part).collect()
    }
}

/// The numbers that items have in the group at hand, made for one after the
/// other.
#[derive(Debug, Default)]
struct Numbers {
    round: u32,
    seen: Vec<(u32, u32)>,
}

impl Numbers {
    /// The items that triangles name, in the order of their first use, and the
    /// triangles by those.
    fn renumber<T: Copy>(&mut self, all: &[T], faces: &[[u32; 3]]) -> (Vec<T>, Vec<[u32; 3]>) {
        self.seen.resize(all.len(), (0, 0));
        self.round += 1;
        let mut used = Vec::new();
        let mut number = |old: u32| {
            let (round, number) = &mut self.seen[old as usize];
            if *round != self.round {
                (*round, *number) = (self.round, used.len() as u32);
                used.push(all[old as usize]);
            }
            *number
        };
        let faces = faces.iter().map(|face| face.map(&mut number)).collect();
        (used, faces)
    }
}

fn number(word: &Word<'_>) -> Result<f64, Unreadable> {
    word.number().map_err(|why| unreadable(word.place, why))
}

fn point(keyword: &Word<'_>, words: [&Word<'_>; 3]) -> Result<DVec3, Unreadable> {
    let [x, y, z] = words.map(number);
    let point = DVec3::new(x?, y?, z?);
    if is_point(point) {
        return Ok(point);
    }
    let message = format!("expected numbers of at most {LARGEST:e}, found {point}");
    Err(unreadable(keyword.place, message))
}

fn expected(keyword: &Word<'_>, what: &str, given: &[Word<'_>]) -> Unreadable {
    let message = format!("expected {what} after `{}`, found {}", keyword.shown(), given.len());
    unreadable(keyword.place, message)
}
