// The picture of a sweep.
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene_files/printable.hpp"

namespace islet::tools {
namespace {

// Pixels.
constexpr double panel_width = 340, panel_height = 230, left = 62, right = 14, top = 30, bottom = 40;

/// Okabe and Ito's colours, which people who see red and green alike can tell apart.
constexpr std::array<const char*, 7> colors = {"#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9", "#000000"};

/// Of a logarithmic axis, the decimal logarithms.
struct Range {
    double low = 0, high = 1, step = 1;
    bool is_logarithmic = false;

    /// How far along the axis a value stands, 0 to 1.
    double share(double value) const { return ((is_logarithmic ? std::log10(value) : value) - low) / (high - low); }
    int ticks() const { return static_cast<int>(std::lround((high - low) / step)); }
    std::string tick(int i) const {
        const double value = low + i * step;
        return fmt::format("{:.6g}", is_logarithmic ? std::pow(10, value) : std::abs(value) < step / 1e6 ? 0 : value);
    }
};

/// A range around both whose ends are whole multiples of a step of 1, 2 or 5 times a power of ten; about four steps.
Range rounded(double low, double high) {
    if (!(high > low)) {
        const double by = low == 0 ? 1 : std::abs(low) / 2;
        low -= by;
        high += by;
    }
    const double raw = (high - low) / 4, power = std::pow(10, std::floor(std::log10(raw)));
    const double step = (raw / power > 5 ? 10 : raw / power > 2 ? 5 : raw / power > 1 ? 2 : 1) * power;
    return {std::floor(low / step) * step, std::ceil(high / step) * step, step};
}

/// Of values above 0 that span more than three powers of ten a logarithmic axis, else one that holds 0.
Range range_of(const SweepTable& table, std::size_t measure) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SweepPoint& point : table.points) {
        if (point.figures[measure].count == 0) continue;
        low = std::min(low, point.figures[measure].least);
        high = std::max(high, point.figures[measure].most);
    }
    if (!(low > 0 && high > 1e3 * low)) return rounded(std::min(low, 0.0), std::max(high, 0.0));
    Range range{std::floor(std::log10(low)), std::ceil(std::log10(high)), 1, true};
    range.step = std::ceil((range.high - range.low) / 6);
    range.high = range.low + std::ceil((range.high - range.low) / range.step) * range.step;
    return range;
}

struct Panel {
    double x0, y0;
    Range x, y;

    double at_x(double share) const { return x0 + left + share * (panel_width - left - right); }
    double at_y(double share) const { return y0 + panel_height - bottom - share * (panel_height - top - bottom); }
    double px(double value) const { return at_x(x.share(value)); }
    double py(double value) const { return at_y(y.share(value)); }
};

std::string frame_of(const Panel& panel, const MeasureInfo& measure, const std::string& x_name) {
    std::string text =
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"title\">{}, {}</text>\n", panel.x0 + left, panel.y0 + 18, measure.name, measure.unit);
    const double bottom_y = panel.at_y(0), left_x = panel.at_x(0), right_x = panel.at_x(1);
    for (int i = 0; i <= panel.y.ticks(); ++i) {
        const double y = panel.at_y(static_cast<double>(i) / panel.y.ticks());
        text += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" class=\"grid\"/><text x=\"{:.1f}\" y=\"{:.1f}\" class=\"y\">{}</text>\n", left_x, y, right_x,
                            left_x - 6, y + 4, panel.y.tick(i));
    }
    for (int i = 0; i <= panel.x.ticks(); ++i)
        text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"x\">{}</text>\n", panel.at_x(static_cast<double>(i) / panel.x.ticks()), bottom_y + 15,
                            panel.x.tick(i));
    return text + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"x\">{}</text>\n", (left_x + right_x) / 2, bottom_y + 31, markup(x_name));
}

/// A series: points that share all parameters but the first.
struct Series {
    std::string name;
    std::vector<const SweepPoint*> points;
};

