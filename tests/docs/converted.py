#!/usr/bin/env python3
"""converted.py PROGRAM SOURCES FOLDER

Meshes of other formats come the documented ways: an Exodus file by `meshio convert`, a MED file by tools/med2inp.py. The files are
written by meshio here, of blocks of linear and quadratic cells; what PROGRAM then says of the mesh, and the pressures of a scene with it,
are those of its own block. Without meshio, its command, h5py or netCDF4 (tools/setup.sh formats) nothing is asked and the status is 77.
"""
import json
import os
import shutil
import subprocess
import sys

try:
    import h5py  # noqa: F401, by meshio for MED
    import meshio
    import netCDF4  # noqa: F401, by meshio for Exodus
    import numpy
except ImportError as missing:
    print("converted.py: not found: %s" % missing.name)
    sys.exit(77)
if not shutil.which("meshio"):
    print("converted.py: not found: the command meshio")
    sys.exit(77)

program, sources, folder = (os.path.abspath(path) for path in sys.argv[1:])
NX, NY = 6, 2  # cells of 1 x 1
SCENE = """
[[body]]
name = "slab"
mesh = %s
material = { youngs_modulus = 1000, poisson_ratio = 0.3 }
pressure = { top = 2 }
symmetric = "left"
[[contact]]
source = "bottom"
target = { kind = "half_plane", point = [0, 0], normal = [0, 1] }
"""


def block(quadratic):
    """Points, cells and sides by name: numbers of nodes, ends before middles."""
    step = 2 if quadratic else 1
    number, points = {}, []
    for j in range(step * NY + 1):
        for i in range(step * NX + 1):
            if not (i % step and j % step):
                number[i, j] = len(points)
                points.append([i / step, j / step])

    def cell(i, j):
        corners = [(i, j), (i + step, j), (i + step, j + step), (i, j + step)]
        middles = [((a + c) // 2, (b + d) // 2) for (a, b), (c, d) in zip(corners, corners[1:] + corners[:1])]
        return [number[at] for at in corners + (middles if quadratic else [])]

    def side(a, b):
        middle = ((a[0] + b[0]) // 2, (a[1] + b[1]) // 2)
        return [number[a], number[b]] + ([number[middle]] if quadratic else [])

    cells = [cell(step * i, step * j) for j in range(NY) for i in range(NX)]
    columns, rows = range(0, step * NX, step), range(0, step * NY, step)
    sides = {"bottom": [side((i, 0), (i + step, 0)) for i in columns], "top": [side((i, step * NY), (i + step, step * NY)) for i in columns],
             "left": [side((0, j), (0, j + step)) for j in rows]}
    return numpy.array(points), numpy.array(cells), sides


def write_exodus(file, points, cells, sides, quadratic):
    sets = {name: numpy.unique(nodes) for name, nodes in sides.items()}
    flat = numpy.column_stack([points, numpy.zeros(len(points))])
    meshio.write(file, meshio.Mesh(flat, [("quad8" if quadratic else "quad", cells)], point_sets=sets))


def write_med(file, points, cells, sides, quadratic):
    names = list(sides)
    lines = numpy.concatenate([sides[name] for name in names])
    tags = numpy.concatenate([numpy.full(len(sides[name]), -2 - k) for k, name in enumerate(names)])
    mesh = meshio.Mesh(points, [("quad8" if quadratic else "quad", cells), ("line3" if quadratic else "line", lines)],
                       cell_data={"cell_tags": [numpy.full(len(cells), -1), tags]})
    mesh.cell_tags = {-1: ["slab"], **{-2 - k: [name] for k, name in enumerate(names)}}
    mesh.point_tags = {}
    meshio.write(file, mesh)


def said(*words):
    run = subprocess.run([program, *words, "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("converted.py: %s: status %d: %s" % (" ".join(words), run.returncode, run.stderr))
    return json.loads(run.stdout)


def pressures(mesh):
    with open("scene.toml", "w") as scene:
        scene.write(SCENE % mesh)
    pairs = said("solve", "scene.toml")["pairs"]
    return sorted(zip(pairs["x"], pairs["pressure"]))


def main():
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.chdir(folder)
    for quadratic in (False, True):
        points, cells, sides = block(quadratic)
        write_exodus("a.e", points, cells, sides, quadratic)
        write_med("a.med", points, cells, sides, quadratic)
        subprocess.run(["meshio", "convert", "a.e", "e.inp"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([sys.executable, os.path.join(sources, "tools/med2inp.py"), "a.med", "med.inp"], check=True)
        own = '{ kind = "block", size = [%d, %d], cells = [%d, %d], quadratic = %s }' % (NX, NY, NX, NY, str(quadratic).lower())
        wanted = pressures(own)
        for file in "e.inp", "med.inp":
            body, = said("mesh", file)["bodies"]
            found = {way["name"]: (way["sides"], way["length"]) for way in body["boundaries"]}
            if found != {"bottom": (NX, NX), "top": (NX, NX), "left": (NY, NY)} or body["nodes"] != len(points):
                return "converted.py: %s: %d nodes, boundaries %s" % (file, body["nodes"], found)
            got = pressures('{ kind = "inp", file = "%s" }' % file)
            # The same equations in another order: round-off of a well-conditioned body.
            if len(got) != len(wanted) or any(abs(a - b) > 1e-10 for one, other in zip(got, wanted) for a, b in zip(one, other)):
                return "converted.py: %s: pressures %s, expected %s" % (file, got, wanted)
    print("Exodus and MED, linear and quadratic: the same meshes and pressures")
    return 0


sys.exit(main())
