// tessera: the window. `tessera --help` says what the command line can do.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QTimer>
#include <cstdlib>
#include <iostream>

#include "app/process/runtime_folder.h"
#include "app/tessera/demo_drive.h"
#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/runtime.h"
#include "app/tessera/site_files.h"

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

struct Words {
  std::string site;
  std::string language;
  std::string appearance;
  std::string port;
  bool demo = false;
  bool emulated = false;
  bool drive = false;
  std::string route;
  double speed = 0.12;
  bool untilFinished = false;
  std::string folder;
};

void describe(CLI::App& app, Words& w) {
  app.add_option("SITE", w.site, "Site to open, *.tessera.json (default: the one that was open last)");
  app.add_flag("--demo", w.demo, "Open the demo floor and connect to its simulated vehicle");
  app.add_flag("--qemu", w.emulated, "The simulated vehicles' firmware runs in an emulated LM3S6965 (needs QEMU)");
  app.add_option("--connect", w.port, "Connect at once: a serial port, tcp://HOST:PORT, or demo");
  auto* drive =
      app.add_option("--drive", w.route,
                     "Send the first vehicle that answers along this route (without a name: the site's first)")
          ->expected(0, 1);
  app.add_option("--speed", w.speed, "Speed of that drive in m/s")->check(CLI::Range{0.01, 2.0})->capture_default_str();
  app.add_flag("--until-finished", w.untilFinished, "End at the end of that drive")->needs(drive);
  app.add_option("--out", w.folder, "Folder for a picture of the window at the end of that drive");
  app.add_option("--language", w.language, "Language of the window")->check(CLI::IsMember{{"en", "zh_CN"}});
  app.add_option("--appearance", w.appearance)->check(CLI::IsMember{{"system", "light", "dark"}});
  app.set_version_flag("--version", TESSERA_VERSION);
  app.footer("Exit code 0 when all went well, 1 when something failed, 2 for a wrong command line.");
}

tessera::ui::ConnectionChoice choiceOf(const QString& words, int baud) {
  tessera::ui::ConnectionChoice choice;
  if (words == QLatin1String{"demo"}) return choice;
  choice.kind = tessera::ui::ConnectionChoice::Kind::Serial;
  choice.port = words;
  choice.baud = baud;
  const auto parsed = tessera::host::PortChoice::parse(words, baud);
  if (const auto* tcp = parsed ? std::get_if<tessera::host::PortChoice::Tcp>(&parsed->to) : nullptr) {
    choice.kind = tessera::ui::ConnectionChoice::Kind::Tcp;
    choice.host = tcp->host;
    choice.tcpPort = tcp->port;
  }
  return choice;
}

int runWindow(const Words& words, bool driving) {
  using namespace tessera::desktop;
  MainWindow window;
  window.restore();
  if (!words.language.empty()) window.setLanguage(QString::fromStdString(words.language));
  if (!words.appearance.empty()) window.setAppearance(appearanceOf(QString::fromStdString(words.appearance)));
  window.session().setEmulated(words.emulated);
  const PoliteEnd politeEnd{[&window] {
    window.endUnasked();
    QApplication::exit();
  }};
  window.show();
  QString failure;
  if (words.untilFinished) window.files().setUnattended();
  if (driving) {
    auto* drive = new DemoDrive{window,
                                {QString::fromStdString(words.route), tessera::MetresPerSecond{words.speed},
                                 words.untilFinished, QString::fromStdString(words.folder)}};
    QObject::connect(drive, &DemoDrive::ended, &window, [&](const QString& sentence) {
      failure = sentence;
      // What was drawn or moved meanwhile belongs to the demonstration.
      window.document().markSaved();
      window.close();
    });
  }
  // From within the event loop, which a question may have to leave.
  QTimer::singleShot(0, &window, [&] {
    if (words.site.empty() && !words.demo) window.reopen();
    if (!words.site.empty() && !window.files().open(QString::fromStdString(words.site)))
      failure = QStringLiteral("The site was not opened.");
    if (words.demo) window.openDemo();
    if (!words.port.empty())
      window.connectTo(choiceOf(QString::fromStdString(words.port), window.document().site().radio.baud));
  });
  const int code = QApplication::exec();
  if (failure.isEmpty()) return code;
  std::cerr << "tessera: " << failure.toStdString() << std::endl;
  return kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tessera::desktop;
  CLI::App app{"Tessera: watch and command vehicles that find their way by RFID tags in the floor.", "tessera"};
  Words words;
  describe(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : kUsage;
  }
  if (const auto sentence = whyNoWindow(); !sentence.empty()) {
    std::cerr << "tessera: " << sentence << std::endl;
    return kFailed;
  }
  tessera::process::provideRuntimeFolder();
  // The key that stops all vehicles works in Qt's own file dialogues alone.
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application{argc, argv};
  QApplication::setOrganizationName(QStringLiteral("Tessera"));
  QApplication::setApplicationName(QStringLiteral("tessera"));
  QApplication::setApplicationDisplayName(QStringLiteral("Tessera"));
  QApplication::setApplicationVersion(QStringLiteral(TESSERA_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("tessera"));
  QApplication::setWindowIcon(QIcon{QStringLiteral(":/app/tessera.svg")});
  return runWindow(words, app.count("--drive") > 0);
}
