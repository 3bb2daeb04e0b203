// Random scenes of all kinds that a user may pose, the wrong ones among them.
#pragma once
#include <cstdint>
#include <string>

#include "signorini/scene/scene.hpp"

namespace signorini_test {

/// Whether any contact of a scene rubs, whether it has the rarer effects, or bodies of revolution.
enum class RandomScenes {
  Frictionless,
  Frictional,
  Varied,  ///< as Frictional, and often with point forces, springs, layers, heat, interference, adjusted gaps
  Revolved,   ///< the cross-sections are of bodies of revolution
  Triangles,  ///< as Frictionless, on triangles and meshes of both
  Paths,      ///< load steps of Varied, some on triangles, some revolved
  Tied,       ///< as Varied, with ties in the place of contacts between two bodies
  Moving,     ///< bodies that move in load steps, see random_moving()
  Any         ///< any of these, then made odd or wrong, see spoil()
};

/// A scene and what it is, in words.
struct RandomScene {
  signorini::Scene scene;
  std::string text;    ///< bodies, supports, loads, contacts, units
  bool wrong = false;  ///< whether it has something that no scene may have
};

/// The scene of a seed: 3 to 120 cells.
///
/// Blocks to 300 times as long as thin, discs, rings and half-spaces, one or two, with supports or without,
/// on obstacles or on each other, by every gap operator and element; graded and curved; Poisson's ratios to
/// 0.4999, stiffness ratios, lengths and stresses over twelve decades, turned, and moved by up to 1e4 sizes;
/// loads that press, drag, pull, or vanish; gaps that are open, exactly zero, or overlaps; friction
/// coefficients from 1e-6 to 1e4 and cohesion. plan() refuses some of them, as it should: a body that nothing
/// stops is one.
///
/// Only whole numbers are drawn, and all numbers come from them by single roundings before a mesh is made.
/// \param seed  names the scene
/// \param kind  Frictional, Varied and Paths: at least one contact rubs. Revolved: the frictionless scene of the same seed as the
///   cross-section of bodies of revolution, which reach the axis or keep off it by up to three sizes.
///   Triangles: the scene of Frictionless with the cells of its first body cut into triangles, and every second one
///   of the others. Paths: five steps, see add_path(); a quarter in triangles, a fifth revolved. Any: what else the
///   seed says, with up to three changes of spoil()
/// \return the scene, with the default solvers
RandomScene random_scene(std::uint64_t seed, RandomScenes kind);

}  // namespace signorini_test
