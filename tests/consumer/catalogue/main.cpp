// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Prints every type that a configuration can name: the registry reaches all components.
#include <cstdio>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/version.hpp>

int main() {
  std::printf("leastcost %s\n", LEASTCOST_VERSION);
  for (const leastcost::PluginKind& kind : leastcost::plugin_kinds())
    for (const std::string& type : leastcost::types_of(kind))
      std::printf("%s %s\n", std::string(kind.name).c_str(), type.c_str());
}
