#include "model/guesses/column_names.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/formats/files/input_file.h"
#include "model/formats/files/time_unit.h"

namespace remount::guesses {
namespace {

/// Names in small letters without what is neither letter nor digit; those of other scripts as they are.
constexpr std::pair<Quantity, std::string_view> kNames[] = {
    {Quantity::Time,
     "t,time,timestamp,timestamps,datenum,stamp,ts,epoch,unixtime,unix,utctime,timeutc,utc,"
     "sensortime,headerstamp,elapsedtime,时间,时间戳,utc时间"},
    {Quantity::HostTime,
     "hosttime,systemtime,systime,pctime,rostime,receivetime,receivedtime,recvtime,"
     "logtime,arrivaltime,系统时间,接收时间,主机时间"},
    {Quantity::GpsTime, "gpstime,timegps,corrtime,gpsseconds,gnsstime,gps时间,gps秒"},
    {Quantity::WeekSeconds,
     "tow,itow,gpstow,timeofweek,gpstimeofweek,sow,gpssow,secondsofweek,gpsweekseconds,"
     "weekseconds,weeksec,gpssecondsofweek,周秒,周内秒,gps周秒,gps周内秒"},
    {Quantity::Week, "week,gpsweek,weekno,weeknumber,gpsweeknumber,wn,wnc,周,周数,gps周,gps周数"},
    {Quantity::Date, "date,day,utcdate,dateutc,gpsdate,datetime,utcdatetime,日期,日期时间"},
    {Quantity::Seconds,
     "sec,secs,second,seconds,utcsec,utcsecond,utcseconds,stampsec,stampsecs,headerstampsec,headerstampsecs,"
     "timestampsec,秒"},
    {Quantity::Nanoseconds,
     "nsec,nsecs,nano,nanos,nanosec,nanosecs,nanosecond,nanoseconds,utcnano,utcnanosecond,utcnanoseconds,stampnsec,"
     "stampnsecs,"
     "stampnanosec,headerstampnsec,headerstampnsecs,headerstampnanosec,纳秒"},
    {Quantity::Microseconds, "usec,usecs,microsec,microsecs,microsecond,microseconds,utcmicrosecond,微秒"},
    {Quantity::Milliseconds, "msec,msecs,millisec,millisecs,millisecond,milliseconds,utcmillisecond,毫秒"},
    {Quantity::Year, "year,utcyear,yyyy,gpsyear,年"},
    {Quantity::Month, "month,utcmonth,gpsmonth,月"},
    {Quantity::MonthDay, "utcday,dayofmonth,gpsday,日"},
    {Quantity::Hour, "hour,hours,utchour,gpshour,时,小时"},
    {Quantity::Minute, "minute,minutes,utcminute,utcmin,gpsminute,分,分钟"},
    {Quantity::Latitude, "lat,latitude,late7,latitudee7,poslat,gpslat,gpslatitude,positionlatitude,纬度"},
    {Quantity::Longitude, "lon,lng,long,longitude,lone7,longitudee7,poslon,gpslon,gpslongitude,positionlongitude,经度"},
    {Quantity::Height,
     "hell,h,alt,altitude,posalt,gpsalt,gpsaltitude,positionaltitude,altitudeellipsoid,"
     "altitudehae,height,hgt,hght,ellheight,ellipsoidheight,ellipsoidalheight,"
     "heightellipsoid,elevation,高,高度,高程,大地高,椭球高"},
    {Quantity::SeaHeight, "hmsl,heightmsl,altitudemsl,altmsl,msl,orthometricheight,海拔,海拔高,海拔高度"},
    {Quantity::East,
     "e,east,easting,eastposition,poseast,utme,utmeast,utmeasting,utmx,pose,东,东向,东坐标,东向坐标,东向位置"},
    {Quantity::North,
     "n,north,northing,northposition,posnorth,posn,utmn,utmnorth,utmnorthing,utmy,北,北向,北坐标,"
     "北向坐标,北向位置"},
    {Quantity::Up, "u,up,posup,天,天向,天向位置"},
    {Quantity::Down, "d,down,posdown,posd,地向,地向位置"},
    {Quantity::X, "x,px,tx,posx,xpos,positionx,position0,translationx,prsrx,x坐标"},
    {Quantity::Y, "y,py,ty,posy,ypos,positiony,position1,translationy,prsry,y坐标"},
    {Quantity::Z, "z,pz,tz,posz,zpos,positionz,position2,translationz,prsrz,z坐标"},
    {Quantity::Roll, "roll,rollangle,angleroll,attroll,insroll,eulerroll,横滚,横滚角,滚转,滚转角,翻滚角,侧倾角"},
    {Quantity::Pitch, "pitch,pitchangle,anglepitch,attpitch,inspitch,eulerpitch,俯仰,俯仰角"},
    {Quantity::Heading,
     "heading,head,hdg,headingangle,angleheading,trueheading,insheading,azimuth,"
     "insazimuth,航向,航向角,方位,方位角"},
    {Quantity::Yaw, "yaw,yawangle,attyaw,insyaw,euleryaw,偏航,偏航角"},
    {Quantity::Qx, "qx,quatx,quaternionx,orientationx,rotationx,qrsx,quatq1,q1,四元数x"},
    {Quantity::Qy, "qy,quaty,quaterniony,orientationy,rotationy,qrsy,quatq2,q2,四元数y"},
    {Quantity::Qz, "qz,quatz,quaternionz,orientationz,rotationz,qrsz,quatq3,q3,四元数z"},
    {Quantity::Qw, "qw,quatw,quaternionw,orientationw,rotationw,qrsw,quatq0,q0,四元数w"},
    {Quantity::SigmaEast,
     "sdeast,eastsd,eaststd,eaststddev,sigmaeast,sigmae,stdeast,stde,lonstd,longitudestd,"
     "longitudestddev,poslonstdev"},
    {Quantity::SigmaNorth,
     "sdnorth,northsd,northstd,northstddev,sigmanorth,sigman,stdnorth,stdn,latstd,"
     "latitudestd,latitudestddev,poslatstdev"},
    {Quantity::SigmaUp,
     "sdheight,sdup,upsd,upstd,sigmaup,sigmau,stdup,stdu,altstd,heightstd,heightsd,"
     "altitudestd,altitudestddev,posaltstdev"},
    {Quantity::SigmaRoll, "rollsd,rollstd,rollstddev,sdroll,stdroll,sigmaroll,anglerollstdev"},
    {Quantity::SigmaPitch, "pitchsd,pitchstd,pitchstddev,sdpitch,stdpitch,sigmapitch,anglepitchstdev"},
    {Quantity::SigmaHeading,
     "headingsd,headingstd,hdngsd,sdheading,stdheading,sigmaheading,yawstd,yawstddev,"
     "yawsd,sigmayaw,azimuthstd,angleheadingstdev"},
    {Quantity::Quality, "quality"},
    {Quantity::Scan, "file,filename,scan,scanname,pcd,cloud,文件,文件名"},
    // Beside what is_rate tells: by their last words some would be positions.
    {Quantity::Other,
     "v,ve,vn,vu,vd,vx,vy,vz,veast,vnorth,vup,vdown,eastv,northv,upv,vforward,vlateral,vhorizontal,sog,"
     "groundspeed,东速,北速,天速"},
    {Quantity::Course, "course,cog,track,trackangle,courseoverground,航迹角"},
};

/// Beside those of time (time_unit.h). The last ones are known to be other than what a manifest can say.
constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
    {"deg", "deg"},        {"degree", "deg"},      {"degrees", "deg"},    {"\xc2\xb0", "deg"},   {"度", "deg"},
    {"rad", "rad"},        {"radian", "rad"},      {"radians", "rad"},    {"弧度", "rad"},       {"m", "m"},
    {"meter", "m"},        {"meters", "m"},        {"metre", "m"},        {"metres", "m"},       {"米", "m"},
    {"mm", "mm"},          {"毫米", "mm"},         {"cm", "cm"},          {"厘米", "cm"},        {"km", "km"},
    {"千米", "km"},        {"公里", "km"},         {"ft", "ft"},          {"feet", "ft"},        {"foot", "ft"},
    {"英尺", "ft"},        {"e7", "1e-7deg"},      {"1e7", "1e-7deg"},    {"1e7deg", "1e-7deg"}, {"dege7", "1e-7deg"},
    {"deg1e7", "1e-7deg"}, {"degx1e7", "1e-7deg"}, {"10e7deg", "1e-7deg"}};

/// What stands where a unit would, and is none.
constexpr std::string_view kNoUnits =
    "utc,gps,gpst,gpstime,unix,posix,epoch,since,of,from,the,1970,1980,gpsweek,week,wgs84,hae,msl,ellipsoid,"
    "ellipsoidal,utm,enu,decimal,dec,north,east,up,true";

std::string plain(std::string_view name) {
  std::string out;
  for (const char c : formats::lower_case(name))
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) out += c;
  return out;
}

