#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace stope::testing {

/// A headless Chromium that is spoken to over two pipes, one JSON text after the other, each ended
/// by a NUL (the DevTools protocol with --remote-debugging-pipe). It has a new, empty profile in
/// `folder` and ends with this object. Throws std::runtime_error with a sentence.
class BrowserPipe {
 public:
  explicit BrowserPipe(const std::filesystem::path& folder);
  ~BrowserPipe();
  BrowserPipe(const BrowserPipe&) = delete;

  void send(const std::string& text);
  /// The next text, for at most `seconds`; empty if none came.
  std::string receive(double seconds);

 private:
  pid_t child_ = -1;
  int to_ = -1, from_ = -1;
  std::string buffer_;
};

}  // namespace stope::testing
