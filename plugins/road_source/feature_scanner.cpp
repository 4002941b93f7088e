#include "plugins/road_source/feature_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stope/error.hpp"

namespace stope::road_source {
namespace {

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text_.starts_with("\xef\xbb\xbf")) place_ = 3;
  }

  Collection scan() {
    skip_blanks();
    if (place_ == text_.size()) fail("the file is empty");
    if (text_[place_] != '{') fail("this is no GeoJSON: expected an object that begins with {");
    ++place_;
    Collection collection;
    bool found = false;
    while (!took('}')) {
      if (!collection.members.empty() || found) expect(',');
      const std::string_view key = scan_key();
      expect(':');
      skip_blanks();
      if (key != "features") {
        collection.members.emplace_back(key, scan_value());
        continue;
      }
      if (found) fail("there is a second list 'features'");
      found = true;
      scan_list(collection.features);
    }
    skip_blanks();
    if (place_ != text_.size()) fail("something follows the end of the collection");
    if (!found) fail("there is no list 'features': this is not a GeoJSON FeatureCollection");
    return collection;
  }

 private:
  void skip_blanks() {
    for (; place_ < text_.size(); ++place_) {
      const char c = text_[place_];
      if (c != ' ' && c != '\n' && c != '\r' && c != '\t') return;
    }
  }

  bool took(char c) {
    skip_blanks();
    if (place_ == text_.size() || text_[place_] != c) return false;
    ++place_;
    return true;
  }

  void expect(char c) {
    if (took(c)) return;
    if (place_ == text_.size()) fail_cut_off();
    fail(fmt::format("expected '{}' here, not '{}'", c, text_[place_]));
  }

  std::string_view scan_key() {
    skip_blanks();
    if (place_ == text_.size()) fail_cut_off();
    if (text_[place_] != '"') fail("expected a name in double quotes");
    const std::size_t begin = place_;
    skip_text();
    return text_.substr(begin + 1, place_ - begin - 2);
  }

  void skip_text() {
    for (++place_; place_ < text_.size(); ++place_) {
      if (text_[place_] == '\\') {
        ++place_;
      } else if (text_[place_] == '"') {
        ++place_;
        return;
      }
    }
    place_ = text_.size();
    fail_cut_off();
  }

  // Up to where the brackets that open here are closed; what is within is parsed later.
  FeatureText scan_value() {
    const std::size_t begin = place_;
    const std::uint32_t line = line_here();
    std::size_t depth = 0;
    while (place_ < text_.size()) {
      const char c = text_[place_];
      if (c == '"') {
        skip_text();
      } else if (depth == 0 && (c == ',' || c == '}' || c == ']')) {
        break;
      } else {
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        ++place_;
      }
      if (depth == 0 && (c == '}' || c == ']' || c == '"'))
        return {text_.substr(begin, place_ - begin), line};
    }
    if (place_ == text_.size()) fail_cut_off();
    if (place_ == begin) fail("expected a value here");
    return {text_.substr(begin, place_ - begin), line};
  }

  void scan_list(std::vector<FeatureText>& features) {
    if (place_ == text_.size()) fail_cut_off();
    if (text_[place_] != '[') fail("'features' is no list: expected [");
    ++place_;
    if (took(']')) return;
    do {
      skip_blanks();
      if (place_ == text_.size()) fail_cut_off(features.size());
      const std::size_t count = features.size() + 1;
      cut_feature_ = count;
      features.push_back(scan_value());
      skip_blanks();
    } while (took(','));
    cut_feature_ = 0;
    expect(']');
  }

  std::uint32_t line_here() {
    line_ += static_cast<std::uint32_t>(
        std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                   text_.begin() + static_cast<std::ptrdiff_t>(place_), '\n'));
    counted_ = place_;
    return line_;
  }

  [[noreturn]] void fail(const std::string& what) {
    throw Error(fmt::format("the road graph {}:{}: {}", name_, line_here(), what));
  }
  [[noreturn]] void fail_cut_off(std::size_t after = 0) {
    if (cut_feature_ > 0)
      fail(fmt::format("the file is cut off in feature {}. Copy it again", cut_feature_));
    if (after > 0) fail(fmt::format("the file is cut off after feature {}. Copy it again", after));
    fail("the file is cut off. Copy it again");
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t place_ = 0, counted_ = 0, cut_feature_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace

Collection scan_features(std::string_view text, const std::string& name) {
  return Scanner(text, name).scan();
}

}  // namespace stope::road_source
