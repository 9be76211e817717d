"""Scenes of the right form with wrong values, each with the complete message that it must cause.

To add a case, add a line.
"""
from hostile_scenes import DISC, POLYGON, RECTANGLE, Row, notch, notched

ALLOWED = ("; allowed are numbers, x, y, z (m), t (s), pi, e, + - * / ^, < <= > >= == !=, && ||, a ? b : c, "
           "and the functions abs, sqrt, exp, log, log10, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, floor, "
           "ceil, sign, atan2, min, max")
SUPPORT = "  - {where: {box: [[-1, -1, -1], [1, 1, 1]]}, velocity: [1, 0, 0]}\n"


MEANING = [
    Row("name of two lines", "name: left", 'name: "left\\nright"',
        ":8:12: supports.0.name: needs one line of at most 60 bytes, not 'left right'; "
        "remove the line break at byte 5"),
    Row("more cells than can be counted", "[4, 4, 2]", "[2000000000, 4, 2]",
        ":2:29: block.cells: makes more than 2000000000 entities, the most that a block may have; use fewer cells"),
    Row("length in quotes", "edge: 0.01", 'edge: "0.01"',
        ":2:53: block.edge: needs a number above 0 m, not '0.01' as a text; remove the quotes"),
    Row("number of cells in quotes", "[4, 4, 2]", "['4', 4, 2]",
        ":2:37: block.cells.0: needs an integer from 1 to 2000000000, not '4' as a text; remove the quotes"),
    Row("true in quotes", "prefilter: true", 'prefilter: "true"',
        ":5:83: sensors.prefilter: needs true or false, not 'true' as a text; remove the quotes"),
    Row("length with a quote too many", "edge: 0.01", 'edge: 0.01"',
        ":2:53: block.edge: needs a number above 0 m, not '0.01\"'; remove the quote in it"),
    Row("infinite length without its point", "edge: 0.01", "edge: inf",
        ":2:53: block.edge: needs a number above 0 m, not 'inf'; it must be finite"),
    Row("infinite box without its point", "[-1, -1, -1]", "[-inf, -1, -1]",
        ":8:33: supports.0.where.box.0.0: needs a number, not '-inf'; infinity is written .inf"),
    Row("infinite threshold without its point", "threshold: 0.02", "threshold: inf",
        ":5:36: sensors.threshold: needs a number or an expression, not 'inf'; infinity is written .inf"),
    Row("infinite velocity without its point", "velocity: [0, 0, 0]", "velocity: [inf, 0, 0]",
        ":6:47: initial.velocity.0: needs a number or an expression, not 'inf'; it must be finite"),
    Row("infinity in a formula", "threshold: 0.02", 'threshold: "2*x + .inf"',
        ":5:36: sensors.threshold: '2*x + .inf' is not a number or an expression: '.inf' at character 7: infinity "
        "has no place in a formula" + ALLOWED),
    Row("velocity that no computer holds", "velocity: [0, 0, 0]", "velocity: [-1e400, 0, 0]",
        ":6:47: initial.velocity.0: needs a number or an expression, not '-1e400'; it is too large to be held: numbers "
        "reach 1.7e308"),
    Row("threshold that no computer holds", "threshold: 0.02", "threshold: 1e400",
        ":5:36: sensors.threshold: needs a number or an expression, not '1e400'; it is too large to be held: numbers "
        "reach 1.7e308, and infinity is written .inf"),
    Row("number in a formula that no computer holds", "threshold: 0.02", 'threshold: "1e400*x"',
        ":5:36: sensors.threshold: '1e400*x' is not a number or an expression: '1e400' at character 1 is too large; "
        "numbers reach up to 1.7e308" + ALLOWED),
    Row("title of control characters", "title: a block", 'title: "\\e[2Jgone"',
        ":1:8: title: needs one line of at most 200 bytes, not ' [2Jgone'; remove the control character 0x1B "
        "at byte 1"),
    Row("title that steers a terminal by one character", "title: a block", 'title: "a\\x9b2J"',
        ":1:8: title: needs one line of at most 200 bytes, not 'a 2J'; remove the control character 0x9B at byte 2"),
    Row("endless title", "title: a block", "title: " + "a" * 201,
        ":1:8: title: needs one line of at most 200 bytes, not '" + "a" * 60 + "...'; it has 201"),
    Row("length beyond all numbers", "edge: 0.01", "edge: 1e300",
        ":2:53: block.edge: every edge must be above 0 m and within 1e-60 to 1e60 m, not 1e+300"),
    Row("infinite length", "edge: 0.01", "edge: .inf",
        ":2:53: block.edge: needs a number above 0 m, not '.inf'; it must be finite"),
    Row("number that no computer holds", "edge: 0.01", "edge: 1e999",
        ":2:53: block.edge: needs a number above 0 m, not '1e999'; it is too large to be held: "
        "numbers reach 1.7e308"),
    Row("number lost beside 0", "edge: 0.01", "edge: 1e-310",
        ":2:53: block.edge: needs a number above 0 m, not '1e-310'; it is too near 0 to be held: "
        "numbers begin at 2.3e-308"),
    Row("not a number", "edge: 0.01", "edge: .nan", ":2:53: block.edge: needs a number above 0 m, not '.nan'"),
    Row("origin far away", "origin: [0, 0, 0]", "origin: [1e15, 0, 0]",
        ":2:1: block: lies so far from 0 along x (1e+15 m) that positions one edge apart are hardly told apart; "
        "move block.origin closer to 0"),
    Row("infinite origin", "origin: [0, 0, 0]", "origin: [-.inf, 0, 0]",
        ":2:68: block.origin.0: needs a number, not '-.inf'; it must be finite"),
    Row("material on boxes", "edge: 0.01", "edge: [0.01, 0.02, 0.01]",
        ":3:1: material: needs cubes with model: paper, but block.edge is 0.01 x 0.02 x 0.01 m: no 16 interactions "
        "make other boxes isotropic; use equal edges, or model: standard"),
    Row("standard entities like hairs", "edge: 0.01, origin: [0, 0, 0]}\nmaterial: {model: paper",
        "edge: [0.01, 10001, 0.01]}\nmaterial: {model: standard",
        ":3:1: material: takes boxes whose longest edge is at most a million times the shortest with model: standard, "
        "but block.edge is 0.01 x 10001 x 0.01 m; use edges that differ less"),
    Row("stiffness of a wrong unit", "young: 2.0e4", "young: 1e150",
        ":3:1: material: makes an edge stiffness of 2e+147 N/m, outside of 1e-60 to 1e60; check the units (SI) "
        "here and of block.edge"),
    Row("damping without end", "damping: 0.2", "damping: 1e200",
        ":3:1: material: makes an edge viscosity of 8.94e+198 N s/m, outside of 1e-60 to 1e60; check the units "
        "(SI) here and of block.edge"),
    Row("unknown name in an expression", "threshold: 0.02", 'threshold: "0.02*(1 + q)"',
        ":5:36: sensors.threshold: '0.02*(1 + q)' is not a number or an expression: 'q' at character 11 is not "
        "known" + ALLOWED),
    Row("unknown function", "threshold: 0.02", 'threshold: "sinus(x)"',
        ":5:36: sensors.threshold: 'sinus(x)' is not a number or an expression: 'sinus' at character 1 is not "
        "known" + ALLOWED),
    Row("open bracket in an expression", "threshold: 0.02", 'threshold: "0.02*(1 + x"',
        ":5:36: sensors.threshold: '0.02*(1 + x' is not a number or an expression: a bracket is not closed" + ALLOWED),
    Row("expression that ends too early", "threshold: 0.02", 'threshold: "0.02*"',
        ":5:36: sensors.threshold: '0.02*' is not a number or an expression: it ends too early" + ALLOWED),
    Row("too many arguments", "threshold: 0.02", 'threshold: "sin(x, y)"',
        ":5:36: sensors.threshold: 'sin(x, y)' is not a number or an expression: a function has too many "
        "arguments at character 9" + ALLOWED),
    Row("too few arguments", "threshold: 0.02", 'threshold: "atan2(x)"',
        ":5:36: sensors.threshold: 'atan2(x)' is not a number or an expression: a function has too few arguments "
        "at character 8" + ALLOWED),
    Row("case without the other", "threshold: 0.02", 'threshold: "x > 0 ? 1"',
        ":5:36: sensors.threshold: 'x > 0 ? 1' is not a number or an expression: '?' without ':'" + ALLOWED),
    Row("assignment", "threshold: 0.02", 'threshold: "x = 2"',
        ":5:36: sensors.threshold: 'x = 2' is not a number or an expression: '=' does not compare; "
        "write '=='" + ALLOWED),
    Row("comma for a point", "threshold: 0.02", 'threshold: "0,02"',
        ":5:36: sensors.threshold: '0,02' is not a number or an expression: a comma separates arguments of "
        "functions only; the decimal sign is a point" + ALLOWED),
    Row("empty expression", "threshold: 0.02", 'threshold: ""',
        ":5:36: sensors.threshold: '' is not a number or an expression: it is empty" + ALLOWED),
    Row("expression with a zero byte", "threshold: 0.02", 'threshold: "x\\0"',
        ":5:36: sensors.threshold: 'x ' is not a number or an expression: the control character 0x00 at "
        "character 2 has no meaning in an expression" + ALLOWED),
    Row("expression in Greek", "threshold: 0.02", 'threshold: "2·π"',
        ":5:36: sensors.threshold: '2·π' is not a number or an expression: '·' at character 2 has no meaning in "
        "an expression" + ALLOWED),
    Row("expression of a million signs", "threshold: 0.02", 'threshold: "' + "+".join("x" * 500_000) + '"',
        ":5:36: sensors.threshold: 'x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+x+...' is not a "
        "number or an expression: it has more than 20000 characters" + ALLOWED),
    Row("expression of many brackets", "threshold: 0.02", "threshold: " + "(" * 9_999 + "x" + ")" * 9_998,
        ":5:36: sensors.threshold: '((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((...' is not a "
        "number or an expression: a bracket is not closed" + ALLOWED),
    Row("threshold that is not a number", "threshold: 0.02", "threshold: .nan",
        ":5:36: sensors.threshold: '.nan' is not a number or an expression: '.nan' at character 1 "
        "is not known" + ALLOWED),
    Row("threshold from 0/0", "threshold: 0.02", 'threshold: "0/0"',
        ":5:36: sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '0/0'"),
    Row("threshold of the time", "threshold: 0.02", 'threshold: "0.02*t"',
        ":5:36: sensors.threshold: may depend on x, y, z, but not on t: '0.02*t'"),
    Row("threshold that is negative somewhere", "threshold: 0.02", 'threshold: "x - 0.02"',
        ":5:36: sensors.threshold: the threshold at x = 0.01, y = 0, z = 0 m is -0.00923355; a threshold is a "
        "stretch above zero (.inf: never); change the expression so that it is positive everywhere"),
    Row("threshold that is not a number somewhere", "threshold: 0.02", 'threshold: "0.02*sqrt(x - 0.02)"',
        ":5:36: sensors.threshold: the threshold at x = 0.01, y = 0, z = 0 m is not a number; a threshold is a "
        "stretch above zero (.inf: never); change the expression so that it is positive everywhere"),
    Row("threshold lost beside 0", "threshold: 0.02", "threshold: 1e-320",
        ":5:36: sensors.threshold: needs a number or an expression, not '1e-320'; it is too near 0 to be held: "
        "numbers begin at 2.3e-308"),
    Row("threshold that scatters to 0", "threshold: 0.02, weibull: {shape: 8",
        "threshold: 2.3e-308, weibull: {shape: 0.1",
        ":5:36: sensors.threshold: the threshold at x = 0.01, y = 0, z = 0 m is 0; a threshold is a stretch "
        "above zero (.inf: never); change the expression so that it is positive everywhere"),
    Row("infinite velocity", "velocity: [0, 0, 0]", "velocity: [1/0, 0, 0]",
        ":6:47: initial.velocity.0: must be finite, not '1/0'"),
    Row("velocity that is infinite somewhere", "velocity: [0, 0, 0]", "velocity: [1/x, 0, 0]",
        ":6:1: initial: the velocity at x = 0, y = 0, z = 0 m is not a finite number; change the expression"),
    Row("velocity beyond all numbers", "velocity: [0, 0, 0]", "velocity: [1e308*1e308, 0, 0]",
        ":6:47: initial.velocity.0: must be finite, not '1e308*1e308'"),
    Row("velocity of the time", "velocity: [0, 0, 0]", "velocity: [sin(t), 0, 0]",
        ":6:47: initial.velocity.0: may depend on x, y, z, but not on t: 'sin(t)'"),
    Row("box upside down", "[-1, -1, -1], [0.005, 1, 1]", "[-1, 1, -1], [0.005, -1, 1]",
        ":8:26: supports.0.where.box: the lower corner is above the upper one along y; give [[x, y, z of the "
        "lower], [x, y, z of the upper]]"),
    Row("box of not a number", "0.005", ".nan", ":8:47: supports.0.where.box.1.0: needs a number, not '.nan'"),
    Row("two supports of one name", "time:", SUPPORT.replace("where", "name: left, where") + "time:",
        ":9:5: supports.1: there is a support named 'left' already; choose another name"),
    Row("two supports that pull at the same", "time:", SUPPORT + "time:",
        ":7:1: supports: supports 'left' and 'support 1' both prescribe the velocity along x of mass 0 at x = 0, "
        "y = 0, z = 0 m; make the boxes disjoint or leave one component null"),
    Row("support with an infinite velocity", "[0, 0, null]", "[0, .inf, null]",
        ":8:77: supports.0.velocity.1: needs a number or an expression, not '.inf'; it must be finite"),
    Row("more supports than can be counted", "  - {name: left", SUPPORT * 30_000 + "  - {name: left",
        ":7:1: supports: has more than 30000 supports; join their boxes"),
    Row("end without end", "end: 0.01", "end: 1e300",
        ":9:13: time.end: 1e+300 s takes 1.36618e+303 steps of 0.000731968 s, more than can be counted; use an "
        "earlier end"),
    Row("step lost beside 0", "step: auto", "step: 1e-320",
        ":9:25: time.step: needs auto or a number above 0 s, not '1e-320'; it is too near 0 to be held: "
        "numbers begin at 2.3e-308"),
    Row("steps that cannot be counted", "step: auto", "step: 1e-30",
        ":9:25: time.step: makes 1e+28 steps to time.end, more than can be counted; use a larger step"),
    Row("step above the bound", "step: auto", "step: 0.1",
        ":9:25: time.step: 0.1 s is above the largest stable step 0.000813298 s (set by the viscosity of an "
        "entity); use at most 0.000731968 s or `auto`, or say time.allow_unstable: true"),
    Row("step beyond all numbers", "step: auto", "step: 1e300",
        ":9:25: time.step: 1e+300 s is above the largest stable step 0.000813298 s (set by the viscosity of an "
        "entity); use at most 0.000731968 s or `auto`, or say time.allow_unstable: true"),
    notched("name of a notch in two lines", "[{name: \"left\\nright\", where: {" + DISC + "}}]",
        ":14:18: notches.0.name: needs one line of at most 60 bytes, not 'left right'; remove the line break at "
        "byte 5"),
    notched("two notches of one name", "[{name: a, where: {" + DISC + "}}, {name: a, where: {" + POLYGON + "}}]",
        ":14:100: notches.1: there is a notch named 'a' already; choose another name"),
    notched("notch with the default name of another",
        "[{name: notch 1, where: {" + DISC + "}}, {where: {" + POLYGON + "}}]",
        ":14:106: notches.1: there is a notch named 'notch 1' already; choose another name"),
    notched("name of a notch with 61 bytes and fewer letters", "[{name: " + "ü" * 30 + "a, where: {" + DISC + "}}]",
        ":14:18: notches.0.name: needs one line of at most 60 bytes, not 'üüüüüüüüüüüüüüüüüüüüüüüüüüüüüü...'; it "
        "has 61"),
    notched("second notch that is wrong",
        "[{where: {" + DISC + "}}, {name: b, where: {" + DISC.replace("0.02, 0.02", "1, 0.02") + "}}]",
        ":14:101: notches.1.where: 'b' lies outside of the block: the notch lies at x = 1 m, the block "
        "reaches from x = 0 to 0.04 m; move the notch"),
    notch("sides that are parallel", RECTANGLE.replace("[0, 0, 2]", "[0, -0.04, 0]"),
        ":14:12: notches.0.where: 'notch 0' encloses no area: its two sides are parallel, or one of "
        "them has length 0"),
    notch("side lost beside the other", RECTANGLE.replace("[0, 0, 2]", "[0, 0, 1e-300]"),
        ":14:12: notches.0.where: 'notch 0' encloses no area: its two sides are parallel, or one of "
        "them has length 0"),
    notch("corner in quotes", RECTANGLE.replace("0.02, 0, -1", "\"0.02\", 0, -1"),
        ":14:41: notches.0.where.rectangle.corner.0: needs a number, not '0.02' as a text; remove the quotes"),
    notch("corner far away", RECTANGLE.replace("[0.02, 0, -1]", "[1e300, 0, -1]"),
        ":14:32: notches.0.where.rectangle.corner: has x = 1e+300 m, more than a million times the "
        "block's reach of 0.06 m; give lengths in m"),
    notch("corner that no computer holds", RECTANGLE.replace("[0.02, 0, -1]", "[1e400, 0, -1]"),
        ":14:41: notches.0.where.rectangle.corner.0: needs a number, not '1e400'; it is too large to be held: "
        "numbers reach 1.7e308"),
    notch("side without end", RECTANGLE.replace("[0, 0, 2]", "[0, 0, -1e300]"),
        ":14:76: notches.0.where.rectangle.and: has z = -1e+300 m, more than a million times the block's "
        "reach of 0.06 m; give lengths in m"),
    notch("centre far away", DISC.replace("[0.02, 0.02, 0.01]", "[0.02, 1e300, 0.01]"),
        ":14:27: notches.0.where.disc.centre: has y = 1e+300 m, more than a million times the block's "
        "reach of 0.06 m; give lengths in m"),
    notch("polygon far away", POLYGON.replace("0.03", "1e300"),
        ":14:44: notches.0.where.polygon.1: has y = 1e+300 m, more than a million times the block's reach"
        " of 0.06 m; give lengths in m"),
    notch("not a number in a polygon", POLYGON.replace("0.03", ".nan"),
        ":14:51: notches.0.where.polygon.1.1: needs a number, not '.nan'"),
    notch("radius lost beside an edge", DISC.replace("radius: 0.01", "radius: 1e-30"),
        ":14:12: notches.0.where: 'notch 0' has a radius of 1e-30 m, too small beside an entity; give at "
        "least 0.01 m"),
    notch("corners on a line", "polygon: [[0.02, 0, 0], [0.02, 0.01, 0], [0.02, 0.03, 0]]",
        ":14:12: notches.0.where: 'notch 0' encloses no area: its corners lie on a line, or its sides "
        "cross; give each corner once, in order around it"),
    notch("corners in one place", "polygon: [[0.02, 0, 0], [0.02, 0, 0], [0.02, 0, 0]]",
        ":14:12: notches.0.where: 'notch 0' encloses no area: its corners lie on a line, or its sides "
        "cross; give each corner once, in order around it"),
    notch("polygon that is not plane", "polygon: [[0.02, 0, 0], [0.02, 0.03, 0], [0.03, 0.03, 0.02], [0.02, 0, 0.02]]",
        ":14:12: notches.0.where: 'notch 0' is not plane: corner 1 lies 0.00479 m off the mean plane "
        "through corner 0; move the corners into one plane"),
    notch("polygon of sides that cross",
        "polygon: [[0.02, 0, 0], [0.02, 0.03, 0], [0.02, 0.01, 0.02], [0.02, 0.03, 0.02], [0.02, 0, -1]]",
        ":14:12: notches.0.where: 'notch 0' has sides that cross or touch each other; give each corner "
        "once, in order around it"),
    notch("bow tie for a polygon", "polygon: [[0.02, 0, 0], [0.02, 0.03, 0.02], [0.02, 0.03, 0], [0.02, 0, 0.02]]",
        ":14:12: notches.0.where: 'notch 0' encloses no area: its corners lie on a line, or its sides "
        "cross; give each corner once, in order around it"),
    notch("corner given twice", "polygon: [[0.02, 0, 0], [0.02, 0.03, 0], [0.02, 0.03, 0], [0.02, 0, 0.02]]",
        ":14:12: notches.0.where: 'notch 0' has sides that cross or touch each other; give each corner "
        "once, in order around it"),
    notch("polygon that ends where it begins",
        "polygon: [[0.02, 0, 0], [0.02, 0.03, 0], [0.02, 0, 0.02], [0.02, 0, 0]]",
        ":14:12: notches.0.where: 'notch 0' has sides that cross or touch each other; give each corner "
        "once, in order around it"),
    notch("notch beside the block", RECTANGLE.replace("0.02, 0, -1", "0.05, 0, -1"),
        ":14:12: notches.0.where: 'notch 0' lies outside of the block: the notch lies at x = 0.05 m, the "
        "block reaches from x = 0 to 0.04 m; move the notch"),
    notch("notch below the block", DISC.replace("0.02, 0.02, 0.01", "0.02, 0.02, -0.02"),
        ":14:12: notches.0.where: 'notch 0' lies outside of the block: the notch reaches from z = -0.03 "
        "to -0.01 m, the block reaches from z = 0 to 0.02 m; move the notch"),
    notch("notch in mm", POLYGON.replace("0.02", "20").replace("0.03", "30"),
        ":14:12: notches.0.where: 'notch 0' lies outside of the block: the notch lies at x = 20 m, the "
        "block reaches from x = 0 to 0.04 m; move the notch"),
    notch("notch on the boundary", RECTANGLE.replace("0.02, 0, -1", "0.04, 0, -1"),
        ":14:12: notches.0.where: 'notch 0' opens 0 of the block's 64 interior faces: it crosses no line between "
        "the centres of two neighbouring entities; make it larger or move it"),
    notch("notch between the centres", "rectangle: {corner: [0.02, 0.006, -1], along: [0, 0.008, 0], and: [0, 0, 2]}",
        ":14:12: notches.0.where: 'notch 0' opens 0 of the block's 64 interior faces: it crosses no line between "
        "the centres of two neighbouring entities; make it larger or move it"),
    notch("notch that passes an edge of the block",
        "polygon: [[0.03, 0.06, 0], [0.06, 0.03, 0], [0.06, 0.03, 0.02], [0.03, 0.06, 0.02]]",
        ":14:12: notches.0.where: 'notch 0' opens 0 of the block's 64 interior faces: it crosses no line between "
        "the centres of two neighbouring entities; make it larger or move it"),
]
