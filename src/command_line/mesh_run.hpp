// What is in a mesh file: told and drawn, before anybody writes a scene about it.
#pragma once
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "addons/files/json.hpp"
#include "command_line/gnuplot.hpp"
#include "signorini/fem/mesh.hpp"

namespace command_line {

/// What a file holds.
struct MeshRun {
  std::string name;                     ///< of the file, for messages
  std::vector<signorini::Mesh> meshes;  ///< one or more
  std::vector<std::string> unread;      ///< what of an input file is not read
  std::vector<std::string>
      further_sets;  ///< element sets of an input file that are no body by themselves
  std::vector<std::string> notes = {};            ///< on names and thicknesses of an input file
  std::vector<std::filesystem::path> files = {};  ///< that were read
};

/// Reads the meshes of a file of Gmsh, of an input file of CalculiX or Abaqus, or of a scene.
/// \param file  a name, or `-`
/// \return what it holds
/// \throws signorini::ProblemError as the reader of such files
MeshRun read_meshes(const std::string& file);

/// \param run  from read_meshes() \return whether check_mesh() takes all meshes
bool usable(const MeshRun& run);

/// Prints bodies, cells, quality and boundaries. \param out  where to \param run  from read_meshes()
void print(std::ostream& out, const MeshRun& run);
/// Writes them. \param json  new \param run  from read_meshes()
void write(signorini::Json& json, const MeshRun& run);

/// Draws the meshes and their boundaries.
/// \param file  to be written
/// \param kind  of it
/// \param run   from read_meshes()
/// \throws signorini::ProblemError as run_gnuplot()
void draw(const std::filesystem::path& file, PictureKind kind, const MeshRun& run);

}  // namespace command_line
