#include <fmt/format.h>

#include <string>

#include "plugins/export/cloud_records.hpp"
#include "plugins/export/text_bytes.hpp"
#include "stope/stope.hpp"

namespace stope::exports {

class Pcd final : public Map<Artefact(PointCloud)> {
 public:
  struct Params {
  } params;

  static void describe(About<Pcd>& about) {
    about.summary("Writes a cloud as a binary PCD file.")
        .from("Point Cloud Library, PCD 0.7")
        .notes(
            "Map-frame coordinates; beyond 8 km from zero x, y and z are 8 bytes wide, which PCL's "
            "own point types do not hold.")
        .ports("cloud", "artefact")
        .writes({"pcd"});
  }

  Artefact apply(const PointCloud& cloud, Context&) const {
    const CloudRecords records = records_of(cloud);
    std::string names, sizes, kinds, counts;
    for (const CloudField& field : records.fields) {
      names += " " + field.name;
      sizes += fmt::format(" {}", field.bytes);
      kinds += fmt::format(" {}", field.kind);
      counts += " 1";
    }
    ArtefactFile file{
        "pcd", bytes_of(fmt::format("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
                                    "FIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\nWIDTH {}\nHEIGHT 1\n"
                                    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
                                    names, sizes, kinds, counts, cloud.points.size(),
                                    cloud.points.size()))};
    file.bytes.insert(file.bytes.end(), records.bytes.begin(), records.bytes.end());
    return {{std::move(file)}};
  }
};

STOPE_STAGE(Pcd, "export/pcd")

}  // namespace stope::exports
