// LAS files and the same compressed (LAZ), byte by byte.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/model/formats/las_bytes.h"
#include "tests/model/formats/laz/part_encoders.h"

namespace remount::formats::laz {

struct Point {
  std::array<std::int32_t, 3> xyz{};  ///< millimetres
  std::uint16_t intensity = 0;
  double time = 0.0;
  unsigned number = 1, count = 1;  ///< of the return, and of all of its pulse
  unsigned channel = 0;            ///< of the scanner, in formats 6 to 10
  std::uint8_t user = 0, extra = 0;
  std::uint16_t source = 0;
  std::array<std::uint16_t, 3> colour{};
};

struct Options {
  int format = 1;
  std::size_t extra_bytes = 0;
  std::vector<std::size_t> chunks{50'000};  ///< points of each; a single number is that of all
  bool table_place_at_end = false;          ///< as of programs that write in one go
  bool chunked = true;                      ///< else all points are one stream without a table
};

inline bool layered(const Options& options) { return options.format >= 6; }
inline bool has_time(int format) { return format != 0 && format != 2; }
inline bool has_colour(int format) {
  return format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10;
}
inline bool has_wave(int format) { return format == 4 || format == 5 || format >= 9; }

/// A point as it stands in a file that is not compressed.
inline std::string raw_point(const Point& point, const Options& options) {
  std::string bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) put(bytes, 4 * axis, point.xyz[axis]);
  put(bytes, 12, point.intensity);
  if (layered(options)) {
    put(bytes, 14, static_cast<std::uint8_t>(point.number | point.count << 4));
    put(bytes, 15, static_cast<std::uint8_t>(point.channel << 4));
    put(bytes, 16, std::uint8_t{0}), put(bytes, 17, point.user), put(bytes, 18, std::uint16_t{0});
    put(bytes, 20, point.source), put(bytes, 22, point.time);
  } else {
    put(bytes, 14, static_cast<std::uint8_t>(point.number | point.count << 3));
    put(bytes, 15, std::uint16_t{0}), put(bytes, 17, point.user), put(bytes, 18, point.source);
    if (has_time(options.format)) put(bytes, 20, point.time);
  }
  if (has_colour(options.format))
    for (const std::uint16_t part : point.colour) put(bytes, bytes.size(), part);
  if (options.format == 8 || options.format == 10) put(bytes, bytes.size(), std::uint16_t{0});
  if (has_wave(options.format)) bytes += std::string(29, '\0');
  return bytes + std::string(options.extra_bytes, static_cast<char>(point.extra));
}

/// Items of a point: number, bytes, version of the compression.
inline std::vector<std::array<std::uint16_t, 3>> items_of(const Options& options) {
  std::vector<std::array<std::uint16_t, 3>> items;
  const auto extra = static_cast<std::uint16_t>(options.extra_bytes);
  if (layered(options)) {
    items.push_back({10, 30, 3});
    if (options.format == 7) items.push_back({11, 6, 3});
    if (options.format == 8 || options.format == 10) items.push_back({12, 8, 3});
    if (options.format >= 9) items.push_back({13, 29, 3});
    if (extra > 0) items.push_back({14, extra, 3});
    return items;
  }
  items.push_back({6, 20, 2});
  if (has_time(options.format)) items.push_back({7, 8, 2});
  if (has_colour(options.format)) items.push_back({8, 6, 2});
  if (has_wave(options.format)) items.push_back({9, 29, 1});
  if (extra > 0) items.push_back({0, extra, 2});
  return items;
}

/// One stream for all parts of the points behind the first one.
class PointWiseEncoder {
 public:
  PointWiseEncoder(const Point& first, const Options& options)
      : options_(options), last_(first), coordinates_(first.xyz, 0), times_(0, first.time) {
    extras_.assign(options.extra_bytes, SymbolModel(256));
  }

