// A place to register tags at: a floor of two tiles, a reader that says what the test lets it say, and a memory.
#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "floor/new_floor.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/register/register_panel.h"
#include "ui/register/register_tool.h"

namespace tessera::ui {

class FakeScanBench : public ScanBench {
public:
  std::vector<PortFound> ports() override { return {{"/dev/ttyTEST0", "Reader", false}}; }
  void open(const QString& port, int baud) override {
    opens << QStringLiteral("%1 at %2").arg(port).arg(baud);
    Q_EMIT opened();
  }
  void close() override { ++closes; }
  void send(const QByteArray& bytes) override { sent << bytes; }
  void say(const QByteArray& text) { Q_EMIT received(text); }

  QStringList opens;
  QList<QByteArray> sent;
  int closes = 0;
};

class FakeRegisterMemory : public RegisterMemory {
public:
  ReaderChoice reader() const override { return reader_; }
  void setReader(const ReaderChoice& reader) override { reader_ = reader; }
  std::optional<scan::Course> course() const override { return course_; }
  void keep(const std::optional<scan::Course>& course) override { course_ = course; }

  ReaderChoice reader_{true, {}, 9600, scan::ReaderForm::HexLines, false};
  std::optional<scan::Course> course_;
};

class Counter : public testing::Test {
protected:
  void SetUp() override {
    document.replace(
        floor::SiteMap::build(floor::layNewFloor({"f", floor::usualTileTypes().front(), 2, 1, false}).value()).value(),
        {});
    panel.resize(420, 760);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  }

  template <class T = QWidget>
  T* find(const char* name) {
    T* found = panel.findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  void click(const char* name) {
    // A check box is hit on its box and its words, which stand at the left.
    auto* widget = find<QWidget>(name);
    QTest::mouseClick(widget, Qt::LeftButton, {}, QPoint{10, widget->height() / 2});
  }
  void startWithPort() {
    find<QComboBox>("scanReader")->setCurrentIndex(1);
    click("startScan");
    ASSERT_EQ(registrar.state(), Registrar::State::Scanning);
  }
  void type(const char* line) {
    QTest::keyClicks(QApplication::focusWidget(), line);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  }
  [[nodiscard]] std::vector<std::string> uids(std::size_t tile) const {
    std::vector<std::string> texts;
    for (const auto& uid : document.site().tiles[tile].uids) texts.push_back(uid.text());
    return texts;
  }
  [[nodiscard]] std::size_t registered() const { return registrar.registration()->progress().registered; }
  [[nodiscard]] QString said(const char* name) { return find<QLabel>(name)->text(); }

  SiteDocument document;
  FakeScanBench bench;
  FakeRegisterMemory memory;
  Registrar registrar{document, bench, memory};
  RegisterPanel panel{registrar};
};

}  // namespace tessera::ui
