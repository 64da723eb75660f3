#include "vector_functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include "occgrid/fast.hpp"
#include "occgrid/map_writer.hpp"
#include "occgrid/noise.hpp"
#include "occgrid/portable_math.hpp"
#include "occgrid/ray.hpp"
#include "occgrid/sensor.hpp"

namespace {

using occgrid::OccupancyGrid;

double real(const std::string& text) {
  return occgrid::detail::double_of(std::stoull(text, nullptr, 16));
}

std::string text(double x) {
  const unsigned long long bits =
      std::isnan(x) ? 0x7ff8000000000000 : occgrid::detail::bits_of(x);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", bits);
  return digits;
}

std::string text(std::int64_t number) {
  return std::to_string(number);
}

std::int64_t whole(const std::string& text) {
  return std::stoll(text);
}

std::uint32_t word(const std::string& text, int base) {
  return static_cast<std::uint32_t>(std::stoull(text, nullptr, base));
}

VectorFunction of_one_number(double (*f)(double)) {
  return [f](const Columns& in) { return Columns{text(f(real(in.at(0))))}; };
}

Columns world_to_grid(const Columns& in) {
  const OccupancyGrid grid(
      {1, 1, real(in.at(0)), real(in.at(1)), real(in.at(2))});
  const auto [gx, gy] = grid.world_to_grid(real(in.at(3)), real(in.at(4)));
  return {text(gx), text(gy)};
}

Columns bresenham(const Columns& in) {
  std::string cells;
  for (const auto [gx, gy] :
       occgrid::bresenham(whole(in.at(0)), whole(in.at(1)), whole(in.at(2)),
                          whole(in.at(3)))) {
    cells += (cells.empty() ? "" : " ") + text(gx) + ":" + text(gy);
  }
  return {cells};
}

Columns clip_ray(const Columns& in) {
  const auto [first, last] =
      occgrid::clip_ray(whole(in.at(0)), whole(in.at(1)), whole(in.at(2)),
                        whole(in.at(3)), whole(in.at(4)), whole(in.at(5)));
  if (last < first) return {"0", "-1"};  // as each miss is written
  return {text(first), text(last)};
}

Columns flaser_angles(const Columns& in) {
  return {text(occgrid::flaser_angles(whole(in.at(0)))[whole(in.at(1))])};
}

occgrid::NoReturn no_return(const std::string& text) {
  if (text != "free" && text != "ignore") throw std::invalid_argument(text);
  return text == "free" ? occgrid::NoReturn::free : occgrid::NoReturn::ignore;
}

Columns read_ranges(const Columns& in) {
  const auto [z, hit, used] =
      occgrid::read_ranges(Eigen::ArrayXd::Constant(1, real(in.at(0))),
                           real(in.at(1)), no_return(in.at(2)));
  return {text(z[0]), hit[0] ? "1" : "0", used[0] ? "1" : "0"};
}

Columns beam_endpoints(const Columns& in) {
  const auto [ex, ey] =
      occgrid::beam_endpoints({real(in.at(0)), real(in.at(1)), real(in.at(2))},
                              Eigen::ArrayXd::Constant(1, real(in.at(3))),
                              Eigen::ArrayXd::Constant(1, real(in.at(4))));
  return {text(ex[0]), text(ey[0])};
}

Columns update_cell(const Columns& in) {
  OccupancyGrid grid({1, 1, 1.0, 0.0, 0.0}, real(in.at(0)), real(in.at(1)),
                     real(in.at(2)), real(in.at(3)), real(in.at(4)));
  for (const char update : in.at(5)) {
    if (update != 'o' && update != 'f') throw std::invalid_argument(in.at(5));
    grid.update_cell(0, 0, update == 'o' ? grid.l_occ() : grid.l_free());
  }
  return {text(grid.log_odds()(0, 0))};
}

Columns pixel(const Columns& in) {
  return {std::to_string(occgrid::pixel(real(in.at(0))))};
}

Columns philox(const Columns& in) {
  const auto at = [&](std::size_t i) { return word(in.at(i), 16); };
  Columns out;
  for (const std::uint32_t w :
       occgrid::philox4x32({at(0), at(1), at(2), at(3)}, {at(4), at(5)})) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08lx",
                  static_cast<unsigned long>(w));
    out.push_back(digits);
  }
  return out;
}

Columns normal_deviate(const Columns& in) {
  return {text(occgrid::normal_deviate(word(in.at(0), 10), word(in.at(1), 10),
                                       word(in.at(2), 10)))};
}

}  // namespace

const std::map<std::string, VectorFunction>& vector_functions() {
  static const std::map<std::string, VectorFunction> functions{
      {"sin", of_one_number(occgrid::sin)},
      {"cos", of_one_number(occgrid::cos)},
      {"exp", of_one_number(occgrid::exp)},
      {"log", of_one_number(occgrid::log)},
      {"logit", of_one_number(occgrid::logit)},
      {"sigmoid", of_one_number(occgrid::sigmoid)},
      {"world_to_grid", world_to_grid},
      {"bresenham", bresenham},
      {"clip_ray", clip_ray},
      {"flaser_angles", flaser_angles},
      {"read_ranges", read_ranges},
      {"beam_endpoints", beam_endpoints},
      {"update_cell", update_cell},
      {"pixel", pixel},
      {"philox", philox},
      {"normal_deviate", normal_deviate},
  };
  return functions;
}
