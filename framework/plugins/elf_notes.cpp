#include "framework/plugins/elf_notes.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstring>

namespace stope {

namespace {

constexpr std::uint64_t aligned(std::uint64_t value, std::uint64_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

void take_stope_note(const std::vector<char>& bytes, std::uint64_t begin, std::uint64_t description,
                     std::uint64_t size, ElfNotes& notes) {
  constexpr std::uint64_t kHead = offsetof(AbiNote, compiler_family) - offsetof(AbiNote, epoch);
  if (size < kHead || description - begin != offsetof(AbiNote, epoch)) return;
  AbiNote note{};
  const std::uint64_t whole = sizeof(AbiNote) - offsetof(AbiNote, epoch);
  notes.complete = size == whole;
  std::memcpy(&note.epoch, bytes.data() + description, notes.complete ? whole : kHead);
  note.plugin_id[sizeof(note.plugin_id) - 1] = '\0';
  note.plugin_version[sizeof(note.plugin_version) - 1] = '\0';
  notes.stope = note;
}

}  // namespace

void take_notes(const std::vector<char>& bytes, std::uint64_t alignment, ElfNotes& notes) {
  if (alignment != 8) alignment = 4;
  std::uint64_t at = 0;
  while (at + sizeof(Elf64_Nhdr) <= bytes.size()) {
    Elf64_Nhdr note{};
    std::memcpy(&note, bytes.data() + at, sizeof(note));
    const std::uint64_t name = at + sizeof(note);
    const std::uint64_t description = aligned(name + note.n_namesz, alignment);
    const std::uint64_t end = description + note.n_descsz;
    if (end > bytes.size()) return;
    const std::string owner(bytes.data() + name, ::strnlen(bytes.data() + name, note.n_namesz));
    if (owner == "Stope" && note.n_type == 1 && !notes.stope) {
      take_stope_note(bytes, at, description, note.n_descsz, notes);
    } else if (owner == "GNU" && note.n_type == NT_GNU_BUILD_ID && notes.build_id.empty()) {
      for (std::uint64_t i = description; i < end; ++i) {
        notes.build_id += fmt::format("{:02x}", static_cast<unsigned char>(bytes[i]));
      }
    }
    at = aligned(end, alignment);
  }
}

}  // namespace stope
