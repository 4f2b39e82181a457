// `tessera-cli ports`: the serial ports of this machine.
#include <QSerialPortInfo>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"

namespace tessera::cli {

void addPorts(CLI::App& app, Run& run) {
  auto* command =
      app.add_subcommand("ports", "List the serial ports found; a simulated world's port is given by its path");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print a JSON array");
  command->callback([json, &run] {
    run = [json] {
      nlohmann::json list = nlohmann::json::array();
      for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts()) {
        list.push_back({{"port", port.systemLocation().toStdString()},
                        {"description", port.description().toStdString()},
                        {"manufacturer", port.manufacturer().toStdString()}});
      }
      if (*json) {
        say(list.dump(2));
        return kDone;
      }
      if (list.empty()) say("No serial port was found. Is the radio's USB adapter plugged in?");
      for (const auto& port : list) {
        say(port["port"].get<std::string>() + "  " + port["description"].get<std::string>());
      }
      return kDone;
    };
  });
}

}  // namespace tessera::cli
