// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include <leastcost/catalogue/output/write_run.hpp>

namespace leastcost {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "leastcost-XXXXXX").string();
  if (error)
    throw HostError("there is no folder for temporary files: " + error.message() +
                    "; let TMPDIR name one that can be written");
  if (mkdtemp(name.data()) == nullptr)
    throw HostError(name + ": cannot make a temporary folder: " + std::generic_category().message(errno) +
                    "; let TMPDIR name a folder that can be written");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace leastcost
