/// \file
/// The plan of a scene, and the model that is made of it: the plan with its numbers.
///
/// Both describe the same statement, with one row of A per gap and, below, one per slip:
/// \f[ Ku = p - A^T\lambda, \qquad \text{gap, slip} = g - Au. \f]
/// The plan knows its sizes: unknowns, rows, rigid motions. The model knows its numbers as well: K, p, A and g. A plan is
/// cheap, because nothing is assembled for it. So a user may read what a run will compute before the run begins.
/// build() moves the plan into the model: one is the other with more known.
/// What is absent in a scene has left nothing in either.
/// A block of 3 x 3 nodes on a rigid plane has 18 unknowns, less those that supports hold, and 3 rows of gaps.
#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "signorini/contact/gaps.hpp"
#include "signorini/fem/assembly.hpp"
#include "signorini/fem/elements.hpp"
#include "signorini/fem/factor.hpp"
#include "signorini/fem/free_motions.hpp"
#include "signorini/fem/joints.hpp"
#include "signorini/scene/path.hpp"
#include "signorini/solvers/primal_dual_active_set.hpp"

namespace signorini {

struct ContactSpec;
struct Effect;

/// A body ready to be assembled, and where it stands among the others.
struct BodyModel {
  Mesh mesh;                   ///< of the scene
  Element element;             ///< found by its name
  MaterialField material;      ///< of its cells
  Loads loads;                 ///< of the scene
  Unknowns unknowns;           ///< of this body, numbered from 0
  Eigen::Index first_node;     ///< number of its first node among those of all bodies
  Eigen::Index first_unknown;  ///< number of its first unknown
  /// spring_stiffness() of its springs; no rows without any
  Eigen::SparseMatrix<double> springs = {};
  std::vector<MeshPiece> pieces = {};  ///< of the mesh
};

/// Which bodies a contact is between, by their numbers.
///
/// Names are looked up once, when the scene is planned. Later steps find bodies by number.
struct ContactBodies {
  std::size_t source;                 ///< of the source
  std::optional<std::size_t> target;  ///< of the target; a rigid obstacle has none
  /// Whether its forces act on more than the places and bodies that its pairs tell, as those of a relation
  bool acts_elsewhere = false;
};
struct Equations;
struct Model;
struct FollowedContact;

/// Changes the gaps of a contact before supports move anything.
/// \param contact       of the scene, whose lengths have been checked
/// \param[in,out] pairs  of the meshes; gets new initial gaps
/// \return what was done, to go on the line of the contact; nothing if the contact asks for nothing
using FitSides = std::function<std::string(const ContactSpec& contact, Pairs& pairs)>;

/// Where bodies have moved to, if pairs were found there: rows of A and their places are those of moved bodies then.
///
/// In a load step of bodies that move, places and displacements are those of one iteration. Gaps and slips are counted
/// from the scene nonetheless: \f$ g - Au \f$ with all of u is the gap there to first order.
struct Standing {
  NodeArray displacement;  ///< `n_nodes x 2` of all nodes, from the scene to there [length]
  /// `n_nodes x 2` by how much they have moved since the end of the last step, less what all have in common if there is no obstacle [length]
  NodeArray since;
  double reach = std::numeric_limits<double>::infinity();  ///< of pairs that are found there, see GapOptions [length]
};
struct StepLoop;

/// What a scene calls for, found without assembling anything. It may be copied, and is all that build() needs.
struct Plan {
  std::vector<std::string> on;       ///< bodies and effects that are on, one line each
  std::vector<std::string> off;      ///< names of the effects that are off
  std::vector<std::string> notes;    ///< what a user should know, such as an element that will lock
  std::vector<MeshQuality> quality;  ///< of the worst cells, per body
  std::vector<const Effect*> effects;  ///< that are on, members of effects()
  std::vector<BodyModel> bodies;       ///< as in the scene
  Unknowns unknowns;                   ///< `n` of all bodies, one after another
  std::vector<FreeMotion> modes;  ///< `n_r` rigid motions that supports leave: null vectors of K
  std::vector<FitSides> fits;     ///< of effects before contact, which calls them in this order
  Gaps gaps;                      ///< `n_c` candidate pairs of all contacts, none without
  std::vector<std::string> contacts;  ///< names: those of the scene, then relations that hold up to a number
  std::vector<std::size_t> contact_of;             ///< `n_c` number of the contact of each pair
  std::vector<ContactBodies> contact_bodies = {};  ///< of each contact
  /// All of these as they were paired, to find their pairs again; null without contact, or if all gaps are linear
  std::shared_ptr<const std::vector<FollowedContact>> followed = {};
  std::vector<bool> small_sliding = {};  ///< of each contact, see ContactSpec
  FrictionLaw law;  ///< of the pairs that can slide and whose own contact has friction
  Solver solver = primal_dual_active_set();  ///< of the scene
  Path path = {};                            ///< load steps, none without
  double time = 0;  ///< of the load step that the loads of a model are of, see Path [time]; 0 before the first
  std::vector<std::string> follows = {};     ///< histories that bonds follow: one entry for each bond and history
  std::vector<LoadPart> parts = {};     ///< one for each history; p and g are their sum times these
  Backend backend = default_backend();  ///< of the scene, factors K
  std::any order = {};  ///< for the back end to begin with, see Stiffness; empty: it finds its own
  std::shared_ptr<const StepLoop> loop = {};  ///< of bodies that move; null: a step is one problem
  std::shared_ptr<const Equations> equations = {};  ///< of the bonds of the scene; null without
  std::vector<Eigen::Index> two_sided = {};  ///< pairs that never lift off, increasing, of the add-on equations
  std::function<void(Model&)> finish = {};  ///< called by build() behind all effects; none by default
  std::shared_ptr<const Standing> standing = {};  ///< null: bodies are where the scene has them
};

/// The plan of a scene and its numbers. build() has made `programme` and `pairs` of `gaps`, which are empty now.
struct Model : Plan {
  QuadraticProgramme programme;  ///< K, p, A, g of the gaps, then of the slips of `law`
  Pairs pairs;                   ///< `n_c` that can close; see Gaps
};

}  // namespace signorini
