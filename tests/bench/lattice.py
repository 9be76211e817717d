"""Converts an intact block to LAMMPS: an atom for each union, a harmonic bond for all springs between two unions."""
import math

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
DIAGONALS = [((0, 0, 0), (1, 1, 1)), ((1, 0, 0), (0, 1, 1)), ((0, 1, 0), (1, 0, 1)), ((0, 0, 1), (1, 1, 0))]
SHARED = [1, 2, 4, 8]
DIAGONAL_TYPE = 4


class Lattice:
    def __init__(self, scene):
        self.cells = scene["block"]["cells"]
        self.edge = scene["block"]["edge"]
        self.matter = scene["material"]
        self.components = [compile(text, "velocity", "eval") for text in scene["initial"]["velocity"]]
        self.sizes = [n + 1 for n in self.cells]

    def atoms(self):
        """The grid places in the order of the atoms' ids, x fastest."""
        nx, ny, nz = self.sizes
        return [(x, y, z) for z in range(nz) for y in range(ny) for x in range(nx)]

    def atom_id(self, place):
        x, y, z = place
        return 1 + x + self.sizes[0] * (y + self.sizes[1] * z)

    def position(self, place):
        return tuple(self.edge * n for n in place)

    def velocity(self, x, y, z):
        """The velocity of the scene, whose expressions are valid Python if they have no powers."""
        names = {"sin": math.sin, "cos": math.cos, "x": x, "y": y, "z": z}
        return [eval(component, names) for component in self.components]

    def entities_at(self, place, free_axis=None):
        """The number of entities that share a vertex, or the edge from it upwards along `free_axis`."""
        inside = [0 < n < count for axis, (n, count) in enumerate(zip(place, self.cells)) if axis != free_axis]
        return 2 ** sum(inside)

    def bonds(self):
        """(type, lower atom, upper atom): types 1 to 3 are edges of 1, 2 and 4 entities, type 4 is a diagonal."""
        found = []
        for place in self.atoms():
            for axis in range(3):
                if place[axis] < self.cells[axis]:
                    upper = tuple(n + (k == axis) for k, n in enumerate(place))
                    kind = 1 + SHARED.index(self.entities_at(place, axis))
                    found.append((kind, self.atom_id(place), self.atom_id(upper)))
            if all(n < count for n, count in zip(place, self.cells)):
                for ends in DIAGONALS:
                    found.append((DIAGONAL_TYPE, *(self.atom_id([n + o for n, o in zip(place, end)]) for end in ends)))
        return found

    def springs(self):
        """(stiffness, viscosity, rest length) of each bond type, by the formulas of src/scene/calibration.hpp."""
        young, density, damping = (self.matter[key] for key in ("young", "density", "damping"))
        relaxation = damping * self.edge / math.sqrt(young / density)
        stiffness = [count * 0.2 * self.edge * young for count in SHARED[:3]] + [0.3 * self.edge * young]
        lengths = 3 * [self.edge] + [math.sqrt(3) * self.edge]
        return [(k, relaxation * k, length) for k, length in zip(stiffness, lengths)]

    def corner_mass(self):
        return self.matter["density"] * self.edge ** 3 / 8

    def entity_atoms(self):
        """The atoms at the corners of each entity, by ascending entities."""
        nx, ny, nz = self.cells
        return [[self.atom_id((x + a, y + b, z + c)) for a, b, c in CORNERS]
                for z in range(nz) for y in range(ny) for x in range(nx)]

    def write(self, path):
        """Writes a LAMMPS data file. Its box is wider than the block, so that no boundary acts on the block."""
        places = self.atoms()
        bonds = self.bonds()
        lines = ["a block of hexahedra", "", f"{len(places)} atoms", f"{len(bonds)} bonds",
                 f"{len(SHARED)} atom types", "4 bond types", ""]
        for axis, count in zip("xyz", self.cells):
            lines.append(f"{-5 * self.edge!r} {(count + 5) * self.edge!r} {axis}lo {axis}hi")
        lines += ["", "Masses", ""] + [f"{i + 1} {n * self.corner_mass()!r}" for i, n in enumerate(SHARED)]
        lines += ["", "Atoms # bond", ""]
        for place in places:
            kind = 1 + SHARED.index(self.entities_at(place))
            lines.append(" ".join([str(self.atom_id(place)), "1", str(kind), *(repr(x) for x in self.position(place))]))
        lines += ["", "Velocities", ""]
        for place in places:
            lines.append(" ".join([str(self.atom_id(place)), *(repr(v) for v in self.velocity(*self.position(place)))]))
        lines += ["", "Bonds", ""] + [f"{i + 1} {kind} {a} {b}" for i, (kind, a, b) in enumerate(bonds)]
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
