#!/usr/bin/env python3
"""Fails on an include that breaks the rules of src/README.md, a cycle of includes, or a library outside its rooms.

Usage: include_rules.py [--self-test] [ROOT]
"""
import pathlib
import re
import sys
import tempfile

# The folders of code. For each room, the rooms or single headers (doors) that it may include.
FOLDERS = {"src": None, "partition": "partition", "io": "io", "tests": "tests"}
SEES = {
    "core": [],
    "physics": ["core"],
    "topology": ["core", "physics/events.hpp"],
    "geometry": ["core", "physics/evolution.hpp", "topology", "partition/communicator.hpp"],
    "partition": ["core"],
    "io": ["core", "physics/events.hpp", "physics/evolution.hpp", "geometry/mesh.hpp", "partition/communicator.hpp"],
    "simulation": ["core", "physics", "topology", "geometry", "partition", "io"],
    "main": ["core", "simulation", "partition/session.hpp"],
    "tests": ["core", "physics", "topology", "geometry", "partition", "io", "simulation"],
}

TEST_FOLDERS = ["fuzz", "support", "unit"]  # folders whose headers tests share

# Each outside library by the beginning of its headers' paths, and the rooms that may include it; tests may include any.
LIBRARIES = {
    "mpi.h": ["partition", "io"],
    "petsc": ["partition"],
    "metis.h": ["partition"],
    "hdf5.h": ["io"],
    "H5": ["io"],
    "yaml-cpp/": ["io"],
    "muParser": ["io"],
    "pugixml": ["io"],
    "nlohmann/": ["io"],
    "spdlog/": ["io"],
    "CLI/": ["simulation"],
    "Eigen/": ["physics"],
    "hwy/": ["physics"],
    "gtest/": [],
    "gmock/": [],
    "benchmark/": [],
    "CGAL/": [],
}
SYSTEM = re.compile(r"(sys/\w+|unistd|fcntl|[exp]?mmintrin)\.h$")
STANDARD = re.compile(r"[a-z_0-9]+$")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sources(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".hpp", ".cpp", ".h", ".inl"):
                yield path


def room_of(root, path):
    parts = path.relative_to(root).parts
    if parts[0] != "src":
        return FOLDERS[parts[0]]
    return parts[1] if len(parts) > 2 else path.stem


def name_of(root, path):
    """The path by which other files include this file: relative to src/, tests/ or the root."""
    relative = path.relative_to(root)
    return (relative.relative_to(relative.parts[0]) if relative.parts[0] in ("src", "tests") else relative).as_posix()


