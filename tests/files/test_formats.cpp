// The three formats, read from the files of tests/data and from texts written here.
#include <filesystem>

#include "addons/files/problem_file.hpp"
#include "catch_compat.hpp"
#include "fuzz/check_text.hpp"
#include "papers/examples.hpp"
#include "support/folder.hpp"
#include "support/problems.hpp"

using Eigen::Index;
using namespace signorini;
using signorini_test::content_of;

namespace {

const std::filesystem::path data = SIGNORINI_TEST_DATA;

std::vector<FiledProblem> lcps(const ProblemFile& file) {
  return std::get<std::vector<FiledProblem>>(file);
}

/// The certificate of a z for M and q, with the gaps that it leaves.
double worst(const ContactProblem& problem, const Eigen::VectorXd& z) {
  ContactState state;
  state.force = z;
  state.gap = problem.free_gap + problem.compliance * z;
  return certify(problem, state).worst();
}

}  // namespace

TEST_CASE("Siconos writes its matrices column by column", "[problem_file]") {
  const auto text = "2\n0\n2\n2\n2\t2\n1 2\n3 4\n-5 -6\nany remark";
  const auto problem = lcps(parse_problem(text, "x")).at(0).problem;
  CHECK(problem.compliance == (Eigen::Matrix2d() << 1, 3, 2, 4).finished());
  CHECK(problem.free_gap == Eigen::Vector2d(-5, -6));
  // Murty's second example has the solution 64 e_6 only if read in this order.
  const auto murty = lcps(read_problem(data / "siconos_lcp/lcp_exp_murty2.dat")).at(0).problem;
  CHECK(worst(murty, 64 * Eigen::VectorXd::Unit(6, 5)) == 0);
  CHECK(worst({murty.compliance.transpose(), murty.free_gap}, 64 * Eigen::VectorXd::Unit(6, 5)) >
        0.1);
}

TEST_CASE("the exact solutions of the Siconos files solve what is read", "[problem_file]") {
  const struct {
    const char* name;
    std::vector<double> z;
  } cases[] = {
      {"lcp_CPS_1", {0, 1}},
      {"lcp_CPS_2", {0, 1, 3}},
      {"lcp_CPS_3", {0.1, 0, 0.1, 0}},
      {"lcp_CPS_4", {2, 2, 2, 92}},
      {"lcp_CPS_4bis", {3, 3, 0, 83}},
      {"lcp_CPS_5", {0, 1}},
      {"lcp_Pang_isolated_sol", {1, 0, 0}},
      {"lcp_deudeu", {4.0 / 3, 7.0 / 3}},
      {"lcp_exp_murty", {0, 0, 0, 0, 0, 1}},
      {"lcp_inf_sol_perturbed", {1, 0, 1e-4}},
      {"lcp_trivial", {1, 1. / 2, 1. / 3, 1. / 4, 1. / 5, 1. / 6, 1. / 7, 1. / 8, 1. / 9}}};
  for (const auto& expected : cases) {
    CAPTURE(expected.name);
    const auto problems =
        lcps(read_problem(data / "siconos_lcp" / (std::string(expected.name) + ".dat")));
    REQUIRE(problems.size() == 1);
    const Eigen::Map<const Eigen::VectorXd> z(expected.z.data(),
                                              static_cast<Index>(expected.z.size()));
    REQUIRE(problems[0].problem.free_gap.size() == z.size());
    CHECK(worst(problems[0].problem, z) < 1e-15);
  }
}

TEST_CASE("a block file holds several problems, with and without their solutions",
          "[problem_file]") {
  const auto cycling = lcps(read_problem(data / "generated/active_set_cycling.txt"));
  REQUIRE(cycling.size() == 2);
  const ContactProblem here = signorini_test::cycling_problem();
  CHECK(cycling[0].line == 3);
  CHECK(cycling[0].problem.compliance == here.compliance);
  CHECK(cycling[0].problem.free_gap == here.free_gap);
  CHECK(cycling[0].known_force == Eigen::Vector3d(0, 0.4, 0));
  CHECK(cycling[0].known_gap == Eigen::Vector3d(0.6, 0, 2.2));
  CHECK(cycling[1].line == 15);
  CHECK(cycling[1].problem.compliance.row(0) == Eigen::RowVector3d(1, 0, 2));  // row by row
  CHECK(cycling[1].known_gap.size() == 0);

  const auto fathi = lcps(read_problem(data / "generated/fathi_spd_lemke_exponential.txt"));
  REQUIRE(fathi.size() == 3);
  for (const FiledProblem& filed : fathi) {
    const ContactProblem exact = signorini::fathi(filed.problem.free_gap.size());
    CHECK(filed.problem.compliance == exact.compliance);
    CHECK(worst(filed.problem, filed.known_force) == 0);
  }
  const auto random = lcps(read_problem(data / "generated/quantecon768_lcp_n10.txt")).at(0);
  CHECK(worst(random.problem, random.known_force) < 1e-14);
}

