#include "addons/along/probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "addons/along/arc_length.hpp"
#include "addons/along/place_in_mesh.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/plane.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"
#include "signorini/report/nodal_fields.hpp"
#include "signorini/scene/bodies.hpp"
#include "signorini/scene/effects.hpp"

namespace signorini {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::VectorXd;
using Columns = std::vector<PairColumn>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// One row of a probe.
struct Place {
  Vector2d at;
  double distance;
  std::vector<Index> nodes;  // of the body; none where it has no place
  VectorXd share;
};

/// Adds columns x and y.
void add_vectors(const std::string& name, const char* unit, const NodeArray& values,
                 Columns& columns) {
  columns.push_back({name + "_x", unit, "", values.col(0)});
  columns.push_back({name + "_y", unit, "", values.col(1)});
}

/// What probes of one solution have in common: stresses and contact at nodes, found once.
class Reader {
 public:
  Reader(const Model& model, const Solution& solution, const std::optional<PathTotals>& totals)
      : model_(model), solution_(solution) {
    if (!model.contacts.empty()) contact_ = nodal_fields(model, solution, totals);
    for (const Effect* effect : model.effects)
      for (const std::string word : {"friction", "cohesion"}) frictional_ = frictional_ || effect->name == word;
  }

  [[nodiscard]] Columns read(const Probe& probe) {
    b_ = body_index(model_.bodies, {"", probe.body});
    return probe.of.empty() ? of_places(probe) : of_boundary(probe.of);
  }

 private:
  [[nodiscard]] const BodyModel& body() const { return model_.bodies[b_]; }

  [[nodiscard]] std::vector<Place> places(const Probe& probe) const {
    std::vector<Place> all;
    const Mesh& mesh = body().mesh;
    if (probe.along.empty()) {
      for (Index k = 0; k < probe.points.rows(); ++k) {
        const Vector2d at = probe.points.row(k);
        PlaceInMesh place = place_in_mesh(mesh, body().element, at);
        if (probe.line && is_outside(place)) place = {};
        all.push_back({at, (probe.points.row(k) - probe.points.row(0)).norm(),
                       std::move(place.nodes), std::move(place.share)});
      }
      return all;
    }
    const std::map<Index, double> lengths = ArcLength(mesh, probe.along).of_nodes();
    for (const Index node : boundary_nodes(mesh, probe.along))
      all.push_back({mesh.nodes.row(node), lengths.at(node), {node}, VectorXd::Ones(1)});
    return all;
  }

  /// Values at places from those at the nodes of the body.
  template <typename Values>
  [[nodiscard]] Eigen::MatrixXd between(const std::vector<Place>& places,
                                        const Values& values) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Constant(static_cast<Index>(places.size()), values.cols(), none);
    for (std::size_t k = 0; k < places.size(); ++k)
      if (!places[k].nodes.empty())
        all.row(static_cast<Index>(k)) =
            places[k].share.transpose() * values(places[k].nodes, Eigen::all);
    return all;
  }

  const StressArray& stress() {
    const auto found = stress_.find(b_);
    if (found != stress_.end()) return found->second;
    return stress_[b_] = nodal_stress(body().mesh, body().element, body().material,
                                      solution_.displacements[b_]);
  }

  Columns of_places(const Probe& probe) {
    const std::vector<Place> rows = places(probe);
    Columns columns;
    NodeArray at(rows.size(), 2);
    VectorXd distance(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      at.row(static_cast<Index>(k)) = rows[k].at;
      distance(static_cast<Index>(k)) = rows[k].distance;
    }
    if (probe.line || !probe.along.empty())
      columns.push_back({"distance", "length", "", std::move(distance)});
    columns.push_back({"x", "length", "", at.col(0)});
    columns.push_back({"y", "length", "", at.col(1)});
    add_vectors("displacement", "length", between(rows, solution_.displacements[b_]), columns);
    const Eigen::MatrixXd tensors = between(rows, stress());
    const char* const parts[] = {"xx", "yy", "xy", "zz"};
    for (Index k = 0; k < 4; ++k)
      columns.push_back({text("stress_", parts[k]), "force/length^2", "", tensors.col(k)});
    VectorXd mises(tensors.rows());
    for (Index k = 0; k < mises.size(); ++k) mises(k) = von_mises(tensors.row(k).transpose());
    columns.push_back({"von_mises", "force/length^2", "", std::move(mises)});
    add_contact(rows, columns);
    if (!probe.along.empty()) add_forces(rows, columns);
    return columns;
  }

  /// A field of contact at nodes; null if no pair has it now.
  [[nodiscard]] const NodalField* field(const std::string& name) const {
    for (const NodalField& one : contact_)
      if (one.name == name) return &one;
    return nullptr;
  }

