// Writes without end, to be killed: round after round a site and ten notes of the same number, which it prints when
// they are written.
#include <QCoreApplication>
#include <cstdio>

#include "store/journal.h"
#include "store/site_store.h"

int main(int argc, char** argv) {
  using namespace tessera;
  const QCoreApplication application{argc, argv};
  if (argc != 2) return 2;
  const auto database = store::Database::open(argv[1]);
  if (!database) {
    std::fprintf(stderr, "%s\n", database.error().sentence.english().c_str());
    return 1;
  }
  for (int round = 1;; ++round) {
    floor::Site site;
    site.name = std::to_string(round);
    for (int i = 0; i < 2000; ++i) site.routes.push_back({site.name, {{Metres{1.0 * round}, Metres{1.0 * i}}}, {}});
    if (!store::SiteStore{**database}.save("site", site, round, true)) return 1;
    std::vector<store::Note> notes(10);
    for (store::Note& note : notes) note.utcMs = round;
    if (!store::Journal{**database}.append(notes)) return 1;
    std::printf("%d\n", round);
    std::fflush(stdout);
  }
}
