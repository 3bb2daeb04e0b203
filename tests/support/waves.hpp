// Two bodies that face each other along a wave, and what the points of their pairs read.
#pragma once
#include <cmath>

#include "addons/motion/kept_points.hpp"
#include "signorini/fem/side_curve.hpp"
#include "support/facing_blocks.hpp"

namespace signorini_test {

struct WavesSpec {
  Eigen::Index source_edges = 17;
  Eigen::Index target_edges = 6;
  signorini::MeshOrder source_order = signorini::MeshOrder::Linear;
  signorini::MeshOrder target_order = signorini::MeshOrder::Linear;
  double gap = 0;
  double grading = 1.3;  ///< of the source
};

/// Two blocks whose facing sides follow one wave, with a gap or an overlap that changes along it. The source lies inside.
struct Waves {
  signorini::Mesh source;
  signorini::Mesh target;

  explicit Waves(const WavesSpec& spec)
      : source(block({0.37, 0}, {2.6, 0.5}, spec.source_edges, spec.source_order, spec.grading)),
        target(block({0, -0.5}, {3.4, 0.5}, spec.target_edges, spec.target_order)) {
    const auto wave = [](const Eigen::Vector2d& x) -> Eigen::Vector2d {
      return {x.x(), x.y() + 0.2 * std::sin(1.7 * x.x() + 0.3)};
    };
    source = signorini::mapped(source, [&](const Eigen::Vector2d& x) -> Eigen::Vector2d {
      return wave(x) + Eigen::Vector2d(0, spec.gap * (1 + 0.5 * std::cos(3 * x.x())));
    });
    target = signorini::mapped(target, wave);
  }
  [[nodiscard]] signorini::NodeArray places() const {
    signorini::NodeArray all(source.n_nodes() + target.n_nodes(), 2);
    all << source.nodes, target.nodes;
    return all;
  }
  /// The pairs of the same bodies elsewhere; `kept` receives their points unless it is null.
  [[nodiscard]] signorini::Pairs at(const signorini::NodeArray& places,
                                    signorini::KeptPoints* kept = nullptr) const {
    signorini::Mesh one = source;
    signorini::Mesh other = target;
    one.nodes = places.topRows(source.n_nodes());
    other.nodes = places.bottomRows(target.n_nodes());
    signorini::GapOptions options;
    if (kept != nullptr)
      options.watch = [kept](const signorini::MortarPoints& found, const signorini::Pairs& pairs) {
        *kept = signorini::kept_points(found, pairs);
      };
    return over(one, other, options);
  }
  [[nodiscard]] signorini::KeptPoints points(const signorini::NodeArray& places) const {
    signorini::KeptPoints kept;
    static_cast<void>(at(places, &kept));
    return kept;
  }
};

inline Eigen::VectorXd some_force(const signorini::Pairs& pairs) {
  const Eigen::ArrayXd wave = (2 * pairs.position.col(0).array()).cos();
  return pairs.weight.array() * (2 + wave);
}

/// Adds what a point reads along its normal to a row.
inline void add_reading(const signorini::KeptPoint& point, double share,
                        Eigen::Ref<Eigen::RowVectorXd> row) {
  for (std::size_t k = 0; k < 3; ++k)
    for (const Eigen::Index axis : {0, 1}) {
      const double part = share * point.normal(axis);
      const auto of = static_cast<Eigen::Index>(k);
      if (point.source.node[k] >= 0)
        row(2 * point.source.node[k] + axis) += part * point.source.value(of);
      if (point.target.node[k] >= 0)
        row(2 * point.target.node[k] + axis) -= part * point.target.value(of);
    }
}

/// How long a side of the source is around a place, per xi.
inline double stretch(const signorini::SidePlace& side, const signorini::NodeArray& places) {
  const std::size_t n = side.n_nodes();
  const double xi = side.value(static_cast<Eigen::Index>(n) - 1) - side.value(0);
  Eigen::RowVector2d tangent(0, 0);
  for (std::size_t k = 0; k < n; ++k)
    tangent +=
        signorini::side_shape(n, xi).slope(static_cast<Eigen::Index>(k)) * places.row(side.node[k]);
  return tangent.norm();
}

/// Rows of N whose points count as they did where a source of straight sides was as long as it is in `first`.
inline Eigen::MatrixXd held_rows(const Waves& waves, const signorini::NodeArray& places,
                                 const signorini::NodeArray& first) {
  signorini::KeptPoints kept;
  const signorini::Pairs pairs = waves.at(places, &kept);
  Eigen::VectorXd total = Eigen::VectorXd::Zero(pairs.weight.size());
  Eigen::MatrixXd N = Eigen::MatrixXd::Zero(total.size(), places.size());
  Eigen::RowVectorXd row(places.size());
  for (const signorini::KeptPoint& point : kept.points) {
    const double amount = point.share * pairs.weight(point.pair) * stretch(point.source, first) /
                          stretch(point.source, places);
    total(point.pair) += amount;
    row = N.row(point.pair);
    add_reading(point, amount, row);
    N.row(point.pair) = row;
  }
  return total.cwiseInverse().asDiagonal() * N;
}

}  // namespace signorini_test
