#include "framework/plugins/probe_messages.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace stope {

namespace {

constexpr std::uint32_t kMostBytes = 16 << 20;

struct Head {
  std::uint32_t kind, status, size;
};

}  // namespace

void write_message(int descriptor, const ProbeMessage& message) noexcept {
  const Head head{message.kind, static_cast<std::uint32_t>(message.status),
                  static_cast<std::uint32_t>(message.text.size())};
  const auto write_all = [descriptor](const char* data, std::size_t size) {
    while (size > 0) {
      const ssize_t written = ::write(descriptor, data, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      data += written;
      size -= static_cast<std::size_t>(written);
    }
    return true;
  };
  if (write_all(reinterpret_cast<const char*>(&head), sizeof(head))) {
    write_all(message.text.data(), message.text.size());
  }
}

std::optional<ProbeMessage> ProbeMessageReader::next() {
  Head head{};
  if (bytes_.size() < sizeof(head)) return std::nullopt;
  std::memcpy(&head, bytes_.data(), sizeof(head));
  if (head.kind > ProbeMessage::kAllWell || head.size > kMostBytes ||
      head.status > static_cast<std::uint32_t>(PluginStatus::kDuplicateStage)) {
    throw Error("a message of the probe makes no sense");
  }
  if (bytes_.size() - sizeof(head) < head.size) return std::nullopt;
  ProbeMessage message{static_cast<ProbeMessage::Kind>(head.kind),
                       static_cast<PluginStatus>(head.status),
                       bytes_.substr(sizeof(head), head.size)};
  bytes_.erase(0, sizeof(head) + head.size);
  return message;
}

}  // namespace stope
