#include "framework/plugins/elf_file.hpp"

#include <elf.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "framework/plugins/plugin_file.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

class ElfFileTest : public ::testing::Test {
 protected:
  ElfFileTest() {
    std::ifstream stream(GOOD_PLUGIN, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
  }
  ElfNotes read() {
    const auto file = context_.temporary_folder() / "plugin.so";
    std::ofstream(file, std::ios::binary)
        .write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    return read_elf(OpenFile(file));
  }
  Elf64_Ehdr header() const {
    Elf64_Ehdr header{};
    std::memcpy(&header, bytes_.data(), sizeof(header));
    return header;
  }
  void set_header(const Elf64_Ehdr& header) { std::memcpy(bytes_.data(), &header, sizeof(header)); }

  testing::MemoryContext context_;
  std::vector<char> bytes_;
};

TEST_F(ElfFileTest, ReadsTheNotes) {
  const ElfNotes notes = read();
  ASSERT_TRUE(notes.stope);
  EXPECT_TRUE(notes.complete);
  EXPECT_EQ(notes.stope->epoch, kAbiEpoch);
  EXPECT_STREQ(notes.stope->plugin_id, "good");
  EXPECT_EQ(notes.build_id.size(), 40U);
}

TEST_F(ElfFileTest, SegmentsSufficeWhereThereAreNoSections) {
  Elf64_Ehdr changed = header();
  changed.e_shoff = 0;
  changed.e_shnum = 0;
  changed.e_shstrndx = 0;
  set_header(changed);
  EXPECT_TRUE(read().stope);
}

TEST_F(ElfFileTest, SectionsSufficeWhereNoSegmentHoldsNotes) {
  const Elf64_Ehdr head = header();
  for (std::size_t i = 0; i < head.e_phnum; ++i) {
    Elf64_Phdr segment{};
    char* place = bytes_.data() + head.e_phoff + i * sizeof(segment);
    std::memcpy(&segment, place, sizeof(segment));
    if (segment.p_type == PT_NOTE) segment.p_type = PT_NULL;
    std::memcpy(place, &segment, sizeof(segment));
  }
  EXPECT_TRUE(read().stope);
}

TEST_F(ElfFileTest, AnyByteOfTheHeadersChangedDoesNoHarm) {
  read();
  const auto file = context_.temporary_folder() / "plugin.so";
  std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
  const auto set = [&stream](std::size_t place, char value) {
    stream.seekp(static_cast<std::streamoff>(place));
    stream.put(value).flush();
  };
  for (std::size_t place = 0; place < 1024; ++place) {
    for (const int value : {0x00, 0x7f, 0xff}) {
      set(place, static_cast<char>(value));
      try {
        read_elf(OpenFile(file));
      } catch (const PluginRefused& refused) {
        EXPECT_STRNE(refused.what(), "");
      }
    }
    set(place, bytes_[place]);
  }
}

}  // namespace
}  // namespace stope
