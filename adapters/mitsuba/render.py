"""Renders a scene that goldray wrote for Mitsuba 3, by a ray through each pixel's middle.

    python3 render.py scene.xml out.exr WIDTH HEIGHT

Mitsuba's own film takes its samples anywhere in a pixel; here the scene's camera
is asked for the ray through the middle of each, and the scene's integrator for
what it sees. The picture is linear, of 32-bit floats, as EXR (or PFM).

The plugins `goldray_*` say what Mitsuba has no plugins for. Rays, shapes, normals,
cameras and shadows are Mitsuba's in any case.
"""

import math
import sys

import mitsuba as mi
import numpy

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)


def numbers(props, name, default=None):
    """Three numbers that are given as a vector, so that no color profile touches them."""
    if default is not None and name not in props:
        return mi.Color3f(default)
    return mi.Color3f(mi.Vector3f(props[name]))


class Surface(mi.BSDF):
    """Lambert's cosine law with Blinn and Phong's highlight.

    `radiometric`: the highlight is times the cosine, and the back is dark. Otherwise
    it is not, and the normal is never turned: a surface that is seen from its back
    shows the light that falls on its front. The share 1/pi is in both.
    """

    def __init__(self, props):
        super().__init__(props)
        self.diffuse = numbers(props, "diffuse")
        self.specular = numbers(props, "specular")
        self.exponent = props.get("exponent", 1.0)
        self.radiometric = props.get("radiometric", False)
        self.m_flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.BackSide
        self.m_components = [self.m_flags]

    def sample(self, ctx, si, sample1, sample2, active=True):
        return mi.BSDFSample3f(), mi.Color3f(0)

    def eval(self, ctx, si, wo, active=True):
        if self.radiometric and si.wi.z <= 0:
            return mi.Color3f(0)
        cosine = max(wo.z, 0.0)
        value = self.diffuse * (cosine / math.pi)
        h = [a + b for a, b in zip(si.wi, wo)]
        length = math.sqrt(sum(x * x for x in h))
        if length > 0 and max(self.specular) > 0:
            highlight = min(max(h[2] / length, 0.0), 1.0) ** self.exponent
            value += self.specular * (highlight * (cosine if self.radiometric else 1.0))
        return value

    def pdf(self, ctx, si, wo, active=True):
        return 0.0

    def to_string(self):
        return "Surface[]"


class Shown(mi.Emitter):
    """What a surface shows by itself, from both sides; it lights nothing."""

    def __init__(self, props):
        super().__init__(props)
        self.m_flags = mi.EmitterFlags.Surface

    def sample_direction(self, it, sample, active=True):
        return mi.DirectionSample3f(), mi.Color3f(0)

    def to_string(self):
        return "Shown[]"


class Glow(Shown):
    """A color."""

    def __init__(self, props):
        super().__init__(props)
        self.radiance = numbers(props, "radiance")

    def eval(self, si, active=True):
        return self.radiance


class Normals(Shown):
    """The normal `n` as the color `(n + 1) / 2`, times `scale`."""

    def __init__(self, props):
        super().__init__(props)
        self.scale = props.get("scale", 1.0)

    def eval(self, si, active=True):
        return mi.Color3f((si.sh_frame.n + 1) * (0.5 * self.scale))


class Depth(Shown):
    """The distance from the eye, or by `along` from a window: white at `near`, black at `far`."""

    def __init__(self, props):
        super().__init__(props)
        self.eye = numpy.array(props["eye"])
        self.along = numpy.array(props["along"]) if "along" in props else None
        self.near, self.far = props["near"], props["far"]

    def eval(self, si, active=True):
        way = numpy.array(si.p) - self.eye
        distance = numpy.linalg.norm(way) if self.along is None else way @ self.along
        return mi.Color3f(min(max((self.far - distance) / (self.far - self.near), 0.0), 1.0))


