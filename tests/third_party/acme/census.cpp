#include <stope/stope.hpp>

#include "sector.hpp"

namespace acme {

class Census final : public stope::Stage {
 public:
  struct Params {
  } params;
  stope::In<Sector> sectors;
  stope::OutValue<stope::Measures> measures;

  static void describe(stope::About<Census>& about) {
    about.summary("Counts the cells of all sectors.")
        .input("sectors", &Census::sectors, "What to count.")
        .output("measures", &Census::measures, "The number of sectors and of their cells.");
  }

  void run(stope::Context&) override {
    double count = 0, cells = 0;
    while (auto sector = sectors.next()) {
      ++count;
      cells += static_cast<double>(sector->cells);
    }
    if (count == 0) throw stope::Error("there is no sector to count: raise 'count' of the source");
    measures.set({{"sectors", "cells"}, {count, cells}, {"", ""}, {"", ""}});
  }
};
STOPE_STAGE(Census, "acme/census")

}  // namespace acme
