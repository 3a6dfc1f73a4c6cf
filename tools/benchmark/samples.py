"""What many runs of the same say."""
import math
import statistics


def median(values):
    return statistics.median(values)


def spread(values):
    """How far the middle half of the values lies apart, as a part of the median; None for fewer than three."""
    if len(values) < 3:
        return None
    low, _, high = statistics.quantiles(values, n=4, method="inclusive")
    middle = statistics.median(values)
    return (high - low) / middle if middle else None


def exponent(points):
    """p of the power law y = c x^p that fits (x, y) best: least squares of the logarithms. None for fewer than two
    points above zero."""
    logs = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(logs) < 2:
        return None
    mean_x, mean_y = (statistics.fmean(values) for values in zip(*logs))
    square = sum((x - mean_x) ** 2 for x, _ in logs)
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / square if square else None
