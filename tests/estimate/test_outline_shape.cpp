// What the outline of a body does between its nodes.
#include <cmath>

#include "addons/estimate/outline_shape.hpp"
#include "catch_compat.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"

using Eigen::Index;
using Eigen::Vector2d;
using namespace signorini;

namespace {

/// A strip of one row of cells between given tops and y = -5: the line of its tops is the outline.
Mesh under(const std::vector<Vector2d>& tops) {
  Mesh mesh = block("block", {0, 0}, {1, 1}, static_cast<Index>(tops.size()) - 1, 1);
  for (std::size_t k = 0; k < tops.size(); ++k) {
    const Index node = static_cast<Index>(k);
    mesh.nodes.row(node) << tops[k].x(), -5;
    mesh.nodes.row(node + static_cast<Index>(tops.size())) = tops[k];
  }
  return mesh;
}

/// The middle of the way from top k to top k + 1; the outline is walked from right to left there.
Vector2d middle(const Mesh& mesh, Index k) {
  const Index tops = mesh.n_nodes() / 2;
  return OutlineShape(mesh).middle(tops + k + 1, tops + k);
}

/// A line at y = 0 up to x = 0, then an arc of radius R below it, then its tangent.
std::vector<Vector2d> line_and_arc(double R, double step, int steps) {
  std::vector<Vector2d> tops = {{-3, 0}, {-2, 0}, {-0.5, 0}};
  for (int k = 0; k <= steps; ++k)
    tops.emplace_back(R * std::sin(k * step), R * std::cos(k * step) - R);
  const Vector2d along(std::cos(steps * step), -std::sin(steps * step));
  const Vector2d end = tops.back();
  for (const double s : {0.4, 1.0, 2.0}) tops.emplace_back(end + s * along);
  return tops;
}

}  // namespace

TEST_CASE("a line that runs into an arc stays a line, and the arc an arc", "[refinement]") {
  const double R = 2;
  const double step = 0.1;
  const int steps = 5;
  const Mesh mesh = under(line_and_arc(R, step, steps));
  for (const Index k : {0, 1, 2}) CHECK(middle(mesh, k).y() == Approx(0).margin(1e-15));
  for (Index k = 0; k < steps; ++k) {
    const double angle = (static_cast<double>(k) + 0.5) * step;
    const Vector2d place(R * std::sin(angle), R * std::cos(angle) - R);
    CHECK((middle(mesh, 3 + k) - place).norm() == Approx(0).margin(1e-14));
  }
  const Index last = 3 + steps;
  const Index tops = mesh.n_nodes() / 2;
  for (Index k = last; k + 1 < tops; ++k) {
    const Vector2d half = (mesh.nodes.row(tops + k) + mesh.nodes.row(tops + k + 1)) / 2;
    CHECK((middle(mesh, k) - half).norm() == Approx(0).margin(1e-14));
  }
}

TEST_CASE("corners and single sides between two lines stay as they are", "[refinement]") {
  // A kink of 6 degrees between lines, then a side that takes off a corner.
  const Mesh mesh =
      under({{0, 0}, {1, 0}, {2, 0.1}, {3, 0.2}, {4, 0.3}, {5, 0}, {6, -0.3}, {7, -0.6}});
  const Index tops = mesh.n_nodes() / 2;
  for (Index k = 0; k + 1 < tops; ++k) {
    const Vector2d half = (mesh.nodes.row(tops + k) + mesh.nodes.row(tops + k + 1)) / 2;
    CHECK((middle(mesh, k) - half).norm() == Approx(0).margin(1e-15));
  }
  const Mesh chamfer =
      under({{0, 0}, {1, 0}, {2, 0}, {2.5, -0.2}, {3, -1}, {3.5, -1.8}, {4, -2.6}});
  const Vector2d half(2.25, -0.1);
  CHECK((middle(chamfer, 2) - half).norm() == Approx(0).margin(1e-15));
}

TEST_CASE("where two arcs meet at an angle, each keeps its own circle", "[refinement]") {
  std::vector<Vector2d> tops;
  for (int k = 0; k <= 6; ++k)  // of radius 2 about (-1.5, 0), from 90 to 50 degrees
    tops.emplace_back(-1.5 + 2 * std::cos(1.6 - 0.12 * k), 2 * std::sin(1.6 - 0.12 * k));
  const Vector2d meet = tops.back();
  const Vector2d centre = meet + 3 * Vector2d(std::cos(-0.9), std::sin(-0.9)) * -1;
  for (int k = 1; k <= 5; ++k)
    tops.emplace_back(centre + 3 * Vector2d(std::cos(-0.9 - 0.1 * k), std::sin(-0.9 - 0.1 * k)));
  const Mesh mesh = under(tops);
  CHECK((middle(mesh, 5) - Vector2d(-1.5, 0)).norm() == Approx(2).epsilon(1e-14).margin(0));
  CHECK((middle(mesh, 6) - centre).norm() == Approx(3).epsilon(1e-14).margin(0));
}

TEST_CASE("on a circle of unequal sides every middle lies on the circle", "[refinement]") {
  std::vector<Vector2d> tops;
  double angle = 0.9;
  for (const double step : {0.02, 0.3, 0.05, 0.4, 0.1, 0.1, 0.6, 0.01, 0.3}) {
    tops.emplace_back(7 - 3 * std::cos(angle), 3 * std::sin(angle));
    angle += step;
  }
  const Mesh mesh = under(tops);
  for (Index k = 0; k + 1 < static_cast<Index>(tops.size()); ++k)
    CHECK((middle(mesh, k) - Vector2d(7, 0)).norm() == Approx(3).epsilon(1e-14));
}
