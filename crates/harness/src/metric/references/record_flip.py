"""Records what NVIDIA's FLIP evaluator says about the picture pairs of `pictures.py`.

    pip install numpy==2.4.6 flip-evaluator==1.7
    python record_flip.py > flip.txt

It counts in single precision: asked about the same two pictures turned and
mirrored, it answers up to 4e-4 differently. The median of the eight answers is
recorded.

Of the map of errors, up to 8 columns and 8 rows are recorded, spread evenly from
the first to the last; all of a small one.
"""

from importlib.metadata import version

import flip_evaluator
import numpy

from pictures import PAIRS, SEEN_PAIRS, SMALL_PAIRS, draw, fnv1a

SPREAD = 8


def spread(pixels):
    """Up to `SPREAD` positions on a line of pixels, its ends included."""
    if pixels <= SPREAD:
        return list(range(pixels))
    return [i * (pixels - 1) // (SPREAD - 1) for i in range(SPREAD)]


def seen(picture):
    return picture.astype(numpy.float32) / numpy.float32(255)


def errors_seen(golden, actual):
    answers = []
    for turns in range(4):
        for mirrored in (False, True):

            def placed(picture):
                turned = numpy.rot90(picture, turns)
                return numpy.ascontiguousarray(turned[:, ::-1] if mirrored else turned)

            found, _, _ = flip_evaluator.evaluate(
                seen(placed(golden)), seen(placed(actual)), "LDR", applyMagma=False
            )
            found = found[..., 0].astype(float)
            answers.append(numpy.rot90(found[:, ::-1] if mirrored else found, -turns))
    return numpy.median(answers, axis=0)


print(f"# Written by record_flip.py with flip-evaluator {version('flip-evaluator')}, numpy {numpy.__version__}.")
print("# name width height fnv1a(golden) fnv1a(actual) mean max, then errors row by row")
for name, width, height, golden, actual in PAIRS + SMALL_PAIRS + SEEN_PAIRS:
    golden, actual = draw(width, height, golden), draw(width, height, actual)
    errors = errors_seen(golden, actual)
    values = [errors.mean(), errors.max(), *errors[numpy.ix_(spread(height), spread(width))].ravel()]
    print(name, width, height, fnv1a(golden), fnv1a(actual), *(f"{value:.7f}" for value in values))
