/// \file
/// Which place of a meshed target a point faces.
///
/// Each pair of every operator asks this question, and a wrong answer is a wrong force: a far side
/// that is taken for a near one, a node at a vertex that finds nothing, a point beyond an end that
/// is paired with it. So the rules are stated in full, below.
#pragma once
#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "signorini/fem/mesh.hpp"
#include "signorini/fem/side_curve.hpp"
#include "signorini/pairing/side_tree.hpp"

namespace signorini {

/// The place of the target that a point faces.
struct Projection {
  bool found = false;      ///< whether there is one; if not, only the last three say anything
  Eigen::Index side = -1;  ///< number in the list of sides of the boundary
  Eigen::Index next = -1;  ///< of the other side that meets it there, if the place is their vertex; else -1
  double xi = 0;           ///< place along the side [-]; beyond [-1, 1] by end_tolerance at most
  AnchoredPoint point = {0, 0};                      ///< the place
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit vector out of the target [-]
  double gap = 0;                                    ///< (x - point) . normal [length], overlap < 0
  bool inside = false;  ///< not found: x lies inside the target body, deeper than the cell it faces
  /// Not found: how far x lies behind a side that faces it, more than the cell is deep; else 0 [length]
  double penetration = 0;
  Eigen::Index visits = 0;  ///< boxes and sides looked at, for those who count the cost
};

/// How far beyond the end of a boundary a point may project and still face it, in xi of the last
/// side: what is lost in positions that were written with seven digits. The side is continued there,
/// so that the force still acts along the line between the two points.
inline constexpr double end_tolerance = 2e-6;

/// Cosine of the turn from which on two sides meet at a corner of the body [-]: a little more than 45 degrees, so that rounding does
/// not decide about the chamfer of a right angle.
inline constexpr double corner_cosine = 0.7071;

/// Cosine of 80 degrees [-]. A side whose normal is farther than that from pointing at the source faces it by a tilt only.
inline constexpr double grazing_cosine = 0.174;

/// Cosine of 50 degrees [-]. A side whose normal is nearer than that to pointing at the source is one that the source looks at.
inline constexpr double facing_cosine = 0.643;

/// Sides of one boundary in a tree of boxes.
///
/// A place of the target faces a point of the source if the normals there are more than 90 degrees
/// apart. Sides that do not face the point are as good as not there: so the far side of a thin or
/// round target is never chosen, and an edge behind which the boundary turns away is an end of it.
/// The rules, which hold whatever the numbering of nodes and cells:
/// - the nearest facing place counts at which the line to the point is normal to the target;
/// - at a vertex between two sides any normal between theirs will do: the line through the vertex and
///   the point; midway between the two if they coincide;
/// - a point at the same distance from two sides that meet is given their common vertex, a point at
///   the same distance from other sides the one that comes first in the list of the boundary;
/// - an end of a boundary that curves is a vertex too, as if there were a next side with the same turn:
///   what lies on a line of symmetry is not lost because sides are straight;
/// - a point beyond an end by more than that faces nothing, nor does one that lies behind a side by
///   more than the depth of its cell.
class TargetSearch {
 public:
  /// \param mesh      of the target; must outlive the search
  /// \param boundary  its boundary that may be touched
  /// \throws ProblemError if there is no such boundary, or it has no sides
  TargetSearch(const Mesh& mesh, const std::string& boundary);

  /// \return number of sides
  [[nodiscard]] Eigen::Index n_sides() const { return static_cast<Eigen::Index>(sides_.size()); }
  /// \param number  in the list of the boundary
  /// \return the side
  [[nodiscard]] const SideCurve& side(Eigen::Index number) const {
    return sides_[static_cast<std::size_t>(number)];
  }
  /// Closest-point projection, by the rules above.
  /// \param x       point of the source [length]
  /// \param normal  of the source there, out of its body [-]
  /// \return the place it faces
  [[nodiscard]] Projection closest(const AnchoredPoint& x, const Eigen::Vector2d& normal) const;
  /// Where the line through x along the normal of the source meets the target; the nearest facing
  /// place, and of two at the same distance the side that comes first in the list.
  /// \param x       point of the source [length]
  /// \param normal  of the source there, out of its body, unit vector [-]
  /// \return the place; its normal is that of the side, its gap the distance along that normal
  [[nodiscard]] Projection along(const AnchoredPoint& x, const Eigen::Vector2d& normal) const;
  /// Whether a place lies beyond a corner that ends the target for a point. Two sides stick out at the corner. The near one points at
  /// the source within 50 degrees, the far one by less than grazing_cosine. The normal of the place does not point at the source
  /// within 50 degrees, and the point hangs over: it lies above the near side, or no deeper below it than the cell there.
  /// \param place          that was found for the point, on the other side or at the corner
  /// \param source_normal  there, out of its body, unit vector [-]
  /// \return whether it lies beyond
  [[nodiscard]] bool beyond_corner(const Projection& place,
                                   const Eigen::Vector2d& source_normal) const;
  /// How far the cell behind a side reaches into the body.
  /// \param number  of the side
  /// \return greatest distance of the other corners from the line through its ends [length]
  [[nodiscard]] double depth(Eigen::Index number) const;

 private:
  struct Candidate;
  struct Query;

  [[nodiscard]] std::vector<SideBox> make_tree();
  [[nodiscard]] SideBox leaf(Eigen::Index number) const;
  void look(const SideBox& box, Query& query) const;
  void look_along(const SideBox& box, Query& query) const;
  void consider(Eigen::Index number, Query& query) const;
  [[nodiscard]] Eigen::Index neighbour(Eigen::Index number, int end) const;
  [[nodiscard]] Eigen::Vector2d normal_beyond(Eigen::Index number, int end) const;
  [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> next_corner(Eigen::Index from, int end) const;
  [[nodiscard]] bool next_faces(Eigen::Index number, int end, const Query& query) const;
  [[nodiscard]] double projection(Eigen::Index number, const Query& query) const;
  [[nodiscard]] bool resolve_end(Candidate& candidate, const Query& query) const;
  [[nodiscard]] Projection placed(Eigen::Index number, double xi, const Eigen::Vector2d& normal,
                                  const Query& query) const;
  [[nodiscard]] Projection at_vertex(Eigen::Index number, int end, const Query& query) const;
  [[nodiscard]] Projection on_side(const Candidate& best, const Query& query) const;
  [[nodiscard]] Projection chosen(Query& query) const;
  [[nodiscard]] bool inside_body(const AnchoredPoint& x) const;

  const Mesh* mesh_;
  std::string boundary_;
  std::vector<SideCurve> sides_;
  std::vector<Eigen::Index> before_, after_;  // neighbours, -1 at the ends of the boundary
  std::vector<SideBox> tree_;                 // the box around all is the last
};

}  // namespace signorini
