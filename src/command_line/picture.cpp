#include "command_line/picture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "command_line/figure_style.hpp"
#include "command_line/scene_run.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/results.hpp"
#include "signorini/core/table.hpp"
#include "signorini/elasticity/stress.hpp"
#include "signorini/report/field_csv.hpp"

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

/// 1, 2 or 5 times a power of ten, so that the largest displacement is at most a twelfth of the scene.
double magnification(const SceneRun& run) {
  Eigen::AlignedBox2d box;
  double most = 0;
  for (std::size_t b = 0; b < run.model->bodies.size(); ++b) {
    const NodeArray& nodes = run.model->bodies[b].mesh.nodes;
    for (Index k = 0; k < nodes.rows(); ++k) box.extend(Eigen::Vector2d(nodes.row(k)));
    most = std::max(most, run.solution->displacements[b].rowwise().norm().maxCoeff());
  }
  if (!(most > 0)) return 1;
  const double wanted = box.diagonal().norm() / 12 / most;
  const double ten = std::pow(10, std::floor(std::log10(wanted)));
  return ten * (wanted >= 5 * ten ? 5 : wanted >= 2 * ten ? 2 : 1);
}

/// The deformed cells of all bodies, one after another, with von Mises' stress in their middle.
std::string cells(const SceneRun& run, double scale) {
  std::ostringstream all;
  for (std::size_t b = 0; b < run.model->bodies.size(); ++b) {
    const BodyModel& body = run.model->bodies[b];
    const NodeArray& u = run.solution->displacements[b];
    const StressArray stress = cell_stress(body.mesh, body.element, body.material, u);
    Eigen::VectorXd value(stress.rows());
    for (Index cell = 0; cell < stress.rows(); ++cell)
      value(cell) = von_mises(body.material, stress.row(cell).transpose());
    std::istringstream csv(deformed_cells_csv(body.mesh, u, value, scale));
    for (std::string line; std::getline(csv, line);)
      if (line.empty() || std::string("-0123456789").find(line[0]) != std::string::npos)
        all << line << '\n';
    all << '\n';
  }
  return all.str();
}

/// Pressure over the way along the source, a block for each contact.
std::string pressures(const SceneRun& run) {
  const Pairs& pairs = run.model->pairs;
  std::ostringstream all;
  double way = 0;
  for (Index k = 0; k < run.solution->pressure.size(); ++k) {
    const std::size_t contact = run.plan.contact_of[static_cast<std::size_t>(k)];
    const bool begins = k == 0 || run.plan.contact_of[static_cast<std::size_t>(k - 1)] != contact;
    if (begins && k > 0) all << '\n';
    way = begins ? 0 : way + (pairs.position.row(k) - pairs.position.row(k - 1)).norm();
    all << shortest(way) << ',' << shortest(run.solution->pressure(k)) << '\n';
  }
  return all.str();
}

std::string script(const std::filesystem::path& file, PictureKind kind, const SceneRun& run) {
  const bool touches = run.solution->pressure.size() > 0;
  const double scale = magnification(run);
  std::ostringstream gp;
  gp << "out = " << for_gnuplot(file.string())
     << "\nwidth = 720; height = " << (touches ? 760 : 480) << '\n'
     << figure_style;
  if (kind == PictureKind::Png)
    gp << "set terminal pngcairo size width,height font sprintf('DejaVu Sans,%g', width/50.0)\n"
          "set output out\n";
  gp << "$cells << EOD\n" << cells(run, scale) << "EOD\n";
  if (touches) gp << "$pressure << EOD\n" << pressures(run) << "EOD\n";
  if (touches) gp << "set multiplot\nset origin 0,0.4\nset size 1,0.6\n";
  gp << "unset key\nset size ratio -1\nset rmargin 12\nset xlabel 'x'\nset ylabel 'y'\n"
     << "set title 'Deformed meshes, displacements times " << scale << ", and von Mises'' stress'\n"
     << "plot $cells using 1:2:3 with polygons fc palette lw 0.3\n";
  if (touches)
    gp << "set origin 0,0\nset size noratio 1,0.4\nset rmargin 3\nset title 'Contact pressure'\n"
          "set xlabel 'way along the source'\nset ylabel 'pressure'\nset yrange [0:*]\n"
          "set autoscale x\n"
          "plot $pressure using 1:2 with linespoints ls 1\nunset multiplot\n";
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
  pose(ending == ".svg" || ending == ".png", "--plot: expected a file .svg or .png, got '", file,
       '\'');
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
  pose(status != not_found,
       "--plot: there is no gnuplot; install it, such as the package gnuplot-nox, or leave the "
       "picture out");
  std::error_code failed;
  pose(status == 0 && first.empty() && std::filesystem::file_size(file, failed) > 0 && !failed,
       "--plot: gnuplot could not draw: ", first.empty() ? "no picture" : first);
}

}  // namespace command_line
