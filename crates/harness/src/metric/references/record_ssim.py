"""Records what scikit-image says about the picture pairs of `pictures.py`.

    pip install numpy==2.4.6 scikit-image==0.26.0
    python record_ssim.py > ssim.txt

The means are scikit-image's, which leave out the windows that look over an
edge; the minimum is that of its full map, which mirrors the picture there.
Pictures smaller than its windows cannot be asked for; `ssim/tests.rs` covers
them from the definition.
"""

import numpy
import skimage
from skimage.metrics import structural_similarity

from pictures import PAIRS, draw, fnv1a

GAUSSIAN = {"gaussian_weights": True, "sigma": 1.5, "use_sample_covariance": False}
UNIFORM = {}


def worst(scores):
    """The lowest score and its column and row, `-` where others come within 1e-9."""
    lowest = scores.min()
    near = numpy.argwhere(scores < lowest + 1e-9)
    if len(near) > 1:
        return float(lowest), "-", "-"
    y, x = near[0]
    return float(lowest), x, y


def ssim(golden, actual, window):
    """The means of red, green and blue; the lowest score, its column and row."""
    means, maps = [], []
    for c in range(3):
        mean, scores = structural_similarity(
            golden[..., c], actual[..., c], data_range=255, full=True, **window
        )
        means.append(float(mean))
        maps.append(scores)
    # The three channels at once must be what they are one by one.
    at_once = structural_similarity(golden, actual, data_range=255, channel_axis=2, **window)
    assert abs(at_once - sum(means) / 3) < 1e-12
    return *means, *worst(numpy.minimum.reduce(maps))


print(f"# Written by record_ssim.py with scikit-image {skimage.__version__}, numpy {numpy.__version__}.")
print("# name width height fnv1a(golden) fnv1a(actual) rmse, then for the Gaussian window")
print("# of 11x11 and for the uniform one of 7x7: red green blue min min_x min_y")
for name, width, height, golden, actual in PAIRS:
    golden, actual = draw(width, height, golden), draw(width, height, actual)
    rmse = float(numpy.sqrt(numpy.mean((golden.astype(float) - actual.astype(float)) ** 2)))
    scores = *ssim(golden, actual, GAUSSIAN), *ssim(golden, actual, UNIFORM)
    print(name, width, height, fnv1a(golden), fnv1a(actual), rmse, *scores)
