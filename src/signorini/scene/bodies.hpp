/// \file
/// The bodies of a scene by name, their nodes and unknowns one after another.
#pragma once
#include <Eigen/SparseCore>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"
#include "signorini/scene/scene.hpp"

namespace signorini {

/// Adds forces on the nodes of a body to p of all bodies, where its supports leave it free.
/// \param body    one of them
/// \param forces  `n_nodes x 2` [force]
/// \param[in,out] load  p `n` of all bodies [force]
void add_nodal_forces(const BodyModel& body, const NodeArray& forces, Eigen::VectorXd& load);

/// Which body a side belongs to.
/// \param bodies  one or several
/// \param side    that names it, or leaves the name out if there is one only
/// \return its number
/// \throws ProblemError listing the bodies if there is none of that name
[[nodiscard]] std::size_t body_index(const std::vector<BodyModel>& bodies, const Side& side);

/// A side as gap operators want it.
/// \param bodies  that must outlive the result
/// \param side    of one of them
/// \return mesh, boundary and first node
/// \throws ProblemError as body_index(), or if the body has no such boundary
[[nodiscard]] Surface surface(const std::vector<BodyModel>& bodies, const Side& side);

/// \param bodies  none, one or several
/// \return number of their nodes
[[nodiscard]] Eigen::Index count_nodes(const std::vector<BodyModel>& bodies);

/// \param bodies  one or several
/// \param node    of the nodes of all bodies
/// \return number of the body that it belongs to
[[nodiscard]] std::size_t body_of_node(const std::vector<BodyModel>& bodies, Eigen::Index node);

/// \param bodies  one or several
/// \return number of their unknowns
[[nodiscard]] Eigen::Index count_unknowns(const std::vector<BodyModel>& bodies);

/// What messages call a contact.
/// \param bodies   of the scene
/// \param contact  one of its contacts
/// \return such as "contact of 'rim' of 'disc' with 'top' of 'plate'"
[[nodiscard]] std::string describe(const std::vector<BodyModel>& bodies,
                                   const ContactSpec& contact);

/// What tables call the contacts of a scene.
/// \param bodies    of the scene
/// \param contacts  of the scene
/// \return of each such as "disc.rim on plate.top", the sides as a scene file has them, or "disc.rim on half plane"; where
///   two would be called the same, the later ones get " (2)" and so on
[[nodiscard]] std::vector<std::string> contact_names(const std::vector<BodyModel>& bodies,
                                                     const std::vector<ContactSpec>& contacts);

/// Calls a function with the name of every history that loads, supports and temperature of a body follow, empty ones
/// too.
/// \param body   of a scene, constant or not
/// \param visit  what to call
template <typename SomeBody, typename Visit>
void each_history(SomeBody& body, Visit&& visit) {
  visit(body.loads.body_force_history);
  for (auto& load : body.loads.edges) visit(load.history);
  for (auto& load : body.loads.points) visit(load.history);
  for (auto& support : body.supports) visit(support.history);
  if (body.temperature) visit(body.temperature->history);
}

/// \param body  of a scene
/// \return whether it is one of revolution: all round the axis, radial forces and moments about the origin cancel
[[nodiscard]] bool is_axial(const BodyModel& body);

/// Adds forces on the nodes of a body up.
/// \param body    any
/// \param forces  `n_nodes x 2` [force]
/// \return their sum; in axial symmetry that of the whole circle, which has no radial component
[[nodiscard]] Eigen::Vector2d sum_of_forces(const BodyModel& body, const NodeArray& forces);

/// \param contact  any
/// \return whether it has friction or cohesion: a law that allows no friction force is none
[[nodiscard]] bool has_friction(const ContactSpec& contact);

/// The rows of A as the programme has them.
/// \param gaps  of all pairs \param law  of the frictional ones
/// \return the rows of the gaps, and below them those of the slips of the law
[[nodiscard]] NodalRows contact_rows(const Gaps& gaps, const FrictionLaw& law);

/// Moves the pairs of a plan to where the programme has them. \param model  whose `gaps` are of all contacts
void take_gaps(Model& model);

/// Puts matrices of the bodies along the diagonal of one, without a copy if there is one body only.
/// \param bodies  one or several, `n` unknowns in all
/// \param blocks  compressed, one of each body; empty afterwards
/// \param all     becomes `n x n` compressed
void put_along_diagonal(const std::vector<BodyModel>& bodies,
                        std::vector<Eigen::SparseMatrix<double>>& blocks,
                        Eigen::SparseMatrix<double>& all);

/// Where the unknowns of all bodies are.
/// \param plan  from plan(), or a model
/// \return `n x 2` position of the node of each unknown [length]
[[nodiscard]] NodeArray unknown_positions(const Plan& plan);

/// \param scene  any \return whether any of its bodies, or of their layers, has a law of finite strain
[[nodiscard]] bool any_law(const Scene& scene);

/// \param scene  any \return whether its pairs are found where its bodies move to
[[nodiscard]] bool bodies_move(const Scene& scene);

/// Displacements that supports give: at the end of each load step, or, without steps or where bodies have moved, all of them.
/// \param scene  any \param draft  its plan so far
/// \param visit  gets them, `n_nodes x 2` of all bodies [length], and the time of the step, if there is one
void each_given(const Scene& scene, const Plan& draft,
                const std::function<void(const NodeArray& held, std::optional<double> time)>& visit);

/// \param contact  any \param x  a place of its source [length] \return its interference there, in full [length]
[[nodiscard]] double interference_at(const ContactSpec& contact, const Eigen::Vector2d& x);

/// \param scene  with the contact \param contact  one of it \param x  a place of its source [length] \param time  of a step
/// \return how much of the interference there is still to come then, 0 without steps [length]
[[nodiscard]] double interference_to_come(const Scene& scene, const ContactSpec& contact,
                                          const Eigen::Vector2d& x, std::optional<double> time);

}  // namespace signorini
