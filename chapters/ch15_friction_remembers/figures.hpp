/// \file
/// Data of the figures of partial slip.
#pragma once
#include <algorithm>
#include <filesystem>
#include <vector>

#include "partial_slip.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"

namespace ch15 {

/// At which the text shows the shear.
inline const std::vector<double> shown = {2, 3, 3.5, 4};

/// Shear and motion of all pairs along a path.
class StickMap {
 public:
  /// \param known  what the shear is divided by: mu q0
  explicit StickMap(const Pressed& known) : bound_(mu * known.slip.peak_pressure) {}

  /// \param model  of the cylinder \param step  of it, later than the last
  void add(const Model& model, const Step& step) {
    const Eigen::VectorXd shear = shear_of(model, step);
    const double time = step.state.time;
    const bool show = std::find(shown.begin(), shown.end(), time) != shown.end();
    for (Index i = 0; i < shear.size(); ++i) {
      const double x = model.pairs.position(i, 0);
      map_.row({number(time), number(x), number(model.pairs.weight(i)),
                to_string(step.solution.contact.motion[static_cast<std::size_t>(i)])});
      if (show) shear_.row({time, x, shear(i) / bound_, mu * step.solution.pressure(i) / bound_});
    }
    if (show) shear_.blank_line();
  }

  /// \param folder  for figures 15.2 and 15.3
  void write(const std::filesystem::path& folder) const {
    write_file(folder / "fig_15_2.csv", shear_.csv("rel 1e-5 abs 1e-6"));
    write_file(folder / "fig_15_3.csv", map_.csv());
  }

 private:
  double bound_;
  Table map_{{"time", "x", "width", "motion"}};
  Table shear_{{"time", "x", "shear", "bound"}};
};

/// Closed forms for the same figures. \param folder  for them \param known  the cylinder pressed
inline void write_theory(const std::filesystem::path& folder, const Pressed& known) {
  Table shear({"time", "x", "shear"}), edge({"time", "stuck"});
  for (const double time : shown) {
    for (int i = -200; i <= 200; ++i) {
      const double x = known.slip.half_width * i / 200;
      shear.row({time, x, known.shear(time, x) / (mu * known.slip.peak_pressure)});
    }
    shear.blank_line();
  }
  for (const double time : steps_between(1, 6, 60)) edge.row({time, known.stuck(time)});
  write_file(folder / "fig_15_2_exact.csv", shear.csv());
  write_file(folder / "fig_15_3_edge.csv", edge.csv());
}

}  // namespace ch15
