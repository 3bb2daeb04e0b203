// Back ends that need other libraries, and the processes that some of them work on.
#pragma once
#include <string>

#include "addons/frontal/backend.hpp"
#include "command_line/scene_run.hpp"

namespace command_line {

/// Goes on as the program beside this one that is linked with all libraries of back ends, if there is one; does not return
/// then. This one is not, so that whoever does not need them does not wait for them to be loaded.
/// \param argv  of main()
void become_whole(char** argv);

/// \param name  of a back end \return whether this program has it
bool has_backend(const std::string& name);

/// How a starter of several processes, such as mpirun, started this one.
struct Launch {
  int rank = 0;  ///< number of this process
  int size = 1;  ///< how many there are
};

/// \return what Open MPI or the process manager of MPICH says; one process if neither says anything
Launch launched();

/// Of a process that is not number 0: works for that one. What goes wrong here process 0 says.
/// \param team     of all processes
/// \param file     of the scene, whose text process 0 tells
/// \return the exit code
int help(const signorini::Team& team, const std::string& file);

/// Tells what every process of a team did.
/// \param team    of which this is process 0; null if the back end works alone
/// \param ledger  of a run that is solved, gets a phase for each of them
void count_members(const signorini::Team* team, signorini::Ledger& ledger);

}  // namespace command_line
