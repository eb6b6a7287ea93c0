"""Labels beside points, none over another label or point, with a thin line back where a label had to move away."""
import math

from matplotlib.transforms import Bbox

DISTANCES = (7, 12, 18, 26, 36, 48, 62, 80, 100)
DIRECTIONS = [math.radians(angle) for angle in (0, 180, 45, 315, 135, 225, 90, 270, 20, 340, 160, 200)]


def place(axes, points, obstacles=()):
    """points: (x, y, text, colour) in data coordinates; obstacles: texts that stay. The axes' limits are final."""
    figure = axes.figure
    renderer = figure.canvas.get_renderer()
    scale = figure.dpi / 72
    frame = axes.get_window_extent(renderer)
    dots = [axes.transData.transform((x, y)) for x, y, _, _ in points]
    taken = [Bbox.from_extents(x - 5 * scale, y - 5 * scale, x + 5 * scale, y + 5 * scale) for x, y in dots]
    taken += [text.get_window_extent(renderer) for text in obstacles]
    for (x, y, text, colour), dot in sorted(zip(points, dots), key=lambda p: (p[1][0], p[1][1])):
        label = axes.text(
            x,
            y,
            text,
            color=colour,
            fontsize=8,
            va="center",
            ha="left",
            zorder=6,
            bbox={"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
        )
        size = label.get_window_extent(renderer)  # of the text alone
        best = None
        for distance in DISTANCES:
            for direction in DIRECTIONS:
                away = distance * scale
                center_x = dot[0] + math.cos(direction) * (away + size.width / 2)
                center_y = dot[1] + math.sin(direction) * (away + size.height / 2 if abs(math.sin(direction)) > 0.5 else away)
                box = Bbox.from_bounds(center_x - size.width / 2, center_y - size.height / 2, size.width, size.height)
                if not (frame.x0 <= box.x0 and box.x1 <= frame.x1 and frame.y0 <= box.y0 and box.y1 <= frame.y1):
                    continue
                if any(box.overlaps(other) for other in taken):
                    continue
                best = box
                break
            if best is not None:
                break
        if best is None:
            raise RuntimeError(f"no room for the label {text}: make the picture larger")
        taken.append(best)
        label.set_position(axes.transData.inverted().transform((best.x0, (best.y0 + best.y1) / 2)))
        near_x, near_y = min(max(dot[0], best.x0), best.x1), min(max(dot[1], best.y0), best.y1)
        if math.hypot(near_x - dot[0], near_y - dot[1]) > 13 * scale:
            end = axes.transData.inverted().transform((near_x, near_y))
            axes.annotate("", xy=(x, y), xytext=end, arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.5}, zorder=4)
