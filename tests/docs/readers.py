#!/usr/bin/env python3
"""readers.py PROGRAM SOURCES FOLDER

What PROGRAM writes, read by others. VTU files of scenes of SOURCES, binary and as text, by VTK, on which ParaView is built, and by meshio:
both must find the same points, cells, fields and names in both, and the digits that are in the text to their last bits. Writes to FOLDER. What is not installed is left out; if
nothing is (tools/setup.sh formats), the status is 77.
"""
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
program, sources, folder = sys.argv[1:]
SCENES = {  # and the names that its file has
    "examples/wheel_on_rail.toml": ["body 0: wheel", "body 1: rail"],
    "examples/bolt_in_tube.toml": ["body 0: bolt", "body 1: tube"],
    "examples/cantilever.toml": [],
}


def installed(module):
    try:
        return __import__(module)
    except ImportError:
        print("readers.py: not found: %s" % module)
        return None


def written(file, name):
    """The numbers of an array as they stand in the text."""
    with open(file, encoding="utf-8") as text:
        found = re.search('Name="%s"[^>]*>([^<]*)<' % re.escape(name), text.read())
    return [float(word) for word in found.group(1).split()]


def by_meshio(meshio, file):
    mesh = meshio.read(file)
    cells = sum(len(block.data) for block in mesh.cells)
    whole = all(str(values.dtype) == "int64" for block in [mesh.cell_data.get("body", [])] for values in block)
    return {"points": len(mesh.points), "cells": cells, "names": sorted(mesh.field_data), "whole": whole,
            "pressure": [float(p) for p in mesh.point_data["contact_pressure"]],
            "displacement": [float(u) for row in mesh.point_data["displacement"] for u in row]}


def by_vtk(vtk, file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    data, names, body = grid.GetPointData(), grid.GetFieldData(), grid.GetCellData().GetArray("body")
    parts = [data.GetArray("stress").GetComponentName(k) for k in range(4)]
    if parts != ["xx", "yy", "xy", "zz"]:
        sys.exit("readers.py: %s: VTK names the parts of a stress %s" % (file, parts))

    def numbers(name):
        array = data.GetArray(name)
        return [array.GetComponent(i, k) for i in range(array.GetNumberOfTuples()) for k in range(array.GetNumberOfComponents())]

    return {"points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
            "names": sorted(names.GetArrayName(k) for k in range(names.GetNumberOfArrays())),
            "whole": body is None or body.GetDataType() in (vtk.VTK_LONG, vtk.VTK_LONG_LONG, vtk.VTK_ID_TYPE),
            "pressure": numbers("contact_pressure"), "displacement": numbers("displacement")}


def main():
    readers = {name: (module, ask) for name, ask in (("meshio", by_meshio), ("vtk", by_vtk)) if (module := installed(name))}
    if not readers:
        return 77
    os.makedirs(folder, exist_ok=True)
    for scene, names in SCENES.items():
        file = os.path.join(folder, os.path.basename(scene).replace(".toml", ".vtu"))
        plain = file.replace(".vtu", "_text.vtu")
        for out, more in (file, []), (plain, ["--ascii"]):
            subprocess.run([program, "solve", os.path.join(sources, scene), "--vtu", out, *more], check=True, stdout=subprocess.DEVNULL)
        want = {"names": names, "whole": True, "pressure": written(plain, "contact_pressure"), "displacement": written(plain, "displacement"),
                "points": len(written(plain, "points")) // 3, "cells": len(written(plain, "offsets"))}
        for out in file, plain:
            for name, (module, ask) in readers.items():
                got = ask(module, out)
                for what, value in want.items():
                    if got[what] != value:
                        return "readers.py: %s of %s by %s: got %.200s, expected %.200s" % (what, out, name, got[what], value)
        if not os.path.getsize(file) < os.path.getsize(plain):
            return "readers.py: %s has %d bytes, as text %d: it should be smaller" % (file, os.path.getsize(file), os.path.getsize(plain))
    print("%d files by %s" % (2 * len(SCENES), " and ".join(readers)))
    return 0


sys.exit(main())
