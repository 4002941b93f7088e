#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/browser/browser_pipe.hpp"

namespace stope::testing {

/// How a page is looked at.
struct View {
  int width = 1280, height = 900;
  bool dark = false;
};

/// A point of the window, in CSS pixels.
struct WindowPoint {
  double x = 0, y = 0;
};

/// A real browser with one page in it, worked as a person would: mouse and keys go through the
/// browser's own input, not through scripts. Throws std::runtime_error with a sentence.
class Browser {
 public:
  /// Keeps its profile and what it downloads below `folder`, which must exist.
  explicit Browser(const std::filesystem::path& folder);

  /// Opens a file and waits until it is loaded.
  void open(const std::filesystem::path& file, const View& view = {});
  /// The value of a JavaScript expression.
  nlohmann::json evaluate(const std::string& expression);
  /// Scrolls the first element that a CSS selector finds into view and returns its middle.
  WindowPoint middle_of(const std::string& selector);

  void click(WindowPoint at);
  /// Presses at one point, moves in steps, releases at the other.
  void drag(WindowPoint from, WindowPoint to);
  void press(const std::string& key);
  /// Chooses an entry of a <select> by its text, as its change event tells.
  void choose(const std::string& selector, const std::string& text);

  /// Waits until a file of that name was downloaded and returns it.
  std::filesystem::path downloaded(const std::string& name);
  /// The whole page as a PNG file.
  void screenshot(const std::filesystem::path& file);

  /// What the page complained of since it was opened: exceptions, console errors, and everything it
  /// asked for from outside itself.
  const std::vector<std::string>& complaints();

 private:
  nlohmann::json call(const std::string& method,
                      nlohmann::json parameters = nlohmann::json::object());
  void note(const nlohmann::json& event);
  void wait_for(const std::string& event);
  void settle();
  void mouse(const char* type, WindowPoint at, int buttons);

  std::filesystem::path folder_;
  BrowserPipe pipe_;
  std::string session_, page_address_;
  int last_id_ = 0;
  std::vector<std::string> complaints_, events_;
};

}  // namespace stope::testing
