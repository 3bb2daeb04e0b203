/// \file
/// The bodies of a scene by name, their nodes and unknowns one after another, and their rigid motions.
#pragma once
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

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

/// \param bodies  one or several
/// \return number of their nodes
[[nodiscard]] Eigen::Index count_nodes(const std::vector<BodyModel>& bodies);

/// What messages call a contact.
/// \param bodies   of the scene
/// \param contact  one of its contacts
/// \return such as "contact of 'rim' of 'disc' with 'top' of 'plate'"
[[nodiscard]] std::string describe(const std::vector<BodyModel>& bodies,
                                   const ContactSpec& contact);

/// \param contact  any
/// \return whether it has friction or cohesion: a law that allows no friction force is none
[[nodiscard]] bool rubs(const ContactSpec& contact);

/// Brings the sides of a contact together as it says: small gaps adjusted first, then its interference.
/// \param contact       whose lengths have been checked
/// \param[in,out] pairs  of the meshes; gets new initial gaps
/// \return what was done, to go on a line about the pairs; nothing if the contact asks for nothing
[[nodiscard]] std::string fit(const ContactSpec& contact, Pairs& pairs);

/// Rigid motions that supports and springs leave to the bodies, each on the unknowns of all of them.
/// \param bodies  with their unknowns and springs
/// \return `n_r` independent motions
[[nodiscard]] std::vector<FreeMotion> rigid_modes(const std::vector<BodyModel>& bodies);

/// Rigid motions that open and close no gap.
/// \param A      `n_c x n` gaps, see Gaps
/// \param modes  `n_r` rigid motions of `n` unknowns
/// \return sentences of the modes that take part in such a motion, empty if every motion moves some gap
[[nodiscard]] std::vector<std::string> motions_without_contact(
    const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, const std::vector<FreeMotion>& modes);

/// One unknown per rigid mode to attach a spring to, so that the springs alone hold the bodies.
/// \param modes  `n_r` independent rigid motions of `n` unknowns
/// \return `n_r` numbers of unknowns
[[nodiscard]] std::vector<Eigen::Index> grounding(const std::vector<FreeMotion>& modes);

/// The shapes of rigid modes side by side.
/// \param modes  `n_r`
/// \return `n x n_r`; empty if there are none
[[nodiscard]] Eigen::MatrixXd mode_shapes(const std::vector<FreeMotion>& modes);

/// Where the unknowns of all bodies are.
/// \param model  from build()
/// \return `n x 2` position of the node of each unknown [length]
[[nodiscard]] NodeArray unknown_positions(const Model& model);

}  // namespace signorini
