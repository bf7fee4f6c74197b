#include "validate/ledger_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace airlight::validation {
namespace {

using Json = nlohmann::ordered_json;

std::string quoted(const std::string& text) { return '"' + text + '"'; }
/// A name as a cell: "precomputed:detail=draft,panels=6" holds a comma.
std::string cell(const std::string& name) { return name.find(',') == name.npos ? name : quoted(name); }

/// "0.43", "5.1", "120": two digits, never more than the yardstick is worth; beyond a factor of eleven only that it is so.
std::string percent(double part) {
  const double value = 100 * part;
  if (!std::isfinite(value)) return "none";
  if (std::abs(value) < 0.0005) return "0";
  if (std::abs(value) < 0.1) return fmt::format("{:.1g}", value);
  if (std::abs(value) < 1) return fmt::format("{:.2f}", value);
  if (std::abs(value) < 10) return fmt::format("{:.1f}", value);
  if (std::abs(value) > 1000) return value > 0 ? "> 1000" : "< -1000";
  return fmt::format("{:.0f}", value);
}

std::string light_of(const std::string& quantity) { return quantity == "luminance" ? "radiance" : quantity; }

/// A model's row on a quantity; on luminance for radiance where it answers in colours.
const LedgerRow* light_row(const Ledger& ledger, const std::string& model, const std::string& atmosphere,
                           const std::string& condition, const std::string& quantity = "radiance") {
  const LedgerRow* row = find_row(ledger, model, atmosphere, quantity, condition);
  return row || quantity != "radiance" ? row : find_row(ledger, model, atmosphere, "luminance", condition);
}

template <class Rows, class Member>
std::vector<std::string> distinct(const Rows& rows, Member member) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    if (std::ranges::find(names, row.*member) == names.end()) names.push_back(row.*member);
  return names;
}

std::string error_table(const Ledger& ledger, const std::string& atmosphere, const std::string& quantity) {
  std::vector<std::string> conditions;
  for (const LedgerRow& row : ledger.rows)
    if (row.atmosphere == atmosphere && light_of(row.quantity) == quantity && row.condition != "sun -2 and higher" &&
        std::ranges::find(conditions, row.condition) == conditions.end())
      conditions.push_back(row.condition);
  // Suns in their order, whichever models answer under which.
  std::ranges::stable_sort(conditions, [](const std::string& a, const std::string& b) {
    const bool x = a.starts_with("sun "), y = b.starts_with("sun ");
    return x && y && std::stod(a.substr(4)) > std::stod(b.substr(4));
  });
  if (conditions.empty()) return {};
  std::string text = fmt::format("\n`{}`, error of {} [%], median and 90th percentile:\n\n| model |", atmosphere,
                                 quantity == "radiance" ? quantity : "skylight on level ground"),
              rule = "\n|---|";
  for (const std::string& condition : conditions) {
    text += ' ' + condition + " |";
    rule += "---|";
  }
  text += rule + '\n';
  for (const std::string& model : distinct(ledger.costs, &ModelCost::model)) {
    std::string line = "| " + model + " |";
    bool any = false;
    for (const std::string& condition : conditions) {
      const LedgerRow* row = light_row(ledger, model, atmosphere, condition, quantity);
      any = any || row;
      line += row ? fmt::format(" {}, {} |", percent(row->figure.median), percent(row->figure.p90)) : " |";
    }
    if (any) text += line + '\n';
  }
  return text;
}

std::string worst_table(const Ledger& ledger) {
  std::string text =
      "\nOver all rays of an atmosphere. Bias is the mean of the signed error; colour is CIEDE2000 of light made as "
      "bright as the\n"
      "truth, median and 90th percentile; transmittance is the largest absolute error.\n\n"
      "| model | air | values | 99th percentile [%] | worst [%] | where | bias [%] | colour | transmittance |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (const ModelCost& cost : ledger.costs) {
    const LedgerRow* row = light_row(ledger, cost.model, cost.atmosphere, "all");
    if (!row) continue;
    const LedgerRow* through = find_row(ledger, cost.model, cost.atmosphere, "transmittance", "all");
    const std::string missing = row->unanswered ? fmt::format("; {} rays not answered", row->unanswered) : "";
    text += fmt::format("| {} | {} | {}{} | {} | {} | {} | {} | {:.1f}, {:.1f} | {} |\n", cost.model, cost.atmosphere,
                        row->figure.count, missing, percent(row->figure.p99), percent(row->figure.worst),
                        row->figure.where, percent(row->figure.bias), row->colour_median, row->colour_p90,
                        through ? fmt::format("{:.1e}", through->figure.worst) : "");
  }
  return text;
}

