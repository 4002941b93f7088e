// How long the static check of a pipeline of 50 stages takes, beside yaml-cpp only loading the same
// text. The goal is less than 100 ms for the check.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "framework/pipeline/check.hpp"
#include "tests/framework/pipeline/fake_catalogue.hpp"

namespace {

std::string fifty_stages() {
  std::string stages = "  pit: {use: source/synthetic_pit, params: {extent: \"${extent}\"}}\n";
  std::string outputs;
  for (int i = 0; i < 12; ++i) {
    const std::string n = std::to_string(i);
    stages += "  cloud" + n + ": {use: map/point_cloud, in: {scans: pit, trajectory: pit}, " +
              "params: {voxel: 20 cm}}\n";
    stages += "  grid" + n + ": {use: rasterizer/drivable, in: cloud" + n +
              ", params: {resolution: 0.5 m, slope: 12 deg}}\n";
    stages +=
        "  roads" + n + ": {use: topology/voronoi, in: grid" + n +
        ", params: {min_clearance: \"${width}\", topology/watershed: {min_clearance: 3 m}}}\n";
    stages += "  plan" + n + ": {use: planner/a_star, in: {roads: roads" + n + ", grid: grid" + n +
              "}, params: {start: [0, 0], goal: [42 m, 9 m]}}\n";
    outputs += "  " + n + "/roads.geojson: roads" + n + "\n";
    outputs += "  " + n + "/plan.geojson: plan" + n + "\n";
    outputs += "  " + n + "/map.png: {use: export/png, in: {grid: grid" + n + ", roads: roads" + n +
               "}}\n";
  }
  stages += "  spare: {use: prior/trajectory_dilation, in: pit.trajectory, params: {width: 8 m}}\n";
  return "stope: 1\nvars: {extent: 400 m, width: 3 m}\nstages:\n" + stages + "outputs:\n" +
         outputs + "  spare.png: spare\n";
}

void measure(const char* what, const std::function<void()>& work) {
  std::vector<double> milliseconds;
  for (int i = 0; i < 101; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(took.count());
  }
  std::printf("%-40s first %.2f ms", what, milliseconds.front());
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf(", median %.2f ms, worst of 101 %.2f ms\n", milliseconds[milliseconds.size() / 2],
              milliseconds.back());
}

}  // namespace

int main() {
  const stope::FakeCatalogue catalogue;
  const std::string text = fifty_stages();
  {
    stope::Diagnostics diagnostics;
    const auto plan = stope::check_pipeline_text(text, "fifty.yaml", {}, catalogue, diagnostics);
    for (const auto& problem : diagnostics.sorted()) std::printf("%s\n", to_text(problem).c_str());
    if (!plan) return 1;
    std::printf("%zu stages, %zu outputs, %zu bytes\n", plan->stages.size() - plan->outputs.size(),
                plan->outputs.size(), text.size());
  }
  measure("stope: static check", [&] {
    stope::Diagnostics diagnostics;
    check_pipeline_text(text, "fifty.yaml", {}, catalogue, diagnostics);
  });
  measure("yaml-cpp: YAML::Load alone", [&] { YAML::Load(text); });
}
