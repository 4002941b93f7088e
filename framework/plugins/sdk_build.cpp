#include "framework/plugins/sdk_build.hpp"

#include <link.h>

#include <filesystem>

#include "framework/plugins/elf_notes.hpp"
#include "framework/plugins/open_file.hpp"
#include "framework/plugins/plugin_file.hpp"

namespace stope {
namespace {

struct SdkLibrary {
  std::filesystem::path file;
  ElfNotes notes;
};

int look_at(dl_phdr_info* object, std::size_t, void* data) {
  if (!std::filesystem::path(object->dlpi_name).filename().string().starts_with("libstope.so"))
    return 0;
  SdkLibrary& library = *static_cast<SdkLibrary*>(data);
  library.file = object->dlpi_name;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const auto& part = object->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const char* begin = reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr);
    take_notes({begin, begin + part.p_memsz}, part.p_align, library.notes);
  }
  return 1;
}

}  // namespace

std::string sdk_build_id() {
  SdkLibrary library;
  ::dl_iterate_phdr(look_at, &library);
  if (!library.notes.build_id.empty() || library.file.empty()) return library.notes.build_id;
  try {
    return OpenFile(library.file).digest();
  } catch (const PluginRefused&) {
    return {};  // removed since it was loaded
  }
}

}  // namespace stope