std::string cost_table(const Ledger& ledger) {
  std::string text =
      "\nWhat it costs, on one machine (compare rows, not machines): processor time, all threads together, at four "
      "wavelengths.\n"
      "Tables are those of one set of air; a ray is one of the yardstick's, in a batch of 4096, in no order, its "
      "tables made.\n\n"
      "| model | tables [CPU-ms] | tables [MiB] | a ray [ns] |\n|---|---|---|---|\n";
  std::vector<std::string> done;
  for (const ModelCost& cost : ledger.costs) {
    if (cost.cost.ray_nanoseconds == 0 || std::ranges::find(done, cost.model) != done.end()) continue;
    done.push_back(cost.model);
    text += fmt::format("| {} | {:.1f} | {:.2f} | {:.0f} |\n", cost.model, 1e3 * cost.cost.tables_seconds,
                        cost.cost.tables_bytes / (1 << 20), cost.cost.ray_nanoseconds);
  }
  return text;
}

}  // namespace

std::string as_csv(const Ledger& ledger) {
  std::string text =
      "model,atmosphere,quantity,condition,rays,unanswered,values,median,p90,p99,worst,bias,colour_median,colour_p90,"
      "where\n";
  for (const LedgerRow& row : ledger.rows) {
    const Figure& f = row.figure;
    text += fmt::format("{},{},{},{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{:.3g},{:.3g},{}\n", cell(row.model),
                        row.atmosphere, row.quantity, row.condition, row.rays, row.unanswered, f.count, f.median, f.p90,
                        f.p99, f.worst, f.bias, row.colour_median, row.colour_p90, quoted(f.where));
  }
  return text;
}

Json as_json(const Ledger& ledger) {
  Json json{{"wavelengths", ledger.wavelengths}, {"solved", ledger.solved}, {"irradiances", ledger.irradiances}};
  for (const LedgerRow& row : ledger.rows) {
    const Figure& f = row.figure;
    // A number that is none (an answer that was not finite) has no place in JSON.
    const auto number = [](double value) { return std::isfinite(value) ? value : 1e300; };
    json["rows"].push_back({{"model", row.model},
                            {"atmosphere", row.atmosphere},
                            {"quantity", row.quantity},
                            {"condition", row.condition},
                            {"rays", row.rays},
                            {"unanswered", row.unanswered},
                            {"values", f.count},
                            {"median", f.median},
                            {"p90", number(f.p90)},
                            {"p99", number(f.p99)},
                            {"worst", number(f.worst)},
                            {"where", f.where},
                            {"bias", number(f.bias)},
                            {"colour_median", row.colour_median},
                            {"colour_p90", row.colour_p90}});
  }
  for (const ModelCost& cost : ledger.costs)
    json["costs"].push_back({{"model", cost.model},
                             {"atmosphere", cost.atmosphere},
                             {"tables_seconds", cost.cost.tables_seconds},
                             {"tables_bytes", cost.cost.tables_bytes},
                             {"ray_nanoseconds", cost.cost.ray_nanoseconds}});
  return json;
}

Ledger ledger_from(const Json& json) {
  Ledger ledger{json.at("wavelengths"), json.at("solved"), json.value("irradiances", std::size_t(0)), {}, {}};
  for (const Json& row : json.at("rows"))
    ledger.rows.push_back({row.at("model"),
                           row.at("atmosphere"),
                           row.at("quantity"),
                           row.at("condition"),
                           {row.at("values"), row.at("median"), row.at("p90"), row.at("p99"), row.at("worst"),
                            row.at("where"), row.at("bias")},
                           row.at("rays"),
                           row.at("unanswered"),
                           row.at("colour_median"),
                           row.at("colour_p90")});
  for (const Json& cost : json.at("costs"))
    ledger.costs.push_back({cost.at("model"),
                            cost.at("atmosphere"),
                            {cost.at("tables_seconds"), cost.at("tables_bytes"), cost.at("ray_nanoseconds")}});
  return ledger;
}

std::string as_markdown(const Ledger& ledger, const std::string& name) {
  std::string nm;
  for (const double wavelength : ledger.wavelengths) nm += fmt::format("{}{:g}", nm.empty() ? "" : ", ", wavelength);
  std::string text = fmt::format(
      "Judged by {} rays and {} irradiances, {} nm. Every figure under each condition: [{}.csv]({}.csv).\n\n![Error "
      "against time]({}.svg)\n",
      ledger.solved, ledger.irradiances, nm, name, name, name);
  const std::vector<std::string> atmospheres = distinct(ledger.rows, &LedgerRow::atmosphere);
  for (const std::string& atmosphere : atmospheres) text += error_table(ledger, atmosphere, "radiance");
  for (const std::string& atmosphere : atmospheres) text += error_table(ledger, atmosphere, "sky_irradiance");
  return text + worst_table(ledger) + cost_table(ledger);
}

