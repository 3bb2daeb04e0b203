#include "command_line/picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "command_line/scene_run.hpp"
#include "command_line/traction_curves.hpp"
#include "papers/field_csv.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/fem/von_mises.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

using Box = Eigen::AlignedBox<double, 2>;

/// The box of all nodes, displaced.
Box box_of(const SceneRun& run, double scale) {
  Box box;
  for (std::size_t b = 0; b < run.model->bodies.size(); ++b) {
    const NodeArray nodes =
        run.model->bodies[b].mesh.nodes + scale * run.solution->displacements[b];
    for (Index k = 0; k < nodes.rows(); ++k) box.extend(Eigen::Vector2d(nodes.row(k)));
  }
  return box;
}

/// What displacements are multiplied by: the largest is at most a twelfth of the scene then.
double magnification(const SceneRun& run) {
  double most = 0;
  for (const NodeArray& u : run.solution->displacements) most = std::max(most, farthest(u).length);
  return most > 0 ? round_down(box_of(run, 0).diagonal().norm() / 12 / most) : 1;
}

/// The deformed cells of all bodies, one after another, with von Mises' stress in their middle.
struct Cells {
  std::string csv;
  double least = std::numeric_limits<double>::infinity();  // stress
  double most = 0;
};

Cells cells(const SceneRun& run, double scale) {
  std::ostringstream all;
  Cells found;
  for (std::size_t b = 0; b < run.model->bodies.size(); ++b) {
    const BodyModel& body = run.model->bodies[b];
    const NodeArray& u = run.solution->displacements[b];
    const StressArray stress = cell_stress(body.mesh, body.element, body.material, u);
    Eigen::VectorXd value(stress.rows());
    for (Index cell = 0; cell < stress.rows(); ++cell)
      value(cell) = von_mises(stress.row(cell).transpose());
    found.least = std::min(found.least, value.minCoeff());
    found.most = std::max(found.most, value.maxCoeff());
    std::istringstream csv(deformed_cells_csv(body.mesh, u, value, scale));
    for (std::string line; std::getline(csv, line);)
      if (line.empty() || std::string("-0123456789").find(line[0]) != std::string::npos)
        all << line << '\n';
    all << '\n';
  }
  found.csv = all.str();
  return found;
}

/// Where things are on the picture [pixels], from its lower left corner.
struct Layout {
  double height = 0;
  double bottom = 0;  // of the meshes
  double top = 0;
};

constexpr double panel_width = 720;
constexpr double panel_left = 84;
constexpr double panel_right = 690;

/// As flat as the scene is, within reason.
Layout layout_of(const Box& box, double panels) {
  const double wanted = (panel_right - panel_left) * box.sizes().y() / box.sizes().x();
  Layout layout;
  layout.bottom = 60 + panels;
  layout.top = layout.bottom + std::clamp(wanted, 60.0, 520.0);
  layout.height = layout.top + 90;
  return layout;
}

void draw_meshes(std::ostream& gp, const Box& box, const Layout& layout, double scale,
                 const std::string& time, const Cells& stress, Index n_cells) {
  const double tics = round_down(box.sizes().maxCoeff() / 4);
  constexpr Index most_outlined = 6000;  // beyond that, outlines are all there is to see
  gp << "set lmargin at screen " << panel_left / panel_width << "\nset rmargin at screen "
     << panel_right / panel_width << "\nset bmargin at screen " << layout.bottom / layout.height
     << "\nset tmargin at screen " << layout.top / layout.height
     << "\nset size ratio -1\nset xlabel 'x'\nset ylabel 'y'\n"
     << "set xtics " << tics << "\nset ytics " << tics << "\nset xrange [" << box.min().x() << ':'
     << box.max().x() << "]\nset yrange [" << box.min().y() << ':' << box.max().y()
     << "]\nset cbrange " << range(stress.least, stress.most)
     << "\nset colorbox horizontal user origin screen " << panel_left / panel_width << ", screen "
     << (layout.top + 34) / layout.height << " size screen "
     << (panel_right - panel_left) / panel_width << ", screen " << 10 / layout.height
     << "\nset label 1 'von Mises'' stress; displacements times " << scale << time << "' at screen "
     << panel_left / panel_width << ", screen " << (layout.top + 66) / layout.height << "\n";
  gp << "plot $cells using 1:2:3 with polygons fc palette lw 0.3";
  if (n_cells <= most_outlined) gp << ", '' using 1:2 with lines lw 0.4 lc rgb '#a0ffffff'";
  gp << '\n';
}

