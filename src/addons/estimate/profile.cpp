#include "addons/estimate/profile.hpp"

#include <algorithm>
#include <cmath>

#include "addons/estimate/contact_edges.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/wording.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;

/// The part of a walk around a body that runs on along a line from one of its pairs, and does not turn back.
/// \param ring  whether the first pair follows on the last
template <typename Place>
std::vector<Index> running_on(const std::vector<Index>& walk, bool ring, Index start,
                              Place&& x_of) {
  const std::size_t first = at(std::find(walk.begin(), walk.end(), start) - walk.begin());
  std::vector<Index> line = {start};
  const auto run_on = [&](std::size_t step, std::size_t end) {
    double way = 0;  // of the first step
    for (std::size_t k = first; line.size() < walk.size() && (ring || k != end);) {
      const std::size_t next = (k + step) % walk.size();
      const double by = x_of(walk[next]) - x_of(walk[k]);
      if (way == 0) way = by;
      if (!(way * by > 0)) break;
      line.push_back(walk[next]);
      k = next;
    }
  };
  run_on(1, walk.size() - 1);
  run_on(walk.size() - 1, 0);
  return line;
}

}  // namespace

std::vector<Index> pairs_of(const Model& model, const std::string& contact) {
  const auto found = std::find(model.contacts.begin(), model.contacts.end(), contact);
  const bool only = contact.empty() && model.contacts.size() == 1;
  require_input(only || found != model.contacts.end(),
                contact.empty() ? text("a goal of contact must name one of several contacts: ")
                                : text("there is no contact ", in_quotes(contact), " for a goal"),
                contact.empty() ? listed(model.contacts) : suggestion(contact, model.contacts));
  const std::size_t number = only ? 0 : at(found - model.contacts.begin());
  std::vector<Index> pairs;
  for (Index pair = 0; pair < model.pairs.weight.size(); ++pair)
    if (model.contact_of[at(pair)] == number) pairs.push_back(pair);
  return pairs;
}

ContactLine line_of(const Model& model, const std::string& contact, const Vector2d& middle) {
  std::vector<Index> pairs = pairs_of(model, contact);
  const auto away = [&](Index pair) {
    return (model.pairs.position.row(pair).transpose() - middle).squaredNorm();
  };
  Index nearest = -1;
  for (const Index pair : pairs) {
    require_input(
        model.pairs.node[at(pair)] >= 0,
        "a width or a peak of pressure cannot be read from the pairs of ",
        model.contacts[model.contact_of[at(pair)]],
        ", which are Gauss points, whose forces are not unique; use the gap operator mortar or "
        "node_to_segment");
    if (nearest < 0 || away(pair) < away(nearest)) nearest = pair;
  }
  require_input(
      nearest >= 0,
      "a width or a peak of pressure needs a contact that can close; none of its pairs can move");
  const Vector2d normal = model.pairs.normal.row(nearest).transpose().normalized();
  const Vector2d along(normal.y(), -normal.x());
  ContactLine line;
  if (depth_of(source_of(model, nearest).material).axial && middle.x() == 0)
    line.footprint = Footprint::Circle;
  const auto x_of = [&](Index pair) {
    return along.dot(model.pairs.position.row(pair).transpose() - middle);
  };
  const std::vector<ContactEdge> edges = contact_edges(model);
  const bool ring = std::any_of(edges.begin(), edges.end(), [&](const ContactEdge& edge) {
    return edge.from == pairs.back() && edge.to == pairs.front();
  });
  pairs = running_on(pairs, ring, nearest, x_of);
  std::stable_sort(pairs.begin(), pairs.end(), [&](Index a, Index b) { return x_of(a) < x_of(b); });
  line.pair = pairs;
  for (const Index pair : pairs) line.x.push_back(x_of(pair));
  return line;
}

Profile profile(const Model& model, const Solution& solution, const std::string& contact,
                const Vector2d& middle) {
  Profile read{line_of(model, contact, middle), {}, {}, {}, Trace::Linear};
  const std::vector<Index>& pair = read.line.pair;
  const Index n = static_cast<Index>(pair.size());
  const auto nearest =
      std::min_element(read.line.x.begin(), read.line.x.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); });
  const Index there = pair[at(nearest - read.line.x.begin())];
  const Vector2d across = model.pairs.normal.row(there).transpose().normalized();
  if (source_of(model, there).mesh.order() == MeshOrder::Quadratic) read.trace = Trace::Quadratic;
  std::vector<Index> column(at(model.pairs.opening.cols() / 2), -1);
  for (Index k = 0; k < n; ++k) column[at(model.pairs.node[at(pair[at(k)])])] = k;
  read.nodal = Eigen::MatrixXd::Zero(n, n);
  for (Index k = 0; k < n; ++k)
    for (NodalRows::InnerIterator entry(model.pairs.opening, pair[at(k)]); entry; ++entry)
      if (const Index node = column[at(entry.col() / 2)]; node >= 0)
        read.nodal(node, k) += entry.value() * across(entry.col() % 2);
  if (read.line.footprint == Footprint::Strip && depth_of(source_of(model, there).material).axial)
    for (Index k = 0; k < n; ++k)
      read.nodal.row(k) *= model.pairs.position(there, 0) / model.pairs.position(pair[at(k)], 0);
  const VectorXd force = read.nodal * solution.contact.force(pair);
  read.force.assign(force.begin(), force.end());
  for (const Index own : pair)
    read.pressure.push_back(solution.contact.force(own) / model.pairs.weight(own));
  return read;
}

}  // namespace signorini
