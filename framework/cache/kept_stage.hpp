#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/cache/stage_keys.hpp"
#include "stope/digest.hpp"

namespace stope {

/// An item of an output in the store.
struct KeptItem {
  std::int64_t stamp = 0;
  std::uint64_t index = 0;
  Digest object;
  std::uint64_t size = 0;  ///< bytes, encoded
  static constexpr void fields(auto& s, auto&& visit) {
    visit("stamp", s.stamp);
    visit("index", s.index);
    visit("high", s.object.high);
    visit("low", s.object.low);
    visit("size", s.size);
  }
};

/// The type of what is no output of a stage but was noted about one.
inline constexpr std::string_view kNoteType = "note";

/// An output of a stage in the store, whole.
struct KeptOutput {
  std::string port;
  std::string type;
  std::uint64_t layout = 0;
  bool lazy = false;  ///< of a source: it loads its items from its own files, and they are not here
  std::vector<KeptItem> items;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("port", s.port);
    visit("type", s.type);
    visit("layout", s.layout);
    visit("lazy", s.lazy);
    visit("items", s.items);
  }
};

/// What a store knows of one key.
struct KeptStage {
  static constexpr std::uint32_t kFormat = 1;
  std::uint32_t format = kFormat;   ///< of this record
  std::string name;                 ///< of the stage that was kept last, for people
  std::vector<KeptOutput> outputs;  ///< those that were read when the stage ran
  const KeptOutput* find(const PortInfo& port) const;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("format", s.format);
    visit("name", s.name);
    visit("outputs", s.outputs);
  }
};

/// Which objects the outputs of a stage are, by its key: `stages/ab/cdef…`, a small file each. A
/// file that is damaged is as good as none, but counted.
class KeptStages {
 public:
  /// Makes the folder under a store's root. Throws Error if it cannot.
  explicit KeptStages(const std::filesystem::path& root);
  std::optional<KeptStage> find(const Digest& key) const;
  /// Files of this store that find() could not read.
  std::size_t damaged() const { return damaged_; }
  /// Adds outputs to what is known of a key. Throws Error if the disk is full.
  void save(const Digest& key, const KeptStage& stage);

 private:
  std::filesystem::path file_of(const Digest& key) const;
  std::filesystem::path folder_;
  mutable std::atomic<std::size_t> damaged_{0};
};

}  // namespace stope
