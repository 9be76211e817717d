#!/usr/bin/env python3
"""Compares the memory and time to read a scene with very many supports with those of a scene with one."""
import json
import os
import subprocess
import tempfile

from runner import ENVIRONMENT, check, main

MANY = 20_000
MOST_BYTES, MOST_SECONDS = 6000, 2e-4  # room for two formulas and a number; a parser for each took 23 kB


def scene(supports):
    return {"block": {"cells": [2, 2, 2], "edge": 0.01}, "material": {"model": "paper", "young": 2e4, "density": 1000},
            "sensors": {"threshold": 0.02}, "time": {"end": 0.001},
            "supports": [{"where": {"box": [[i, i, i], [i + 1, 1e6, 1e6]]}, "velocity": ["0.1*t", f"sin({i}*t)*x", 0]}
                         for i in range(1, supports + 1)]}


def cost(workplace, supports):
    """The peak of memory in bytes and the CPU time in seconds of a forecast."""
    with tempfile.TemporaryDirectory(prefix="cracksim-mpi-") as sessions:
        alone = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_tmpdir_base": sessions}
        with subprocess.Popen([workplace.binary, workplace.write(json.dumps(scene(supports))), "--dry-run"],
                              cwd=workplace.path, env={**os.environ, **ENVIRONMENT, **alone},
                              stdout=subprocess.DEVNULL) as run:
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
    check(run.returncode == 0, f"{supports} supports: the exit code is {run.returncode}")
    return usage.ru_maxrss * 1024, usage.ru_utime


def many_supports_take_little_each(workplace, quick):
    if quick:
        return  # sanitizers need memory and time themselves
    (many_bytes, many_seconds), (few_bytes, few_seconds) = cost(workplace, MANY), cost(workplace, 1)
    check(many_bytes - few_bytes < MANY * MOST_BYTES, f"{(many_bytes - few_bytes) / MANY:.0f} bytes a support")
    check(many_seconds - few_seconds < MANY * MOST_SECONDS, f"{(many_seconds - few_seconds) / MANY:.1e} s a support")


main([many_supports_take_little_each])
