// Chapter 11 - With which power of the cell the errors fall: displacements, pressure and half-width, by five elements.
// Run:  make ch11     Reads: nothing     Writes: ch11_orders.results, orders.md, fig_11_9.csv
// Takes longer than 5 s: ./run.sh shows its committed results.
#include <iostream>

#include "half_plane.hpp"
#include "signorini/core/table.hpp"
#include "signorini/report/program.hpp"
#include "signorini/report/results.hpp"

namespace {

using namespace signorini;

const std::vector<std::string> tested = {"q4", "q4_incompatible", "t3", "q8", "t6"};
const std::vector<double> edges_on_b = {4, 8, 16, 32};

// 1. The contact ends somewhere in its last edge. So each size of the cells has four meshes, whose edges end differently.
// [sizes]
std::vector<OrderErrors> errors_of_sizes(const std::string& element) {
  std::vector<OrderErrors> errors;
  for (const double edges : edges_on_b) {
    OrderErrors square;  // sums of squares
    for (const double part : {0.125, 0.375, 0.625, 0.875}) {
      const OrderErrors one = order_errors(element, edges + part);
      square.energy += one.energy * one.energy / 4;
      square.pressure += one.pressure * one.pressure / 4;
      square.half_width += one.half_width * one.half_width / 4;
    }
    errors.push_back(
        {std::sqrt(square.energy), std::sqrt(square.pressure), std::sqrt(square.half_width)});
  }
  return errors;
}
// [sizes]

// 2. An order is the slope of the straight line through the logarithms.
void compare(const ProgramOptions& run, Results& results) {
  Table table({"element", "energy, 32 edges [%]", "order", "pressure [%]", "order",
               "half-width [%]", "order"});
  Table curve({"element", "edges", "energy", "pressure", "half_width"});
  for (std::size_t k = 0; k < tested.size(); ++k) {
    const std::vector<OrderErrors> errors = errors_of_sizes(tested[k]);
    std::vector<std::string> row = {tested[k]};
    const auto add = [&](const std::string& what, double OrderErrors::*error) {
      const double order = slope(edges_on_b, errors, error);
      results.add(what + "_" + tested[k], order, "-");
      row.push_back(number(100 * errors.back().*error, "%.2g"));
      row.push_back(number(order, "%.2f"));
    };
    add("energy", &OrderErrors::energy);
    add("pressure", &OrderErrors::pressure);
    add("half_width", &OrderErrors::half_width);
    table.row(row);
    for (std::size_t j = 0; j < errors.size(); ++j)
      curve.row({static_cast<double>(k), edges_on_b[j], 100 * errors[j].energy,
                 100 * errors[j].pressure, 100 * errors[j].half_width});
    curve.blank_line();
  }
  std::cout << table.markdown();
  write_file(run.out / "orders.md", table.markdown());
  write_file(run.out / "fig_11_9.csv", curve.csv("rel 1e-4 abs 1e-7"));
}

SolveStatus chapter(const ProgramOptions& run) {
  Results results("ch11_orders");
  compare(run, results);
  results.print();
  results.write(run.out);
  return SolveStatus::Solved;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("ch11_orders", "Observed orders", SIGNORINI_CHAPTER_OUT, argc, argv, chapter);
}
