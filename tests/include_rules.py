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
    "geometry": ["core", "physics/evolution.hpp", "topology"],
    "partition": ["core"],
    "io": ["core", "physics/events.hpp", "geometry/mesh.hpp", "partition/communicator.hpp"],
    "scene": ["core", "physics", "topology/face_link.hpp", "partition", "io"],
    "dynamics": ["core", "physics", "partition", "scene"],
    "surface": ["core", "physics", "topology", "geometry", "partition", "io", "dynamics"],
    "forecast": ["core", "physics", "topology", "partition", "io", "scene", "dynamics", "surface"],
    "simulation": ["core", "physics", "partition", "io", "scene", "dynamics", "surface", "forecast"],
    "main": ["core", "simulation", "partition/session.hpp"],
    "tests": ["core", "physics", "topology", "geometry", "partition", "io", "scene", "dynamics", "surface", "forecast",
              "simulation"],
}

# Inside a room that has folders: the folders and headers of the room that each folder, and each file beside them, may
# include.
INSIDE = {
    "physics/interaction": [],
    "physics/problem": ["physics/interaction"],
    "physics/state": ["physics/events", "physics/problem"],
    "physics/measure": [],
    "physics/engine": ["physics/problem", "physics/state", "physics/measure"],
    "physics/events": [],
    "physics/evolution": [],
    "physics/standard_law": ["physics/problem"],
    "physics/simd_target": [],
    "physics/start": ["physics/problem", "physics/state", "physics/engine"],
    "physics/fracture": ["physics/problem", "physics/state", "physics/engine", "physics/events"],
    "physics/lattice": ["physics/problem", "physics/state", "physics/measure", "physics/engine", "physics/fracture"],
    "physics/standard": ["physics/measure", "physics/engine", "physics/fracture", "physics/lattice"],
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
    "unsupported/Eigen/": ["physics"],
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


def part_of(name):
    """The folder of a room, or the file without its extension beside the folders, to which a file belongs."""
    return "/".join(name.split("/")[:2]).split(".")[0].removesuffix("-inl")


def wrong_inside(place, target):
    part, other = part_of(place), part_of(target)
    if part not in INSIDE or part == other or other in INSIDE[part]:
        return None
    return f"{part} sees inside its room only {', '.join(INSIDE[part]) or 'itself'}"


def wrong_quoted(room, place, target):
    target_room = target.split("/")[0] if "/" in target else None
    if room == "tests" and target_room in TEST_FOLDERS:
        return None
    if target_room not in SEES:
        return "the path does not begin with a room's name"
    if room == target_room:
        return wrong_inside(place, target)
    if target_room in SEES[room] or target in SEES[room]:
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


def component_of(name):
    """A header and its source are one component: a source closes a cycle as much as a header does."""
    return name.rsplit(".", 1)[0]


def cycles(graph):
    """Each cycle of includes between components, once, as the list of its components."""
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
        targets = graph.setdefault(component_of(name_of(root, path)), [])
        for line, angled, target in includes(path):
            problem = wrong_library(room, target) if angled else wrong_quoted(room, name_of(root, path), target)
            if problem:
                result.append(f"{place}:{line}: includes {target}: {problem}")
            if not angled:
                other = component_of(target.removeprefix("tests/"))
                if other != component_of(name_of(root, path)) or target == name_of(root, path):
                    targets.append(other)
    result += ["cycle of includes: " + " -> ".join(cycle) for cycle in cycles(graph)]
    return result


def unused_rules(root):
    """Rules that no include of the tree needs."""
    used = set()
    for path in sources(root):
        room, name = room_of(root, path), name_of(root, path)
        for _, angled, target in includes(path):
            if not angled:
                used |= {(room, target.split("/")[0]), (room, target), (part_of(name), part_of(target))}
    rules = [(room, seen) for table in (SEES, INSIDE) for room, all_seen in table.items() for seen in all_seen]
    return [f"no file of {room} includes {seen}: remove the rule" for room, seen in rules if (room, seen) not in used]


GOOD = {
    "src/core/ids.hpp": "#include <cstdint>\n",
    "src/physics/events.hpp": '#include "core/ids.hpp"\n',
    "src/physics/engine.hpp": '#include "physics/state/state.hpp"\n',
    "src/physics/problem/network.hpp": '#include <Eigen/Core>\n#include "core/ids.hpp"\n',
    "src/physics/state/state.hpp": '#include "physics/events.hpp"\n#include "physics/problem/network.hpp"\n',
    "src/physics/state/state.cpp": '#include "physics/state/state.hpp"\n',
    "src/physics/lattice/sweep.hpp": '#include <hwy/highway.h>\n#include "physics/state/state.hpp"\n',
    "src/topology/gmap.hpp": '#include "physics/events.hpp"\n',
    "src/geometry/mesh.hpp": '#include "topology/gmap.hpp"\n',
    "partition/communicator.hpp": "#include <mpi.h>\n#include <sys/resource.h>\n",
    "io/writer.hpp": '#include <hdf5.h>\n#include "geometry/mesh.hpp"\n#include "io/handle.hpp"\n',
    "src/simulation/run.hpp": '#include <CLI/CLI.hpp>\n#include "dynamics/dynamics.hpp"\n',
    "src/main.cpp": '#include "simulation/run.hpp"\n#include "partition/session.hpp"\n',
    "tests/unit/core/ids_test.cpp": '#include <gtest/gtest.h>\n#include "core/ids.hpp"\n#include "support/a.hpp"\n',
}
PLANTED = [
    ("src/core/up.hpp", '#include "physics/events.hpp"\n', "core sees of physics nothing"),
    ("src/physics/down.hpp", '#include "topology/gmap.hpp"\n', "physics sees of topology nothing"),
    ("src/physics/state/up.cpp", '#include "physics/lattice/sweep.hpp"\n', "physics/state sees inside its room only"),
    ("src/physics/problem/up.hpp", '#include "physics/engine.hpp"\n', "physics/problem sees inside its room only"),
    ("src/physics/state/a.cpp", '#include "physics/engine.hpp"\n', "physics/state sees inside its room only"),
    ("src/topology/state.cpp", '#include "physics/state/state.hpp"\n',
     "topology sees of physics only physics/events.hpp"),
    ("src/geometry/events.cpp", '  #  include "physics/events.hpp"\n', "only physics/evolution.hpp"),
    ("src/scene/map.cpp", '#include "topology/gmap.hpp"\n', "scene sees of topology only topology/face_link.hpp"),
    ("src/dynamics/frame.cpp", '#include "io/writer.hpp"\n', "dynamics sees of io nothing"),
    ("src/forecast/run.cpp", '#include "simulation/run.hpp"\n', "forecast sees of simulation nothing"),
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
    ("src/core/ids.hpp", '#include "core/ids.hpp"\n', "cycle of includes: core/ids -> core/ids"),
    ("src/topology/gmap.hpp", '#include "topology/a.hpp"\n#include "physics/events.hpp"\n'
     '#include "topology/gmap.hpp"\n', "cycle of includes: topology/gmap -> topology/gmap"),
    ("src/core/ids.cpp", '#include "core/a.hpp"\n#include "core/ids.hpp"\n', None),
    ("io/writer.cpp", '#include "io/reader.hpp"\n', None),
]
# Two files that close a cycle only together: a source includes a header whose own header includes the source's header.
CYCLE_OF_COMPONENTS = {
    "io/reader.hpp": '#include "io/writer.hpp"\n',
    "io/writer.cpp": '#include "io/writer.hpp"\n#include "io/reader.hpp"\n',
}


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
        if found if expected is None else len(found) != 1 or expected not in found[0]:
            wrong.append(f"{name} with {text.strip()}: expected one violation with '{expected}', found {found}")
    found = found_in({**GOOD, **CYCLE_OF_COMPONENTS})
    if found != ["cycle of includes: io/reader -> io/writer -> io/reader"]:
        wrong.append(f"a cycle through a source: found {found}")
    return wrong


def main(arguments):
    testing = "--self-test" in arguments
    roots = [argument for argument in arguments if argument != "--self-test"]
    root = pathlib.Path(roots[0]) if roots else pathlib.Path(__file__).resolve().parent.parent
    problems = self_test() if testing else violations(root) + unused_rules(root)
    print("\n".join(problems) if problems else "include rules: every planted violation is found" if testing
          else f"include rules: {sum(1 for _ in sources(root))} files follow them")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
