// What a panel may be given to draw.
#include <algorithm>
#include <cmath>
#include <limits>

#include "live/figure.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"

namespace live {

void Panel::curve(std::string label, Look look, const VectorXd& x, const VectorXd& y) {
  layers.push_back({std::move(label), look, x, y, 0, {}});
}

void Panel::trail(std::string label, std::string series, double x, double y) {
  curve(std::move(label), Look::Trail, VectorXd::Constant(1, x), VectorXd::Constant(1, y));
  layers.back().series = std::move(series);
  curve("", Look::Here, layers.back().x, layers.back().y);
}

void Panel::points(const std::string& label, const VectorXd& x, const VectorXd& y,
                   const VectorXd& pressure, const char* some, const char* none) {
  for (const bool closed : {false, true}) {
    std::vector<Index> at;
    for (Index k = 0; k < x.size(); ++k)
      if ((pressure(k) > 0) == closed) at.push_back(k);
    if (!at.empty())
      curve(label + ", " + (closed ? some : none), closed ? Look::Closed : Look::Open, x(at),
            y(at));
  }
}

void Panel::motions(const VectorXd& x, const VectorXd& y, const signorini::ContactState& contact) {
  for (const bool slide : {false, true}) {
    const std::vector<Index> at = closed_pairs(contact, slide);
    if (!at.empty())
      curve(slide ? "slides" : "sticks", slide ? Look::Open : Look::Closed, x(at), y(at));
  }
}

void Panel::cells(std::string label, const MatrixXd& corner,
                  const Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic>& cell,
                  const VectorXd& value, double most) {
  Layer layer{std::move(label), Look::Line, {}, {}, cell.cols(), value, 0, most, true};
  layer.x.resize(cell.size());
  layer.y.resize(cell.size());
  for (Index k = 0, n = 0; k < cell.rows(); ++k)
    for (Index c = 0; c < cell.cols(); ++c, ++n) {
      layer.x(n) = corner(cell(k, c), 0);
      layer.y(n) = corner(cell(k, c), 1);
    }
  layers.push_back(std::move(layer));
}

void Panel::map(std::string label, const VectorXd& x, const VectorXd& y,
                const std::function<double(double, double)>& value, double least, double most) {
  const Index columns = x.size() - 1;
  const Index rows = y.size() - 1;
  Layer layer{std::move(label),
              Look::Line,
              VectorXd(4 * columns * rows),
              VectorXd(4 * columns * rows),
              4,
              VectorXd(columns * rows),
              least,
              most};
  for (Index i = 0, n = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j, ++n) {
      layer.x.segment<4>(4 * n) << x(j), x(j + 1), x(j + 1), x(j);
      layer.y.segment<4>(4 * n) << y(i), y(i), y(i + 1), y(i + 1);
      layer.value(n) = value((x(j) + x(j + 1)) / 2, (y(i) + y(i + 1)) / 2);
    }
  layers.push_back(std::move(layer));
}

namespace {

const double root = std::sqrt(3.);  // twice the height of the triangle of weights

// Each half of a parallelogram of the grid over two sides of the triangle is a cell; none is cut by the third side.
Layer cells_of_triangle(Index n, const std::function<double(const Eigen::Vector3d&)>& value) {
  Layer layer;
  layer.corners = 3;
  layer.x.resize(3 * n * n);
  layer.y.resize(3 * n * n);
  layer.value.resize(n * n);
  Index cell = 0;
  const auto add = [&](Index i, Index j,
                       Index up) {  // rows i of the second weight, columns j of the third
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const Index corner[3][2] = {{i + up, j}, {i + 1, j + up}, {i, j + 1}};
    for (Index c = 0; c < 3; ++c) {
      const double b = static_cast<double>(corner[c][0]) / static_cast<double>(n);
      const double d = static_cast<double>(corner[c][1]) / static_cast<double>(n);
      const Eigen::Vector3d weights(1 - b - d, b, d);
      const Eigen::Vector2d place = in_triangle(weights);
      layer.x(3 * cell + c) = place.x();
      layer.y(3 * cell + c) = place.y();
      middle += weights / 3;
    }
    layer.value(cell++) = value(middle);
  };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; i + j < n; ++j) {
      add(i, j, 0);
      if (i + j + 1 < n) add(i, j, 1);
    }
  return layer;
}

}  // namespace

Eigen::Vector2d in_triangle(const Eigen::Vector3d& weights) {
  return {weights(1) + weights(2) / 2, root / 2 * weights(2)};
}

