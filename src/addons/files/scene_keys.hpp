// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The keys of a scene file, table by table.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "addons/along/variation.hpp"
#include "addons/equations/bonds.hpp"
#include "addons/files/keys.hpp"
#include "addons/files/scene_file.hpp"

namespace signorini {

/// A scene while it is read.
struct SceneDraft {
  SceneFile file;                         ///< what was read so far
  const Value* root = nullptr;            ///< the whole text
  std::optional<Material> material = {};  ///< of the bodies that have none of their own
  bool material_used = false;             ///< whether there is such a body
  Bonds bonds = {};                       ///< those read so far
  std::vector<History> histories = {};    ///< of load steps
  std::vector<const Value*> places = {};  ///< where each of them stands in the text
};

/// A body while it is read.
struct BodyDraft : Body {
  bool own_material = false;            ///< whether it has one
  std::vector<std::string> notes = {};  ///< on what was read
};

/// A contact while it is read.
struct ContactDraft : ContactSpec {
  std::vector<Body>* bodies = nullptr;  ///< of the scene; get boundaries that are made of several
};

/// A tie while it is read.
struct TieDraft : ContactDraft {
  bool slides = false;  ///< see Tie
  bool closes = false;  ///< see Tie
  std::optional<Eigen::Vector2d> stiffness = {};  ///< see Tie
};

/// A linear relation while it is read.
struct RelationDraft : Relation {
  const std::vector<Body>* bodies = nullptr;  ///< of the scene
};

/// A term of a relation while it is read.
struct TermDraft : RelationTerm {
  const std::vector<Body>* bodies = nullptr;  ///< of the scene
};

/// A rigid side while it is read.
struct RigidDraft : RigidSide {
  const std::vector<Body>* bodies = nullptr;  ///< of the scene
};

/// What acts at one point of a body.
struct PointDraft {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< where
  std::optional<Eigen::Vector2d> force = {};     ///< on the body
  std::optional<Eigen::Vector2d> spring = {};    ///< stiffness in x and y
  std::optional<double> x = {};                  ///< given displacement along x
  std::optional<double> y = {};                  ///< given displacement along y
  std::string history = {};                      ///< that force and displacements grow with
};

/// Some load steps while they are read.
struct StepsDraft {
  std::optional<double> until = {};  ///< time at which they end
  int count = 1;                     ///< how many
  const Value* values = nullptr;     ///< table of what histories reach then
};

/// A layer while it is read.
struct LayerDraft : Material {
  std::string region = {};       ///< its name; empty if it is given by a box
  std::vector<double> box = {};  ///< left, bottom, right, top; empty without
};

/// A probe while it is read.
struct ProbeDraft {
  std::string name = {};                     ///< of its own; empty: see read_probes()
  std::string body = {};                     ///< name of its body; empty: the only one
  std::optional<Eigen::Vector2d> at = {};    ///< a point
  std::optional<Eigen::Vector2d> from = {};  ///< begin of a line
  std::optional<Eigen::Vector2d> to = {};    ///< end of it
  int points = 11;                           ///< on the line
  std::string along = {};                    ///< a boundary
  std::string of = {};                       ///< a boundary
};

/// \return keys of the head of the file, in the order in which they are read
[[nodiscard]] const Keys<SceneDraft>& scene_keys();
/// \return keys of a body, in the order in which they are read
[[nodiscard]] const Keys<BodyDraft>& body_keys();
/// \return keys of a material, in the order in which they are read
[[nodiscard]] const Keys<Material>& material_keys();
/// Reads a material and checks it. \param value  of the key \param material  gets it
/// \throws ProblemError as read_members() and check_material()
void read_material(const Value& value, Material& material);
/// \return keys of a layer, in the order in which they are read
[[nodiscard]] const Keys<LayerDraft>& layer_keys();
/// \return keys of a point of a body, in the order in which they are read
[[nodiscard]] const Keys<PointDraft>& point_keys();
/// \return keys of a temperature, in the order in which they are read
[[nodiscard]] const Keys<Temperature>& temperature_keys();
/// \return keys of a contact, in the order in which they are read
[[nodiscard]] const Keys<ContactDraft>& contact_keys();
/// \return keys of a tie, in the order in which they are read
[[nodiscard]] const Keys<TieDraft>& tie_keys();
/// \return keys of a linear relation, in the order in which they are read
[[nodiscard]] const Keys<RelationDraft>& relation_keys();
/// \return keys of a term of a relation, in the order in which they are read
[[nodiscard]] const Keys<TermDraft>& term_keys();
/// \return keys of a rigid side, in the order in which they are read
[[nodiscard]] const Keys<RigidDraft>& rigid_keys();
/// A boundary as BODY.BOUNDARY; of the only body also as BOUNDARY. \param value  of the key \param bodies  of the scene
/// \return it \throws ProblemError if there is none of that name, or it is empty
[[nodiscard]] Side side_of(const Value& value, const std::vector<Body>& bodies);
/// Refuses choices of a contact that nothing asks for. \param value  its table \param contact  that was read
/// \throws ProblemError if there is one
void check_choices(const Value& value, const ContactSpec& contact);
/// \return keys of the head of the file that bonds have, in the order in which they are read
[[nodiscard]] const Keys<SceneDraft>& bond_keys();
/// \return keys of a history, in the order in which they are read
[[nodiscard]] const Keys<History>& history_keys();
/// \return keys of some load steps, in the order in which they are read
[[nodiscard]] const Keys<StepsDraft>& steps_keys();
/// \return keys of a value that grows with a history
[[nodiscard]] const std::vector<KeyInfo>& growing_keys();
/// \return keys of friction, in the order in which they are read
[[nodiscard]] const Keys<Friction>& friction_keys();
/// \return keys of a probe, in the order in which they are read
[[nodiscard]] const Keys<ProbeDraft>& probe_keys();
/// Reads `[[probe]]`, after `[[body]]`. \param value  of the key \param draft  gets the probes
/// \throws ProblemError for a place that is not in its body, or a name that another has
void read_probes(const Value& value, SceneDraft& draft);
/// \return keys of what is written, in the order in which they are read
[[nodiscard]] const Keys<Output>& output_keys();

/// Reads `[[history]]`. \param value  of the key \param draft  gets the histories
/// \throws ProblemError for a value that is not a table, or a name that another has
void read_histories(const Value& value, SceneDraft& draft);
/// Reads `[[steps]]`, after `[[history]]`. \param value  of the key \param draft  gets the path
/// \throws ProblemError for a step of size zero or a value of a history that has a table
void read_steps(const Value& value, SceneDraft& draft);
/// Checks that every history that is named exists, and that every one is named, when all has been read.
/// \param draft  of the text
/// \throws ProblemError otherwise, or if there are histories but no steps
void check_histories(const SceneDraft& draft);

/// \return keys of a value that varies from place to place
[[nodiscard]] const std::vector<KeyInfo>& varying_keys();
/// \param value  any \return whether it is a table or a polynomial for what varies from place to place
[[nodiscard]] bool varies(const Value& value);
/// Reads what varies from place to place.
/// \param value       as varies() wants it
/// \param components  1 of a number, 2 of a vector
/// \param mesh        of the body
/// \param boundary    along which it varies; empty: in the body
/// \return the variation
/// \throws ProblemError for anything else, or places of a table that do not increase
[[nodiscard]] Variation read_variation(const Value& value, Eigen::Index components,
                                       const Mesh& mesh, const std::string& boundary);
/// Takes `{ value = ..., history = ... }` apart.
/// \param value    of a key
/// \param history  receives the name; stays as it is without one
/// \return what stands under `value`, or the value itself, if it is by itself
/// \throws ProblemError for a table of other keys
[[nodiscard]] const Value& without_history(const Value& value, std::string& history);

/// A value that may grow with a history: by itself, or as `{ value = ..., history = ... }`.
/// \param value    of a key
/// \param into     receives it
/// \param history  receives the name; stays as it is without one
/// \param bound    of numbers
/// \throws ProblemError as take()
template <typename M>
void take_growing(const Value& value, M& into, std::string& history, Bound bound = Bound::Any) {
  take(without_history(value, history), into, bound);
}

/// \param member  gets the name \return the key `history` of a table
template <typename T>
[[nodiscard]] Key<T> history_key(std::string T::*member) {
  return key("history", member, "",
             "what it grows with, see load steps; without it, it is always there");
}

}  // namespace signorini
