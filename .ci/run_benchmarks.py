#!/usr/bin/env python3
"""Runs every Google Benchmark program under a folder and prints one table: run_benchmarks.py FOLDER [FILTER]."""
import json
import pathlib
import subprocess
import sys

KNOWN = {"name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions", "repetition_index", "threads",
         "iterations", "real_time", "cpu_time", "time_unit", "label", "aggregate_name", "aggregate_unit", "big_o", "rms"}
NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}


def in_words(nanoseconds):
    for unit in ("s", "ms", "us"):
        if nanoseconds >= NANOSECONDS[unit]:
            return f"{nanoseconds / NANOSECONDS[unit]:.4g} {unit}"
    return f"{nanoseconds:.4g} ns"


def row(result):
    scale = NANOSECONDS.get(result.get("time_unit", "ns"), 1.0)
    times = [in_words(result[key] * scale) if key in result else "" for key in ("real_time", "cpu_time")]
    counters = [f"{key} {value:.5g}" for key, value in result.items() if key not in KNOWN and isinstance(value, (int, float))]
    return (result["name"], *times, "  ".join(counters + [result.get("label", "")]))


def results(program, pattern):
    """The benchmarks of one program; none when the filter matches none of them."""
    command = [program, f"--benchmark_filter={pattern}"]
    listed = subprocess.run(command + ["--benchmark_list_tests"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    if not listed.strip():
        return []
    print(f"tws: {program.name}", file=sys.stderr)
    done = subprocess.run(command + ["--benchmark_format=json"], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout)["benchmarks"]


def main():
    folder, pattern = pathlib.Path(sys.argv[1]), (sys.argv[2:] + [""])[0] or "."
    rows = [row(result) for program in sorted(folder.glob("*/*_benchmark")) for result in results(program, pattern)]
    if not rows:
        sys.exit(f"tws: no benchmark matches '{pattern}'")
    width = max(len(name) for name, *_ in rows)
    print(f"{'benchmark':{width}} {'time':>12} {'CPU time':>12}  counters")
    for name, real, cpu, counters in rows:
        print(f"{name:{width}} {real:>12} {cpu:>12}  {counters}".rstrip())


if __name__ == "__main__":
    main()
