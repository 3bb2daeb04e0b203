#include <algorithm>
#include <optional>
#include <utility>

#include "addons/files/filed_meshes.hpp"
#include "addons/files/kinds.hpp"
#include "meshes/disc.hpp"
#include "meshes/half_space.hpp"
#include "meshes/plate_with_hole.hpp"
#include "meshes/ring.hpp"
#include "meshes/split.hpp"
#include "signorini/core/index.hpp"
#include "signorini/core/rounding.hpp"
#include "meshes/block.hpp"
#include "meshes/reshape.hpp"

namespace signorini {

using Eigen::Index;

template <>
const std::vector<Word<DiscPart>> words_of<DiscPart> = {
    {"full", DiscPart::Full}, {"right", DiscPart::Right}, {"lower right", DiscPart::LowerRight}};

template <>
const std::vector<Word<Sector>> words_of<Sector> = {
    {"full", Sector::Full}, {"half", Sector::Half}, {"quarter", Sector::Quarter}};

template <>
const std::vector<Word<MirrorLine>> words_of<MirrorLine> = {{"upright", MirrorLine::Upright},
                                                            {"level", MirrorLine::Level}};

namespace {

constexpr Bound positive = Bound::Positive;
constexpr double largest_mesh = 1e7;  // cells

const double degree = pi / 180;

void check_size(double cells) {
  require_argument(cells <= largest_mesh, "a mesh of ", cells, " cells is too large; at most ",
                   largest_mesh, " are made");
}

double number(Index n) { return static_cast<double>(n); }

template <typename Spec>
Key<Spec> quadratic() {
  return {{"quadratic", "true or false", "", "false", "8 nodes per cell instead of 4"},
          [](const Value& value, Spec& spec) {
            bool wanted = false;
            take(value, wanted);
            spec.order = wanted ? MeshOrder::Quadratic : MeshOrder::Linear;
          }};
}

Kind<Mesh> block() {
  using S = BlockSpec;
  return kind_of<Mesh, S>(
      "block", "a rectangle; boundaries left, right, bottom, top",
      {required(key("size", &S::size, "length", "width and height", positive)),
       required(key("cells", &S::cells_x, &S::cells_y, "", "along x and y", positive)),
       key("corner", &S::corner, "length", "lower left corner"),
       key("grading", &S::grading_x, &S::grading_y, "", "last cell / first, along x and y",
           positive),
       quadratic<S>()},
      [](const S& spec) {
        check_size(number(spec.cells_x) * number(spec.cells_y));
        return make_block(spec);
      });
}

/// Lines of a block along one axis.
struct Lines {
  Eigen::VectorXd at, grading;
  std::vector<Index> cells;
};

struct GradedBlock {
  Eigen::VectorXd x, y;
  MeshOrder order = MeshOrder::Linear;
};

const Keys<Lines>& line_keys() {
  static const Keys<Lines> keys = {
      required(key("at", &Lines::at, "length", "where the parts begin and end, increasing")),
      {{"cells", "list of whole numbers > 0", "", "", "of each part", true},
       [](const Value& value, Lines& lines) { take(value, lines.cells, positive); }},
      key("grading", &Lines::grading, "", "last cell / first of each part; without it all 1",
          positive)};
  return keys;
}

Key<GradedBlock> lines(const char* name, Eigen::VectorXd GradedBlock::*member, const char* help) {
  return {{name, "table of at, cells, grading", "", "", help, true},
          [member](const Value& value, GradedBlock& block) {
            Lines lines;
            read_members(value, line_keys(), lines);
            const auto parts = static_cast<Index>(lines.cells.size());
            if (lines.at.size() != parts + 1)
              value.fail("expected one more entry of 'at' than of 'cells', got ", lines.at.size(),
                         " and ", parts);
            if (lines.grading.size() == 0) lines.grading.setOnes(parts);
            if (lines.grading.size() != parts)
              value.fail("expected as many entries of 'grading' as of 'cells', got ",
                         lines.grading.size(), " and ", parts);
            std::vector<Stretch> stretches;
            double cells = 0;
            for (Index k = 0; k < parts; ++k) {
              const Index n = lines.cells[at(k)];
              stretches.push_back({lines.at(k + 1), n, lines.grading(k)});
              cells += number(n);
            }
            value.explain([&] {
              check_size(cells);
              block.*member = stretched(lines.at(0), stretches);
            });
          }};
}

Kind<Mesh> graded_block() {
  using S = GradedBlock;
  return kind_of<Mesh, S>(
      "graded_block", "a rectangle of several parts; boundaries left, right, bottom, top",
      {lines("x", &S::x, "upright lines: { at = [..], cells = [..], grading = [..] }"),
       lines("y", &S::y, "level lines, likewise"), quadratic<S>()},
      [](const S& spec) {
        check_size(number(spec.x.size()) * number(spec.y.size()));
        return make_graded_block("block", spec.x, spec.y, spec.order);
      });
}

/// The cells of a mesh that is fine in a core: even there, and in layers around it.
template <typename S>
Keys<S> with_layers(Keys<S> keys, const char* core, const char* cells) {
  keys.push_back(key("core", &S::core, "length", core, positive));
  keys.push_back(key("core_cells", &S::core_columns, &S::core_rows, "", cells, positive));
  keys.push_back(key("layers", &S::layers, "", "of cells around the core", positive));
  keys.push_back(key("layer_grading", &S::layer_grading, "",
                     "growth of the last layer / of the first, in logarithms", positive));
  keys.push_back(quadratic<S>());
  return keys;
}

/// \param parts  how often the core and its layers stand in the mesh
template <typename S>
void check_layers(const S& spec, double parts) {
  const double columns = number(spec.core_columns), rows = number(spec.core_rows);
  check_size(parts * (columns * rows + (columns + rows) * number(spec.layers)));
}

Kind<Mesh> half_space() {
  using S = HalfSpaceSpec;
  return kind_of<Mesh, S>(
      "half_space",
      "right half of a half-space, fine at the origin; boundaries surface (y = 0), axis (x = 0), "
      "side, base",
      with_layers<S>({required(key("width", &S::width, "length", "along x", positive)),
                      required(key("depth", &S::depth, "length", "downwards", positive))},
                     "width and depth of the even cells at the origin",
                     "of the core, along x and y"),
      [](const S& spec) {
        check_layers(spec, 1);
        return make_half_space(spec);
      });
}

Kind<Mesh> edge_block() {
  using S = EdgeBlockSpec;
  return kind_of<Mesh, S>(
      "edge_block",
      "right half of a half-space, fine below the edge of a load; boundaries surface (y = 0), "
      "loaded (of it), axis, side, base",
      {required(key("edge", &S::edge, "length", "where the load ends", positive)),
       required(key("width", &S::width, "length", "along x", positive)),
       required(key("depth", &S::depth, "length", "downwards", positive)),
       key("cells_under", &S::cells_under, "", "under the load", positive),
       key("cells_beside", &S::cells_beside, "", "from the edge to the side, at least 2", positive),
       key("cells_deep", &S::cells_deep, "", "from the surface to the base, at least 2", positive),
       key("grading_under", &S::grading_under, "", "cell at the axis / cell at the edge", positive),
       key("grading_beside", &S::grading_beside, "",
           "cell at the side / at the edge; without it the first is as wide as the last under the "
           "load",
           positive),
       key("grading_deep", &S::grading_deep, "",
           "cell at the base / at the surface; without it the first is as high as that one is wide",
           positive),
       quadratic<S>()},
      [](const S& spec) {
        check_size((number(spec.cells_under) + number(spec.cells_beside)) *
                   number(spec.cells_deep));
        return make_edge_block(spec);
      });
}

Kind<Mesh> round_disc() {
  using S = DiscSpec;
  return kind_of<Mesh, S>(
      "disc", "a disc of even cells; boundaries rim, of a part also axis, of a quarter middle",
      {required(key("radius", &S::radius, "length", "of the disc", positive)),
       key("centre", &S::centre, "length", "of the disc"),
       key("part", &S::part, "", "how much of it"),
       key("core", &S::core, "", "half width of the core / radius", positive),
       key("core_roundness", &S::core_roundness, "", "of the core, 0 (square) to 1 (disc)",
           Bound::NotNegative),
       key("core_cells", &S::core_cells, "", "from the centre to a side of the core", positive),
       key("layers", &S::layers, "", "of cells around the core", positive),
       key("layer_grading", &S::layer_grading, "", "outermost layer / innermost", positive),
       quadratic<S>()},
      [](const S& spec) {
        const double core = number(spec.core_cells);
        check_size(4 * (core * core + 2 * core * number(spec.layers)));
        return make_disc(spec);
      });
}

Kind<Mesh> pressed_disc() {
  using S = PressedDiscSpec;
  return kind_of<Mesh, S>(
      "pressed_disc", "a disc that is fine at its lowest and highest point; boundaries as of disc",
      with_layers<S>({required(key("radius", &S::radius, "length", "of the disc", positive)),
                      key("pole", &S::pole, "length", "lowest point"),
                      key("part", &S::part, "", "how much of it")},
                     "width along x and depth of the even cells at the pole",
                     "of the core, along rim and axis"),
      [](const S& spec) {
        check_layers(spec, 4);
        return make_pressed_disc(spec);
      });
}

/// Rays in degrees, or evenly in each quadrant.
template <typename Spec>
struct WithRays : Spec {
  std::vector<Index> quadrants;
};

template <typename Spec>
Keys<WithRays<Spec>> ray_keys(Keys<WithRays<Spec>> keys) {
  using S = WithRays<Spec>;
  keys.push_back({{"rays", "list of numbers", "degree", "",
                   "directions of the rays, one more than cells along the angle; without it even"},
                  [](const Value& value, S& spec) {
                    take(value, spec.rays);
                    spec.rays *= degree;
                  }});
  keys.push_back({{"quadrants", "list of whole numbers > 0", "", "",
                   "cells of each quadrant, in place of rays"},
                  [](const Value& value, S& spec) {
                    take(value, spec.quadrants, positive);
                    if (spec.rays.size() > 0) value.fail("give either rays or quadrants, not both");
                  }});
  keys.push_back({{"sector", type_name<Sector>(Bound::Any), "", written(Sector::Full),
                   "how much of it, counter-clockwise from the x axis"},
                  [](const Value& value, S& spec) { take(value, spec.sector); }});
  keys.push_back(quadratic<S>());
  return keys;
}

template <typename Spec>
Spec checked(WithRays<Spec> spec) {
  if (!spec.quadrants.empty()) spec.rays = rays_by_quadrant(spec.quadrants);
  check_size(number(spec.cells_angle) * number(spec.cells_radius));
  return spec;
}

template <typename S>
Key<S> cells_around(const char* help) {
  return {{"cells", "two of: whole number > 0", "", "", help, true},
          [](const Value& value, S& spec) {
            const std::vector<Value>& both = list_of(value, 2, "whole number > 0");
            take(both[0], spec.cells_angle, positive);
            take(both[1], spec.cells_radius, positive);
          }};
}

Kind<Mesh> plate_with_hole() {
  using B = PlateWithHoleSpec;
  using S = WithRays<B>;
  return kind_of<Mesh, S>(
      "plate_with_hole",
      "a rectangle with a round hole in its middle; boundaries hole, left, right, bottom, top, of "
      "a "
      "part also symmetry (x axis) and symmetry_y",
      ray_keys<B>({required(key("hole_radius", &B::hole_radius, "length", "of the hole", positive)),
                   required(key("size", &B::size, "length", "of the whole plate", positive)),
                   cells_around<S>("along the hole, and from the hole to the sides"),
                   key("centre", &B::centre, "length", "of hole and plate"),
                   key("grading", &B::grading, "", "outer cell of a ray / inner", positive)}),
      [](const S& spec) { return make_plate_with_hole(checked<B>(spec)); });
}

Kind<Mesh> annulus() {
  using B = AnnulusSpec;
  using S = WithRays<B>;
  return kind_of<Mesh, S>(
      "ring",
      "what lies between two circles; boundaries inner, outer, of a part also symmetry (x axis) "
      "and symmetry_y",
      ray_keys<B>(
          {required(key("inner_radius", &B::inner_radius, "length", "of the hole", positive)),
           required(
               key("outer_radius", &B::outer_radius, "length", "above inner_radius", positive)),
           cells_around<S>("along the angle and the radius"),
           key("centre", &B::centre, "length", "of both circles"),
           key("grading", &B::grading, "", "outermost cell / innermost", positive)}),
      [](const S& spec) { return make_annulus(checked<B>(spec)); });
}

/// What is done with a mesh of any kind, in this order.
struct Place {
  bool triangles = false;
  std::optional<MirrorLine> mirror;
  double turn = 0;
  Eigen::Vector2d move = Eigen::Vector2d::Zero();
};

const Keys<Place>& place_keys() {
  static const Keys<Place> keys = {
      key("triangles", &Place::triangles, "", "every quadrilateral is cut into two triangles"),
      key("mirror", &Place::mirror, "",
          "at the line x = 0 (upright) or y = 0 (level); boundaries keep their names"),
      key("turn", &Place::turn, "degree", "about the origin, counter-clockwise, after mirror"),
      key("move", &Place::move, "length", "to another place, after mirror and turn")};
  return keys;
}

}  // namespace

const std::vector<Kind<Mesh>>& mesh_kinds() {
  static const std::vector<Kind<Mesh>> kinds = {
      block(),        graded_block(), half_space(),      edge_block(), round_disc(),
      pressed_disc(), annulus(),      plate_with_hole(), gmsh_kind(),  inp_kind()};
  return kinds;
}

const std::vector<KeyInfo>& mesh_keys() {
  static const std::vector<KeyInfo> keys = infos(place_keys());
  return keys;
}

Mesh read_mesh(const Value& table, const std::string& name) {
  Mesh mesh = find_kind(table, mesh_kinds(), mesh_keys()).make(table);
  Place place;
  fill(table, place_keys(), place);
  if (place.triangles) mesh = split(mesh);
  if (place.mirror) mesh = mirrored(std::move(mesh), *place.mirror);
  if (place.turn != 0) {
    const Eigen::RowVector2d e = unit_vector(place.turn * degree);
    mesh = mapped(std::move(mesh), [e](const Eigen::Vector2d& at) -> Eigen::Vector2d {
      return {e.x() * at.x() - e.y() * at.y(), e.y() * at.x() + e.x() * at.y()};
    });
  }
  if (place.move != Eigen::Vector2d::Zero()) mesh = moved(std::move(mesh), place.move);
  mesh.name = name;
  return mesh;
}

}  // namespace signorini
