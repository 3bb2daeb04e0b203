// # Rectangles and graded lines
//
// Stresses change quickly near a contact and slowly far from it. Cells of equal size waste most of
// the unknowns where nothing happens, and a sudden change of size is bad for stresses, too. A
// geometric row of steps is the way between: each one is \f$q\f$ times the one before. With
// \f$n\f$ steps and the *grading* \f$g = q^{n-1}\f$, the last over the first, three steps and
// \f$g = 4\f$ have \f$q = 2\f$ and end at 1/7, 3/7 and 1.
//
// Users name the grading, not \f$q\f$: doubling the number of cells then leaves the picture as it
// is.

#include "meshes/block.hpp"

#include <cmath>

#include "meshes/lattice.hpp"
#include "signorini/core/bisection.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/rounding.hpp"

namespace signorini {

using Eigen::Index;

namespace {

/// All blocks end here: two rows of lines, and a lattice that puts a node on each crossing. The
/// middle of a side is half way between its lines, also where steps grow, since a midpoint off the
/// middle would distort the map of the cell.
Mesh block_of(const std::string& name, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
              MeshOrder order) {
  return make_lattice(name, {x.size() - 1, y.size() - 1, order}, [&](Index i, Index j) {
    return Eigen::RowVector2d(at_half(x, i), at_half(y, j));
  });
}

}  // namespace

/// Sums of steps, divided by the last sum: the last position is exactly 1, whatever \f$q\f$ was
/// rounded to.
Eigen::VectorXd graded_steps(Index n, double grading) {
  require_argument(n > 0, "graded_steps: need at least one step, got ", n);
  require_argument(grading > 0 && std::isfinite(grading),
                   "graded_steps: grading must be positive, got ", grading);
  Eigen::VectorXd position = Eigen::VectorXd::LinSpaced(n + 1, 0, 1);
  if (n == 1 || grading == 1) return position;
  const double ratio = std::pow(grading, 1 / static_cast<double>(n - 1));
  double step = 1;
  for (Index i = 1; i <= n; ++i, step *= ratio) position(i) = position(i - 1) + step;
  return position / position(n);
}

/// A rectangle of no width, or of no cells, is refused before a mesh is made of it.
Mesh make_block(const BlockSpec& spec) {
  require_argument(spec.size.minCoeff() > 0 && spec.size.allFinite() && spec.corner.allFinite(),
                   "make_block '", spec.name, "': width and height must be positive, got ",
                   spec.size.x(), " x ", spec.size.y());
  require_argument(spec.cells_x > 0 && spec.cells_y > 0, "make_block '", spec.name,
                   "': need at least one cell in each direction, got ", spec.cells_x, " x ",
                   spec.cells_y);
  const Eigen::VectorXd x =
      spec.corner.x() + spec.size.x() * graded_steps(spec.cells_x, spec.grading_x).array();
  const Eigen::VectorXd y =
      spec.corner.y() + spec.size.y() * graded_steps(spec.cells_y, spec.grading_y).array();
  return block_of(spec.name, x, y, spec.order);
}

/// The short form for equal cells, as examples and tests have them.
Mesh block(const std::string& name, const Eigen::Vector2d& corner, const Eigen::Vector2d& size,
           Index cells_x, Index cells_y, MeshOrder order) {
  return make_block({name, corner, size, cells_x, cells_y, 1, 1, order});
}

/// A line of several parts, as a drawing has it: fine, growing, coarse. Each end is set to the
/// number that was given, since other bodies will have nodes there, which must be in the same
/// place.
Eigen::VectorXd stretched(double start, const std::vector<Stretch>& stretches) {
  require_argument(!stretches.empty(), "stretched: need at least one stretch");
  Index cells = 0;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const double begin = s == 0 ? start : stretches[s - 1].end;
    const Stretch& part = stretches[s];
    require_argument(part.end > begin && std::isfinite(part.end - begin), "stretched: stretch ", s,
                     " begins at ", begin, " and must end beyond, got ", part.end);
    require_argument(
        part.cells > 0 && part.grading > 0 && std::isfinite(part.grading), "stretched: stretch ", s,
        " needs at least one cell and a positive grading, got ", part.cells, " and ", part.grading);
    cells += part.cells;
  }
  // Every part is scaled to its own length; only its steps are relative.
  Eigen::VectorXd positions(cells + 1);
  positions(0) = start;
  Index at = 0;
  for (const Stretch& part : stretches) {
    const double begin = positions(at);
    positions.segment(at + 1, part.cells) =
        begin +
        (part.end - begin) * graded_steps(part.cells, part.grading).tail(part.cells).array();
    at += part.cells;
    positions(at) = part.end;
  }
  return positions;
}

/// The other way round: given the first cell, which grading fills the line? With \f$q = e^t\f$ the
/// sum is
///
/// \f[ h_1\,\frac{q^n - 1}{q - 1} = h_1\,\frac{e^{nt} - 1}{e^t - 1} = L. \f]
///
/// It grows with \f$t\f$. Bounds are doubled until the root lies between them, and halving finds
/// it. For \f$L = 10\f$, \f$n = 3\f$ and \f$h_1 = 1\f$ the lines are at 0, 1, 3.54 and 10, and the
/// grading is 6.46. expm1 keeps the digits near \f$t = 0\f$, where both differences vanish.
double grading_from(double length, Index cells, double first) {
  require_argument(
      cells > 1 && first > 0 && first < length && std::isfinite(length),
      "grading_from: need at least 2 cells and a first cell shorter than the line, got ", cells,
      " cells, the first of ", first, " on a line of ", length);
  // Cells grow by the factor e^t, and their sum with t.
  const double n = static_cast<double>(cells);
  const auto fits = [&](double t) {
    return first * (t == 0 ? n : std::expm1(n * t) / std::expm1(t)) <= length;
  };
  double low = -1;
  double high = 1;
  while (!fits(low)) low *= 2;
  while (fits(high)) high *= 2;
  return std::exp((n - 1) * bisected(low, high, fits).first);
}

/// Lines that do not increase would make cells inside out. A message that names the two lines says
/// more than one that names a cell. Here the user gives all lines, for example some of stretched()
/// and some of another body.
Mesh make_graded_block(const std::string& name, const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                       MeshOrder order) {
  // NaN compares false with everything and would slip through a test for `<=`.
  const auto check = [&](char axis, const Eigen::VectorXd& lines) {
    require_argument(lines.size() > 1, "make_graded_block '", name, "': need at least 2 lines of ",
                     axis, ", got ", lines.size());
    for (Index i = 0; i < lines.size(); ++i)
      require_argument(std::isfinite(lines(i)) && (i == 0 || lines(i) > lines(i - 1)),
                       "make_graded_block '", name, "': positions of ", axis,
                       " must increase, but number ", i, " is ", lines(i),
                       i == 0 ? "" : text(" after ", lines(i - 1)));
  };
  check('x', x);
  check('y', y);
  return block_of(name, x, y, order);
}

}  // namespace signorini