  void add(const Point& point) {
    add_flags(point);
    const unsigned kind = kind_of(point),
                   level = point.count > point.number ? point.count - point.number : point.number - point.count;
    if (point.intensity != intensity_[kind])
      intensities_.put(encoder_, intensity_[kind], point.intensity, std::min(kind, 3U));
    intensity_[kind] = point.intensity;
    if (point.user != last_.user) encoder_.symbol(model_of(users_, last_.user), point.user);
    if (point.source != last_.source) sources_.put(encoder_, last_.source, point.source);
    coordinates_.put_xy(encoder_, point.xyz, kind, point.count == 1);
    coordinates_.put_z(encoder_, point.xyz[2], level, point.count == 1);
    if (has_time(options_.format)) times_.put(encoder_, point.time);
    if (has_colour(options_.format)) add_colour(point.colour);
    if (has_wave(options_.format)) add_wave();
    for (SymbolModel& model : extras_) encoder_.symbol(model, static_cast<std::uint8_t>(point.extra - last_.extra));
    last_ = point;
  }

  std::string finish() { return encoder_.finish(); }

 private:
  using Chained = std::array<std::unique_ptr<SymbolModel>, 256>;

  static SymbolModel& model_of(Chained& models, std::size_t before) {
    if (!models[before]) models[before] = std::make_unique<SymbolModel>(256);
    return *models[before];
  }

  /// The table of kinds of returns for pulses of up to five returns, as the format has it.
  static unsigned kind_of(const Point& point) { return point.count * (point.count - 1) / 2 + point.number - 1; }

  void add_flags(const Point& point) {
    const unsigned flags = point.number | point.count << 3, before = last_.number | last_.count << 3;
    const unsigned kind = kind_of(point);
    encoder_.symbol(changed_, (flags != before ? 32U : 0U) | (point.intensity != intensity_[kind] ? 16U : 0U) |
                                  (point.user != last_.user ? 2U : 0U) | (point.source != last_.source ? 1U : 0U));
    if (flags != before) encoder_.symbol(model_of(flags_, before), flags);
  }

  void add_colour(const std::array<std::uint16_t, 3>& colour) {
    const auto& before = last_.colour;
    const bool grey = colour[0] == colour[1] && colour[0] == colour[2];
    unsigned changed = grey ? 0 : 64;
    for (std::size_t i = 0; i < (grey ? 1 : 3); ++i)
      changed |= ((colour[i] & 0xffU) != (before[i] & 0xffU) ? 1U << (2 * i) : 0U) |
                 (colour[i] >> 8 != before[i] >> 8 ? 2U << (2 * i) : 0U);
    encoder_.symbol(colour_changed_, changed);
    // What the bytes are is not read: any symbol stands for them.
    for (const unsigned part : {0U, 1U, 2U, 4U, 3U, 5U})
      if ((changed >> part & 1U) != 0) encoder_.symbol(colours_[part], (colour[0] + 31 * part) & 0xffU);
  }

  void add_wave() {
    encoder_.symbol(wave_index_, last_.user);
    const unsigned way = last_.user & 3U;
    encoder_.symbol(wave_ways_[wave_way_], way);
    wave_way_ = way;
    if (way == 2) wave_steps_.put(encoder_, 0, 77);
    if (way == 3) encoder_.number(32, 0x1234'5678U), encoder_.number(32, 0x9abc'def0U);
    wave_sizes_.put(encoder_, 0, 1000);
    wave_points_.put(encoder_, 0, -5);
    for (unsigned axis = 0; axis < 3; ++axis) wave_axes_.put(encoder_, 0, 1 << axis, axis);
  }

  const Options& options_;
  Point last_;
  EntropyEncoder encoder_;
  CoordinateEncoder coordinates_;
  TimeEncoder times_;
  SymbolModel changed_{64}, colour_changed_{128}, wave_index_{256};
  Chained flags_, users_;
  IntegerEncoder intensities_{16, 4}, sources_{16};
  std::array<std::uint16_t, 16> intensity_{};
  std::vector<SymbolModel> colours_ = std::vector<SymbolModel>(6, SymbolModel(256)), extras_,
                           wave_ways_ = std::vector<SymbolModel>(4, SymbolModel(4));
  unsigned wave_way_ = 0;
  IntegerEncoder wave_steps_{32}, wave_sizes_{32}, wave_points_{32}, wave_axes_{32, 3};
};

/// A stream for each part of the points behind the first one; parts that stay the same have none.
class LayeredEncoder {
 public:
  explicit LayeredEncoder(const Point& first) : current_(first.channel) { begin(first); }

