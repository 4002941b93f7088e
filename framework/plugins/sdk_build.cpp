#include "framework/plugins/sdk_build.hpp"

#include <link.h>

#include <filesystem>

#include "framework/plugins/elf_notes.hpp"

namespace stope {
namespace {

int look_at(dl_phdr_info* object, std::size_t, void* data) {
  if (!std::filesystem::path(object->dlpi_name).filename().string().starts_with("libstope.so"))
    return 0;
  ElfNotes& notes = *static_cast<ElfNotes*>(data);
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const auto& part = object->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const char* begin = reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr);
    take_notes({begin, begin + part.p_memsz}, part.p_align, notes);
  }
  return 1;
}

}  // namespace

std::string sdk_build_id() {
  ElfNotes notes;
  ::dl_iterate_phdr(look_at, &notes);
  return notes.build_id;
}

}  // namespace stope
