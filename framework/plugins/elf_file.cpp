// The problem: to learn how a library was built before running any of its code, from a file that
// may be anything. The ELF header is checked against this machine; then all notes are gathered,
// from the PT_NOTE segments (which survive stripping) and, where there are none of ours, from the
// section `.note.stope`. Every range is checked against the file's size before it is read. Cost: a
// handful of small reads.
#include "framework/plugins/elf_file.hpp"

#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "framework/plugins/plugin_file.hpp"

namespace stope {

namespace {

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
constexpr const char* kMachineName = "x86-64";
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
constexpr const char* kMachineName = "64-bit ARM";
#else
#error "Stope runs on x86-64 and on 64-bit ARM"
#endif

constexpr std::uint64_t kMostNoteBytes = 1 << 20;

std::string machine_name(Elf64_Half machine) {
  switch (machine) {
    case EM_X86_64:
      return "x86-64";
    case EM_AARCH64:
      return "64-bit ARM";
    case EM_386:
      return "32-bit x86";
    case EM_ARM:
      return "32-bit ARM";
    case EM_RISCV:
      return "RISC-V";
    case EM_PPC64:
      return "64-bit PowerPC";
    default:
      return fmt::format("machine number {}", machine);
  }
}

[[noreturn]] void refuse_machine(const std::string& other) {
  throw PluginRefused(PluginStatus::kOtherMachine,
                      fmt::format("It was built for {}, this Stope for {}: rebuild it for {}.",
                                  other, kMachineName, kMachineName));
}

Elf64_Ehdr read_header(const OpenFile& file) {
  const std::string what = "the ELF header";
  Elf64_Ehdr header{};
  if (file.size() >= SELFMAG) file.read(0, SELFMAG, header.e_ident, what);
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    throw PluginRefused(
        PluginStatus::kNotALibrary,
        "It is not a library: it does not begin as an ELF file does. Remove it from "
        "the plugin folder.");
  }
  file.read(0, EI_NIDENT, header.e_ident, what);
  if (header.e_ident[EI_CLASS] != ELFCLASS64) refuse_machine("a 32-bit machine");
  if (header.e_ident[EI_DATA] != ELFDATA2LSB) refuse_machine("a big-endian machine");
  file.read(0, sizeof(header), &header, what);
  if (header.e_machine != kMachine) refuse_machine(machine_name(header.e_machine));
  if (header.e_type != ET_DYN) {
    throw PluginRefused(PluginStatus::kNotALibrary,
                        "It is an ELF file but not a shared library: build it with "
                        "stope_add_plugin().");
  }
  return header;
}

template <class Entry>
std::vector<Entry> read_table(const OpenFile& file, std::uint64_t offset, std::uint64_t entry_size,
                              std::uint64_t count, const std::string& what) {
  if (count == 0) return {};
  if (entry_size != sizeof(Entry)) {
    throw PluginRefused(
        PluginStatus::kNotALibrary,
        fmt::format("It is a damaged library: {} cannot be right. Build it again.", what));
  }
  // Counts are 16 bits wide, so that no file can ask for more than a few megabytes.
  file.require(offset, count * sizeof(Entry), what);
  std::vector<Entry> table(count);
  file.read(offset, count * sizeof(Entry), table.data(), what);
  return table;
}

void take_notes_at(const OpenFile& file, std::uint64_t offset, std::uint64_t size,
                   std::uint64_t alignment, ElfNotes& notes) {
  if (size > kMostNoteBytes) return;
  file.require(offset, size, "a note");
  std::vector<char> bytes(size);
  file.read(offset, size, bytes.data(), "a note");
  take_notes(bytes, alignment, notes);
}

/// Whether a section bears this name, by the table of names in another section.
bool is_named(const OpenFile& file, const Elf64_Shdr& section, const Elf64_Shdr& names,
              const std::string& name) {
  if (section.sh_name >= names.sh_size || names.sh_size - section.sh_name <= name.size()) {
    return false;
  }
  std::string found(name.size() + 1, '?');
  file.read(names.sh_offset + section.sh_name, found.size(), found.data(), "a section's name");
  return found == name + '\0';
}

}  // namespace

ElfNotes read_elf(const OpenFile& file) {
  const Elf64_Ehdr header = read_header(file);
  const auto segments = read_table<Elf64_Phdr>(file, header.e_phoff, header.e_phentsize,
                                               header.e_phnum, "the table of segments");
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_LOAD) file.require(segment.p_offset, segment.p_filesz, "a segment");
  }
  // The table of sections stands last in most libraries, so that it tells even a small loss.
  const auto sections =
      read_table<Elf64_Shdr>(file, header.e_shoff, header.e_shentsize,
                             header.e_shoff == 0 ? 0 : header.e_shnum, "the table of sections");

  ElfNotes notes;
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_NOTE) {
      take_notes_at(file, segment.p_offset, segment.p_filesz, segment.p_align, notes);
    }
  }
  for (const Elf64_Shdr& section : sections) {
    if (notes.stope || header.e_shstrndx >= sections.size()) break;
    if (is_named(file, section, sections[header.e_shstrndx], ".note.stope")) {
      take_notes_at(file, section.sh_offset, section.sh_size, section.sh_addralign, notes);
    }
  }
  return notes;
}

}  // namespace stope
