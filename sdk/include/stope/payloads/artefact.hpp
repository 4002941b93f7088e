#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stope {

/// A file to be, as an export makes it.
struct ArtefactFile {
  std::string extension;  ///< without the dot; the file is called by the output's own name
  std::vector<std::uint8_t> bytes;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("extension", s.extension);
    visit("bytes", s.bytes);
  }
};

/// What an export makes of a payload: one file, or one and its companions (map.yaml and map.pgm).
/// The framework alone writes them, each named `<stem>.<extension>`.
struct Artefact {
  static constexpr std::string_view kType = "stope/Artefact@1";
  std::vector<ArtefactFile> files;  ///< the first is the one the pipeline asked for
  static constexpr void fields(auto& s, auto&& visit) { visit("files", s.files); }
};

}  // namespace stope
