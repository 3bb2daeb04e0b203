// # The plan of a scene
//
// A plan says what will be computed before anything is computed. It names elements and
// materials, numbers unknowns, finds pairs, and asks every effect whether it is present. It
// assembles nothing. Its second purpose is to refuse. An error in the first second, with the
// name of the body, is better than a singular matrix after an hour. What needs no mesh is
// refused first, in check_scene.cpp.
//
// For example, the cantilever of examples/cantilever.toml has 100 times 10 cells and 101 times 11 nodes. Its
// left side holds 11 of them, so that 2200 unknowns are left. 101 nodes of its lower side may
// touch the ground, and the one that is held can not: A has 100 rows.
//
// Nothing later looks at the scene. So what is not in the plan has no effect on the answer.

#include <ostream>
#include <utility>

#include "signorini/core/bytes.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/check_scene.hpp"
#include "signorini/scene/checks.hpp"
#include "signorini/scene/effects.hpp"
#include "signorini/scene/motions.hpp"
#include "signorini/scene/notes.hpp"

namespace signorini {
namespace {

using Eigen::Index;

// A triangle is a cell with 3 corners where a quadrilateral has 4.
Index count_triangles(const Mesh& mesh) {
  Index count = 0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell) count += 4 - mesh.corners(cell);
  return count;
}

// A mixed mesh has two elements: the user names the one of the quadrilaterals, and the triangles
// beside them follow from it. The plan tells both.
std::string elements_in_words(const Mesh& mesh, const Element& element) {
  const Index triangles = element.corners() == 3 ? 0 : count_triangles(mesh);
  if (triangles == 0) return element.name;
  return text(element.name, " and ", triangles, " of them ", triangle_beside(mesh).name);
}

// What to know of an element that is stiffer than the body; empty if there is none. A body
// resists a change of volume \f$ 2(1 + \nu) / (3(1 - 2\nu)) \f$ times as much as a change of
// shape: 2.2 times for \f$ \nu = 0.3 \f$, 50 times for 0.49. Cells that cannot keep their
// volume when they bend are then far too stiff. The displacements of quadratic cells are
// still right there, but the mean stress in them jumps from point to point: in a tube by 3 % of its
// pressure for 0.49, by half of it for 0.499.
std::string note_on_locking(const Mesh& mesh, const Element& element, const Material& material) {
  const double nu = material.state == PlaneState::Stress ? 0 : material.poisson_ratio;
  const auto sentence = [&](const char* what, const char* way_out) {
    return text(what, " for Poisson's ratio ", nu, " in ", to_string(material.state), way_out);
  };
  if (nu > 0.4 && std::string(element.name) == "q4")
    return sentence("q4 locks", " and bears too much load: use q4_bbar or q4_incompatible");
  if (nu > 0.495 && mesh.order() == MeshOrder::Quadratic)
    return sentence("stresses and pressures of q8 and t6 oscillate", ": use q4_bbar");
  const Index triangles = mesh.order() == MeshOrder::Linear ? count_triangles(mesh) : 0;
  if (triangles == 0) return "";
  if (nu > 0.4)
    return sentence("t3 locks", " and bears too much load: use quadrilaterals, or t6 up to 0.495");
  return text("t3 (", triangles, " of ", mesh.n_cells(), " cells of '", mesh.name,
              "') is too stiff where the body bends: use triangles of 6 nodes (t6), or ",
              "quadrilaterals");
}

// Layers may lock where the rest of the body does not. Equal notes in a row are written
// once.
void note_on_body(const Body& body, const Element& element, std::vector<std::string>& notes) {
  std::string last = note_on_locking(body.mesh, element, body.material);
  if (!last.empty()) notes.push_back(last);
  for (const Layer& layer : body.layers) {
    const std::string note = note_on_locking(body.mesh, element, layer.material);
    if (!note.empty() && note != last) notes.push_back(note);
    last = note;
  }
}

// What a body is of that names no element. Internal modes of cells under finite strain bend into
// hourglasses when they are pressed; the mean of the volume is the next best there.
const Element& element_of(const Body& body) {
  const Element& usual = element_for(body.mesh, body.element);
  const bool modes = usual.relax != nullptr && body.material.law != nullptr;
  return modes && body.element.empty() ? find_element("q4_bbar") : usual;
}

// Mesh, element and material are checked in this order: an element can only be judged on a
// mesh that is sound. Numbers of nodes and unknowns go on where the body before ended: a body
// behind the cantilever begins with node 1111 and unknown 2200.
//
// An error of the material carries the name of the body, because check_material() does not know
// it. Regions are only looked up here. What their layers do to the stiffness is an effect.
void plan_body(const Body& body, Plan& plan) {
  const std::string& name = body.mesh.name;
  plan.quality.push_back(check_mesh(body.mesh));
  const Element& element = element_of(body);
  try {
    check_material(body.material);
  } catch (const ProblemError& error) {
    throw ProblemError(text("body '", name, "': ", error.what()));
  }
  Unknowns unknowns = number_unknowns(body.mesh, body.supports, body.material.state);
  const Index count = unknowns.count;
  plan.on.push_back(text("body '", name, "': ", body.mesh.n_cells(), " cells ",
                         elements_in_words(body.mesh, element), ", ", count, " unknowns, ",
                         to_string(body.material.state)));
  if (const Index given = 2 * body.mesh.n_nodes() - count; given > 0)
    plan.on.push_back(text("supports of '", name, "': ", given, " displacements given"));
  note_on_body(body, element, plan.notes);
  const Index first_node = count_nodes(plan.bodies);
  const Index first_unknown =
      plan.bodies.empty() ? 0 : plan.bodies.back().first_unknown + plan.bodies.back().unknowns.count;
  plan.bodies.push_back({body.mesh, element, body.material, body.loads, std::move(unknowns),
                         first_node, first_unknown});
  plan.bodies.back().pieces = pieces(body.mesh);
}

// What supports leave: the unknowns of all bodies, and their rigid motions. A body without any
// support has three of these, one that is held along y has one. Whether contact stops them is
// asked later, by the last effect of the table.
void plan_unknowns(const Scene& scene, Plan& plan) {
  std::vector<const Unknowns*> unknowns;
  for (const BodyModel& body : plan.bodies) unknowns.push_back(&body.unknowns);
  plan.unknowns = joined(unknowns);
  plan.modes = rigid_modes(plan.bodies);
  for (const BodyModel& body : plan.bodies) ask_checks(plan.notes, &Check::mesh, scene, body);
}

// Rows of A, of gaps and of slips. They are what contact costs: the compliance has as many rows
// and columns, and each of its columns takes a solve with the factor of K.
struct Rows {
  Index count;
  long long bytes;
};

// An effect is asked for nothing but its rows. What it takes is the difference before and
// after.
Rows rows_of(const Plan& plan) {
  Rows rows{plan.gaps.A.rows() + static_cast<Index>(plan.law.pair.size()), bytes_of(plan.gaps.A)};
  for (const Index pair : plan.law.pair)
    rows.bytes += bytes_of_row(plan.gaps.T.row(pair).nonZeros());
  return rows;
}

// Each effect sees the draft with all that effects before it took. An absent one is named as
// off and costs nothing more.
// [effects]
void plan_effects(const Scene& scene, Plan& plan) {
  for (const Effect& effect : effects())
    if (effect.present(scene, plan)) {
      const Rows before = rows_of(plan);
      effect.declare(scene, plan);
      plan.effects.push_back(&effect);
      const Rows after = rows_of(plan);
      if (after.count > before.count)
        plan.on.back() += text("; ", effect.name, " takes ", after.count - before.count,
                               " rows of A, ", after.bytes - before.bytes, " bytes");
    } else {
      plan.off.emplace_back(effect.name);
    }
}
// [effects]

// A solver that tries all sets is for a few pairs only. It is refused now and not after the
// factorisation. How many pairs there are is known only here, after contact has found them and
// supports have taken those that cannot move.
void check_pairs(const Plan& plan) {
  const std::string why = too_many(plan.solver, plan.gaps.A.rows());
  require_input(why.empty(), "solver '", plan.solver.name, "' ", why, ": take the default, '",
                Scene().solver.name, "'");
}

}  // namespace

