"""getfem_hertz.py: solves hertz.msh of this folder with GetFEM, nodal contact between non-matching meshes.

Arguments: E and nu of both, pressure on the middle of the disc. Writes getfem.csv: x [mm] and force [N] of every
node of the rim, in rising order, below the number of iterations. Ends with a message if GetFEM has not converged.
"""

import sys

sys.path = [folder for folder in sys.path if folder]  # not what lies in this folder
import getfem
import numpy

modulus, ratio, pressure = [float(word) for word in sys.argv[1:]]
getfem.util("trace level", 1)
names = {}
for line in open("hertz.msh"):
    if line.startswith("$EndPhysicalNames"):
        break
    words = line.split()
    if len(words) == 3:
        names[words[2].strip('"')] = int(words[1])

model = getfem.Model("real")
model.add_initialized_data("lambda", modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)))
model.add_initialized_data("mu", modulus / (2 * (1 + ratio)))
model.add_initialized_data("pressure", [0, -pressure])
model.add_initialized_data("r", modulus)
both = getfem.Mesh("import", "gmsh", "hertz.msh")
fields, methods = {}, {}
for body in ["disc", "plate"]:
    mesh = getfem.Mesh("clone", both)
    mesh.del_convex(numpy.setdiff1d(mesh.cvid(), mesh.region(names[body])[0]))
    fields[body] = getfem.MeshFem(mesh, 2)
    fields[body].set_fem(getfem.Fem("FEM_QK(2,1)"))
    methods[body] = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,3)"))
    model.add_fem_variable(body, fields[body])
    model.add_isotropic_linearized_elasticity_brick(methods[body], body, "lambda", "mu")
    model.add_normal_Dirichlet_condition_with_multipliers(methods[body], body, 1, names[body + "_axis"])
model.add_Dirichlet_condition_with_simplification("plate", names["plate_base"])
model.add_source_term_brick(methods["disc"], "disc", "pressure", names["disc_middle"])

rim = fields["disc"].basic_dof_on_region(names["disc_rim"])[::2]
model.add_nodal_contact_between_nonmatching_meshes_brick(
    methods["disc"], methods["plate"], "disc", "plate", "force", "r", names["disc_rim"],
    names["plate_surface"])
iterations, converged = model.solve("lsolver", "mumps", "max_iter", 100, "max_res", 1e-9)[:2]
if not converged:
    sys.exit(f"GetFEM: not converged after {iterations} iterations")
x, force = fields["disc"].basic_dof_nodes(rim)[0], -model.variable("force")
with open("getfem.csv", "w") as table:
    print(f"# iterations {iterations}\nx,force", file=table)
    for k in numpy.argsort(x):
        print(f"{x[k]:.17g},{force[k]:.17g}", file=table)
