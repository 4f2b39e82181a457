// Readers of every kind at a real port, read by the whole window: tags that say where they lie, modules that are asked,
// and what is heard.
#include <QCheckBox>
#include <QFile>
#include <QProcess>
#include <map>

#include "app/desktop/registering.h"

namespace tessera::desktop {
namespace {

class Readers : public Registering {
protected:
  static QByteArray hex(const char* digits) { return QByteArray::fromHex(digits); }
  static std::string placed(const std::string& uid, Point place) {
    return uid + " @" + std::to_string(place.x.value()) + "," + std::to_string(place.y.value());
  }
  [[nodiscard]] std::string uidHere(std::size_t stop) const {
    const auto& registration = *registrar().registration();
    return scan::uidAt(registration.site(), registration.walk().at(stop)).text();
  }
  [[nodiscard]] Point point(std::size_t stop) const { return *registrar().registration()->walk().at(stop).place; }
};

TEST_F(Readers, tellWhereATagSaysThatItLies) {
  ASSERT_NO_FATAL_FAILURE(start());
  scan(placed("04000001", point(0)));
  scan(placed("04000002", point(1) + Offset{Metres{0.04}, Metres{-0.02}}));
  say(placed("04000005", point(4)));
  ASSERT_TRUE(until([&] { return find("scanWhere")->isVisible(); }));
  EXPECT_EQ(registered(), 2U) << "it belongs elsewhere";
  EXPECT_TRUE(said("scanNotice").startsWith("Tag 04000005 says that it lies at (")) << said("scanNotice").toStdString();
  QTest::mouseClick(find("scanWhere"), Qt::LeftButton);
  EXPECT_EQ(registrar().point(), point(4)) << "the walk goes on there";
  QTest::qWait(800);  // the card is taken away and held there again
  scan(placed("04000005", point(4)));
  EXPECT_EQ(uidHere(4), "04000005");
  say("04000009 @1000.0,2000.0");
  ASSERT_TRUE(until([&] { return said("scanNotice").contains("where no tag is to be registered"); }));
  EXPECT_FALSE(find("scanWhere")->isVisible());
  say("04000009 @here");
  ASSERT_TRUE(until([&] { return said("scanNotice").contains("expected @X,Y in metres"); }));
  EXPECT_EQ(registered(), 3U);
}

// A module as its maker describes it: it says nothing unless it is asked, and every answer fits a question.
class Module {
public:
  explicit Module(sim::Pty& pty) : pty_{pty} {}

  /// The digits of the answer to an anticollision (4 bytes) and to a selection (7 bytes); empty: no card.
  std::string shortUid, longUid;
  int asked = 0;
  int strange = 0;

  void serve() {
    for (const std::uint8_t byte : pty_.read()) heard_.append(static_cast<char>(byte));
    static const std::map<QByteArray, int> questions{{QByteArray::fromHex("AABB0600FFFF0102 5251"), 0},
                                                     {QByteArray::fromHex("AABB0600FFFF0202 0404"), 1},
                                                     {QByteArray::fromHex("AABB0500FFFF120210"), 2}};
    for (bool found = true; found;) {
      found = false;
      for (const auto& [question, kind] : questions) {
        if (!heard_.startsWith(question)) continue;
        heard_.remove(0, question.size());
        ++asked;
        answer(kind);
        found = true;
      }
    }
    if (heard_.size() >= 10) ++strange, heard_.clear();
  }

private:
  void answer(int kind) {
    const std::string& uid = kind == 1 ? shortUid : kind == 2 ? longUid : shortUid;
    const char* command = kind == 0 ? "0102" : kind == 1 ? "0202" : "1202";
    QByteArray body = QByteArray::fromHex("5251") + QByteArray::fromHex(command);
    if (kind != 0 && uid.empty()) {
      body += '\x14';
    } else {
      body += QByteArray(1, '\0') + (kind == 0 ? QByteArray::fromHex("0400") : QByteArray::fromStdString(uid));
    }
    char check = 0;
    for (const char byte : body) check = static_cast<char>(check ^ byte);
    body += check;
    QByteArray frame = QByteArray::fromHex("AABB") + static_cast<char>(body.size()) + '\0';
    for (const char byte : body) {
      frame += byte;
      if (byte == '\xAA') frame += '\0';
    }
    pty_.write({reinterpret_cast<const std::uint8_t*>(frame.constData()), static_cast<std::size_t>(frame.size())});
  }