/// Draws a contact in a panel. \param bottom  of it [pixels] \param block  name of its data
void draw_tractions(std::ostream& gp, const TractionCurve& curve, bool named, double bottom,
                    const Layout& layout, const std::string& block) {
  const double top = bottom + 165;
  gp << "unset label 1\nunset key\nunset xzeroaxis\nset bmargin at screen "
     << bottom / layout.height << "\nset tmargin at screen " << top / layout.height
     << "\nset size noratio\nset xtics autofreq\nset ytics autofreq\nset xlabel 'way along the "
        "source'\nset ylabel '"
     << (curve.frictional ? "contact traction" : "contact pressure") << "'\nset yrange "
     << (curve.most <= 0    ? "[0:1]"
         : curve.frictional ? "[*:*]"
                            : "[0:*]")
     << "\nset xrange " << range(curve.from, curve.to) << '\n';
  if (named)
    gp << "set label 1 " << for_gnuplot(curve.name) << " noenhanced at screen "
       << panel_left / panel_width << ", screen "
       << (top + (curve.frictional ? 38 : 16)) / layout.height << '\n';
  if (!curve.frictional) {
    gp << "plot " << block << " using 1:2 with linespoints ls 1\n";
    return;
  }
  gp << "set key horizontal left center noopaque at screen " << panel_left / panel_width
     << ", screen " << (top + 16) / layout.height << "\nset xzeroaxis lt 8\nplot " << block
     << " using 1:4 with lines ls 7 lw 0.8 title 'bound of the shear', '' using 1:(-$4) with lines "
        "ls 7 lw 0.8 notitle, '' using 1:2 with linespoints ls 1 title 'pressure', '' using 1:3 "
        "with linespoints ls 2 title 'shear'\n";
}

std::string script(const std::filesystem::path& file, PictureKind kind, const SceneRun& run) {
  const std::vector<TractionCurve> curves = traction_curves(run);
  const double scale = magnification(run);
  const Box box = box_of(run, scale);
  const bool named = curves.size() > 1 || (!curves.empty() && curves.front().frictional);
  const double panel =
      named ? 285 : 240;  // height of the curves of a contact, with all around them
  const Layout layout = layout_of(box, panel * static_cast<double>(curves.size()));
  Index n_cells = 0;
  for (const BodyModel& body : run.model->bodies) n_cells += body.mesh.n_cells();
  std::ostringstream gp;
  gp << picture_head(file, kind, panel_width, layout.height);
  const Cells stress = cells(run, scale);
  gp << "unset key\n$cells << EOD\n" << stress.csv << "EOD\n";
  const auto block = [](std::size_t k) { return text("$contact", k); };
  for (std::size_t k = 0; k < curves.size(); ++k)
    gp << block(k) << " << EOD\n" << curves[k].csv << "EOD\n";
  if (!curves.empty()) gp << "set multiplot\n";
  const PathState* const state = run.state();
  const std::string time = state == nullptr ? "" : text("; time ", shortest(state->time));
  draw_meshes(gp, box, layout, scale, time, stress, n_cells);
  for (std::size_t k = 0; k < curves.size(); ++k)
    draw_tractions(gp, curves[k], named, 60 + panel * static_cast<double>(curves.size() - 1 - k),
                   layout, block(k));
  if (!curves.empty()) gp << "unset multiplot\n";
  gp << "set output\n";
  return gp.str();
}

}  // namespace

void draw(const std::filesystem::path& file, PictureKind kind, const SceneRun& run) {
  run_gnuplot(file, script(file, kind, run));
}

}  // namespace command_line
