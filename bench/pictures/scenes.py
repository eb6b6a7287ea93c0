"""Scenes: time a ray against the number of triangles, from the rows that scene_speed writes."""
import json

from matplotlib.ticker import FuncFormatter, NullFormatter

from .style import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, pyplot, save

LOOKS = {
    "graze float": (BLUE, "*", "-", 2.4),
    "graze double": (SKY, "P", "-", 1.6),
    "graze float batch": (BLUE, "v", (0, (2, 2)), 1.8),
    "graze double batch": (SKY, "h", (0, (6, 2)), 1.6),
    "Embree robust": (RED, "s", (0, (4, 2)), 1.4),
    "Embree": (ORANGE, "o", "-", 1.4),
    "Embree packets": (GREEN, "^", (0, (1, 1.5)), 1.4),
    "Embree stream": (GREY, "D", (0, (5, 2, 1, 2)), 1.4),
}
OTHERS = [(BLACK, "X", "-", 1.0), (PURPLE, "p", (0, (6, 2)), 1.4), (BLACK, "d", (0, (2, 2)), 1.4)]
LEGEND = 2.1  # inches
MIXES = ("camera", "incoherent", "occlusion")


def read(path):
    with open(path, encoding="utf-8") as file:
        rows = json.load(file).get("rows", [])
    if not rows:
        raise ValueError(f"there are no rows in {path}")
    return rows


def lines_of(rows, mix):
    """By contender: (triangles, ns a ray), the peers' races and our growth together."""
    lines = {}
    for row in rows:
        if row["what"] == mix and row["unit"] == "ns a ray" and row["section"] in ("peers", "growth"):
            lines.setdefault(row["contender"], {}).setdefault(row["triangles"], row["value"])
    return {contender: sorted(points.items()) for contender, points in lines.items()}


def draw(rows, folder):
    mixes = [mix for mix in MIXES if lines_of(rows, mix)]
    figure, all_axes = pyplot.subplots(1, len(mixes), figsize=(4.4 * len(mixes) + LEGEND, 4.4), sharey=True, squeeze=False)
    figure.suptitle("Scenes: time a ray against the number of triangles, one core", x=0.01, ha="left", fontsize=12)
    looks, others = dict(LOOKS), list(OTHERS)
    for axes, mix in zip(all_axes[0], mixes):
        for contender, points in lines_of(rows, mix).items():
            if contender not in looks:
                looks[contender] = others.pop(0)
            colour, marker, dashes, width = looks[contender]
            axes.plot(
                [x for x, _ in points],
                [y for _, y in points],
                label=contender,
                color=colour,
                marker=marker,
                linestyle=dashes,
                linewidth=width,
                markersize=5,
            )
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(mix + " rays")
        axes.set_xlabel("triangles")
        axes.yaxis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    all_axes[0][0].set_ylabel("processor time a ray (ns)")
    found = {}
    for axes in all_axes[0]:
        for handle, name in zip(*axes.get_legend_handles_labels()):
            found.setdefault(name, handle)
    right = 1 - LEGEND / figure.get_size_inches()[0]
    figure.legend(found.values(), found.keys(), loc="center left", bbox_to_anchor=(right, 0.55), frameon=False, handlelength=3.2)
    figure.tight_layout(rect=(0, 0, right, 0.95))
    save(figure, folder, "scenes")
    return "scenes"
