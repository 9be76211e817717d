#!/usr/bin/env python3
"""Each script of tests/long is independent: it builds every program that it runs by jobs/build.sh beforehand."""
import re

from runner import ROOT, check, main

FOLDERS = {"long": "release"}  # presets whose folder has another name


def programs_run(text):
    """Yields the preset's folder, the name, and the position in the text of every program given by its path."""
    for found in re.finditer(r"build/(\w+)/(?:tests/(?:fuzz/)?)?([\w$]+)", text):
        if found[2] not in ("findings", "grown") and not text[found.end():].startswith((".log", "/")):
            yield found[1], found[2].replace("$target", ""), found.start()


def programs_built(text):
    """Yields the preset's folder, the targets (none: all), and the position in the text of every build."""
    for found in re.finditer(r"^jobs/build\.sh (\w+)([ \w]*)", text, re.MULTILINE):
        yield FOLDERS.get(found[1], found[1]), found[2].split(), found.start()


def is_built_before(text, folder, name, place):
    return any(built == folder and (not targets or name in targets) and start < place
               for built, targets, start in programs_built(text))


def campaigns_build_what_they_run(workplace, quick):
    del workplace, quick
    scripts = sorted((ROOT / "tests/long").glob("*.sh"))
    for script in scripts:
        text = re.sub(r"^\s*#.*$", "", script.read_text(encoding="utf-8"), flags=re.MULTILINE)
        found = list(programs_run(text))
        check(found, f"{script.name} runs nothing")
        for folder, name, place in found:
            check(is_built_before(text, folder, name, place),
                  f"{script.name} runs build/{folder}/.../{name}, but does not build it")
    check(len(scripts) > 3, f"only {scripts} were found")


main([campaigns_build_what_they_run])
