#include "framework/compare/report/viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "framework/compare/report/map_underlay.hpp"
#include "framework/compare/report/overlay.hpp"
#include "framework/report/draw/base64.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/page/outputs.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMostPictures = 64ULL << 20;

bool shown_kind(const CellArtefact& file) {
  return file.kind == CellArtefact::Kind::kPicture || file.kind == CellArtefact::Kind::kGeojson;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// JSON that may stand in a <script>: nothing in it can end the element.
std::string script_text(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

class ViewerData {
 public:
  explicit ViewerData(const Comparison& comparison) : comparison_(comparison) {}

  /// False if there is nothing to look at.
  bool collect() {
    Json outputs = Json::array(), cells = Json::object();
    for (std::size_t recording = 0; recording < comparison_.recordings.size(); ++recording)
      for (std::size_t seed = 0; seed < comparison_.seeds.size(); ++seed) {
        for (std::size_t arm = 0; arm < comparison_.arms.size(); ++arm)
          add_cell(comparison_.cell(arm, recording, seed), outputs, cells);
        add_overlays(recording, seed);
      }
    json_ = {{"baseline", comparison_.baseline},
             {"outputs", outputs},
             {"cells", cells},
             {"pictures", pictures_},
             {"maps", maps_},
             {"overlays", overlays_}};
    return !outputs.empty();
  }
  const Json& json() const { return json_; }

 private:
  static std::string key(std::size_t recording, std::size_t seed, std::size_t arm) {
    return fmt::format("{}/{}/{}", recording, seed, arm);
  }

  void add_cell(const ComparedCell& cell, Json& outputs, Json& cells) {
    Json files = Json::object();
    for (const CellArtefact& file : cell.artefacts) {
      if (!shown_kind(file) || file.companion) continue;
      const bool picture = file.kind == CellArtefact::Kind::kPicture;
      const Json output{{"name", file.output}, {"picture", picture}};
      if (std::find(outputs.begin(), outputs.end(), output) == outputs.end())
        outputs.push_back(output);
      // A stream's outputs are many files: the last is what it came to.
      files[file.output] = {{"sum", file.sha256}, {"link", link_text(file.path)}};
      if (picture) add_picture(file);
    }
    Json json{{"files", files}};
    if (cell.status != CellStatus::kDone)
      json["why"] = cell.status == CellStatus::kPending ? "not run yet" : cell.sentence;
    cells[key(cell.recording, cell.seed, cell.arm)] = json;
  }

  void add_picture(const CellArtefact& file) {
    if (pictures_.contains(file.sha256) || held_ + file.bytes > kMostPictures) return;
    const std::string bytes = bytes_of(comparison_.folder / file.path);
    if (bytes.empty()) return;
    held_ += bytes.size();
    pictures_[file.sha256] =
        base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }

  // Where the run's map lies on the sheet, and by which name it is held; null if it saved none.
  Json map_under(const ComparedCell& cell, const Sheet& sheet) {
    for (const CellArtefact& file : cell.artefacts) {
      if (file.companion || !file.path.ends_with(".yaml")) continue;
      const auto picture = std::find_if(
          cell.artefacts.begin(), cell.artefacts.end(), [&](const CellArtefact& other) {
            return other.companion && other.output == file.output && other.path.ends_with(".pgm");
          });
      if (picture == cell.artefacts.end()) continue;
      // Equal pictures may lie in different places.
      const std::string name = file.sha256 + picture->sha256;
      const auto known = frames_.find(name);
      const auto frame = known == frames_.end() ? hold_map(name, file) : known->second;
      if (!frame) continue;
      const Placement place = placement_of(*frame, sheet);
      return {{"held", name},         {"x", place.x},           {"y", place.y},
              {"width", place.width}, {"height", place.height}, {"transform", place.transform}};
    }
    return nullptr;
  }

  std::optional<GridFrame> hold_map(const std::string& name, const CellArtefact& yaml) {
    auto& frame = frames_[name];
    if (const auto map = read_map(comparison_.folder / yaml.path);
        map && held_ + map->png.size() <= kMostPictures) {
      held_ += map->png.size();
      maps_[name] = base64(map->png);
      frame = map->frame;
    }
    return frame;
  }

  // The baseline's lines beside those of every arm, all arms on one sheet.
  void add_overlays(std::size_t recording, std::size_t seed) {
    std::map<std::string, std::map<std::size_t, Lines>> drawings;  // by output, by arm
    for (std::size_t arm = 0; arm < comparison_.arms.size(); ++arm)
      for (const CellArtefact& file : comparison_.cell(arm, recording, seed).artefacts)
        if (file.kind == CellArtefact::Kind::kGeojson && !file.companion)
          drawings[file.output][arm] = lines_of_geojson(bytes_of(comparison_.folder / file.path));
    for (const auto& [output, arms] : drawings) {
      if (arms.count(comparison_.baseline) == 0) continue;
      std::vector<Lines> all;
      for (const auto& [arm, lines] : arms) all.push_back(lines);
      const Sheet sheet = sheet_for(all);
      if (sheet.extent.empty()) continue;
      const Json map = map_under(comparison_.cell(comparison_.baseline, recording, seed), sheet);
      for (const auto& [arm, lines] : arms) {
        if (arm == comparison_.baseline) continue;
        const Overlay overlay = overlay_of(arms.at(comparison_.baseline), lines, sheet);
        overlays_[key(recording, seed, arm)][output] = {
            {"height", std::round(sheet.height)},
            {"tolerance", length_text(sheet.tolerance)},
            {"map", map},
            {"parts", {overlay.common, overlay.only_first, overlay.only_second}},
            {"lengths",
             {length_text(overlay.metres_common), length_text(overlay.metres_first),
              length_text(overlay.metres_second)}}};
      }
    }
  }

  const Comparison& comparison_;
  std::uint64_t held_ = 0;
  std::map<std::string, std::optional<GridFrame>> frames_;  ///< of the maps, by name
  Json pictures_ = Json::object(), maps_ = Json::object(), overlays_ = Json::object(), json_;
};

template <class Named>
std::string options(const std::vector<Named>& all, std::size_t without = ~std::size_t{0}) {
  std::string html;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i != without)
      html += fmt::format("<option value=\"{}\">{}</option>", i, escaped(all[i].name));
  return html;
}

std::string seed_options(const std::vector<std::uint64_t>& seeds) {
  std::string html;
  for (std::size_t i = 0; i < seeds.size(); ++i)
    html += fmt::format("<option value=\"{}\">{}</option>", i, seeds[i]);
  return html;
}

}  // namespace

std::string viewer_html(const Comparison& comparison) {
  if (comparison.arms.size() < 2) return {};
  ViewerData data(comparison);
  if (!data.collect()) return {};
  const std::string baseline = escaped(comparison.arms[comparison.baseline].name);
  return fmt::format(
      "<section id=\"side-by-side\"><h2>Side by side</h2>\n<form class=\"choose\" "
      "autocomplete=\"off\"><label>recording <select id=\"recording\">{}</select></label>"
      "<label{}>seed <select id=\"seed\">{}</select></label><label><span "
      "class=\"left-name\">{}</span> against <select id=\"arm\">{}</select></label></form>\n"
      "<noscript><p class=\"soft\">Pictures need JavaScript. They stand as files in the folder of "
      "each run, under arms/.</p></noscript>\n<div id=\"views\" class=\"views\" "
      "data-left=\"{}\"></div>\n<script type=\"application/json\" id=\"viewer-data\">{}</script>\n"
      "</section>\n",
      options(comparison.recordings), comparison.seeds.size() > 1 ? "" : " hidden=\"hidden\"",
      seed_options(comparison.seeds), baseline, options(comparison.arms, comparison.baseline),
      baseline, script_text(data.json()));
}

}  // namespace stope::report
