"""ns a ray against the number of triangles, from what scene_speed prints."""
import re

from matplotlib.ticker import FuncFormatter, NullFormatter

from .style import BLACK, BLUE, GREEN, GREY, ORANGE, RED, SKY, pyplot, save

LOOKS = {"graze float": (BLUE, "*", "-", 2.4), "graze double": (SKY, "P", "-", 1.6), "Embree robust": (RED, "s", (0, (4, 2)), 1.4),
         "Embree": (ORANGE, "o", "-", 1.4), "Embree packets": (GREEN, "^", (0, (1, 1.5)), 1.4), "Embree stream": (GREY, "D", (0, (5, 2, 1, 2)), 1.4)}


def read(path):
    """A list of meshes, each with its line about building and its mixes: name, then (contender, ns) pairs."""
    meshes = []
    with open(path, encoding="utf-8") as file:
        for line in file:
            about = re.match(r"(\S.*): (\d+) triangles; (.*)", line)
            if about:
                meshes.append({"name": about[1], "triangles": int(about[2]), "about": about[3].strip(), "mixes": {}})
                continue
            mix = re.match(r"  (\w+)\s+(.*)", line)
            if mix and meshes:
                meshes[-1]["mixes"][mix[1]] = [(name.strip(), float(ns)) for name, ns in re.findall(r"([A-Za-z ]+?) ([\d.]+) ns", mix[2])]
    return meshes


def draw(meshes, folder):
    mixes = list(meshes[0]["mixes"])
    figure, all_axes = pyplot.subplots(1, len(mixes), figsize=(4.4 * len(mixes), 4.4), sharey=True, squeeze=False)
    figure.suptitle("Scenes: time a ray against the number of triangles", x=0.01, ha="left", fontsize=12)
    meshes = sorted(meshes, key=lambda m: m["triangles"])
    for axes, mix in zip(all_axes[0], mixes):
        lines = {}
        for mesh in meshes:
            for contender, ns in mesh["mixes"].get(mix, []):
                lines.setdefault(contender, []).append((mesh["triangles"], ns))
        for contender, points in lines.items():
            colour, marker, dashes, width = LOOKS.get(contender, (BLACK, "x", "-", 1.2))
            axes.plot([x for x, _ in points], [y for _, y in points], label=contender, color=colour, marker=marker, linestyle=dashes,
                      linewidth=width, markersize=5)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(mix)
        axes.set_xlabel("triangles")
        axes.yaxis.set_major_formatter(FuncFormatter(lambda ns, _: f"{ns:g}"))
        axes.yaxis.set_minor_formatter(NullFormatter())
    all_axes[0][0].set_ylabel("processor time a ray (ns)")
    all_axes[0][0].legend(frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.95))
    save(figure, folder, "scenes")
    return "scenes"
