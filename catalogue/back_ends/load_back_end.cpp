// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/back_ends/load_back_end.hpp"

#include <dlfcn.h>

#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

BackEndMaker load_back_end(const char* library, const char* file) {
  void* handle = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);  // one that is loaded already is not loaded again
  void* maker = handle == nullptr ? nullptr : ::dlsym(handle, "leastcost_make_back_end");
  if (maker == nullptr) {
    const char* why = ::dlerror();
    throw InputError(std::string(library) + " is needed for this, but its part of leastcost, " + file +
                     ", cannot be loaded: install the whole of leastcost, and the " + library +
                     " that this build was made with (" + (why == nullptr ? "unknown reason" : why) + ")");
  }
  return reinterpret_cast<BackEndMaker>(maker);
}

}  // namespace leastcost
