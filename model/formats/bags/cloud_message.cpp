#include "model/formats/bags/cloud_message.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/index.h"
#include "messages/bags.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/clouds/cloud_fields.h"
#include "model/formats/files/input_file.h"

namespace remount::bags {
namespace {

constexpr std::size_t kMaxFields = 512;

[[noreturn]] void fail(const MessageReader& reader, Message what) {
  throw Error(ErrorCode::Format, reader.where(), std::move(what));
}

/// sensor_msgs/PointField's numbers of types.
formats::ScalarType scalar_type(unsigned datatype, const MessageReader& reader) {
  constexpr formats::ScalarType kTypes[] = {
      formats::ScalarType::I8,  formats::ScalarType::U8,  formats::ScalarType::I16, formats::ScalarType::U16,
      formats::ScalarType::I32, formats::ScalarType::U32, formats::ScalarType::F32, formats::ScalarType::F64};
  if (datatype < 1 || datatype > std::size(kTypes)) fail(reader, say::bag_cloud_field_type(datatype));
  return kTypes[datatype - 1];
}

/// sensor_msgs/PointCloud2 up to its points.
struct Layout {
  MessageHeader header;
  std::uint64_t height = 0, width = 0, point_bytes = 0, row_bytes = 0;
  std::vector<formats::CloudField> fields;
  bool big_endian = false;
};

Layout read_layout(MessageReader& reader) {
  Layout layout;
  layout.header = read_header(reader);
  layout.height = reader.number<std::uint32_t>();
  layout.width = reader.number<std::uint32_t>();
  constexpr std::size_t kLeastBytes = 13;
  const std::size_t fields = reader.sequence(kLeastBytes);
  if (fields > kMaxFields) fail(reader, say::bag_cloud_fields(fields, kMaxFields));
  for (std::size_t i = 0; i < fields; ++i) {
    formats::CloudField field;
    field.name = formats::lower_case(reader.string());
    field.offset = reader.number<std::uint32_t>();
    field.type = scalar_type(reader.number<std::uint8_t>(), reader);
    field.count = std::max<std::uint32_t>(1, reader.number<std::uint32_t>());  // some drivers write 0 for one value
    layout.fields.push_back(std::move(field));
  }
  layout.big_endian = reader.number<std::uint8_t>() != 0;
  layout.point_bytes = reader.number<std::uint32_t>();
  layout.row_bytes = reader.number<std::uint32_t>();
  return layout;
}

/// Throws where columns that are used lie outside the point or on each other: no driver writes that, and the cloud
/// would take many times the memory of its message.
void check_columns(const Layout& layout, const formats::CloudColumns& columns, const MessageReader& reader) {
  formats::refuse_narrow_coordinates(layout.fields, columns, reader.where());
  std::vector<const formats::CloudField*> used;
  for (const int column : {columns.x, columns.y, columns.z, columns.intensity, columns.ring, columns.time})
    if (column >= 0) used.push_back(&layout.fields[index_at(column)]);
  std::sort(used.begin(), used.end(),
            [](const formats::CloudField* a, const formats::CloudField* b) { return a->offset < b->offset; });
  for (std::size_t i = 0; i < used.size(); ++i) {
    const formats::CloudField& field = *used[i];
    if (field.offset + formats::size_of(field.type) > layout.point_bytes)
      fail(reader, say::bag_cloud_field_outside(field.name, field.offset, Bytes{layout.point_bytes}));
    if (i > 0 && used[i - 1]->offset + formats::size_of(used[i - 1]->type) > field.offset)
      fail(reader, say::bag_cloud_fields_overlap(used[i - 1]->name, field.name));
  }
}

/// Throws where the rows lie outside the data.
void check_rows(Layout& layout, std::size_t data_bytes, const MessageReader& reader) {
  // 32 bits times 32 bits fit 64; a single row's length is written wrong by some drivers and not needed.
  const std::uint64_t row = layout.width * layout.point_bytes;
  if (layout.height <= 1) layout.row_bytes = row;
  if (layout.row_bytes < row) fail(reader, say::bag_cloud_row(Bytes{layout.row_bytes}, row, layout.width));
  const bool empty = layout.height == 0 || row == 0;
  if (!empty && (data_bytes < row || (layout.height - 1) > (data_bytes - row) / layout.row_bytes))
    fail(reader, say::bag_cloud_rows(layout.height, Bytes{row}, Bytes{data_bytes}));
  if (empty) layout.height = 0;
}

formats::CloudBuilder read_points(MessageReader& reader, Layout& layout) {
  const formats::CloudColumns columns = formats::find_cloud_columns(layout.fields, reader.where());
  const std::string_view data = reader.byte_sequence();
  check_columns(layout, columns, reader);
  check_rows(layout, data.size(), reader);
  const auto type_of = [&](int column) { return layout.fields[index_at(column)].type; };
  formats::CloudBuilder builder(columns, formats::time_column(layout.fields, columns), layout.height * layout.width);
  const bool swap = layout.big_endian != (std::endian::native == std::endian::big);
  for (std::uint64_t row = 0; row < layout.height; ++row)
    for (std::uint64_t i = 0; i < layout.width; ++i) {
      const char* point = data.data() + row * layout.row_bytes + i * layout.point_bytes;
      const auto value = [&](int column) {
        return formats::read_scalar(point + layout.fields[index_at(column)].offset, type_of(column), swap);
      };
      formats::RawPoint raw{value(columns.x), value(columns.y), value(columns.z)};
      if (columns.intensity >= 0) raw.intensity = value(columns.intensity);
      if (columns.ring >= 0) raw.ring = value(columns.ring);
      if (columns.time >= 0) raw.time = value(columns.time);
      builder.add(raw);
    }
  return builder;
}

struct LivoxHead {
  MessageHeader header;
  std::size_t points = 0;
};

LivoxHead read_livox_head(MessageReader& reader) {
  LivoxHead head;
  head.header = read_header(reader);
  reader.number<std::uint64_t>();  // time of the first point, which the header's stamp is as well
  head.points = reader.number<std::uint32_t>();
  reader.skip(4);  // number of the sensor, reserved
  return head;
}

formats::CloudBuilder read_livox(MessageReader& reader) {
  read_livox_head(reader);
  constexpr std::size_t kLeastBytes = 19;
  const std::size_t points = reader.sequence(kLeastBytes);
  formats::CloudColumns columns;
  columns.x = columns.y = columns.z = columns.intensity = columns.ring = columns.time = 0;
  formats::CloudBuilder builder(columns, {formats::ScalarType::U32, 1e-9}, points);
  for (std::size_t i = 0; i < points; ++i) {
    formats::RawPoint raw;
    raw.time = reader.number<std::uint32_t>();
    raw.x = reader.number<float>();
    raw.y = reader.number<float>();
    raw.z = reader.number<float>();
    raw.intensity = reader.number<std::uint8_t>();
    reader.number<std::uint8_t>();  // tag
    raw.ring = reader.number<std::uint8_t>();
    builder.add(raw);
  }
  return builder;
}

}  // namespace

formats::ReadCloud read_cloud(MessageReader& reader, MessageKind kind, std::int64_t stamp_ns,
                              formats::PointTimes times) {
  if (kind == MessageKind::ApolloCloud) return read_apollo_cloud(reader, stamp_ns, times);
  if (kind == MessageKind::LivoxCustom) {
    formats::ReadCloud read = read_livox(reader).finish(stamp_ns, reader.where(), times);
    read.columns = "offset_time x y z reflectivity tag line";
    return read;
  }
  Layout layout = read_layout(reader);
  formats::ReadCloud read = read_points(reader, layout).finish(stamp_ns, reader.where(), times);
  read.columns = formats::column_names(layout.fields);
  return read;
}

CloudOutline read_cloud_outline(MessageReader& reader, MessageKind kind) {
  CloudOutline outline;
  if (kind == MessageKind::LivoxCustom) {
    const LivoxHead head = read_livox_head(reader);
    outline.header = head.header;
    outline.points = head.points;
    outline.timed = outline.ringed = true;
    return outline;
  }
  const Layout layout = read_layout(reader);
  const formats::CloudColumns columns = formats::find_cloud_columns(layout.fields, reader.where());
  outline.header = layout.header;
  outline.points = layout.height * layout.width;
  outline.timed = columns.time >= 0;
  outline.ringed = columns.ring >= 0;
  return outline;
}

}  // namespace remount::bags