void Panel::triangle(std::string label, const std::function<double(const Eigen::Vector3d&)>& value,
                     const std::vector<double>& levels, std::string words, double most,
                     const std::string& first, const std::string& second) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto at = [&](double x, double y) {
    const double third = 2 * y / root, middle = x - third / 2, left = 1 - middle - third;
    const bool within = std::min({left, middle, third}) > -1e-9;
    return within ? value({left, middle, third}) : none;
  };
  equal = true;
  window = {-0.08, 1.08, -0.08, 0.95};
  layers.push_back(cells_of_triangle(36, value));
  layers.back().label = std::move(label);
  layers.back().most = most;
  level_lines(std::move(words), Look::Dotted, VectorXd::LinSpaced(97, 0, 1),
              VectorXd::LinSpaced(85, 0, root / 2), at, levels);
  curve("", Look::Line, Eigen::Vector4d(0, 1, 0.5, 0), Eigen::Vector4d(0, 0, root / 2, 0));
  if (!first.empty()) drag = {{first, -1, -1 / root, 1}, {second, 1, -1 / root}};
}

void Panel::level_lines(std::string label, Look look, const VectorXd& x, const VectorXd& y,
                        const std::function<double(double, double)>& value,
                        const std::vector<double>& levels) {
  using Eigen::Vector3d;
  MatrixXd values(y.size(), x.size());
  for (Index i = 0; i < y.size(); ++i)
    for (Index j = 0; j < x.size(); ++j) values(i, j) = value(x(j), y(i));
  std::vector<Vector3d> ends;  // of pieces: a line enters and leaves each triangle that it meets
  const auto corner = [&](Index j, Index i) { return Vector3d(x(j), y(i), values(i, j)); };
  const auto edge = [&ends](double level, const Vector3d& a, const Vector3d& b) {
    if ((a.z() > level) != (b.z() > level))
      ends.push_back(a + (level - a.z()) / (b.z() - a.z()) * (b - a));
  };
  for (const double level : levels)
    for (Index i = 0; i + 1 < y.size(); ++i)
      for (Index j = 0; j + 1 < x.size(); ++j)
        for (const Index upper : {0, 1}) {
          const Vector3d a = corner(j, i);
          const Vector3d b = corner(j + 1, i + 1);
          const Vector3d c = corner(j + 1 - upper, i + upper);
          edge(level, a, b);
          edge(level, b, c);
          edge(level, c, a);
        }
  if (ends.empty()) return;
  const double none = std::numeric_limits<double>::quiet_NaN();
  VectorXd at_x = VectorXd::Constant(static_cast<Index>(3 * ends.size() / 2), none);
  VectorXd at_y = at_x;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto place = static_cast<Index>(k + k / 2);  // a break after each piece
    at_x(place) = ends[k].x();
    at_y(place) = ends[k].y();
  }
  curve(std::move(label), look, at_x, at_y);
}

void Panel::body(const signorini::BodyModel& body, const signorini::NodeArray& displacement,
                 const signorini::NodeArray& place, double most) {
  const signorini::StressArray stress =
      signorini::cell_stress(body.mesh, body.element, body.material, displacement);
  VectorXd mises(stress.rows());
  for (Index k = 0; k < stress.rows(); ++k) mises(k) = signorini::von_mises(stress.row(k));
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> corners(body.mesh.n_cells(), 4);
  for (Index k = 0; k < body.mesh.n_cells(); ++k)
    for (Index c = 0; c < 4; ++c)
      corners(k, c) = body.mesh.cells(k, std::min<Index>(c, body.mesh.corners(k) - 1));
  cells("von Mises's stress", place, corners, mises, most);
}

void Panel::bodies(const signorini::Model& model, const signorini::Solution& solution, double most,
                   double magnified) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const signorini::NodeArray& u = solution.displacements[b];
    body(model.bodies[b], u, model.bodies[b].mesh.nodes + magnified * u, most);
  }
}

void Panel::arrows(std::string label, const signorini::NodeArray& place,
                   const signorini::NodeArray& push, const VectorXd& pressure, double length) {
  std::vector<Index> pressed;
  for (Index i = 0; i < pressure.size(); ++i)
    if (pressure(i) > 0) pressed.push_back(i);
  if (pressed.empty()) return;
  const signorini::NodeArray from = place - length * pressure.asDiagonal() * push;
  const std::size_t every = (pressed.size() + 23) / 24;  // no more than can be told apart
  const auto n = static_cast<Index>((pressed.size() + every - 1) / every);
  MatrixXd ends(2 * n, 2);
  for (Index k = 0; k < n; ++k) {
    const Index i = pressed[every * static_cast<std::size_t>(k)];
    ends.row(2 * k) = from.row(i);
    ends.row(2 * k + 1) = place.row(i);
  }
  curve(std::move(label), Look::Arrow, ends.col(0), ends.col(1));
}

void Panel::pressure(const signorini::Model& model, const signorini::Solution& solution,
                     double length, double magnified, std::size_t source) {
  const signorini::Pairs& pairs = model.pairs;
  signorini::NodeArray place = pairs.position;
  for (Index i = 0; i < place.rows(); ++i)
    if (const Index node = pairs.node[static_cast<std::size_t>(i)]; node >= 0)
      place.row(i) += magnified * solution.displacements[source].row(node);
  arrows("contact pressure", place, pairs.normal, solution.pressure, length);
}

}  // namespace live
