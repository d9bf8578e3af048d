#pragma once

#include <string>

namespace wold::test {

/// What a shell script in Blender's place says of itself.
struct FakeBlender {
  const char* version = "9.9.9";
  bool volumes = true;
  bool fog = true;
  const char* devices = "[]";  ///< JSON
};

/// The line by which wold_render.py --probe answers, without its end.
inline std::string probe_line(const FakeBlender& fake = {}) {
  const auto word = [](bool value) { return value ? "true" : "false"; };
  return std::string("wold: probe {\"version\": \"") + fake.version +
         "\", \"module\": false, \"volumes\": " + word(fake.volumes) +
         ", \"fog\": " + word(fake.fog) + ", \"nanovdb\": null, \"devices\": " + fake.devices +
         ", \"threads\": 2, \"python\": \"3.99\"}";
}

/// How such a script begins: it says what it is and what it can when it is asked, and ends. Every
/// probe adds a line to the file `probes`.
inline std::string fake_blender_head(const std::string& probes, const FakeBlender& fake = {}) {
  return std::string("#!/bin/sh\ncase \"$*\" in\n  --version) echo 'Blender ") + fake.version +
         "'; exit ;;\n  *--probe) echo probe >> '" + probes + "'; echo '" + probe_line(fake) +
         "'; exit ;;\nesac\n";
}

}  // namespace wold::test
