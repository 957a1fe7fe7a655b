#include "core/formats/number_lines.h"

#include "core/formats/document_json.h"
#include "core/formats/json_text.h"
#include "core/formats/numbers.h"

#include <algorithm>
#include <set>

namespace splineloft {
namespace {

/// A cell of a line, and the column at which it begins, from 1.
struct Cell {
    std::string_view text;
    std::size_t column = 1;
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r\n\v\f\"";
    const auto first = text.find_first_not_of(space);
    return first == text.npos ? std::string_view()
                              : text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// What parts the cells of a line.
std::string_view separatorsOf(std::string_view line) {
    for (const std::string_view strong : {"\t", ";"}) {
        if (line.find(strong) != line.npos) {
            return strong;
        }
    }
    return line.find(',') != line.npos ? "," : " ";
}

std::vector<Cell> cellsOf(std::string_view line) {
    const auto separators = separatorsOf(line);
    std::vector<Cell> cells;
    std::size_t begin = 0;
    while (begin <= line.size()) {
        const auto end = std::min(line.find_first_of(separators, begin), line.size());
        const auto cell = trimmed(line.substr(begin, end - begin));
        if (!cell.empty() || separators != " ") { // spaces may stand in a row
            cells.push_back({cell, begin + 1});
        }
        begin = end + 1;
    }
    while (!cells.empty() && cells.back().text.empty()) {
        cells.pop_back();
    }
    return cells;
}

std::optional<double> numberIn(const Cell& cell, bool commaIsPoint) {
    std::string text(cell.text);
    if (commaIsPoint && std::ranges::count(text, ',') == 1 && text.find('.') == text.npos) {
        std::ranges::replace(text, ',', '.');
    }
    if (!text.empty() && text.front() == '+') {
        text.erase(0, 1);
    }
    return numberFrom(text);
}

/// The lines so far as a curve.
class Table {
  public:
    std::optional<Refusal> add(std::string_view line, std::size_t number) {
        const auto cells = cellsOf(line);
        if (cells.empty()) {
            return std::nullopt;
        }
        const bool isFirst = !hasLines_;
        hasLines_ = true;
        const bool commaIsPoint = separatorsOf(line) != ",";
        std::vector<double> row;
        for (const auto& cell : cells) {
            if (const auto value = numberIn(cell, commaIsPoint)) {
                row.push_back(*value);
            } else if (isFirst && row.empty()) {
                return takeNames(cells);
            } else {
                return at(number, cell.column, inQuotes(cell.text) + " is no number", "a number");
            }
        }
        if (row.size() > static_cast<std::size_t>(maxDimension)) {
            return at(number, 1, "has " + std::to_string(row.size()) + " numbers",
                      "1 to 16 numbers");
        }
        const Point point{std::span<const double>(row)};
        if (points_.empty()) {
            points_ = Points(point.dimension());
        }
        if (point.dimension() != points_.dimension()) {
            return at(number, 1, "has " + std::to_string(row.size()) + " numbers",
                      std::to_string(points_.dimension()) + ", as many as the first line");
        }
        points_.append(point);
        return std::nullopt;
    }

    Result<Curve> curve() const {
        if (points_.empty()) {
            return Refusal{"", "", "has no numbers", "lines of numbers"};
        }
        Curve curve;
        curve.name = "points";
        completeParameters(curve);
        curve.points = points_;
        const bool named = names_.size() == static_cast<std::size_t>(points_.dimension()) &&
                           std::set(names_.begin(), names_.end()).size() == names_.size();
        curve.coordinates = named ? names_ : usualCoordinates(points_.dimension());
        return curve;
    }

  private:
    static Refusal at(std::size_t line, std::size_t column, std::string what, std::string remedy) {
        return {"", std::to_string(line) + ":" + std::to_string(column), std::move(what),
                std::move(remedy)};
    }

    std::optional<Refusal> takeNames(const std::vector<Cell>& cells) {
        for (const auto& cell : cells) {
            names_.push_back(asSaved(cell.text)); // two may be alike only then
        }
        return std::nullopt;
    }

    bool hasLines_ = false;
    std::vector<std::string> names_;
    Points points_;
};

} // namespace

Result<Curve> curveFromLines(std::string_view text) {
    Table table;
    std::size_t number = 0;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        if (auto refusal = table.add(text.substr(0, end), ++number)) {
            return *refusal;
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return table.curve();
}

} // namespace splineloft
