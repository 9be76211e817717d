#!/usr/bin/env python3
"""Exit codes, messages and files of runs that are refused or become invalid, and of options that run nothing."""
import math
import os
import subprocess
import time

from runner import ENVIRONMENT, check, cracking_scene, dataset, last_frame, main, summary

SCENE = """\
block: {entity: hexahedron, cells: [4, 4, 2], edge: 0.01}
material: {model: paper, young: 2.0e4, density: 1000, damping: 0.2}
sensors:
  kind: normal
  threshold: 0.02
time: {end: 0.01}
"""

# The fault, the setting that causes it, and the words that the message must have besides the file's name.
WRONG_SCENES = [
    ("an unknown key", ("  threshold: 0.02", "  treshold: 0.02"), [":5:3", "treshold", "threshold"]),
    ("an unknown section", ("time:", "tiem:"), [":6:1", "tiem", "time"]),
    ("a missing section", ("block: {entity: hexahedron, cells: [4, 4, 2], edge: 0.01}\n", ""), ["block"]),
    ("a text for a number", ("edge: 0.01", "edge: small"), [":1:", "edge"]),
    ("no entity along x", ("[4, 4, 2]", "[0, 4, 2]"), [":1:", "cells"]),
    ("two numbers of cells", ("[4, 4, 2]", "[4, 4]"), [":1:", "cells"]),
    ("a negative edge", ("edge: 0.01", "edge: -0.01"), [":1:", "edge"]),
    ("an unknown entity", ("hexahedron", "dodecahedron"), [":1:", "entity", "hexahedron"]),
    ("another Poisson's ratio", ("damping: 0.2", "damping: 0.2, poisson: 0.3"), [":2:", "poisson", "0.25"]),
    ("a material on a box that is no cube", ("edge: 0.01", "edge: [0.01, 0.02, 0.01]"), [":2:", "material"]),
    ("an expression that cannot be read", ("threshold: 0.02", 'threshold: "0.02*(1+q)"'), [":5:", "threshold", "q"]),
    ("a threshold that is negative somewhere", ("threshold: 0.02", 'threshold: "x-0.02"'), ["threshold"]),
    ("a step above the bound", ("{end: 0.01}", "{end: 0.01, step: 0.1}"), [":6:", "step", "allow_unstable"]),
    ("an unknown scheme", ("{end: 0.01}", "{end: 0.01, scheme: rk5}"), [":6:", "scheme", "cordis"]),
    ("YAML that ends too early", ("[4, 4, 2]", "[4, 4, 2"), [":"]),
]
WRONG_COMMANDS = [
    ("an unknown option", ["--ot", "there"], ["--ot"]),
    ("a key of --set that does not exist", ["--set", "coat.raet=3"], ["coat.raet", "rate"]),
    ("a value of --set of the wrong kind", ["--set", "coat.rate=often"], ["coat.rate", "often"]),
]


def contents(workplace):
    return sorted(path.relative_to(workplace.path) for path in workplace.path.rglob("*"))


def message_lines(done, word):
    return [line for line in (done.stdout + done.stderr).splitlines() if word in line]


def refused(workplace, what, names, *arguments, ranks=2):
    """Checks that a run returns 2, writes nothing, and prints one message, from one rank, with the given names."""
    before = contents(workplace)
    done = workplace.run(*arguments, ranks=ranks)
    said = f"{what}: {' '.join(done.args)} said\n{done.stdout}{done.stderr}"
    check(done.returncode == 2, f"the exit code is {done.returncode}, not 2; {said}")
    check(contents(workplace) == before, f"files were written; {said}")
    text = done.stdout + done.stderr
    for name in names:
        check(name in text, f"the message does not name '{name}'; {said}")
    check(len(message_lines(done, names[0])) == 1, f"the message does not come once, from one rank; {said}")


def wrong_scenes_return_2(workplace, quick):
    for what, (right, wrong), names in WRONG_SCENES[:4 if quick else None]:
        check(right in SCENE, f"{what}: '{right}' is not in the scene")
        scene = workplace.write(SCENE.replace(right, wrong, 1))
        refused(workplace, what, [scene.name, *names], scene)


def wrong_commands_return_2(workplace, quick):
    del quick
    scene = workplace.write(SCENE)
    for what, arguments, names in WRONG_COMMANDS:
        refused(workplace, what, names, scene, *arguments)
    refused(workplace, "a scene that does not exist", ["absent.yaml"], "absent.yaml")
    refused(workplace, "no scene", ["INPUT"])


def foreign_directory_is_refused(workplace, quick):
    del quick
    scene = workplace.write(SCENE)
    foreign = workplace.path / "papers"
    foreign.mkdir()
    (foreign / "thesis.txt").write_text("years of work", encoding="utf-8")
    refused(workplace, "a directory of others", ["papers"], scene, "--out", foreign)
    check((foreign / "thesis.txt").read_text(encoding="utf-8") == "years of work", "a foreign file was changed")


def old_run_goes_only_for_a_valid_one(workplace, quick):
    del quick
    directory = workplace.finished(SCENE)
    old = (directory / "summary.json").read_bytes()
    broken = workplace.write(SCENE.replace("threshold", "treshold"), "broken.yaml")
    refused(workplace, "an old run, a wrong scene", ["broken.yaml"], broken, "--out", directory)
    check((directory / "summary.json").read_bytes() == old, "the old summary.json was touched for a wrong scene")
    done = workplace.run(workplace.write(SCENE), "--out", directory)
    check(done.returncode == 0, f"a second run into its own directory returned {done.returncode}\n{done.stderr}")