std::optional<Quantity> named(std::string_view name) {
  const std::string wanted = plain(name);
  if (wanted.empty()) return std::nullopt;
  std::vector<std::string_view> words;
  for (const auto& [quantity, names] : kNames) {
    formats::split_csv(names, words, ',');
    if (std::ranges::find(words, wanted) != words.end()) return quantity;
  }
  return std::nullopt;
}

/// "ddmm.mmmm", "dddmm.mm": degrees and minutes side by side.
bool is_degrees_and_minutes(std::string_view word) {
  const std::size_t degrees = std::min(word.find_first_not_of('d'), word.size());
  const std::string_view minutes = word.substr(degrees);
  return (degrees == 2 || degrees == 3) && minutes.size() >= 2 &&
         minutes.find_first_not_of('m') == std::string_view::npos;
}

/// "deg" of "degrees"; empty where the word is no unit that is known.
std::string known_unit(std::string_view word) {
  const std::string name = plain(word);
  if (is_degrees_and_minutes(name)) return "ddmm";
  if (name == "0001s") return "ms";  // "0.001 s", of Septentrio's converter
  if (const auto unit_ns = formats::time_unit_named_ns(name)) return std::string(formats::time_unit_name(*unit_ns));
  const auto* found = std::ranges::find(kUnits, name, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kUnits) ? "" : std::string(found->second);
}

