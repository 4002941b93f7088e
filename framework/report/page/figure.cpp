#include "framework/report/page/figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include "framework/report/draw/base64.hpp"
#include "framework/report/draw/png.hpp"
#include "framework/report/page/html.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

// Every figure is drawn 1000 units wide, so that marks have the same size in all of them.
constexpr double kWidth = 1000;
constexpr std::size_t kManyMarks = 250, kVeryMany = 1000;

// Two figures that are not much wider than high share a row.
constexpr double kNearlySquare = 1.25;

bool is_finite(const Vector2& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

// What the figure shows of the plane: the ground's area, or all strokes and a margin.
std::optional<GridFrame> frame_of(const FigureParts& parts) {
  const Sketch* below = parts.sketch->raster ? parts.sketch : parts.ground;
  if (below && below->raster) return below->raster->frame;
  Vector2 low(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  Vector2 high = -low;
  const auto include = [&](const Vector2& point) {
    if (!is_finite(point)) return;
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  };
  for (const Sketch* sketch : {parts.sketch, parts.roads}) {
    if (!sketch) continue;
    for (const Stroke& stroke : sketch->strokes) {
      for (const Vector2& point : stroke.points) include(point);
    }
    for (const Mark& mark : sketch->marks) include(mark.place);
  }
  if (!(low.x() <= high.x())) return std::nullopt;
  const Vector2 size = high - low;
  // Neither side so short that the picture becomes a thread.
  const double longest = std::max(size.maxCoeff(), 1.0);
  const double margin = 0.06 * longest;
  const double width = std::max(size.x() + 2 * margin, 0.3 * longest);
  const double height = std::max(size.y() + 2 * margin, 0.3 * longest);
  GridFrame frame;
  frame.width = 1'000'000;
  frame.resolution = width / frame.width;
  frame.height = static_cast<std::int32_t>(std::lround(height / frame.resolution));
  const Vector2 middle = (low + high) / 2;
  frame.origin = {middle.x() - width / 2, middle.y() - height / 2, 0};
  return frame;
}

class Drawing {
 public:
  Drawing(const GridFrame& frame, bool wide)
      : frame_(frame), wide_(wide), units_(kWidth / frame.width), height_(units_ * frame.height) {}

  void raster(const Raster& raster) {
    const Picture& picture = raster.picture;
    // Single cells are shown as what they are; what was shrunk may be smoothed again.
    const bool cells = picture.width == raster.frame.width;
    svg_ += fmt::format(
        "<image class=\"{}{}\" width=\"{:.0f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\" "
        "href=\"data:image/png;base64,{}\"/>\n",
        raster.neutral ? "neutral" : "tinted", cells ? " cells" : "", kWidth, height_,
        base64(raster.png.empty() ? encode_png(picture) : raster.png));
  }

  void strokes(const Sketch& sketch, bool casing) {
    for (const Stroke& stroke : sketch.strokes) {
      const std::string d = path(stroke);
      if (d.empty()) continue;
      if (casing) svg_ += fmt::format("<path class=\"casing\" d=\"{}\"/>\n", d);
      svg_ += fmt::format("<path class=\"{}\" d=\"{}\"", escaped(stroke.style), d);
      svg_ += stroke.title.empty()
                  ? std::string("/>\n")
                  : fmt::format("><title>{}</title></path>\n", escaped(stroke.title));
    }
  }

  void marks(const Sketch& sketch) {
    // A small figure is shown at half the size.
    const double scale = wide_ && ratio() >= kNearlySquare ? 1.0 : 1.6;
    const bool many = sketch.marks.size() > kManyMarks, very_many = sketch.marks.size() > kVeryMany;
    const double radius = (very_many ? 1.7 : (many ? 2.8 : 4.2)) * scale;
    if (many) svg_ += "<g class=\"many\">\n";
    for (const Mark& mark : sketch.marks) {
      if (!is_finite(mark.place)) continue;
      const Vector2 place = units(mark.place);
      const bool end = mark.style == "start" || mark.style == "goal";
      svg_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"",
                          escaped(mark.style), place.x(), place.y(), end ? 7 * scale : radius);
      svg_ += mark.title.empty()
                  ? std::string("/>\n")
                  : fmt::format("><title>{}</title></circle>\n", escaped(mark.title));
    }
    if (many) svg_ += "</g>\n";
  }

  void faint(const Sketch& sketch) {
    svg_ += "<g class=\"faint\">\n";
    strokes(sketch, false);
    svg_ += "</g>\n";
  }

  std::string svg(const std::string& label) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.2f}\" "
        "role=\"img\" aria-label=\"{}\">\n{}</svg>",
        kWidth, height_, escaped(label), svg_);
  }
  double ratio() const { return kWidth / height_; }

 private:
  Vector2 units(const Vector2& point) const {
    const Vector2 cell = frame_.to_grid(point.x(), point.y());
    return {cell.x() * units_, height_ - cell.y() * units_};
  }
  std::string path(const Stroke& stroke) const {
    std::string d;
    for (const Vector2& point : stroke.points) {
      if (!is_finite(point)) continue;
      const Vector2 place = units(point);
      fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? 'M' : 'L', place.x(),
                     place.y());
    }
    if (stroke.closed && !d.empty()) d += 'Z';
    return d;
  }

  const GridFrame& frame_;
  bool wide_;
  double units_;  ///< per cell
  double height_;
  std::string svg_;
};

