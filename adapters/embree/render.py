"""A small ray-cast picture of a goldray scene, with the rays of Embree.

Reads goldray's JSON dialect, writes a PFM picture. Which triangle a ray meets first and what is
in the way of lights are Embree's answers, in single precision; camera, the place on the triangle,
shading and the rest are this file's, in double precision.

Needs the packages embreex and numpy. Call: render.py SCENE.json OUTPUT.pfm
"""

import json
import sys
from pathlib import Path

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

# Shadow rays start this part of the scene's size off the surface: single precision, a few roundings.
OFFSET = 3e-6


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def dot(a, b):
    return np.sum(a * b, axis=-1)


def say(why):
    sys.exit(f"render.py: {why}")


def one(tagged):
    """The name and fields of a variant: `"Normal"`, or `{"Lambert": {...}}`."""
    if isinstance(tagged, str):
        return tagged, {}
    ((name, fields),) = tagged.items()
    return name, fields


# Rays


def rays(scene):
    """Origins and directions through the pixels' centers, row by row from the top."""
    width, height = scene["image"]
    kind, camera = one(scene["camera"])
    point = lambda name, default: np.array(camera.get(name, default), dtype=float)
    if kind == "LookAt":
        eye, view = point("eye", None), point("at", None) - point("eye", None)
        up, normal, distance = point("up", (0, 1, 0)), None, 1.0
        window_height = 2 * np.tan(np.radians(camera["fov_deg"]) / 2)
        window = window_height * width / height, window_height
    else:
        eye, view = point("view_point", None), point("view_dir", (0, 0, -1))
        up, normal = point("view_up", (0, 1, 0)), camera.get("proj_normal")
        distance = camera.get("proj_distance", 1.0)
        window = camera.get("view_width", 1.0), camera.get("view_height", 1.0)
    w = unit(np.array(normal, dtype=float)) if normal is not None else -unit(view)
    u = unit(np.cross(up, w))
    v = np.cross(w, u)
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    a = window[0] * ((x.ravel() + 0.5) / width - 0.5)
    b = window[1] * (0.5 - (y.ravel() + 0.5) / height)
    across = a[:, None] * u + b[:, None] * v
    if kind == "Parallel":
        return eye + across, np.broadcast_to(unit(view), across.shape)
    return np.broadcast_to(eye, across.shape), distance * unit(view) + across


# Triangles


BOX = [
    # Corners by bits x, y, z; counter-clockwise from outside.
    (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6),
]  # fmt: skip


def step_matrix(step):
    """What a step of a group does, as a matrix of 4 x 4."""
    name, (x, y, z) = one(step)
    m = np.eye(4)
    if name == "Translate":
        m[:3, 3] = x, y, z
    elif name == "Scale":
        m[:3, :3] = np.diag([x, y, z])
    else:
        for axis, degrees in enumerate((x, y, z)):
            c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
            turn = np.eye(4)
            i, j = (axis + 1) % 3, (axis + 2) % 3
            turn[i, i], turn[i, j], turn[j, i], turn[j, j] = c, -s, s, c
            m = turn @ m
    return m


def corners_of_mesh(path, flat):
    """Corners and, if every corner has one, normals: arrays of (n, 3, 3)."""
    read = {".obj": read_obj, ".ply": read_ply}.get(path.suffix.lower())
    if read is None:
        say(f"{path.name}: expected an OBJ or PLY file")
    corners, normals = read(path)
    return corners, None if flat else normals


