#include "framework/plugins/probe_child.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "framework/plugins/floating_point_modes.hpp"
#include "framework/plugins/linked_libraries.hpp"
#include "framework/plugins/plugin_library.hpp"
#include "framework/plugins/probe_messages.hpp"

namespace stope {

namespace {

/// Cuts what ties the child to the terminal, the signals and the life of its parent.
void detach_from_parent() {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  // Handlers of the parent (of Ctrl-C, of a sanitizer) would hide how the plugin ended.
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGINT, SIGTERM}) {
    ::signal(number, SIG_DFL);
  }
  ::signal(SIGPIPE, SIG_IGN);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (const int nowhere = ::open("/dev/null", O_RDWR); nowhere >= 0) {
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      ::dup2(nowhere, standard);
    }
  }
  // First of all exit handlers to run: those of the parent must not run here.
  std::atexit([] { ::_exit(EXIT_FAILURE); });
}

Manifest describe_in_child(const std::filesystem::path& file, int descriptor) {
  const auto tell = [descriptor](const std::string& doing) {
    write_message(descriptor, {ProbeMessage::kDoing, PluginStatus::kUsable, doing});
  };
  const FloatingPointModes before = floating_point_modes();
  const PluginLibrary library(file, tell);
  Manifest manifest = library.describe(tell);
  manifest.libraries = linked_libraries(file);
  if (floating_point_modes() != before) {
    throw PluginRefused(PluginStatus::kFloatingPoint,
                        "It changes the floating-point modes when it describes its stages, so that "
                        "other stages would compute other numbers: leave them as they are.");
  }
  return manifest;
}

}  // namespace

void run_probe_child(const std::filesystem::path& file, int descriptor) noexcept {
  // A parent without standard files has pipes in their places, which detaching would overwrite.
  descriptor = ::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  detach_from_parent();
  try {
    ByteBuffer buffer;
    encode_manifest(describe_in_child(file, descriptor), buffer);
    const auto* data = reinterpret_cast<const char*>(buffer.bytes().data());
    write_message(descriptor, {ProbeMessage::kManifest, PluginStatus::kUsable,
                               std::string(data, buffer.bytes().size())});
    write_message(descriptor, {ProbeMessage::kAllWell, PluginStatus::kUsable, ""});
  } catch (const PluginRefused& refused) {
    write_message(descriptor, {ProbeMessage::kRefused, refused.status(), refused.what()});
  } catch (const std::exception& error) {
    write_message(descriptor, {ProbeMessage::kRefused, PluginStatus::kFailed,
                               std::string("It cannot be described: ") + error.what() + "."});
  }
  ::_exit(EXIT_SUCCESS);
}

}  // namespace stope
