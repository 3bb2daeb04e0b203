// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The back ends of this program: who factors K. To add one: write a `.cpp` with a function of its name that returns it, and
/// put that name into the table in backends.cpp; one that needs another library lives in `src/backends/`, and
/// `cmake/Backends.cmake` puts its name there where the library is found. The conformance suite picks it up.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "signorini/fem/factor.hpp"

namespace signorini {

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

/// \return the member that is ours and needs no other library
[[nodiscard]] Backend frontal();

/// Adds the members of the table to backends(): frontal() first, which becomes the default of every scene.
void register_backends();

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
