"""Scenes of a wrong form, each with the complete message that it must cause. To add a case, add a line."""
from typing import NamedTuple

SCENE = """\
title: a block
block: {entity: hexahedron, cells: [4, 4, 2], edge: 0.01, origin: [0, 0, 0]}
material: {model: paper, young: 2.0e4, density: 1000, poisson: 0.25, damping: 0.2}
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
MATERIAL = "material: {model: paper, young: 2.0e4, density: 1000, poisson: 0.25, damping: 0.2}"
PAPER = "model: paper, young: 2.0e4, density: 1000"
STANDARD = "model: standard, young: 2.0e4, density: 1000"
NOT_MEASURED = ("not available in cracksim 0.1; the constant that gives its threshold is not measured for model: "
                "{model} with sensors.kind: {kind}; give sensors.threshold in its place, or take model: paper with "
                "sensors.kind: normal")
NETWORK = "network: {mass: 1, edge: {stiffness: 4, viscosity: 0.1}, diagonal: {stiffness: 6}}"
RECTANGLE = "rectangle: {corner: [0.02, 0, -1], along: [0, 0.02, 0], and: [0, 0, 2]}"
DISC = "disc: {centre: [0.02, 0.02, 0.01], normal: [1, 0, 0], radius: 0.01}"
POLYGON = "polygon: [[0.02, 0, 0], [0.02, 0.03, 0], [0.02, 0, 0.02]]"


class Row(NamedTuple):
    name: str
    right: str  # occurs once in SCENE
    wrong: str  # replaces `right`
    message: str  # follows the name of the file


def notched(name, notches, message):
    """A scene with these notches, which begin in line 14."""
    last = SCENE.splitlines()[-1]
    return Row(name, last, f"{last}\nnotches: {notches}", message)


def notch(name, where, message):
    """A scene with a notch, whose surface begins at 14:20."""
    return notched(name, "[{where: {" + where + "}}]", message)


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
    Row("no stiffness", "young: 2.0e4", "young: 0", ":3:33: material.young: needs a number above 0 Pa, not '0'"),
    Row("true for a density", "density: 1000", "density: true",
        ":3:49: material.density: needs a number above 0 kg/m3, not 'true'"),
    Row("another Poisson's ratio", "poisson: 0.25", "poisson: 0.3",
        ":3:64: material.poisson: must be 0.25 with model: paper, not '0.3': the network of interactions is isotropic "
        "only there; use model: standard"),
    Row("Poisson's ratio below the range", f"{PAPER}, poisson: 0.25", f"{STANDARD}, poisson: -0.2001",
        ":3:67: material.poisson: needs a number from -0.2 to 0.49, not '-0.2001': the energy of the standard entity "
        "is proved to be positive there"),
    Row("Poisson's ratio above the range", f"{PAPER}, poisson: 0.25", f"{STANDARD}, poisson: 0.4901",
        ":3:67: material.poisson: needs a number from -0.2 to 0.49, not '0.4901': the energy of the standard entity "
        "is proved to be positive there"),
    Row("text for Poisson's ratio", f"{PAPER}, poisson: 0.25", f"{STANDARD}, poisson: rubber",
        ":3:67: material.poisson: needs a number, not 'rubber'"),
    Row("unknown model", "model: paper", "model: papre",
        ":3:19: material.model: does not know 'papre'; did you mean 'paper'?"),
    Row("number for a model", "model: paper", "model: 1",
        ":3:19: material.model: does not know '1'; take one of standard, paper"),
    Row("list for a model", "model: paper", "model: [paper]",
        ":3:12: material.model: needs one of standard, paper, not a list"),
    Row("negative damping", "damping: 0.2", "damping: -0.2",
        ":3:79: material.damping: needs a number, 0 a/c0 or above, not '-0.2'"),
    Row("fracture energy of 0", "damping: 0.2", "fracture_energy: 0",
        ":3:87: material.fracture_energy: needs a number above 0 J/m2, not '0'"),
    Row("unknown key of the material", "damping: 0.2", "dampening: 0.2",
        ":3:70: material.dampening: unknown key; did you mean 'damping'?"),
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
    Row("unknown sensor", "kind: normal", "kind: wide",
        ":5:17: sensors.kind: does not know 'wide'; take one of normal, stress"),
    Row("stress of a network", f"{MATERIAL}\nduplets: corners\nsensors: {{kind: normal",
        f"{NETWORK}\nduplets: corners\nsensors: {{kind: stress",
        ":5:17: sensors.kind: 'stress' needs Young's modulus, which network does not give; use material, or take "
        "normal"),
    Row("fracture energy for stress", "damping: 0.2}\nduplets: corners\nsensors: {kind: normal",
        "fracture_energy: 1}\nduplets: corners\nsensors: {kind: stress",
        ":3:87: material.fracture_energy: " + NOT_MEASURED.format(model="paper", kind="stress")),
    Row("fracture energy for standard entities", f"{PAPER}, poisson: 0.25, damping: 0.2",
        f"{STANDARD}, poisson: 0.25, fracture_energy: 1",
        ":3:90: material.fracture_energy: " + NOT_MEASURED.format(model="standard", kind="normal")),
    Row("fracture energy for standard entities and their own sensors",
        f"{PAPER}, poisson: 0.25, damping: 0.2}}\nduplets: corners\nsensors: {{kind: normal, ",
        f"{STANDARD}, poisson: 0.25, fracture_energy: 1}}\nduplets: corners\nsensors: {{",
        ":3:90: material.fracture_energy: " + NOT_MEASURED.format(model="standard", kind="stress")),
    Row("stress without a threshold", "kind: normal, threshold: 0.02", "kind: stress",
        ":5:1: sensors: nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never)"),
    Row("no threshold", "threshold: 0.02, ", "",
        ":5:1: sensors: nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never) or "
        "material.fracture_energy (J/m2)"),
    Row("no threshold for standard entities",
        f"{PAPER}, poisson: 0.25, damping: 0.2}}\nduplets: corners\nsensors: {{kind: normal, threshold: 0.02, ",
        f"{STANDARD}, poisson: 0.25, damping: 0.2}}\nduplets: corners\nsensors: {{kind: normal, ",
        ":5:1: sensors: nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never)"),
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
    notched("number for the notches", "1", ":14:10: notches: needs a list, not '1'"),
    notched("map for the notches", "{centre: {where: {" + RECTANGLE + "}}}", ":14:1: notches: needs a list, not a map"),
    notched("empty notches", "", ":14:1: notches: needs a list, not an empty value"),
    notched("number for a notch", "[1]", ":14:11: notches.0: needs a map with keys of name, where, not '1'"),
    notched("unknown key of a notch", "[{where: {" + RECTANGLE + "}, width: 1}]",
        ":14:94: notches.0.width: unknown key; known here are name, where"),
    notched("misspelt key of a notch", "[{wehre: {" + RECTANGLE + "}}]",
        ":14:12: notches.0.wehre: unknown key; did you mean 'where'?"),
    notched("surface beside where", "[{" + RECTANGLE + "}]",
        ":14:12: notches.0.rectangle: unknown key; known here are name, where"),
    notched("notch without a place", "[{name: centre}]",
        ":14:11: notches.0: the key 'where' is missing; add it (inputs/README.md lists what it takes)"),
    notched("place of a notch without a value", "[{where: }]",
        ":14:12: notches.0.where: needs a map with keys of rectangle, disc, polygon, not an empty value"),
    notched("list for the place of a notch", "[{where: [" + POLYGON[9:] + "]}]",
        ":14:12: notches.0.where: needs a map with keys of rectangle, disc, polygon, not a list"),
    notched("list for the name of a notch", "[{name: [a, b], where: {" + DISC + "}}]",
        ":14:12: notches.0.name: needs a text, not a list"),
    notched("long name of a notch", "[{name: " + "a" * 61 + ", where: {" + DISC + "}}]",
        ":14:18: notches.0.name: needs one line of at most 60 bytes, not "
        "'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...'; it has 61"),
    notched("more notches than can be counted",
        "[" + ("{where: {" + DISC + "}}, ") * 10_000 + "{where: {" + DISC + "}}]",
        ":14:1: notches: has more than 10000 notches; join their surfaces"),
    notch("notch without a surface", "",
        ":14:12: notches.0.where: needs a surface: rectangle: {corner, along, and}, disc: {centre, "
        "normal, radius} or polygon: [[x, y, z], ...]"),
    notch("notch of two surfaces", RECTANGLE + ", " + DISC,
        ":14:12: notches.0.where: needs one surface, not 2: rectangle: {corner, along, and}, disc: "
        "{centre, normal, radius} or polygon: [[x, y, z], ...]"),
    notch("notch of three surfaces", RECTANGLE + ", " + DISC + ", " + POLYGON,
        ":14:12: notches.0.where: needs one surface, not 3: rectangle: {corner, along, and}, disc: "
        "{centre, normal, radius} or polygon: [[x, y, z], ...]"),
    notch("unknown surface of a notch", "ellipse: {}",
        ":14:20: notches.0.where.ellipse: unknown key; known here are rectangle, disc, polygon"),
    notch("box for the surface of a notch", "box: [[0, 0, 0], [1, 1, 1]]",
        ":14:20: notches.0.where.box: unknown key; known here are rectangle, disc, polygon"),
    notch("list for a rectangle", "rectangle: [0, 0, 0]",
        ":14:20: notches.0.where.rectangle: needs a map with keys of corner, along, and, not a list"),
    notch("rectangle without a corner", RECTANGLE.replace("corner: [0.02, 0, -1], ", ""),
        ":14:20: notches.0.where.rectangle: the key 'corner' is missing; add it (inputs/README.md lists what it "
        "takes)"),
    notch("rectangle with one side", RECTANGLE.replace(", and: [0, 0, 2]", ""),
        ":14:20: notches.0.where.rectangle: the key 'and' is missing; add it (inputs/README.md lists what it takes)"),
    notch("rectangle without along", RECTANGLE.replace("along: [0, 0.02, 0], ", ""),
        ":14:20: notches.0.where.rectangle: the key 'along' is missing; add it (inputs/README.md lists what it "
        "takes)"),
    notch("unknown key of a rectangle", RECTANGLE.replace("and:", "end:"),
        ":14:76: notches.0.where.rectangle.end: unknown key; did you mean 'and'?"),
    notch("corner of two numbers", RECTANGLE.replace("[0.02, 0, -1]", "[0.02, 0]"),
        ":14:32: notches.0.where.rectangle.corner: needs a list of 3 values, not of 2"),
    notch("number for a corner", RECTANGLE.replace("[0.02, 0, -1]", "0.02"),
        ":14:40: notches.0.where.rectangle.corner: needs a list of 3 values, not '0.02'"),
    notch("text in a corner", RECTANGLE.replace("[0.02, 0, -1]", "[left, 0, -1]"),
        ":14:41: notches.0.where.rectangle.corner.0: needs a number, not 'left'"),
    notch("expression in a corner", RECTANGLE.replace("[0.02, 0, -1]", "[2*x, 0, -1]"),
        ":14:41: notches.0.where.rectangle.corner.0: needs a number, not '2*x'"),
    notch("infinite corner", RECTANGLE.replace("[0.02, 0, -1]", "[0.02, 0, -.inf]"),
        ":14:50: notches.0.where.rectangle.corner.2: needs a number, not '-.inf'; it must be finite"),
    notch("side of four numbers", RECTANGLE.replace("[0, 0.02, 0]", "[0, 0.02, 0, 0]"),
        ":14:55: notches.0.where.rectangle.along: needs a list of 3 values, not of 4; put an expression that holds "
        "commas in quotes"),
    notch("side of length 0", RECTANGLE.replace("[0, 0.02, 0]", "[0, 0, 0]"),
        ":14:12: notches.0.where: 'notch 0' encloses no area: its two sides are parallel, or one of "
        "them has length 0"),
    notch("infinite side", RECTANGLE.replace("[0, 0, 2]", "[0, 0, .inf]"),
        ":14:88: notches.0.where.rectangle.and.2: needs a number, not '.inf'; it must be finite"),
    notch("text in a side", RECTANGLE.replace("[0, 0, 2]", "[0, 0, up]"),
        ":14:88: notches.0.where.rectangle.and.2: needs a number, not 'up'"),
    notch("disc without a centre", DISC.replace("centre: [0.02, 0.02, 0.01], ", ""),
        ":14:20: notches.0.where.disc: the key 'centre' is missing; add it (inputs/README.md lists what it takes)"),
    notch("disc without a normal", DISC.replace("normal: [1, 0, 0], ", ""),
        ":14:20: notches.0.where.disc: the key 'normal' is missing; add it (inputs/README.md lists what it takes)"),
    notch("disc without a radius", DISC.replace(", radius: 0.01", ""),
        ":14:20: notches.0.where.disc: the key 'radius' is missing; add it (inputs/README.md lists what it takes)"),
    notch("centre in American", DISC.replace("centre", "center"),
        ":14:27: notches.0.where.disc.center: unknown key; did you mean 'centre'?"),
    notch("number for a disc", "disc: 0.01",
        ":14:26: notches.0.where.disc: needs a map with keys of centre, normal, radius, not '0.01'"),
    notch("text in a centre", DISC.replace("[0.02, 0.02, 0.01]", "[0.02, middle, 0.01]"),
        ":14:42: notches.0.where.disc.centre.1: needs a number, not 'middle'"),
    notch("normal of length 0", DISC.replace("[1, 0, 0]", "[0, 0, 0]"),
        ":14:12: notches.0.where: 'notch 0' has a normal of length 0; give the direction across the disc"),
    notch("axis for a normal", DISC.replace("[1, 0, 0]", "x"),
        ":14:63: notches.0.where.disc.normal: needs a list of 3 values, not 'x'"),
    notch("infinite normal", DISC.replace("[1, 0, 0]", "[.inf, 0, 0]"),
        ":14:64: notches.0.where.disc.normal.0: needs a number, not '.inf'; it must be finite"),
    notch("radius of 0", DISC.replace("radius: 0.01", "radius: 0"),
        ":14:82: notches.0.where.disc.radius: needs a number above 0 m, not '0'"),
    notch("negative radius", DISC.replace("radius: 0.01", "radius: -0.01"),
        ":14:82: notches.0.where.disc.radius: needs a number above 0 m, not '-0.01'"),
    notch("infinite radius", DISC.replace("radius: 0.01", "radius: .inf"),
        ":14:82: notches.0.where.disc.radius: needs a number above 0 m, not '.inf'; it must be finite"),
    notch("radius with its unit", DISC.replace("radius: 0.01", "radius: 1 cm"),
        ":14:82: notches.0.where.disc.radius: needs a number above 0 m, not '1 cm'"),
    notch("number for a polygon", "polygon: 3", ":14:29: notches.0.where.polygon: needs a list, not '3'"),
    notch("map for a polygon", "polygon: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}",
        ":14:20: notches.0.where.polygon: needs a list, not a map"),
    notch("polygon without corners", "polygon: []",
        ":14:12: notches.0.where: 'notch 0' has fewer than three corners; give three or more"),
    notch("polygon of two corners", "polygon: [[0.02, 0, 0], [0.02, 0.03, 0]]",
        ":14:12: notches.0.where: 'notch 0' has fewer than three corners; give three or more"),
    notch("polygon of too many corners", "polygon: [" + "[0.02, 0, 0], " * 1000 + "[0.02, 0, 0]]",
        ":14:20: notches.0.where.polygon: has more than 1000 corners; divide it into several notches"),
    notch("polygon in two dimensions", "polygon: [[0, 0], [0.03, 0], [0, 0.03]]",
        ":14:30: notches.0.where.polygon.0: needs a list of 3 values, not of 2"),
    notch("polygon of numbers", "polygon: [0.02, 0, 0]",
        ":14:30: notches.0.where.polygon.0: needs a list of 3 values, not '0.02'"),
    notch("text in a polygon", POLYGON.replace("0.03", "top"),
        ":14:51: notches.0.where.polygon.1.1: needs a number, not 'top'"),
    notch("infinite polygon", POLYGON.replace("0.03", ".inf"),
        ":14:51: notches.0.where.polygon.1.1: needs a number, not '.inf'; it must be finite"),
]