  void add(const Point& point) {
    const Point& before = channels_[current_]->last;
    const unsigned context = (before.number == 1 ? 1U : 0U) + (before.number >= before.count ? 2U : 0U) +
                             (channels_[current_]->time_changed ? 4U : 0U);
    const bool other = point.channel != current_;
    SymbolModel& changed_model = channels_[current_]->changed[context];
    const Point& last = other && channels_[point.channel] ? channels_[point.channel]->last : before;
    const bool new_time = point.time != last.time, new_count = point.count != last.count;
    const unsigned step = (point.number + 16 - last.number) % 16, way = step == 0    ? 0
                                                                        : step == 1  ? 1
                                                                        : step == 15 ? 2
                                                                                     : 3;
    xy_.symbol(changed_model, (other ? 64U : 0U) | (new_time ? 16U : 0U) | (new_count ? 4U : 0U) | way);
    if (other) change_channel(point.channel);
    Channel& channel = *channels_[current_];
    if (new_count) xy_.symbol(model_of(channel.counts[channel.last.count]), point.count);
    if (way == 3 && new_time) xy_.symbol(model_of(channel.numbers[channel.last.number]), point.number);
    if (way == 3 && !new_time) xy_.symbol(channel.number_at_same_time, step - 2);
    add_values(channel, point, new_time);
  }

  /// Sizes and bytes of the nine layers.
  std::pair<std::string, std::string> finish() {
    std::string sizes(36, '\0'), bytes;
    const auto add = [&](std::size_t layer, EntropyEncoder& encoder, bool changed) {
      const std::string made = changed ? encoder.finish() : "";
      put(sizes, 4 * layer, static_cast<std::uint32_t>(made.size()));
      bytes += made;
    };
    add(0, xy_, true), add(1, z_, z_changed_), add(4, intensity_, intensity_changed_), add(8, time_, time_changed_);
    return {sizes, bytes};
  }

 private:
  struct Channel {
    explicit Channel(const Point& point) : last(point), coordinates(point.xyz, point.xyz[2]), times(1, point.time) {
      intensity.fill(point.intensity);
    }
    Point last;
    bool time_changed = false;
    std::vector<SymbolModel> changed = std::vector<SymbolModel>(8, SymbolModel(128));
    SymbolModel channel{3}, number_at_same_time{13};
    std::array<std::optional<SymbolModel>, 16> counts, numbers;
    CoordinateEncoder coordinates;
    IntegerEncoder intensities{16, 4};
    std::array<std::uint16_t, 8> intensity{};
    TimeEncoder times;
  };

  static SymbolModel& model_of(std::optional<SymbolModel>& model) {
    if (!model) model.emplace(16);
    return *model;
  }

  void begin(const Point& point) { channels_[current_] = std::make_unique<Channel>(point); }

  void change_channel(unsigned channel) {
    xy_.symbol(channels_[current_]->channel, (channel + 4 - current_) % 4 - 1);
    const Point last = channels_[current_]->last;
    current_ = channel;
    if (!channels_[current_]) begin(last);
  }

  void add_values(Channel& channel, const Point& point, bool new_time) {
    const unsigned at_new_time = new_time ? 1 : 0, level = point.count - point.number;
    // The table of kinds for pulses of up to three returns, as the format has it.
    constexpr unsigned kKinds[4][4] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 2, 0}, {0, 3, 4, 5}};
    const unsigned kind = kKinds[point.count][point.number];
    channel.coordinates.put_xy(xy_, point.xyz, kind << 1 | at_new_time, point.count == 1);
    channel.coordinates.put_z(z_, point.xyz[2], level, point.count == 1);
    z_changed_ = z_changed_ || point.xyz[2] != channel.last.xyz[2];
    const unsigned place = (point.number == 1 ? 2U : 0U) + (point.number >= point.count ? 1U : 0U);
    std::uint16_t& last = channel.intensity[place << 1 | at_new_time];
    channel.intensities.put(intensity_, last, point.intensity, place);
    last = point.intensity;
    intensity_changed_ = intensity_changed_ || point.intensity != channel.last.intensity;
    if (new_time) channel.times.put(time_, point.time);
    time_changed_ = time_changed_ || new_time;
    channel.last = point;
    channel.time_changed = new_time;
  }

  EntropyEncoder xy_, z_, intensity_, time_;
  bool z_changed_ = false, intensity_changed_ = false, time_changed_ = false;
  std::array<std::unique_ptr<Channel>, 4> channels_;
  unsigned current_;
};

