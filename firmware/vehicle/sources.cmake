# The vehicle's logic, relative to this folder. The same list is compiled for the microcontroller and for the host.
set(TESSERA_VEHICLE_SOURCES
  eeprom_image.cpp
  settings.cpp)
