"""What the repetitions of a measurement say: medians, their spread, and whether two differ."""
import random
import statistics


def median(rounds):
    return statistics.median(rounds)


def spread(rounds):
    """The middle half: lower and upper quartile."""
    if len(rounds) < 2:
        return rounds[0], rounds[0]
    low, _, high = statistics.quantiles(rounds, n=4, method="inclusive")
    return low, high


def doubt(a, b, resamples=2000, seed=1):
    """How likely it is that chance made the medians of a and b differ: the share of bootstrap resamples in which they lie the other
    way round or are equal. Outliers, of which a shared machine has many, hardly move a median."""
    source = random.Random(seed)
    is_above = median(b) > median(a)
    against = 0
    for _ in range(resamples):
        x, y = median(source.choices(a, k=len(a))), median(source.choices(b, k=len(b)))
        against += y <= x if is_above else y >= x
    return against / resamples
