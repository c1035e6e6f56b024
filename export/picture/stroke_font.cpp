// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/picture/stroke_font.h"

#include <algorithm>
#include <array>

namespace latticast {
namespace {

struct Letter {
  char letter;
  std::string_view strokes;
};

// In the order of their codes.
constexpr std::array letters = {
    Letter{'!', "2824 2322"},
    Letter{'"', "1816 3836"},
    Letter{'#', "1218 3238 0444 0646"},
    Letter{'%', "0248 1807 4332"},
    Letter{'\'', "2826"},
    Letter{'(', "38262432"},
    Letter{')', "18262412"},
    Letter{'*', "2327 0347 0743"},
    Letter{'+', "2327 0545"},
    Letter{',', "2311"},
    Letter{'-', "1535"},
    Letter{'.', "2223"},
    Letter{'/', "0248"},
    Letter{'0', "180703123243473818"},
    Letter{'1', "172822 1232"},
    Letter{'2', "07183847460242"},
    Letter{'3', "07183847463525 354443321203"},
    Letter{'4', "32380444"},
    Letter{'5', "480805354443321203"},
    Letter{'6', "473818070312324344351504"},
    Letter{'7', "084822"},
    Letter{'8', "180706153546473818 1504031232434435"},
    Letter{'9', "031232434738180706153546"},
    Letter{':', "2324 2627"},
    Letter{'<', "470543"},
    Letter{'=', "0444 0646"},
    Letter{'>', "074503"},
    Letter{'A', "022842 1434"},
    Letter{'B', "0208 083847463505 3544433202"},
    Letter{'C', "4738180703123243"},
    Letter{'D', "02082846442202"},
    Letter{'E', "48080242 0535"},
    Letter{'F', "480802 0535"},
    Letter{'G', "47381807031232434525"},
    Letter{'H', "0208 4248 0545"},
    Letter{'I', "2228 1232 1838"},
    Letter{'J', "4843321203"},
    Letter{'K', "0208 4804 1542"},
    Letter{'L', "080242"},
    Letter{'M', "0208254842"},
    Letter{'N', "02084248"},
    Letter{'O', "180703123243473818"},
    Letter{'P', "02083847463505"},
    Letter{'Q', "180703123243473818 2442"},
    Letter{'R', "02083847463505 2542"},
    Letter{'S', "473818070615354443321203"},
    Letter{'T', "0848 2822"},
    Letter{'U', "080312324348"},
    Letter{'V', "082248"},
    Letter{'W', "0812263248"},
    Letter{'X', "0842 0248"},
    Letter{'Y', "082548 2522"},
    Letter{'Z', "08480242"},
    Letter{'[', "38282232"},
    Letter{']', "18282212"},
    Letter{'_', "0141"},
    Letter{'a', "4642 4536160503123243"},
    Letter{'b', "0208 0516364543321203"},
    Letter{'c', "4536160503123243"},
    Letter{'d', "4842 4536160503123243"},
    Letter{'e', "04444536160503123243"},
    Letter{'f', "12172838 0636"},
    Letter{'g', "46413010 4536160503123243"},
    Letter{'h', "0208 0516364542"},
    Letter{'i', "2622 2827"},
    Letter{'j', "26211000 2827"},
    Letter{'k', "0208 4604 1442"},
    Letter{'l', "2822"},
    Letter{'m', "0206 05162522 25364542"},
    Letter{'n', "0206 0516364542"},
    Letter{'o', "160503123243453616"},
    Letter{'p', "0600 0516364543321203"},
    Letter{'q', "4640 4536160503123243"},
    Letter{'r', "0206 04162636"},
    Letter{'s', "45361605143443321203"},
    Letter{'t', "18132232 0636"},
    Letter{'u', "0603123243 4642"},
    Letter{'v', "062246"},
    Letter{'w', "0612243246"},
    Letter{'x', "0642 0246"},
    Letter{'y', "0622 4610"},
    Letter{'z', "06460242"},
};

}  // namespace

std::string_view strokes_of(char letter) {
  if (letter == ' ') return {};
  const auto* const found = std::lower_bound(letters.begin(), letters.end(), letter,
                                             [](const Letter& a, char b) { return a.letter < b; });
  return found != letters.end() && found->letter == letter ? found->strokes : strokes_of_box;
}

}  // namespace latticast