def includes(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found.group(1) == "<", found.group(2)


def wrong_quoted(room, target):
    target_room = target.split("/")[0] if "/" in target else None
    if room == "tests" and target_room in TEST_FOLDERS:
        return None
    if target_room not in SEES:
        return "the path does not begin with a room's name"
    if room == target_room or target_room in SEES[room] or target in SEES[room]:
        return None
    doors = [door for door in SEES[room] if door.startswith(target_room + "/")]
    return f"{room} sees of {target_room} " + (f"only {', '.join(doors)}" if doors else "nothing")


def wrong_library(room, target):
    if STANDARD.match(target) or SYSTEM.match(target):
        return None
    for beginning, rooms in LIBRARIES.items():
        if target.startswith(beginning):
            allowed = room == "tests" or room in rooms
            return None if allowed else f"this library is named in {', '.join(rooms) or 'tests'} only"
    return "unknown library: give it a room in tests/include_rules.py, or include a file of the project with quotes"


def cycles(graph):
    """Each cycle of includes, once, as the list of its files."""
    found, state, stack = [], {}, []

    def visit(node):
        state[node] = "open"
        stack.append(node)
        for target in graph.get(node, []):
            if state.get(target) == "open":
                found.append(stack[stack.index(target):] + [target])
            elif target in graph and target not in state:
                visit(target)
        stack.pop()
        state[node] = "done"

    for node in sorted(graph):
        if node not in state:
            visit(node)
    return found


def violations(root):
    result, graph = [], {}
    for path in sources(root):
        room, place = room_of(root, path), path.relative_to(root)
        if room not in SEES:
            result.append(f"{place}: '{room}' is not a room that tests/include_rules.py knows")
            continue
        targets = graph.setdefault(name_of(root, path), [])
        for line, angled, target in includes(path):
            problem = wrong_library(room, target) if angled else wrong_quoted(room, target)
            if problem:
                result.append(f"{place}:{line}: includes {target}: {problem}")
            if not angled:
                targets.append(target.removeprefix("tests/"))
    result += ["cycle of includes: " + " -> ".join(cycle) for cycle in cycles(graph)]
    return result


GOOD = {
    "src/core/ids.hpp": "#include <cstdint>\n",
    "src/physics/events.hpp": '#include "core/ids.hpp"\n',
    "src/physics/state.hpp": '#include <Eigen/Core>\n#include <hwy/highway.h>\n#include "physics/events.hpp"\n',
    "src/topology/gmap.hpp": '#include "physics/events.hpp"\n',
    "src/geometry/mesh.hpp": '#include "topology/gmap.hpp"\n#include "partition/communicator.hpp"\n',
    "partition/communicator.hpp": "#include <mpi.h>\n#include <sys/resource.h>\n",
    "io/writer.hpp": '#include <hdf5.h>\n#include "geometry/mesh.hpp"\n#include "io/handle.hpp"\n',
    "src/simulation/run.hpp": '#include <CLI/CLI.hpp>\n#include "topology/gmap.hpp"\n',
    "src/main.cpp": '#include "simulation/run.hpp"\n#include "partition/session.hpp"\n',
    "tests/unit/core/ids_test.cpp": '#include <gtest/gtest.h>\n#include "core/ids.hpp"\n#include "support/a.hpp"\n',
}
PLANTED = [
    ("src/core/up.hpp", '#include "physics/events.hpp"\n', "core sees of physics nothing"),
    ("src/physics/down.hpp", '#include "topology/gmap.hpp"\n', "physics sees of topology nothing"),
    ("src/topology/state.cpp", '#include "physics/state.hpp"\n', "topology sees of physics only physics/events.hpp"),
    ("src/geometry/events.cpp", '  #  include "physics/events.hpp"\n', "only physics/evolution.hpp"),
    ("partition/physics.cpp", '#include "physics/events.hpp"\n', "partition sees of physics nothing"),
    ("io/map.cpp", '#include "topology/gmap.hpp"\n', "io sees of topology nothing"),
    ("io/plan.cpp", '#include "partition/session.hpp"\n', "only partition/communicator.hpp"),
    ("src/main.cpp", '#include "topology/gmap.hpp"\n', "main sees of topology nothing"),
    ("io/test.cpp", '#include "support/a.hpp"\n', "does not begin with a room's name"),
    ("io/bare.cpp", '#include "handle.hpp"\n', "does not begin with a room's name"),
    ("src/physics/mpi.cpp", "#include <mpi.h>\n", "named in partition, io only"),
    ("src/simulation/hdf5.cpp", "#include <hdf5.h>\n", "named in io only"),
    ("io/eigen.cpp", "#include <Eigen/Dense>\n", "named in physics only"),
    ("src/core/gtest.cpp", "#include <gtest/gtest.h>\n", "named in tests only"),
    ("io/boost.cpp", "#include <boost/graph.hpp>\n", "unknown library"),
    ("src/gpu/kernel.cpp", "#include <vector>\n", "'gpu' is not a room"),
    ("src/core/ids.hpp", '#include "core/ids.hpp"\n', "cycle of includes: core/ids.hpp -> core/ids.hpp"),
    ("src/physics/events.hpp", '#include "physics/state.hpp"\n', "cycle of includes"),
]


def found_in(files):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        return violations(root)


def self_test():
    wrong = [f"a tree without violations gives: {found}" for found in found_in(GOOD)]
    for name, text, expected in PLANTED:
        found = found_in({**GOOD, name: text})
        if len(found) != 1 or expected not in found[0]:
            wrong.append(f"{name} with {text.strip()}: expected one violation with '{expected}', found {found}")
    return wrong


def main(arguments):
    testing = "--self-test" in arguments
    roots = [argument for argument in arguments if argument != "--self-test"]
    root = pathlib.Path(roots[0]) if roots else pathlib.Path(__file__).resolve().parent.parent
    problems = self_test() if testing else violations(root)
    print("\n".join(problems) if problems else "include rules: every planted violation is found" if testing
          else f"include rules: {sum(1 for _ in sources(root))} files follow them")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
