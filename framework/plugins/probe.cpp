// The problem: to learn what a library offers one must run its code, and that code may crash, hang
// or call exit(). The idea: a forked child opens it and writes what it does, then what it found,
// through a pipe; the parent reads until the child says that all is well or until time is up, and
// believes nothing but that word. Cost: a fork and a few hundred bytes, once for each new file.
#include "framework/plugins/probe.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "framework/plugins/plugin_file.hpp"
#include "framework/plugins/probe_child.hpp"
#include "framework/plugins/probe_messages.hpp"

namespace stope {

namespace {

using Clock = std::chrono::steady_clock;

class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_, O_CLOEXEC) != 0) {
      throw PluginRefused(PluginStatus::kFailed,
                          fmt::format("It cannot be probed: {}.", std::strerror(errno)));
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(ends_[0]);
    close_writer();
  }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2] = {-1, -1};
};

/// A child process that is killed, with all it started, and collected when this object goes.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    // Before it is collected: afterwards its number may be another process's.
    ::kill(-id_, SIGKILL);
    ::kill(id_, SIGKILL);
    while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  /// How it ended, or none if it had not by the deadline. Does not collect it.
  std::optional<siginfo_t> ending(Clock::time_point deadline) const {
    for (;;) {
      siginfo_t info{};
      if (::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
          info.si_pid == id_) {
        return info;
      }
      if (Clock::now() >= deadline) return std::nullopt;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

 private:
  pid_t id_;
};

/// What the child had said by the time it ended or its time did.
struct Heard {
  std::string doing = "being opened";
  std::optional<Manifest> manifest;
  bool all_well = false;
  bool in_time = true;
};

/// Takes one message. Throws PluginRefused if it tells of a failure.
void take(const ProbeMessage& message, Heard& heard) {
  switch (message.kind) {
    case ProbeMessage::kDoing:
      heard.doing = message.text;
      return;
    case ProbeMessage::kRefused:
      throw PluginRefused(message.status, message.text);
    case ProbeMessage::kManifest: {
      ByteReader reader(std::as_bytes(std::span(message.text)));
      heard.manifest = decode_manifest(reader);
      return;
    }
    case ProbeMessage::kAllWell:
      heard.all_well = heard.manifest.has_value();
      return;
  }
}

Heard listen(int descriptor, Clock::time_point deadline) {
  Heard heard;
  ProbeMessageReader reader;
  while (!heard.all_well) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd waiting{descriptor, POLLIN, 0};
    const int ready = left.count() <= 0 ? 0 : ::poll(&waiting, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) {
      heard.in_time = false;
      break;
    }
    char bytes[4096];
    const ssize_t got = ::read(descriptor, bytes, sizeof(bytes));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    reader.add({bytes, static_cast<std::size_t>(got)});
    while (const auto message = reader.next()) take(*message, heard);
  }
  return heard;
}

[[noreturn]] void refuse_ending(const Heard& heard, const siginfo_t& ending) {
  if (ending.si_code == CLD_KILLED || ending.si_code == CLD_DUMPED) {
    const char* name = ::sigabbrev_np(ending.si_status);
    throw PluginRefused(PluginStatus::kCrashed,
                        fmt::format("It crashed (SIG{}) while {}. It is left out; tell its author.",
                                    name ? name : std::to_string(ending.si_status), heard.doing));
  }
  throw PluginRefused(
      PluginStatus::kExited,
      fmt::format("It ended the process that opened it, while {}. It is left out; a "
                  "plugin must not call exit().",
                  heard.doing));
}

[[noreturn]] void refuse_hanging(const Heard& heard, std::chrono::milliseconds limit) {
  throw PluginRefused(PluginStatus::kHung,
                      fmt::format("It hung: it was still {} after {} s and was stopped. It is left "
                                  "out; tell its author.",
                                  heard.doing, static_cast<double>(limit.count()) / 1000));
}

}  // namespace

Manifest probe_plugin(const std::filesystem::path& file, std::chrono::milliseconds limit) {
  Pipe pipe;
  const Clock::time_point deadline = Clock::now() + limit;
  const pid_t id = ::fork();
  if (id < 0) {
    throw PluginRefused(PluginStatus::kFailed,
                        fmt::format("It cannot be probed: {}.", std::strerror(errno)));
  }
  if (id == 0) run_probe_child(file, pipe.writer());
  pipe.close_writer();
  Child child(id);
  ::setpgid(id, id);  // as the child does, whoever is first
  try {
    Heard heard = listen(pipe.reader(), deadline);
    if (heard.all_well) return std::move(*heard.manifest);
    if (!heard.in_time) refuse_hanging(heard, limit);
    if (const auto ending = child.ending(deadline)) refuse_ending(heard, *ending);
    refuse_hanging(heard, limit);
  } catch (const PluginRefused&) {
    throw;
  } catch (const Error& error) {
    throw PluginRefused(PluginStatus::kFailed,
                        fmt::format("What it says of itself is garbled: {}.", error.what()));
  }
}

}  // namespace stope
