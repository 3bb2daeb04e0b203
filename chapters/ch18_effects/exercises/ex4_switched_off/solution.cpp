#include <functional>
#include <map>
#include <stdexcept>

#include "exercise.hpp"

namespace ex18_4 {

using signorini::Body;
using signorini::ContactSpec;

signorini::Scene without(signorini::Scene scene, const std::string& effect) {
  static const std::map<std::string, std::function<void(Body&)>> of_bodies = {
      {"body force", [](Body& body) { body.loads.body_force = {}; }},
      {"edge loads", [](Body& body) { body.loads.edges.clear(); }},
      {"point forces", [](Body& body) { body.loads.points.clear(); }},
      {"layers", [](Body& body) { body.layers.clear(); }},
      {"temperature", [](Body& body) { body.temperature.reset(); }},
      {"springs", [](Body& body) { body.springs.clear(); }}};
  static const std::map<std::string, std::function<void(ContactSpec&)>> of_contacts = {
      {"adjusted gaps", [](ContactSpec& contact) { contact.adjust.reset(); }},
      {"interference", [](ContactSpec& contact) { contact.interference.reset(); }},
      {"friction",  // shares its block with cohesion
       [](ContactSpec& contact) {
         if (contact.friction) contact.friction->coefficient = 0;
       }},
      {"cohesion", [](ContactSpec& contact) {
         if (contact.friction) contact.friction->cohesion = 0;
       }}};
  if (const auto found = of_bodies.find(effect); found != of_bodies.end())
    for (Body& body : scene.bodies) found->second(body);
  else if (const auto here = of_contacts.find(effect); here != of_contacts.end())
    for (ContactSpec& contact : scene.contacts) here->second(contact);
  else
    throw std::invalid_argument("without: '" + effect + "' cannot be switched off");
  return scene;
}

}  // namespace ex18_4