def two_runs_do_not_share_a_directory(workplace, quick):
    del quick
    long_scene = workplace.write(cracking_scene(time={"end": 1000}), "long.yaml")
    directory = workplace.path / "shared"
    with subprocess.Popen(["mpirun", "-n", "1", workplace.binary, long_scene, "--out", directory],
                          env={**os.environ, **ENVIRONMENT}, stdout=subprocess.DEVNULL) as first:
        try:
            for _ in range(300):
                if (directory / "history.csv").exists():
                    break
                time.sleep(0.1)
            second = workplace.run(workplace.write(SCENE), "--out", directory, ranks=2)
        finally:
            first.terminate()
    check(second.returncode == 2, f"the second run returned {second.returncode}, not 2\n{second.stdout}{second.stderr}")
    check("another run is writing" in second.stderr, f"the message does not say why:\n{second.stderr}")
    check((directory / "history.csv").exists(), "the second run removed files of the first")


def block_beyond_the_memory_is_refused(workplace, quick):
    if quick:
        return  # the sanitizers need the whole address space
    scene = workplace.write(SCENE.replace("[4, 4, 2]", "[400, 300, 100]"))
    for ranks in (1, 2):
        done = workplace.run("--as=2000000000", workplace.binary, scene, ranks=ranks, binary="prlimit")
        check(done.returncode == 2, f"the exit code is {done.returncode}, not 2\n{done.stdout}{done.stderr}")
        check(len(message_lines(done, "12000000 entities need about")) == 1, f"the message is:\n{done.stderr}")


def support_may_start_with_infinite_acceleration(workplace, quick):
    del quick
    scene = cracking_scene(supports=[{"name": "pull", "where": {"box": [[0.075, -1, -1], [1, 1, 1]]},
                                      "velocity": ["sqrt(t)", 0, 0]}], time={"end": 0.02, "scheme": "ab2"})
    workplace.finished(scene, ranks=2)


def dry_run_writes_nothing(workplace, quick):
    del quick
    scene = workplace.write(SCENE)
    before = contents(workplace)
    done = workplace.run(scene, "--dry-run", ranks=2)
    check(done.returncode == 0, f"--dry-run returned {done.returncode}\n{done.stdout}{done.stderr}")
    check(contents(workplace) == before, "--dry-run wrote files")


def help_and_version_return_0(workplace, quick):
    del quick
    for option, word in (("--help", "--dry-run"), ("--version", "cracksim")):
        done = workplace.run(option, ranks=2)
        check(done.returncode == 0, f"{option} returned {done.returncode}\n{done.stdout}{done.stderr}")
        check(len(message_lines(done, word)) >= 1, f"{option} does not say '{word}':\n{done.stdout}")
    check(len(message_lines(done, "cracksim")) == 1, f"--version is said by more than one rank:\n{done.stdout}")
    check(contents(workplace) == [], "--help or --version wrote files")


def default_directory_is_the_stem_of_the_input(workplace, quick):
    del quick
    done = workplace.run(workplace.write(SCENE, "plate.yaml"))
    check(done.returncode == 0, f"the run returned {done.returncode}\n{done.stdout}{done.stderr}")
    check((workplace.path / "plate.out" / "summary.json").exists(), f"no plate.out/summary.json: {contents(workplace)}")


def unstable_run_returns_3(workplace, quick):
    intact = {"threshold": math.inf}
    kick = {"velocity": ["0.01*sin(300*x+200*y)", "0.01*sin(250*z)", 0]}
    stable = cracking_scene(sensors=intact, initial=kick)
    bound = summary(workplace.finished(stable))["time"]["bound"]
    step = 3 * bound
    scene = cracking_scene(sensors=intact, initial=kick, output={"rate": 0.2 / step, "surface": True},
                           time={"end": 20000 * step, "step": step, "allow_unstable": True})
    for ranks in (2,) if quick else (1, 2, 3):
        directory = workplace.path / f"unstable-{ranks}"
        done = workplace.run(workplace.write(scene), "--out", directory, "--audit", ranks=ranks)
        said = f"on {ranks} ranks:\n{done.stdout}{done.stderr}"
        check(done.returncode == 3, f"the exit code is {done.returncode}, not 3; {said}")
        for word in ("step", "mass", "bound"):
            check(word in done.stdout + done.stderr, f"the message does not name '{word}'; {said}")
        found = summary(directory)
        check(found["status"] == "invalid", "the status in summary.json is not 'invalid'")
        check(found["time"]["steps"] == found["invalid"]["step"],
              f"the last step is not the invalid one: {found['time']}")
        check(found["state_hash"] is None, "a state that depends on the ranks has a hash")
        frame = last_frame(directory, "surface")
        subprocess.run(["h5ls", "-r", str(frame)], check=True, stdout=subprocess.DEVNULL)
        points = dataset(frame, "/VTKHDF/Points")
        check(points and all(map(math.isfinite, points)), f"{frame.name} has points that are not finite")
        check(not list(directory.rglob("*.tmp")), "unfinished files were left")


if __name__ == "__main__":
    main([wrong_scenes_return_2, wrong_commands_return_2, foreign_directory_is_refused,
          old_run_goes_only_for_a_valid_one, two_runs_do_not_share_a_directory, block_beyond_the_memory_is_refused,
          support_may_start_with_infinite_acceleration, dry_run_writes_nothing, help_and_version_return_0,
          default_directory_is_the_stem_of_the_input, unstable_run_returns_3])
