#include "framework/plugins/loaded_objects.hpp"

#include <link.h>

#include <filesystem>

#include "framework/plugins/elf_notes.hpp"

namespace stope {
namespace {

/// Names in the dynamic section of an object.
void read_names(const dl_phdr_info& info, const ElfW(Phdr) & part, LoadedObject& object) {
  const auto* entries = reinterpret_cast<const ElfW(Dyn)*>(info.dlpi_addr + part.p_vaddr);
  ElfW(Addr) strings = 0;
  for (const auto* entry = entries; entry->d_tag != DT_NULL; ++entry)
    if (entry->d_tag == DT_STRTAB) strings = entry->d_un.d_ptr;
  if (strings == 0) return;
  // Where the section is read-only the linker has not made it an address.
  if (strings < info.dlpi_addr) strings += info.dlpi_addr;
  const auto text = [&](const ElfW(Dyn) & entry) {
    return reinterpret_cast<const char*>(strings + entry.d_un.d_val);
  };
  for (const auto* entry = entries; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_SONAME) object.name = text(*entry);
    if (entry->d_tag == DT_NEEDED) object.needed.emplace_back(text(*entry));
  }
}

int look_at(dl_phdr_info* info, std::size_t, void* data) {
  LoadedObject object;
  object.file = info->dlpi_name;
  // Neither the program, which has no name here, nor what the kernel maps has a file.
  if (object.file.find('/') == std::string::npos) return 0;
  object.name = std::filesystem::path(object.file).filename().string();
  ElfNotes notes;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const auto& part = info->dlpi_phdr[i];
    if (part.p_type == PT_DYNAMIC) read_names(*info, part, object);
    if (part.p_type != PT_NOTE) continue;
    const char* begin = reinterpret_cast<const char*>(info->dlpi_addr + part.p_vaddr);
    take_notes({begin, begin + part.p_memsz}, part.p_align, notes);
  }
  object.build_id = notes.build_id;
  static_cast<std::vector<LoadedObject>*>(data)->push_back(std::move(object));
  return 0;
}

}  // namespace

std::vector<LoadedObject> loaded_objects() {
  std::vector<LoadedObject> objects;
  ::dl_iterate_phdr(look_at, &objects);
  return objects;
}

}  // namespace stope
