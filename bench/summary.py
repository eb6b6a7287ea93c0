"""The figures that the pages quote, from the results."""
from rounds import median


def times(group, task):
    """ns of each entry of a task, by name."""
    return {e["name"]: median(e["rounds"]) for e in group["entries"] if e["task"] == task}


def entry(group, name):
    return next((e for e in group["entries"] if e["name"] == name), None)


# What is exact or of more than the input's precision is no inexact peer.
EXACT = ("cgal", "graze", "repaired-", "cramer-80", "cramer-double", "cramer-rational")


def fastest_inexact(group, task):
    peers = {n: t for n, t in times(group, task).items() if not n.startswith(EXACT) or n in ("repaired-hits", "cramer-hits")}
    name = min(peers, key=peers.get)
    return name, peers[name]


def rows(results):
    """One row a shape, mix and format: the fastest inexact kernel, graze and EPICK, for decisions and for whole answers."""
    out = []
    for group in results["time_error"]:
        row = {"shape": group["shape"], "mix": group["mix"], "title": group["title"], "format": group["format"]}
        for task, ours, batch in (
            ("decision", "graze-hits", "graze-batch-hits"),
            ("numbers", "graze-intersect", "graze-batch-intersect"),
        ):
            all_times = times(group, task)
            peer, peer_time = fastest_inexact(group, task)
            cell = {
                "peer": peer,
                "peer_ns": peer_time,
                "ns": all_times[ours],
                "batch_ns": all_times[batch],
                "peer_errors": entry(group, peer)["errors"],
                "errors": entry(group, ours)["errors"],
            }
            for kernel in ("epick", "epeck"):
                cell[kernel + "_ns"] = all_times.get(f"cgal-{kernel}-hits" if task == "decision" else f"cgal-{kernel}")
            row[task] = cell
        out.append(row)
    return out


def nanoseconds(ns):
    return "–" if ns is None else f"{ns:,.0f} ns" if ns >= 9.95 else f"{ns:.1f} ns"


def times_ratio(a, b):
    return "–" if a is None or b is None else f"{a / b:.2f} ×"


def share(part, whole):
    if part == 0:
        return "none"
    percent = 100 * part / whole
    return f"{percent:.0f} %" if percent >= 9.95 else f"{percent:.2g} %"


def ulps(text):
    value = float(text)
    if value == float("inf"):
        return "∞"
    return f"{value:.2g}" if value < 100 else f"{value:,.0f}" if value < 1e5 else f"{value:.1e}"


def markdown(results, form="double"):
    """The summary table, as the documents show it."""
    lines = [
        "| queries | mix | fastest inexact decision | graze `hits` | | EPICK | fastest inexact answer | graze `intersect` | | wrong, worst t of the inexact |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows(results):
        if row["format"] != form:
            continue
        d, n = row["decision"], row["numbers"]
        errors = n["peer_errors"]
        lines.append(
            "| "
            + " | ".join(
                [
                    row["shape"] + "s",
                    row["mix"],
                    nanoseconds(d["peer_ns"]),
                    nanoseconds(d["ns"]),
                    times_ratio(d["ns"], d["peer_ns"]),
                    nanoseconds(d["epick_ns"]),
                    nanoseconds(n["peer_ns"]),
                    nanoseconds(n["ns"]),
                    times_ratio(n["ns"], n["peer_ns"]),
                    f"{share(errors['wrong'], errors['queries'])}, {ulps(errors['max_ulps']) if errors['values'] else '–'} ulps",
                ]
            )
            + " |"
        )
    return "\n".join(lines)
