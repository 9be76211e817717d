"""Scenes of a wrong form, each with the complete message that it must cause. To add a case, add a line."""
from typing import NamedTuple

SCENE = """\
title: a block
block: {entity: hexahedron, cells: [4, 4, 2], edge: 0.01, origin: [0, 0, 0]}
material: {young: 2.0e4, density: 1000, poisson: 0.25, damping: 0.2}
duplets: corners
sensors: {kind: normal, threshold: 0.02, weibull: {shape: 8, seed: 1}, prefilter: true}
initial: {displacement: [0, 0, 0], velocity: [0, 0, 0]}
supports:
  - {name: left, where: {box: [[-1, -1, -1], [0.005, 1, 1]]}, velocity: [0, 0, null]}
time: {end: 0.01, step: auto, scheme: cordis, allow_unstable: false}
coat: {rate: 50}
output: {rate: 50, surface: true, crack: true, masses: false, topology: false}
history: {rate: 200}
partition: {kind: metis}
"""
MATERIAL = "material: {young: 2.0e4, density: 1000, poisson: 0.25, damping: 0.2}"
NETWORK = "network: {mass: 1, edge: {stiffness: 4, viscosity: 0.1}, diagonal: {stiffness: 6}}"


class Row(NamedTuple):
    name: str
    right: str  # occurs once in SCENE
    wrong: str  # replaces `right`
    message: str  # follows the name of the file


def scene_with(row):
    assert SCENE.count(row.right) == 1, f"{row.name}: '{row.right}' does not stand in SCENE once"
    return SCENE.replace(row.right, row.wrong)


