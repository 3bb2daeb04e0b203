/// \file
/// The seam between the library and who factors K: what a factor can do, and the family of those that make one.
///
/// The library itself has sparse_cholesky(). An add-on, or a program, adds a better one with add_backend(); the first that
/// was added is the default of every scene.
#pragma once
#include <Eigen/SparseCore>
#include <any>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "signorini/core/ledger.hpp"
#include "signorini/fem/mesh.hpp"

namespace signorini {

/// What a back end factors. It must not outlive the matrices.
struct Stiffness {
  const Eigen::SparseMatrix<double>&
      matrix;  ///< K `n x n` compressed, both triangles [force/length]
  /// A `n_c x n` whose compliance will be asked for [-]
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows;
  std::function<NodeArray()> positions =
      {};  ///< tells where unknowns are; empty if they are not known
  /// Names an unknown in messages; empty if there is no more to say than its number.
  std::function<std::string(Eigen::Index)> describe = {};
  /// Unknowns, each once, that a spring as stiff as their diagonal entry holds besides.
  std::vector<Eigen::Index> grounded = {};
  /// Factor::order() of a matrix before this one, of whatever pattern; empty: there is none, or it is not to be taken.
  std::any order = {};
};

/// A factor of K, whoever made it: the two operations that the rest of the library knows.
class Factor {
 public:
  /// By row.
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  /// u of K u = p.
  using Solve = std::function<Eigen::VectorXd(const Eigen::Ref<const Eigen::VectorXd>&)>;
  /// A K^-1 A^T, counted.
  using Compliance = std::function<Eigen::MatrixXd(const Rows&, Ledger&)>;
  /// Some unknowns, which alone have loads, and whose displacements alone are asked for.
  struct Part {
    Solve solve;                  ///< u of K u = p, both of these unknowns
    double solve_operations = 0;  ///< of one solve()
  };
  /// Finds the part of unknowns, each of them once.
  using Parts = std::function<Part(const std::vector<Eigen::Index>&)>;
  /// What it takes.
  struct Size {
    Eigen::Index unknowns = 0;    ///< n
    Eigen::Index nonzeros = 0;    ///< entries of L with the diagonal
    double operations = 0;        ///< of the factorisation
    double solve_operations = 0;  ///< of one solve()
  };

  /// Joins what a back end gives.
  /// \param solve       u of K u = p
  /// \param compliance  A K^-1 A^T
  /// \param size        what it takes
  /// \param parts       solves of a part alone; empty if the back end has none
  /// \param order       see order(); empty if the back end finds it anew each time
  Factor(Solve solve, Compliance compliance, const Size& size, Parts parts = {},
         std::function<std::any()> order = {})
      : solve_(std::move(solve)),
        compliance_(std::move(compliance)),
        size_(size),
        parts_(std::move(parts)),
        order_(std::move(order)) {}

  /// Solves K u = p.
  /// \param load  `n` p [force]
  /// \return `n` u [length]
  /// \throws std::invalid_argument unless there is one entry per unknown
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& load) const;
  /// Solves that walk through that part of the factor that eliminates some unknowns or is above them, and only that; the same
  /// numbers as solve() without other loads. A back end without such solves has to be asked for all unknowns.
  /// \param unknowns  each once
  /// \return what solves for them; nothing if the back end cannot
  /// \throws std::invalid_argument if there is no such unknown
  [[nodiscard]] std::optional<Part> part(const std::vector<Eigen::Index>& unknowns) const;
  /// A K^-1 A^T.
  /// \param A       `n_c x n` [-]
  /// \param ledger  receives the count `operations`
  /// \return `n_c x n_c`, symmetric positive semidefinite [length/force]
  /// \throws std::invalid_argument if A does not have one column per unknown
  [[nodiscard]] Eigen::MatrixXd compliance(const Rows& A, Ledger& ledger) const;

  /// \return the order of elimination as the back end knows it: it may serve the next matrix, see Stiffness
  [[nodiscard]] std::any order() const { return order_ ? order_() : std::any(); }
  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index size() const { return size_.unknowns; }
  /// \return entries of L with the diagonal, also those that are zero in a front
  [[nodiscard]] Eigen::Index nonzeros() const { return size_.nonzeros; }
  /// \return multiplications, additions, divisions and roots of the factorisation
  [[nodiscard]] double operations() const { return size_.operations; }
  /// \return multiplications, additions and divisions of one solve()
  [[nodiscard]] double solve_operations() const { return size_.solve_operations; }

 private:
  Solve solve_;
  Compliance compliance_;
  Size size_;
  Parts parts_;
  std::function<std::any()> order_;
};

struct Team;

/// One member of the family.
struct Backend {
  const char* name;     ///< as `--backend` wants it
  const char* summary;  ///< one line of a list
  /// Factors K. `ledger` receives the counts `nonzeros` and `operations`, in phases of its own. It throws ProblemError if K
  /// has an entry that is not finite, or is singular to working precision: some part can move without resistance.
  Factor (*factor)(const Stiffness& stiffness, Ledger& ledger);
  /// Joins the processes that this one was started with; null if it works alone.
  Team (*team)() = nullptr;
};

/// The family.
/// \return all members that were added, in that order
[[nodiscard]] const std::vector<Backend>& backends();

/// Adds a member to the family, unless it has one of that name. The beginning of a program is the place for it.
/// \param member  with a name and a function `factor`
void add_backend(const Backend& member);

/// \return the first member of the family; sparse_cholesky() if there is none
[[nodiscard]] Backend default_backend();

/// Eigen's sparse Cholesky factor L D L^T, with a minimum degree ordering. It is no member of the family until it is added.
///
/// A pivot that is not larger than n times the rounding of the diagonal entry of K that it was made of is none: K is then
/// singular to working precision.
/// \return the back end
[[nodiscard]] Backend sparse_cholesky();

}  // namespace signorini
