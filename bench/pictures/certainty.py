"""What certainty costs as more of the input is degenerate: times, and how often each stage ran."""
from matplotlib.ticker import FuncFormatter, NullFormatter

from rounds import median
from .style import BLACK, BLUE, GREEN, GREY, RED, pyplot, save, style

STAGES = [
    ("exact", "exact stage", RED, "s", "-"),
    ("rounding", "rounding in double-double", BLUE, "o", "-"),
    ("refined", "discriminant refined", GREEN, "^", (0, (3, 1.5))),
    ("midpoint", "midpoint test", BLACK, "D", (0, (1, 1.5))),
]


def times(axes, groups):
    by_name = {}
    for group in groups:
        for entry in group["entries"]:
            by_name.setdefault(entry["name"], (entry["label"], []))[1].append((group["percent"], median(entry["rounds"])))
    axes.set_yscale("log")
    for name, (label, points) in by_name.items():
        look = style(label)
        if name == "graze-hits":
            look["linestyle"] = (0, (4, 2))
        axes.plot(
            [x for x, _ in points], [y for _, y in points], label=label + (" hits" if name == "cgal-epick-hits" else ""), **look
        )
    axes.set_xlabel("share of degenerate input (%)")
    axes.set_ylabel("processor time a query (ns)")
    axes.yaxis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.legend(frameon=False, loc="upper left", ncol=2)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * 6)


def stages(axes, groups):
    for key, label, colour, marker, line in STAGES:
        if key == "refined" and groups[0]["shape"] == "triangle":
            continue
        # The exact stage rounds up to three numbers: a midpoint test counts once for each.
        axes.plot(
            [g["percent"] for g in groups],
            [100 * g["intersect"][key] / g["intersect"]["queries"] for g in groups],
            label=label,
            color=colour,
            marker=marker,
            linestyle=line,
            linewidth=1.4,
            markersize=5,
        )
    axes.plot([0, 100], [100, 100], color=GREY, linewidth=1, label="filter")
    axes.set_xlabel("share of degenerate input (%)")
    axes.set_ylabel("runs of a stage per 100 queries")
    axes.set_ylim(-4, 160)
    axes.legend(frameon=False, loc="upper left", ncol=2)


def draw(shape, timed, counted, folder):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11.5, 4.8))
    degenerate = "through an edge or a corner, exactly" if shape == "triangle" else "exact tangents"
    figure.suptitle(f"Ray and {shape}: the cost of certainty. Degenerate: {degenerate}", x=0.01, ha="left", fontsize=12)
    times(left, [g for g in timed if g["shape"] == shape and g["mix"] == "degenerate"])
    stages(right, [g for g in counted if g["shape"] == shape and g["mix"] == "degenerate"])
    figure.tight_layout(rect=(0, 0, 1, 0.96))
    name = f"certainty-{shape}"
    save(figure, folder, name)
    return name
