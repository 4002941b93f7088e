#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "framework/pipeline/plan.hpp"
#include "framework/report/sketch.hpp"
#include "stope/digest.hpp"
#include "stope/payload.hpp"

namespace stope::report {

/// Reads along at an output of a stage, for the digest in run.json and the picture in the report.
/// It holds on to no payload: of a value, and of a stream's first and last item, it keeps a sketch
/// of bounded size; of the last item so far nothing but the handle, so that it may be spilled.
class PayloadTap {
 public:
  /// `digest`: over all items. `draw`: makes the sketch, or empty.
  PayloadTap(PlannedSource source, bool stream, bool digest, SketchFunction draw);

  void take(const AnyItem& item);
  /// After the last item: draws it.
  void finish();

  const PlannedSource& source() const { return source_; }
  std::uint64_t items() const { return items_; }
  /// Of a value: the digest of its encoded form. Of a stream: of stamp, index and encoded form of
  /// every item in turn. None if not asked for or nothing came.
  std::optional<Digest> digest() const;
  /// One of a value; of a stream the first item's and, if there were several, the last one's.
  const std::vector<Sketch>& sketches() const { return sketches_; }

 private:
  void draw(const AnyItem& item);

  PlannedSource source_;
  bool stream_;
  bool digesting_;
  SketchFunction draw_;
  Digester digester_;
  std::uint64_t items_ = 0;
  AnyItem last_;
  std::vector<Sketch> sketches_;
};

}  // namespace stope::report