TEST_CASE("a friction problem reads the same whatever its storage", "[problem_file]") {
  // Two pairs; normal and tangential rows in turns, columns below each other.
  const std::string end = " -1 5 -2 6  0.25 0.5\n1\n";
  const std::string dense = "2 2 0 4 4 4 4  1 2 0 0  20 3 0 0  4 0 5 6  0 0 60 7 " + end;
  const std::string blocks =
      "2\n2\n1\n4\n4\n3\n2\n2\n2 4\n2 4\n3\n3\n0 2 3\n0 1 1\n0\n1 2 20 3\n1\n4 0 0 0\n2\n5 6 60 "
      "7\n" +
      end;
  const std::string head = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c) Timothy A. Davis\n";
  const std::string columns =
      "2\n2\n2\n4\n4\n2\n" + head +
      "4-by-4, nzmax: 9 nnz: 9, 1-norm: 23\n  col 0 : locations 0 to 1\n 0 : 1\n 1 : 2\n"
      "  col 1 : locations 2 to 3\n 0 : 20\n 1 : 3\n  col 2 : locations 4 to 6\n 0 : 4\n 2 : 5\n"
      " 3 : 6\n  col 3 : locations 7 to 8\n 2 : 60\n 3 : 7\n" +
      end;
  const std::string triplets =
      "2\n2\n2\n4\n4\n1\n" + head +
      "triplet: 4-by-4, nzmax: 20 nnz: 10\n 0 0 : 1\n 1 0 : 2\n 0 1 : 20\n 1 1 : 3\n 0 2 : 4\n"
      " 2 2 : 5\n 3 2 : 6\n 2 3 : 59\n 3 3 : 7\n 2 3 : 1\n" +  // what stands twice is added
      end;
  Eigen::Matrix4d W;  // gaps first
  W << 1, 4, 20, 0, 0, 5, 0, 60, 2, 0, 3, 0, 0, 6, 0, 7;
  for (const std::string& content : {dense, blocks, columns, triplets}) {
    CAPTURE(content);
    const FiledProblem filed = lcps(parse_problem(content, "file")).at(0);
    CHECK(filed.has_friction());
    CHECK(filed.problem.compliance == W);
    CHECK(filed.problem.free_gap == Eigen::Vector2d(-1, -2));
    CHECK(filed.problem.free_slip == Eigen::Vector2d(5, 6));
    CHECK(filed.problem.law.pair == std::vector<Index>{0, 1});
    CHECK(filed.problem.law.coefficient == Eigen::Vector2d(0.25, 0.5));
    CHECK(filed.problem.law.cohesion == Eigen::Vector2d(0, 0));
  }
  // The same storages without friction.
  const FiledProblem plain =
      lcps(parse_problem("3 1 3 3 2 2 2 2 3 2 3 3 2 0 1 2 0 1 0 1 2 3 4 1 5 -1 -2 -3", "file"))
          .at(0);
  CHECK_FALSE(plain.has_friction());
  CHECK(plain.problem.compliance == (Eigen::Matrix3d() << 1, 3, 0, 2, 4, 0, 0, 0, 5).finished());
  CHECK(plain.problem.free_gap == Eigen::Vector3d(-1, -2, -3));
}

TEST_CASE("a quadratic programme keeps every number and the published optimum", "[problem_file]") {
  const ProblemFile file = read_problem(data / "maros_meszaros/HS35.txt");
  const auto& programme = std::get<TwoSidedProgramme>(file);
  CHECK(programme.P == (Eigen::Matrix3d() << 4, 2, 2, 2, 4, 0, 2, 0, 2).finished());
  CHECK(programme.q == Eigen::Vector3d(-8, -6, -4));
  CHECK(programme.r == 9);
  CHECK(programme.A.row(0) == Eigen::RowVector3d(-1, -1, -2));
  CHECK(programme.lower == Eigen::Vector4d(-3, 0, 0, 0));
  CHECK(programme.upper == Eigen::Vector4d::Constant(no_bound));
  REQUIRE(programme.published_optimum);
  CHECK(*programme.published_optimum == 0.111111111);
}

TEST_CASE("blanks, tabs, line ends of other systems, a byte order mark and comments do no harm",
          "[problem_file]") {
  const std::string plain = "n 2\nM\n2 1\n1 2\nq\n-1 +3\nz\n.5 0\n";
  const auto expected = lcps(parse_problem(plain, "x")).at(0);
  for (const std::string& same :
       {std::string("n 2\r\nM\r\n2 1\r\n1 2\r\nq\r\n-1 3\r\nz\r\n0.5 0\r\n"),
        std::string(
            "\xEF\xBB\xBF# n 9\n\n\tn\t2 # two\n M\n\n2\t1\n1  2 \nq\n-1 3e0\nz\n5e-1 0")}) {
    const auto got = lcps(parse_problem(same, "x")).at(0);
    CHECK(got.problem.compliance == expected.problem.compliance);
    CHECK(got.problem.free_gap == expected.problem.free_gap);
    CHECK(got.known_force == expected.known_force);
  }
}

TEST_CASE("a programme may have no rows, and P may be symmetric to rounding only",
          "[problem_file]") {
  const auto text = "n 2\nm 0\nr 0\nP\n2 1\n1.0000000000000002 2\nq\n1 1\nA\nl\nu\n";
  const ProblemFile file = parse_problem(text, "x");
  const auto& programme = std::get<TwoSidedProgramme>(file);
  CHECK(programme.A.rows() == 0);
  CHECK(programme.P == programme.P.transpose());
}

TEST_CASE("odd texts that were found before are read or refused, and solved or refused",
          "[problem_file][hard]") {
  int texts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "fuzz_corpus")) {
    CAPTURE(entry.path().filename().string());
    CHECK(signorini_test::check_text(content_of(entry.path())) == "");
    ++texts;
  }
  CHECK(texts > 10);
}
