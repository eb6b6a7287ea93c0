"""The page: one HTML file that holds all of its pictures and tables."""
from html import escape

from page_parts import STYLE, details, picture, table
from rounds import median, spread
from summary import nanoseconds, rows, share, times_ratio, ulps


def overview(results):
    body = []
    for row in rows(results):
        d, n = row["decision"], row["numbers"]
        errors = n["peer_errors"]
        body.append(
            (
                "",
                [
                    row["shape"],
                    row["format"],
                    row["mix"],
                    nanoseconds(d["peer_ns"]),
                    nanoseconds(d["ns"]),
                    times_ratio(d["ns"], d["peer_ns"]),
                    nanoseconds(d["batch_ns"]),
                    nanoseconds(d["epick_ns"]),
                    times_ratio(d["ns"], d["epick_ns"]),
                    nanoseconds(n["peer_ns"]),
                    nanoseconds(n["ns"]),
                    times_ratio(n["ns"], n["peer_ns"]),
                    nanoseconds(n["epick_ns"]),
                    share(errors["wrong"], errors["queries"]),
                    ulps(errors["max_ulps"]) if errors["values"] else "–",
                ],
            )
        )
    return table(
        [
            "shape",
            "format",
            "mix",
            "fastest inexact decision",
            "graze hits",
            "ratio",
            "graze batch",
            "EPICK",
            "graze / EPICK",
            "fastest inexact answer",
            "graze intersect",
            "ratio",
            "EPICK",
            "the inexact: wrong",
            "its worst t, ulps",
        ],
        body,
        names=3,
    )


def entries_table(groups):
    body = []
    for group in groups:
        for e in group["entries"]:
            errors = e["errors"]
            low, high = spread(e["rounds"])
            has_values = errors["values"] > 0
            body.append(
                (
                    "ours" if e["ours"] else "",
                    [
                        e["name"],
                        group["format"],
                        e["task"],
                        f"{median(e['rounds']):.1f}",
                        f"{low:.1f} … {high:.1f}",
                        share(errors["wrong"], errors["queries"]),
                        share(errors["correct"], errors["values"]) if has_values else "–",
                        *[ulps(errors[k]) if has_values else "–" for k in ("median_ulps", "p999_ulps", "max_ulps")],
                        f"{errors['queries']:,}",
                        (errors.get("worst_case", ""), "case"),
                    ],
                )
            )
    return table(
        [
            "kernel",
            "format",
            "task",
            "ns a query",
            "middle half",
            "wrong",
            "t correctly rounded",
            "median ulps",
            "99.9 %",
            "greatest",
            "judged",
            "the case of the greatest error",
        ],
        body,
    )


def time_error(results, folder):
    groups = {}
    for group in results["time_error"]:
        groups.setdefault((group["shape"], group["mix"]), []).append(group)
    out = [
        "<h2>Time against error</h2><p>One picture a mix. Wrong are decisions that the exact oracle contradicts in any way, but for what a "
        "kernel declares to do otherwise (coplanar rays as misses, say). Errors of t are held against the exact real value, in units of the "
        "last place of the answer's format; a correctly rounded t errs by half a unit at most.</p>"
    ]
    for (shape, mix), pair in groups.items():
        out.append(f"<h3>{escape(shape.capitalize())}s, {escape(pair[0]['title'])}</h3>")
        out.append(picture(folder, f"pareto-{shape}-{mix}", f"time against error, {shape}s, {mix}"))
        out.append(details("all figures", entries_table(pair)))
    return "".join(out)


def stability(results, folder):
    out = [
        "<h2>Stability sweeps</h2><p>One condition a picture, from benign to hopeless. Each line is the greatest error of an answer of the "
        "right kind among random inputs; the points are what hill climbing on the numbers that the input was made of found, for each kernel by "
        "itself. Below, how many of the random inputs were answered wrongly.</p>"
    ]
    for sweep in results.get("stability", []):
        out.append(f"<h3>{escape(sweep['title'])}</h3>" + picture(folder, f"sweep-{sweep['name']}", sweep["title"]))
        body = []
        for line in sweep["lines"]:
            found = [p for p in line["points"] if "hunted_ulps" in p]
            if not found:
                continue
            worst = max(found, key=lambda p: float(p["hunted_ulps"]))
            body.append(
                (
                    "ours" if line["ours"] else "",
                    [
                        line["name"],
                        str(worst["level"]),
                        ulps(worst["max_ulps"]),
                        ulps(worst["hunted_ulps"]),
                        (worst["worst_case"], "case"),
                    ],
                )
            )
        out.append(
            details(
                "the worst case of each kernel",
                table(["kernel", "level", "greatest of random, ulps", "after the hunt", "the case"], body),
            )
        )
    return "".join(out)


def stage_costs(results):
    """(what, ns) from the timed and counted shares."""
    out = []
    for shape in ("triangle", "sphere"):
        groups = {
            g["percent"]: {e["name"]: median(e["rounds"]) for e in g["entries"]}
            for g in results["certainty"]
            if g["shape"] == shape and g["mix"] == "degenerate"
        }
        filter_ns, answer_ns = groups[0]["graze-hits"], groups[0]["graze-intersect"]
        out += [
            (f"{shape}: filter alone (hits, nothing degenerate)", filter_ns),
            (f"{shape}: rounding (what intersect adds to that)", answer_ns - filter_ns),
            (f"{shape}: exact stage, decision (hits, all degenerate, less the filter)", groups[100]["graze-hits"] - filter_ns),
            (
                f"{shape}: exact stage, numbers (intersect, all degenerate, less the filter)",
                groups[100]["graze-intersect"] - filter_ns,
            ),
        ]
    ties = [g for g in results["certainty"] if g["mix"] == "ties"]
    counted = [g for g in results["stages"] if g["mix"] == "ties"]
    if ties and counted:
        ns = {e["name"]: median(e["rounds"]) for e in ties[0]["entries"]}["graze-intersect"]
        tests = counted[0]["intersect"]["midpoint"] / counted[0]["intersect"]["queries"]
        out.append((f"triangle: intersect where t lies halfway between two doubles ({tests:.2f} midpoint tests a query)", ns))
    return out