std::string legend_html(const std::vector<LegendEntry>& legend) {
  if (legend.empty()) return {};
  std::string html = "<span class=\"legend\">";
  for (const LegendEntry& entry : legend) {
    html += "<span>";
    if (!entry.colour.empty()) {
      html += fmt::format("<i style=\"background:{}\"></i>", escaped(entry.colour));
    } else if (entry.style == "road" || entry.style == "road closed" || entry.style == "path" ||
               entry.style == "track") {
      html += fmt::format(
          "<svg class=\"key\" viewBox=\"0 0 22 10\"><path class=\"{}\" "
          "d=\"M1 5H21\"/></svg>",
          escaped(entry.style));
    } else {
      html += fmt::format(
          "<svg class=\"key dot\" viewBox=\"0 0 10 10\"><circle class=\"{}\" "
          "cx=\"5\" cy=\"5\" r=\"3.6\"/></svg>",
          escaped(entry.style));
    }
    html += escaped(entry.text) + "</span>";
  }
  return html + "</span>";
}

std::string caption_html(const FigureParts& parts) {
  std::string html =
      fmt::format("<figcaption><b>{}</b> <span class=\"kind\">{}</span> {}", escaped(parts.name),
                  escaped(parts.sketch->kind), escaped(parts.sketch->caption));
  if (!parts.remark.empty())
    html += fmt::format(" <span class=\"remark\">{}</span>", escaped(parts.remark));
  return html + legend_html(parts.sketch->legend) + "</figcaption>";
}

std::string scale_html(const GridFrame& frame) {
  const double width = frame.width * frame.resolution;
  const double length = scale_bar_length(width);
  return fmt::format("<div class=\"scale\" style=\"width:{:.3f}%\"><span>{}</span></div>",
                     100 * length / width, length_text(length));
}

std::string north_html(const GridFrame& frame) {
  return fmt::format(
      "<div class=\"north\" title=\"north\"><span style=\"transform:rotate("
      "{:.1f}deg)\">↑</span>N</div>",
      frame.origin.yaw * 180 / std::numbers::pi);
}

}  // namespace

double scale_bar_length(double width) {
  const double most = width / 4;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) return step * power;
  }
  return power;
}

std::string figure_html(const FigureParts& parts) {
  const auto frame = frame_of(parts);
  if (!frame) return {};
  Drawing drawing(*frame, parts.wide);
  const Sketch* below = parts.sketch->raster ? parts.sketch : parts.ground;
  const bool has_ground = below && below->raster;
  if (has_ground) drawing.raster(*below->raster);
  if (parts.roads) drawing.faint(*parts.roads);
  drawing.strokes(*parts.sketch, parts.sketch->kind == "Path");
  drawing.marks(*parts.sketch);
  const char* size = !parts.wide ? "" : (drawing.ratio() < kNearlySquare ? " wide half" : " wide");
  return fmt::format(
      "<figure class=\"map{}\"><div class=\"frame{}\" style=\"--ratio:{:.4f}\">{}{}{}</div>{}"
      "</figure>\n",
      size, parts.sketch->points ? " points" : "", drawing.ratio(),
      drawing.svg(fmt::format("{}: {}", parts.name, parts.sketch->kind)), scale_html(*frame),
      parts.sketch->in_map ? north_html(*frame) : "", caption_html(parts));
}

}  // namespace stope::report
