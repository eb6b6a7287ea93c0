"""How every picture looks: one colour, marker and dash a kernel, the same in all of them. The colours are Okabe and Ito's, which
the colour-blind tell apart; markers and dashes are legible in grey."""
import matplotlib

matplotlib.use("Agg")
from matplotlib import colors, pyplot  # noqa: E402

BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE, GREY = (
    "#000000",
    "#E69F00",
    "#56B4E9",
    "#009E73",
    "#0072B2",
    "#D55E00",
    "#CC79A7",
    "#7F7F7F",
)

# label: colour, marker, dashes, width
STYLES = {
    "graze hits": (BLUE, "*", (), 2.6),
    "graze intersect": (BLUE, "*", (), 2.6),
    "graze batch": (BLUE, "P", (), 1.6),
    "naive": (RED, "v", (4, 2), 1.3),
    "stable": (RED, "^", (1, 1.5), 1.3),
    "repaired": (ORANGE, "<", (), 1.3),
    "Kahan": (PURPLE, "s", (5, 2, 1, 2), 1.3),
    "Goualard": (PURPLE, "D", (2, 2), 1.3),
    "Haines": (GREEN, "o", (), 1.3),
    "pbrt": (GREEN, "X", (3, 1.5), 1.3),
    "Cramer": (RED, "v", (4, 2), 1.3),
    "Möller–Trumbore": (ORANGE, "^", (), 1.3),
    "Woop": (GREEN, "o", (3, 1.5), 1.3),
    "80-bit": (SKY, "h", (), 1.3),
    "double-double": (GREY, "d", (6, 2), 1.3),
    "rational": (BLACK, "p", (2, 2), 1.3),
    "EPICK": (BLACK, "s", (), 1.3),
    "EPECK": (GREY, "D", (1, 1.5), 1.3),
}

pyplot.rcParams.update(
    {
        "font.family": "DejaVu Sans",
        "font.size": 9,
        "axes.titlesize": 10,
        "axes.labelsize": 9,
        "legend.fontsize": 8.5,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#DDDDDD",
        "grid.linewidth": 0.6,
        "axes.axisbelow": True,
        "svg.fonttype": "none",
        "svg.hashsalt": "graze",
        "figure.dpi": 110,
    }
)


def style(label):
    colour, marker, dashes, width = STYLES[label]
    return {"color": colour, "marker": marker, "linewidth": width, "linestyle": (0, dashes) if dashes else "-"}


def text_colour(label):
    """Darker than the marker, to be read on white."""
    return tuple(0.72 * part for part in colors.to_rgb(STYLES[label][0]))


def save(figure, folder, name):
    for ending, metadata in (("svg", {"Date": None}), ("png", {})):
        figure.savefig(f"{folder}/{name}.{ending}", metadata=metadata)
    pyplot.close(figure)
