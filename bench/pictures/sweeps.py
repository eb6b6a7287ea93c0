"""A stability sweep: the greatest error that was found, and the share of wrong answers, along one condition."""
from matplotlib.ticker import FuncFormatter

from .style import BLACK, GREY, pyplot, save, style

LEAST_ULPS, MOST_ULPS = 0.2, 1e32


def power(k, _=None):
    return "1" if k == 0 else f"$2^{{{int(k)}}}$"


def draw(sweep, folder):
    figure, (top, bottom) = pyplot.subplots(2, 1, figsize=(9.6, 7.6), sharex=True, gridspec_kw={"height_ratios": [2.3, 1]})
    figure.suptitle(sweep["title"], x=0.01, ha="left", fontsize=12)
    levels = [p["level"] for p in sweep["lines"][0]["points"]]
    top.set_yscale("log")
    seen = [0.5]
    for number, line in enumerate(sweep["lines"]):
        look = style(line["label"])
        found = [p for p in line["points"] if "hunted_ulps" in p]
        at = [p["level"] for p in found]
        worst, hunted = (
            [min(max(float(p[key]), LEAST_ULPS * 1.5), MOST_ULPS) for p in found] for key in ("max_ulps", "hunted_ulps")
        )
        seen += hunted
        ours = {"zorder": 5, "markersize": 7} if line["ours"] else {"zorder": 3, "markersize": 4.5}
        every = max(1, len(levels) // 9)
        top.plot(at, worst, label=line["label"], markevery=(number % every, every), **look, **ours)
        top.plot(at, hunted, color=look["color"], marker=".", markersize=3.5, linestyle="none", alpha=0.6, zorder=2)
        bottom.plot(
            levels, [100 * p["wrong"] / sweep["queries"] for p in line["points"]], markevery=(number % every, every), **look, **ours
        )
    if sweep["slope"]:
        first, last = levels[0], levels[-1]
        limit = max(seen)
        xs = [k for k in range(first, last + 1) if 2.0 ** (sweep["slope"] * k) <= limit]
        top.plot(
            xs,
            [2.0 ** (sweep["slope"] * k) for k in xs],
            color=BLACK,
            linewidth=1,
            linestyle=(0, (1, 2)),
            label=f"theory: slope {'1' if sweep['slope'] == 1 else '½'}",
            zorder=2,
        )
    top.axhline(0.5, color=GREY, linewidth=0.8, zorder=1, label="½ ulp")
    top.set_ylim(LEAST_ULPS, max(seen) * 20)
    top.set_ylabel("greatest error of t, u, v found (ulps of double)")
    bottom.set_ylabel("wrong answers (%)")
    bottom.set_ylim(-4, 104)
    bottom.set_xlabel(sweep["axis"])
    bottom.xaxis.set_major_formatter(FuncFormatter(power))
    handles, names = top.get_legend_handles_labels()
    figure.legend(handles, names, loc="center left", bbox_to_anchor=(0.8, 0.55), frameon=False, handlelength=3.6)
    figure.tight_layout(rect=(0, 0.035, 0.8, 0.97))
    clipped = "; errors beyond 10³² are drawn there" if max(seen) >= MOST_ULPS else ""
    theory = f"\ndotted: {sweep['theory']}" if sweep["slope"] else ""
    figure.text(
        0.01,
        0.006,
        f"{sweep['queries']} random inputs a level; points: after hill climbing, for each kernel by itself; of answers of the right "
        f"kind{clipped}{theory}",
        fontsize=7.5,
        color="#555555",
    )
    name = f"sweep-{sweep['name']}"
    save(figure, folder, name)
    return name
