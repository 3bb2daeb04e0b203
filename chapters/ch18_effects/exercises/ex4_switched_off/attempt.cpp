#include "exercise.hpp"

namespace ex18_4 {

signorini::Scene without(signorini::Scene scene, const std::string& effect) {
  // Enough for the warm cylinder on a rough plate. Your code here: any scene, any of the ten.
  if (effect == "temperature") scene.bodies[0].temperature.reset();
  if (effect == "friction") scene.contacts[0].friction.reset();
  return scene;
}

}  // namespace ex18_4
