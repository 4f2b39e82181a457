// `tessera-cli ports`: the serial ports of this machine.
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "host/serial_ports.h"

namespace tessera::cli {

void addPorts(CLI::App& app, Run& run) {
  auto* command =
      app.add_subcommand("ports", "List the serial ports found; a simulated world's port is given by its path");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print a JSON array");
  command->callback([json, &run] {
    run = [json] {
      nlohmann::json list = nlohmann::json::array();
      for (const host::SerialPortFound& port : host::serialPorts()) {
        list.push_back({{"port", port.port.toStdString()},
                        {"description", port.description.toStdString()},
                        {"manufacturer", port.manufacturer.toStdString()},
                        {"built_in", port.builtIn}});
      }
      if (*json) {
        say(list.dump(2));
        return kDone;
      }
      if (list.empty()) say("No serial port was found. Is the radio's USB adapter plugged in?");
      for (const auto& port : list) {
        const bool builtIn = port["built_in"].get<bool>();
        say(port["port"].get<std::string>() + "  " +
            (builtIn ? "built into this computer" : port["description"].get<std::string>()));
      }
      return kDone;
    };
  });
}

}  // namespace tessera::cli
