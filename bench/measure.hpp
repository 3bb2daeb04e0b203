/// \file
/// What the measurements share: clock, median, and a body pressed on a flat foundation.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "signorini/core/table.hpp"
#include "meshes/block.hpp"
#include "signorini/report/results.hpp"
#include "signorini/scene/scene.hpp"
#include "tests/support/hertz.hpp"

namespace signorini::bench {

/// The clock of all measurements: what others do on the same machine does not count.
/// \return processor time of this program so far, all threads together [s]
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// The middle value. \param values  at least one
/// \return of an even number the mean of the two in the middle
inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// A block of height 1 with a rounded base, pressed by its top face on a flat foundation.
/// \param cells_x  along the base, which has one candidate pair more
/// \param cells_y  over the height
/// \param rise     of the base from one end to the other
/// \param depth    by which the top face is pressed down
/// \return the scene; its cells are square
inline Scene pressed_block(Eigen::Index cells_x, Eigen::Index cells_y, double rise = 0.1,
                           double depth = 0.02) {
  Scene scene;
  Body& body = scene.bodies[0];
  BlockSpec spec;
  spec.name = "block";
  spec.size.x() = static_cast<double>(cells_x) / static_cast<double>(cells_y);
  spec.cells_x = cells_x;
  spec.cells_y = cells_y;
  const double curvature = rise / (spec.size.x() * spec.size.x());
  body.mesh = mapped(make_block(spec), [curvature](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(x.x(), x.y() + curvature * x.x() * x.x() * (1 - x.y()));
  });
  body.material = {1, 0.3, PlaneState::Strain, 1};
  body.supports = {symmetric("left"), prescribed("top", Axis::Y, -depth)};
  scene.contacts = {{{"bottom"}, half_plane({0, 0}, {0, 1})}};
  return scene;
}

/// The meshes of the example of chapter 11, with more cells.
/// \param part  how many stand along each side of a cell of the example
/// \return 1399 nodes, 5412, 21 286 and 84 426 for 1, 2, 4 and 8
inline HertzMeshSpec finer_hertz_mesh(Eigen::Index part) {
  HertzMeshSpec spec;
  for (Eigen::Index* cells : {&spec.disc_cells, &spec.disc_rows, &spec.disc_layers,
                              &spec.plate_cells, &spec.plate_rows, &spec.plate_layers})
    *cells *= part;
  return spec;
}

/// The cylinder on a plate of chapter 11, half of it: two bodies of which contact alone holds one.
/// \param cells   of the cores along the contact
/// \param rows    of the cores in depth
/// \param layers  around the cores
/// \return the scene
inline Scene hertz(Eigen::Index cells, Eigen::Index rows, Eigen::Index layers) {
  HertzMeshSpec spec;
  spec.disc_cells = spec.plate_cells = cells;
  spec.disc_rows = spec.plate_rows = rows;
  spec.disc_layers = spec.plate_layers = layers;
  return signorini_test::hertz(spec);
}

/// Shows a table and writes it for texts and for figures. \param out  folder \param name  of both files \param table  what
inline void write_table(const std::filesystem::path& out, const std::string& name,
                        const Table& table) {
  std::cout << '\n' << table.markdown();
  write_file(out / (name + ".md"), table.markdown());
  write_file(out / (name + ".csv"), table.csv());
}

}  // namespace signorini::bench
