"""The hot loops above their floors."""
from rounds import median
from .style import BLUE, GREY, pyplot, save


def draw(floor, folder):
    loops = floor["loops"]
    figure, axes = pyplot.subplots(figsize=(9.6, 3.8))
    figure.suptitle("Hot loops above the machine's floor, random input", x=0.01, ha="left", fontsize=12)
    for i, loop in enumerate(reversed(loops)):
        took = median(loop["rounds"])
        axes.barh(i, took, color=BLUE, height=0.62)
        axes.barh(i, loop["floor_ns"], color="white", edgecolor=GREY, hatch="////", height=0.62, linewidth=0.8)
        axes.text(
            took,
            i,
            f"  {took:.1f} ns, the floor {loop['floor_ns']:.2f} ns: {100 * loop['floor_ns'] / took:.0f} %",
            va="center",
            fontsize=8,
        )
    axes.set_yticks(range(len(loops)))
    axes.set_yticklabels([f"{loop['shape']} {loop['name']}, {loop['format']}" for loop in reversed(loops)])
    axes.set_xlabel("processor time a decision (ns); hatched: its operations or bytes at the measured peak")
    axes.set_xlim(0, max(median(loop["rounds"]) for loop in loops) * 1.45)
    axes.grid(axis="y", visible=False)
    figure.tight_layout(rect=(0, 0, 1, 0.97))
    save(figure, folder, "floor")
    return "floor"
