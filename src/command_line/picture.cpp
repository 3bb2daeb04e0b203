#include "command_line/picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include "command_line/figure_style.hpp"
#include "command_line/scene_run.hpp"
#include "command_line/traction_curves.hpp"
#include "papers/field_csv.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/fem/stress.hpp"
#include "signorini/report/results.hpp"

namespace command_line {
namespace {

using namespace signorini;
using Eigen::Index;

/// A text between quotes of gnuplot or of the shell. \param quote  how a quote is written in it
std::string quoted(const std::string& text, const char* quote) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? quote : std::string(1, c);
  return result + "'";
}
std::string for_gnuplot(const std::string& text) { return quoted(text, "''"); }
std::string for_shell(const std::string& text) { return quoted(text, "'\\''"); }

using Box = Eigen::AlignedBox<double, 2>;

/// 1, 2 or 5 times a power of ten, not above a positive number.
double round_down(double wanted) {
  const double ten = std::pow(10, std::floor(std::log10(wanted)));
  return ten * (wanted >= 5 * ten ? 5 : wanted >= 2 * ten ? 2 : 1);
}

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
  for (const NodeArray& u : run.solution->displacements)
    most = std::max(most, u.rowwise().norm().maxCoeff());
  return most > 0 ? round_down(box_of(run, 0).diagonal().norm() / 12 / most) : 1;
}

/// A range for gnuplot, which refuses one without a length.
std::string range(double from, double to) {
  const double margin = to > from ? 0 : std::max(1e-6 * std::abs(to), 1e-300);
  return text('[', shortest(from - margin), ':', shortest(to + margin), ']');
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
  gp << "out = " << for_gnuplot(file.string()) << "\nwidth = " << panel_width
     << "; height = " << layout.height << '\n'
     << figure_style;
  const Cells stress = cells(run, scale);
  gp << "set terminal " << (kind == PictureKind::Png ? "pngcairo" : "svg dynamic")
     << " size width,height font sprintf('DejaVu Sans,%g', width/60.0) background '#ffffff'\n"
     << "set output out\nunset key\n$cells << EOD\n"
     << stress.csv << "EOD\n";
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

/// A file that goes away again.
class Passing {
 public:
  explicit Passing(std::filesystem::path file) : file_(std::move(file)) {}
  ~Passing() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  Passing(const Passing&) = delete;
  Passing& operator=(const Passing&) = delete;
  Passing(Passing&&) = delete;
  Passing& operator=(Passing&&) = delete;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

}  // namespace

PictureKind picture_kind(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  require_input(ending == ".svg" || ending == ".png", "--plot: expected a file .svg or .png, got '",
                file, '\'');
  return ending == ".svg" ? PictureKind::Svg : PictureKind::Png;
}

void draw(const std::filesystem::path& file, PictureKind kind, const SceneRun& run) {
  const Passing gp(file.string() + ".gp");
  const Passing log(file.string() + ".log");
  write_file(gp.file(), script(file, kind, run));
  const std::string command =
      "gnuplot " + for_shell(gp.file().string()) + " > " + for_shell(log.file().string()) + " 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream said(log.file());
  std::string first;
  while (std::getline(said, first) && first.find_first_not_of(" \t\r") == std::string::npos) {
  }
  constexpr int not_found = 127 << 8;
  require_input(
      status != not_found,
      "--plot: there is no gnuplot; install it, such as the package gnuplot-nox, or leave the "
      "picture out");
  std::error_code failed;
  require_input(status == 0 && std::filesystem::file_size(file, failed) > 0 && !failed,
                "--plot: gnuplot could not draw: ", first.empty() ? "no picture" : first);
}

}  // namespace command_line
