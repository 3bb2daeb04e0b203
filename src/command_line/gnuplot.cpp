#include "command_line/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "addons/files/scene_file.hpp"
#include "command_line/figure_style.hpp"
#include "command_line/quoting.hpp"
#include "signorini/core/errors.hpp"
#include "signorini/core/table.hpp"
#include "signorini/core/wording.hpp"
#include "signorini/report/results.hpp"

namespace command_line {
namespace {

using namespace signorini;

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
  const auto found = std::find(picture_endings.begin(), picture_endings.end(), ending);
  require_input(found != picture_endings.end(), "--plot: expected a file .svg, .png or .pdf, got ",
                in_quotes(file));
  return static_cast<PictureKind>(found - picture_endings.begin());
}

std::string range(double from, double to) {
  const double margin = to > from ? 0 : std::max(1e-6 * std::abs(to), 1e-300);
  return text('[', shortest(from - margin), ':', shortest(to + margin), ']');
}

double round_down(double wanted) {
  const double ten = std::pow(10, std::floor(std::log10(wanted)));
  return ten * (wanted >= 5 * ten ? 5 : wanted >= 2 * ten ? 2 : 1);
}

std::string picture_head(const std::filesystem::path& file, PictureKind kind, double width,
                         double height) {
  const std::string head = text("out = ", for_gnuplot(file.string()), "\nwidth = ", width,
                                "; height = ", height, '\n', figure_style);
  constexpr const char* letters = " font sprintf('DejaVu Sans,%g', width/";
  // Letters of a page are in points, of which an inch has 72, and its lines half as wide as those of a screen.
  const std::string terminal =
      kind == PictureKind::Pdf
          ? text("pdfcairo size width/96,height/96", letters, "80.0) linewidth 0.5")
          : text(kind == PictureKind::Png ? "pngcairo" : "svg dynamic", " size width,height",
                 letters, "60.0)");
  return text(head, "set terminal ", terminal, " background '#ffffff'\nset output out\n");
}

void run_gnuplot(const std::filesystem::path& file, const std::string& script) {
  const Passing gp(file.string() + ".gp");
  const Passing log(file.string() + ".log");
  write_file(gp.file(), script);
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
