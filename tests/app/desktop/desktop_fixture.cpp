#include "app/desktop/desktop_fixture.h"

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTimer>

#include "app/tessera/site_files.h"
#include "ui/canvas/view.h"

namespace tessera::desktop {
namespace {

// Far more than anything takes on a machine that does other things as well.
constexpr int kPatienceMs = 120'000;

}  // namespace

DesktopTest::DesktopTest() {
  QStandardPaths::setTestModeEnabled(false);
  qputenv("XDG_DATA_HOME", home.filePath("data").toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.filePath("config"));
}

DesktopTest::~DesktopTest() {
  if (window) killWindow();
}

void DesktopTest::openWindow(bool reopen) {
  window = std::make_unique<MainWindow>();
  window->restore();
  window->resize(1280, 820);  // more than this platform's screen; what a person has
  window->setLanguage(QStringLiteral("en"));
  window->setAppearance(Appearance::Light);
  window->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  window->activateWindow();  // shortcuts are the active window's
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  if (reopen) window->reopen();
}

bool DesktopTest::closeWindow() {
  if (!window->close()) return false;
  window.reset();
  return true;
}

void DesktopTest::killWindow() {
  window->document().markSaved();
  window.reset();
}

bool DesktopTest::until(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatienceMs); }

void DesktopTest::answerQuestion(const QString& name, const QString& buttonText) {
  auto* look = new QTimer{qApp};
  look->setInterval(20);
  QObject::connect(look, &QTimer::timeout, look, [look, name, buttonText] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr || box->objectName() != name) return;
    for (QAbstractButton* button : box->buttons()) {
      if (QString{button->text()}.remove('&') != buttonText) continue;
      look->deleteLater();
      QTest::mouseClick(button, Qt::LeftButton);
      return;
    }
  });
  look->start();
}

void DesktopTest::inDialogue(const QString& name, const std::function<void(QDialog&)>& work) {
  auto* look = new QTimer{window.get()};
  look->setInterval(20);
  QObject::connect(look, &QTimer::timeout, look, [look, name, work] {
    const QPointer<QDialog> dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr || dialog->objectName() != name) return;
    look->deleteLater();
    look->stop();
    try {
      work(*dialog);
    } catch (const std::exception& e) {
      ADD_FAILURE() << e.what();
    }
    if (dialog != nullptr && dialog->isVisible()) dialog->done(QDialog::Rejected);
  });
  look->start();
}

// Typed letter by letter, the list of completions would take the Return whenever it came up in time; and the dialogue
// selects the file that it proposes once it has read the folder, which counts more than what is typed.
void DesktopTest::nameTheFile(const QString& path) {
  inDialogue(QStringLiteral("QFileDialog"), [path](QDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
    const auto taken = [&] {
      name->clear();
      name->setText(path);
      return dynamic_cast<QFileDialog&>(dialog).selectedFiles() == QStringList{path};
    };
    EXPECT_TRUE(until(taken));
    QTest::keyClick(name, Qt::Key_Return);
  });
}

void DesktopTest::startDemo() {
  QTest::mouseClick(find("demoButton"), Qt::LeftButton);
  ASSERT_TRUE(until([&] { return vehicle().contact == supervisor::Contact::Connected && vehicle().located; }));
}

void DesktopTest::pressWhenOffered(const char* action, Qt::Key key) {
  EXPECT_TRUE(until([&] { return find<QAction>(action)->isEnabled(); })) << action;
  press(key);
}

supervisor::VehicleView DesktopTest::vehicle() const {
  const auto picture = window->session().latest();
  return picture && !picture->vehicles.empty() ? picture->vehicles.front() : supervisor::VehicleView{};
}

QPoint DesktopTest::pixelOf(double x, double y) const {
  return window->canvas().view().toPixel({Metres{x}, Metres{y}}).toPoint();
}

void DesktopTest::clickFloor(double x, double y, bool twice) {
  const QPoint at = pixelOf(x, y);
  QTest::mouseMove(&window->canvas(), at);
  QTest::mouseClick(&window->canvas(), Qt::LeftButton, {}, at);
  if (twice) QTest::mouseDClick(&window->canvas(), Qt::LeftButton, {}, at);
}

void DesktopTest::drawRoute(const std::vector<std::pair<double, double>>& vertices) {
  trigger("drawRoute");
  for (const auto& [x, y] : vertices) clickFloor(x, y);
  QTest::keyClick(&window->canvas(), Qt::Key_Return);
}

}  // namespace tessera::desktop
