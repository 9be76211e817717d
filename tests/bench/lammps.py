"""Runs LAMMPS on the lattice that cracksim uses, for comparison."""
import pathlib
import re
import subprocess

from measure import STEP

SCRIPT = """\
units si
newton {newton}
boundary f f f
atom_style bond
{before}
read_data {data}
{bonds}
comm_modify mode single cutoff {cutoff!r} vel {ghost_velocity}
neighbor 0 bin
neigh_modify once yes
balance 1.0 shift xyz 10 1.01
fix motion all nve
timestep {step!r}
thermo 0
run {steps}
{after}
"""
POSITIONS = 'write_dump all custom {file} id x y z modify sort id format float %.17g'


class Lammps:
    def __init__(self, workplace, binary, lattice):
        self.workplace = workplace
        self.binary = binary
        self.lattice = lattice
        self.help = subprocess.run([binary, "-h"], text=True, capture_output=True, check=False,
                                   stdin=subprocess.DEVNULL).stdout
        self.data = workplace.path / "lattice.data"
        lattice.write(self.data)

    def version(self):
        found = re.search(r"Simulator - (.*)", self.help)
        return found.group(1).strip() if found else "an unknown version"

    def has(self, style):
        return re.search(rf"(?<!\S){re.escape(style)}(?!\S)", self.help) is not None

    def harmonic(self, steps, newton="on", positions=None):
        """LAMMPS defines the energy as E = K (r - r0)^2, so K = k/2."""
        lines = ["bond_style harmonic"]
        lines += [f"bond_coeff {i + 1} {0.5 * k!r} {length!r}"
                  for i, (k, _, length) in enumerate(self.lattice.springs())]
        return self._script("harmonic", lines, [], steps, newton, "no", positions)

    def breakable(self, steps):
        """bpm/spring: damped; it tests each bond for breaking, at a strain that is not reached."""
        breaking = 0.1
        before = ["bond_style bpm/spring overlay/pair yes", "special_bonds lj/coul 1 1 1"]
        lines = [f"pair_style zero {1.8 * self.lattice.edge!r} nocoeff", "pair_coeff * *"]
        lines += [f"bond_coeff {i + 1} {k!r} {breaking} {z!r}" for i, (k, z, _) in enumerate(self.lattice.springs())]
        return self._script("breakable", lines, before, steps, "on", "yes", None)

    def _script(self, name, bonds, before, steps, newton, ghost_velocity, positions):
        after = POSITIONS.format(file=positions) if positions else ""
        path = self.workplace.path / f"{name}.in"
        path.write_text(SCRIPT.format(newton=newton, data=self.data, bonds="\n".join(bonds), before="\n".join(before),
                                      cutoff=1.8 * self.lattice.edge, ghost_velocity=ghost_velocity, step=STEP,
                                      steps=steps, after=after), encoding="utf-8")
        return path

    def milliseconds(self, script, ranks, steps):
        """The time of a step, from LAMMPS' own loop time."""
        text = self.workplace.run(ranks, self.binary, "-in", script, "-log", "none")
        found = re.search(r"Loop time of (\S+) on (\d+) procs", text)
        if not found or int(found.group(2)) != ranks:
            raise SystemExit(f"{self.binary} did not run on {ranks} ranks; was it built with another MPI?\n{text}")
        return 1e3 * float(found.group(1)) / steps


def read_positions(path):
    """[x, y, z] by atom id from a dump that is sorted by id; ids count from 1."""
    text = pathlib.Path(path).read_text(encoding="utf-8").split("ITEM: ATOMS id x y z\n")[1]
    return [None, *([float(x) for x in line.split()[1:4]] for line in text.splitlines())]