def read_obj(path):
    points, normals, faces, shaded = [], [], [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split("#")[0].split() or [""]
        if word == "v":
            points.append([float(r) for r in rest[:3]])
        elif word == "vn":
            normals.append([float(r) for r in rest])
        elif word == "f":
            index = [(r.split("/") + ["", ""])[:3] for r in rest]
            at = lambda i, n: int(i) - 1 if int(i) > 0 else n + int(i)
            for k in range(1, len(index) - 1):
                fan = (index[0], index[k], index[k + 1])
                faces.append([at(i[0], len(points)) for i in fan])
                shaded.append([at(i[2], len(normals)) if i[2] else -1 for i in fan])
    corners = np.array(points)[np.array(faces)]
    shaded = np.array(shaded)
    if not normals or (shaded < 0).any():
        return corners, None
    return corners, np.array(normals)[shaded]


PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip


def read_ply(path):
    """Files with points first and then faces, as most are."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line.split() for line in header.decode("latin-1").splitlines()]
    layout = next(line[1] for line in lines if line[:1] == ["format"])
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}.get(layout)
    elements = []
    for line in lines:
        if line[:1] == ["element"]:
            elements.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            elements[-1][2].append(line[1:])
    names = [name for name, _, _ in elements]
    lists = [len(properties[0]) == 4 and len(properties) == 1 for _, _, properties in elements]
    if order is None or names != ["vertex", "face"] or lists != [False, True]:
        say(f"{path.name}: expected a binary PLY file of vertices and faces alone")
    (_, many, properties), (_, faces, (((_, count, index, _)),)) = elements
    vertex = np.dtype([(name, order + PLY_TYPES[kind]) for kind, name in properties])
    vertices = np.frombuffer(body, vertex, many)
    face = np.dtype([("n", order + PLY_TYPES[count]), ("i", order + PLY_TYPES[index], 3)])
    triangles = np.frombuffer(body, face, faces, offset=many * vertex.itemsize)
    if (triangles["n"] != 3).any():
        say(f"{path.name}: expected triangles")
    field = lambda names: np.stack([vertices[name].astype(float) for name in names], axis=-1)
    has_normals = {"nx", "ny", "nz"} <= set(vertex.names)
    normals = field(["nx", "ny", "nz"])[triangles["i"]] if has_normals else None
    return field("xyz")[triangles["i"]], normals


class Triangles:
    """All triangles of a scene in world space, with what they are made of."""

    def __init__(self, scene, folder):
        self.scene, self.folder = scene, folder
        self.corners, self.normals, self.materials = [], [], []
        self.add_all(scene.get("objects", []), np.eye(4), None)
        if not self.corners:
            self.corners = [np.zeros((0, 3, 3))]
            self.normals = [np.zeros((0, 3, 3))]
        self.corners = np.concatenate(self.corners)
        self.normals = np.concatenate(self.normals)

    def add_all(self, objects, world, inherited):
        for tagged in objects:
            kind, o = one(tagged)
            material = o.get("material", inherited)
            if kind == "Group":
                matrix = np.eye(4)
                for step in o.get("transform", []):
                    matrix = step_matrix(step) @ matrix
                self.add_all(o["objects"], world @ matrix, material)
            elif kind == "Triangle":
                self.add(np.array([[o["a"], o["b"], o["c"]]], dtype=float), None, world, material)
            elif kind == "Box":
                lo_hi = np.array([o["min"], o["max"]], dtype=float)
                corner = lambda k: [lo_hi[k >> axis & 1, axis] for axis in range(3)]
                quads = [[corner(k) for k in face] for face in BOX]
                fan = [[q[0], q[k], q[k + 1]] for q in quads for k in (1, 2)]
                self.add(np.array(fan), None, world, material)
            elif kind == "Mesh":
                corners, normals = corners_of_mesh(self.folder / o["file"], o.get("flat", False))
                self.add(corners, normals, world, material)
            else:
                say(f"{kind}: expected triangles, boxes or meshes, as Embree is given no others here")

    def add(self, corners, normals, world, material):
        linear = world[:3, :3]
        corners = corners @ linear.T + world[:3, 3]
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        # A mirroring group turns triangles around, but not what is outside.
        side = np.sign(np.linalg.det(linear))
        across = unit(side * np.cross(b - a, c - a))
        if normals is None:
            normals = np.repeat(across[:, None], 3, axis=1)
        else:
            normals = unit(normals @ np.linalg.inv(linear))
        self.corners.append(corners)
        self.normals.append(normals)
        self.materials.extend([self.resolved(material)] * len(corners))

    def resolved(self, material):
        gray = 0.2 if self.scene.get("shading") == "Radiometric" else 1.0
        kind, m = one(material or "Lambert")
        if kind == "Named":
            kind, m = one(self.scene["materials"][m])
        if kind not in ("Constant", "Normal", "Lambert", "BlinnPhong") or "texture" in m:
            say(f"material {kind}: not known here")
        return kind, {"diffuse": [gray] * 3, **m}


# Light


def shade(scene, triangles, embree, size, points, sides, normals, views, numbers):
    """The light that leaves each hit against its ray."""
    convention = scene.get("shading", "Classic")
    colors = np.zeros((len(points), 3))
    names = [triangles.materials[k][0] for k in numbers]
    of = lambda key, zero: np.array([triangles.materials[k][1].get(key, zero) for k in numbers])
    k_d, k_s, power = of("diffuse", [0.0] * 3), of("specular", [0.0] * 3), of("exponent", 1.0)
    lit = np.array([name in ("Lambert", "BlinnPhong") for name in names], dtype=bool)
    constant = np.array([name == "Constant" for name in names], dtype=bool)
    if constant.any():
        colors[constant] = of("color", [0.0] * 3)[constant]
    normal = np.array([name == "Normal" for name in names], dtype=bool)
    colors[normal] = 0.5 * (normals[normal] + 1)
    for tagged in scene.get("lights", []):
        kind, light = one(tagged)
        intensity = np.array(light.get("intensity", (1, 1, 1)), dtype=float)
        if kind == "Ambient":
            colors[lit] += (k_d * intensity)[lit]
            continue
        if kind == "Point":
            to_light = np.array(light["position"], dtype=float) - points
            falloff = light.get("falloff") or ("Constant" if convention == "Classic" else "InverseSquare")
            fall = 1.0 if falloff == "Constant" else 1 / dot(to_light, to_light)[:, None]
            far = 1.0
        else:
            to_light = np.broadcast_to(-np.array(light["direction"], dtype=float), points.shape)
            fall, far = 1.0, 1e30
        l = unit(to_light)
        cosine = np.maximum(dot(normals, l), 0)[:, None]
        h = l + views
        length = np.linalg.norm(h, axis=-1, keepdims=True)
        h = np.divide(h, length, out=np.zeros_like(h), where=length > 0)
        highlight = k_s * (np.clip(dot(normals, h), 0, 1) ** power)[:, None]
        if convention == "Radiometric":
            share = (k_d / np.pi + highlight) * cosine
            share[dot(normals, views) <= 0] = 0
        else:
            share = k_d * cosine + highlight
        visible = lit.copy()
        if scene.get("shadows", True):
            off = np.where(dot(sides, to_light) < 0, -1.0, 1.0)[:, None] * sides * OFFSET * size
            start = points + off
            aim = np.array(light["position"]) - start if kind == "Point" else to_light
            reach = np.full(len(points), far, dtype=np.float32)
            blocked = embree.run(
                start.astype(np.float32), aim.astype(np.float32), dists=reach, query="OCCLUDED"
            )
            visible &= np.asarray(blocked) < 0
        colors[visible] += (share * intensity * fall)[visible]
    return colors


def weights(corners, origins, directions):
    """Where rays meet the triangles that Embree found, by the weights of the second and the third
    corner. Its own are of single precision, and highlights show it."""
    to_b, to_c = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(directions, to_c)
    volume = dot(to_b, across)
    from_a = origins - corners[:, 0]
    beta = dot(from_a, across) / volume
    gamma = dot(directions, np.cross(from_a, to_b)) / volume
    return beta[:, None], gamma[:, None]


def picture(scene, folder):
    width, height = scene["image"]
    triangles = Triangles(scene, folder)
    embree = EmbreeScene(robust=True)
    mesh = TriangleMesh(embree, triangles.corners.astype(np.float32)) if len(triangles.corners) else None
    origins, directions = rays(scene)
    colors = np.tile(np.array(scene.get("background", (0, 0, 0)), dtype=float), (width * height, 1))
    show, of_show = one(scene.get("show", "Shaded"))
    if mesh is not None:
        found = embree.run(origins.astype(np.float32), directions.astype(np.float32), output=True)
        hit = found["primID"] >= 0
        numbers = found["primID"][hit]
        beta, gamma = weights(triangles.corners[numbers], origins[hit], directions[hit])
        mix = lambda three: (1 - beta - gamma) * three[:, 0] + beta * three[:, 1] + gamma * three[:, 2]
        corners = triangles.corners[numbers]
        points, normals = mix(corners), unit(mix(triangles.normals[numbers]))
        sides = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
        views = -unit(directions[hit])
        if show == "Shaded":
            size = np.abs(triangles.corners).max()
            colors[hit] = shade(scene, triangles, embree, size, points, sides, normals, views, numbers)
        elif show == "Silhouette":
            colors[hit] = 1
        elif show == "Normals":
            colors[hit] = 0.5 * (normals + 1)
        elif show == "Depth":
            distance = np.linalg.norm(points - origins[hit], axis=-1)
            near, far = of_show["near"], of_show["far"]
            colors[hit] = np.clip((far - distance) / (far - near), 0, 1)[:, None]
        else:
            say(f"show {show}: not known here")
    if show == "Shaded":
        colors *= scene.get("exposure", 1.0)
    return colors.reshape(height, width, 3)


def main():
    scene_file, output = Path(sys.argv[1]), Path(sys.argv[2])
    image = picture(json.loads(scene_file.read_text()), scene_file.parent)
    height, width, _ = image.shape
    # PFM has its rows from the bottom up.
    rows = image[::-1].astype("<f4").tobytes()
    output.write_bytes(f"PF\n{width} {height}\n-1.0\n".encode() + rows)


if __name__ == "__main__":
    main()