/// "s" of "s since 1970", "m" of "m, WGS84"; as it stands there where a word of it is not known.
std::string unit_of(std::string_view text) {
  if (std::string unit = known_unit(text); !unit.empty()) return unit;
  std::vector<std::string_view> remarks;
  formats::split_csv(kNoUnits, remarks, ',');
  std::string unit;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" ,;_\t", at), text.size());
    const std::string word = plain(text.substr(at, end - at)), known = known_unit(word);
    at = end + 1;
    if (word.empty() || std::ranges::find(remarks, word) != remarks.end()) continue;
    if (known.empty() || (!unit.empty() && unit != known)) return std::string(formats::trim(text).substr(0, 20));
    unit = known;
  }
  return unit;
}

/// Where a unit in brackets, of Latin letters or of Chinese text, begins; npos where there is none.
std::size_t bracket_at(std::string_view title) {
  for (const std::string_view open : {"(", "[", "{", "（", "【"})
    if (const std::size_t at = title.find(open); at != std::string_view::npos && at > 0) {
      const bool counts = at + 2 < title.size() && title[at + 1] >= '0' && title[at + 1] <= '9' && title[at + 2] == ']';
      return counts ? std::string_view::npos : at;  // "q[0]" is one of several
    }
  return std::string_view::npos;
}

std::string_view without_brackets(std::string_view text) {
  for (const std::string_view mark : {"(", "[", "{", "（", "【"})
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
  for (const std::string_view mark : {")", "]", "}", "）", "】"})
    if (text.ends_with(mark)) text.remove_suffix(mark.size());
  return text;
}

/// Words between marks that are no letters: "pose.position.x", "lat_deg".
std::vector<std::string_view> words_of(std::string_view name) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t begin = name.find_first_not_of("._-/ :", at);
    if (begin == std::string_view::npos) break;
    at = std::min(name.find_first_of("._-/ :", begin), name.size());
    words.push_back(name.substr(begin, at - begin));
  }
  return words;
}

/// "field.pose.pose.position.x": by its last words, of which two are a name. Single letters need the word before them.
std::optional<Quantity> named_by_end(const std::vector<std::string_view>& words) {
  for (const std::size_t count : {3U, 2U}) {
    if (words.size() <= count) continue;
    std::string end;
    for (std::size_t i = words.size() - count; i < words.size(); ++i) end += words[i];
    if (const auto quantity = named(end)) return quantity;
  }
  return words.size() > 1 && words.back().size() > 2 ? named(words.back()) : std::nullopt;
}

