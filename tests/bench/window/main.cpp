// window_bench [--benchmark_...]: what a frame of the interface costs the processor, on curves of
// up to 10^6 points. Real events go through the real frame function; there is no window, and what
// the graphics card does is not measured. Getting the bytes ready that it is sent is.
#include "ui/frame.h"
#include "ui/packing.h"
#include "ui/revisions.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace splineloft::ui {
namespace {

constexpr Screen screen{1280, 800, 1};
constexpr double frameSeconds = 1.0 / 60;

/// A coil of many turns with a ripple on it: no two legs are alike, and none is long.
Document coil(std::string_view family, std::size_t count) {
    Curve curve;
    curve.family = family;
    completeParameters(curve);
    curve.ends = familyOf(curve).ends.front();
    Points points(2);
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        const double angle = 40 * std::numbers::pi * part;
        const double radius = 10 + 90 * part + 0.3 * std::sin(1.7 * static_cast<double>(i));
        points.append({radius * std::cos(angle), radius * std::sin(angle)});
    }
    curve.points = std::move(points);
    return {{std::make_shared<Curve>(std::move(curve))}, "{}"};
}

/// The interface without a window, and a hand in it.
class Desk {
  public:
    explicit Desk(Document document) : session_(std::move(document)) {
        startInterface();
        loadFonts({}, screen);
        frames(3);
    }
    ~Desk() { stopInterface(); }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    Session& session() { return session_; }

    void frame(std::initializer_list<InputEvent> events) {
        const FrameResult result =
            runFrame(session_, screen, std::span(events.begin(), events.size()), frameSeconds);
        for (const auto& picture : result.pictures) {
            for (const auto& stroke : picture.pieces) {
                prepare(stroke.table);
            }
        }
        benchmark::DoNotOptimize(result.pictures.data());
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            frame({});
        }
    }

    ScreenPoint at(std::size_t point) const {
        const auto row = session_.document().curves[0]->points[point];
        return Viewport{session_.view.camera, session_.canvas}.toScreen({row[0], row[1]});
    }

    /// So near that a leg is about 20 pixels long, with a point in the middle.
    void lookCloselyAt(std::size_t point) {
        const auto& points = session_.document().curves[0]->points;
        const double leg = distance(points.at(point), points.at(point + 1));
        session_.view.camera = {{points[point][0], points[point][1]}, 20 / leg};
        frames(2);
    }

    /// Takes hold of a point, with all others that are selected.
    void grab(std::size_t point) {
        const ScreenPoint place = at(point);
        session_.view.selection.insert({0, point, Part::point});
        session_.view.activeCurve = 0;
        frame({PointerMoved{place.x, place.y}});
        frame({PointerButton{Button::left, true, {}}});
        hand_ = place;
        pull(); // beyond the slack of a click
        pull();
    }

    /// Moves the hand a little to and fro: one frame.
    void pull() {
        ++moves_;
        frame({PointerMoved{hand_.x + 12 + moves_ % 7, hand_.y - 9 - moves_ % 5}});
    }

  private:
    /// Gets ready what the renderer would send to the card.
    void prepare(const PieceTable& table) {
        auto& known = sent_[table.revisions->identity()];
        for (const auto& blocks : table.revisions->since(known)) {
            const auto points = pointsOf(table, blocks);
            benchmark::DoNotOptimize(
                packed(table.points.subspan(points.first, points.size())).data());
        }
        known = table.revisions->revision();
    }

    Session session_;
    std::map<std::uint64_t, std::uint64_t> sent_; // revisions by identity
    ScreenPoint hand_;
    int moves_ = 0;
};

std::size_t countIn(const benchmark::State& state) {
    return static_cast<std::size_t>(state.range(0));
}

