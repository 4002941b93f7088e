#include "framework/pipeline/members.hpp"

#include <gtest/gtest.h>

#include "fake_catalogue.hpp"

namespace stope {
namespace {

using Ids = std::vector<std::string>;

TEST(Members, ShareFamilyRequiredInputsAndOutputs) {
  const FakeCatalogue catalogue;
  EXPECT_EQ(interchangeable_members(catalogue, "topology/watershed"),
            (Ids{"topology/voronoi", "topology/watershed"}));
  // It needs seeds as well.
  EXPECT_EQ(interchangeable_members(catalogue, "topology/region_growing"),
            (Ids{"topology/region_growing"}));
}

TEST(Members, MayDifferInOptionalInputs) {
  const FakeCatalogue catalogue;
  EXPECT_EQ(interchangeable_members(catalogue, "planner/direct"),
            (Ids{"planner/a_star", "planner/direct"}));
}

TEST(Members, OfNothingAreNone) {
  EXPECT_TRUE(interchangeable_members(FakeCatalogue(), "topology/unheard_of").empty());
}

}  // namespace
}  // namespace stope
