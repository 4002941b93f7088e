#include "framework/report/other_files.hpp"

#include <algorithm>

#include "framework/report/output_name.hpp"
#include "framework/report/pending_file.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;

bool holds_owned(const std::string& folder, const std::set<std::string>& owned) {
  const auto next = owned.lower_bound(folder + "/");
  return owned.contains(folder) || (next != owned.end() && next->starts_with(folder + "/"));
}

void collect(const fs::path& folder, const std::string& prefix, bool of_stream,
             const std::set<std::string>& owned, std::vector<std::string>& others) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string leaf = entry->path().filename().string(), name = prefix + leaf;
    std::error_code ignored;
    if (is_pending(entry->path())) continue;
    if (entry->symlink_status(ignored).type() != fs::file_type::directory) {
      if (!owned.contains(name) && !(of_stream && is_item_name(leaf))) others.push_back(name);
    } else if (holds_owned(name, owned)) {
      collect(entry->path(), name + "/", owned.contains(name), owned, others);
    } else {
      others.push_back(name + "/");
    }
  }
}

}  // namespace

std::vector<std::string> other_files(const fs::path& folder, const std::set<std::string>& owned) {
  std::vector<std::string> others;
  collect(folder, "", false, owned, others);
  std::sort(others.begin(), others.end());
  return others;
}

}  // namespace stope::report
