#include <gtest/gtest.h>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {
namespace {

TEST(Diagnostics, ReadAsEditorsUnderstandThem) {
  const Place place{"pit.yaml", 3, 14};
  EXPECT_EQ(
      to_text({Severity::kError, "P050", place, "No plugin offers 'x'.", "Did you mean 'y'?"}),
      "pit.yaml:3:14: error[P050]: No plugin offers 'x'. Did you mean 'y'?");
  EXPECT_EQ(to_text({Severity::kWarning, "P090", {"pit.yaml", 0, 0}, "Nothing.", ""}),
            "pit.yaml: warning[P090]: Nothing.");
  EXPECT_EQ(to_text({Severity::kNote, "P091", {"--set", 2, 0}, "So it is.", ""}),
            "--set:2: note[P091]: So it is.");
}

TEST(Diagnostics, AreOrderedByPlaceWithoutRepetitions) {
  Diagnostics diagnostics;
  diagnostics.warning("P002", {"b.yaml", 1, 1}, "w");
  diagnostics.error("P001", {"a.yaml", 10, 1}, "late");
  diagnostics.error("P001", {"a.yaml", 9, 1}, "early");
  diagnostics.error("P001", {"a.yaml", 10, 1}, "late");
  const auto sorted = diagnostics.sorted();
  ASSERT_EQ(sorted.size(), 3U);
  EXPECT_EQ(sorted[0].sentence, "early");
  EXPECT_EQ(sorted[1].sentence, "late");
  EXPECT_EQ(sorted[2].place.file, "b.yaml");
}

TEST(Diagnostics, WarningsAreNoErrors) {
  Diagnostics diagnostics;
  diagnostics.warning("P090", {}, "w");
  diagnostics.note("P091", {}, "n");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.error("P001", {}, "e");
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace stope