// The order is from what needs least to what needs most: names, meshes, supports, effects.
//
// Matrices get their number of columns even if they have no rows. So effects may stack rows
// below them without a branch. An error of an effect carries the notes so far.
Plan plan(const Scene& scene) {
  Plan plan;
  check_scene(scene);
  for (const Body& body : scene.bodies) plan_body(body, plan);
  plan_unknowns(scene, plan);
  plan.gaps.A.resize(0, plan.unknowns.count);
  const Index components = 2 * count_nodes(plan.bodies);
  plan.gaps.pairs.opening.resize(0, components);
  plan.gaps.pairs.sliding.resize(0, components);
  plan.solver = scene.solver;
  plan.backend = scene.backend;
  with_context(plan.notes, [&] {
    plan_effects(scene, plan);
    check_pairs(plan);
  });
  for (const Body& body : scene.bodies) ask_checks(plan.notes, &Check::loads, body);
  if (plan.gaps.A.rows() > 0)
    plan.on.push_back(text("solver ", plan.solver.name, ", certified from K, p, A, g"));
  return plan;
}

// One line per effect, on or off: a reader sees what was left out, too. A scene file with a
// misspelt key is refused elsewhere, but a load that was forgotten shows only here.
void print(std::ostream& out, const Plan& plan, const std::vector<std::string>& notes) {
  for (const std::string& line : plan.on) out << "  on    " << line << '\n';
  for (const std::string& line : plan.off) out << "  off   " << line << '\n';
  for (const std::string& line : notes) out << "  note  " << line << '\n';
}

std::ostream& operator<<(std::ostream& out, const Plan& plan) {
  print(out, plan, plan.notes);
  return out;
}

}  // namespace signorini