  /// Gap, pressure and shear where all nodes that share a place have a pair: columns stay when pairs come and go.
  void add_contact(const std::vector<Place>& rows, Columns& columns) const {
    if (model_.contacts.empty()) return;
    std::vector<std::string> names = {"contact_gap", "contact_pressure"};
    if (frictional_) names.emplace_back("contact_shear_traction");
    const NodalField* const status = field("contact_status");
    const Index first = body().first_node;
    for (const std::string& name : names) {
      VectorXd values = VectorXd::Constant(static_cast<Index>(rows.size()), none);
      if (const NodalField* const one = field(name); one != nullptr && status != nullptr) {
        values = between(rows, one->values.middleRows(first, body().mesh.n_nodes()));
        for (std::size_t k = 0; k < rows.size(); ++k)
          for (std::size_t i = 0; i < rows[k].nodes.size(); ++i)
            if (std::abs(rows[k].share(static_cast<Index>(i))) > 1e-9 &&
                status->values(first + rows[k].nodes[i]) < 0)
              values(static_cast<Index>(k)) = none;
      }
      const char* const unit = name == "contact_gap" ? "length" : "force/length^2";
      columns.push_back({name, unit, "", std::move(values)});
    }
  }

  /// What acts on the nodes of the body, with names; what is not there is not among them.
  [[nodiscard]] std::vector<std::pair<std::string, NodeArray>> forces() const {
    std::vector<std::pair<std::string, NodeArray>> all;
    if (!model_.contacts.empty())
      all.emplace_back("contact", contact_forces(model_, solution_, b_));
    const auto held = body().unknowns.number.array() < 0;
    if (held.any()) {
      const NodeArray support = support_forces(model_, solution_, b_);
      // On components that are free it is the rounding of the run.
      all.emplace_back("support", held.select(support.array(), 0.0).matrix());
    }
    if (body().springs.rows() > 0) all.emplace_back("spring", spring_forces(model_, solution_, b_));
    if (model_.equations) all.emplace_back("bond", solution_.bond_forces[b_]);
    return all;
  }

  void add_forces(const std::vector<Place>& rows, Columns& columns) const {
    for (const auto& [name, force] : forces())
      add_vectors(name + "_force", "force", between(rows, force), columns);
  }

  [[nodiscard]] Columns of_boundary(const std::string& boundary) const {
    const Mesh& mesh = body().mesh;
    const NodeArray& u = solution_.displacements[b_];
    const std::vector<Index> nodes = boundary_nodes(mesh, boundary);
    const VectorXd weight = boundary_weights(mesh, boundary, depth_of(body().material));
    Columns columns;
    add_vectors("displacement", "length", weight.transpose() * u(nodes, Eigen::all) / weight.sum(),
                columns);
    const bool axial = is_axial(body());
    for (const auto& [name, force] : forces()) {
      Vector2d sum = Vector2d::Zero();
      double moment = 0;
      for (const Index node : nodes) {
        const Vector2d f = force.row(node);
        Vector2d arm = mesh.nodes.row(node);
        if (model_.standing) arm += u.row(node).transpose();
        sum += f;
        moment += cross(arm, f);
      }
      if (axial) sum.x() = moment = none;
      add_vectors(name + "_force", "force", sum.transpose(), columns);
      columns.push_back({name + "_moment", "force*length", "", VectorXd::Constant(1, moment)});
    }
    return columns;
  }

  const Model& model_;
  const Solution& solution_;
  bool frictional_ = false;  // whether the scene has friction
  std::vector<NodalField> contact_;
  std::map<std::size_t, StressArray> stress_;  // by number of the body
  std::size_t b_ = 0;                          // that is read
};

}  // namespace

NodeArray points_between(const Vector2d& from, const Vector2d& to, Index count) {
  require_argument(count >= 2, "points_between: a line needs 2 points or more, got ", count);
  NodeArray points(count, 2);
  for (Index k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    points.row(k) = ((1 - share) * from + share * to).transpose();
  }
  return points;
}

std::vector<Columns> probed(const Model& model, const Solution& solution,
                            const std::vector<Probe>& probes,
                            const std::optional<PathTotals>& totals) {
  check_solved(solution, totals, "probed");
  Reader reader(model, solution, totals);
  std::vector<Columns> all;
  for (const Probe& probe : probes) all.push_back(reader.read(probe));
  return all;
}

Columns table_of(const std::vector<Probe>& probes, const std::vector<Columns>& columns) {
  Index rows = 0;
  for (const Columns& of_one : columns) rows += of_one.front().values.size();
  Columns table = {{"probe", "-", "", VectorXd(rows), {}}};
  Index first = 0;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const Index own = columns[k].front().values.size();
    table.front().words.push_back(probes[k].name);
    table.front().values.segment(first, own).setConstant(static_cast<double>(k));
    for (const PairColumn& column : columns[k]) {
      auto same = std::find_if(table.begin(), table.end(),
                               [&](const PairColumn& known) { return known.name == column.name; });
      if (same == table.end()) {
        table.push_back({column.name, column.unit, "", VectorXd::Constant(rows, none)});
        same = table.end() - 1;
      }
      same->values.segment(first, own) = column.values;
    }
    first += own;
  }
  return table;
}

}  // namespace signorini
