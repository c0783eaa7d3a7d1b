"""``python -m tests.fuzz --reader ply --inputs 100000 --seed 1 --engine hypothesis``: fuzz one reader and say what came of it.

Engines: ``hypothesis`` damages good files blindly; ``atheris`` (the extra `fuzz`, Linux only) goes by the coverage.
Exit 1 when something was found; the inputs are then in the folder that is named.  An input may take 5 s and 1 GiB.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

_BUNCH, _BUNCHES = 25, 100
"""Inputs in one example, because hypothesis takes longer for an example than most readers do; and examples in one search,
because it remembers all that it has tried."""


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--reader", required=True)
    parser.add_argument("--inputs", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--engine", choices=("hypothesis", "atheris"), default="hypothesis")
    parser.add_argument("--out", help="folder of findings (default: a new one)")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    folder = Path(given.out or tempfile.mkdtemp(prefix="impronta-fuzz-"))
    folder.mkdir(parents=True, exist_ok=True)
    if given.inside:
        {"hypothesis": _hypothesis, "atheris": _atheris}[given.engine](given.reader, given.inputs, given.seed, folder)
        return 0
    command = [sys.executable, "-m", "tests.fuzz", "--inside", "--out", str(folder)]
    command += [f"--{name}={getattr(given, name)}" for name in ("reader", "inputs", "seed", "engine")]
    (folder / "summary.json").unlink(missing_ok=True)
    with (folder / "log").open("wb") as log:
        code = subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, check=False).returncode
    said = (folder / "log").read_text("utf-8", "replace")
    summary = json.loads((folder / "summary.json").read_text()) if (folder / "summary.json").exists() else {"reader": given.reader, "findings": {}}
    edges = re.findall(r"cov: (\d+)", said)
    summary |= {"engine": given.engine, "seed": given.seed, "edges": int(edges[-1]) if edges else None, "exit": code}
    if given.engine == "hypothesis":
        summary["noise_bytes"] = len(said)  # what native code prints by itself
    print(json.dumps(summary))
    bad = bool(code or summary["findings"] or summary.get("inputs", 0) < given.inputs)
    if bad:
        print(f"The inputs and the log are in {folder}.", file=sys.stderr)
    return int(bad)


def _parse_rigs_once(reader: str) -> None:
    """A third of the time of a case goes into its rig, whose text hardly changes and whose reader is fuzzed by itself."""
    if reader.startswith("case"):
        from scanner_core.case import points

        points.parse_rig = lru_cache(8)(points.parse_rig)


def _hypothesis(reader: str, inputs: int, seed: int, folder: Path) -> None:
    import hypothesis
    from hypothesis import HealthCheck, Phase, settings
    from hypothesis import strategies as st

    from tests.fuzz.corpus import dictionary, samples
    from tests.fuzz.damage import damaged_files
    from tests.fuzz.watch import Watch

    bunches = st.lists(damaged_files(samples(reader), dictionary(reader)), min_size=_BUNCH, max_size=_BUNCH)
    _parse_rigs_once(reader)
    watch = Watch(reader, folder)

    def all_of(bunch: list[bytes]) -> None:
        for content in bunch[: inputs - watch.summary.inputs]:
            watch(content)

    while watch.summary.inputs < inputs:
        given = hypothesis.given(bunches)(lambda bunch: all_of(bunch))
        given = hypothesis.seed(seed * 1_000_003 + watch.summary.inputs)(given)
        limits = settings(
            max_examples=_BUNCHES, database=None, deadline=None, derandomize=False, phases=[Phase.generate], suppress_health_check=list(HealthCheck)
        )
        limits(given)()
    watch.write()


def _atheris(reader: str, inputs: int, seed: int, folder: Path) -> None:
    import atheris

    with atheris.instrument_imports(include=["scanner_core", "tomllib", "json"]):
        from tests.fuzz.corpus import dictionary, samples
        from tests.fuzz.watch import Watch

    seeds, words = folder / "seeds", folder / "words"
    seeds.mkdir(exist_ok=True)
    for number, content in enumerate(samples(reader)):
        (seeds / str(number)).write_bytes(content)
    words.write_text("".join('"' + "".join(f"\\x{byte:02x}" for byte in word) + '"\n' for word in dictionary(reader)))
    _parse_rigs_once(reader)
    watch = Watch(reader, folder)

    def one(content: bytes) -> None:
        watch(content)
        if watch.summary.inputs == inputs:
            watch.write()

    limits = [f"-runs={inputs}", f"-seed={seed}", "-max_len=65536", "-timeout=0", "-rss_limit_mb=4096", f"-artifact_prefix={folder}/"]
    # The first folder receives what the fuzzer finds worth keeping.
    (folder / "kept").mkdir(exist_ok=True)
    atheris.Setup([sys.argv[0], *limits, f"-dict={words}", str(folder / "kept"), str(seeds)], one)
    atheris.Fuzz()


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    sys.exit(main())
