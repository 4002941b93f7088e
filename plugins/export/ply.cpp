#include <fmt/format.h>

#include <string>

#include "plugins/export/cloud_records.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {

class Ply final : public Map<Artefact(PointCloud)> {
 public:
  struct Params {
  } params;

  static void describe(About<Ply>& about) {
    about.summary("Writes a cloud as a binary PLY file.")
        .from("Stanford polygon format 1.0, little endian")
        .notes("Map-frame coordinates; beyond 8 km from zero x, y and z are doubles.")
        .ports("cloud", "artefact")
        .writes({"ply"});
  }

  Artefact apply(const PointCloud& cloud, Context&) const {
    const CloudRecords records = records_of(cloud);
    std::string header = fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n",
                                     cloud.points.size());
    for (const CloudField& field : records.fields) {
      const char* type = field.kind == 'U' ? "uchar" : (field.bytes == 8 ? "double" : "float");
      header += fmt::format("property {} {}\n", type, field.name);
    }
    ArtefactFile file{"ply", bytes_of(header + "end_header\n")};
    file.bytes.insert(file.bytes.end(), records.bytes.begin(), records.bytes.end());
    return {{std::move(file)}};
  }
};

STOPE_STAGE(Ply, "export/ply")

}  // namespace stope::exports
