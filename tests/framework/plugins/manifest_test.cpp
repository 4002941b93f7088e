#include "framework/plugins/manifest.hpp"

#include <gtest/gtest.h>

#include "tests/framework/plugins/stage_info_samples.hpp"

namespace stope {
namespace {

void expect_equal(const PortInfo& a, const PortInfo& b) {
  EXPECT_EQ(std::tie(a.name, a.type, a.layout, a.stream, a.required, a.doc),
            std::tie(b.name, b.type, b.layout, b.stream, b.required, b.doc));
}

void expect_equal(const ParameterInfo& a, const ParameterInfo& b) {
  EXPECT_EQ(std::tie(a.name, a.kind, a.optional, a.default_value, a.unit, a.doc),
            std::tie(b.name, b.kind, b.optional, b.default_value, b.unit, b.doc));
  const Limits &p = a.limits, &q = b.limits;
  EXPECT_EQ(std::tie(p.least, p.most, p.least_excluded, p.most_excluded, p.choices, p.count_least,
                     p.count_most, p.path, p.required),
            std::tie(q.least, q.most, q.least_excluded, q.most_excluded, q.choices, q.count_least,
                     q.count_most, q.path, q.required));
}

TEST(Manifest, ComesBackWhole) {
  const Manifest before = full_manifest();
  ByteBuffer buffer;
  encode_manifest(before, buffer);
  ByteReader reader(buffer.bytes());
  const Manifest after = decode_manifest(reader);
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_EQ(after.plugin_id, "acme");
  EXPECT_EQ(after.plugin_version, "4.5.6");
  EXPECT_EQ(after.libraries, before.libraries);
  ASSERT_EQ(after.stages.size(), 2U);
  const StageInfo &a = before.stages[1], &b = after.stages[1];
  EXPECT_EQ(std::tie(a.id, a.summary, a.source, a.notes, a.map, a.deterministic, a.live,
                     a.also_reads, a.extensions),
            std::tie(b.id, b.summary, b.source, b.notes, b.map, b.deterministic, b.live,
                     b.also_reads, b.extensions));
  ASSERT_EQ(b.inputs.size(), 1U);
  ASSERT_EQ(b.outputs.size(), 1U);
  expect_equal(a.inputs[0], b.inputs[0]);
  expect_equal(a.outputs[0], b.outputs[0]);
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    expect_equal(a.parameters[i], b.parameters[i]);
  }
}

TEST(Manifest, CutAnywhereIsAnErrorAndNothingWorse) {
  ByteBuffer buffer;
  encode_manifest(full_manifest(), buffer);
  for (std::size_t size = 0; size < buffer.bytes().size(); ++size) {
    ByteReader reader(std::span(buffer.bytes()).first(size));
    EXPECT_THROW(decode_manifest(reader), Error) << size;
  }
}

TEST(Manifest, AnyByteChangedDoesNoHarm) {
  ByteBuffer buffer;
  encode_manifest(full_manifest(), buffer);
  for (std::size_t place = 0; place < buffer.bytes().size(); ++place) {
    std::vector<std::byte> bytes = buffer.bytes();
    bytes[place] = std::byte{0xff};
    ByteReader reader(bytes);
    try {
      decode_manifest(reader);
    } catch (const Error&) {  // as good as a manifest
    }
  }
}

}  // namespace
}  // namespace stope
