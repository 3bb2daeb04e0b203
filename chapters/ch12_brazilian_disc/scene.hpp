/// \file
/// Chapter 12 - the disc between two plates, as a scene.
#pragma once
#include <array>
#include <cmath>

#include "closed_form/brazilian.hpp"
#include "closed_form/hertz.hpp"
#include "closed_form/moduli.hpp"
#include "meshes/disc.hpp"
#include "meshes/half_space.hpp"
#include "meshes/reshape.hpp"
#include "signorini/pairing/mortar.hpp"  // the operators of these contacts, linked with it
#include "signorini/report/shown.hpp"
#include "signorini/scene/readings.hpp"

namespace ch12 {

using namespace signorini;
using Eigen::Index;

// [data]
constexpr double R = 50;     // radius of the disc [mm]
constexpr double P = 41.76;  // load, of both halves together [N/mm]
constexpr double size = 95;  // width of a half plate, and its height [mm]
const Material material{4000, 0.35, PlaneState::Strain, 1};  // of all bodies [MPa], [mm]

const double modulus = plane_strain_modulus(material.youngs_modulus, material.poisson_ratio);
const LineContact plate{R, contact_modulus(modulus, modulus), P};
const double b = hertz_half_width(plate);           // of the contacts [mm]
const SqueezedDisc lines{R, P};                     // line loads in place of the plates
const double strength = brazilian_strength(lines);  // equation (44) [MPa]
// [data]

/// How finely the three bodies are divided.
struct Division {
  Index columns;      ///< cells of the disc along its rim at a pole, on 1.4 mm
  Index rows;         ///< cells below them, on 1.4 mm
  Index layers;       ///< from there to the middle of the disc
  double grading;     ///< small: fine in the middle; large: fine at the poles
  double plates = 1;  ///< finer plates
};

// [divisions]
const Division for_middle{28, 12, 36, 0.1};  // cells of one size in the middle
const Division for_axis{28, 18, 84, 2};      // cells that grow from the poles to the middle
// [divisions]

/// \param division  of the bodies
/// \return meshes of the right halves of disc, lower and upper plate
inline std::array<Mesh, 3> three_meshes(const Division& division) {
  PressedDiscSpec round;
  round.core = {1.4, 1.4};  // even cells where the contact will be
  round.core_columns = division.columns;
  round.core_rows = division.rows;
  round.layers = division.layers;
  round.layer_grading = division.grading;
  round.part = DiscPart::Right;
  HalfSpaceSpec flat;
  flat.name = "lower plate";
  flat.width = flat.depth = size;
  flat.core = round.core;
  flat.core_columns = std::lround(20 * division.plates);
  flat.core_rows = std::lround(10 * division.plates);
  flat.layers = std::lround(14 * division.plates);
  flat.layer_grading = 3;
  const Mesh lower = make_half_space(flat);
  Mesh upper = moved(mirrored(lower, MirrorLine::Level), {0, 2 * R});
  upper.name = "upper plate";
  return {make_pressed_disc(round), lower, upper};
}

/// \param division  of the bodies
/// \return right halves of disc, lower and upper plate
// [scene]
inline Scene disc_between_plates(const Division& division) {
  const std::array<Mesh, 3> meshes = three_meshes(division);
  Scene scene;
  scene.bodies.resize(3);
  for (std::size_t k = 0; k < 3; ++k) {
    scene.bodies[k].mesh = meshes[k];
    scene.bodies[k].material = material;
    scene.bodies[k].supports = {symmetric("axis")};
  }
  scene.bodies[1].supports.push_back(fixed("base"));
  scene.bodies[2].loads.edges = {{"base", P / 2 / size, {}}};
  scene.contacts = {{{"rim", "disc"}, Side{"surface", "lower plate"}},
                    {{"rim", "disc"}, Side{"surface", "upper plate"}}};
  return scene;
}
// [scene]

/// \param d      of the bodies
/// \param finer  cells in each direction, against `d`
/// \return solved scene
inline SolvedScene solve_disc(const Division& d, double finer = 1) {
  const auto cells = [finer](Index n) {
    return static_cast<Index>(std::lround(finer * static_cast<double>(n)));
  };
  return shown(disc_between_plates(
                   {cells(d.columns), cells(d.rows), cells(d.layers), d.grading, d.plates * finer}),
               "the disc");
}

}  // namespace ch12
