#include "render/capabilities_json.h"

#include <nlohmann/json.hpp>

namespace wold::render {

using nlohmann::json;

json to_json(const Capabilities& capabilities) {
  json devices = json::array();
  for (const Device& device : capabilities.devices)
    devices.push_back({{"type", device.type}, {"name", device.name}});
  return {{"version", capabilities.version},
          {"python", capabilities.python},
          {"volumes", capabilities.volumes},
          {"fog", capabilities.fog},
          {"nanovdb", capabilities.nanovdb ? json(*capabilities.nanovdb) : json()},
          {"devices", std::move(devices)},
          {"threads", capabilities.threads}};
}

Capabilities capabilities_of(const json& from) {
  Capabilities capabilities;
  capabilities.version = from.at("version").get<std::string>();
  capabilities.python = from.at("python").get<std::string>();
  capabilities.volumes = from.at("volumes").get<bool>();
  capabilities.fog = from.at("fog").get<bool>();
  if (!from.at("nanovdb").is_null()) capabilities.nanovdb = from.at("nanovdb").get<bool>();
  for (const json& device : from.at("devices"))
    capabilities.devices.push_back(
        {device.at("type").get<std::string>(), device.at("name").get<std::string>()});
  capabilities.threads = from.at("threads").get<int>();
  return capabilities;
}

}  // namespace wold::render
