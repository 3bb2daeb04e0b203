/// \file
/// The keys of a scene file, table by table.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene_file/keys.hpp"
#include "signorini/scene_file/scene_file.hpp"

namespace signorini {

/// A scene while it is read.
struct SceneDraft {
  SceneFile file;                         ///< what was read so far
  std::optional<Material> material = {};  ///< of the bodies that have none of their own
  bool material_used = false;             ///< whether there is such a body
};

/// A body while it is read.
struct BodyDraft {
  Body body;              ///< what was read so far
  bool material = false;  ///< whether it has one of its own
};

/// A contact while it is read.
struct ContactDraft {
  const std::vector<Body>* bodies = nullptr;  ///< of the scene
  ContactSpec contact;                        ///< what was read so far
};

/// What acts at one point of a body.
struct PointDraft {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< where
  std::optional<Eigen::Vector2d> force = {};     ///< on the body
  std::optional<Eigen::Vector2d> spring = {};    ///< stiffness in x and y
  std::optional<double> x = {};                  ///< given displacement along x
  std::optional<double> y = {};                  ///< given displacement along y
};

/// A layer while it is read.
struct LayerDraft {
  std::string region;       ///< its name; empty if it is given by a box
  std::vector<double> box;  ///< left, bottom, right, top; empty without
  Material material;        ///< that of the body, but for what the layer says
};

/// \return keys of the head of the file, in the order in which they are read
[[nodiscard]] const Keys<SceneDraft>& scene_keys();
/// \return keys of a body, in the order in which they are read
[[nodiscard]] const Keys<BodyDraft>& body_keys();
/// \return keys of a material, in the order in which they are read
[[nodiscard]] const Keys<Material>& material_keys();
/// \return keys of a layer, in the order in which they are read
[[nodiscard]] const Keys<LayerDraft>& layer_keys();
/// \return keys of a point of a body, in the order in which they are read
[[nodiscard]] const Keys<PointDraft>& point_keys();
/// \return keys of a temperature, in the order in which they are read
[[nodiscard]] const Keys<Temperature>& temperature_keys();
/// \return keys of a contact, in the order in which they are read
[[nodiscard]] const Keys<ContactDraft>& contact_keys();
/// \return keys of friction, in the order in which they are read
[[nodiscard]] const Keys<Friction>& friction_keys();
/// \return keys of what is written, in the order in which they are read
[[nodiscard]] const Keys<Output>& output_keys();

}  // namespace signorini
