"""Time against error on one mix: on the left decisions alone, on the right whole answers."""
import math

from matplotlib.ticker import FuncFormatter, NullFormatter

from rounds import median
from . import labels
from .style import BLACK, GREY, pyplot, save, style, text_colour

# A unit in the last place of float is this many of double.
FLOAT_ULP = 2.0**29
LEAST_ULPS, MOST_ULPS = 0.2, 1e22


def front(points):
    """Those that no other beats in both: sorted by x."""
    out = []
    for x, y in sorted(points):
        if not out or y < out[-1][1]:
            out.append((x, y))
    return out


def draw_front(axes, points):
    steps = front(points)
    if not steps:
        return
    low, high = axes.get_ylim()
    left, right = axes.get_xlim()
    xs, ys = [steps[0][0]], [high]
    for x, y in steps:
        xs += [x, x]
        ys += [ys[-1], y]
    axes.plot(xs + [right], ys + [ys[-1]], color=GREY, linewidth=1, linestyle=(0, (6, 3)), zorder=1)
    axes.set_xlim(left, right)
    axes.set_ylim(low, high)


def share(value, total):
    percent = 100 * value / total
    return f"{percent:.0f} %" if percent >= 9.5 else f"{percent:.1f} %" if percent >= 0.095 else f"{percent:.2f} %"


def time_axis(axes, times):
    axes.set_yscale("log")
    low, high = min(times), max(times)
    axes.set_ylim(low / 1.9, high * 2.2)
    axes.set_ylabel("processor time a query (ns)")
    axes.yaxis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())


def plot_point(axes, x, entry, is_float):
    look = style(entry["label"])
    axes.plot(
        [x],
        [median(entry["rounds"])],
        marker=look["marker"],
        color=look["color"],
        linestyle="none",
        zorder=5,
        markersize=11 if look["marker"] == "*" else 7,
        markerfacecolor="white" if is_float else look["color"],
    )


def name(entry, is_float):
    return entry["label"] + (" (float)" if is_float else "")


def decisions(axes, entries):
    """entries: (entry, is it float). Shares on a logarithmic axis, none in a column of its own."""
    entries = [(e, f) for e, f in entries if e["task"] == "decision"]
    least = min([1 / e["errors"]["queries"] for e, _ in entries])
    none = least / 8

    def place(entry):
        return entry["errors"]["wrong"] / entry["errors"]["queries"] or none

    axes.set_xscale("log")
    axes.set_xlim(none / 3, 3)
    time_axis(axes, [median(e["rounds"]) for e, _ in entries])
    axes.axvspan(none / 3, none * 3, color="#F2F2F2", zorder=0)
    ticks = [none] + [10.0**k for k in range(math.ceil(math.log10(least)), 1)]
    axes.set_xticks(ticks)
    axes.set_xticklabels(["none"] + [f"{100 * t:g} %" for t in ticks[1:]])
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("wrong decisions")
    axes.set_title("decisions alone: hit or miss")
    for entry, is_float in entries:
        plot_point(axes, place(entry), entry, is_float)
    draw_front(axes, [(place(e), median(e["rounds"])) for e, is_float in entries if not is_float])
    labels.place(axes, [(place(e), median(e["rounds"]), name(e, f), text_colour(e["label"])) for e, f in entries])


def numbers(axes, entries):
    entries = [(e, f) for e, f in entries if e["task"] == "numbers" and e["errors"]["values"] > 0]

    def ulps(entry, is_float, key):
        unit = FLOAT_ULP if is_float else 1
        return min(max(float(entry["errors"][key]) * unit, LEAST_ULPS * 1.5), MOST_ULPS)

    worst = max(ulps(e, f, "max_ulps") for e, f in entries)
    axes.set_xscale("log")
    axes.set_xlim(LEAST_ULPS, worst * 3000)
    time_axis(axes, [median(e["rounds"]) for e, _ in entries])
    axes.set_xlabel("error of t: median ── 99.9th percentile ● ── greatest (units in the last place of double)")
    axes.set_title("whole answers: kind, t, u, v")
    halves = []
    for at, what in ((0.5, "double"), (0.5 * FLOAT_ULP, "float")):
        axes.axvline(at, color=BLACK, linewidth=0.8, linestyle=(0, (1, 2)), zorder=1)
        halves.append(axes.text(at * 1.15, axes.get_ylim()[1] * 0.97, f"½ ulp of {what}", fontsize=7, color=BLACK, va="top"))
    for entry, is_float in entries:
        axes.plot(
            [ulps(entry, is_float, "median_ulps"), ulps(entry, is_float, "max_ulps")],
            [median(entry["rounds"])] * 2,
            color=style(entry["label"])["color"],
            linewidth=0.9,
            alpha=0.55,
            zorder=2,
        )
        plot_point(axes, ulps(entry, is_float, "p999_ulps"), entry, is_float)
    draw_front(axes, [(ulps(e, f, "p999_ulps"), median(e["rounds"])) for e, f in entries if not f])

    def text(entry, is_float):
        errors = entry["errors"]
        return name(entry, is_float) + (f", {share(errors['wrong'], errors['queries'])} wrong" if errors["wrong"] else "")

    labels.place(
        axes, [(ulps(e, f, "p999_ulps"), median(e["rounds"]), text(e, f), text_colour(e["label"])) for e, f in entries], halves
    )


def draw(groups, folder):
    """groups: the double and the float group of one shape and mix. Returns the picture's name."""
    entries = [(e, g["format"] == "float") for g in groups for e in g["entries"]]
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(13.5, 6.8), gridspec_kw={"width_ratios": [1, 1.55]})
    shape, title = groups[0]["shape"], groups[0]["title"]
    figure.suptitle(f"Ray and {shape}, {title}", x=0.01, ha="left", fontsize=12)
    # Before labels are placed: they are fitted to the axes as they are.
    figure.subplots_adjust(left=0.058, right=0.992, bottom=0.125, top=0.89, wspace=0.15)
    figure.text(
        0.01,
        0.012,
        "lower left is better; dashed: the front, of double; filled: double, open: float, on the input rounded "
        "to float; wrong: kinds, features, sides or roots, but for what a kernel declares to do otherwise",
        fontsize=7.5,
        color="#555555",
    )
    decisions(left, entries)
    numbers(right, entries)
    result = f"pareto-{shape}-{groups[0]['mix']}"
    save(figure, folder, result)
    return result