class Point(mi.Emitter):
    """A light at a point, as bright at any distance."""

    def __init__(self, props):
        super().__init__(props)
        self.position = mi.Point3f(mi.Vector3f(props["position"]))
        self.intensity = numbers(props, "intensity")
        self.m_flags = mi.EmitterFlags.DeltaPosition

    def sample_direction(self, it, sample, active=True):
        ds = mi.DirectionSample3f()
        ds.p = self.position
        way = ds.p - it.p
        ds.dist = math.sqrt(way.x * way.x + way.y * way.y + way.z * way.z)
        if ds.dist == 0:
            return ds, mi.Color3f(0)
        ds.d = way / ds.dist
        ds.n = mi.Normal3f(0)
        ds.uv = mi.Point2f(0)
        ds.time = it.time
        ds.pdf = 1.0
        ds.delta = True
        return ds, self.intensity

    def eval(self, si, active=True):
        return mi.Color3f(0)

    def bbox(self):
        return mi.BoundingBox3f()

    def to_string(self):
        return "Point[]"


class Direct(mi.SamplingIntegrator):
    """Asks every light that has a place or a direction, where Mitsuba's own asks one by chance,
    and follows every ray that a mirror or glass sends on, `bounces` times, where Mitsuba's own
    follows one by chance.
    """

    def __init__(self, props):
        super().__init__(props)
        self.shadows = props.get("shadows", True)
        self.background = numbers(props, "background", 0.0)
        self.bounces = props.get("bounces", 0)

    def sample(self, scene, sampler, ray, medium=None, active=True):
        return self.radiance(scene, ray, self.bounces), True, []

    def radiance(self, scene, ray, left):
        si = scene.ray_intersect(ray)
        if not si.is_valid():
            return self.background
        emitter = si.emitter(scene)
        radiance = mi.Color3f(0) if emitter is None else mi.Color3f(emitter.eval(si))
        bsdf = si.bsdf(ray)
        for light in scene.emitters():
            if mi.has_flag(light.flags(), mi.EmitterFlags.Surface):
                continue
            ds, weight = light.sample_direction(si, mi.Point2f(0.5, 0.5))
            value = bsdf.eval(mi.BSDFContext(), si, si.to_local(ds.d)) * weight
            # The ray starts off the surface on the light's side of it.
            if max(value) > 0 and not (self.shadows and scene.ray_test(si.spawn_ray_to(ds.p))):
                radiance += value
        if left == 0 or not mi.has_flag(bsdf.flags(), mi.BSDFFlags.Delta):
            return radiance
        for component in range(bsdf.component_count()):
            # As importance: radiance would be scaled by the square of the index.
            ctx = mi.BSDFContext(mi.TransportMode.Importance, mi.BSDFFlags.All, component)
            way, share = bsdf.sample(ctx, si, 0.5, mi.Point2f(0.5, 0.5))
            if max(share) > 0:
                onward = si.spawn_ray(si.to_world(way.wo))
                radiance += share * self.radiance(scene, onward, left - 1)
        return radiance

    def to_string(self):
        return "Direct[]"


mi.register_bsdf("goldray_surface", Surface)
mi.register_emitter("goldray_glow", Glow)
mi.register_emitter("goldray_normals", Normals)
mi.register_emitter("goldray_depth", Depth)
mi.register_emitter("goldray_point", Point)
mi.register_integrator("goldray_direct", Direct)


def render(path, width, height):
    """The picture as an array of height, width and three channels."""
    scene = mi.load_file(path, parallel=False)
    sensor, integrator = scene.sensors()[0], scene.integrator()
    sampler = sensor.sampler()
    sampler.seed(0, 1)
    picture = numpy.zeros((height, width, 3), dtype=numpy.float32)
    for j in range(height):
        for i in range(width):
            place = mi.Point2f((i + 0.5) / width, (j + 0.5) / height)
            ray, weight = sensor.sample_ray(0.0, 0.5, place, mi.Point2f(0.5, 0.5))
            color, is_hit, _ = integrator.sample(scene, sampler, ray)
            if is_hit:
                picture[j, i] = numpy.array(color * weight)
    return picture


def main():
    path, output, width, height = sys.argv[1:5]
    picture = render(path, int(width), int(height))
    mi.Bitmap(picture).write(output)


if __name__ == "__main__":
    main()
