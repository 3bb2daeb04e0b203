#!/usr/bin/env python3
"""med2inp.py FILE.med NEW.inp

A mesh of Salome or Code_Aster as an input file with its groups, which `signorini mesh` and the key kind = "inp" read: groups of cells
become element sets, groups of nodes node sets. `meshio convert` alone would lose the groups. Needs Python's meshio and h5py.
"""
import sys

import meshio

TYPES = {"triangle": "CPS3", "quad": "CPS4", "triangle6": "CPS6", "quad8": "CPS8", "line": "T3D2", "line3": "T3D3"}


def members(groups_of_tags, tags, first, sets):
    """Adds the numbers, from `first` on, of those with the tags of a group to its set."""
    for k, tag in enumerate(tags):
        for group in groups_of_tags.get(int(tag), ()):
            sets.setdefault(group, []).append(first + k)


def card(out, keyword, sets):
    for name, numbers in sets.items():
        out.write("*%s, %s=%s\n" % (keyword, keyword, name))
        out.writelines("%d,\n" % number for number in numbers)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip().splitlines()[0])
    try:
        mesh = meshio.read(sys.argv[1], file_format="med")
    except (OSError, meshio.ReadError) as error:
        sys.exit("med2inp.py: %s: %s" % (sys.argv[1], error))
    except KeyError as error:
        sys.exit("med2inp.py: %s: this is no MED file, it has no %s; of Exodus, meshio convert makes an input file" % (sys.argv[1], error))
    element_sets, node_sets, first = {}, {}, 1
    with open(sys.argv[2], "w", encoding="utf-8") as out:
        out.write("*NODE\n")
        for k, point in enumerate(mesh.points):
            out.write("%d, %s\n" % (k + 1, ", ".join(repr(float(x)) for x in point)))
        for block, cells in enumerate(mesh.cells):
            if cells.type not in TYPES:
                print("med2inp.py: not written: %d cells of type %s" % (len(cells.data), cells.type), file=sys.stderr)
                continue
            out.write("*ELEMENT, TYPE=%s\n" % TYPES[cells.type])
            for k, nodes in enumerate(cells.data):
                out.write("%d, %s\n" % (first + k, ", ".join(str(int(node) + 1) for node in nodes)))
            if "cell_tags" in mesh.cell_data:
                members(mesh.cell_tags, mesh.cell_data["cell_tags"][block], first, element_sets)
            first += len(cells.data)
        if "point_tags" in mesh.point_data:
            members(mesh.point_tags, mesh.point_data["point_tags"], 1, node_sets)
        card(out, "ELSET", element_sets)
        card(out, "NSET", node_sets)


main()