# Scenes that inputs/scene.schema.json refuses too.
FORM = [
    Row("list for the title", "title: a block", "title: [a, block]", ":1:1: title: needs a text, not a list"),
    Row("empty title", "title: a block", "title:", ":1:1: title: needs a text, not an empty value"),
    Row("unknown section", "history:", "histroy:", ":12:1: histroy: unknown key; did you mean 'history'?"),
    Row("section without values", "coat: {rate: 50}", "coat:",
        ":10:1: coat: needs a map with keys of rate, not an empty value"),
    Row("number for a section", "coat: {rate: 50}", "coat: 50", ":10:7: coat: needs a map with keys of rate, not '50'"),
    Row("list for a section", "history: {rate: 200}", "history: [200]",
        ":12:1: history: needs a map with keys of rate, not a list"),
    Row("no block", SCENE.splitlines()[1] + "\n", "",
        ":1:1: the key 'block' is missing; add it (inputs/README.md lists what it takes)"),
    Row("no time", SCENE.splitlines()[8] + "\n", "",
        ":1:1: the key 'time' is missing; add it (inputs/README.md lists what it takes)"),
    Row("no matter", MATERIAL + "\n", "",
        ":1:1: neither material nor network is given; add `material: {young: ..., density: ...}`"),
    Row("material and network", MATERIAL, MATERIAL + "\n" + NETWORK,
        ":4:1: network: material and network exclude each other; remove one of the two"),
    Row("unknown entity", "hexahedron", "hexaeder",
        ":2:17: block.entity: does not know 'hexaeder'; did you mean 'hexahedron'?"),
    Row("entity that comes later", "hexahedron", "tetrahedron",
        ":2:17: block.entity: not available in cracksim 0.1; 'tetrahedron' comes later; take hexahedron"),
    Row("number for an entity", "entity: hexahedron", "entity: 6",
        ":2:17: block.entity: does not know '6'; take hexahedron"),
    Row("map for an entity", "entity: hexahedron", "entity: {hexahedron: 1}",
        ":2:9: block.entity: needs hexahedron, not a map"),
    Row("key of another section", "edge: 0.01,", "edge: 0.01, rate: 5,",
        ":2:59: block.rate: unknown key; known here are entity, cells, edge, origin"),
    Row("no cells", "cells: [4, 4, 2], ", "",
        ":2:1: block: the key 'cells' is missing; add it (inputs/README.md lists what it takes)"),
    Row("two numbers of cells", "[4, 4, 2]", "[4, 4]", ":2:29: block.cells: needs a list of 3 values, not of 2"),
    Row("one number of cells", "[4, 4, 2]", "32", ":2:36: block.cells: needs a list of 3 values, not '32'"),
    Row("no entity along x", "[4, 4, 2]", "[0, 4, 2]",
        ":2:37: block.cells.0: needs an integer from 1 to 2000000000, not '0'"),
    Row("negative number of cells", "[4, 4, 2]", "[4, 4, -2]",
        ":2:43: block.cells.2: needs an integer from 1 to 2000000000, not '-2'"),
    Row("half a cell", "[4, 4, 2]", "[4, 4, 2.5]",
        ":2:43: block.cells.2: needs an integer from 1 to 2000000000, not '2.5'"),
    Row("cells beyond 64 bits", "[4, 4, 2]", "[99999999999999999999, 4, 2]",
        ":2:37: block.cells.0: needs an integer from 1 to 2000000000, not '99999999999999999999'"),
    Row("text for a length", "edge: 0.01", "edge: small", ":2:53: block.edge: needs a number above 0 m, not 'small'"),
    Row("length with its unit", "edge: 0.01", "edge: 1 cm", ":2:53: block.edge: needs a number above 0 m, not '1 cm'"),
    Row("length with a comma", "edge: 0.01", 'edge: "0,01"',
        ":2:53: block.edge: needs a number above 0 m, not '0,01'; the decimal sign is a point"),
    Row("length in hexadecimal", "edge: 0.01", "edge: x10", ":2:53: block.edge: needs a number above 0 m, not 'x10'"),
    Row("no length", "edge: 0.01", "edge: 0", ":2:53: block.edge: needs a number above 0 m, not '0'"),
    Row("negative length", "edge: 0.01", "edge: -0.01", ":2:53: block.edge: needs a number above 0 m, not '-0.01'"),
    Row("one negative length of three", "edge: 0.01", "edge: [0.01, 0.01, -0.01]",
        ":2:47: block.edge: every edge must be above 0 m and within 1e-60 to 1e60 m, not -0.01"),
    Row("text in the origin", "origin: [0, 0, 0]", "origin: [0, 0, up]",
        ":2:74: block.origin.2: needs a number, not 'up'"),
    Row("no stiffness", "young: 2.0e4", "young: 0", ":3:19: material.young: needs a number above 0 Pa, not '0'"),
    Row("true for a density", "density: 1000", "density: true",
        ":3:35: material.density: needs a number above 0 kg/m3, not 'true'"),
    Row("another Poisson's ratio", "poisson: 0.25", "poisson: 0.3",
        ":3:50: material.poisson: must be 0.25, not '0.3': the network of interactions is isotropic only there"),
    Row("negative damping", "damping: 0.2", "damping: -0.2",
        ":3:65: material.damping: needs a number, 0 a/c0 or above, not '-0.2'"),
    Row("fracture energy of 0", "damping: 0.2", "fracture_energy: 0",
        ":3:73: material.fracture_energy: needs a number above 0 J/m2, not '0'"),
    Row("unknown key of the material", "damping: 0.2", "dampening: 0.2",
        ":3:56: material.dampening: unknown key; did you mean 'damping'?"),
    Row("network without mass", MATERIAL, NETWORK.replace("mass: 1, ", ""),
        ":3:1: network: the key 'mass' is missing; add it (inputs/README.md lists what it takes)"),
    Row("network without diagonal", MATERIAL, "network: {mass: 1, edge: {stiffness: 4}}",
        ":3:1: network: the key 'diagonal' is missing; add it (inputs/README.md lists what it takes)"),
    Row("negative mass", MATERIAL, NETWORK.replace("mass: 1", "mass: -1"),
        ":3:17: network.mass: needs a number above 0 kg, not '-1'"),
    Row("edge without stiffness", MATERIAL, NETWORK.replace("stiffness: 4, ", ""),
        ":3:20: network.edge: the key 'stiffness' is missing; add it (inputs/README.md lists what it takes)"),
    Row("number for an interaction", MATERIAL, NETWORK.replace("{stiffness: 6}", "6"),
        ":3:68: network.diagonal: needs a map with keys of stiffness, viscosity, not '6'"),
    Row("negative viscosity", MATERIAL, NETWORK.replace("0.1", "-0.1"),
        ":3:52: network.edge.viscosity: needs a number, 0 N s/m or above, not '-0.1'"),
    Row("unknown duplets", "corners", "edges", ":4:10: duplets: does not know 'edges'; take one of corners, tree"),
    Row("sensor that comes later", "kind: normal", "kind: wide",
        ":5:17: sensors.kind: not available in cracksim 0.1; 'wide' comes later; take normal"),
    Row("no threshold", "threshold: 0.02, ", "",
        ":5:1: sensors: nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never) or "
        "material.fracture_energy (J/m2)"),
    Row("list for a threshold", "threshold: 0.02", "threshold: [0.02]",
        ":5:25: sensors.threshold: needs a number or an expression, not a list"),
    Row("threshold of 0", "threshold: 0.02", "threshold: 0",
        ":5:36: sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '0'"),
    Row("minus infinity for a threshold", "threshold: 0.02", "threshold: -.inf",
        ":5:36: sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '-.inf'"),
    Row("shape of 0", "shape: 8", "shape: 0",
        ":5:59: sensors.weibull.shape: must be from 0.1 (wide scatter) to 1e6 (none), not '0'"),
    Row("endless shape", "shape: 8", "shape: .inf",
        ":5:59: sensors.weibull.shape: needs a number, not '.inf'; it must be finite"),
    Row("scatter without shape", "shape: 8, ", "",
        ":5:42: sensors.weibull: the key 'shape' is missing; add it (inputs/README.md lists what it takes)"),
    Row("negative seed", "seed: 1", "seed: -1",
        ":5:68: sensors.weibull.seed: needs an integer from 0 to 9223372036854775807, not '-1'"),
    Row("seed beyond 63 bits", "seed: 1", "seed: 9223372036854775808",
        ":5:68: sensors.weibull.seed: needs an integer from 0 to 9223372036854775807, not '9223372036854775808'"),
    Row("yes for true", "prefilter: true", "prefilter: yes",
        ":5:83: sensors.prefilter: needs true or false, not 'yes'"),
    Row("number for a field", "displacement: [0, 0, 0]", "displacement: 0",
        ":6:25: initial.displacement: needs a list of 3 values, not '0'"),
    Row("empty component of a field", "displacement: [0, 0, 0]", "displacement: [0, 0, null]",
        ":6:32: initial.displacement.2: needs a number or an expression, not an empty value"),
    Row("expression taken apart by its commas", "displacement: [0, 0, 0]", "displacement: [max(x, y), 0, 0]",
        ":6:11: initial.displacement: needs a list of 3 values, not of 4; put an expression that holds commas in "
        "quotes"),
    Row("map for the supports", "  - {name", "  {name", ":7:1: supports: needs a list, not a map"),
    Row("support without a place", "where: {box: [[-1, -1, -1], [0.005, 1, 1]]}, ", "",
        ":8:5: supports.0: the key 'where' is missing; add it (inputs/README.md lists what it takes)"),
    Row("support without a velocity", ", velocity: [0, 0, null]", "",
        ":8:5: supports.0: the key 'velocity' is missing; add it (inputs/README.md lists what it takes)"),
    Row("support that holds nothing", "[0, 0, null]", "[null, null, null]",
        ":8:63: supports.0.velocity: holds nothing: every component is null; give a velocity in m/s (0: at rest) "
        "for at least one"),
    Row("box with one corner", ", [0.005, 1, 1]]", "]",
        ":8:26: supports.0.where.box: needs a list of 2 values, not of 1"),
    Row("box in two dimensions", "[0.005, 1, 1]", "[0.005, 1]",
        ":8:46: supports.0.where.box.1: needs a list of 3 values, not of 2"),
    Row("not a number in a box", "0.005", "left", ":8:47: supports.0.where.box.1.0: needs a number, not 'left'"),
    Row("unknown shape of a place", "where: {box:", "where: {sphere:",
        ":8:26: supports.0.where.sphere: unknown key; known here are box"),
    Row("no end", "end: 0.01, ", "",
        ":9:1: time: the key 'end' is missing; add it (inputs/README.md lists what it takes)"),
    Row("end at 0", "end: 0.01", "end: 0", ":9:13: time.end: needs a number above 0 s, not '0'"),
    Row("negative end", "end: 0.01", "end: -1", ":9:13: time.end: needs a number above 0 s, not '-1'"),
    Row("word for a step", "step: auto", "step: fast",
        ":9:25: time.step: needs auto or a number above 0 s, not 'fast'"),
    Row("list for a step", "step: auto", "step: [1e-4]",
        ":9:19: time.step: needs auto or a number above 0 s, not a list"),
    Row("negative step", "step: auto", "step: -1e-4",
        ":9:25: time.step: needs auto or a number above 0 s, not '-1e-4'"),
    Row("scheme that comes later", "cordis", "implicit",
        ":9:39: time.scheme: not available in cracksim 0.1; 'implicit' comes later; take cordis"),
    Row("unknown scheme", "cordis", "verlet", ":9:39: time.scheme: does not know 'verlet'; take one of cordis, ab2"),
    Row("unknown precision", "scheme: cordis", "precision: half",
        ":9:42: time.precision: does not know 'half'; take one of double, single"),
    Row("text for true or false", "allow_unstable: false", "allow_unstable: perhaps",
        ":9:63: time.allow_unstable: needs true or false, not 'perhaps'"),
    Row("rate of 0 for the coat", "coat: {rate: 50}", "coat: {rate: 0}",
        ":10:14: coat.rate: needs a number above 0 Hz, not '0'"),
    Row("negative rate", "output: {rate: 50", "output: {rate: -50",
        ":11:16: output.rate: needs a number, 0 Hz or above, not '-50'"),
    Row("text for a rate", "history: {rate: 200}", "history: {rate: often}",
        ":12:17: history.rate: needs a number, 0 Hz or above, not 'often'"),
    Row("number for true or false", "surface: true", "surface: 1",
        ":11:29: output.surface: needs true or false, not '1'"),
    Row("unknown kind of frames", "masses: false", "meshes: false",
        ":11:48: output.meshes: unknown key; did you mean 'masses'?"),
    Row("unknown partition", "metis", "scotch",
        ":13:19: partition.kind: does not know 'scotch'; take one of metis, slab, random"),
    Row("section that comes later", "partition:", "checkpoint: {every: 600}\npartition:",
        ":13:1: checkpoint: not available in cracksim 0.1; runs cannot be saved and restarted yet: remove the key"),
]
