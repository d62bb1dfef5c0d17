"""Renders with Mitsuba 3 what the lines of standard input ask for.

A line is an object of JSON with the path of a scene, the name of a sampler, the
samples a pixel, how many of them at once, and where the picture goes, as rows
of three 32-bit floats for each pixel. The answer is a line with the CPU seconds
of all of the process's threads, of which one renders.
"""

import json
import sys
import time

import drjit
import mitsuba
import numpy

# Below this many seconds a render after others of other scenes is in good part
# the compiler's and the caches', in the variants that compile what they run: the
# time is then that of the next one.
WARM_UP = 3.0
compiles = not sys.argv[1].startswith("scalar")

scenes = {}


def loaded(scene, sampler, at_once):
    key = (scene, sampler, at_once)
    if key not in scenes:
        # One scene at a time: the bench goes from one to the next.
        if scenes and next(iter(scenes))[0] != scene:
            scenes.clear()
        with_ = {"sampler": sampler, "pass": str(at_once)}
        scenes[key] = mitsuba.load_file(scene, parallel=False, **with_)
    return scenes[key]


def render(scene, samples):
    start = time.process_time()
    picture = scene.integrator().render(scene, seed=0, spp=samples)
    drjit.eval(picture)
    drjit.sync_thread()
    return time.process_time() - start, picture


def answer(request):
    scene = loaded(request["scene"], request["sampler"], request["at_once"])
    seconds, picture = render(scene, request["samples"])
    if compiles and seconds < WARM_UP:
        seconds, picture = render(scene, request["samples"])
    numpy.array(picture).astype("<f4").tofile(request["picture"])
    return {"seconds": seconds}


mitsuba.set_variant(sys.argv[1])
mitsuba.set_log_level(mitsuba.LogLevel.Error)
drjit.set_thread_count(1)
print(json.dumps({"version": mitsuba.__version__}), flush=True)
for line in sys.stdin:
    try:
        told = answer(json.loads(line))
    except Exception as why:  # The bench says it, with what it asked for.
        told = {"error": str(why)}
    print(json.dumps(told), flush=True)