std::string as_svg(const Ledger& ledger) {
  struct Point {
    std::string name;
    double time, error;
  };
  std::vector<Point> points;
  for (const ModelCost& cost : ledger.costs) {
    const LedgerRow* row = light_row(ledger, cost.model, "earth", "sun -2 and higher");
    if (cost.atmosphere == "earth" && row && cost.cost.ray_nanoseconds > 0)
      points.push_back({cost.model, cost.cost.ray_nanoseconds, 100 * row->figure.p90});
  }
  constexpr double left = 70, top = 20, width = 560, height = 300;
  constexpr double fastest = 1, slowest = 5, best = -1, worst = 3;  // powers of ten: ns, %
  const auto x = [&](double ns) {
    return left + width * (std::clamp(std::log10(ns), fastest, slowest) - fastest) / (slowest - fastest);
  };
  const auto y = [&](double error) {
    return top + height * (worst - std::clamp(std::log10(error), best, worst)) / (worst - best);
  };
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      left + width + 30, top + height + 60);
  for (double power = fastest; power <= slowest; ++power) {
    const double at = x(std::pow(10, power));
    svg += fmt::format(
        "<path d=\"M{0:.0f} {1}v{2}\" stroke=\"#ddd\"/><text x=\"{0:.0f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4:g}</text>\n",
        at, top, height, top + height + 18, std::pow(10, power));
  }
  for (double power = best; power <= worst; ++power) {
    const double at = y(std::pow(10, power));
    svg += fmt::format(
        "<path d=\"M{0} {1:.0f}h{2}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.0f}\" text-anchor=\"end\">{5:g} "
        "%</text>\n",
        left, at, width, left - 6, at + 4, std::pow(10, power));
  }
  svg += fmt::format(
      "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\">processor time of a ray at four wavelengths [ns]</text>\n"
      "<text transform=\"translate(14 {:.0f}) rotate(-90)\" text-anchor=\"middle\">error, 90th percentile</text>\n",
      left + width / 2, top + height + 42, top + height / 2);
  for (const Point& p : points)
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"#26c\"/><text x=\"{2:.1f}\" "
        "y=\"{3:.1f}\"{5}>{4}</text>\n",
        x(p.time), y(p.error), x(p.time) + (x(p.time) > left + 0.75 * width ? -9 : 9), y(p.error) + 4, p.name,
        x(p.time) > left + 0.75 * width ? " text-anchor=\"end\"" : "");
  return svg + "</svg>\n";
}

std::vector<std::string> worse_than(const Ledger& now, const Ledger& before) {
  // Instruction sets round differently: percentiles of radiance move by less than a percent of themselves, worst values, which look
  // into the edge of the planet's shadow, by a few. What is exact to 1e-5 may lose that much.
  constexpr double part = 0.05, floor = 2e-5, shadows = 2e-4;
  std::vector<std::string> lines;
  for (const LedgerRow& old : before.rows) {
    const LedgerRow* row = find_row(now, old.model, old.atmosphere, old.quantity, old.condition);
    if (!row) continue;
    const std::string name = fmt::format("{}, {}, {}, {}", old.model, old.atmosphere, old.quantity, old.condition);
    const auto compare = [&](const char* what, double is, double was, double slack) {
      if (!(is <= was * (1 + part) + slack))
        lines.push_back(fmt::format("{}: {} {:.4g}, was {:.4g}", name, what, is, was));
    };
    const double slack = old.quantity == "transmittance" ? floor : shadows;
    compare("median", row->figure.median, old.figure.median, slack);
    compare("90th percentile", row->figure.p90, old.figure.p90, slack);
    compare("99th percentile", row->figure.p99, old.figure.p99, slack);
    compare("worst", row->figure.worst, old.figure.worst, slack);
    compare("size of the bias", std::abs(row->figure.bias), std::abs(old.figure.bias), slack);
    compare("colour error, median", row->colour_median, old.colour_median, 0.05);
    compare("colour error, 90th percentile", row->colour_p90, old.colour_p90, 0.05);
    if (row->unanswered > old.unanswered)
      lines.push_back(fmt::format("{}: {} rays not answered, were {}", name, row->unanswered, old.unanswered));
  }
  return lines;
}

}  // namespace airlight::validation
