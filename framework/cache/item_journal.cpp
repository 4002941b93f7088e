#include "framework/cache/item_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>
#include <system_error>

#include "stope/digest.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

/// An item and the digest of it, without padding.
struct Line {
  std::int64_t stamp = 0;
  std::uint64_t index = 0, high = 0, low = 0, size = 0, check = 0;

  std::uint64_t right_check() const {
    Digester digester;
    digester.write(this, offsetof(Line, check));
    return digester.digest().low;
  }
};
static_assert(sizeof(Line) == 6 * sizeof(std::uint64_t));

}  // namespace

ItemJournal::ItemJournal(const std::filesystem::path& root) : folder_(root / "partial") {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw Error(fmt::format("cannot make the store {}: {}", root.string(), error.message()));
}

std::filesystem::path ItemJournal::file_of(const Digest& key, const std::string& port) const {
  return folder_ / fmt::format("{}.{}", key.text(), port);
}

void ItemJournal::add(const Digest& key, const std::string& port, const KeptItem& item) {
  Line line{item.stamp, item.index, item.object.high, item.object.low, item.size, 0};
  line.check = line.right_check();
  const int file =
      ::open(file_of(key, port).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  // In one write, so that lines of two processes do not mix; a torn one fails its check.
  [[maybe_unused]] const ssize_t written = ::write(file, &line, sizeof line);
  ::close(file);
}

std::map<std::uint64_t, KeptItem> ItemJournal::items(const Digest& key,
                                                     const std::string& port) const {
  std::map<std::uint64_t, KeptItem> items;
  std::ifstream stream(file_of(key, port), std::ios::binary);
  for (Line line; stream.read(reinterpret_cast<char*>(&line), sizeof line);) {
    if (line.check != line.right_check()) break;
    items[line.index] = {line.stamp, line.index, {line.high, line.low}, line.size};
  }
  return items;
}

void ItemJournal::remove(const Digest& key, const std::string& port) {
  std::error_code ignored;
  std::filesystem::remove(file_of(key, port), ignored);
}

}  // namespace stope
