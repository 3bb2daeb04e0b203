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
  std::optional<double> x = {}, y = {};          ///< given displacements
};

/// A layer while it is read.
struct LayerDraft {
  std::string region;       ///< its name; empty if it is given by a box
  std::vector<double> box;  ///< left, bottom, right, top; empty without
  Material material;        ///< that of the body, but for what the layer says
};

/// \name The tables
/// \return the keys in the order in which they are read
/// @{
[[nodiscard]] const Keys<SceneDraft>& scene_keys();
[[nodiscard]] const Keys<BodyDraft>& body_keys();
[[nodiscard]] const Keys<Material>& material_keys();
[[nodiscard]] const Keys<LayerDraft>& layer_keys();
[[nodiscard]] const Keys<PointDraft>& point_keys();
[[nodiscard]] const Keys<Temperature>& temperature_keys();
[[nodiscard]] const Keys<ContactDraft>& contact_keys();
[[nodiscard]] const Keys<Friction>& friction_keys();
[[nodiscard]] const Keys<Output>& output_keys();
/// @}

}  // namespace signorini
