// What the model says is a message of the catalogue: no sentence stands in its sources.
#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

namespace remount::widgets {
namespace {

const QString kRoot = QStringLiteral(REMOUNT_SOURCE_DIR "/");

/// All but what no window shows.
bool is_shown(const QString& path) {
  static const QRegularExpression kOthers(
      "model/(fleet|simulator|results/exporters)/|_writer\\.cpp"    // texts of files
      "|model/report/"                                              // markup
      "|(message_document|attitude_convention|system_words)\\.cpp"  // words of former files, names in files
      "|algorithms/messages/");                                     // of those who write the catalogue
  return !path.contains(kOthers);
}

/// Mistakes of who calls, and what is written into a file or asked of a database.
bool is_no_message(const QString& literal) {
  static const QStringList kNone{"was not added to the alignment",
                                 "the objects are not those of this scan",
                                 "as many values as candidates are expected",
                                 "; its scans are 0 to ",
                                 "was not written so far yet",
                                 "there is no such chunk",
                                 "a chunk cannot be compressed",
                                 "a chunk that is not compressed needs no unpacking",
                                 "a column of the cloud is not as long as its points",
                                 "messages are taken to need no swapping",
                                 "no message of packets is called so",
                                 "a packet is longer than its message has room",
                                 "pitch centre ahead of the rear axle",  // ids of quantities in files
                                 "right wheel scale over left",
                                 "end error as measured",
                                 "angle between ground and turn",
                                 "angle between arm and first plane",
                                 "rotation equation singular value ",
                                 "all pairs: certified optimum",  // sources of candidates in files
                                 "all pairs: dual quaternion",
                                 "all pairs: joint quadratic",
                                 "all pairs: best found in range",
                                 "x y z reflectance",  // names of columns
                                 "x y z reflectance ring",
                                 "x y z intensity",
                                 "x y z intensity ring time",
                                 "x y z intensity timestamp",
                                 "offset_time x y z reflectivity tag line"};
  // '#': a comment in a file. Definitions of messages stand in bags.
  static const QRegularExpression kOther("^(#|PRAGMA |SELECT |\\n|time stamp\\n|std_msgs/Header header\\n)");
  return kNone.contains(literal) || literal.contains(kOther);
}

/// String literals of C++, those beside each other joined.
QStringList literals_of(const QString& source) {
  static const QRegularExpression kToken(
      R"re(//[^\n]*|#include[^\n]*|(?<![0-9a-fA-F])'(?:[^'\\\n]|\\.)+'|"((?:[^"\\\n]|\\.)*)")re");
  QStringList literals;
  qsizetype end_of_last = -1;
  for (auto match = kToken.globalMatch(source); match.hasNext();) {
    const QRegularExpressionMatch token = match.next();
    if (token.capturedStart(1) < 0) continue;
    const QString text = token.captured(1).replace("\\\"", "\"").replace("\\n", "\n");
    const bool follows =
        end_of_last >= 0 && source.mid(end_of_last, token.capturedStart() - end_of_last).trimmed().isEmpty();
    if (follows)
      literals.back() += text;
    else
      literals << text;
    end_of_last = token.capturedEnd();
  }
  return literals;
}

/// What stands between inserted values, where it is long enough to be part of a sentence.
QStringList pieces_of(const QString& text) {
  static const QRegularExpression kInserted(R"(%[-+.*0-9]*(?:zu|td|lld|[sdfgeuc%])|%\d)"),
      kEdges(R"(^[ .,:;()]+|[ .,:;()]+$)");
  QStringList pieces;
  for (QString piece : text.split(kInserted)) {
    piece.remove(kEdges);
    if (piece.count(' ') >= 3) pieces << piece;
  }
  return pieces;
}

TEST(model_sentences, are_read_from_sources_as_a_compiler_does) {
  EXPECT_EQ(
      literals_of(
          "f(\"one \"\n  \"two\",  // \"no\"\n  '\"', \"three \\\"x\\\"\", 1'000, \"four\");\n#include \"no.h\"\n"),
      (QStringList{"one two", "three \"x\"", "four"}));
  EXPECT_EQ(pieces_of("the farthest is %.2f m off the others at %s; one of %zu."), QStringList{"m off the others at"});
}

TEST(model_sentences, stand_in_the_catalogue) {
  int literals = 0;
  for (const char* folder : {"algorithms", "model"})
    for (QDirIterator files(kRoot + folder, {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
      const QString path = files.next().mid(kRoot.size());
      if (!is_shown(path)) continue;
      QFile file(kRoot + path);
      ASSERT_TRUE(file.open(QIODevice::ReadOnly));
      for (const QString& literal : literals_of(QString::fromUtf8(file.readAll()))) {
        ++literals;
        if (is_no_message(literal)) continue;
        for (const QString& piece : pieces_of(literal))
          ADD_FAILURE() << path.toStdString() << " says \"" << piece.toStdString()
                        << "\", which belongs into resources/messages: " << literal.toStdString();
      }
    }
  EXPECT_GT(literals, 1000) << "the sources were not found";
}

}  // namespace
}  // namespace remount::widgets
