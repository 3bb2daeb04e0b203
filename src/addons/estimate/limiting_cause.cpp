#include "addons/estimate/limiting_cause.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "addons/estimate/contact_edges.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/scene/bodies.hpp"

namespace signorini {
namespace {

using Eigen::Index;

/// Where a source that presses ends at a held node; empty if none does.
std::string held_end(const AccurateSolution& run) {
  std::vector<std::vector<char>> presses;  // of the nodes of each body
  for (const BodyModel& body : run.model.bodies) presses.emplace_back(at(body.mesh.n_nodes()), 0);
  for (const Index pair : run.solution.contact.active())
    presses[source_index(run.model, pair)][at(run.model.pairs.node[at(pair)])] = 1;
  for (const ContactSpec& contact : run.scene.contacts) {
    const std::size_t b = body_index(run.model.bodies, contact.source);
    const BodyModel& body = run.model.bodies[b];
    for (const CellSide& side : boundary(body.mesh, contact.source.boundary)) {
      const std::vector<Index> nodes = body.mesh.side_nodes(side);
      const auto held = std::find_if(nodes.begin(), nodes.end(), [&](Index node) {
        return body.unknowns.number(node, 0) < 0 && body.unknowns.number(node, 1) < 0;
      });
      const bool pressed = std::any_of(nodes.begin(), nodes.end(),
                                       [&](Index node) { return presses[b][at(node)] != 0; });
      if (held != nodes.end() && pressed)
        return text("the source ", in_quotes(contact.source.boundary), " of body '", body.mesh.name,
                    "' presses up to ", in_brackets(body.mesh.nodes.row(*held)),
                    ", which is held: pressures grow without bound there; end it before");
    }
  }
  return {};
}

}  // namespace

std::string limiting_cause(const AccurateSolution& run) {
  const AccuracyRound& last = run.rounds.back();
  if (!last.error) return "the mesh is too coarse for an estimate";
  const bool unforeseen = last.saturation > 0 && *last.error == last.saturation;
  if (unforeseen || (last.to_come > 0 && *last.error == last.to_come)) {
    const std::string end = held_end(run);
    return (unforeseen
                ? "changes from mesh to mesh that no estimate foresaw are most of the error"
                : "answers still change from mesh to mesh by more than their estimates say") +
           (end.empty() ? end : "; " + end);
  }
  if (last.model_error > 0 && *last.error == last.model_error)
    return "the reading is most of the error: ellipses fitted to different parts of the pressure "
           "differ, so it does not press as Hertz's contact does; ask for its force or for a "
           "displacement";
  const ErrorParts& parts = last.parts;
  const double outline = std::abs(parts.outline);
  const double gap = std::abs(parts.gap) + std::abs(parts.quadrature_error);
  const double edge = std::abs(parts.free_boundary);
  const double inside = std::abs(parts.interior);
  if (outline > inside && outline > edge && outline > gap)
    return "what straight sides cut off curved outlines is most of the error";
  if (gap > inside && gap > edge)
    return "gaps between the nodes of the contact are most of the error";
  if (edge > inside) return "where contact ends is most of the error";
  std::size_t body = 0;
  Index cell = 0;
  double largest = -1;
  for (std::size_t b = 0; b < run.estimate->share.size(); ++b) {
    Index here = 0;
    const double most = run.estimate->share[b].cwiseAbs().maxCoeff(&here);
    if (most > largest) std::tie(largest, body, cell) = std::make_tuple(most, b, here);
  }
  const Mesh& mesh = run.model.bodies[body].mesh;
  const Eigen::RowVector2d x = mesh.nodes.row(mesh.cells(cell, 0));
  return text("stresses inside the bodies are most of the error, most of all in the cell at (",
              x.x(), ", ", x.y(), ") of body '", mesh.name, '\'');
}

}  // namespace signorini
