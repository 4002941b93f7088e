#include "browser_pipe.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace stope::testing {
namespace {

using Clock = std::chrono::steady_clock;

// The browser reads at 3 and writes at 4. Pipes may sit on these numbers already, so they are first
// moved out of the way.
[[noreturn]] void become_browser(int read_end, int write_end, const std::string& profile,
                                 const std::string& log) {
  const int in = ::fcntl(read_end, F_DUPFD, 10), out = ::fcntl(write_end, F_DUPFD, 10);
  ::dup2(in, 3);
  ::dup2(out, 4);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(file, 1);
  ::dup2(file, 2);
  for (int other = 5; other < 64; ++other) ::close(other);
  ::setsid();
  const std::string data = "--user-data-dir=" + profile;
  ::execlp("chromium", "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic",
           "--no-first-run", "--disable-background-networking", "--disable-component-update",
           "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars",
           "--remote-debugging-pipe", data.c_str(), "about:blank", static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

BrowserPipe::BrowserPipe(const std::filesystem::path& folder) {
  int down[2], up[2];
  if (::pipe2(down, O_CLOEXEC) != 0 || ::pipe2(up, O_CLOEXEC) != 0)
    throw std::runtime_error("cannot make pipes to the browser");
  ::signal(SIGPIPE, SIG_IGN);
  const std::string profile = (folder / "profile").string(), log = (folder / "log.txt").string();
  child_ = ::fork();
  if (child_ < 0) throw std::runtime_error("cannot start a process for the browser");
  if (child_ == 0) become_browser(down[0], up[1], profile, log);
  ::close(down[0]);
  ::close(up[1]);
  to_ = down[1];
  from_ = up[0];
}

BrowserPipe::~BrowserPipe() {
  // Without its pipe the browser ends by itself; what hangs is ended, with all that it started.
  ::close(to_);
  ::close(from_);
  const auto until = Clock::now() + std::chrono::seconds(5);
  while (::waitpid(child_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > until) {
      ::kill(-child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void BrowserPipe::send(const std::string& text) {
  const char* data = text.c_str();
  for (std::size_t left = text.size() + 1; left > 0;) {
    const ssize_t count = ::write(to_, data, left);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw std::runtime_error(
          "the browser is gone; is 'chromium' installed? tools/deps installs it");
    data += count;
    left -= static_cast<std::size_t>(count);
  }
}

std::string BrowserPipe::receive(double seconds) {
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(seconds));
  for (;;) {
    const std::size_t end = buffer_.find('\0');
    if (end != std::string::npos) {
      std::string text = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return text;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    pollfd wanted{from_, POLLIN, 0};
    if (left.count() <= 0 || ::poll(&wanted, 1, static_cast<int>(left.count())) == 0) return {};
    char part[65536];
    const ssize_t count = ::read(from_, part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw std::runtime_error(
          "the browser ended; is 'chromium' installed? tools/deps installs it");
    buffer_.append(part, static_cast<std::size_t>(count));
  }
}

}  // namespace stope::testing
