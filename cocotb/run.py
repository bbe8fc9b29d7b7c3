"""Runs the tests of this folder on both cores' AXI tops, in several configurations, under Icarus Verilog.

`make cocotb` calls it with the tools of scripts/python-tools; configurations may be chosen by name.
"""

import os
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from cocotb_tools.runner import get_results, get_runner
from power_up import switched_on

HERE = Path(__file__).resolve().parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", HERE.parent / "target")).resolve() / "cocotb"
SEARCH = ["--points", "surface:60", "--k", "3", "--limit", "24"]
# Near queries one after the other, so that neighborhoods are used again.
COHERENT = [
    "--points",
    "surface:60",
    "--k",
    "6",
    "--radius",
    "0.4",
    "--alpha",
    "2",
    "--order",
    "grid:2x2",
    "--limit",
    "24",
]
# More leaves than the caches hold, and a bus as the configuration says.
SEARCH_KEYS = {
    "features.neighbors": 8,
    "features.tree_depth": 4,
    "features.bucket": 8,
    "features.index_bits": 8,
    "implementation.threads": 4,
    "implementation.lanes": 2,
    "implementation.point_cache": 4,
}
LOG_LINES = 60
POWER_UP_SEED = int(os.environ.get("POINTCORE_SEED", "1"))


@dataclass(frozen=True)
class Configuration:
    """A core on a bus."""

    name: str
    core: str
    stream_bits: int
    memory_bits: int
    # Seeds of what is random; 0 pauses nothing.
    seeds: list[int]
    # Keys of the search core's configuration beside SEARCH_KEYS, and what is searched.
    keys: dict[str, int] = field(default_factory=dict)
    search: list[str] = field(default_factory=lambda: SEARCH)

    @property
    def folder(self) -> Path:
        """Where everything of this configuration is written."""
        return TARGET / self.name

    @property
    def top(self) -> str:
        """The module under test."""
        return f"{self.core}_axi"

    @property
    def tests(self) -> list[str]:
        """The modules with its tests."""
        window = ["test_window"] if self.core == "search" and "implementation.tree_cache" not in self.keys else []
        return ["test_registers", f"test_{self.core}", *window]

    def source(self) -> list[str]:
        """Arguments of `pointcore vectors`."""
        if self.core == "splat":
            overrides = [
                f"overrides.stream_bits={self.stream_bits}",
                f"overrides.memory_bits={self.memory_bits}",
            ]
            return [str(HERE / "scene.toml"), *(f"--set={override}" for override in overrides)]
        lines = ['kind = "search"', *(f"{key} = {value}" for key, value in {**SEARCH_KEYS, **self.keys}.items())]
        lines += ["[bus]", f"stream_bits = {self.stream_bits}", f"memory_bits = {self.memory_bits}"]
        file = self.folder / "search.toml"
        file.write_text("\n".join(lines) + "\n")
        return [*self.search, "--config", str(file)]


CONFIGURATIONS = [
    Configuration("splat", "splat", 64, 64, [0, 1]),
    Configuration("splat_narrow", "splat", 32, 32, [2]),
    Configuration("splat_wide", "splat", 512, 256, [3]),
    Configuration("search", "search", 64, 64, [0, 1, 2]),
    Configuration("search_narrow", "search", 32, 32, [3], {"implementation.lanes": 1, "implementation.threads": 2}),
    Configuration(
        "search_wide", "search", 256, 512, [4], {"implementation.lanes": 4, "implementation.leaves_in_flight": 2}
    ),
    Configuration("search_tree_cache", "search", 128, 128, [5], {"implementation.tree_cache": 16}),
    Configuration("search_neighbor_cache", "search", 64, 64, [6], {"features.neighbor_cache": 4}, COHERENT),
]


def pointcore(*arguments: str | Path) -> None:
    """Runs the command."""
    command = ["cargo", "run", "--quiet", "--bin", "pointcore", "--", *arguments]
    subprocess.run(command, cwd=HERE.parent, check=True, stdout=subprocess.DEVNULL)


def generate(configuration: Configuration) -> None:
    """Writes vectors, and the hardware that they are for."""
    folder = configuration.folder
    folder.mkdir(parents=True, exist_ok=True)
    pointcore("vectors", *configuration.source(), "-o", folder)
    pointcore("gen", folder / "config.toml", "-o", folder / "verilog")


def simulate(configuration: Configuration) -> tuple[int, int, float]:
    """Builds and runs a configuration; returns how many tests passed and failed, and the seconds it took."""
    started = time.monotonic()
    folder = configuration.folder
    sources = []
    for part in ("top", "axi"):
        file = f"{configuration.core}_{part}.v"
        sources.append(folder / file)
        sources[-1].write_text(switched_on((folder / "verilog" / file).read_text(), POWER_UP_SEED))
    runner = get_runner("icarus")
    runner.build(
        sources=sources,
        hdl_toplevel=configuration.top,
        build_dir=folder / "build",
        timescale=("1ns", "1ns"),
        always=True,
        log_file=folder / "build.log",
    )
    results = runner.test(
        hdl_toplevel=configuration.top,
        test_module=configuration.tests,
        build_dir=folder / "build",
        test_dir=folder,
        results_xml=str(folder / "results.xml"),
        # The bus models use names that cocotb is about to drop.
        extra_env={
            "SEEDS": os.environ.get("POINTCORE_SEED", " ".join(map(str, configuration.seeds))),
            "VECTORS": str(folder),
            "PYTHONWARNINGS": "ignore::DeprecationWarning",
        },
        log_file=folder / "test.log",
    )
    count, failed = get_results(results)
    return count - failed, failed, time.monotonic() - started


def main() -> int:
    """Runs the configurations named, or all."""
    names = sys.argv[1:]
    known = [configuration.name for configuration in CONFIGURATIONS]
    if unknown := set(names) - set(known):
        print(
            f"unknown configuration {', '.join(sorted(unknown))}: expected some of {', '.join(known)}", file=sys.stderr
        )
        return 2
    chosen = [configuration for configuration in CONFIGURATIONS if configuration.name in (names or known)]
    for configuration in chosen:
        generate(configuration)
    passed = failed = 0
    with ProcessPoolExecutor(os.cpu_count()) as pool:
        for configuration, (good, bad, seconds) in zip(chosen, pool.map(simulate, chosen)):
            passed, failed = passed + good, failed + bad
            print(f"{configuration.name}: {good} passed, {bad} failed, {seconds:.0f} s", flush=True)
            if bad or not good:
                log = configuration.folder / "test.log"
                print("\n".join(log.read_text().splitlines()[-LOG_LINES:]))
                print(f"The whole log: {log}")
                print(f"Again, with one seed: POINTCORE_SEED=SEED make cocotb CONFIGURATIONS={configuration.name}")
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
