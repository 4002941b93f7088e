#include "framework/report/payload_tap.hpp"

#include <utility>

#include "framework/report/draw/png.hpp"

namespace stope::report {

PayloadTap::PayloadTap(PlannedSource source, bool stream, bool digest, SketchFunction draw)
    : source_(source), stream_(stream), digesting_(digest), draw_(std::move(draw)) {}

void PayloadTap::take(const AnyItem& item) {
  ++items_;
  if (digesting_) {
    const std::shared_ptr<const void> value = item.payload->pin();
    if (stream_) {
      encode(item.stamp, digester_);
      encode(item.index, digester_);
    }
    item.payload->type().encode(value.get(), digester_);
  }
  if (!draw_) return;
  if (items_ == 1) {
    draw(item);
  } else {
    last_ = item;
  }
}

void PayloadTap::finish() {
  if (last_) draw(last_);
  last_ = {};
}

void PayloadTap::draw(const AnyItem& item) {
  Sketch sketch = draw_(item.payload->pin().get());
  sketch.index = item.index;
  sketch.stamp = item.stamp;
  if (sketch.raster) {
    sketch.raster->png = encode_png(sketch.raster->picture);
    sketch.raster->picture.pixels = {};
  }
  sketches_.push_back(std::move(sketch));
}

std::optional<Digest> PayloadTap::digest() const {
  if (!digesting_ || items_ == 0) return std::nullopt;
  return digester_.digest();
}

}  // namespace stope::report