/// What would be taken for an angle or a place by its last word, and is how fast that changes.
bool is_rate(std::string_view name) {
  const std::string words = plain(name);
  for (const std::string_view part : {"vel", "rate", "acc", "gyr", "omega", "speed", "bias", "速度", "加速", "角速",
                                      "twist", "cov", "linear", "angular", "force", "mag"})
    if (words.find(part) != std::string::npos) return true;
  return false;
}

/// What a title says, as far as it is known.
struct ReadTitle {
  std::optional<Quantity> quantity;
  std::string unit;
};

ReadTitle read_title(std::string_view title, std::string_view unit_below) {
  title = formats::trim(title);
  ReadTitle out;
  const std::size_t bracket = bracket_at(title);
  if (bracket != std::string_view::npos) {
    out.unit = unit_of(without_brackets(formats::trim(title.substr(bracket))));
    title = formats::trim(title.substr(0, bracket));
  } else if (!formats::trim(unit_below).empty()) {
    out.unit = unit_of(without_brackets(formats::trim(unit_below)));
  }
  if (title.empty()) return out;
  std::vector<std::string_view> words = words_of(title);
  auto quantity = named(title);
  if (!quantity) quantity = named_by_end(words);
  const bool in_parts = quantity == Quantity::Seconds || quantity == Quantity::Nanoseconds;
  if (!in_parts) quantity = named(title);
  if (!in_parts && words.size() > 1) {
    const std::string unit = known_unit(words.back());
    const bool is_unit = !unit.empty();
    std::string without_unit;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) without_unit += words[i];
    if (const auto bare = is_unit ? named(without_unit) : std::nullopt) quantity = bare;
    if (is_unit && out.unit.empty()) out.unit = unit;
    if (is_unit && !quantity && words.size() > 2) words.pop_back();
  }
  if (!quantity && is_rate(title)) quantity = Quantity::Other;
  if (!quantity) quantity = named_by_end(words);
  out.quantity = quantity;
  return out;
}

}  // namespace

std::optional<NamedQuantity> quantity_of(std::string_view title, std::string_view unit_below) {
  ReadTitle read = read_title(title, unit_below);
  if (!read.quantity) return std::nullopt;
  return NamedQuantity{*read.quantity, std::move(read.unit)};
}

std::string unit_stated(std::string_view title, std::string_view unit_below) {
  ReadTitle read = read_title(title, unit_below);
  if (read.unit.empty() && read.quantity == Quantity::Seconds) return "s";
  if (read.unit.empty() && read.quantity == Quantity::Milliseconds) return "ms";
  if (read.unit.empty() && read.quantity == Quantity::Microseconds) return "us";
  if (read.unit.empty() && read.quantity == Quantity::Nanoseconds) return "ns";
  return std::move(read.unit);
}

bool is_unit(std::string_view text) { return !known_unit(without_brackets(formats::trim(text))).empty(); }

std::vector<std::string_view> units_read(Quantity quantity) {
  switch (quantity) {
    case Quantity::Time:
    case Quantity::HostTime:
    case Quantity::GpsTime:
    case Quantity::WeekSeconds:
    case Quantity::Seconds:
    case Quantity::Nanoseconds:
      return {"s", "ms", "us", "ns"};
    case Quantity::Latitude:
    case Quantity::Longitude:
      return {"deg", "rad", "ddmm", "1e-7deg"};
    case Quantity::Roll:
    case Quantity::Pitch:
    case Quantity::Heading:
    case Quantity::Yaw:
      return {"deg", "rad"};
    case Quantity::Height:
    case Quantity::SeaHeight:
    case Quantity::East:
    case Quantity::North:
    case Quantity::Up:
    case Quantity::Down:
    case Quantity::X:
    case Quantity::Y:
    case Quantity::Z:
      return {"m"};
    default:
      return {};
  }
}

bool unit_is_read(const NamedQuantity& column) {
  const std::vector<std::string_view> known = units_read(column.quantity);
  return known.empty() || column.unit.empty() || std::ranges::find(known, column.unit) != known.end();
}

}  // namespace remount::guesses
