#include "ui/commission/flash_page.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>

#include "ui/base/icon.h"

namespace tessera::ui {

QString firmwareImage(const QString& programFolder) {
  for (const char* where : {"../share/tessera/firmware/tessera-vehicle.bin", "tessera-vehicle.bin"}) {
    const QFileInfo file{QDir{programFolder}, QLatin1String{where}};
    if (file.isFile()) return QDir::cleanPath(file.absoluteFilePath());
  }
  return {};
}

FlashPage::FlashPage(Commissioning& work, QWidget* parent)
    : StepPage{work, Commissioning::Step::Firmware, Needs::Nothing, parent} {
  intro_.setWordWrap(true);
  demo_.setWordWrap(true);
  content().addWidget(&intro_);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    Command& c = commands_[i];
    c.what.setWordWrap(true);
    c.line.setReadOnly(true);
    c.line.setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    c.line.setObjectName(QStringLiteral("flashCommand%1").arg(i + 1));
    c.copy.setObjectName(QStringLiteral("copyCommand%1").arg(i + 1));
    c.copy.setIcon(icon(QStringLiteral("copy")));
    c.copy.setAutoDefault(false);
    c.what.setBuddy(&c.line);
    auto* row = new QHBoxLayout;
    row->addWidget(&c.line, 1);
    row->addWidget(&c.copy);
    content().addWidget(&c.what);
    content().addLayout(row);
    connect(&c.copy, &QPushButton::clicked, this, [&c] { QApplication::clipboard()->setText(c.line.text()); });
  }
  done_.setObjectName(QStringLiteral("flashDone"));
  done_.setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(&done_);
  row->addStretch();
  content().addLayout(row);
  content().addSpacing(fontMetrics().height() / 2);
  content().addWidget(&demo_);
  content().addStretch();
  connect(&done_, &QPushButton::clicked, this, [this] { markDone(); });
  connect(&work, &Commissioning::markChanged, this,
          [this, &work] { done_.setEnabled(work.mark(Commissioning::Step::Firmware) != Commissioning::Mark::Done); });
  useImage(firmwareImage(QCoreApplication::applicationDirPath()));
}

void FlashPage::useImage(const QString& file) {
  image_ = file;
  const QString quoted = '"' + file + '"';
  const bool there = !file.isEmpty();
  commands_[0].line.setText(QStringLiteral("openocd -f board/ek-lm3s6965.cfg -c ") +
                            (there ? QStringLiteral("'program {%1} verify reset exit 0x0'").arg(file)
                                   : QStringLiteral("'program tessera-vehicle.elf verify reset exit'")));
  commands_[1].line.setText(QStringLiteral("arm-none-eabi-objcopy -O binary tessera-vehicle.elf tessera-vehicle.bin"));
  commands_[2].line.setText(QStringLiteral("lm4flash ") + (there ? quoted : QStringLiteral("tessera-vehicle.bin")));
  for (Command& c : commands_) {
    c.line.setToolTip(c.line.text());
    c.line.setCursorPosition(0);
  }
  commands_[1].what.setHidden(there);
  commands_[1].line.setHidden(there);
  commands_[1].copy.setHidden(there);
  FlashPage::retranslate();
}

void FlashPage::retranslate() {
  StepPage::retranslate();
  setTitle(tr("Firmware onto the vehicle's board"));
  setSubTitle(tr("For a board with the microcontroller LM3S6965. Skip this if the vehicle has its firmware."));
  const bool there = !image_.isEmpty();
  intro_.setText(
      there ? tr("Connect the board's debug port to this computer by USB, lift the vehicle's wheels off the floor, and "
                 "write the firmware that came with this program by one of these commands:")
            : tr("Connect the board's debug port to this computer by USB, lift the vehicle's wheels off the floor, "
                 "and run in the folder of the firmware (tessera-vehicle.elf):"));
  commands_[0].what.setText(tr("With Open&OCD (boards like the EK-LM3S6965; Debian package openocd):"));
  commands_[1].what.setText(
      tr("With lm&4flash (boards whose debugger is a Stellaris ICDI), first make a plain image:"));
  commands_[2].what.setText(there ? tr("With lm&4flash (boards whose debugger is a Stellaris ICDI):")
                                  : tr("and write &it:"));
  for (Command& c : commands_) {
    c.copy.setText(tr("Copy"));
    c.copy.setToolTip(tr("Copy the command"));
  }
  done_.setText(tr("The firmware is on the board"));
  demo_.setText(
      tr("No vehicle at hand? Connect to the demo world: it simulates every vehicle of the site with the same "
         "firmware, this one too, and needs no flashing."));
}

}  // namespace tessera::ui