/// Points `from` to `to`, which are one chunk.
inline std::string chunk_of(const std::vector<Point>& points, std::size_t from, std::size_t to,
                            const Options& options) {
  std::string bytes = raw_point(points[from], options);
  if (!layered(options)) {
    PointWiseEncoder encoder(points[from], options);
    for (std::size_t i = from + 1; i < to; ++i) encoder.add(points[i]);
    return bytes + encoder.finish();
  }
  LayeredEncoder encoder(points[from]);
  for (std::size_t i = from + 1; i < to; ++i) encoder.add(points[i]);
  const auto [sizes, layers] = encoder.finish();
  put(bytes, bytes.size(), static_cast<std::uint32_t>(to - from));
  const std::size_t others = options.format == 7    ? 1
                             : options.format == 8  ? 2
                             : options.format == 9  ? 1
                             : options.format == 10 ? 3
                                                    : 0;
  return bytes + sizes + std::string(4 * (others + options.extra_bytes), '\0') + layers;
}

/// Header and, of a compressed file, the record that says how it is.
inline std::string head_of(const std::vector<Point>& points, const Options& options, bool compressed) {
  LasOptions plain;
  plain.minor = 4, plain.format = options.format;
  plain.points.clear();
  std::string bytes = las(plain).substr(0, 375);
  put(bytes, 104, static_cast<std::uint8_t>(options.format | (compressed ? 0x80 : 0)));
  put(bytes, 105, static_cast<std::uint16_t>(raw_point({}, options).size()));
  put(bytes, 247, std::uint64_t{points.size()});
  if (compressed) {
    const auto items = items_of(options);
    std::string record;
    put(record, 0, static_cast<std::uint16_t>(layered(options) ? 3 : options.chunked ? 2 : 1));
    put(record, 12, options.chunks.size() > 1 ? 0xffff'ffffU : static_cast<std::uint32_t>(options.chunks.front()));
    put(record, 32, static_cast<std::uint16_t>(items.size()));
    for (const auto& item : items)
      for (const std::uint16_t number : item) put(record, record.size(), number);
    put(bytes, 100, std::uint32_t{1});
    bytes += std::string(54, '\0');
    bytes.replace(375 + 2, 14, "laszip encoded");
    put(bytes, 375 + 18, std::uint16_t{22204}), put(bytes, 375 + 20, static_cast<std::uint16_t>(record.size()));
    bytes += record;
  }
  put(bytes, 96, static_cast<std::uint32_t>(bytes.size()));
  return bytes;
}

inline std::string plain_of(const std::vector<Point>& points, const Options& options) {
  std::string bytes = head_of(points, options, false);
  for (const Point& point : points) bytes += raw_point(point, options);
  return bytes;
}

inline std::string laz_of(const std::vector<Point>& points, const Options& options) {
  std::string bytes = head_of(points, options, true);
  if (!options.chunked) return bytes + chunk_of(points, 0, points.size(), options);
  const std::size_t place = bytes.size();
  put(bytes, place, ~std::uint64_t{0});
  EntropyEncoder encoder;
  IntegerEncoder numbers(32, 2);
  std::int32_t last_points = 0, last_bytes = 0;
  std::uint32_t count = 0;
  for (std::size_t from = 0; from < points.size(); ++count) {
    const std::size_t most =
        options.chunks.size() > 1 ? options.chunks[count % options.chunks.size()] : options.chunks[0];
    const std::size_t to = std::min(points.size(), from + most);
    const std::string chunk = chunk_of(points, from, to, options);
    if (options.chunks.size() > 1) numbers.put(encoder, last_points, static_cast<std::int32_t>(to - from), 0);
    numbers.put(encoder, last_bytes, static_cast<std::int32_t>(chunk.size()), 1);
    last_points = static_cast<std::int32_t>(to - from), last_bytes = static_cast<std::int32_t>(chunk.size());
    bytes += chunk;
    from = to;
  }
  const std::uint64_t table = bytes.size();
  put(bytes, bytes.size(), std::uint32_t{0}), put(bytes, bytes.size(), count);
  bytes += encoder.finish();
  if (options.table_place_at_end)
    put(bytes, bytes.size(), table);
  else
    put(bytes, place, table);
  return bytes;
}

}  // namespace remount::formats::laz