def certainty(results, folder):
    if "certainty" not in results or "stages" not in results:
        return ""
    out = [
        "<h2>The cost of certainty</h2><p>Every query runs the filter. What it leaves in doubt goes to the exact stage; hits that it "
        "settles are rounded from double-double, and, where that is in doubt, by the exact stage; an exact value that its 64 leading bits do not tell from a "
        "midpoint takes the midpoint test. Counted by the compiler's hooks at every function, in a program that is not timed.</p>"
    ]
    for shape in ("triangle", "sphere"):
        out.append(picture(folder, f"certainty-{shape}", f"cost of certainty, {shape}"))
    out.append(table(["stage", "ns"], [("", [what, f"{ns:.1f}"]) for what, ns in stage_costs(results)]))
    return "".join(out)


def floor(results, folder):
    if "floor" not in results:
        return ""
    peaks = results["floor"]["peaks"]
    body = [
        (
            "",
            [
                f"{l['shape']} {l['name']}",
                l["format"],
                f"{l['operations']:.0f}",
                f"{l['bytes']:.0f}",
                f"{l['floor_ns']:.2f}",
                f"{median(l['rounds']):.2f}",
                f"{100 * l['floor_ns'] / median(l['rounds']):.0f} %",
            ],
        )
        for l in results["floor"]["loops"]
    ]
    return (
        "<h2>The floor</h2><p>What the operations of the filter (a multiply-add is two) and the bytes that it reads take at the machine's peaks, "
        f"measured in the same run: {peaks['double_operations_a_ns']:.0f} operations a ns in double, {peaks['float_operations_a_ns']:.0f} in float, "
        f"{peaks['bytes_a_ns']:.0f} bytes a ns ({escape(peaks['vectors'])}). A single query fills two lanes of a vector, so a share of one is out of its reach.</p>"
        + picture(folder, "floor", "hot loops above their floor")
        + table(["loop", "format", "operations", "bytes", "floor, ns", "ns", "share of the floor"], body)
    )


def scenes(scene_rows, folder):
    if not scene_rows:
        return ""
    body = []
    for row in scene_rows:
        rays = f"{1000 / row['value']:.2f}" if row["unit"] == "ns a ray" else ""
        ratio = f"{row['ratio']:.2f} × {row['to']}" if "to" in row else ""
        body.append(
            (
                "ours" if row["contender"].startswith("graze") else "",
                [
                    row["section"],
                    row["scene"],
                    row["what"],
                    row["contender"],
                    f"{row['triangles']:,}",
                    f"{row['value']:.4g} {row['unit']}",
                    rays,
                    ratio,
                ],
            )
        )
    return (
        "<h2>Scenes</h2><p>Whole scenes beside Embree and CGAL's AABB tree, on the same rays, interleaved; and against the number of triangles.</p>"
        + picture(folder, "scenes", "time a ray against the number of triangles")
        + details(
            "all figures",
            table(["part", "scene", "measured", "kernel", "triangles", "value", "Mrays/s", "as good as"], body, names=4),
        )
    )


def batch_lines(text):
    if not text:
        return ""
    return (
        "<h2>Batches</h2><p>One ray against arrays, for each instruction set, beside scalar loops and what the compiler makes of "
        f"branch-free formulas.</p>{details('all figures', f'<pre>{escape(text)}</pre>')}"
    )


def html(results, scene_rows, batches, folder):
    machine = results["machine"]
    caches = ", ".join(f"L{c['level']} {c['type'][0].lower()} {c['bytes'] // 1024} KiB" for c in machine["caches"])
    facts = (
        f"{machine['processor']}, {machine['cores']} cores ({caches}); {results['compiler']}, {results['flags']}; {results['date']}; seed "
        f"{results['seed']}; medians of {results['repetitions']} repetitions, randomly interleaved, processor time of one thread"
    )
    plan = results["plan"]
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>graze: time against error</title><style>{STYLE}</style></head><body>
<h1>graze: time against error</h1>
<p class="soft">{escape(facts)}</p>
<h2>In one table</h2>
<p>Ratios are of times: below 1 graze is the faster. The inexact are formulas in the input's own precision; the last two columns tell what the fastest of them gets wrong.</p>
{overview(results)}
{time_error(results, folder)}
{stability(results, folder)}
{certainty(results, folder)}
{floor(results, folder)}
{scenes(scene_rows, folder)}
{batch_lines(batches)}
<h2>To repeat</h2>
<pre>./dev bench {escape(plan)}
bench/compare OLD/results.json NEW/results.json   # what got slower, or wronger
echo 'CASE' | build/release/bin/graze answer      # any case of the tables</pre>
<p>All figures are in <a href="results.json">results.json</a>, beside this page, the pictures in <code>pictures/</code> as SVG and PNG.</p>
</body></html>
"""
