#include <tws_core/sector_file.h>

#include <stdexcept>
#include <string>

namespace tws {

SectorFile::SectorFile(std::uint32_t numbers, int sectors) {
  if (sectors < 1) throw std::invalid_argument("SectorFile: " + std::to_string(sectors) + " sectors; at least 1");
  links_.resize(numbers);
  sectors_.resize(index(sectors));
}

void SectorFile::refuse(const char* why, std::uint32_t number, int sector) {
  throw std::invalid_argument("SectorFile: number " + std::to_string(number) + ", sector " + std::to_string(sector) +
                              ": " + why);
}

}  // namespace tws
