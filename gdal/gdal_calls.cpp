// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "gdal/gdal_calls.hpp"

#include <dlfcn.h>

#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// The library as it was found, or why it was not.
struct LoadedGdal {
  GdalCalls calls;
  std::string fault;
};

std::string unusable(const std::string& why) {
  return "GDAL is needed, but its library " LEASTCOST_GDAL_LIBRARY " cannot be used (" + why +
         "): install the package " LEASTCOST_GDAL_PACKAGE;
}

LoadedGdal load() {
  LoadedGdal loaded;
  void* library = dlopen(LEASTCOST_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) {
    const char* why = dlerror();
    loaded.fault = unusable(why == nullptr ? "it cannot be loaded" : why);
    return loaded;
  }
  const auto find = [&]<class Function>(const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) loaded.fault = unusable("it has no function " + std::string(name));
  };
#define LEASTCOST_FIND_FUNCTION(name) find(#name, loaded.calls.name);
  LEASTCOST_GDAL_FUNCTIONS(LEASTCOST_FIND_FUNCTION)
#undef LEASTCOST_FIND_FUNCTION
  if (loaded.fault.empty()) loaded.calls.GDALAllRegister();
  return loaded;
}

const LoadedGdal& loaded_gdal() {
  static const LoadedGdal loaded = load();
  return loaded;
}

}  // namespace

const GdalCalls& gdal() {
  if (!gdal_fault().empty()) throw InputError(gdal_fault());
  return loaded_gdal().calls;
}

const std::string& gdal_fault() { return loaded_gdal().fault; }

}  // namespace leastcost
