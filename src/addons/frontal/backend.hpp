/// \file
/// The family of back ends: who factors K. To add one: write a `.cpp` with a function of its name that returns it, and put
/// that name into the table in backends.cpp; one that needs another library lives in `src/backends/`, and
/// `cmake/Backends.cmake` puts its name there where the library is found. The conformance suite picks it up.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "addons/frontal/separator_tree.hpp"
#include "signorini/core/ledger.hpp"

namespace signorini {

/// What a back end factors. It must not outlive the matrices.
struct Stiffness {
  const Eigen::SparseMatrix<double>&
      matrix;  ///< K `n x n` compressed, both triangles [force/length]
  /// A `n_c x n` whose compliance will be asked for [-]
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& rows;
  std::function<Positions()> positions = {};  ///< tells where unknowns are; empty if nobody knows
  /// Names an unknown in messages; empty if there is no more to say than its number.
  std::function<std::string(Eigen::Index)> describe = {};
  /// Unknowns, each once, that a spring as stiff as their diagonal entry holds besides.
  std::vector<Eigen::Index> grounded = {};
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
  /// Unknowns that no entry of K joins with others, alone.
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
  Factor(Solve solve, Compliance compliance, const Size& size, Parts parts = {})
      : solve_(std::move(solve)),
        compliance_(std::move(compliance)),
        size_(size),
        parts_(std::move(parts)) {}

  /// Solves K u = p.
  /// \param load  `n` p [force]
  /// \return `n` u [length]
  /// \throws std::invalid_argument unless there is one entry per unknown
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::Ref<const Eigen::VectorXd>& load) const;
  /// Solves that walk through their own part of the factor, and only that; the same numbers as solve() without other
  /// loads. A back end without such solves has to be asked for all unknowns.
  /// \param unknowns  each once, that no entry of K joins with others
  /// \return what solves for them; nothing if the back end cannot
  /// \throws std::invalid_argument if there is no such unknown
  [[nodiscard]] std::optional<Part> part(const std::vector<Eigen::Index>& unknowns) const;
  /// A K^-1 A^T.
  /// \param A       `n_c x n` [-]
  /// \param ledger  receives the count `operations`
  /// \return `n_c x n_c`, symmetric positive semidefinite [length/force]
  /// \throws std::invalid_argument if A does not have one column per unknown
  [[nodiscard]] Eigen::MatrixXd compliance(const Rows& A, Ledger& ledger) const;

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
};

/// What one process of a team did and took.
struct TeamMember {
  long long peak_bytes =
      0;  ///< the most memory that it had, 0 where the system does not tell [byte]
  long long stiffness_entries = 0;  ///< of K that it assembled for the factor, one triangle
  double operations = 0;            ///< of the factorisation
};

/// Processes that factor together. Number 0 does all that a process alone does; the others assemble their shares of K, and
/// keep their parts of the factor.
struct Team {
  /// Makes the share of K of a process of what process 0 told; both triangles.
  using Prepare = std::function<Eigen::SparseMatrix<double>(const std::string&)>;

  int rank = 0;  ///< number of this process
  int size = 1;  ///< how many there are
  /// Of process 0: hands a text, such as that of a scene file, to the others.
  std::function<void(const std::string&)> tell;
  /// Of the others: works for process 0 until that ends. \return the exit code that it ends with
  std::function<int(const Prepare&)> help;
  /// Of process 0: lets the others end. The argument is the exit code.
  std::function<void(int)> end;
  /// Of process 0: what every process did.
  std::function<std::vector<TeamMember>()> members;
};

/// One member of the family.
struct Backend {
  const char* name;     ///< as `--backend` wants it
  const char* summary;  ///< one line of a list
  /// Factors K. `ledger` receives the counts `nonzeros` and `operations`, in phases of its own. It throws ProblemError as
  /// FrontalFactor does if K is singular to working precision or has an entry that is not finite.
  Factor (*factor)(const Stiffness& stiffness, Ledger& ledger);
  /// Joins the processes that this one was started with; null if it works alone.
  Team (*team)() = nullptr;
};

/// \return the member that is ours, needs no other library and is the default
[[nodiscard]] Backend frontal();

/// The family.
/// \return all members that this program has, ours first
[[nodiscard]] const std::vector<Backend>& backends();

/// A member that this program was built without.
struct MissingBackend {
  std::string name;    ///< as `--backend` would want it
  std::string needed;  ///< packages, and how to get them
};

/// \return the members that this program could have and was built without
[[nodiscard]] std::vector<MissingBackend> missing_backends();

/// Looks up a member.
/// \param name  of a back end
/// \return it
/// \throws ProblemError with the nearest name and all others, and with what to install if the library knows more
[[nodiscard]] const Backend& find_backend(const std::string& name);

/// For back ends that tell no pivots: whether K is singular to working precision.
///
/// Loads as large as the stiffness of each unknown, with signs at random, move the unknowns of a K that holds them by less
/// than what rounding divided by their number would. If they move further FrontalFactor is asked, which looks at every pivot.
/// \param stiffness  that was factored
/// \param solve      u of K u = p
/// \throws ProblemError of FrontalFactor
void check_held(const Stiffness& stiffness, const Factor::Solve& solve);

/// Says why a back end could not factor K.
/// \param stiffness  that it was given
/// \param backend    its name
/// \throws ProblemError of FrontalFactor; another one if that has nothing to say against K
[[noreturn]] void refuse(const Stiffness& stiffness, const char* backend);

}  // namespace signorini