std::vector<Series> series_of(const Sweep& sweep, const SweepTable& table) {
    const std::size_t inner = table.points.size() / sweep.axes[0].values.size();
    std::vector<Series> series(inner);
    for (std::size_t i = 0; i < table.points.size(); ++i) series[i % inner].points.push_back(&table.points[i]);
    for (Series& one : series) {
        std::vector<std::string> names;
        for (std::size_t a = 1; a < sweep.axes.size(); ++a) names.push_back(sweep.axes[a].name + " " + value_text(sweep.axes[a].name, one.points[0]->values[a], 6));
        one.name = fmt::format("{}", fmt::join(names, ", "));
        std::sort(one.points.begin(), one.points.end(), [](const SweepPoint* a, const SweepPoint* b) { return a->values[0] < b->values[0]; });
    }
    return series;
}

std::string drawn(const Series& series, const Panel& panel, std::size_t measure, const char* color) {
    std::string line, upper, lower, dots;
    for (const SweepPoint* point : series.points) {
        const SweepFigure& f = point->figures[measure];
        if (f.count == 0) continue;
        const double x = panel.px(point->values[0]);
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, panel.py(f.mean));
        upper += fmt::format("{}{:.1f} {:.1f}", upper.empty() ? "M" : "L", x, panel.py(f.most));
        lower = fmt::format("L{:.1f} {:.1f}", x, panel.py(f.least)) + lower;
        dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>", x, panel.py(f.mean), color);
    }
    if (line.empty()) return {};
    return fmt::format("<path d=\"{}{}Z\" fill=\"{}\" fill-opacity=\"0.18\"/><path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>{}\n", upper,
                       lower, color, line, color, dots);
}

}  // namespace

void check_plot(const Sweep& sweep) {
    if (sweep.axes.empty()) throw SweepError("--plot needs something to --vary");
    const std::string& first = sweep.axes[0].name;
    if (value_names(first) != nullptr) throw SweepError(fmt::format("a plot goes along numbers: --vary another parameter before {}", first));
}

std::string plot_of(const Sweep& sweep, const SweepTable& table) {
    check_plot(sweep);
    const std::vector<Series> series = series_of(sweep, table);
    std::vector<std::size_t> shown;
    for (std::size_t m = 0; m < measure_count; ++m)
        if (std::any_of(table.points.begin(), table.points.end(),
                        [m](const SweepPoint& p) { return p.figures[m].count > 0 && (p.figures[m].most != 0 || m < 2); }))
            shown.push_back(m);
    const std::size_t columns = std::min<std::size_t>(shown.size(), 3), rows = (shown.size() + columns - 1) / columns;
    const bool has_legend = series.size() > 1 && series.size() <= 12;
    const double width = panel_width * static_cast<double>(columns),
                 height = 26 + panel_height * static_cast<double>(rows) + (has_legend ? 18.0 * static_cast<double>((series.size() + 3) / 4) : 0);
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
        "<style>.grid{{stroke:#ddd}}.x{{text-anchor:middle}}.y{{text-anchor:end}}.title{{font-weight:bold}}</style>\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n<text x=\"{2:.0f}\" y=\"18\" font-size=\"13\">{3}: {4} seeds a point; line: mean, band: "
        "smallest to largest</text>\n",
        width, height, left, markup(sweep.scene), sweep.seeds);
    const auto [least_x, most_x] = std::minmax_element(sweep.axes[0].values.begin(), sweep.axes[0].values.end());
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const Panel panel{panel_width * static_cast<double>(i % columns), 26 + panel_height * static_cast<double>(i / columns), rounded(*least_x, *most_x),
                          range_of(table, shown[i])};
        text += frame_of(panel, measures[shown[i]], sweep.axes[0].name);
        for (std::size_t s = 0; s < series.size(); ++s) text += drawn(series[s], panel, shown[i], colors[s % colors.size()]);
    }
    for (std::size_t s = 0; has_legend && s < series.size(); ++s)
        text +=
            fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"{}\">{}</text>\n", left + static_cast<double>(s % 4) * (width - left) / 4,
                        38 + panel_height * static_cast<double>(rows) + 18.0 * static_cast<double>(s / 4), colors[s % colors.size()], markup(series[s].name));
    return text + "</svg>\n";
}

}  // namespace islet::tools
