// What registering a tag costs the window: processor time of its thread from the reader's line to the lit next place,
// on floors of some sizes of which every second tile is registered. Prints a table; judges nothing.
#include <QApplication>
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

#include "floor/new_floor.h"
#include "ui/register/register_panel.h"

namespace {

using namespace tessera;

constexpr int kTagsRead = 40;

double threadMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) / 1e6;
}

class Reader : public ui::ScanBench {
public:
  std::vector<ui::PortFound> ports() override { return {}; }
  void open(const QString& /*port*/, int /*baud*/) override { Q_EMIT opened(); }
  void close() override {}
  void send(const QByteArray& /*bytes*/) override {}
};

class Memory : public ui::RegisterMemory {
public:
  ui::ReaderChoice reader() const override { return {}; }
  void setReader(const ui::ReaderChoice& /*reader*/) override {}
  std::optional<scan::Course> course() const override { return {}; }
  void keep(const std::optional<scan::Course>& /*course*/) override {}
};

floor::TagUid uid(std::size_t n) {
  std::array<std::uint8_t, 7> bytes{4};
  for (std::size_t i = 1; i < bytes.size(); ++i) bytes.at(i) = static_cast<std::uint8_t>(n >> (8 * (6 - i)));
  return floor::TagUid::fromBytes(bytes).value();
}

void measure(int columns, int rows) {
  auto site = floor::layNewFloor({"bench", floor::usualTileTypes().front(), columns, rows, false}).value();
  for (std::size_t i = 0; i < site.tiles.size(); i += 2)
    for (std::size_t n = 0; n < 8; ++n) site.tiles[i].uids.push_back(uid(8 * i + n));
  ui::SiteDocument document;
  document.replace(floor::SiteMap::build(std::move(site)).value(), {});
  Reader reader;
  Memory memory;
  ui::Registrar registrar{document, reader, memory};
  ui::RegisterPanel panel{registrar};
  panel.show();
  ui::ReaderChoice choice;
  choice.keyboard = false;
  choice.sounds = false;
  registrar.start({}, choice);
  std::vector<double> all;
  for (std::size_t n = 0; n < kTagsRead; ++n) {
    QApplication::processEvents();
    const double before = threadMs();
    Q_EMIT reader.received(QByteArray::fromStdString(uid(0x800000 + n).text()) + '\n');
    QApplication::processEvents();
    all.push_back(threadMs() - before);
  }
  std::sort(all.begin(), all.end());
  std::printf("%9d tags: %7.1f ms in the middle, %7.1f ms at most\n", 8 * columns * rows, all[all.size() / 2],
              all.back());
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application{argc, argv};
  std::printf("A tag is registered, processor time of the window's thread:\n");
  measure(20, 16);
  measure(100, 50);
  measure(500, 250);
  return 0;
}
