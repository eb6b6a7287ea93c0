"""compare and the statistics under it, on made-up runs with noise like a shared machine's: a few per cent of jitter, now and then
a repetition that takes up to twice as long, and a run that is slower as a whole."""
import copy
import importlib.machinery
import importlib.util
import json
import os
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import rounds  # noqa: E402

COMPARE = os.path.join(sys.argv[1], "compare")
SPEC = importlib.util.spec_from_loader("compare", importlib.machinery.SourceFileLoader("compare", COMPARE))
compare_module = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(compare_module)
SEEDS = 20


def noisy(source, ns, repetitions):
    out = []
    for _ in range(repetitions):
        time = ns * source.lognormvariate(0, 0.04)
        if source.random() < 0.1:
            time *= source.uniform(1.1, 2)
        out.append(time)
    return out


def run(source, slowed=1.0, repetitions=11):
    """12 measurements, half of them ours, of which the first is slowed down."""
    machine = source.uniform(0.9, 1.15)
    entries = []
    for i in range(12):
        ns = machine * (10 + 17 * i) * (slowed if i == 0 else 1)
        entries.append(
            {
                "name": f"entry-{i}",
                "ours": i < 6,
                "rounds": noisy(source, ns, repetitions),
                "errors": {"queries": 100, "wrong": 0, "values": 50, "correct": 50 if i < 6 else 20},
            }
        )
    return {"time_error": [{"shape": "sphere", "format": "double", "mix": "made-up", "entries": entries}]}


def changed(old, new):
    """The names of what changed, with the options' defaults."""
    by_key = [{("sphere", e["name"]): e for e in results["time_error"][0]["entries"]} for results in (old, new)]
    return {(key[1], ratio > 1) for key, ratio, _ in compare_module.changes(*by_key, 0.1, 0.1)}


def compare(folder, old, new):
    paths = []
    for name, results in (("old.json", old), ("new.json", new)):
        paths.append(os.path.join(folder, name))
        with open(paths[-1], "w", encoding="utf-8") as file:
            json.dump(results, file)
    return subprocess.run([sys.executable, COMPARE] + paths, capture_output=True, text=True, check=False)


def check(condition, what):
    if not condition:
        print("FAILED:", what)
        sys.exit(1)


def main():
    caught = quiet = 0
    for seed in range(SEEDS):
        source = random.Random(seed)
        old = run(source)
        caught += ("entry-0", True) in changed(old, run(source, slowed=1.2))
        quiet += not changed(old, run(source))
    with tempfile.TemporaryDirectory() as folder:
        source = random.Random(SEEDS)
        old, slow = run(source), run(source, slowed=1.3)
        result = compare(folder, old, slow)
        check(result.returncode == 1 and result.stdout.startswith("SLOWER") and "entry-0 " in result.stdout, "a slow-down is told")
        check(compare(folder, old, old).returncode == 0, "nothing changed")
        old = run(random.Random(99))
        wrong = copy.deepcopy(old)
        wrong["time_error"][0]["entries"][3]["errors"]["wrong"] = 1
        result = compare(folder, old, wrong)
        check(
            result.returncode == 1 and "WRONGER  graze  sphere double made-up entry-3" in result.stdout, "a wrong decision is told"
        )
        missing = subprocess.run(
            [sys.executable, COMPARE, os.path.join(folder, "none"), COMPARE], capture_output=True, text=True, check=False
        )
        check(missing.returncode == 2 and "cannot be read" in missing.stderr, "a missing file is refused")
        strange = subprocess.run([sys.executable, COMPARE, COMPARE, COMPARE], capture_output=True, text=True, check=False)
        check(strange.returncode == 2 and "is no result" in strange.stderr, "a strange file is refused")
    print(f"a slow-down of 20 %: {caught} of {SEEDS} caught; no change: {quiet} of {SEEDS} quiet")
    check(caught >= SEEDS - 1, "a slow-down of 20 % is caught in 19 of 20")
    check(quiet >= SEEDS - 1, "no change is quiet in 19 of 20")
    check(rounds.doubt([1, 2, 3, 4, 5], [6, 7, 8, 9, 10]) == 0, "samples that do not overlap leave no doubt")
    check(rounds.doubt([1, 1, 1], [1, 1, 1]) == 1, "equal samples leave nothing but doubt")
    check(rounds.doubt([1, 2, 3, 4], [2, 3, 1, 4]) > 0.3, "a shuffled sample is in doubt")
    check(rounds.spread([1, 2, 3, 4, 5]) == (2, 4) and rounds.median([3, 1, 2]) == 2, "quartiles and median")


main()