  sim::Pty& pty_;
  QByteArray heard_;
};

TEST_F(Readers, thatAreModulesAreAskedForShortAndLongUids) {
  ASSERT_NO_FATAL_FAILURE(start(3));
  Module module{*reader};
  const auto served = [&](const std::function<bool()>& condition) {
    return until([&] {
      module.serve();
      return condition();
    });
  };
  ASSERT_TRUE(served([&] { return module.asked >= 4; })) << "each of the four questions, without a card";
  EXPECT_EQ(registered(), 0U);
  module.shortUid = hex("04AAB2C3").toStdString();  // with a byte that is stuffed
  ASSERT_TRUE(served([&] { return registered() == 1; }));
  const int asked = module.asked;
  ASSERT_TRUE(served([&] { return module.asked >= asked + 8; }));
  EXPECT_EQ(registered(), 1U) << "a card that lies there counts once";
  module.shortUid = hex("8804A1B2").toStdString();  // the first half of a long one
  module.longUid = hex("04A1B2C3D4E5F6").toStdString();
  ASSERT_TRUE(served([&] { return registered() == 2; }));
  EXPECT_EQ(uidHere(0), "04AAB2C3");
  EXPECT_EQ(uidHere(1), "04A1B2C3D4E5F6");
  EXPECT_EQ(module.strange, 0) << "nothing but the four questions was sent";
}

TEST_F(Readers, areHeardThroughTheFirstPlayerOfTheSystemThatWorks) {
  // In place of the players of the machine: one fails, the next notes what it is to play.
  QTemporaryDir players;
  const auto put = [&](const char* name, const char* script) {
    QFile player{players.filePath(QString::fromLatin1(name))};
    ASSERT_TRUE(player.open(QIODevice::WriteOnly));
    player.write(script);
    player.close();
    player.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  };
  put("pw-play", "#!/bin/sh\nexit 1\n");
  put("paplay", "#!/bin/sh\nhead -c 4 \"$1\" >> \"${0%/*}/heard\"\necho \" ${1##*/}\" >> \"${0%/*}/heard\"\n");
  const QByteArray path = qgetenv("PATH");
  ASSERT_TRUE(closeWindow());
  qputenv("PATH", players.path().toLocal8Bit() + ':' + path);
  openWindow();
  qputenv("PATH", path);
  const auto heard = [&] {
    QFile notes{players.filePath("heard")};
    return notes.open(QIODevice::ReadOnly) ? notes.readAll() : QByteArray{};
  };
  ASSERT_NO_FATAL_FAILURE(start());
  scan("04000001");
  EXPECT_TRUE(until([&] { return heard() == "RIFF registered.wav\n"; })) << heard().toStdString();
  say("rubbish");
  EXPECT_TRUE(until([&] { return heard() == "RIFF registered.wav\nRIFF refused.wav\n"; })) << heard().toStdString();
  QTest::mouseClick(find("scanSound"), Qt::LeftButton, {}, QPoint{8, find("scanSound")->height() / 2});
  scan("04000002");
  QTest::mouseClick(find("scanSound"), Qt::LeftButton, {}, QPoint{8, find("scanSound")->height() / 2});
  scan("04000003");
  EXPECT_TRUE(until([&] { return heard().count('\n') == 3; })) << heard().toStdString();
}

}  // namespace
}  // namespace tessera::desktop