void perPiece(benchmark::State& state, double pieces) {
    // Seconds, printed with a prefix: "850n" is 0.85 microseconds.
    state.counters["per_changed_piece"] = benchmark::Counter(
        pieces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// One point of many is dragged; a local family changes four pieces.
void dragOne(benchmark::State& state, const std::string& family, bool closely) {
    const auto count = countIn(state);
    Desk desk(coil(family, count));
    const auto point = count / 2 / 3 * 3; // of a Bézier spline, an anchor
    if (closely) {
        desk.lookCloselyAt(point);
    }
    desk.grab(point);
    for ([[maybe_unused]] const auto& iteration : state) {
        desk.pull();
    }
}

/// Many neighbours are dragged together.
void dragMany(benchmark::State& state, const std::string& family, std::size_t together) {
    const auto count = countIn(state);
    Desk desk(coil(family, count));
    const auto point = count / 2;
    for (std::size_t k = 0; k < together; ++k) {
        desk.session().view.selection.insert({0, point + k, Part::point});
    }
    desk.grab(point);
    for ([[maybe_unused]] const auto& iteration : state) {
        desk.pull();
    }
    perPiece(state, static_cast<double>(together));
}

void pan(benchmark::State& state, bool closely) {
    const auto count = countIn(state);
    Desk desk(coil("catmull-rom", count));
    if (closely) {
        desk.lookCloselyAt(count / 2);
    }
    desk.frame({PointerMoved{400, 300}});
    desk.frame({PointerButton{Button::middle, true, {}}});
    int moves = 0;
    for ([[maybe_unused]] const auto& iteration : state) {
        ++moves;
        desk.frame({PointerMoved{400.0 + moves % 20, 300.0 - moves % 30}});
    }
}

/// The pointer goes over the canvas and asks what lies under it.
void hover(benchmark::State& state) {
    Desk desk(coil("catmull-rom", countIn(state)));
    int moves = 0;
    for ([[maybe_unused]] const auto& iteration : state) {
        ++moves;
        desk.frame({PointerMoved{300.0 + moves % 400, 200.0 + moves % 300}});
    }
}

/// A rubber band around a tenth of the points or so, which changes with every frame.
void box(benchmark::State& state) {
    Desk desk(coil("catmull-rom", countIn(state)));
    desk.frame({PointerMoved{60, 45}});
    desk.frame({PointerButton{Button::left, true, {}}});
    int moves = 0;
    for ([[maybe_unused]] const auto& iteration : state) {
        ++moves;
        desk.frame({PointerMoved{300.0 + moves % 10, 200.0 + moves % 10}});
    }
}

/// From the document to the first frame that shows it.
void open(benchmark::State& state) {
    const Document document = coil("catmull-rom", countIn(state));
    for ([[maybe_unused]] const auto& iteration : state) {
        Desk desk(document);
    }
}

void registerAll() {
    const auto sized = [](benchmark::internal::Benchmark* entry) {
        entry->RangeMultiplier(10)->Range(1000, 1'000'000)->Unit(benchmark::kMicrosecond);
    };
    for (const auto* family : {"catmull-rom", "b-spline", "cardinal", "bezier-spline"}) {
        const std::string name(family);
        sized(benchmark::RegisterBenchmark(
            ("drag one, near/" + name).c_str(),
            [name](benchmark::State& state) { dragOne(state, name, true); }));
        sized(benchmark::RegisterBenchmark(
            ("drag one, all in view/" + name).c_str(),
            [name](benchmark::State& state) { dragOne(state, name, false); }));
    }
    for (const std::size_t together : {100, 10'000}) {
        benchmark::RegisterBenchmark(
            ("drag " + std::to_string(together) + " together/catmull-rom").c_str(),
            [together](benchmark::State& state) { dragMany(state, "catmull-rom", together); })
            ->Arg(100'000)
            ->Unit(benchmark::kMicrosecond);
    }
    sized(benchmark::RegisterBenchmark("pan, near", pan, true));
    sized(benchmark::RegisterBenchmark("pan, all in view", pan, false));
    sized(benchmark::RegisterBenchmark("hover", hover));
    sized(benchmark::RegisterBenchmark("rubber band", box));
    sized(benchmark::RegisterBenchmark("open", open));
}

} // namespace
} // namespace splineloft::ui

int main(int count, char** arguments) {
    splineloft::ui::registerAll();
    // Unless the caller says otherwise: the run then takes about a minute.
    std::string usual = "--benchmark_min_time=0.2";
    std::vector<char*> options{arguments[0], usual.data()};
    options.insert(options.end(), arguments + 1, arguments + count);
    auto optionCount = static_cast<int>(options.size());
    benchmark::Initialize(&optionCount, options.data());
    if (benchmark::ReportUnrecognizedArguments(optionCount, options.data())) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
}
